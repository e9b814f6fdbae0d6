-- argument node: the node of the crossing: its node_id
-- argument radius: radius of the ring along its axis, metres
-- see accept_mend, roundabout_candidates
INSERT INTO town.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650300 6860000, 650350 6860000, 650400 6860000)', 7), ('SRID=2154;LINESTRING(650350 6860060, 650350 6860000)', 6);
SELECT streetgen.make_roundabout('town', (SELECT node_id FROM town.node ORDER BY geom <-> 'SRID=2154;POINT(650350 6860000)' LIMIT 1), 15) > 0 AS made;
SELECT round(ST_Length(geom)) AS length, direction, roundabout_tag FROM town.axis WHERE ST_X(ST_StartPoint(geom)) > 650250 ORDER BY roundabout_tag, length;
-- drawing
SELECT geom, 'axis', 'axis' FROM (VALUES ('LINESTRING(-50 0, -15 0)'::geometry), ('LINESTRING(15 0, 50 0)'), ('LINESTRING(0 50, 0 15)')) v(geom)
UNION ALL SELECT ST_ExteriorRing(ST_Buffer('POINT(0 0)'::geometry, 15, 16)), 'result', 'ring'
UNION ALL SELECT 'POINT(0 0)', 'point', 'node'
