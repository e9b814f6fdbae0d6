\set ECHO none
\ir shared/truths.sql
-- What input tables refuse: the row, the value, what is expected and the way out.  Each test is a row (name, holds).
SELECT streetgen.create_model('town', 2154, subjects => '{object,interconnection}'), streetgen.create_model('older', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7);
CREATE TABLE tried (statement text, wanted text, message text);
INSERT INTO tried VALUES
  ('UPDATE town.axis SET width = 201 WHERE axis_id = 2', '23514', 'the width of axis 2 cannot be 201'),
  ('UPDATE town.axis_editing SET width = 201 WHERE axis_id = 2', '23514', 'the width of axis 2 cannot be 201'),
  ('UPDATE town.axis SET width = ''NaN'' WHERE axis_id = 2', '23514', 'the width of axis 2 cannot be NaN'),
  ('UPDATE town.axis SET width = ''-Infinity'', level = 70', '23514', 'the width of axis 1 cannot be -Infinity'),
  ('UPDATE town.axis SET level = 70 WHERE axis_id = 2', '23514', 'the level of axis 2 cannot be 70'),
  ('UPDATE town.axis SET level = NULL WHERE axis_id = 2', '23502', 'the level of axis 2 cannot be NULL'),
  ('UPDATE town.axis SET direction = ''up'' WHERE axis_id = 2', '23514', 'the direction of axis 2 cannot be "up"'),
  ('UPDATE town.axis SET kind_forward = ''tram'' WHERE axis_id = 2', '23514', 'the kind_forward of axis 2 cannot be "tram"'),
  ('UPDATE town.axis SET turn_backward = ''up'' WHERE axis_id = 2', '23514', 'the turn_backward of axis 2 cannot be "up"'),
  ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING(1 1,1 1)'' WHERE axis_id = 2', '23514', 'the geom of axis 2 cannot be LINESTRING(1 1,1 1)'),
  ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING EMPTY'' WHERE axis_id = 2', '23514', 'the geom of axis 2 cannot be LINESTRING EMPTY'),
  ('INSERT INTO town.axis (axis_id, geom, speed) VALUES (9, ''SRID=2154;LINESTRING(1 1,2 2)'', -1)', '23514', 'the speed of the new axis 9 cannot be -1'),
  ('INSERT INTO town.axis (axis_id) VALUES (9)', '23502', 'the geom of the new axis 9 cannot be NULL'),
  ('INSERT INTO town.axis (axis_id, geom) VALUES (NULL, ''SRID=2154;LINESTRING(1 1,2 2)'')', '23502', 'the axis_id of the new axis cannot be NULL'),
  ('UPDATE town.axis_class SET width = 0 WHERE class = ''primary''', '23514', 'the width of axis class primary cannot be 0'),
  ('INSERT INTO town.transition_override (transition_override_id, axis_id, which) VALUES (7, 1, ''middle'')', '23514', 'the which of the new transition override 7 cannot be "middle"'),
  ('INSERT INTO town.lane_override (lane_override_id, axis_id, abscissa, ordinality, line) VALUES (7, 1, 5, 1, ''SRID=2154;LINESTRING EMPTY'')', '23514', 'the line of the new lane override 7 cannot be LINESTRING EMPTY'),
  ('INSERT INTO town.corner_override (corner_override_id, geom, axis_a, axis_b, radius) VALUES (7, ''SRID=2154;POINT(650100 6860000)'', 1, 2, 201)', '23514', 'the radius of the new corner override 7 cannot be 201'),
  ('INSERT INTO town.turn_restriction (turn_restriction_id, geom, from_axis, to_axis, kind, turn) VALUES (7, ''SRID=2154;POINT(650100 6860000)'', 1, 2, ''no'', ''up'')', '23514', 'the turn of the new turn restriction 7 cannot be "up"'),
  ('INSERT INTO town.turn_restriction (turn_restriction_id, geom, from_axis, to_axis) VALUES (7, ''SRID=2154;POINT(650100 6860000)'', 1, 2)', '23502', 'the kind of the new turn restriction 7 cannot be NULL'),
  ('INSERT INTO town.turn_restriction (turn_restriction_id, geom, from_axis, to_axis, kind) VALUES (7, ''SRID=2154;POINT EMPTY'', 1, 2, ''no'')', '23514', 'the geom of the new turn restriction 7 cannot be POINT EMPTY'),
  ('INSERT INTO town.turn_restriction (turn_restriction_id, geom, from_axis, to_axis, kind) VALUES (7, ''SRID=2154;POINT(NaN 1)'', 1, 2, ''no'')', '23514', 'the geom of the new turn restriction 7 cannot be POINT(NaN 1)'),
  ('INSERT INTO town.interconnection_override (interconnection_override_id, geom, axis_in, lane_in, axis_out, lane_out) VALUES (7, ''SRID=2154;POINT EMPTY'', 1, 2, 2, 2)', '23514', 'the geom of the new interconnection override 7 cannot be POINT EMPTY'),
  ('INSERT INTO town.interconnection_override (interconnection_override_id, geom, axis_in, lane_in, axis_out, lane_out, control) VALUES (7, ''SRID=2154;POINT(650100 6860000)'', 1, 2, 2, 2, ''SRID=2154;POINT(NaN 1)'')', '23514', 'the control of the new interconnection override 7 cannot be POINT(NaN 1)'),
  ('INSERT INTO town.interconnection_override (interconnection_override_id, geom, axis_in, lane_in, axis_out, lane_out, control) VALUES (7, ''SRID=2154;POINT(650100 6860000)'', 1, 2, 2, 2, ''SRID=2154;POINT(1e13 1)'')', '23514', 'the control of the new interconnection override 7 cannot be POINT(10000000000000 1)');
-- Rules of drawing: their key names the row.
INSERT INTO town.symbol_rule (theme, layer, kind, place, fill) VALUES ('street', 'lane', 'bus', 3, '#ff0000');
INSERT INTO tried SELECT format('INSERT INTO town.symbol_rule (theme, layer, place, from_scale, to_scale, fill, line, width, unit, dash, marker) VALUES (%s)', row), '23514', format(said, 'new symbol rule') FROM (VALUES
  ('''street'', ''section'', 1, 0, 1, ''red'', NULL, NULL, NULL, NULL, NULL', 'the fill of the %s street section 0 1 cannot be "red"'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#FFF'', 1, ''pixel'', NULL, NULL', 'the line of the %s street section 0 1 cannot be "#FFF"'),
  ('''night'', ''section'', 1, 0, 1, NULL, NULL, NULL, NULL, NULL, NULL', 'the theme of the %s night section 0 1 cannot be "night"'),
  ('''street'', ''section'', 1, 5000, 1500, NULL, NULL, NULL, NULL, NULL, NULL', 'the to_scale of the %s street section 5000 1 cannot be 1500'),
  ('''street'', ''section'', 1, -1, 1, NULL, NULL, NULL, NULL, NULL, NULL', 'the from_scale of the %s street section -1 1 cannot be -1'),
  ('''street'', ''section'', 1e7, 0, 1, NULL, NULL, NULL, NULL, NULL, NULL', 'the place of the %s street section 0 10000000 cannot be 10000000'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', 1, NULL, NULL, NULL', 'the unit of the %s street section 0 1 cannot be NULL'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', NULL, NULL, NULL, NULL', 'the width of the %s street section 0 1 cannot be NULL'),
  ('''street'', ''name'', 1, 0, 1, ''#ff0000'', NULL, NULL, NULL, NULL, NULL', 'the width of the %s street name 0 1 cannot be NULL'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', -1, ''metre'', NULL, NULL', 'the width of the %s street section 0 1 cannot be -1'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', 1, ''foot'', NULL, NULL', 'the unit of the %s street section 0 1 cannot be "foot"'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', 1, ''metre'', ''3,2'', NULL', 'the dash of the %s street section 0 1 cannot be "3,2"'),
  ('''street'', ''section'', 1, 0, 1, NULL, ''#ff0000'', 1, ''metre'', NULL, ''star''', 'the marker of the %s street section 0 1 cannot be "star"'),
  ('''street'', ''section'', 1, 0, 1, ''#ff0000'', NULL, NULL, NULL, NULL, ''shadow''', 'the marker of the %s street section 0 1 cannot be "shadow"')) v(row, said);
INSERT INTO tried VALUES ('UPDATE town.symbol_rule SET from_scale = 10, to_scale = 5', '23514', 'the to_scale of symbol rule street lane bus 10 3 cannot be 5'),
  ('UPDATE town.symbol_rule SET width = 1', '23514', 'the unit of symbol rule street lane bus 0 3 cannot be NULL'),
  ('INSERT INTO town.symbol_rule (layer, place) VALUES (''lane'', 3)', '23502', 'the theme of the new symbol rule lane 0 3 cannot be NULL');
SELECT format('%s: %s', statement, concat_ws(' ', r.state, r.said)), r.state = wanted AND r.said = message AND r.detail LIKE 'Expected %.' AND r.hint <> '' FROM tried, test.refusal(statement) r;
BEGIN;
SAVEPOINT edit;

\o /dev/null
SELECT test.refusal('UPDATE town.axis SET width = 201 WHERE axis_id = 2');
\o
ROLLBACK TO edit;
UPDATE town.axis SET width = 9 WHERE axis_id = 2;
SELECT 'the rest of the transaction stays usable', width = 9 FROM town.edge WHERE axis_id = 2;
COMMIT;

-- Words and constraints agree.
CREATE VIEW worded AS SELECT c.relname, n.attribute, n.condition, n.sqlstate, r.* FROM pg_class c CROSS JOIN streetgen._conditions(c.oid) n LEFT JOIN LATERAL streetgen._input_rule(c.oid, n.attribute, n.name) r ON true
  WHERE relnamespace = 'town'::regnamespace AND relkind = 'r' AND relname = ANY (streetgen._edited_tables('town') || '{axis_class,symbol_rule}'::name[]);
SELECT format('%s.%s says what it expects', relname, attribute), expected <> '' OR attribute = 'geom' FROM worded WHERE sqlstate = '23514' ORDER BY relname, attribute, condition;
SELECT format('%s.%s: its bounds are those of the constraint', relname, attribute), bool_and(condition ~ format('\m%s\M', replace(bound[1], '-', ''))) FROM worded, regexp_matches(expected, '\d+(?:\.\d+)?', 'g') bound
  WHERE sqlstate = '23514' AND expected ~ '^-?[0-9.]+ to [0-9]+( |$)' GROUP BY relname, attribute ORDER BY relname, attribute;
SELECT format('%s.%s says a way out', relname, attribute), bool_and(way_out ~ '\.$' AND expected !~ '\.$') FROM worded WHERE expected IS NOT NULL GROUP BY relname, attribute ORDER BY relname, attribute;
SELECT 'each constraint of one column is looked at, and each that says what it asks for', (SELECT count(*) FROM worded WHERE sqlstate = '23514')
  = (SELECT count(*) FROM pg_constraint JOIN pg_class c ON c.oid = conrelid WHERE contype = 'c' AND (cardinality(conkey) = 1 OR obj_description(pg_constraint.oid, 'pg_constraint') <> '') AND relnamespace = 'town'::regnamespace AND relname = ANY (streetgen._edited_tables('town') || '{axis_class,symbol_rule}'::name[]));

-- A model of an older build; one that lost a constraint.
DO $$
DECLARE
  t record;
BEGIN
  FOR t IN SELECT tgname, tgrelid::regclass AS input FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = 'older'::regnamespace AND tgfoid = 'streetgen._refuse_row()'::regprocedure LOOP
    EXECUTE format('DROP TRIGGER %I ON %s', t.tgname, t.input);
  END LOOP;
  CREATE TRIGGER refuse_width BEFORE INSERT OR UPDATE OF width ON older.axis FOR EACH ROW WHEN (NOT NEW.width > 0) EXECUTE FUNCTION streetgen._refuse_row();
  PERFORM streetgen.adopt_model('older');
END $$;
SELECT 'an adopted model has one trigger a table that refuses', array_agg(DISTINCT tgname::text) = '{refuse}' AND count(*) > 15 AND count(*) = count(DISTINCT tgrelid)
  FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = 'older'::regnamespace AND tgfoid = 'streetgen._refuse_row()'::regprocedure;
SELECT 'an adopted model says it too', hint <> '' FROM test.refusal('INSERT INTO older.axis (geom, width) VALUES (''SRID=2154;LINESTRING(1 1,2 2)'', 0)');
ALTER TABLE older.axis DROP CONSTRAINT axis_radius_check;
SET streetgen.live = 'off';
INSERT INTO older.axis (geom, radius) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 201);
SELECT 'a constraint that is gone refuses nothing', radius = 201 FROM older.axis;

-- Columns that somebody adds, named as they please.
ALTER TABLE older.axis ADD "Nom de la voie" text NOT NULL DEFAULT '', ADD date date CHECK (date > '2000-01-01'::date), ADD grade text CHECK (grade IN ('a', 'grade'));
SELECT 'a model with columns of others is adopted', test.state($$SELECT streetgen.adopt_model('older')$$) = 'none';
SELECT 'their constraints hold', test.state($$INSERT INTO older.axis (geom, date) VALUES ('SRID=2154;LINESTRING(1 1,2 2)', '1999-12-31')$$) = '23514';
SELECT 'and they go as they came', test.state($$ALTER TABLE older.axis DROP "Nom de la voie", DROP date, DROP grade$$) = 'none';
SELECT streetgen.drop_model('town'), streetgen.drop_model('older') \g /dev/null
