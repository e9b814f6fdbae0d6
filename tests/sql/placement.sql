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

-- What a user takes away stays away; what a user changes is the user's.
SELECT streetgen.create_model('row', 2154, subjects => '{object}') \g /dev/null
INSERT INTO row.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 8), (2, pg_temp.line('LINESTRING(100 0, 200 0)'), 8), (3, pg_temp.line('LINESTRING(100 0, 100 80)'), 6);
INSERT INTO row.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (1, 'tree', 'left', 10, 1, 2);
CREATE FUNCTION pg_temp.trees() RETURNS integer[] LANGUAGE sql AS $$ SELECT array_agg(round(ST_X(geom) - 650000)::integer ORDER BY ST_X(geom)) FROM row.street_object WHERE type = 'tree' AND placed_by = 'rule' AND abs(ST_Y(geom) - 6860005) < 1e-6 $$;
SELECT 'a row of trees', pg_temp.trees() @> '{10,20,30,40,50,60,70,80,120,130,140,150,160,170,180,190}';
DELETE FROM row.street_object_editing WHERE abs(ST_X(geom) - 650030) < 1 OR abs(ST_X(geom) - 650150) < 1;
SELECT 'a tree that was deleted stays away', pg_temp.trees() @> '{20,40,140,160}' AND NOT pg_temp.trees() && '{30,150}';
SELECT sum(inserted) FROM streetgen.generate('row', wait => true) \g /dev/null
SELECT 'after a run too', NOT pg_temp.trees() && '{30,150}';
UPDATE row.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
UPDATE row.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
UPDATE row.axis SET geom = pg_temp.line('LINESTRING(100 0, 140 0)') WHERE axis_id = 2;
INSERT INTO row.axis (axis_id, geom, width) VALUES (4, pg_temp.line('LINESTRING(140 0, 200 0)'), 8);
SELECT 'also where the axis is turned round, or split', pg_temp.trees() @> '{20,40,160}' AND NOT pg_temp.trees() && '{30,150}';
DELETE FROM row.free_place WHERE abs(ST_X(geom) - 650030) < 1;
SELECT 'taken back, it comes back', pg_temp.trees() @> '{30}' AND NOT pg_temp.trees() && '{150}';
UPDATE row.street_object SET abscissa = abscissa + 4 WHERE placed_by = 'rule' AND (abs(ST_X(geom) - 650050) < 1 OR abs(ST_X(geom) - 650190) < 1);
SELECT 'a tree that was moved in the table is the user''s, and its place stays free', count(*) = 2 AND NOT pg_temp.trees() && '{50,190}' FROM row.street_object WHERE placed_by = 'user' AND rule_id IS NULL;
UPDATE row.axis SET geom = pg_temp.line('LINESTRING(100 0, 200 0)') WHERE axis_id = 2;
DELETE FROM row.axis WHERE axis_id = 4;
UPDATE row.axis SET geom = pg_temp.line('LINESTRING(0 0, 100 0, 200 0)') WHERE axis_id = 1;
DELETE FROM row.axis WHERE axis_id = 2;
SELECT 'two of one number come onto one axis', count(*) = 2 AND bool_and(axis_id = 1) AND NOT pg_temp.trees() && '{50,150,190}' FROM row.street_object WHERE placed_by = 'user';
UPDATE row.placement_rule SET phase = 1;
SELECT 'a rule with other places leaves the same ground free', pg_temp.trees() @> '{21,41,161}' AND NOT pg_temp.trees() && '{51,151,191}';
SELECT 'a second run changes nothing of them', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('row', wait => true);
SELECT 'nor is there an error of check_model', count(*) = 0 FROM streetgen.check_model('row') WHERE severity = 'error';
DELETE FROM row.placement_rule;
SELECT 'free places go with their rule', NOT EXISTS (SELECT FROM row.free_place);

INSERT INTO row.placement_rule (rule_id, type, along, side, distance_from_limit) VALUES (2, 'crossing', 'arm', 'alternating', 2.5);
INSERT INTO row.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (3, 'parking_bay', 'left', 6, 0, 2);
CREATE TABLE crossings AS SELECT street_object_id, axis_id FROM row.pedestrian_crossing JOIN row.street_object USING (street_object_id);
UPDATE row.pedestrian_crossing_editing SET width = 6 WHERE axis_id = 3;
SELECT 'a crossing that was widened is the user''s', (SELECT placed_by = 'user' AND width = 6 FROM row.street_object JOIN row.pedestrian_crossing USING (street_object_id) WHERE axis_id = 3) AND (SELECT count(*) = 3 FROM row.pedestrian_crossing);
SELECT 'and rules of bays look at it at once', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('row', wait => true);
DELETE FROM row.pedestrian_crossing WHERE street_object_id = (SELECT max(street_object_id) FROM row.street_object WHERE placed_by = 'rule' AND type = 'crossing');
SELECT 'a crossing of a rule that was deleted by its own table stays away', count(*) = 2 FROM row.pedestrian_crossing;
SELECT 'and bays look at that too', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('row', wait => true);

-- What a user takes by name, what is named anew, and what is emptied.
SELECT streetgen.create_model('own', 2154, subjects => '{object}') \g /dev/null
INSERT INTO own.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 8);
INSERT INTO own.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (1, 'tree', 'left', 10, 1, 5), (2, 'lamp', 'right', 30, 1, 5);
CREATE FUNCTION pg_temp.stand(text) RETURNS integer[] LANGUAGE sql AS $$ SELECT array_agg(abscissa::integer ORDER BY abscissa) FROM own.street_object WHERE placed_by = $1 AND type IN ('tree', 'plane') $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE sql AS $$ SELECT sum(inserted + updated + deleted) = 0 AND NOT EXISTS (SELECT FROM streetgen.check_model('own') WHERE severity = 'error') FROM streetgen.generate('own', wait => true) $$;
UPDATE own.street_object SET placed_by = 'user' WHERE type = 'tree' AND abscissa = 20;
SELECT 'a tree that a user takes is of no rule, and its place stays free', pg_temp.stand('user') = '{20}' AND pg_temp.stand('rule') = '{10,30,40,50,60,70,80,90}' AND (SELECT rule_id IS NULL AND rule_place IS NULL FROM own.street_object WHERE placed_by = 'user') AND pg_temp.still();
UPDATE own.street_object SET placed_by = 'import', source = 'survey', source_ref = '1' WHERE type = 'tree' AND abscissa = 30;
SELECT 'also for an import', pg_temp.stand('import') = '{30}' AND NOT pg_temp.stand('rule') && '{20,30}' AND pg_temp.still();
INSERT INTO own.street_object (type, axis_id, abscissa, side, placement, placed_by, rule_id, rule_place) SELECT type, axis_id, 97, side, placement, 'user', rule_id, rule_place + 1000 FROM own.street_object WHERE type = 'tree' AND abscissa = 90;
SELECT 'no new object of a user is of a rule', (SELECT rule_id IS NULL FROM own.street_object WHERE abscissa = 97) AND pg_temp.still();
-- As an earlier version let it: the user's, moved, and still with its rule.
ALTER TABLE own.street_object DISABLE TRIGGER USER;
UPDATE own.street_object SET placed_by = 'user', abscissa = 44 WHERE type = 'tree' AND abscissa = 40;
ALTER TABLE own.street_object ENABLE TRIGGER USER;
UPDATE own.axis SET width = 9;
SELECT 'one that kept its rule loses the rule, and the place stays free', pg_temp.stand('user') = '{20,44,97}' AND pg_temp.stand('rule') = '{10,50,60,70,80,90}' AND NOT EXISTS (SELECT FROM own.street_object WHERE placed_by <> 'rule' AND rule_id IS NOT NULL) AND pg_temp.still();
CREATE TABLE own_before AS SELECT street_object_id, geom, placed_by, (SELECT count(*) FROM own.free_place) AS places FROM own.street_object WHERE type = 'tree';
UPDATE own.object_type SET type = 'plane' WHERE type = 'tree';
SELECT 'objects of a type that is renamed stay the rule''s, with their keys', count(*) = 10 AND bool_and(o.type = 'plane' AND o.placed_by = b.placed_by AND o.geom::bytea = b.geom::bytea) AND bool_and(places = (SELECT count(*) FROM own.free_place)) AND pg_temp.still() FROM own_before b JOIN own.street_object o USING (street_object_id);
SELECT 'and the rule places the new name', (SELECT type = 'plane' FROM own.placement_rule WHERE rule_id = 1) AND (SELECT count(*) = 10 FROM own.street_object WHERE type = 'plane');
UPDATE own.street_object SET type = 'bollard' WHERE type = 'plane' AND abscissa = 90;
SELECT 'one that gets another type is the user''s', NOT pg_temp.stand('rule') && '{90}' AND pg_temp.still();
UPDATE own.free_place SET geom = ST_Translate(geom, -30, 0) WHERE abs(ST_X(geom) - 650090) < 1e-6;
SELECT 'a free place that is moved frees one place and takes another', pg_temp.stand('rule') = '{10,50,70,80,90}' AND pg_temp.still();
TRUNCATE own.free_place;
SELECT 'where no place is free any more, rules place objects at once, but on none of the same kind', pg_temp.stand('rule') = '{10,40,50,60,70,80,90}' AND pg_temp.still();
DELETE FROM own.street_object WHERE placed_by <> 'rule' AND abscissa IN (20, 30);
SELECT 'and where that is gone, too', pg_temp.stand('rule') = '{10,20,30,40,50,60,70,80,90}' AND pg_temp.still();
TRUNCATE own.street_object CASCADE;
SELECT 'objects of rules that were emptied stay away, as deleted ones', NOT EXISTS (SELECT FROM own.street_object) AND pg_temp.still();
SELECT 'and stand at no edge', NOT EXISTS (SELECT FROM own.object_edge);
TRUNCATE own.free_place;
SELECT 'taken back, they come back', pg_temp.stand('rule') = '{10,20,30,40,50,60,70,80,90}' AND pg_temp.still();
SET streetgen.computes = 'on';
INSERT INTO own.object_edge VALUES (1000000, (SELECT min(edge_id) FROM own.edge));
RESET streetgen.computes;
SELECT 'check_model tells of a row of object_edge without its object', array_agg(id) = '{1000000}' FROM streetgen.check_model('own') WHERE severity = 'error' AND rule = 'row of object_edge whose object or edge is gone';

-- Two junctions near each other.
SELECT streetgen.create_model('near', 2154, subjects => '{object}') \g /dev/null
INSERT INTO near.axis (axis_id, geom, width, radius) VALUES (1, pg_temp.line('LINESTRING(0 0, 60 0)'), 6, 2), (2, pg_temp.line('LINESTRING(60 0, 74 0)'), 6, 2), (3, pg_temp.line('LINESTRING(74 0, 130 0)'), 6, 2), (4, pg_temp.line('LINESTRING(60 0, 60 80)'), 6, 2), (5, pg_temp.line('LINESTRING(74 0, 74 80)'), 6, 2);
INSERT INTO near.placement_rule (type, along, side, distance_from_limit) VALUES ('crossing', 'arm', 'alternating', 2.5);
SELECT 'a crossing on each arm, and one in the middle of a street that has no room for two', count(*) = 5 AND count(*) FILTER (WHERE axis_id = 2 AND abs(abscissa - 7) < 1e-6) = 1 FROM near.street_object;
CREATE TABLE placed AS SELECT street_object_id, axis_id, geom FROM near.street_object;
UPDATE near.placement_rule SET side = 'both';
SELECT 'whatever side the rule names', count(*) = 5 AND bool_and(ST_DWithin(o.geom, p.geom, 0)) FROM near.street_object o FULL JOIN placed p USING (street_object_id);
DELETE FROM near.placement_rule;
INSERT INTO near.placement_rule (type, along, side, axis_offset, distance_from_limit) VALUES ('sign', 'arm', 'right', 1, 2.5);
SELECT 'signs there stand on either side', array_agg(side ORDER BY side) = '{left,right}' FROM near.street_object WHERE axis_id = 2 AND type = 'sign';

-- Crossings in bends that turn back: a result, whatever the line.
SELECT streetgen.create_model('bent', 2154, subjects => '{object}') \g /dev/null
INSERT INTO bent.axis (axis_id, geom, width) SELECT n, pg_temp.line(format('LINESTRING(%s 0, %s 0.3, %s 3, %s %s, %s 30)', 200 * n, 200 * n + 30, 200 * n + 31, 200 * n + 29, 1 + n % 5, 200 * n + 10 * (n % 4))), 4 + n FROM generate_series(1, 12) n;
INSERT INTO bent.pedestrian_crossing_editing (axis_id, abscissa, width, angle) SELECT axis_id, share * ST_Length(geom), 2 + 3 * share, 45 + 90 * share FROM bent.axis, unnest(ARRAY[0, 0.2, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 1]) share;
SELECT 'each has sound ground and stripes, or none', count(*) = 108 AND count(surface) > 50 AND bool_and(coalesce(ST_IsValid(surface), true)) AND bool_and(coalesce(ST_IsValid(stripes), true)) FROM bent.pedestrian_crossing;
UPDATE bent.axis SET width_end = width / 2;
SELECT 'also where it tapers', count(surface) > 50 AND bool_and(coalesce(ST_IsValid(surface), true)) FROM bent.pedestrian_crossing;
-- Points of an axis that are there twice.
INSERT INTO bent.axis (axis_id, geom, width) VALUES (30, pg_temp.line('LINESTRING(0 500, 40 500, 80 500, 80 500)'), 7), (31, pg_temp.line('LINESTRING(80 500, 80 500, 160 500)'), 9);
INSERT INTO bent.pedestrian_crossing_editing (axis_id, abscissa) VALUES (30, 79), (31, 1);
SELECT 'a crossing where the axis ends with a point twice', bool_and(ST_IsValid(surface) AND ST_Area(surface) > 20) FROM bent.pedestrian_crossing JOIN bent.street_object USING (street_object_id) WHERE axis_id IN (30, 31);

-- Where crossings are built, if the rule does not say.
-- Of a roundabout that is computed the arms count, not the tag.
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('kinds', 2154, subjects => '{object}') \g /dev/null
RESET streetgen_test.subjects;
INSERT INTO kinds.axis (axis_id, geom, width, kind, roundabout_tag, direction) SELECT row_number() OVER (), pg_temp.line(format('LINESTRING(%s 0, %s 0, %s 0)', 100 * (n - 1), 100 * n - 50, 100 * n)), 6, kind, tag, CASE WHEN tag IS NULL THEN 'both' ELSE 'direct' END
  FROM unnest('{residential,motorway,motorway_link,service,primary}'::text[], ARRAY[NULL, NULL, NULL, NULL, 'roundabout']) WITH ORDINALITY v(kind, tag, n);
INSERT INTO kinds.axis (axis_id, geom, width) SELECT 10 + n, pg_temp.line(format('LINESTRING(%s 0, %s 60)', 100 * n, 100 * n)), 6 FROM generate_series(0, 5) n;
INSERT INTO kinds.axis (axis_id, geom, width) VALUES (20, pg_temp.line('LINESTRING(0 0, 0 -60)'), 6);
INSERT INTO kinds.placement_rule (rule_id, type, along, side, distance_from_limit) VALUES (1, 'crossing', 'arm', 'alternating', 2.5);
SELECT 'no crossing of a rule without classes on motorways, their links, service ways and roundabouts', array_agg(DISTINCT axis_id ORDER BY axis_id) = '{1,10,11,12,13,14,20}' FROM kinds.street_object;
UPDATE kinds.placement_rule SET kind = '{motorway,service}';
SELECT 'there too where the rule says so', array_agg(DISTINCT axis_id ORDER BY axis_id) = '{2,4}' FROM kinds.street_object;
SELECT 'a type with a table is not renamed: ' || said, test.state(format('UPDATE kinds.object_type SET type = %L WHERE type = %L', said || '_2', said)) = '22023' FROM unnest('{crossing,parking_bay}'::text[]) said;
SELECT 'and no row is lost', count(*) > 2 FROM kinds.pedestrian_crossing;
