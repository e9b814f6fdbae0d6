-- argument extent: what to mesh, in the reference of the model; NULL: all
-- argument tolerance: the mesh leaves the heights of the axes by at most this, metres, 0.001 to 10
-- see arc_road_mesh, export_layer
SELECT edge_id, node_id, level, ST_NumGeometries(geom) AS triangles FROM streetgen.road_mesh('town', tolerance => 0.05);
-- drawing
WITH mesh AS (SELECT * FROM streetgen.road_mesh('town', ST_MakeEnvelope(650085, 6859970, 650115, 6860010, 2154)))
SELECT ST_Intersection(ST_MakePolygon(ST_ExteriorRing(ST_Force2D(t.geom))), ST_MakeEnvelope(650070, 6859965, 650130, 6860015, 2154)), CASE WHEN node_id IS NULL THEN 'result' ELSE 'intersection' END, NULL
FROM mesh, ST_Dump(geom) t WHERE t.geom && ST_MakeEnvelope(650070, 6859965, 650130, 6860015, 2154)
