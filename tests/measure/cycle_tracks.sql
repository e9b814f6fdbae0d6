-- Cycle tracks that a source maps as lines of their own, the metres of a model, and the share of these on a roadway,
-- on the ground of sidewalks, and beside a cycle lane that lies within 6 m and runs with them, so that the street has
-- both; psql -v model=NAME -f tests/measure/cycle_tracks.sql. A model computes footway and lane. Places every metre.
-- crossings apart: those lead over roadways. pieces_lost: sidewalks whose surface is in more pieces than its strip.
WITH place AS MATERIALIZED (
    SELECT f.level, p.geom, ST_Azimuth(ST_LineInterpolatePoint(f.geom, greatest(0, share - 0.001)),
            ST_LineInterpolatePoint(f.geom, least(1, share + 0.001))) AS heading
    FROM :"model".footway f JOIN :"model".axis_class c ON c.class = f.kind AND c.use = 'cycle',
        LATERAL (SELECT (n - 0.5) / ceil(ST_Length(f.geom)) AS share
            FROM generate_series(1, ceil(ST_Length(f.geom))::integer) n) s,
        LATERAL (SELECT ST_LineInterpolatePoint(f.geom, share) AS geom) p
    WHERE f.role IS DISTINCT FROM 'crossing'),
seen AS (
    SELECT EXISTS (SELECT FROM :"model".section s JOIN :"model".edge e USING (edge_id)
            WHERE e.level = p.level AND s.surface && p.geom AND ST_Covers(s.surface, p.geom)) AS driven,
        EXISTS (SELECT FROM :"model".sidewalk w WHERE w.surface && p.geom
            AND ST_Covers(w.surface, p.geom)) AS walked,
        EXISTS (SELECT FROM :"model".lane l WHERE l.kind = 'cycle' AND l.surface && ST_Expand(p.geom, 6)
            AND ST_DWithin(l.surface, p.geom, 6) AND abs(sin(p.heading
                - ST_Azimuth(ST_StartPoint(l.geom), ST_EndPoint(l.geom)))) < 0.5) AS laned
    FROM place p)
SELECT count(*) AS metres, round(100.0 * avg(driven::integer), 1) AS on_roadway,
    round(100.0 * avg((walked AND NOT driven)::integer), 1) AS on_sidewalk,
    round(100.0 * avg((laned AND NOT driven)::integer), 1) AS beside_cycle_lane
FROM seen;
SELECT count(*) AS sidewalks, count(*) FILTER (WHERE ST_NumGeometries(surface) > ST_NumGeometries(strip))
    AS pieces_lost FROM :"model".sidewalk;
