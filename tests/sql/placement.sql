\set ECHO none
\ir shared/truths.sql
-- Rules of placement: corners, turns, and a rule of one's own.  (name, holds)
SET client_min_messages = warning;
SELECT streetgen.create_model('town', 2154, subjects => '{object}') \g /dev/null
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
INSERT INTO town.axis (geom, width, radius, direction, lane_count, turn_forward) VALUES (pg_temp.line('LINESTRING(0 0, 100 0)'), 8, 6, 'both', 3, 'left|through'), (pg_temp.line('LINESTRING(100 0, 100 80)'), 8, 6, 'both', 2, NULL),
  (pg_temp.line('LINESTRING(100 0, 180 0)'), 8, 6, 'both', 2, NULL);

INSERT INTO town.placement_rule (type, along, every, axis_offset) VALUES ('bollard', 'corner', 1.5, 0.5);
SELECT 'bollards stand half a metre behind the arc of a corner', count(*) > 8 AND bool_and((SELECT min(abs(ST_Distance(o.geom, c.arc) - 0.5)) FROM town.corner c WHERE c.radius > 0) < 1e-3) FROM town.street_object o;
SELECT 'off the roadway', NOT EXISTS (SELECT FROM town.street_object o JOIN town.roadway r ON ST_Intersects(o.geom, r.surface));
SELECT 'a metre and a half apart', min(d) > 1.2 FROM (SELECT (SELECT min(ST_Distance(a.geom, b.geom)) FROM town.street_object b WHERE b.street_object_id <> a.street_object_id) AS d FROM town.street_object a) x;
SELECT 'a second run changes nothing', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true);
UPDATE town.axis SET radius = 9;
SELECT 'they follow the corner', bool_and((SELECT min(abs(ST_Distance(o.geom, c.arc) - 0.5)) FROM town.corner c WHERE c.radius > 0) < 1e-3) FROM town.street_object o;
DELETE FROM town.placement_rule;

INSERT INTO town.placement_rule (type, along, side, turn, axis_offset) VALUES ('sign', 'arm', 'right', 'left', 1);
SELECT 'a sign where a lane turns left', array_agg(axis_id) = '{1}' FROM town.street_object;
UPDATE town.placement_rule SET turn = 'right';
SELECT 'none where none turns right', NOT EXISTS (SELECT FROM town.street_object);
SELECT 'a turn of other letters is refused', test.state($$UPDATE town.placement_rule SET turn = 'left|'$$) = '23514';
DELETE FROM town.placement_rule;

-- A rule of one's own: a kiosk in the middle of each edge over 90 m.
CREATE FUNCTION public.kiosks(model name, edges bigint[]) RETURNS SETOF streetgen.placement LANGUAGE sql STABLE AS $$
  SELECT 'kiosk', axis_id, (start_abscissa + end_abscissa) / 2, 'left', 2.0::float8, 0.0::float8 FROM town.edge WHERE edge_id = ANY (edges) AND end_abscissa - start_abscissa > 90 $$;
SELECT streetgen.set('town', 'placement_function', 'public.kiosks') \g /dev/null
SELECT sum(inserted) IS NULL FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'it places by its own rule', array_agg((type, axis_id, abscissa, placed_by, rule_id)::text) = '{"(kiosk,1,50,rule,0)"}' FROM town.street_object;
CREATE TABLE kept AS SELECT street_object_id FROM town.street_object;
UPDATE town.axis SET width = 10;
SELECT 'what it places follows, and keeps its key', (SELECT ST_Y(geom) = 6860007 FROM town.street_object JOIN kept USING (street_object_id));
INSERT INTO town.axis (geom, width) VALUES (pg_temp.line('LINESTRING(0 200, 95 200)'), 6);
SELECT 'also along what is drawn later', array_agg(axis_id ORDER BY axis_id) = '{1,4}' FROM town.street_object;
UPDATE town.street_object_editing SET geom = ST_Translate(geom, 7, 0) WHERE axis_id = 4;
SELECT 'what is dragged is the user''s, and its place stays free', count(*) = 2 AND count(*) FILTER (WHERE placed_by = 'user') = 1 FROM town.street_object;
SELECT 'a second run changes nothing of it', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true);
CREATE FUNCTION public.off_axis(model name, edges bigint[]) RETURNS SETOF streetgen.placement LANGUAGE sql STABLE AS $$ SELECT 'kiosk', 1::bigint, 1e6::float8, 'left', 2.0::float8, NULL::float8 $$;
SELECT streetgen.live('town', false) \g /dev/null
SELECT streetgen.set('town', 'placement_function', 'public.off_axis') \g /dev/null
SELECT 'a place off its axis is refused', test.state($$SELECT streetgen.generate('town')$$) = '22023';
SELECT 'refused: ' || said, test.state(format($$SELECT streetgen.set('town', 'placement_function', %L)$$, said)) = '22023' FROM unnest('{nowhere.function,lower,"x y(",""}'::text[]) said;
SELECT streetgen.set('town', 'placement_function', 'none') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
SELECT 'without it what it placed goes, and the user''s stays', array_agg(placed_by) = '{user}' FROM town.street_object;
