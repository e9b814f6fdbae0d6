-- argument axis_offset: offset at the start of the axis, metres to its left; to its right below 0
-- argument offset_end: offset at the end of the axis, metres; NULL: as at the start
-- see lanes, variable_buffer
SELECT ST_AsText(streetgen.offset_line('LINESTRING(0 0, 60 0)', 2, -2));
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 30 0, 45 20, 75 20)'::geometry AS axis)
SELECT axis, 'axis', 'axis' FROM given
UNION ALL SELECT streetgen.offset_line(axis, 5), 'result', '5' FROM given
UNION ALL SELECT streetgen.offset_line(axis, -2, -8), 'result', '-2 to -8' FROM given
