-- argument offset_left: offset of the left border, metres to the left of the road
-- argument offset_right: offset of the right border, metres to the left of the road; to its right below 0
-- argument tolerance: borders leave the true ones by at most this, metres, 0.001 to 10
-- see arc_road_line, arc_road_offset
SELECT ST_NumGeometries(mesh) AS triangles, ST_AsText((ST_Dump(mesh)).geom, 2) AS first
FROM streetgen.arc_road_mesh(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'), 3.5, -3.5) mesh LIMIT 1;
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 80 40, 140 40)', 30) AS road)
SELECT ST_MakePolygon(ST_ExteriorRing(ST_Force2D(t.geom))), 'result', NULL FROM given, ST_Dump(streetgen.arc_road_mesh(road, 6, -6, 0.2)) t
UNION ALL SELECT road, 'axis', NULL FROM given
