-- argument tolerance: chords leave the road by at most this, metres, 0.001 to 10
-- see arc_road, arc_road_mesh
SELECT ST_AsText(streetgen.arc_road_line(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)', 20), 1), 2);
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 80 40, 140 40)') AS road)
SELECT road, 'helper', NULL FROM given
UNION ALL SELECT streetgen.arc_road_line(road, 0.8), 'result', NULL FROM given
UNION ALL SELECT (ST_DumpPoints(streetgen.arc_road_line(road, 0.8))).geom, 'point', NULL FROM given
