-- argument lines: LINESTRINGs in one direction
-- see lanes, offset_line
SELECT ST_AsText(streetgen.mean_line(ARRAY['LINESTRING(0 0, 60 0)', 'LINESTRING(0 4, 60 8)']::geometry[]));
-- drawing
WITH given AS (SELECT ARRAY['LINESTRING(0 0, 60 0)', 'LINESTRING(0 12, 30 14, 60 8)']::geometry[] AS lines)
SELECT unnest(lines), 'axis', NULL FROM given UNION ALL SELECT streetgen.mean_line(lines), 'result', NULL FROM given
