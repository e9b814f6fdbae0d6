-- Of the footways of a model that say that they are sidewalks, the metres at street level, and the share of these on
-- sidewalks, on roadway, and elsewhere; psql -v model=NAME -f tests/measure/mapped_sidewalks.sql. Places every metre,
-- so that a share is that of the length. Of those on roadway, over_drives lie on one that nobody crosses on foot, such
-- as a drive, across lead over another, and along run with it. off_all_streets lies beyond 30 m of every edge: the
-- extract lacks its street.
WITH place AS MATERIALIZED (
    SELECT f.level, p.geom, ST_Azimuth(ST_LineInterpolatePoint(f.geom, greatest(0, share - 0.001)),
            ST_LineInterpolatePoint(f.geom, least(1, share + 0.001))) AS heading
    FROM :"model".footway f, LATERAL (SELECT (n - 0.5) / ceil(ST_Length(geom)) AS share
        FROM generate_series(1, ceil(ST_Length(geom))::integer) n) s,
        LATERAL (SELECT ST_LineInterpolatePoint(f.geom, share) AS geom) p
    WHERE role = 'sidewalk' AND ST_Length(f.geom) > 0),
seen AS (
    SELECT EXISTS (SELECT FROM :"model".sidewalk w WHERE w.surface && p.geom
        AND ST_Covers(w.surface, p.geom)) AS walked,
        EXISTS (SELECT FROM :"model".section s JOIN :"model".edge e USING (edge_id)
            WHERE s.surface && p.geom AND ST_Covers(s.surface, p.geom) AND e.level = p.level
            UNION ALL SELECT FROM :"model".intersection i
            WHERE i.surface && p.geom AND ST_Covers(i.surface, p.geom) AND i.level = p.level) AS driven,
        n.beside IS NOT NULL AS beside, n.turn, n.crossed
    FROM place p LEFT JOIN LATERAL (
        SELECT true AS beside, c.crossed_on_foot IS NOT FALSE AS crossed,
            abs(sin(p.heading - ST_Azimuth(ST_LineInterpolatePoint(e.geom, greatest(0, share - 0.001)),
                ST_LineInterpolatePoint(e.geom, least(1, share + 0.001))))) AS turn
        FROM :"model".edge e JOIN :"model".axis a USING (axis_id) LEFT JOIN :"model".axis_class c ON c.class = a.kind,
            LATERAL (SELECT ST_LineLocatePoint(e.geom, p.geom) AS share) s
        WHERE ST_DWithin(e.geom, p.geom, 30)
        ORDER BY e.level <> p.level, ST_Distance(e.geom, p.geom) - greatest(e.width, e.width_end) / 2 LIMIT 1) n
        ON true)
SELECT count(*) AS metres, round(100.0 * avg((walked AND NOT driven)::integer), 1) AS on_sidewalk,
    round(100.0 * avg(driven::integer), 2) AS on_roadway,
    round(100.0 * avg((driven AND NOT crossed)::integer), 2) AS over_drives,
    round(100.0 * avg((driven AND crossed AND turn > 0.5)::integer), 2) AS across,
    round(100.0 * avg((driven AND crossed AND turn <= 0.5)::integer), 2) AS along,
    round(100.0 * avg((NOT walked AND NOT driven)::integer), 1) AS elsewhere,
    round(100.0 * avg((NOT beside)::integer), 1) AS off_all_streets
FROM seen;
SELECT count(*) AS mapped_sides, percentile_cont(0.1) WITHIN GROUP (ORDER BY width) AS tenth,
    percentile_cont(0.5) WITHIN GROUP (ORDER BY width) AS median,
    percentile_cont(0.9) WITHIN GROUP (ORDER BY width) AS ninth FROM :"model".sidewalk_source;
