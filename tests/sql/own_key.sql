\set ECHO none
\ir shared/truths.sql
-- Who writes keys of his own takes none from those who leave them out.
SELECT streetgen.create_model('town', srid => 2154, subjects => ARRAY['object', 'height', 'junction']) \g /dev/null
CREATE FUNCTION test.line(place integer) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000 + 300 * place), ST_MakePoint(650100, 6860000 + 300 * place)), 2154) $$;

-- Several rows, one, in one statement with others, by COPY, and by a changed key.
INSERT INTO town.axis (axis_id, geom, width) SELECT i, test.line(i), 6 FROM generate_series(1, 3) i;
INSERT INTO town.axis (geom, width) VALUES (test.line(4), 6);
INSERT INTO town.axis (axis_id, geom, width) VALUES (DEFAULT, test.line(5), 6), (6, test.line(6), 6), (DEFAULT, test.line(7), 6), (100, test.line(8), 6), (DEFAULT, test.line(9), 6);
UPDATE town.axis SET axis_id = 102 WHERE axis_id = 101;
INSERT INTO town.axis (geom, width) SELECT test.line(i), 6 FROM generate_series(10, 11) i;
SELECT 'axes without a number go on after those with one', array_agg(axis_id ORDER BY axis_id) = '{1,2,3,4,5,6,7,100,102,103,104}' FROM town.axis;
SELECT 'their streets are there', count(DISTINCT axis_id) = 11 FROM town.section JOIN town.edge USING (edge_id);
INSERT INTO town.axis (axis_id, geom, width) VALUES (50, test.line(12), 6);
INSERT INTO town.axis (geom, width) VALUES (test.line(13), 6);
SELECT 'a lower number leaves the count where it is', max(axis_id) = 105 FROM town.axis;
SELECT 'a number that is taken is refused', test.state($$INSERT INTO town.axis (axis_id, geom, width) VALUES (7, test.line(14), 6)$$) = '23505';
INSERT INTO town.axis (axis_id, geom, width) VALUES (9223372036854775807, test.line(15), 6);
INSERT INTO town.axis (geom, width) VALUES (test.line(16), 6);
SELECT 'the greatest number of all uses up none', array_agg(axis_id ORDER BY axis_id DESC) @> '{9223372036854775807,106}' FROM town.axis;

-- The same of each table of input whose key is generated.
SELECT 'each such table has the trigger', array_agg(relname ORDER BY relname) FILTER (WHERE NOT EXISTS (SELECT FROM pg_trigger WHERE tgrelid = c.oid AND tgname = 'own_key')) IS NULL AND count(*) > 12
FROM pg_class c JOIN pg_attribute ON attrelid = c.oid AND attidentity <> '' WHERE relnamespace = 'town'::regnamespace AND relname = ANY (streetgen._edited_tables('town'));
INSERT INTO town.lane_override (lane_override_id, axis_id, abscissa, ordinality, width) SELECT i, i, 5, 1, 3 FROM generate_series(1, 2) i;
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) SELECT i, 5, 1, 3 FROM generate_series(3, 4) i;
SELECT 'overrides', array_agg(lane_override_id ORDER BY axis_id) = '{1,2,3,4}' FROM town.lane_override;
INSERT INTO town.street_object (street_object_id, type, geom) VALUES (1, 'tree', ST_SetSRID(ST_MakePoint(650050, 6860300), 2154));
INSERT INTO town.street_object (type, geom) VALUES ('tree', ST_SetSRID(ST_MakePoint(650060, 6860300), 2154));
SELECT 'objects', array_agg(street_object_id ORDER BY ST_X(geom)) = '{1,2}' FROM town.street_object;

-- An import counts no keys but those of the rows that it brings: it would set back what others count meanwhile.
CREATE TABLE test.line_of_source AS SELECT i AS id, test.line(i) AS geom FROM generate_series(17, 18) i;
SELECT FROM streetgen.import_axes('town', 'test.line_of_source', '{"source_ref": "id"}') \g /dev/null
SELECT 'axes of an import go on too', array_agg(axis_id ORDER BY axis_id) = '{107,108}' FROM town.axis WHERE source_ref IS NOT NULL;
CREATE TABLE test.count AS SELECT last_value, log_cnt, is_called FROM town.axis_axis_id_seq;
SELECT FROM streetgen.import_axes('town', 'test.line_of_source', '{"source_ref": "id"}') \g /dev/null
SELECT 'an import of known rows leaves the count alone', (SELECT (last_value, log_cnt, is_called) FROM test.count) = (SELECT (last_value, log_cnt, is_called) FROM town.axis_axis_id_seq);

-- An editor may write keys of his own, and not the sequence.
CREATE ROLE own_key_editor ROLE CURRENT_USER;
SELECT streetgen.grant('town', 'own_key_editor', 'editor') \g /dev/null
SET ROLE own_key_editor;
INSERT INTO town.axis (axis_id, geom, width) VALUES (200, ST_SetSRID('LINESTRING(660000 6860000,660100 6860000)'::geometry, 2154), 6);
INSERT INTO town.axis (geom, width) VALUES (ST_SetSRID('LINESTRING(660000 6861000,660100 6861000)'::geometry, 2154), 6);
RESET ROLE;
SELECT 'an editor too', array_agg(axis_id ORDER BY axis_id) = '{200,201}' FROM town.axis WHERE axis_id BETWEEN 200 AND 300;
DROP OWNED BY own_key_editor;
DROP ROLE own_key_editor;

-- A model of a build before: its own keys are counted when its functions are made.
ALTER TABLE town.axis DISABLE TRIGGER own_key;
INSERT INTO town.axis (axis_id, geom, width) VALUES (300, test.line(20), 6);
ALTER TABLE town.axis ENABLE TRIGGER own_key;
SELECT streetgen._make_functions('town') \g /dev/null
INSERT INTO town.axis (geom, width) VALUES (test.line(21), 6);
SELECT 'keys of before are counted', axis_id = 301 FROM town.axis WHERE ST_Equals(geom, test.line(21));
