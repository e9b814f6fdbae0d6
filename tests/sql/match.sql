\set ECHO none
\ir shared/truths.sql
-- The same street in two data sets: which lines of a table go along which axes.  (name, holds)
SELECT streetgen.create_model('town', 2154, subjects => '{}') \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, name) SELECT n, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7, called FROM (VALUES (1, 'LINESTRING(0 0, 100 0)', 'Rue de l''Église'), (2, 'LINESTRING(100 0, 200 0)', 'Rue de l''Église'),
  (3, 'LINESTRING(100 0, 100 120)', 'High Street'), (4, 'LINESTRING(0 300, 100 300)', NULL)) v(n, line, called);
CREATE TABLE survey (id integer, label text, pace float8, geom geometry);
INSERT INTO survey SELECT n, called, pace, ST_Transform(ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 4326) FROM (VALUES (1, 'rue de l''eglise', 30, 'LINESTRING(210 2, 150 2, -20 1)'), (2, 'HIGH STREET', 50, 'MULTILINESTRING((103 -2, 103 70), (102 70, 101 130))'),
  (3, 'Rue de l''Église', 20, 'LINESTRING(0 14, 100 14)'), (4, NULL, 70, 'LINESTRING(20 303, 60 303)'), (5, 'Quai', 10, 'LINESTRING(0 500, 100 500)')) v(n, called, pace, line);
CREATE FUNCTION pg_temp.pairs(mapping jsonb, distance float8 DEFAULT 10) RETURNS text LANGUAGE sql AS
  $$ SELECT string_agg(axis_id || ' ' || source_ref, ', ' ORDER BY n) FROM streetgen.match_axes('town', 'survey', mapping, distance) WITH ORDINALITY m(axis_id, source_ref, shared, alike, score, n) $$;
SELECT 'lines of another reference, direction and cut are found', pg_temp.pairs('{"source_ref": "id"}') = '1 1, 2 1, 3 2, 4 4';
SELECT 'shared is the share of the axis, and alike is unknown', bool_and(alike IS NULL AND CASE axis_id WHEN 4 THEN abs(shared - 0.4 * (1 - 3 / 20.0)) < 0.02 AND score > 0.84 ELSE abs(shared - score) < 0.05 AND shared > 0.85 END) AND count(*) = 4
  FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id"}');
SELECT 'axes that are dilated by more reach farther', pg_temp.pairs('{"source_ref": "id"}', 40) LIKE '1 1, 1 3, 2 1, %';
SELECT 'a name of other capitals is alike, one without accents is not', string_agg(axis_id || ' ' || source_ref || ' ' || coalesce(alike::text, '-'), ', ' ORDER BY axis_id, source_ref) = '3 2 1, 4 4 -' FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}');
SELECT streetgen.set('town', 'match_names', 'unaccent') \g /dev/null
SELECT 'accents want their extension', r.state = '0A000' AND r.hint = 'CREATE EXTENSION unaccent; or set match_names to plain.' FROM test.refusal($$SELECT * FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}')$$) r;
SELECT test.as_administrator('CREATE EXTENSION unaccent') \g /dev/null
SELECT 'without accents the names are alike, and one farther away is a match too', pg_temp.pairs('{"source_ref": "id", "name": "label"}') = '1 1, 2 1, 3 2, 4 4' AND pg_temp.pairs('{"source_ref": "id", "name": "label"}', 25) = '1 1, 1 3, 2 1, 3 2, 4 4';
SELECT streetgen.set('town', 'match_names', 'fuzzy') \g /dev/null
SELECT 'trigrams want their extension', r.state = '0A000' AND r.hint = 'CREATE EXTENSION pg_trgm; or set match_names to plain.' FROM test.refusal($$SELECT * FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}')$$) r;
SELECT test.as_administrator('CREATE EXTENSION pg_trgm') \g /dev/null
SELECT 'a name nearly alike is enough', alike BETWEEN 0.5 AND 0.9 AND score < shared FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}') WHERE axis_id = 1;
UPDATE survey SET label = 'Quai' WHERE id = 2;
SELECT 'a line of another name is none', NOT EXISTS (SELECT FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}') WHERE axis_id = 3);
SELECT streetgen.set('town', 'match_weight_name', '0') \g /dev/null
SELECT 'unless names weigh nothing', EXISTS (SELECT FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id", "name": "label"}') WHERE axis_id = 3);
SELECT streetgen.set('town', 'match_least', '0.99') \g /dev/null
SELECT 'a better score is asked for', pg_temp.pairs('{"source_ref": "id"}') IS NULL;
SELECT streetgen.set('town', 'match_least', '0.7') \g /dev/null
SELECT 'values move', count(*) = 4 FROM (SELECT DISTINCT ON (axis_id) axis_id, pace FROM streetgen.match_axes('town', 'survey', '{"source_ref": "id"}') m JOIN survey s ON s.id::text = m.source_ref ORDER BY axis_id, score DESC) best;
-- The settings are beside the streets.
SELECT 'no street is stale of them', count(*) = 0 FROM streetgen.check_model('town') WHERE rule LIKE '%stale%';
-- Rights.
CREATE ROLE match_reader ROLE CURRENT_USER;
SELECT streetgen.grant('town', 'match_reader', 'reader') \g /dev/null
GRANT SELECT ON survey TO match_reader;
SET ROLE match_reader;
SELECT 'a reader may ask', pg_temp.pairs('{"source_ref": "id"}') = '1 1, 2 1, 3 2, 4 4';
RESET ROLE;
-- Bad input.
CREATE FUNCTION pg_temp.refused(mapping text, distance text DEFAULT '10') RETURNS text LANGUAGE sql AS
  $$ SELECT state || ' ' || said || CASE WHEN hint IS NULL THEN '' ELSE ' +' END FROM test.refusal(format('SELECT * FROM streetgen.match_axes(%L, %L, %L, %L)', 'town', 'survey', mapping, distance)) $$;
SELECT 'a distance out of range', bool_and(pg_temp.refused('{"source_ref": "id"}', d) = format('22023 distance is %s, out of range +', d)) FROM unnest('{0,-1,1000,NaN,Infinity}'::text[]) d;
SELECT 'a table without a source_ref', pg_temp.refused('{}') = '42703 table public.survey has no column "source_ref" +';
SELECT 'a word that is no target', pg_temp.refused('{"source_ref": "id", "width": "pace"}') = '22023 the mapping names "width", which is no column of the source to fill +';
INSERT INTO survey VALUES (6, 'x', 1, 'SRID=2154;POINT(650000 6860000)');
SELECT 'a point among the lines', pg_temp.refused('{"source_ref": "id"}') = '22023 source row 6 has a POINT as geom +';
UPDATE survey SET geom = 'LINESTRING(650000 6860000, 650010 6860000)' WHERE id = 6;
SELECT 'a line of no reference', pg_temp.refused('{"source_ref": "id"}') = '22023 source row 6 has SRID 0 +';
UPDATE survey SET geom = ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 'NaN'), ST_MakePoint(650010, 6860000)), 2154) WHERE id = 6;
SELECT 'a vertex that is not finite', pg_temp.refused('{"source_ref": "id"}') = '22023 source row 6 has a vertex that is not finite +';
UPDATE survey SET geom = 'SRID=2154;LINESTRING(650000 6860000, 650010 6860000)', id = NULL WHERE id = 6;
SELECT 'a row that nothing names', pg_temp.refused('{"source_ref": "id"}') = '22023 source row number 6 has no source_ref +';
UPDATE survey SET id = 6, geom = CASE label WHEN 'x' THEN 'SRID=2154;LINESTRING EMPTY' END WHERE id IS NULL;
INSERT INTO survey VALUES (7, 'y', 1, NULL), (8, 'z', 1, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860000)'), (9, 'curve', 1, 'SRID=2154;CIRCULARSTRING(650000 6860300, 650050 6860304, 650100 6860300)');
SELECT 'rows without a line or without length are none, and a curve is a line', pg_temp.pairs('{"source_ref": "id"}') = '1 1, 2 1, 3 2, 4 4, 4 9' OR pg_temp.pairs('{"source_ref": "id"}') = '1 1, 2 1, 3 2, 4 9, 4 4';
TRUNCATE survey;
SELECT 'an empty table gives nothing', pg_temp.pairs('{"source_ref": "id"}') IS NULL;
DO $$ BEGIN PERFORM streetgen.drop_model('town'); END $$;
DROP OWNED BY match_reader;
DROP ROLE match_reader;
