\set ECHO none
\ir shared/truths.sql
-- Functions of the user's that a model calls: an edit by anybody calls them with the rights of its owner, so that only those of the owner are called.  (name, holds)
CREATE ROLE called_owner ROLE CURRENT_USER; CREATE ROLE called_editor ROLE CURRENT_USER; CREATE ROLE called_stranger ROLE CURRENT_USER;
DO $$ BEGIN EXECUTE format('GRANT CREATE ON DATABASE %I TO called_owner', current_database()); END $$;
GRANT CREATE ON SCHEMA public TO called_owner;
SET ROLE called_owner;
-- Theirs is not beside PostGIS, where an editor would not lend them the rights of the owner.
CREATE SCHEMA ours;
GRANT USAGE ON SCHEMA ours TO PUBLIC;
GRANT CREATE ON SCHEMA ours TO called_stranger;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{object,signal,roundabout}', driving_side => 'right'); END $$;
INSERT INTO town.axis (axis_id, geom, width, lane_count, importance) SELECT n, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7, 2, 2 FROM (VALUES (1, 'LINESTRING(-80 0,0 0)'), (2, 'LINESTRING(0 0,80 0)'),
  (3, 'LINESTRING(0 -80,0 0)'), (4, 'LINESTRING(0 0,0 80)'), (6, 'LINESTRING(80 0,95 15)'), (7, 'LINESTRING(95 15,110 0)'), (8, 'LINESTRING(110 0,95 -15)'), (9, 'LINESTRING(95 -15,80 0)')) v(n, line);
INSERT INTO town.control_point (kind, geom) VALUES ('signals', 'SRID=2154;POINT(650000 6860000)');
INSERT INTO town.object_type (type) VALUES ('shelter');
CREATE TABLE town.shelter (street_object_id bigint PRIMARY KEY, roof text);
DO $$ BEGIN PERFORM streetgen.grant('town', 'called_editor', 'editor'), streetgen.specialise('town', 'shelter', 'shelter'); END $$;
SELECT 'a plain owner has a model with objects', count(*) = 1 FROM town.controller;

-- What each place takes: a function that does what the model does without.
CREATE TABLE town.place AS SELECT * FROM (VALUES
  ('radius_function', 'width float8, speed float8, importance integer, lane_count integer, kind text', 'float8', 'SELECT 4.0::float8'),
  ('roundabout_score', 'shape float8, name float8, network float8, weights float8[]', 'float8', 'SELECT streetgen.roundabout_score(shape, name, network, weights)'),
  ('trajectory', 'lane_in geometry, lane_out geometry, centre geometry, tolerance float8', 'geometry', 'SELECT ST_MakeLine(ST_EndPoint(lane_in), ST_StartPoint(lane_out))'),
  ('classifier', 'arms streetgen.junction_arm[]', 'text', 'SELECT streetgen.junction_kind(arms)'),
  ('signal_program', 'movements streetgen.signal_request[]', 'SETOF streetgen.signal_answer', 'SELECT * FROM streetgen.signal_phases(movements)'),
  ('placement_function', 'model name, edges bigint[]', 'SETOF streetgen.placement', 'SELECT ''lamp'', 1, 20, ''left'', 1, NULL::float8 WHERE model <> ''''')) v(setting, arguments, result, body);
GRANT SELECT ON town.place TO called_stranger;
GRANT USAGE ON SCHEMA town TO called_stranger;
GRANT SELECT ON town.shelter, town.street_object TO called_stranger;
CREATE FUNCTION pg_temp.make(prefix text) RETURNS void LANGUAGE plpgsql AS $$ DECLARE p record; BEGIN
  FOR p IN SELECT * FROM town.place LOOP
    EXECUTE format('CREATE FUNCTION ours.%I(%s) RETURNS %s LANGUAGE sql IMMUTABLE AS %L', prefix || p.setting, p.arguments, p.result, p.body);
  END LOOP;
  EXECUTE format('CREATE FUNCTION ours.%I(town.shelter, town.street_object) RETURNS town.shelter LANGUAGE sql STABLE AS %L', prefix || 'shelter', 'SELECT ($1.street_object_id, current_user)::town.shelter');
END $$;
SELECT pg_temp.make('own_') \g /dev/null
SET ROLE called_stranger;
SELECT pg_temp.make('their_') \g /dev/null
SET ROLE called_owner;
CREATE FUNCTION pg_temp.set(setting text, prefix text) RETURNS text LANGUAGE sql AS $$ SELECT format('SELECT streetgen.set(''town'', %L, %L)', setting, prefix || setting) $$;

SELECT 'one of somebody else is refused: ' || setting, (r).state = '42501' AND (r).said = format('setting "%s" of model "town" cannot be ''ours.their_%1$s''', setting) AND (r).detail LIKE '%called_stranger%' AND (r).hint LIKE 'ALTER FUNCTION ours.their_%OWNER TO called_owner%'
  FROM (SELECT setting, test.refusal(pg_temp.set(setting, 'ours.their_')) AS r FROM town.place) t;
SELECT 'one that is not there: ' || setting, (r).state = '22023' AND (r).detail = 'There is no such function.' AND (r).hint LIKE '%a%function%' FROM (SELECT setting, test.refusal(pg_temp.set(setting, 'ours.no_')) AS r FROM town.place) t;
SELECT format('%s cannot be %s', setting, quote_literal(name)), test.state(format('SELECT streetgen.set(''town'', %L, %L)', setting, name)) = '22023' FROM town.place, unnest(ARRAY['', 'a.b.c.d', 'own_(', 'x(); SELECT 1 --', '"']) name;
SELECT 'one of the owner is taken: ' || setting, test.state(pg_temp.set(setting, 'ours.own_')) = 'none' FROM town.place p;
SELECT 'and kept with its schema: ' || setting, value = 'ours.own_' || setting FROM town.place JOIN town.setting ON name = setting;
SELECT 'of a table too', test.state($$SELECT streetgen.specialise('town', 'shelter', 'shelter', 'ours.own_shelter(town.shelter, town.street_object)')$$) = 'none';
SELECT 'and kept with its schema', function = 'ours.own_shelter' FROM town.specialised_type;
SELECT 'but not somebody else''s', (r).state = '42501' AND (r).said = 'the function of table "shelter" of model "town" cannot be ''ours.their_shelter''' AND (r).detail LIKE '%called_stranger%'
  FROM test.refusal($$SELECT streetgen.specialise('town', 'shelter', 'shelter', 'ours.their_shelter(town.shelter, town.street_object)')$$) r;
SELECT 'all are called', sum(updated) > 0 FROM streetgen.generate('town', wait => true);
SET ROLE called_editor;
-- Somewhat else each time.
CREATE FUNCTION pg_temp.edit() RETURNS text LANGUAGE sql AS $$ SELECT test.state(format('UPDATE town.axis SET width = %s WHERE axis_id IN (1, 7)', 7 + random())) $$;
SELECT 'an editor''s edit calls them', pg_temp.edit() = 'none';
INSERT INTO town.street_object (type, geom) VALUES ('shelter', 'SRID=2154;POINT(650040 6860010)');
SELECT 'with the rights of the owner', roof = 'called_owner' FROM town.shelter;

-- Given away since, or written by hand: refused at the call.
CREATE FUNCTION pg_temp.given_away(name text, statement text) RETURNS text LANGUAGE plpgsql AS $$ DECLARE given regprocedure := (SELECT oid FROM pg_proc WHERE proname = name); said text; BEGIN
  RESET ROLE;
  EXECUTE format('ALTER FUNCTION %s OWNER TO called_stranger', given);
  SET ROLE called_editor;
  said := (SELECT r.state || ' ' || r.said FROM test.refusal(statement) r);
  RESET ROLE;
  EXECUTE format('ALTER FUNCTION %s OWNER TO called_owner', given);
  SET ROLE called_editor;
  RETURN said;
END $$;
RESET ROLE;
SELECT 'one that was given away since: ' || setting, pg_temp.given_away('own_' || setting, format('UPDATE town.axis SET width = %s WHERE axis_id IN (1, 7)', 6 + random())) = format('42501 setting "%s" of model "town" cannot be ''ours.own_%1$s''', setting) FROM town.place;
SELECT 'that of a table too', pg_temp.given_away('own_shelter', 'UPDATE town.street_object SET angle = 5 WHERE type = ''shelter''') = '42501 the function of table "shelter" of model "town" cannot be ''ours.own_shelter''';
SET ROLE called_owner;
UPDATE town.specialised_type SET function = 'ours.their_shelter';
SET ROLE called_editor;
SELECT 'one that was written by hand', test.state('UPDATE town.street_object SET angle = 5 WHERE type = ''shelter''') = '42501';
SELECT 'an editor writes no type with a table: ' || statement, test.state(statement) = '42501' FROM unnest(ARRAY['INSERT INTO town.specialised_type VALUES (''lamp'', ''shelter'', ''own_shelter'')', 'UPDATE town.specialised_type SET function = NULL',
  'DELETE FROM town.specialised_type', 'TRUNCATE town.specialised_type', $$SELECT streetgen.specialise('town', 'lamp', 'shelter')$$]) statement;
SELECT 'nor names a program: ' || statement, test.state(statement) IN ('22023', '23514') FROM unnest(ARRAY['UPDATE town.controller_editing SET program = ''ours.their_signal_program''',
  'INSERT INTO town.controller_override (axis_id, geom, program) VALUES (1, ''SRID=2154;POINT(650000 6860000)'', ''ours.own_signal_program'')']) statement;
UPDATE town.controller_editing SET program = 'paper';
SELECT 'only what comes with the extension', program = 'paper' FROM town.controller;

-- Models of older builds let him.
SET ROLE called_owner;
ALTER TABLE town.controller_override DROP CONSTRAINT controller_override_program_check;
DO $$ BEGIN PERFORM set_config('streetgen.live', 'off', true); UPDATE town.controller_override SET program = 'ours.own_signal_program'; END $$;
GRANT INSERT, UPDATE, DELETE ON town.specialised_type TO called_editor;
GRANT UPDATE (function), INSERT (type, relation, function) ON town.specialised_type TO called_editor;
CREATE TABLE town.wind_override (axis_id bigint, wind float8);
CREATE FUNCTION public.own_shelter(town.shelter, town.street_object) RETURNS town.shelter LANGUAGE sql STABLE AS 'SELECT ($1.street_object_id, ''plain'')::town.shelter';
UPDATE town.specialised_type SET function = 'own_shelter';
DO $$ BEGIN PERFORM streetgen.adopt_model('town'); END $$;
SELECT 'an adopted model takes it back', NOT has_any_column_privilege('called_editor', 'town.specialised_type', 'INSERT, UPDATE') AND NOT has_table_privilege('called_editor', 'town.specialised_type', 'DELETE') AND has_table_privilege('called_editor', 'town.specialised_type', 'SELECT');
DO $$ BEGIN PERFORM streetgen.grant('town', 'called_editor', 'editor'); END $$;
SELECT 'a table of the owner''s that is called as overrides are stays his', NOT has_table_privilege('called_editor', 'town.wind_override', 'INSERT, UPDATE, DELETE') AND NOT EXISTS (SELECT FROM pg_trigger WHERE tgrelid = 'town.wind_override'::regclass);
CREATE FUNCTION town.measured(bigint) RETURNS bigint LANGUAGE sql SECURITY DEFINER AS 'SELECT $1';
SELECT 'a function with the rights of the owner that cannot look for those of others is refused', r.state = '22023' AND r.said = 'function town.measured(bigint) has no line at which to look for functions of others' AND r.hint <> ''
  FROM test.refusal($$SELECT streetgen._own_function('town', 'measured(bigint)', 'what is measured')$$) r;
DROP FUNCTION town.measured(bigint);
SELECT 'its controllers have the program of the model', (SELECT program IS NULL FROM town.controller_override) AND test.state($$UPDATE town.controller_override SET program = 'ours.own_signal_program'$$) = '23514';
SELECT 'and its function without a schema is called', test.state('UPDATE town.street_object SET angle = 5 WHERE type = ''shelter''') = 'none';
DO $$ BEGIN PERFORM streetgen.switch_subject('town', 'object', false), streetgen.switch_subject('town', 'object', true); END $$;
SELECT 'switching subjects gives no right on it either', NOT has_table_privilege('called_editor', 'town.specialised_type', 'INSERT, UPDATE, DELETE') AND has_table_privilege('called_editor', 'town.object_type', 'INSERT');
RESET ROLE;
DO $$ BEGIN PERFORM streetgen.drop_model('town'); END $$;
DROP OWNED BY called_owner, called_editor, called_stranger;
DROP ROLE called_owner, called_editor, called_stranger;
