-- argument elements: elements of [horizontal_alignment](#horizontal_alignment)
-- argument tolerance: chords leave the alignment by at most this, metres, 1e-5 to 100
-- argument grades: abscissa, height and radius of grade points; NULL: the line has no heights
-- see horizontal_alignment, alignment_point
SELECT ST_NPoints(streetgen.alignment_line(elements)) AS points
FROM (SELECT array_agg(e) AS elements FROM streetgen.horizontal_alignment('LINESTRING(0 0, 400 0, 700 300)', '{0, 130, 0}', '{0, 70, 0}') e) road;
-- drawing
WITH road AS (SELECT array_agg(e) AS elements FROM streetgen.horizontal_alignment('LINESTRING(0 0, 120 0, 180 90)', '{0, 60, 0}', '{0, 40, 0}') e)
SELECT streetgen.alignment_line(elements), 'helper', NULL FROM road
UNION ALL SELECT streetgen.alignment_line(elements, 2), 'result', NULL FROM road
UNION ALL SELECT p.geom, 'point', NULL FROM road, ST_DumpPoints(streetgen.alignment_line(elements, 2)) p
