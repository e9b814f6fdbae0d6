-- argument radius: radius of the arc, metres
-- see arc_centre, max_corner_radius, intersection_surface
SELECT ST_GeometryType(arc), round(ST_Length(arc)::numeric, 2) AS metres
FROM streetgen.corner_arc('LINESTRING(0 0, 60 0)', 'LINESTRING(0 0, 0 60)', 8, 6, 7) arc;
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 40 0)'::geometry AS a, 'LINESTRING(0 0, 10 38)'::geometry AS b)
SELECT streetgen.section_surface(a, 8, 0, 40), 'section', NULL FROM given
UNION ALL SELECT streetgen.section_surface(b, 6, 0, 39), 'section', NULL FROM given
UNION ALL SELECT a, 'axis', 'axis_a' FROM given UNION ALL SELECT b, 'axis', 'axis_b' FROM given
UNION ALL SELECT streetgen.arc_centre(a, b, 8, 6, 7), 'point', 'centre' FROM given
UNION ALL SELECT streetgen.corner_arc(a, b, 8, 6, 7), 'result', NULL FROM given
