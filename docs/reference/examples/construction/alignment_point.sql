-- argument elements: elements of [horizontal_alignment](#horizontal_alignment)
-- argument metres: metres along the alignment
-- argument grades: abscissa, height and radius of grade points; NULL: the alignment has no heights
-- see horizontal_alignment, alignment_line
SELECT ST_AsText(p.geom, 2) AS place, round(p.heading::numeric, 4) AS heading, round(p.curvature::numeric, 5) AS curvature, p.grade
FROM (SELECT array_agg(e) AS elements FROM streetgen.horizontal_alignment('LINESTRING(0 0, 400 0, 700 300)', '{0, 130, 0}', '{0, 70, 0}') e) road,
    streetgen.alignment_point(elements, 400, '{"(0,100,0)","(700,121,0)"}') p;
-- drawing
WITH road AS (SELECT array_agg(e) AS elements FROM streetgen.horizontal_alignment('LINESTRING(0 0, 120 0, 180 90)', '{0, 60, 0}', '{0, 40, 0}') e)
SELECT streetgen.alignment_line(elements), 'helper', NULL FROM road
UNION ALL SELECT p.geom, 'point', m || ' m' FROM road, generate_series(0, 200, 50) m, streetgen.alignment_point(elements, m) p
