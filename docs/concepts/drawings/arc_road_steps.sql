-- Chords of a road, and triangles between two offsets with as many steps on either border: figure 9 of Wilkie, Sewall and Lin.
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 84 40, 130 34, 168 62)', 34) AS road), beside AS (SELECT road, ST_Translate(road, 0, -45) AS below FROM given)
SELECT road, 'axis', NULL FROM beside
UNION ALL SELECT streetgen.arc_road_line(road, 0.5), 'result', 'chords' FROM beside
UNION ALL SELECT p.geom, 'point', NULL FROM beside, ST_DumpPoints(streetgen.arc_road_line(road, 0.5)) p
UNION ALL SELECT ST_MakePolygon(ST_ExteriorRing(ST_Force2D(t.geom))), 'result', NULL FROM beside, ST_Dump(streetgen.arc_road_mesh(below, 5, -5, 0.5)) t
UNION ALL SELECT below, 'axis', NULL FROM beside
