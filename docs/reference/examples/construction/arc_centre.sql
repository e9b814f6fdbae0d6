-- argument radius: radius of the arc, metres
-- see corner_arc, max_corner_radius, turning_radius
SELECT ST_AsText(streetgen.arc_centre('LINESTRING(0 0, 60 0)', 'LINESTRING(0 0, 0 60)', 8, 6, 7));
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 40 0)'::geometry AS a, 'LINESTRING(0 0, 10 38)'::geometry AS b),
made AS (SELECT *, streetgen.arc_centre(a, b, 8, 6, 7) AS centre FROM given)
SELECT streetgen.section_surface(a, 8, 0, 40), 'section', NULL FROM given
UNION ALL SELECT streetgen.section_surface(b, 6, 0, 39), 'section', NULL FROM given
UNION ALL SELECT a, 'axis', 'axis_a' FROM given UNION ALL SELECT b, 'axis', 'axis_b' FROM given
UNION ALL SELECT ST_Boundary(ST_Buffer(centre, 7, 32)), 'helper', NULL FROM made
UNION ALL SELECT centre, 'result', 'centre' FROM made
