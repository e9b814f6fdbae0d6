-- argument line: LINESTRING, metres: the straight alignments
-- argument radii: radius of the arc at each point, metres; 0: the point stays sharp
-- argument clothoids: parameter A of both clothoids at each point, metres; 0: none
-- see alignment_point, alignment_line, vertical_alignment, clothoid
SELECT ordinality, kind, round(abscissa::numeric, 2) AS abscissa, round(length::numeric, 2) AS length, round(curvature_end::numeric, 5) AS curvature_end
FROM streetgen.horizontal_alignment('LINESTRING(0 0, 400 0, 700 300)', '{0, 130, 0}', '{0, 70, 0}');
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 120 0, 180 90)'::geometry AS line),
    road AS (SELECT line, array_agg(e ORDER BY ordinality) AS elements FROM given, streetgen.horizontal_alignment(line, '{0, 60, 0}', '{0, 40, 0}') e GROUP BY line)
SELECT line, 'helper', NULL FROM road
UNION ALL SELECT streetgen.alignment_line(elements), 'result', NULL FROM road
UNION ALL SELECT e.start, 'point', e.kind FROM road, unnest(elements) e
