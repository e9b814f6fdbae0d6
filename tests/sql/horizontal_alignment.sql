\set ECHO none
\ir shared/truths.sql
-- Alignments of lines, clothoids and arcs from SQL. Each test is a row (name, holds).

CREATE TEMPORARY TABLE road AS SELECT array_agg(e ORDER BY ordinality) AS elements
    FROM streetgen.horizontal_alignment('SRID=2154;LINESTRING(0 0,400 0,700 300,1200 300)', '{0,130,250,0}', '{0,70,120,0}') e;
CREATE TEMPORARY TABLE grades AS SELECT ARRAY[(0, 100, 0), (400, 120, 2000), (900, 110, 0)]::streetgen.alignment_grade[] AS grades;

SELECT 'horizontal_alignment: line, clothoid, arc, clothoid', array_agg(kind ORDER BY ordinality) = '{line,clothoid,arc,clothoid,line,clothoid,arc,clothoid,line}' FROM road, unnest(elements);
SELECT 'horizontal_alignment: a clothoid is A^2 / R long', abs(length - 70 * 70 / 130.0) < 1e-9 FROM road, unnest(elements) WHERE ordinality = 2;
SELECT 'horizontal_alignment: left is positive', (SELECT curvature_start FROM road, unnest(elements) WHERE ordinality = 3) = 1 / 130.0::float8 AND (SELECT curvature_start FROM road, unnest(elements) WHERE ordinality = 7) = -1 / 250.0::float8;
SELECT 'horizontal_alignment: joints meet', bool_and(ST_DWithin(p.geom, b.start, 1e-9) AND abs(p.heading - b.heading) < 1e-9 AND abs(p.curvature - b.curvature_start) < 1e-9)
    FROM road, unnest(elements) a JOIN LATERAL unnest(elements) b ON b.ordinality = a.ordinality + 1, streetgen.alignment_point(ARRAY[a], a.abscissa + a.length) p;
SELECT 'horizontal_alignment: it ends where the line ends', ST_DWithin(p.geom, 'SRID=2154;POINT(1200 300)', 1e-9) AND abs(p.heading) < 1e-9 FROM road, streetgen.alignment_point(elements, 1e9) p;
CREATE TEMPORARY TABLE kept AS SELECT e.* FROM road, unnest(elements) e;
SELECT 'horizontal_alignment: stored rows give the same places', bool_and(ST_DWithin(a.geom, b.geom, 1e-7)) FROM road, (SELECT array_agg(k::text::streetgen.alignment_element ORDER BY ordinality) AS again FROM kept k) k,
    generate_series(0, 1200, 7) m, streetgen.alignment_point(elements, m) a, streetgen.alignment_point(again, m) b;
SELECT 'horizontal_alignment: ' || name, test.state(statement) = '22023' FROM (VALUES
    ('a curve that does not fit', $$SELECT streetgen.horizontal_alignment('LINESTRING(0 0,100 0,100 100)', '{0,200,0}', '{0,0,0}')$$),
    ('a radius too few', $$SELECT streetgen.horizontal_alignment('LINESTRING(0 0,100 0,100 100)', '{0,20}', '{0,0,0}')$$),
    ('a point twice', $$SELECT streetgen.horizontal_alignment('LINESTRING(0 0,100 0,100 0,100 100)', '{0,0,0,0}', '{0,0,0,0}')$$),
    ('NaN', $$SELECT streetgen.horizontal_alignment('LINESTRING(0 0,100 0,100 100)', '{0,NaN,0}', '{0,0,0}')$$),
    ('a turn straight back', $$SELECT streetgen.horizontal_alignment('LINESTRING(0 0,100 0,0 0)', '{0,5,0}', '{0,0,0}')$$)) v(name, statement);
SELECT 'horizontal_alignment: NULL gives no row', count(*) = 0 FROM streetgen.horizontal_alignment(NULL, '{0}', '{0}');

SELECT 'alignment_line: chords keep the tolerance', ST_HausdorffDistance(streetgen.alignment_line(elements, 0.01), streetgen.alignment_line(elements, 0.0001)) < 0.0102 FROM road;
SELECT 'alignment_line: with heights', ST_NDims(l) = 3 AND abs(ST_Z(ST_StartPoint(l)) - 100) < 1e-9 FROM road, grades, streetgen.alignment_line(elements, 0.01, grades) l;
SELECT 'alignment_point: height and grade on a parabola', abs(ST_Z(p.geom) - (120 - 2000 * power(0.05 + 0.02, 2) / 8)) < 1e-9 AND abs(p.grade - 0.015) < 1e-9 FROM road, grades, streetgen.alignment_point(elements, 400, grades) p;
SELECT 'alignment_point: no elements', test.state($$SELECT streetgen.alignment_point('{}', 1)$$) = '22023';

SELECT 'vertical_alignment: grade, crest, grade', array_agg(kind ORDER BY start_abscissa) = '{grade,crest,grade}' AND max(end_abscissa - start_abscissa) FILTER (WHERE kind = 'crest') - 140 < 1e-9 AND max(radius) = 2000
    FROM streetgen.vertical_alignment('{0,400,900}', '{100,120,110}', '{0,2000,0}');
SELECT 'vertical_alignment: points out of order', test.state($$SELECT streetgen.vertical_alignment('{0,400,300}', '{0,1,2}', '{0,0,0}')$$) = '22023';
SELECT 'vertical_alignment: lists of different lengths', test.state($$SELECT streetgen.vertical_alignment('{0,400}', '{0}', '{0,0}')$$) = '22004';

SELECT 'clothoid: from a straight line to an arc', abs(ST_Length(c) - 100) < 0.01 AND abs(ST_Y(ST_EndPoint(c)) - 100 * (0.5 / 3 - power(0.5, 3) / 42 + power(0.5, 5) / 1320)) < 1e-4 FROM streetgen.clothoid('POINT(0 0)', 0, 100, 0, 0.01, 0.001) c;
SELECT 'least_radius: the norm at 60 and 120 km/h', abs(streetgen.least_radius(60) - 130) < 1e-9 AND abs(streetgen.least_radius(120) - 700) < 1e-9;
SELECT 'least_radius: out of range', test.state('SELECT streetgen.least_radius(0)') = '22023';
SELECT 'benefit: positive where the road is shorter', streetgen.benefit(100, 200, 10, 15) = 1000 AND streetgen.benefit(100, 200, 10, NULL) = 'Infinity' AND streetgen.benefit(NULL, 200, 10, 15) IS NULL;
SELECT 'curvature_spectrum: shares sum to 1', abs(sum(share) - 1) < 1e-12 AND count(*) = 5 FROM streetgen.curvature_spectrum((SELECT ST_MakeLine(ST_Point(x, 50 * sin(x / 100.0)) ORDER BY x) FROM generate_series(0, 6000, 5) x));
SELECT 'curvature_spectrum: a straight line has none', count(*) = 0 FROM streetgen.curvature_spectrum('LINESTRING(0 0,9000 0)');
