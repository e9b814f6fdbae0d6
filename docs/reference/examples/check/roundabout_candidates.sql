-- argument eps: metres between centres of one cluster
-- argument least: centres of a cluster at least
-- see detect_arcs
INSERT INTO town.axis (geom) SELECT ST_ExteriorRing(ST_Buffer('SRID=2154;POINT(650300 6860300)'::geometry, 20));
SELECT number, ST_AsText(centre, 1) AS centre, round(radius::numeric, 1) AS radius, support FROM streetgen.roundabout_candidates('town');
-- drawing
WITH given AS (SELECT ST_ExteriorRing(ST_Buffer('POINT(0 0)'::geometry, 20, 4)) AS ring)
SELECT ring, 'axis', 'axis' FROM given UNION ALL SELECT centre, 'point', 'centre' FROM given, streetgen.detect_arcs(ring, tolerance => 1)
UNION ALL SELECT arc, 'result', NULL FROM given, streetgen.detect_arcs(ring, tolerance => 1)
