-- argument axis_offset: metres to the left of the road; to its right below 0
-- see arc_road_mesh, offset_line
SELECT ST_AsText(streetgen.arc_road_offset(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'), 10), 3);
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 80 40, 140 40)', 12) AS road)
SELECT road, 'axis', 'road' FROM given
UNION ALL SELECT streetgen.arc_road_offset(road, 8), 'result', '8' FROM given
UNION ALL SELECT streetgen.arc_road_offset(road, -18), 'result', '-18' FROM given
