-- argument line: LINESTRING, metres
-- argument radii: half width at each vertex of the line, metres
-- argument side: both, left or right
-- argument ends: flat or round
-- see section_surface, offset_line
SELECT round(ST_Area(streetgen.variable_buffer('LINESTRING(0 0, 10 0, 30 0)', ARRAY[4, 2, 3]))::numeric, 2) AS m2;
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 20 0, 45 10)'::geometry AS line)
SELECT streetgen.variable_buffer(line, ARRAY[4, 2, 6], 'both', 'round'), 'result', NULL FROM given
UNION ALL SELECT line, 'axis', NULL FROM given
UNION ALL SELECT (ST_DumpPoints(line)).geom, 'point', NULL FROM given
