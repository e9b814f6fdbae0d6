\set ECHO none
\ir shared/truths.sql
-- Any line table to axes: mapping, refusals, cleaning, following the source.  Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.with_mapping(mapping text) RETURNS text LANGUAGE sql AS $$
  SELECT format('SELECT count(*) FROM streetgen.import_axes(''import_a'', ''import_source'', %L)', mapping)
$$;
CREATE FUNCTION pg_temp.with_line(line text) RETURNS text LANGUAGE sql AS $$
  SELECT format('CREATE TABLE import_bad AS SELECT 77 AS id, %L::geometry AS geom; '
                'SELECT count(*) FROM streetgen.import_axes(''import_b'', ''import_bad'', ''{"source_ref": "id"}'')', line)
$$;
DO $$ BEGIN
  PERFORM streetgen.create_model('import_a', 32631);
  PERFORM streetgen.create_model('import_b', 32631);
END $$;
CREATE TABLE import_source (id integer, kind text, width float8, lanes integer, label text, geom geometry);
INSERT INTO import_source VALUES
  (1, 'residential', 7, 2, 'Rue A', 'SRID=32631;LINESTRING(0 0, 20 0, 20.1 0, 50 0, 100 0)'),
  (2, 'residential', 0, NULL, 'Rue B', 'SRID=32631;LINESTRING(50 0, 50 80)'),
  (3, 'secondary', 40, 2, NULL, 'SRID=32631;MULTILINESTRING((100 0, 200 0), (300 0, 400 0))'),
  (4, 'runway', 45, 1, NULL, 'SRID=32631;LINESTRING(0 1000, 2000 1000)'),
  (5, 'footway', NULL, NULL, NULL, 'SRID=32631;LINESTRING(0 5, 100 5)'),
  (6, 'residential', NULL, NULL, NULL, ST_Transform('SRID=32631;LINESTRING(650000 6860000, 650100 6860000)'::geometry, 32631)),
  (7, 'residential', 7, NULL, NULL, 'SRID=32631;LINESTRING(100 0, 50 0, 0 0)'),
  (9, 'residential', 7, NULL, NULL, 'SRID=32631;LINESTRING(0 3000, 90 3000, 100 3000)'),
  (10, 'residential', 7, NULL, NULL, 'SRID=32631;LINESTRING(0 3100, 90 3000.1, 200 3000.2)');
CREATE TABLE import_report AS SELECT * FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}');

SELECT 'a class that is walked makes no axis' AS name,
       (SELECT count(*) = 0 FROM import_a.axis WHERE kind = 'footway') AS holds;
SELECT 'classes are counted, as axes or footways',
       (SELECT count = 6 FROM import_report WHERE what = 'taken' AND class = 'residential')
   AND (SELECT count = 1 FROM import_report WHERE what = 'taken as footway' AND class = 'footway');
SELECT 'a width of zero is unknown and named',
       (SELECT width IS NULL FROM import_a.axis WHERE source_ref = '2')
   AND (SELECT source_refs = '{2}' FROM import_report WHERE what LIKE 'width of zero%');
SELECT 'a width beyond the lanes is named, part by part, a runway''s is not',
       (SELECT source_refs = '{3/1,3/2}' FROM import_report WHERE what = 'width not believed');
SELECT 'parts become axes of their own', (SELECT array_agg(source_ref ORDER BY source_ref) = '{3/1,3/2}' FROM import_a.axis WHERE source_ref LIKE '3%');
SELECT 'a constant fills its column', (SELECT bool_and(level = 1) FROM import_a.axis);
SELECT 'another SRID is transformed',
       (SELECT ST_SRID(geom) = 32631 AND ST_DWithin(ST_StartPoint(geom), 'SRID=32631;POINT(650000 6860000)', 0.01) FROM import_a.axis WHERE source_ref = '6');
SELECT 'a vertex that another axis shares stays', (SELECT ST_AsText(geom) LIKE '%50 0,%' FROM import_a.axis WHERE source_ref = '1');
SELECT 'near and collinear points go, the original stays beside',
       (SELECT ST_NPoints(geom) = 3 AND ST_NPoints(source_geom) = 5 FROM import_a.axis WHERE source_ref = '1');
SELECT 'an axis over another is named, the one that would go, and so is one in part',
       (SELECT source_refs = '{7,9}' FROM import_report WHERE what = 'axis lies on another');
SELECT 'the report says that generate is due', EXISTS (SELECT FROM import_report WHERE what = 'generate is due');

CREATE TABLE import_before AS SELECT ctid AS place, * FROM import_a.axis;
SELECT 'importing the same again changes no row',
       (SELECT count(*) >= 0 FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}'))
   AND NOT EXISTS (SELECT FROM import_before b LEFT JOIN import_a.axis a ON a.ctid = b.place AND a.axis_id = b.axis_id WHERE a.axis_id IS NULL);
UPDATE import_source SET label = 'Rue C' WHERE id = 2;
DELETE FROM import_source WHERE id = 4;
INSERT INTO import_source VALUES (8, 'residential', 6, 2, NULL, 'SRID=32631;LINESTRING(0 200, 100 200)');
SELECT 'importing again follows the source', (SELECT count(*) > 0 FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}'));
SELECT 'a new row is an axis', EXISTS (SELECT FROM import_a.axis WHERE source_ref = '8');
SELECT 'a vanished row is none', NOT EXISTS (SELECT FROM import_a.axis WHERE source_ref = '4');
SELECT 'a changed row keeps its id',
       (SELECT a.name = 'Rue C' AND a.axis_id = b.axis_id FROM import_a.axis a JOIN import_before b USING (source_ref) WHERE a.source_ref = '2');

-- Edited by hand: it stays until the source says something else.
UPDATE import_a.axis SET width = 17, name = 'by hand', geom = ST_Translate(geom, 0, 1) WHERE source_ref IN ('1', '2');
CREATE TABLE edited AS SELECT axis_id, source_ref, geom FROM import_a.axis WHERE source_ref IN ('1', '2');
UPDATE import_source SET width = coalesce(width, 6) + 1 WHERE id = 2;
SELECT 'importing again takes only the row that changed', (SELECT count = 1 FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}') WHERE what = 'new or changed');
SELECT 'an axis edited by hand stays so', a.width = 17 AND a.name = 'by hand' AND a.geom::bytea = e.geom::bytea FROM import_a.axis a JOIN edited e USING (axis_id) WHERE e.source_ref = '1';
SELECT 'so does one whose row changed, beside what the source says', (a.width, a.source_width) = (17, s.width) AND a.name = 'by hand' AND a.geom::bytea = e.geom::bytea FROM import_a.axis a JOIN edited e USING (axis_id) JOIN import_source s ON id = 2 WHERE e.source_ref = '2';
SELECT 'what both changed is in conflict', array_agg((c.axis_id = e.axis_id, column_name, by_hand, source_old, source_new, stands)::text) = ARRAY[(true, 'width', '17', NULL, '1', 'hand')::text] FROM import_a.import_conflict c, edited e WHERE e.source_ref = '2';
ALTER TABLE import_a.axis DROP source_hash CASCADE;
DROP TABLE import_a.delivered, import_a.open_conflict CASCADE;
SELECT streetgen.adopt_model('import_a') \g /dev/null
SELECT 'nor is all taken anew in a model of an older build', (SELECT count = 2 FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}') WHERE what = 'new or changed');
DROP TABLE edited;

SELECT 'where it is not known what was delivered, all that differs from the source is in conflict', array_agg(source_ref || ' ' || column_name ORDER BY source_ref, column_name) = '{1 name,1 width,2 name,2 width}' FROM import_a.import_conflict;
-- Cut by hand as QGIS does it: the first piece stays, the other comes with all its values and a reference of its own.
UPDATE import_a.axis SET geom = ST_LineSubstring(geom, 0, 0.4) WHERE source_ref = '8';
INSERT INTO import_a.axis (geom, width, source, source_ref, source_geom)
SELECT ST_LineSubstring(source_geom, 0.4, 1), width, source, '8_1', source_geom FROM import_a.axis WHERE source_ref = '8';
SELECT 'importing again leaves a piece that was cut off', (SELECT count(*) FROM streetgen.import_axes('import_a', 'import_source',
  '{"geom": "geom", "width": "width", "lane_count": "lanes", "kind": "kind", "name": "label", "source_ref": "id", "level": {"value": 1}}') WHERE what LIKE 'vanished%') = 0;
SELECT 'and the axis as it was cut', array_agg(round(ST_Length(geom)) ORDER BY source_ref) = '{40,60}' FROM import_a.axis WHERE source_ref IN ('8', '8_1');

SELECT 'a missing column is 42703', test.state(pg_temp.with_mapping('{"width": "breadth"}')) = '42703';
SELECT 'SQL is no column', test.state(pg_temp.with_mapping('{"width": "1); DROP TABLE import_source; --"}')) = '42703';
SELECT 'a key that is no column of axis is 22023', test.state(pg_temp.with_mapping('{"axis_id": "id"}')) = '22023';
SELECT 'a mapping that is no object is 22023', test.state(pg_temp.with_mapping('["width"]')) = '22023';
SELECT 'a part of a lane is 22023', test.state(pg_temp.with_mapping('{"lane_count": {"value": 2.5}}')) = '22023';
SELECT 'a whole number may have decimals', test.state(pg_temp.with_mapping('{"lane_count": {"value": 2.0}}')) IS DISTINCT FROM '22023';
SELECT 'a constant of the wrong type is 22023', test.state(pg_temp.with_mapping('{"width": {"value": "wide"}}')) = '22023';
SELECT 'a geometry column that is none is 22023', test.state(pg_temp.with_mapping('{"geom": "kind"}')) = '22023';
SELECT 'a line that is NULL: 22004', test.state($$SELECT streetgen._clean_network('{}', '{NULL}', 0.1, 0.3, 4)$$) = '22004';
SELECT 'a tolerance out of range: 22023', test.state($$SELECT streetgen._clean_network('{}', '{}', 11, 0.3, 4)$$) = '22023';
SELECT 'a model that does not exist is 3F000',
       test.state($$SELECT streetgen.import_axes('import_none', 'import_source', '{}')$$) = '3F000';
SELECT 'bad geometry is 22023 and names its row: ' || line, test.state(pg_temp.with_line(line)) = '22023' AND test.said(pg_temp.with_line(line)) LIKE '%77%'
  FROM unnest(ARRAY['SRID=32631;POINT(0 0)', 'LINESTRING(0 0, 1 1)',
                    'SRID=32631;LINESTRING(0 0, NaN 1)',
                    'SRID=32631;LINESTRING(0 0, 1e13 1)']) AS line;
CREATE TABLE bare (id integer, geom geometry);
INSERT INTO bare VALUES (1, NULL), (2, 'SRID=32631;LINESTRING(0 0, 100 0)'), (3, 'SRID=32631;LINESTRING EMPTY'), (NULL, 'GEOMETRYCOLLECTION EMPTY'), (5, 'SRID=32631;LINESTRING(0 50, 100 50)');
SELECT 'rows without geometry are told, and left out', array_agg(ROW (what, count, source_refs)::text ORDER BY what) = ARRAY[ROW ('generate is due', 2, NULL)::text, ROW ('neither width nor lanes stated, 6 m wide', 2, NULL)::text, ROW ('new or changed', 2, NULL)::text,
    ROW ('row without geometry, left out', 3, ARRAY['1', '3', 'number 4'])::text, ROW ('taken', 2, NULL)::text] FROM streetgen.import_axes('import_b', 'bare', '{"source_ref": "id"}');
SELECT 'and all others are axes', array_agg(source_ref ORDER BY source_ref) = '{2,5}' FROM import_b.axis;
UPDATE bare SET geom = NULL WHERE id = 5;
SELECT 'a row that lost its geometry has vanished', source_refs = '{5}' FROM streetgen.import_axes('import_b', 'bare', '{"source_ref": "id"}') WHERE what LIKE 'vanished%';
SELECT 'and is no axis', array_agg(source_ref) = '{2}' FROM import_b.axis;
CREATE TABLE mixed AS SELECT id, ST_GeomFromEWKT('SRID=32631;' || shape) AS geom FROM (VALUES (1, 'POINT(0 0)'), (2, 'LINESTRING(0 900, 100 900)'), (3, 'POLYGON((0 0, 9 0, 9 9, 0 0))'), (4, 'POINT(5 5)')) v(id, shape);
SELECT 'what is no line is left out beside lines, and told', array_agg(ROW (what, source_refs)::text ORDER BY what) = '{"(\"no line but a POINT, left out\",\"{1,4}\")","(\"no line but a POLYGON, left out\",{3})"}' FROM streetgen.import_axes('import_b', 'mixed', '{"source_ref": "id"}') WHERE what LIKE 'no line%';
DELETE FROM mixed WHERE id = 2;
SELECT 'a table without a line is refused, with the way out', state = '22023' AND said = 'source row 1 is a POINT, expected a line' AND hint LIKE '%the layer of the file, that has lines.' FROM test.refusal($$SELECT streetgen.import_axes('import_b', 'mixed', '{"source_ref": "id"}')$$);
DROP TABLE mixed;
TRUNCATE import_b.axis;
CREATE TABLE misspelt AS SELECT id, class, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * id), ST_MakePoint(90, 50 * id)), 32631) AS geom FROM (VALUES (1, 'secondry'), (2, 'secondary'), (3, 'secondry'), (4, 'footway'), (5, 'track')) v(id, class);
SELECT streetgen.set('import_b', 'width_default', '5.5') \g /dev/null
SELECT 'rows of a class that is unknown are taken and named, those of one that is not wanted or walked counted', array_agg((what, class, count, source_refs)::text ORDER BY what, class) = '{"(\"not taken: class\",track,1,)","(taken,secondary,1,)","(taken,secondry,2,)","(\"taken as footway\",footway,1,)","(\"unknown class, 5.5 m wide where neither width nor lanes are stated\",secondry,2,\"{1,3}\")"}'
  FROM streetgen.import_axes('import_b', 'misspelt', '{"source_ref": "id", "kind": "class"}') WHERE what ~ 'taken|unknown class';
SELECT 'they have the width that is told', array_agg(source_ref || ' ' || u.width ORDER BY source_ref) = '{"1 5.5","2 8","3 5.5"}' FROM import_b.axis JOIN import_b.axis_used u USING (axis_id) WHERE source = 'misspelt';
INSERT INTO import_b.axis_class (class, taken) VALUES ('secondry', false);
SELECT 'a class that was said not to be wanted is not', (what, count) = ('not taken: class', 2) FROM streetgen.import_axes('import_b', 'misspelt', '{"source_ref": "id", "kind": "class"}') WHERE class = 'secondry';
SELECT streetgen.set('import_b', 'width_default', '6') \g /dev/null
DROP TABLE misspelt;
TRUNCATE import_b.axis;
-- Tables of the user's, named as the import's own.
SELECT format('CREATE TABLE public.%I AS SELECT NULL::text AS class, false AS taken', name) FROM unnest('{_import,_import_part,_import_class,_import_query,_import_restriction}'::name[]) name \gexec
SELECT 'an import goes by its own tables', array_agg(what) @> '{taken,generate is due}' FROM streetgen.import_axes('import_b', 'bare', '{"source_ref": "id"}');
SELECT 'and leaves those of others: ' || name, to_regclass('public.' || name) IS NOT NULL FROM unnest('{_import,_import_part,_import_class,_import_query,_import_restriction}'::name[]) name;
DROP TABLE public._import, public._import_part, public._import_class, public._import_query, public._import_restriction;
TRUNCATE import_b.axis;
SELECT 'a refused import leaves no axis', (SELECT count(*) = 0 FROM import_b.axis);
SELECT 'the source is as it was', (SELECT count(*) = 9 FROM import_source);
DROP TABLE import_source, import_report, import_before;
DO $$ BEGIN
  PERFORM streetgen.drop_model('import_a');
  PERFORM streetgen.drop_model('import_b');
END $$;
