\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Signals: phases, what is shown when, by hand, green waves, and what users program.  (name, holds)
CREATE FUNCTION line(VARIADIC xy float8[]) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + xy[2 * i - 1], 6860000 + xy[2 * i]) ORDER BY i), 2154) FROM generate_series(1, cardinality(xy) / 2) i $$;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{signal}', driving_side => 'right'); END $$;
-- A street of eleven pieces that ten side streets cross; the crossings have signals.
INSERT INTO town.axis (geom, width, lane_count, importance, speed, name)
  SELECT line(150.0 * (k - 1) + 7 * (k % 3), 0, 150.0 * k + 7 * ((k + 1) % 3), 0), 8, 2, 2, 50, 'high' FROM generate_series(1, 11) k ORDER BY k;
INSERT INTO town.axis (geom, width, lane_count, importance, speed, name)
  SELECT line(150.0 * k + 7 * ((k + 1) % 3), 90 * d, 150.0 * k + 7 * ((k + 1) % 3), 0), 6, 2, 3, 30, 'side' FROM generate_series(1, 10) k, unnest(ARRAY[-1, 1]) d;
INSERT INTO town.control_point (geom, kind) SELECT ST_StartPoint(geom), 'signals' FROM town.axis WHERE name = 'high' AND axis_id > 1;
SELECT 'each junction of kind signals has one controller', count(*) = 10 AND count(controller_id) = 10 FROM town.junction LEFT JOIN town.controller ON controller_id = junction_id WHERE kind = 'signals';
SELECT 'and no other place', count(*) = 10 FROM town.controller;
SELECT 'a crossing of two streets has two phases', bool_and(n = 2) FROM (SELECT count(*) AS n FROM town.signal_state WHERE kind = 'green' GROUP BY controller_id) s;
SELECT 'states last as long as the cycle', bool_and(cycle = whole) FROM town.controller JOIN (SELECT controller_id, sum(duration ORDER BY ordinality) AS whole FROM town.signal_state GROUP BY 1) s USING (controller_id);
SELECT 'all that connects has green', count(*) > 100 AND bool_and(s.lane_in IS NOT NULL) FROM town.movement m LEFT JOIN town.signal_movement s USING (lane_in, lane_out) WHERE m.connecting AND m.junction_id IN (SELECT controller_id FROM town.controller);
SELECT 'protected movements neither cross nor merge', NOT EXISTS (SELECT FROM town.conflict c JOIN town.interconnection a ON a.interconnection_id = c.interconnection_a JOIN town.interconnection b ON b.interconnection_id = c.interconnection_b
  JOIN town.signal_movement p ON (p.lane_in, p.lane_out) = (a.lane_in, a.lane_out) JOIN town.signal_movement q ON (q.lane_in, q.lane_out) = (b.lane_in, b.lane_out)
  WHERE (p.controller_id, p.ordinality) = (q.controller_id, q.ordinality) AND p.right_of_way = 'protected' AND q.right_of_way = 'protected');
SELECT 'left turns give way, nothing else does', bool_and((turn = 'left') = (right_of_way = 'permitted')) FROM town.signal_movement JOIN town.movement USING (lane_in, lane_out);
SELECT 'of two permitted movements that meet one goes first', count(*) > 40 AND count(DISTINCT (controller_id, precedence, lane_in, lane_out)) = count(DISTINCT (controller_id, precedence)) AND count(precedence) = count(*) FROM town.signal_movement;
SELECT 'states last whole seconds', bool_and(duration = round(duration)) FROM town.signal_state;
SELECT 'a signal group is what comes by a street with the same green', count(*) = 40 AND bool_and(kind = 'traffic') FROM town.signal_group;
SELECT 'who meets has time between greens, both ways', count(*) = 80 AND bool_and(i.seconds BETWEEN 3 AND 7 AND o.seconds > 0) FROM town.intergreen i JOIN town.intergreen o ON (o.controller_id, o.ends, o.begins) = (i.controller_id, i.begins, i.ends)
  JOIN (SELECT DISTINCT controller_id, signal_group, ordinality FROM town.signal_movement) a ON (a.controller_id, a.signal_group) = (i.controller_id, i.ends) JOIN (SELECT DISTINCT controller_id, signal_group, ordinality FROM town.signal_movement) b
  ON (b.controller_id, b.signal_group) = (i.controller_id, i.begins) WHERE a.ordinality <> b.ordinality;
SELECT 'heads stand at the stop lines', count(*) = 40 AND bool_and(ST_DWithin(h.geom, ST_LineInterpolatePoint(m.geom, 0.5), 1e-9))
  FROM town.signal_head h JOIN town.lane l USING (lane_id) JOIN town.marking m ON (m.edge_id, m.lane_position, m.along_axis, m.kind) = (l.edge_id, l.lane_position, h.along_axis, 'stop');
SELECT 'they say whether somebody mapped the signals', bool_and(method = 'hypothesis') FROM town.controller;
SELECT 'check_model has nothing to say of them', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation LIKE 'controller%' OR severity = 'error');
CREATE TABLE before AS SELECT * FROM test.content('town') UNION ALL SELECT s::text FROM town.signal_state s UNION ALL SELECT m::text FROM town.signal_movement m UNION ALL SELECT c::text FROM town.controller c;
SELECT 'a second run rewrites no row', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town');

-- What is shown.
SELECT 'the same again after each cycle', NOT EXISTS (SELECT * FROM streetgen.signals('town', 12) EXCEPT SELECT s.* FROM town.controller c, LATERAL streetgen.signals('town', 12 + 3 * c.cycle) s WHERE s.controller_id = c.controller_id);
SELECT 'over a cycle each movement has green as long as its states', bool_and(abs(shown - known) <= 1) FROM (SELECT lane_in, lane_out, count(*) FILTER (WHERE aspect = 'green') AS shown FROM (SELECT min(controller_id) AS id, min(cycle) AS cycle FROM town.controller) c,
  generate_series(0, ceil(c.cycle)::integer - 1) t, LATERAL streetgen.signals('town', t) s WHERE s.controller_id = c.id GROUP BY 1, 2) a
  JOIN (SELECT lane_in, lane_out, sum(duration) AS known FROM town.signal_movement JOIN town.signal_state USING (controller_id, ordinality) GROUP BY 1, 2) b USING (lane_in, lane_out);
SELECT 'a plan ends with the cycle', max(ends) = max(cycle) FROM town.controller c, LATERAL streetgen.signal_plan('town', c.controller_id) WHERE c.controller_id = (SELECT min(controller_id) FROM town.controller);
SELECT 'its picture has a line for each signal group, and a phase for each green', (xpath('count(//*[local-name() = "text" and contains(., " from ")])', svg))[1]::text = '4' AND (xpath('count(//*[local-name() = "text" and contains(., "phase ")])', svg))[1]::text = '2' FROM (SELECT streetgen.signal_svg('town', min(controller_id))::xml AS svg FROM town.controller) s;

-- On foot: a crossing of each street of the second place.
SELECT controller_id AS node_id FROM town.controller ORDER BY controller_id OFFSET 1 LIMIT 1 \gset
INSERT INTO town.control_point (geom, kind) SELECT ST_LineInterpolatePoint(CASE from_node WHEN :node_id THEN geom ELSE ST_Reverse(geom) END, 10 / ST_Length(geom)), 'pedestrian_crossing' FROM town.edge WHERE :node_id IN (from_node, to_node);
SELECT 'each street of the place has a crossing', count(*) = 4 AND count(DISTINCT edge_id) = 4 AND bool_and(abs(seconds - 4 - width / 1.2) < 1e-9 AND NOT inside) FROM town.junction_crossing;
SELECT 'people cross the one street while the other one has green', array_agg((name, ordinality)::text ORDER BY name, ordinality) = '{"(high,4)","(high,4)","(side,1)","(side,1)"}'
  FROM town.signal_crossing JOIN town.edge USING (edge_id) JOIN town.axis USING (axis_id);
SELECT 'and who turns gives way to them', bool_and(right_of_way = 'permitted') FROM town.signal_crossing;
SELECT 'nobody drives in from there, or straight out', NOT EXISTS (SELECT FROM town.signal_crossing c JOIN town.signal_movement m USING (controller_id, ordinality) JOIN town.movement w USING (lane_in, lane_out)
  JOIN town.lane i ON i.lane_id = m.lane_in JOIN town.lane o ON o.lane_id = m.lane_out WHERE i.edge_id = c.edge_id OR o.edge_id = c.edge_id AND w.turn = 'through');
SELECT 'green lasts as long as they need', bool_and(duration >= seconds) FROM town.signal_crossing JOIN town.junction_crossing USING (control_point_id, edge_id) JOIN town.signal_state USING (controller_id, ordinality);
SELECT 'the picture has a line for each', (xpath('count(//*[local-name() = "text" and contains(., "on foot")])', streetgen.signal_svg('town', :node_id)::xml))[1]::text = '4';
UPDATE town.axis SET direction = CASE WHEN name = 'side' AND axis_id % 2 = 0 THEN 'direct' ELSE direction END;
SELECT 'no crossing without green', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'crossing at signals where people never have green');
UPDATE town.axis SET direction = 'both';
DELETE FROM town.control_point WHERE kind = 'pedestrian_crossing';

-- By hand.
UPDATE town.controller_editing SET cycle = 100, start_offset = 7 WHERE controller_id = (SELECT min(controller_id) FROM town.controller);
SELECT 'a cycle by hand stretches the greens', (SELECT (cycle, start_offset, method) = (100::float8, 7::float8, 'by_hand') AND abs(100 - (SELECT sum(duration) FROM town.signal_state s WHERE s.controller_id = c.controller_id)) < 1e-9 FROM town.controller c WHERE method = 'by_hand');
UPDATE town.axis SET width = 9 WHERE axis_id = 1;
SELECT 'it outlives an edit', count(*) = 1 FROM town.controller WHERE method = 'by_hand' AND cycle = 100;
UPDATE town.controller_editing SET durations[1] = 40 WHERE by_hand;
SELECT 'a duration by hand too', count(*) = 1 FROM town.controller JOIN town.signal_state USING (controller_id) WHERE method = 'by_hand' AND ordinality = 1;
DELETE FROM town.controller_editing WHERE by_hand;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
SELECT 'taken back, all is as before', NOT EXISTS ((SELECT c::text FROM town.controller c EXCEPT TABLE before) UNION ALL (SELECT s::text FROM town.signal_state s EXCEPT TABLE before) UNION ALL (SELECT m::text FROM town.signal_movement m EXCEPT TABLE before));
SELECT name || ' is refused', test.state(statement) = state FROM (VALUES
    ('a program that is none', $$UPDATE town.controller_editing SET program = 'dance'$$, '22023'),
    ('a cycle of a second', 'UPDATE town.controller_editing SET cycle = 1', '22023'),
    ('a cycle that is no number', $$UPDATE town.controller_editing SET cycle = 'NaN'$$, '22023'),
    ('an offset below 0', 'UPDATE town.controller_editing SET start_offset = -1', '22023'),
    ('durations of another number', $$UPDATE town.controller_editing SET durations = '{3}'$$, '22023'),
    ('a duration of a day', 'UPDATE town.controller_editing SET durations[1] = 86400', '22023'),
    ('by_hand typed alone', 'UPDATE town.controller_editing SET by_hand = true WHERE NOT by_hand', '22023'),
    ('a controller drawn', 'INSERT INTO town.controller_editing (program) VALUES (NULL)', '0A000'),
    ('a setting that names no function', $$SELECT streetgen.set('town', 'signal_program', 'pg_catalog.now')$$, '22023'),
    ('a time that is no number', $$SELECT streetgen.signals('town', 'NaN')$$, '22023'),
    ('a controller that is not there', $$SELECT streetgen.signal_plan('town', -5)$$, '22023'),
    ('a wave at no speed', $$SELECT streetgen.coordinate('town', '{1}', 0)$$, '22023'),
    ('a wave along an axis that is not there', $$SELECT streetgen.coordinate('town', '{1,99999}', 50)$$, '22023'),
    ('a flow below 0', 'UPDATE town.axis SET flow = -1', '23514')) v(name, statement, state) ORDER BY name COLLATE "C";

-- A green wave: whoever passes the first light in its first seconds of green meets green at all others.
SELECT 'a wave passes ten controllers', count(*) = 10 FROM streetgen.coordinate('town', ARRAY(SELECT generate_series(1, 11)::bigint), 50);
CREATE TABLE wave AS SELECT r.controller_id, r.metres, r.lane_in FROM streetgen._route_controllers('town', ARRAY(SELECT generate_series(1, 11)::bigint)) r;
SELECT 'all have one cycle', count(DISTINCT cycle) = 1 FROM town.controller;
SELECT 'a car at the speed meets green at each, cycle after cycle', count(*) = 30 AND bool_and(s.aspect = 'green') FROM wave w CROSS JOIN generate_series(0, 2) turn CROSS JOIN (SELECT max(cycle) AS cycle FROM town.controller) c,
  LATERAL streetgen.signals('town', turn * cycle + w.metres / (50 / 3.6)) s JOIN town.movement m USING (lane_in, lane_out) WHERE s.lane_in = w.lane_in AND m.turn = 'through';
DELETE FROM town.controller_editing;

-- The paper's program, flows, crossings on foot, and programs of users.
SELECT streetgen.set('town', 'signal_program', 'paper'), streetgen.generate('town') \g /dev/null
SELECT 'of the paper: six pairs of 20 s', bool_and(cycle = 120 AND program = 'paper') FROM town.controller;
SELECT streetgen.set('town', 'signal_program', 'phases'), streetgen.generate('town') \g /dev/null
UPDATE town.axis SET flow = CASE name WHEN 'high' THEN 1400 ELSE 300 END;
SELECT 'who has more traffic has more green', bool_and(high > 2 * side) FROM (SELECT s.controller_id, max(duration) FILTER (WHERE a.name = 'high') AS high, max(duration) FILTER (WHERE a.name = 'side') AS side FROM town.signal_state s
  JOIN town.signal_movement m USING (controller_id, ordinality) JOIN town.lane ON lane_id = lane_in JOIN town.edge USING (edge_id) JOIN town.axis a USING (axis_id) GROUP BY 1) g;
INSERT INTO town.control_point (geom, kind) SELECT ST_LineInterpolatePoint(geom, 0.95), 'pedestrian_crossing' FROM town.axis WHERE name = 'high';
SELECT 'people cross the high street before it has green again', count(*) = 10 AND bool_and(walk_until - walk_from >= 4 AND clear_until - walk_until >= 8 / 1.2 AND clear_until <= starts) FROM town.signal_crossing c
  JOIN (SELECT controller_id, cycle FROM town.controller) k USING (controller_id) CROSS JOIN LATERAL (SELECT min(g.green_from + CASE WHEN g.green_from < c.walk_from THEN cycle ELSE 0 END) AS starts FROM town.signal_green g
    JOIN town.intergreen i ON (i.controller_id, i.ends) = (g.controller_id, g.signal_group) JOIN town.signal_group w ON (w.controller_id, w.signal_group) = (i.controller_id, i.begins)
    WHERE (w.controller_id, w.control_point_id, w.edge_id) = (c.controller_id, c.control_point_id, c.edge_id)) s;
CREATE FUNCTION one_by_one(movements streetgen.signal_request[]) RETURNS SETOF streetgen.signal_answer LANGUAGE sql AS $$
  SELECT n::integer, 9::float8, 'green', lane_in, lane_out, along_in, along_out, 'protected' FROM unnest(movements) WITH ORDINALITY m(lane_in, lane_out, along_in, along_out, a, b, c, d, e, f, g, h, i, j, k, l, o, p, n) $$;
CREATE FUNCTION all_at_once(movements streetgen.signal_request[]) RETURNS SETOF streetgen.signal_answer LANGUAGE sql AS $$
  SELECT 1, 9::float8, 'green', lane_in, lane_out, along_in, along_out, 'protected' FROM unnest(movements) $$;
CREATE FUNCTION forgets(movements streetgen.signal_request[]) RETURNS SETOF streetgen.signal_answer LANGUAGE sql AS $$ SELECT 1, 9::float8, 'green', NULL::bigint, NULL::bigint, NULL::boolean, NULL::boolean, NULL $$;
CREATE FUNCTION raises(movements streetgen.signal_request[]) RETURNS SETOF streetgen.signal_answer LANGUAGE plpgsql AS $$ BEGIN RAISE 'no' USING ERRCODE = '22012'; END $$;
CREATE FUNCTION pg_temp.program(name text) RETURNS text LANGUAGE sql AS $$ SELECT test.state(format('SELECT streetgen.set(%L, %L, %L); SELECT FROM streetgen.generate(%1$L)', 'town', 'signal_program', 'public.' || name)) $$;
SELECT 'a program that lets movements meet is refused', pg_temp.program('all_at_once') = '22023';
SELECT 'one that forgets movements too', pg_temp.program('forgets') = '22023';
SELECT 'one that raises does so with its code', pg_temp.program('raises') = '22012';
SELECT 'after them all is as it was', bool_and(program = 'phases') FROM town.controller;
SELECT 'a program of a user runs', pg_temp.program('one_by_one') = 'none';

-- Edits leave what a run from scratch makes.
DO $$ BEGIN PERFORM streetgen.set('town', 'signal_program', 'phases'), streetgen.create_model('anew', 2154, subjects => '{signal}', driving_side => 'right'); PERFORM FROM streetgen.generate('town'); END $$;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (3, 15);
INSERT INTO town.axis (geom, width, lane_count, importance, speed, name) SELECT line(150.0 * k + 7 * ((k + 1) % 3), 0, 150.0 * k + 60, 70), 6, 2, 4, 30, 'slant' FROM generate_series(2, 5) k;
DELETE FROM town.axis WHERE axis_id = 18;
UPDATE town.axis SET lane_count = 4, width = 14 WHERE axis_id BETWEEN 4 AND 6;
SELECT 'signals after edits are those from scratch', test.followed('town', 'anew');

-- Switched off, nothing is left of it.
SELECT FROM streetgen.switch_subject('town', 'signal', false);
SELECT 'switched off, the tables go', to_regclass('town.controller') IS NULL AND to_regclass('town.controller_editing') IS NULL AND to_regprocedure('town._update_signals(bigint[], bigint[])') IS NULL;
UPDATE town.axis SET width = 8.2 WHERE axis_id = 2;
SELECT 'and a model without signals says so', test.state($$SELECT streetgen.signals('town', 0)$$) = '55000';

-- What signals make of odd junctions: fourteen arms, a street of 60 m to walk over, a drive, no traffic and too much.
DO $$ BEGIN PERFORM streetgen.create_model('odd', 2154, subjects => '{signal}', driving_side => 'right'); END $$;
INSERT INTO odd.axis (geom, width, lane_count, importance, speed, name) SELECT line(0, 0, 150 * cos(radians(360 * k / 14.0)), 150 * sin(radians(360 * k / 14.0))), 6, 2, 3, 50, 'ray' FROM generate_series(0, 13) k;
INSERT INTO odd.axis (geom, width, lane_count, importance, speed, name) VALUES (line(1000, 0, 1200, 0), 60, 4, 2, 50, 'wide'), (line(1200, 0, 1400, 0), 60, 4, 2, 50, 'wide'), (line(1200, 0, 1200, 150), 6, 2, 4, 50, 'narrow'), (line(1200, -150, 1200, 0), 6, 2, 4, 50, 'narrow'),
  (line(2000, 0, 2200, 0), 8, 2, 3, 50, 'street'), (line(2200, 0, 2400, 0), 8, 2, 3, 50, 'street'), (line(2200, 0, 2200, 100), 5, 2, 6, 20, 'drive');
INSERT INTO odd.control_point (geom, kind) SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000), 2154), 'signals' FROM unnest(ARRAY[0, 1200, 2200]) x;
INSERT INTO odd.control_point (geom, kind) VALUES (ST_SetSRID(ST_MakePoint(651185, 6860000), 2154), 'pedestrian_crossing');
CREATE VIEW odd_state AS SELECT controller_id, CASE round(ST_X(geom)) WHEN 650000 THEN 'star' WHEN 651200 THEN 'wide' ELSE 'drive' END AS place, cycle, s.ordinality, s.kind, s.duration FROM odd.controller JOIN odd.signal_state s USING (controller_id);
SELECT 'no cycle is longer than signal_cycle', count(*) = 3 AND max(cycle) <= 120 FROM odd.controller;
SELECT 'all that connects has green, also of fourteen arms', count(*) > 150 AND bool_and(s.lane_in IS NOT NULL) FROM odd.movement m LEFT JOIN odd.signal_movement s USING (lane_in, lane_out) WHERE m.connecting AND m.junction_id IN (SELECT controller_id FROM odd.controller);
SELECT 'all red lasts no longer than signal_all_red', max(duration) <= 6 FROM odd_state WHERE kind = 'all_red';
SELECT 'people cross 60 m within a cycle', count(*) = 1 AND bool_and(clear_until - walk_until = 50) FROM odd.signal_crossing;
SELECT 'a drive has no phase of its own, and gives way', count(DISTINCT signal_movement.ordinality) = 1 AND bool_or(right_of_way = 'permitted') FROM odd.signal_movement JOIN odd_state USING (controller_id, ordinality) JOIN odd.lane ON lane_id = lane_in JOIN odd.edge USING (edge_id) WHERE place = 'drive' AND importance = 6;
SELECT 'and one phase serves all of it', count(*) = 1 FROM odd_state WHERE place = 'drive' AND kind = 'green';
UPDATE odd.axis SET flow = 0;
SELECT 'no traffic is a cycle', min(cycle) >= 15 AND max(cycle) <= 120 FROM odd.controller;
UPDATE odd.axis SET flow = 20000;
SELECT 'too much traffic is a cycle', min(cycle) >= 30 AND max(cycle) <= 120 FROM odd.controller;
UPDATE odd.axis SET flow = NULL;
SELECT 'nothing is told of them as an error', NOT EXISTS (SELECT FROM streetgen.check_model('odd') WHERE severity = 'error' AND relation = 'controller');
SELECT streetgen.set('odd', 'signal_cycle', '60'), streetgen.generate('odd') \g /dev/null
SELECT 'a cycle that is too short makes phases one, and says so', max(cycle) <= 60 AND (SELECT count(*) = 1 FROM streetgen.check_model('odd') WHERE rule = 'through traffic that gives way at signals') FROM odd.controller;
SELECT 'a walk that is too long for it goes, and check_model says so', NOT EXISTS (SELECT FROM odd.signal_crossing) AND (SELECT count(*) = 1 FROM streetgen.check_model('odd') WHERE rule = 'crossing at signals where people never have green');
SELECT 'what goes first is known then too', NOT EXISTS (SELECT FROM odd.signal_movement a JOIN odd.signal_movement b USING (controller_id, ordinality) WHERE a.precedence = b.precedence AND (a.lane_in, a.lane_out) <> (b.lane_in, b.lane_out));
SELECT streetgen.set('odd', 'signal_cycle', '120'), streetgen.generate('odd') \g /dev/null
SELECT 'a setting beyond its range is refused', test.state($$SELECT streetgen.set('odd', 'signal_cycle', '5')$$) = '22023';
UPDATE odd.controller_editing SET turn_phases = true WHERE controller_id = (SELECT min(controller_id) FROM odd_state WHERE place = 'wide');
SELECT 'by hand turns have a phase of their own', count(*) FILTER (WHERE kind = 'green') > 2 AND bool_or(c.turn_phases) AND bool_and(c.cycle <= 120) FROM odd_state JOIN odd.controller c USING (controller_id) WHERE place = 'wide';
SELECT 'and no turn gives way to what goes straight on', count(*) > 0 AND bool_and(right_of_way = 'protected') FROM odd.signal_movement JOIN odd_state USING (controller_id, ordinality) JOIN odd.movement USING (lane_in, lane_out) WHERE place = 'wide' AND turn = 'left';
UPDATE odd.controller_editing SET durations = array_fill(1::float8, ARRAY[cardinality(durations)]) WHERE turn_phases;
SELECT 'durations by hand that leave nobody time are told', count(*) = 1 FROM streetgen.check_model('odd') WHERE rule = 'green that begins before others have left, s';
DELETE FROM odd.controller_editing WHERE by_hand;
SELECT 'taken back, turns are by rule again', count(*) FILTER (WHERE kind = 'green') = 2 FROM odd_state WHERE place = 'wide';
-- Signals in mid-block with a cycle by hand that go: the decision is about no other signals on the street.
SELECT streetgen.create_model('held', 2154, subjects => '{signal}', driving_side => 'right') \g /dev/null
INSERT INTO held.axis (axis_id, geom, width, importance) VALUES (1, 'SRID=2154;LINESTRING(649700 6860000,650000 6860000,650200 6860000)', 8, 4), (2, 'SRID=2154;LINESTRING(650000 6860000,650000 6860150)', 8, 4);
INSERT INTO held.control_point (control_point_id, geom, kind) VALUES (1, 'SRID=2154;POINT(649994 6860000)', 'signals'), (2, 'SRID=2154;POINT(649880 6860000)', 'signals');
CREATE FUNCTION pg_temp.held() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(concat_ws(' ', round(ST_X(geom)), cycle = 77), ', ' ORDER BY ST_X(geom)) FROM held.controller $$;
UPDATE held.controller_editing SET cycle = 77 WHERE controller_id = (SELECT controller_id FROM held.controller ORDER BY ST_X(geom) LIMIT 1);
SELECT 'a cycle by hand holds at its signals alone', pg_temp.held() = '649880 t, 650000 f';
DELETE FROM held.control_point WHERE control_point_id = 2;
SELECT 'and nowhere when they are gone, which is told', pg_temp.held() = '650000 f' AND (SELECT count(*) = 1 FROM streetgen.check_model('held') WHERE rule = 'controller override away from signals');
SELECT FROM streetgen.generate('held', wait => true) \g /dev/null
SELECT 'a run from scratch makes the same', pg_temp.held() = '650000 f';
INSERT INTO held.control_point (control_point_id, geom, kind) VALUES (2, 'SRID=2154;POINT(649881 6860000)', 'signals');
SELECT 'put back they have it again', pg_temp.held() = '649881 t, 650000 f' AND NOT EXISTS (SELECT FROM streetgen.check_model('held') WHERE rule = 'controller override away from signals');
-- Durations by hand stay with the streets that a phase serves: of five arms, whose phases take turns by the way across.
DO $$ BEGIN PERFORM streetgen.create_model('five', 2154, subjects => '{signal}', driving_side => 'right'); END $$;
CREATE FUNCTION arm(degrees float8, east float8 DEFAULT 0) RETURNS geometry LANGUAGE sql AS $$ SELECT line(east, 0, 120 * cos(radians(degrees)), 120 * sin(radians(degrees))) $$;
INSERT INTO five.axis (axis_id, geom, width, lane_count, importance, speed) SELECT k, arm(degrees), 8, 2, 3, 50 FROM (VALUES (1, 0), (2, 75), (3, 140), (4, 215), (5, 290)) v(k, degrees);
INSERT INTO five.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000 6860000)', 'signals');
CREATE VIEW five_green AS SELECT s.ordinality, min(duration) AS duration, string_agg(DISTINCT axis_id::text, '+' ORDER BY axis_id::text) AS axes FROM five.signal_state s JOIN five.signal_movement USING (controller_id, ordinality) JOIN five.lane ON lane_id = lane_in JOIN five.edge USING (edge_id) GROUP BY s.ordinality;
UPDATE five.controller_editing SET durations[1] = 33, durations[3] = 5.5;
CREATE TABLE typed AS SELECT axes, ordinality FROM five_green;
SELECT 'a duration is typed for a phase', array_agg(concat_ws(' ', axes, duration)) = '{3+5 33}' FROM five_green WHERE ordinality = 1;
UPDATE five.axis SET geom = arm(320) WHERE axis_id = 5;
SELECT 'phases turn their order when a street is moved', count(*) > 0 FROM five_green g JOIN typed t USING (axes) WHERE g.ordinality <> t.ordinality;
CREATE FUNCTION pg_temp.typed() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(axes, ', ' ORDER BY axes) FROM five_green WHERE duration = 33 $$;
SELECT 'and the duration stays with its street', pg_temp.typed() = '3+5';
CREATE FUNCTION pg_temp.goes_on_with(phases text[]) RETURNS text LANGUAGE sql AS $$ SELECT (phases || phases[1])[array_position(phases, '3+5') + 1] $$;
SELECT 'all red by hand holds where the same phase follows', bool_or(duration = 5.5) = (SELECT pg_temp.goes_on_with((SELECT array_agg(axes ORDER BY ordinality) FROM typed)) = pg_temp.goes_on_with((SELECT array_agg(axes ORDER BY ordinality) FROM five_green))) FROM five.signal_state WHERE kind = 'all_red';
SELECT FROM streetgen.generate('five', wait => true) \g /dev/null
SELECT 'also from scratch', pg_temp.typed() = '3+5' AND NOT EXISTS (SELECT FROM streetgen.check_model('five') WHERE rule = 'durations by hand without their street');
UPDATE five.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (2, 3);
UPDATE five.axis SET geom = ST_LineSubstring(geom, 0.94, 1) WHERE axis_id = 3;
SELECT 'on streets turned round and shortened too', pg_temp.typed() = '3+5';
UPDATE five.axis SET geom = ST_SetPoint(geom, CASE WHEN ST_X(ST_StartPoint(geom)) = 650000 THEN 0 ELSE -1 END, 'SRID=2154;POINT(650008 6860006)');
SELECT 'and where the place moves and another street goes with the one, with the other', pg_temp.typed() = '5';
DELETE FROM five.axis WHERE axis_id IN (3, 5);
INSERT INTO five.axis (axis_id, geom, width, lane_count, importance, speed) VALUES (6, arm(180, 8), 8, 2, 3, 50);
SELECT 'it goes to no other street, and check_model tells of it', pg_temp.typed() IS NULL AND (SELECT count(*) = 1 FROM streetgen.check_model('five') WHERE rule = 'durations by hand without their street');
UPDATE five.controller_editing SET cycle = 100;
SELECT 'what is typed beside leaves it', array_length(durations, 1) = array_length(phases, 1) AND cycle = 100 FROM five.controller_override;
UPDATE five.controller_editing SET durations = NULL;
SELECT 'taken back, nothing is told', (durations, phases, approaches) IS NULL AND NOT EXISTS (SELECT FROM streetgen.check_model('five') WHERE rule = 'durations by hand without their street') FROM five.controller_override;
-- A crossing is one of the arm that it lies on: between two junctions of the nearer one, and of none where lanes end farther off.
SELECT streetgen.create_model('arms', 2154, subjects => '{signal}', driving_side => 'right') \g /dev/null
INSERT INTO arms.axis (axis_id, geom, width, importance) VALUES (1, line(-100, 0, 0, 0, 45, 0, 145, 0), 8, 3), (2, line(0, 0, 0, 100), 8, 3), (3, line(45, 0, 45, 100), 8, 3);
INSERT INTO arms.control_point (geom, kind) SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000), 2154), kind FROM (VALUES (0, 'signals'), (45, 'signals'), (-9, 'pedestrian_crossing'), (-30, 'pedestrian_crossing'), (10, 'pedestrian_crossing'), (36, 'pedestrian_crossing'), (55, 'pedestrian_crossing')) v(x, kind);
CREATE FUNCTION pg_temp.crossed() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(concat_ws(' at ', round(ST_X(c.geom) - 650000), round(ST_X(n.geom) - 650000)), ', ' ORDER BY ST_X(c.geom)) FROM arms.junction_crossing c JOIN arms.node n USING (node_id) $$;
SELECT 'crossings are of the arm that they lie on', pg_temp.crossed() = '-9 at 0, 10 at 0, 36 at 45, 55 at 45';
SELECT 'who waits for one waits before it', count(*) = 4 AND bool_and(CASE WHEN along_axis THEN line < crossing ELSE line > crossing END) FROM (SELECT ST_X(c.geom) AS crossing, ST_X(ST_Centroid(m.geom)) AS line, along_axis FROM arms.junction_crossing c JOIN arms.marking m USING (edge_id, node_id) WHERE m.kind = 'stop') l;
DELETE FROM arms.axis WHERE axis_id = 3;
SELECT 'where the street just goes on, only how near its lanes end counts', pg_temp.crossed() = '-9 at 0, 10 at 0';
