-- argument line: LINESTRING, metres
-- argument keep: which points stay whatever happens, one value a point; empty: none
-- argument epsilon: points nearer to each other than this go, metres, 0 to 1000
-- argument r_min: points that turn more sharply than this radius go, metres, 0 to 1000
-- see import_axes
SELECT ST_AsText(streetgen.clean('LINESTRING(0 0, 10 0, 10.1 0.1, 20 0, 30 15)', '{}', 0.3, 3));
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 12 4, 13 1, 25 5, 34 5, 34.5 9, 36 5, 50 20)'::geometry AS line)
SELECT line, 'helper', NULL FROM given
UNION ALL SELECT (ST_DumpPoints(line)).geom, 'point', NULL FROM given
UNION ALL SELECT streetgen.clean(line, '{}', 0.3, 4), 'result', NULL FROM given
