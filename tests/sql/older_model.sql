\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- A model made before lanes for both directions, sidewalks, merging lanes, double roundabouts, free places and ties of heights, and what it gets.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('older', 2154, subjects => '{interconnection,roundabout,object,height,signal}', driving_side => 'right');
  INSERT INTO older.axis (axis_id, geom, width, lane_count, importance) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7, 2, id FROM (VALUES
    (1, 'LINESTRING(-80 0,0 0,80 0)'), (2, 'LINESTRING(0 -80,0 0)')) v(id, line);
  -- A roundabout of four arms, and a lamp.
  INSERT INTO older.axis (axis_id, geom, width, lane_count) SELECT 3, ST_ExteriorRing(ST_Buffer('SRID=2154;POINT(650500 6860000)', 18, 6)), 7, 2;
  INSERT INTO older.axis (axis_id, geom, width, lane_count) SELECT 4 + a, ST_SetSRID(ST_MakeLine(ST_MakePoint(650500 + 18 * x, 6860000 + 18 * y), ST_MakePoint(650500 + 100 * x, 6860000 + 100 * y)), 2154), 6, 2
    FROM generate_series(0, 3) a, LATERAL (SELECT round(cos(radians(90 * a))::numeric)::float8, round(sin(radians(90 * a))::numeric)::float8) v(x, y);
  INSERT INTO older.street_object (type, axis_id, abscissa, axis_offset) VALUES ('lamp', 1, 40, 5);
END $$;
CREATE TABLE content AS SELECT * FROM test.content('older');
CREATE TABLE named AS SELECT interconnection_id, lane_in, lane_out FROM older.interconnection;
CREATE FUNCTION pg_temp.columns() RETURNS SETOF text LANGUAGE sql AS $$
  SELECT format('%s.%s %s %s', attrelid::regclass, attname, format_type(atttypid, atttypmod), attnotnull) FROM pg_attribute JOIN pg_class c ON c.oid = attrelid
  WHERE relnamespace = 'older'::regnamespace AND relkind = 'r' AND attnum > 0 AND NOT attisdropped
  UNION ALL SELECT pg_get_constraintdef(oid) FROM pg_constraint WHERE connamespace = 'older'::regnamespace $$;
CREATE TABLE wanted AS SELECT pg_temp.columns() AS column;
CREATE FUNCTION pg_temp.words() RETURNS SETOF text LANGUAGE sql AS $$
  SELECT pg_get_indexdef(indexrelid) FROM pg_index JOIN pg_class c ON c.oid = indrelid WHERE relnamespace = 'older'::regnamespace
  UNION ALL SELECT format('%s.%s %s', attrelid::regclass, attname, col_description(attrelid, attnum)) FROM pg_attribute JOIN pg_class c ON c.oid = attrelid
  WHERE relnamespace = 'older'::regnamespace AND relkind = 'r' AND attnum > 0 AND NOT attisdropped
  UNION ALL SELECT format('%s %s %s', conrelid::regclass, pg_get_constraintdef(oid), obj_description(oid)) FROM pg_constraint WHERE connamespace = 'older'::regnamespace
  UNION ALL SELECT format('%s %s', oid::regclass, obj_description(oid)) FROM pg_class WHERE relnamespace = 'older'::regnamespace AND relkind = 'r' $$;
CREATE TABLE worded AS SELECT pg_temp.words() AS words;
ALTER TABLE older.axis DROP access CASCADE, DROP parking_left CASCADE, DROP parking_right CASCADE, DROP lane_markings CASCADE, DROP sidewalk_apart CASCADE, DROP paved CASCADE, DROP height_limit CASCADE, DROP strips_left CASCADE, DROP strips_right CASCADE, DROP sidewalk_paved_left CASCADE, DROP sidewalk_paved_right CASCADE, DROP cycle_paved_left CASCADE, DROP cycle_paved_right CASCADE, DROP lanes_both CASCADE, DROP ref CASCADE, DROP roadway_offset CASCADE, DROP change_forward CASCADE, DROP change_backward CASCADE, DROP sidewalk_left CASCADE, DROP sidewalk_right CASCADE, DROP flow CASCADE;
ALTER TABLE older.axis_class DROP highway_role CASCADE, DROP walked_along CASCADE, DROP crossed_on_foot CASCADE, DROP lanes_by_width CASCADE,
  DROP lanes_one_way CASCADE, DROP width_one_way CASCADE, DROP lanes_each_way CASCADE, DROP parking_left CASCADE, DROP parking_right CASCADE;
DELETE FROM older.axis_class WHERE class = 'busway' OR use = 'rail';
DELETE FROM older.object_type WHERE type IN ('tram_stop', 'platform');
ALTER TABLE older.turn_restriction DROP except_kinds CASCADE;
ALTER TABLE older.lane_override DROP both_ways CASCADE;
ALTER TABLE older.interconnection_override DROP along_in CASCADE, DROP along_out CASCADE;
ALTER TABLE older.edge DROP lanes_both CASCADE, DROP roadway_offset CASCADE, DROP sidewalk_left CASCADE, DROP sidewalk_right CASCADE, DROP curve CASCADE, DROP beside_left CASCADE, DROP beside_right CASCADE;
ALTER TABLE older.lane DROP both_ways CASCADE, DROP borders CASCADE;
ALTER TABLE older.marking DROP free_surface CASCADE;
DROP TABLE older.object_distance CASCADE;
ALTER TABLE older.marking DROP along_axis CASCADE, ADD UNIQUE (edge_id, kind, lane_position);
ALTER TABLE older.axis_route DROP piece CASCADE, DROP uncut CASCADE, ADD UNIQUE (source, route, ordinality);
DROP INDEX older.axis_route_place;
ALTER TABLE older.interconnection DROP traffic CASCADE, DROP along_in CASCADE, DROP along_out CASCADE, ADD UNIQUE (lane_in, lane_out);
ALTER TABLE older.lane DROP start_abscissa CASCADE, DROP end_abscissa CASCADE, DROP CONSTRAINT lane_kind_check, ADD CHECK (kind IN ('general', 'bus', 'cycle', 'parking'));
ALTER TABLE older.lane_separator DROP leftwards CASCADE, DROP rightwards CASCADE;
ALTER TABLE older.roundabout_edge DROP face CASCADE;
ALTER TABLE older.profile DROP tied_from CASCADE, DROP tied_to CASCADE;
ALTER TABLE older.turn_restriction DROP via_axes CASCADE, DROP via_geom CASCADE, DROP to_geom CASCADE;
ALTER TABLE older.street_object DROP control_point_id CASCADE;
ALTER TABLE older.control_point DROP marking CASCADE, DROP kerb CASCADE, DROP refuge CASCADE;
-- Of the columns that one statement adds the first may be there: they came one by one.
ALTER TABLE older.pedestrian_crossing DROP painted_as CASCADE, DROP footway_id CASCADE, DROP kerb CASCADE, DROP
    refuge CASCADE, DROP island CASCADE;
ALTER TABLE older.object_edge ADD FOREIGN KEY (street_object_id) REFERENCES older.street_object ON DELETE CASCADE, ADD FOREIGN KEY (edge_id) REFERENCES older.edge ON DELETE CASCADE;
ALTER TABLE older.lane_override DROP line CASCADE, DROP geom CASCADE;
ALTER TABLE older.transition_override DROP geom CASCADE;
ALTER TABLE older.section DROP borders CASCADE;
DROP TABLE older.free_place CASCADE;
-- Computed tables that came to a subject later.
DROP TABLE older.intergreen, older.signal_group CASCADE;
DROP INDEX older.edge_axis, older.lane_override_axis;
DO $$ DECLARE said text; BEGIN
  FOR said IN SELECT format('COMMENT ON COLUMN %s.%I IS NULL', attrelid::regclass, attname) FROM pg_attribute JOIN pg_class c ON c.oid = attrelid WHERE relnamespace = 'older'::regnamespace AND relkind = 'r' AND attnum > 0 AND NOT attisdropped
    UNION ALL SELECT format('COMMENT ON CONSTRAINT %I ON %s IS NULL', conname, conrelid::regclass) FROM pg_constraint WHERE connamespace = 'older'::regnamespace
    UNION ALL SELECT format('COMMENT ON TABLE %s IS NULL', oid::regclass) FROM pg_class WHERE relnamespace = 'older'::regnamespace AND relkind = 'r' LOOP
    EXECUTE said;
  END LOOP;
END $$;
-- Rules of drawing had no name for what holds for several columns, and less held.
ALTER TABLE older.symbol_rule DROP CONSTRAINT symbol_rule_scales, DROP CONSTRAINT symbol_rule_name_has_size, DROP CONSTRAINT symbol_rule_width_has_unit, DROP CONSTRAINT symbol_rule_line_has_width,
  DROP CONSTRAINT symbol_rule_shadow_has_width, ADD CHECK (from_scale < to_scale), ADD CHECK (layer <> 'name' OR width IS NOT NULL), ADD CHECK (num_nulls(width, unit) IN (0, 2)), ADD CONSTRAINT mine CHECK (place <> 7 OR fill IS NULL);
INSERT INTO older.symbol_rule (theme, layer, place, line) VALUES ('street', 'ref', 500, '#112233');
DELETE FROM older.setting WHERE name IN ('delivery_wins', 'object_snap', 'track_width');
UPDATE older.setting SET maximum = 1e9 WHERE name = 'reach';
SELECT 'a rule that cannot be stops it, and is told', state = '23514' AND said = 'a rule of older.symbol_rule cannot be what it is' AND hint LIKE 'Change or delete it in older.symbol_rule%' FROM test.refusal($$SELECT streetgen.adopt_model('older')$$);
DELETE FROM older.symbol_rule;
DO $$ BEGIN PERFORM streetgen.adopt_model('older'); END $$;
SELECT 'a rule of several columns is refused with the way out', state = '23514' AND said ~ 'symbol rule' AND hint = 'Fill width and unit.' FROM test.refusal($$INSERT INTO older.symbol_rule (theme, layer, place, line) VALUES ('street', 'ref', 500, '#112233')$$);
SELECT 'a condition of the user stays', test.state($$INSERT INTO older.symbol_rule (theme, layer, place, fill) VALUES ('street', 'ground', 7, '#112233')$$) = '23514';
ALTER TABLE older.symbol_rule DROP CONSTRAINT mine;
SELECT 'it gets the settings that came later, and their ranges', NOT EXISTS (SELECT name, unit, description, minimum, maximum, choice FROM streetgen._default_setting() EXCEPT SELECT name, unit, description, minimum, maximum, choice FROM older.setting);
SELECT 'it gets the classes of tracks, and the types of their stops', (SELECT count(*) = 3 FROM older.axis_class
    WHERE use = 'rail' AND taken) AND (SELECT count(*) = 2 FROM older.object_type WHERE type IN ('tram_stop',
    'platform'));
SELECT 'an older model gets the columns and keys of a new one' AS name, NOT EXISTS ((SELECT pg_temp.columns() EXCEPT TABLE wanted) UNION ALL (TABLE wanted EXCEPT SELECT pg_temp.columns())) AS holds;
SELECT 'and the indexes and comments of a new one', count(*) > 500 AND NOT EXISTS ((SELECT pg_temp.words() EXCEPT TABLE worded) UNION ALL (TABLE worded EXCEPT SELECT pg_temp.words())) FROM worded;
CREATE FUNCTION pg_temp.meanings(classes jsonb) RETURNS SETOF jsonb LANGUAGE sql AS $$ SELECT c - '{lanes_one_way,lanes_one_way_by,width_one_way,lanes_each_way,parking_left,parking_right}'::text[] FROM jsonb_array_elements(classes) c $$;
SELECT 'its classes are those of a new model, with their meanings', (SELECT jsonb_agg(c ORDER BY c) FROM (SELECT pg_temp.meanings(jsonb_agg(to_jsonb(a))) AS c FROM older.axis_class a) o) = (SELECT jsonb_agg(c ORDER BY c) FROM (SELECT pg_temp.meanings(jsonb_agg(to_jsonb(d))) AS c FROM streetgen._default_axis_class() d) o);
SELECT 'but its one-way streets have the lanes that they had', bool_and(num_nonnulls(lanes_one_way, width_one_way, lanes_each_way) = 0) FROM older.axis_class WHERE class <> 'busway';
DELETE FROM older.axis_class WHERE class = 'busway';
DO $$ BEGIN PERFORM streetgen.adopt_model('older'); END $$;
SELECT 'one that was deleted since stays away', NOT EXISTS (SELECT FROM older.axis_class WHERE class = 'busway');
SELECT 'its rows say what they said', NOT EXISTS ((SELECT * FROM test.content('older') EXCEPT TABLE content) UNION ALL (TABLE content EXCEPT SELECT * FROM test.content('older')));
SELECT 'and keep their keys over a run', (SELECT bool_and(inserted + deleted = 0 AND (relation = 'edge' OR updated = 0)) FROM streetgen.generate('older')) AND (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('older')) AND NOT EXISTS (TABLE named EXCEPT SELECT interconnection_id, lane_in, lane_out FROM older.interconnection);
UPDATE older.axis SET lane_count = 1 WHERE axis_id = 2;
SELECT 'and it takes lanes for both directions', (SELECT count(*) = 1 FROM older.lane WHERE both_ways) AND NOT EXISTS (SELECT FROM streetgen.check_model('older') WHERE severity = 'error');
DELETE FROM older.street_object;
INSERT INTO older.placement_rule (type, along) VALUES ('tree', 'border');
SELECT 'and objects of rules', (SELECT count(*) > 0 FROM older.street_object WHERE placed_by = 'rule');
DELETE FROM older.street_object WHERE street_object_id = (SELECT min(street_object_id) FROM older.street_object);
SELECT 'and places that rules leave free', (SELECT count(*) = 1 FROM older.free_place) AND NOT EXISTS (SELECT FROM streetgen.check_model('older') WHERE severity = 'error');
DO $$ BEGIN PERFORM streetgen.switch_subject('older', 'ramp', true); END $$;
SELECT 'and ramps', to_regclass('older.ramp') IS NOT NULL;
-- Whoever adopts a model of another one lends him no right: what the owner hung on his tables runs as the owner.
CREATE ROLE adopted_owner ROLE CURRENT_USER; CREATE SCHEMA adopted_place; GRANT USAGE, CREATE ON SCHEMA adopted_place TO adopted_owner;
SELECT test.as_administrator(format('GRANT CREATE ON DATABASE %I TO adopted_owner', current_database())) \g /dev/null
SET ROLE adopted_owner;
SELECT streetgen.create_model('adopted', 2154, subjects => '{object}') \g /dev/null
CREATE TABLE adopted_place.seen (who text);
CREATE FUNCTION adopted_place.look() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN INSERT INTO adopted_place.seen VALUES (current_user); RETURN NEW; END $$;
CREATE TRIGGER look BEFORE INSERT OR UPDATE ON adopted.object_type FOR EACH ROW EXECUTE FUNCTION adopted_place.look();
DROP TABLE adopted.parking_bay CASCADE;
DELETE FROM adopted.object_type WHERE type = 'parking_bay';
RESET ROLE;
SELECT streetgen.adopt_model('adopted') \g /dev/null
SELECT 'a trigger of the owner runs as the owner while another role adopts his model', count(*) > 0 AND bool_and(who = 'adopted_owner') FROM adopted_place.seen;
SELECT 'and the model is whole', to_regclass('adopted.parking_bay') IS NOT NULL AND (SELECT bool_and(relowner = 'adopted_owner'::regrole) FROM pg_class WHERE relnamespace = 'adopted'::regnamespace);
SET ROLE adopted_owner;
CREATE FUNCTION adopted_place.rise() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN PERFORM set_config('role', 'none', true); INSERT INTO adopted_place.seen VALUES (current_user); RETURN NEW; END $$;
CREATE TRIGGER rise BEFORE INSERT OR UPDATE ON adopted.setting FOR EACH ROW EXECUTE FUNCTION adopted_place.rise();
ALTER TABLE adopted.setting DISABLE TRIGGER rise;
DELETE FROM adopted.setting WHERE name = 'object_snap';
ALTER TABLE adopted.setting ENABLE TRIGGER rise;
RESET ROLE;
SELECT 'nor can it take the role of who adopts', state = '42501' AND said ~ 'cannot set parameter "role"' FROM test.refusal($$SELECT streetgen.adopt_model('adopted')$$);
SELECT 'and it ran with no other right', bool_and(who = 'adopted_owner') FROM adopted_place.seen;
ALTER TABLE adopted.setting DISABLE TRIGGER rise;
CREATE FUNCTION adopted_place.adopt() RETURNS void LANGUAGE sql SECURITY DEFINER AS $$ SELECT streetgen.adopt_model('adopted') $$;
ALTER FUNCTION adopted_place.adopt() OWNER TO adopted_owner;
SELECT 'a function with rights of its owner adopts his model', test.state('SELECT adopted_place.adopt()') = 'none';
SELECT 'and the setting is there again', EXISTS (SELECT FROM adopted.setting WHERE name = 'object_snap');
CREATE ROLE adopted_stranger ROLE CURRENT_USER;
SET ROLE adopted_stranger;
SELECT 'whoever is no member of the role calls nothing with it', state = '42501' AND hint <> '' FROM test.refusal($$SELECT streetgen._as_owner('adopted', 'drop_model')$$);
RESET ROLE;
DROP ROLE adopted_stranger;
-- A table of somebody else, which the model follows.
CREATE TABLE public.adopted_line AS SELECT 1 AS id, 'SRID=2154;LINESTRING(650000 6860000, 650080 6860000)'::geometry AS geom;
GRANT SELECT, TRIGGER, INSERT ON public.adopted_line TO adopted_owner;
SET ROLE adopted_owner;
SELECT count(*) FROM streetgen.follow('adopted', 'adopted_line', '{"source_ref": "id"}') \g /dev/null
SELECT 'a model that follows a table of somebody else is adopted', state = 'none' FROM test.refusal($$SELECT streetgen.adopt_model('adopted')$$);
INSERT INTO public.adopted_line VALUES (2, 'SRID=2154;LINESTRING(650080 6860000, 650080 6860080)');
SELECT 'and follows it once', (SELECT count(*) = 2 FROM adopted.axis) AND (SELECT count(*) = 4 FROM pg_trigger WHERE tgrelid = 'adopted_line'::regclass);
-- What stands by the name of a view or table that came later.
DROP VIEW adopted.activity;
CREATE VIEW adopted.activity AS SELECT 1 AS mine;
SELECT 'a view by the name of another of the model is told, with the way out', state = '42809' AND said = 'adopted.activity stands where a view of the model belongs' AND hint ~ 'ALTER TABLE adopted.activity RENAME TO' FROM test.refusal($$SELECT streetgen.adopt_model('adopted')$$);
DROP VIEW adopted.activity;
CREATE TABLE adopted.activity (mine integer);
SELECT 'and so is a table', state = '42809' AND said = 'adopted.activity stands where a view of the model belongs' FROM test.refusal($$SELECT streetgen.adopt_model('adopted')$$);
ALTER TABLE adopted.activity RENAME TO my_activity;
DROP TABLE adopted.check_result;
CREATE TABLE adopted.check_result (mine integer);
SELECT 'a table of the user by the name of one of the model is told', state = '42809' AND said = 'adopted.check_result stands where a table of the model belongs' AND hint ~ 'ALTER TABLE adopted.check_result RENAME TO' FROM test.refusal($$SELECT streetgen.adopt_model('adopted')$$);
ALTER TABLE adopted.check_result RENAME TO my_check;
SELECT 'renamed, all stay', test.state($$SELECT streetgen.adopt_model('adopted')$$) = 'none' AND to_regclass('adopted.my_check') IS NOT NULL AND to_regclass('adopted.my_activity') IS NOT NULL;
RESET ROLE;
DROP TABLE public.adopted_line;
SELECT streetgen.drop_model('adopted') \g /dev/null
SELECT test.as_administrator(format('REVOKE CREATE ON DATABASE %I FROM adopted_owner', current_database())) \g /dev/null
DROP OWNED BY adopted_owner CASCADE;
DROP ROLE adopted_owner;
