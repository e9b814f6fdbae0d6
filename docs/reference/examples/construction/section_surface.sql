-- argument start_abscissa: where the roadway begins, metres along the axis
-- argument end_abscissa: where the roadway ends, metres along the axis
-- see border_line, intersection_surface, variable_buffer
SELECT ST_AsText(streetgen.section_surface('LINESTRING(0 0, 60 0)', 8, 10, 50));
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 30 0, 45 20, 70 20)'::geometry AS axis)
SELECT streetgen.section_surface(axis, 8, 10, 70), 'result', NULL FROM given
UNION ALL SELECT axis, 'axis', 'axis' FROM given
