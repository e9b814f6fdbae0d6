\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- follow: a model in step with a user's own table.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 2154), streetgen.create_model('twin', 2154), streetgen.create_model('once', 2154) \g /dev/null

-- A grid of streets of 60 m; a vertex in the middle of each that cleaning takes, one near the next street that it keeps.
CREATE TABLE lines (id integer PRIMARY KEY, breite text, kind text, label text, remark text, geom geometry);
CREATE FUNCTION pg_temp.street(i integer, bend float8 DEFAULT 0) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ARRAY[a, ST_Translate(a, 0.1 * (1 - down), 0.1 * down), ST_Translate(a, 30 * (1 - down) + bend * down, 30 * down + bend * (1 - down)), ST_Translate(a, 60 * (1 - down), 60 * down)]), 2154)
  FROM (SELECT ST_Point(650000 + 60 * ((i / 2) % 4), 6860000 + 60 * ((i / 8) % 5)) AS a, i % 2 AS down) s $$;
INSERT INTO lines SELECT i, 5 + i % 4, CASE i % 7 WHEN 0 THEN 'footway' WHEN 1 THEN NULL ELSE 'residential' END, 'street ' || i, NULL, pg_temp.street(i) FROM generate_series(1, 24) i;

CREATE VIEW mapping AS SELECT '{"width": "breite", "kind": "kind", "name": "label", "source_ref": "id", "lane_count": {"value": 2}}'::jsonb AS mapping;
CREATE TABLE said AS SELECT f.* FROM mapping, streetgen.follow('town', 'lines', mapping) f;
SELECT 'follow says what import_axes says' AS name, NOT EXISTS ((SELECT * FROM said EXCEPT SELECT f.* FROM mapping, streetgen.import_axes('twin', 'lines', mapping) f)) AS holds;
SELECT 'generate is due', EXISTS (SELECT FROM said WHERE what = 'generate is due');
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null

CREATE FUNCTION pg_temp.differing() RETURNS bigint LANGUAGE sql AS $$
  SELECT count(*) FROM (SELECT to_jsonb(a) - 'axis_id' - 'geom' - 'source_geom' AS said, geom::text, source_geom::text FROM town.axis a) a
  FULL JOIN (SELECT to_jsonb(a) - 'axis_id' - 'geom' - 'source_geom' AS said, geom::text, source_geom::text FROM twin.axis a) b USING (said, geom, source_geom) WHERE a.said IS NULL OR b.said IS NULL $$;
-- One statement on the source; then as if all of it were imported again, and generated.
CREATE FUNCTION pg_temp.step(statement text) RETURNS boolean LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  PERFORM FROM mapping, streetgen.import_axes('twin', 'lines', mapping);
  PERFORM set_config('streetgen.live', '', true);
  RETURN pg_temp.differing() = 0 AND test.followed('town', 'once');
END $$;
SELECT 'in step after: ' || statement, pg_temp.step(statement) FROM (VALUES (1, $$UPDATE lines SET breite = '9.5' WHERE id = 3$$), (2, $$UPDATE lines SET label = 'rue' WHERE id IN (4, 5)$$),
  (3, $$UPDATE lines SET kind = 'footway' WHERE id = 9$$), (4, $$UPDATE lines SET kind = 'residential' WHERE id IN (7, 9)$$),
  (5, $$INSERT INTO lines SELECT i, 6, NULL, 'new', NULL, pg_temp.street(i) FROM generate_series(30, 33) i$$),
  (6, $$UPDATE lines SET geom = pg_temp.street(id, 4) WHERE id % 3 = 0$$), (7, $$DELETE FROM lines WHERE id IN (6, 14)$$),
  (8, $$UPDATE lines SET geom = ST_Collect(geom, ST_Translate(geom, 20, 20)) WHERE id = 10$$), (9, $$UPDATE lines SET geom = ST_GeometryN(geom, 1) WHERE id = 10$$),
  (10, $$UPDATE lines SET geom = ST_Transform(geom, 4326) WHERE id = 11$$), (11, $$UPDATE lines SET id = id + 100 WHERE id < 6$$),
  (12, $$UPDATE lines a SET geom = b.geom FROM lines b WHERE (a.id, b.id) IN ((101, 102), (102, 101))$$), (13, $$UPDATE lines SET breite = '150' WHERE id = 12$$), (14, $$UPDATE lines SET breite = '0' WHERE id = 13$$),
  (15, $$INSERT INTO lines SELECT 200, 6, NULL, 'point', NULL, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860000)'$$),
  (16, $$UPDATE lines SET geom = NULL WHERE id = 9$$), (17, $$UPDATE lines SET geom = 'SRID=2154;LINESTRING EMPTY' WHERE id = 10$$),
  (18, $$INSERT INTO lines VALUES (12, 4, NULL, 'again', NULL, pg_temp.street(40)) ON CONFLICT (id) DO UPDATE SET breite = 4$$),
  (19, $$MERGE INTO lines l USING (VALUES (15), (300)) v(n) ON id = n WHEN MATCHED THEN DELETE WHEN NOT MATCHED THEN INSERT VALUES (300, 7, NULL, 'merged', NULL, pg_temp.street(41, 2))$$)) v(nth, statement);

-- Random scripts.
CREATE FUNCTION pg_temp.edit() RETURNS text LANGUAGE sql AS $$
  SELECT format((ARRAY['UPDATE lines SET breite = %2$s WHERE id %% 5 = %1$s %% 5', 'UPDATE lines SET geom = pg_temp.street(%3$s, %2$s + id / 1000.0) WHERE id IN (SELECT id FROM lines ORDER BY id LIMIT 1 OFFSET %1$s)',
      'DELETE FROM lines WHERE id IN (SELECT id FROM lines WHERE id > 16 ORDER BY id LIMIT 2 OFFSET %1$s)', 'INSERT INTO lines VALUES (%4$s, %2$s, NULL, %3$s, NULL, pg_temp.street(%3$s, 1 + %4$s / 1e6))',
      'UPDATE lines SET kind = CASE WHEN kind = ''footway'' THEN NULL ELSE ''footway'' END WHERE id %% 11 = %1$s', 'UPDATE lines SET geom = ST_Multi(ST_Collect(ST_Transform(ST_GeometryN(geom, 1), 2154), pg_temp.street(%3$s, id / 1000.0))) WHERE id %% 13 = %1$s',
      'UPDATE lines SET geom = ST_Reverse(geom), remark = %1$s WHERE id %% 17 = %1$s', 'UPDATE lines SET id = %4$s WHERE id IN (SELECT id FROM lines ORDER BY id LIMIT 1 OFFSET %1$s)'])[1 + floor(8 * random())::integer],
    floor(12 * random())::integer, 4 + floor(6 * random())::integer, floor(40 * random())::integer, 1000 + floor(1e6 * random())::integer) $$;
SELECT setseed(0.4) \g /dev/null
SELECT format('in step after random edit %s', n), (SELECT pg_temp.step(e) FROM pg_temp.edit() e WHERE n > 0) FROM generate_series(1, 40) n;
SELECT 'there is something left to compare', count(*) > 10 FROM town.axis;

-- What writes nothing.
CREATE TABLE before AS SELECT test.rows('town') AS rows, (SELECT array_agg((ctid, xmin)::text ORDER BY ctid) FROM town.axis) AS axes;
UPDATE lines SET remark = 'seen', label = label;
UPDATE lines SET breite = 7 WHERE id = -1;
DELETE FROM lines WHERE id = -1;
SELECT 'columns that are not mapped, and statements that find no row, write nothing', rows = test.rows('town') AND axes = (SELECT array_agg((ctid, xmin)::text ORDER BY ctid) FROM town.axis) FROM before;
SELECT pg_temp.step($$UPDATE lines SET breite = 6 WHERE id = 8$$) \g /dev/null
UPDATE town.axis SET width = 11, name = 'by hand' WHERE source_ref = '16';
UPDATE lines SET breite = 8 WHERE id = 8;
SELECT 'what was edited by hand stays while its row does', width = 11 FROM town.axis WHERE source_ref = '16';
UPDATE lines SET label = 'changed' WHERE id = 16;
SELECT 'and where its row changes in what was edited', (width, name) = (11, 'by hand') FROM town.axis WHERE source_ref = '16';
SELECT 'which is in conflict', array_agg((column_name, by_hand, source_old, source_new)::text) = ARRAY[('name', 'by hand', 'street 16', 'changed')::text] FROM town.import_conflict;
SELECT streetgen.settle_conflict('town', axis_id, 'name', 'source') FROM town.axis WHERE source_ref = '16' \g /dev/null
SELECT 'until somebody settles it', name = 'changed' AND NOT EXISTS (SELECT FROM town.import_conflict) FROM town.axis WHERE source_ref = '16';
UPDATE town.axis SET width = NULL WHERE source_ref = '16';
SELECT 'until that is emptied', a.width IS NOT DISTINCT FROM l.breite::float8 FROM town.axis a JOIN lines l ON l.id = 16 WHERE source_ref = '16';

-- Cut by hand: both pieces follow the row in what nobody edited, and stay where it ends.
INSERT INTO lines VALUES (500, 6, NULL, 'cut', NULL, 'SRID=2154;LINESTRING(651000 6860000, 651100 6860000)'), (501, 6, NULL, 'same line', NULL, 'SRID=2154;LINESTRING(651000 6860000, 651100 6860000)');
UPDATE town.axis SET geom = ST_LineSubstring(geom, 0, 0.4) WHERE source_ref = '500';
INSERT INTO town.axis (geom, source, source_ref, source_geom) SELECT ST_LineSubstring(source_geom, 0.4, 1), source, '500_1', source_geom FROM town.axis WHERE source_ref = '500';
UPDATE town.axis SET width = 6, lane_count = 2, width_by_hand = false WHERE source_ref = '500_1';
UPDATE lines SET kind = 'secondary' WHERE id = 500;
SELECT 'pieces that were cut by hand', array_agg(concat_ws(' ', source_ref, kind, round(ST_Length(geom))) ORDER BY source_ref) = '{500 secondary 40,500_1 secondary 60,501 100}' FROM town.axis WHERE source_ref LIKE '50%';
DELETE FROM lines WHERE id IN (500, 501);
SELECT 'they stay, in conflict, where the row ends', array_agg(c.column_name ORDER BY a.source_ref) = '{*,*}' AND array_agg(a.source_ref ORDER BY a.source_ref) = '{500,500_1}' FROM town.axis a LEFT JOIN town.import_conflict c USING (axis_id) WHERE a.source_ref LIKE '50%';
SELECT streetgen.settle_conflict('town', axis_id, '*', 'source') FROM town.import_conflict \g /dev/null
SELECT 'until the source is to hold', count(*) = 0 FROM town.axis WHERE source_ref LIKE '50%';

-- Refusals: those of import_axes, and the statement is undone.
CREATE TABLE copy AS TABLE lines;
SELECT 'refused as import_axes does it: ' || what, (refused).state = '22023' AND (refused) = (imported) AND NOT EXISTS (SELECT * FROM lines EXCEPT SELECT * FROM copy)
FROM (SELECT what, test.refusal('UPDATE lines SET ' || what || ' WHERE id = 8') AS refused,
        test.refusal('UPDATE copy SET ' || what || $$ WHERE id = 8; SELECT FROM mapping, streetgen.import_axes('twin', 'copy', mapping)$$) AS imported
      FROM unnest(ARRAY['geom = ST_SetSRID(geom, 0)',
        'geom = ''SRID=2154;LINESTRING(0 0, NaN 1)''', 'geom = ''SRID=2154;LINESTRING(0 0, 1 1)''', 'geom = ST_SetSRID(''LINESTRING(500 500, 501 500)''::geometry, 4326)']) what) r;
SELECT 'a row that becomes a point is left out, as in import_axes', pg_temp.step('UPDATE lines SET geom = ST_StartPoint(geom) WHERE id = 8');
SELECT 'it is no axis', NOT EXISTS (SELECT FROM town.axis WHERE source_ref = '8');
SELECT 'it comes back as a line', pg_temp.step('UPDATE lines SET geom = pg_temp.street(8) WHERE id = 8');
SELECT 'and is one', EXISTS (SELECT FROM town.axis WHERE source_ref = '8');
SELECT 'beside another line it is left out, as in import_axes', pg_temp.step('UPDATE lines SET geom = CASE id WHEN 8 THEN ST_StartPoint(geom) ELSE ST_Translate(geom, 1, 0) END WHERE id IN (8, 16)');
SELECT 'until it is a line again', pg_temp.step('UPDATE lines SET geom = pg_temp.street(8) WHERE id = 8');
SELECT 'a width that means nothing is unknown, as in import_axes: ' || width, pg_temp.step(format('UPDATE lines SET breite = %L WHERE id = 8', width))
FROM unnest('{wide,300,NaN}'::text[]) width;
SELECT 'so is the axis', width IS NULL FROM town.axis WHERE source_ref = '8';
SELECT 'the model is still in step', pg_temp.step('UPDATE lines SET breite = 5.5 WHERE id = 8');
ALTER TABLE lines DROP CONSTRAINT lines_pkey;
SELECT 'rows that swap their names', pg_temp.step('UPDATE lines SET id = 24 - id WHERE id IN (8, 16)');
SELECT 'a second row with the name of another is refused', test.said('INSERT INTO lines SELECT 8, 6, NULL, NULL, NULL, pg_temp.street(44)') LIKE 'source_ref 8 stands in more than one source row'
   AND test.said('UPDATE lines SET id = 8 WHERE id = 16') LIKE 'source_ref 8 stands in more than one source row';
ALTER TABLE lines ALTER id DROP NOT NULL;
SELECT 'a row without a name is refused', test.state('INSERT INTO lines SELECT NULL, 6, NULL, NULL, NULL, pg_temp.street(44)') = '22023';

-- What can be followed.
CREATE VIEW seen AS TABLE lines;
CREATE TABLE parted (id integer, geom geometry) PARTITION BY RANGE (id);
CREATE TABLE part PARTITION OF parted FOR VALUES FROM (0) TO (9);
CREATE TABLE nameless AS SELECT NULL::integer AS id, pg_temp.street(1) AS geom;
CREATE TABLE doubled AS SELECT 1 AS id, pg_temp.street(n) AS geom FROM generate_series(1, 2) n;
SELECT format('follow refuses %s with %s', source, wanted), test.state(format('SELECT streetgen.follow(%L, %L, %L)', model, source, mapping)) = wanted
FROM (VALUES ('town', 'seen', '{"source_ref": "id"}', '42809'), ('town', 'parted', '{"source_ref": "id"}', '42809'), ('town', 'part', '{"source_ref": "id"}', '42809'), ('town', 'twin.axis', '{"source_ref": "axis_id"}', '42809'),
  ('town', 'copy', '{}', '22023'), ('town', 'copy', '{"source_ref": {"value": "a"}}', '22023'), ('town', 'copy', '{"source_ref": "nr"}', '42703'), ('town', 'copy', '[]', '22023'),
  ('town', 'nameless', '{"source_ref": "id"}', '22023'), ('town', 'doubled', '{"source_ref": "id"}', '22023'), ('nowhere', 'copy', '{"source_ref": "id"}', '3F000')) v(model, source, mapping, wanted);
SELECT 'a refused follow leaves no trigger', NOT EXISTS (SELECT FROM pg_trigger WHERE tgrelid IN ('copy'::regclass, 'nameless'::regclass));

-- Two sources, two models, several steps in one transaction.
CREATE TABLE "More lines" (key text, "the $body$ line" geometry);
INSERT INTO "More lines" VALUES ('a', 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000)'), ('8', 'SRID=2154;LINESTRING(650560 6860000, 650600 6860030)');
SELECT streetgen.follow('town', '"More lines"', '{"geom": "the $body$ line", "source_ref": "key", "name": {"value": "it''s 5 %"}}') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'a second source leaves the first alone', count(*) FILTER (WHERE source_ref = '8') = 2 AND count(DISTINCT source) = 2 FROM town.axis;
SELECT count(*) FROM mapping, streetgen.follow('twin', 'lines', mapping) \g /dev/null
SELECT count(*) FROM streetgen.generate('twin', wait => true) \g /dev/null
BEGIN;
UPDATE lines SET breite = 10 WHERE id = 8;
DELETE FROM "More lines" WHERE key = 'a';
INSERT INTO "More lines" VALUES ('c', 'SRID=2154;LINESTRING(650600 6860030, 650660 6860030)');
UPDATE lines SET breite = 9 WHERE id = 16;
COMMIT;
SELECT 'two sources, in one transaction', test.followed('town', 'once') AND (SELECT array_agg(source_ref ORDER BY source_ref) = '{8,c}' FROM town.axis WHERE name = 'it''s 5 %');
SELECT 'a source that two models follow', test.followed('twin', 'once') AND (SELECT array_agg(width ORDER BY source_ref) = '{9,10}' FROM twin.axis WHERE source = 'lines' AND source_ref IN ('8', '16'));
TRUNCATE "More lines";
SELECT 'TRUNCATE takes the axes of its table only', count(*) = 0 FROM town.axis WHERE source <> 'lines';
SELECT 'and the streets', test.followed('town', 'once');

-- Taken back; dropped.
SELECT streetgen.unfollow('town', 'lines') \g /dev/null
UPDATE lines SET breite = 4 WHERE id = 8;
SELECT 'unfollow: the axes stay', (SELECT width = 10 FROM town.axis WHERE source_ref = '8') AND (SELECT width = 4 FROM twin.axis WHERE source = 'lines' AND source_ref = '8');
SELECT 'what is not followed cannot be left', test.state($$SELECT streetgen.unfollow('town', 'lines')$$) = '42704';
UPDATE lines SET id = 800 WHERE id = 8;
SELECT count(*) FROM mapping, streetgen.follow('town', 'lines', mapping) \g /dev/null
SELECT 'follow again brings what changed in between', width = 4 FROM town.axis WHERE source = 'lines' AND source_ref = '800';
SELECT count(*) FROM streetgen.follow('town', 'lines', '{"width": {"value": 3}, "source_ref": "id"}') \g /dev/null
CREATE TABLE gone AS SELECT 1 AS id, 'SRID=2154;LINESTRING(650700 6860000, 650760 6860000)'::geometry AS geom;
CREATE TABLE renamed AS SELECT 1 AS id, 'SRID=2154;LINESTRING(650700 6860100, 650760 6860100)'::geometry AS geom;
SELECT count(*) FROM unnest(ARRAY['gone', 'renamed']) t, streetgen.follow('town', t::regclass, '{"source_ref": "id"}') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
DROP TABLE gone;
ALTER TABLE renamed RENAME id TO key;
SELECT test.as_administrator('DROP EXTENSION streetgen CASCADE'), test.as_administrator('CREATE EXTENSION streetgen') \g /dev/null
SELECT 'without the extension nothing is followed', NOT EXISTS (SELECT FROM pg_trigger WHERE tgrelid = 'lines'::regclass);
SELECT streetgen.adopt_model('town'), streetgen.adopt_model('once'), streetgen.adopt_model('twin') \g /dev/null
UPDATE lines SET geom = ST_Translate(geom, 0, 1) WHERE id = 800;
SELECT 'adopt_model follows again, by the mapping of the last call', test.followed('town', 'once') AND (SELECT ST_Equals(a.source_geom, l.geom) AND width = 3 FROM town.axis a JOIN lines l ON (a.source, a.source_ref) = ('lines', id::text) WHERE id = 800);
SELECT 'for each model', ST_Equals(a.source_geom, l.geom) FROM twin.axis a JOIN lines l ON (a.source, a.source_ref) = ('lines', id::text) WHERE id = 800;
SELECT 'a table that is gone is forgotten, one that cannot be followed is kept', array_agg(source ORDER BY source) = '{"\"More lines\"",lines,renamed}' FROM town.followed;
SELECT 'and can be left', test.state($$SELECT streetgen.unfollow('town', 'renamed')$$) = 'none' AND test.state($$SELECT streetgen.unfollow('town', 'renamed')$$) = '42704';
SELECT 'a second follow is instead of the first', count(*) = 4 FROM pg_trigger WHERE tgrelid = 'lines'::regclass AND tgname LIKE '%town';
SELECT streetgen.drop_model('twin') \g /dev/null
UPDATE lines SET remark = 'on';
SELECT 'a model that is dropped takes its triggers with it', count(*) = 4 FROM pg_trigger WHERE tgrelid = 'lines'::regclass;

-- Rights: of the owner of the model, and TRIGGER on a table of somebody else; its writers need none on the model.
CREATE ROLE follow_owner ROLE CURRENT_USER;
CREATE ROLE follow_writer ROLE CURRENT_USER;
SELECT format('GRANT CREATE ON DATABASE %I TO follow_owner', current_database()) \gexec
CREATE SCHEMA survey AUTHORIZATION follow_writer;
SET ROLE follow_writer;
CREATE TABLE survey.road (id integer, geom geometry);
INSERT INTO survey.road VALUES (1, 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000)');
GRANT USAGE ON SCHEMA survey TO follow_owner;
GRANT SELECT ON survey.road TO follow_owner;
RESET ROLE;
SET ROLE follow_owner;
SELECT streetgen.create_model('rural', 2154) \g /dev/null
SELECT 'follow needs the right to make triggers', test.state($$SELECT streetgen.follow('rural', 'survey.road', '{"source_ref": "id"}')$$) = '42501';
RESET ROLE;
GRANT TRIGGER ON survey.road TO follow_owner;
SET ROLE follow_owner;
SELECT 'and nothing else on it', test.state($$SELECT streetgen.follow('rural', 'survey.road', '{"source_ref": "id"}')$$) = 'none';
SELECT count(*) FROM streetgen.generate('rural', wait => true) \g /dev/null
RESET ROLE;
SET ROLE follow_writer;
INSERT INTO survey.road VALUES (2, 'SRID=2154;LINESTRING(650560 6860000, 650600 6860030)');
SELECT 'a writer of the table cannot read the model', test.state('SELECT FROM rural.axis') = '42501';
SELECT 'nor follow with it, nor take it back', test.state($$SELECT streetgen.follow('rural', 'survey.road', '{"source_ref": "id"}')$$) = '42501' AND test.state($$SELECT streetgen.unfollow('rural', 'survey.road')$$) = '42501';
RESET ROLE;
SELECT 'but the model follows him', test.followed('rural', 'once') AND (SELECT count(*) = 2 FROM rural.axis);
SET ROLE follow_owner;
SELECT 'the owner of the model takes it back on a table of another', test.state($$SELECT streetgen.unfollow('rural', 'survey.road')$$) = 'none';
-- What the owner of a model writes there gives no rights: adopted by a superuser it follows what its owner may.
INSERT INTO rural.followed VALUES ('survey.secret', '{"source_ref": "id"}');
RESET ROLE;
CREATE TABLE survey.secret AS SELECT 1 AS id, 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000)'::geometry AS geom;
SET client_min_messages = error;
SELECT streetgen.adopt_model('rural') \g /dev/null
SELECT 'a table that the owner of the model may not read is not followed', NOT EXISTS (SELECT FROM pg_trigger WHERE tgrelid = 'survey.secret'::regclass);
DROP SCHEMA survey CASCADE;
SELECT streetgen.drop_model('rural') \g /dev/null
DROP OWNED BY follow_owner, follow_writer;
DROP ROLE follow_owner, follow_writer;
