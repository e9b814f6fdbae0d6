-- argument line: LINESTRING, metres
-- argument step: metres between the places where headings are taken, 0.01 to 1000
-- argument extent: length of a window, metres, 16 to 100000 steps
-- see alignment_line
SELECT cycles_from, cycles_to, round(share::numeric, 3) AS share
FROM streetgen.curvature_spectrum((SELECT ST_MakeLine(ST_Point(x, 50 * sin(x / 100.0)) ORDER BY x) FROM generate_series(0, 6000, 5) x));
