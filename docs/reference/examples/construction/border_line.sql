-- argument abscissa: place on the axis, metres from its start; clamped to the axis
-- see section_surface
SELECT ST_AsText(streetgen.border_line('LINESTRING(0 0, 60 0)', 20, 8));
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 30 0, 50 12)'::geometry AS axis)
SELECT streetgen.section_surface(axis, 8, 0, 53), 'section', NULL FROM given
UNION ALL SELECT axis, 'axis', 'axis' FROM given
UNION ALL SELECT streetgen.border_line(axis, 16, 8), 'result', NULL FROM given
UNION ALL SELECT ST_LineInterpolatePoint(axis, 16 / ST_Length(axis)), 'point', 'abscissa' FROM given
