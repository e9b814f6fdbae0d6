\set ECHO none
\ir shared/truths.sql
-- What tables of lines hold instead of a LINESTRING, taken by import_axes.  (name, holds)
SELECT streetgen.create_model('town', 2154) \g /dev/null
CREATE TABLE drawn (id integer, geom geometry);
INSERT INTO drawn SELECT id, ST_GeomFromEWKT('SRID=2154;' || geom) FROM (VALUES
    -- Quarters of a circle of 50 m about 650000 6860000, and of one of 200 m.
    (1, 'CIRCULARSTRING(650050 6860000, 650040 6860030, 650000 6860050)'),
    (2, 'COMPOUNDCURVE((650300 6860000, 650300 6860100), CIRCULARSTRING(650300 6860100, 650340 6860220, 650500 6860300), (650500 6860300, 650600 6860300))'),
    (3, 'MULTICURVE((651000 6860000, 651100 6860000), CIRCULARSTRING(651300 6860000, 651290 6860030, 651250 6860050))'),
    (4, 'CIRCULARSTRING(652000 6860000, 652040 6860000, 652000 6860000)'),
    (5, 'GEOMETRYCOLLECTION(LINESTRING(653000 6860000, 653100 6860000))'),
    (6, 'GEOMETRYCOLLECTION(POINT(653000 6860100), LINESTRING(653000 6860100, 653100 6860100), GEOMETRYCOLLECTION(CIRCULARSTRING(653250 6860100, 653240 6860130, 653200 6860150)))'),
    (7, 'CIRCULARSTRING Z(654050 6860000 1, 654040 6860030 2, 654000 6860050 3)'),
    (8, 'CIRCULARSTRING M(655050 6860000 1, 655040 6860030 2, 655000 6860050 3)'),
    (9, 'CIRCULARSTRING ZM(656050 6860000 1 1, 656040 6860030 2 2, 656000 6860050 3 3)'),
    (10, 'CIRCULARSTRING(657000 6860000, 657000 6860000, 657000 6860000)'),
    (11, 'CIRCULARSTRING EMPTY'), (12, 'MULTICURVE EMPTY')) v(id, geom);
CREATE TABLE told AS SELECT * FROM streetgen.import_axes('town', 'drawn', '{"source_ref": "id"}');
SELECT 'curves and collections are taken, parts by themselves', array_agg(source_ref ORDER BY source_ref) = '{1,2,3/1,3/2,4,5,6/1,6/2,7,8,9}' FROM town.axis;
SELECT 'chords leave their arc by a centimetre at most', bool_and(least(abs(r - 50), 0.0101) <= 0.01) AND max(50 - r) > 0.005 FROM (SELECT ST_Distance(ST_LineInterpolatePoint(ST_MakeLine(p.geom, q.geom), 0.5), 'SRID=2154;POINT(650000 6860000)') AS r
    FROM town.axis, ST_DumpPoints(source_geom) p, ST_DumpPoints(source_geom) q WHERE source_ref = '1' AND q.path[1] = p.path[1] + 1) c;
SELECT 'a compound curve keeps its straight parts', abs(ST_Length(geom) - (200 + 100 * pi())) < 0.1 AND ST_Distance(geom, 'SRID=2154;POINT(650300 6860050)') < 0.01 FROM town.axis WHERE source_ref = '2';
SELECT 'a circle of three points is one', ST_IsClosed(geom) AND abs(ST_Length(geom) - 40 * pi()) < 0.2 FROM town.axis WHERE source_ref = '4';
SELECT 'an arc drawn from its other end has the same chords', ST_Reverse(streetgen._chords('', ST_Reverse(geom), 2154, 0.01))::bytea = streetgen._chords('', geom, 2154, 0.01)::bytea FROM drawn WHERE id = 1;
SELECT streetgen.create_model('hill', 2154, dimension => 3), streetgen.set('hill', 'curve_tolerance', '0.1') \g /dev/null
SELECT FROM streetgen.import_axes('hill', 'drawn', '{"source_ref": "id"}');
SELECT 'heights go along an arc', round(ST_Z(ST_StartPoint(geom))) = 1 AND round(ST_Z(ST_LineInterpolatePoint(geom, 0.41))) = 2 AND round(ST_Z(ST_EndPoint(geom))) = 3 FROM hill.axis WHERE source_ref = '7';
SELECT 'the tolerance is a setting', bool_and(ST_NPoints(h.source_geom) < ST_NPoints(t.source_geom)) FROM hill.axis h JOIN town.axis t USING (source_ref) WHERE source_ref IN ('1', '2', '7', '9');
-- An arc of 500 US survey feet.
SELECT streetgen.create_model('feet', 32618) \g /dev/null
CREATE TABLE measured AS SELECT 1 AS id, 'SRID=2263;CIRCULARSTRING(985500 205000, 985400 205300, 985000 205500)'::geometry AS geom;
SELECT FROM streetgen.import_axes('feet', 'measured', '{"source_ref": "id"}');
SELECT 'a centimetre is one of the ground, whatever the unit of the source', 500 * 0.3048 * (1 - cos(pi() / 4 / (ST_NPoints(source_geom) - 1))) BETWEEN 0.009 AND 0.0101 FROM feet.axis;
SELECT 'what is no line in a collection is told', count(*) = 1 FROM told WHERE what = 'other than lines in a collection, left out' AND source_refs = '{6}';
SELECT 'an arc of one place has no length', source_refs = '{10}' FROM told WHERE what = 'line without length, left out';
SELECT 'an empty curve is no geometry', source_refs = '{11,12}' FROM told WHERE what = 'row without geometry, left out';
INSERT INTO drawn VALUES (30, 'SRID=2154;GEOMETRYCOLLECTION(POINT(650000 6860000))');
SELECT 'a collection without a line is left out, and told', source_refs = '{30}' FROM streetgen.import_axes('town', 'drawn', '{"source_ref": "id"}') WHERE what = 'no line but a GEOMETRYCOLLECTION, left out';
UPDATE drawn SET geom = 'SRID=2154;CIRCULARSTRING(650000 6860000, 650040 6860030, 650000 NaN)' WHERE id = 30;
SELECT 'so is a curve to nowhere', (r).state = '22023' AND (r).said LIKE 'source row 30 has a vertex that is not finite%' FROM test.refusal($$SELECT streetgen.import_axes('town', 'drawn', '{"source_ref": "id"}')$$) r;
UPDATE drawn SET geom = 'CIRCULARSTRING(650000 6860000, 650040 6860030, 650000 6860050)' WHERE id = 30;
SELECT 'and one of no reference', (r).state = '22023' AND (r).said LIKE 'source row 30 has no SRID%' FROM test.refusal($$SELECT streetgen.import_axes('town', 'drawn', '{"source_ref": "id"}')$$) r;
-- A table that is followed.
DELETE FROM drawn WHERE id = 30;
SELECT FROM streetgen.follow('town', 'drawn', '{"source_ref": "id"}');
UPDATE drawn SET geom = 'SRID=2154;CIRCULARSTRING(650060 6860000, 650048 6860036, 650000 6860060)' WHERE id = 1;
SELECT 'a curve of a table that is followed', abs(ST_Length(geom) - 30 * pi()) < 0.1 FROM town.axis WHERE source_ref = '1';
