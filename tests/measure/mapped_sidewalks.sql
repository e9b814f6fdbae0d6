-- Of the footways of a model that say that they are sidewalks, the metres at street level, and the share of these on
-- sidewalks, on roadway, and elsewhere; psql -v model=NAME -f tests/measure/mapped_sidewalks.sql. Places every metre,
-- so that a share is that of the length. off_all_streets lies beyond 30 m of every edge: the extract lacks its street.
WITH place AS MATERIALIZED (
    SELECT footway_id, f.level, (ST_DumpPoints(ST_LineInterpolatePoints(geom, least(1, 1 / ST_Length(geom))))).geom
    FROM :"model".footway f WHERE role = 'sidewalk' AND ST_Length(geom) > 0),
seen AS (
    SELECT EXISTS (SELECT FROM :"model".sidewalk w WHERE w.surface && p.geom
        AND ST_Covers(w.surface, p.geom)) AS walked,
        EXISTS (SELECT FROM :"model".section s JOIN :"model".edge e USING (edge_id)
            WHERE s.surface && p.geom AND ST_Covers(s.surface, p.geom) AND e.level = p.level
            UNION ALL SELECT FROM :"model".intersection i
            WHERE i.surface && p.geom AND ST_Covers(i.surface, p.geom) AND i.level = p.level) AS driven,
        EXISTS (SELECT FROM :"model".edge e WHERE ST_DWithin(e.geom, p.geom, 30)) AS beside
    FROM place p)
SELECT count(*) AS metres, round(100.0 * avg((walked AND NOT driven)::integer), 1) AS on_sidewalk,
    round(100.0 * avg(driven::integer), 1) AS on_roadway, round(100.0 * avg((NOT walked AND NOT driven)::integer), 1)
        AS elsewhere, round(100.0 * avg((NOT beside)::integer), 1) AS off_all_streets
FROM seen;
SELECT count(*) AS mapped_sides, percentile_cont(0.1) WITHIN GROUP (ORDER BY width) AS tenth,
    percentile_cont(0.5) WITHIN GROUP (ORDER BY width) AS median,
    percentile_cont(0.9) WITHIN GROUP (ORDER BY width) AS ninth FROM :"model".sidewalk_source;
