\set ECHO none
\ir shared/truths.sql
-- Scenes for driving simulators.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction,sidewalk}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, speed, name, kind) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 14, 4, 'both', 2, 50, 'Main', 'primary'), (2, 'SRID=2154;LINESTRING(650200 6860000,650400 6860000)', 14, 4, 'both', 2, 50, 'Main', 'primary'),
    (3, 'SRID=2154;LINESTRING(650200 6859800,650200 6860000)', 7, 2, 'both', 4, 50, 'South', 'residential');
  PERFORM streetgen.generate('town', wait => true);
  PERFORM streetgen.create_traffic('town');
  PERFORM streetgen.place_cars('town', 10);
END $$;

-- What a log tells.
CREATE TEMPORARY TABLE trace AS SELECT t, car_id, link, metres, speed, ST_X(geom) AS x, ST_Y(geom) AS y FROM streetgen.simulate('town', 'idm', 60, 0.1, '{"flow": 300}', options => '{"output": 0.5}') ORDER BY hashint8(car_id), t DESC;
CREATE TEMPORARY TABLE reported AS SELECT * FROM streetgen.drive_report('town', 'trace', '{"time": "t", "actor": "car_id"}');
SELECT 'a report has a row for each sample, by time and actor' AS name, count(*) = (SELECT count(*) FROM trace) AND bool_and(in_order) AS holds FROM (SELECT (t, actor COLLATE "C") >= lag((t, actor COLLATE "C")) OVER (ORDER BY sample) IS NOT FALSE AS in_order FROM reported) r;
SELECT 'our own cars are on the lanes that they drove on', count(*) > 1000 AND count(*) FILTER (WHERE r.link = t.link AND abs(r.metres - t.metres) < 0.01 AND abs(r.lane_offset) < 0.01) >= 0.995 * count(*)
  FROM reported r JOIN trace t ON t.t = r.t AND t.car_id::text = r.actor;
SELECT 'none of them is anywhere else', bool_and(finding IS NULL AND NOT against) FROM reported;
SELECT 'speed over the limit is that over the speed of the link', bool_and(abs(over_limit - (r.speed - k.speed)) < 1e-3) FROM reported r JOIN town.link k ON k.link_id = r.link;
SELECT 'the gap to who is ahead on a lane is what lies between them', count(*) > 500 AND bool_and(r.leader = n.car_id::text AND abs(r.gap - (n.metres - t.metres - 5)) < 0.01) FROM reported r JOIN trace t ON t.t = r.t AND t.car_id::text = r.actor
  CROSS JOIN LATERAL (SELECT o.car_id, o.metres FROM trace o WHERE o.t = t.t AND o.link = t.link AND o.metres > t.metres ORDER BY o.metres LIMIT 1) n;
SELECT 'time to collision is the gap by the difference of speeds', count(*) > 100 AND bool_and(abs(r.time_to_collision * (r.speed - o.speed) / 3.6 - r.gap) < 1e-6) FROM reported r JOIN reported o ON o.t = r.t AND o.actor = r.leader WHERE r.time_to_collision > 0;
SELECT 'and none where both draw apart', NOT EXISTS (SELECT FROM reported r JOIN reported o ON o.t = r.t AND o.actor = r.leader WHERE r.speed < o.speed AND r.time_to_collision IS NOT NULL);
CREATE TEMPORARY VIEW mixed AS SELECT * FROM trace ORDER BY md5(concat(t, car_id));
SELECT 'a log out of order gives the same rows', NOT EXISTS (TABLE reported EXCEPT SELECT * FROM streetgen.drive_report('town', 'mixed', '{"time": "t", "actor": "car_id"}'));
CREATE TEMPORARY VIEW stamped AS SELECT timestamp '2026-01-01' + make_interval(secs => t) AS time, ST_Transform(ST_SetSRID(ST_MakePoint(x, y), 2154), 4326) AS place, 'car ' || car_id AS actor FROM trace;
SELECT 'so do timestamps, points of another projection, and speeds by places', count(*) = (SELECT count(*) FROM trace) AND count(*) FILTER (WHERE p.link = r.link) >= 0.99 * count(*) AND avg(abs(p.speed - r.speed)) < 2
  FROM streetgen.drive_report('town', 'stamped', '{"geom": "place"}') p JOIN reported r ON 'car ' || r.actor = p.actor AND p.t = extract(epoch FROM timestamp '2026-01-01') + r.t;
CREATE TEMPORARY VIEW unplaced AS SELECT t AS time, ST_MakePoint(x, y) AS place, car_id AS actor, speed FROM trace;
SELECT 'points without reference are in that of the model', NOT EXISTS (TABLE reported EXCEPT SELECT * FROM streetgen.drive_report('town', 'unplaced', '{"geom": "place"}'));

-- Logs with errors in them.
CREATE TEMPORARY TABLE odd (time float8, x float8, y float8, actor text, length float8);
INSERT INTO odd SELECT i, 650020 + 10 * i, 6859998.25, 'a', 5 FROM generate_series(0, 9) i;
INSERT INTO odd VALUES (3.5, 'NaN', 6860000, 'a', 5), (NULL, 650000, 6860000, 'a', 5), (4, 650060, 6859998, 'a', 5), (12, 650020, 6860100, 'a', 5), (13, 650020, NULL, 'a', 5);
SELECT 'what cannot be placed is told', string_agg(concat(t, ' ', finding), ', ' ORDER BY sample) FILTER (WHERE finding IS NOT NULL) = '3.5 no_place, 4 twice, 12 off_road, 13 no_place,  no_time' AND count(*) FILTER (WHERE finding IS NULL AND link IS NOT NULL) = 10 FROM streetgen.drive_report('town', 'odd');
SELECT 'a log without rows gives none', (SELECT count(*) FROM town.simulated) = 0 AND NOT EXISTS (SELECT FROM streetgen.drive_report('town', 'town.simulated', '{"time": "t", "geom": "geom"}'));
SELECT 'a missing column is named', test.said($q$SELECT * FROM streetgen.drive_report('town', 'trace')$q$) = 'table trace has no column "time"' AND test.state($q$SELECT * FROM streetgen.drive_report('town', 'trace', '{"time": "t", "speed": "v"}')$q$) = '42703';
SELECT 'so is one of words', test.said($q$SELECT * FROM streetgen.drive_report('town', 'odd', '{"time": "actor"}')$q$) = 'column "actor" of table odd is of type text, expected a number';
SELECT 'so is a mapping that nobody knows', test.said($q$SELECT * FROM streetgen.drive_report('town', 'odd', '{"lane": "x"}')$q$) = 'the mapping has no "lane"' AND test.said($q$SELECT * FROM streetgen.drive_report('town', 'odd', '{"x": 3}')$q$) = 'the mapping of "x" is 3, expected a column name'
  AND test.state($q$SELECT * FROM streetgen.drive_report('town', 'stamped', '{"geom": "place", "x": "y"}')$q$) = '22023' AND test.state($q$SELECT * FROM streetgen.drive_report('town', 'stamped', '{"geom": "actor"}')$q$) = '22023';
UPDATE odd SET length = 0 WHERE time = 7;
SELECT 'and a length of nothing, with its row', test.said($q$SELECT * FROM streetgen.drive_report('town', 'odd')$q$) LIKE 'the length at sample 10 is 0%';
SELECT 'NULL is refused', test.state($q$SELECT * FROM streetgen.drive_report('town', NULL)$q$) = '22004' AND test.state($q$SELECT * FROM streetgen.drive_summary('town', 'odd', NULL)$q$) = '22004';

-- Street by street.
CREATE TEMPORARY TABLE summarized AS SELECT * FROM streetgen.drive_summary('town', 'trace', '{"time": "t", "actor": "car_id"}');
SELECT 'a summary counts each sample once, and the seconds between all', sum(sample_count) = (SELECT count(*) FROM trace) AND abs(sum(seconds) - (SELECT sum(s) FROM (SELECT max(t) - min(t) AS s FROM trace GROUP BY car_id) c)) < 1e-6 AND bool_and(name IN ('Main', 'South')) FROM summarized;
SELECT 'the greatest excess and the least gap are those of samples', (SELECT (max(greatest_over_limit), min(least_gap), min(least_time_to_collision)) FROM summarized) = (SELECT (max(over_limit), min(gap), min(time_to_collision)) FROM reported);
SELECT 'stretches hold what lies on them', count(*) > 50 AND bool_and(ends - starts = 50 AND axis_id IN (1, 2)) AND sum(sample_count) = (SELECT sum(sample_count) FROM summarized WHERE name = 'Main') FROM streetgen.drive_summary('town', 'trace', '{"time": "t", "actor": "car_id"}', 50, '{Main}');
SELECT 'a stretch of nothing is refused', test.state($q$SELECT * FROM streetgen.drive_summary('town', 'odd', stretch => 0)$q$) = '22023' AND test.state($q$SELECT * FROM streetgen.drive_summary('town', 'odd', stretch => 'NaN')$q$) = '22023';
-- One drives straight on over a joint, one changes lanes, with samples that count for nothing.
CREATE TEMPORARY TABLE changes AS SELECT 2.0 * i AS time, 650020 + 40.0 * i AS x, 6859994.75 AS y, 'straight' AS actor FROM generate_series(0, 9) i UNION ALL SELECT i, 650010 + 15.0 * i, CASE WHEN i < 5 THEN 6859994.75 ELSE 6859998.25 END, 'changes' FROM generate_series(0, 9) i;
INSERT INTO changes VALUES (5, 650085, 6859998.2, 'changes'), ('-infinity', 650085, 6859998.25, 'changes'), (NULL, 650085, 6859998.25, 'changes');
SELECT 'a change of lanes is one on an edge, and what counts for nothing is left out', string_agg(concat_ws(' ', actor, name, sample_count, seconds, lane_changes), ', ' ORDER BY actor, name) = 'changes Main 10 9 1, straight Main 10 18 0' FROM streetgen.drive_summary('town', 'changes');
SELECT 'no line lies across an axis where it turns back', streetgen._line_across('LINESTRING(0 0,10 0,0 0)', 10, true) IS NULL AND ST_AsText(streetgen._line_across('LINESTRING(0 0,10 0)', 5, true)) = 'LINESTRING(5 0,5 60)';

-- Actors by rules.
CREATE TEMPORARY TABLE placed AS SELECT * FROM streetgen.place_actors('town');
SELECT 'actors are placed by the rules that a model begins with', (SELECT array_agg((kind, placed = n) ORDER BY kind) FROM placed p, LATERAL (SELECT CASE kind WHEN 'car' THEN (SELECT count(*) FROM town.car_place) ELSE (SELECT count(*) FROM town.walker_place) END AS n) n)::text = '{"(car,t)","(walker,t)"}';
SELECT 'as densely as they say, up to one a lane', bool_and(abs(n - 8 * length / 1000) < 1) FROM (SELECT k.length, count(p.car_id) AS n FROM town.link k LEFT JOIN town.car_place p USING (link_id) WHERE k.kind = 'lane' GROUP BY k.link_id, k.length) l;
SELECT 'people are on sidewalks', count(*) > 5 AND bool_and(EXISTS (SELECT FROM town.sidewalk s WHERE ST_DWithin(s.surface, p.geom, 1e-6))) FROM town.walker_place p;
CREATE TEMPORARY TABLE first AS SELECT to_jsonb(c) AS row FROM town.car c UNION ALL SELECT to_jsonb(w) FROM town.walker w;
SELECT 'the same seed places the same actors', sum(n.placed) = (SELECT count(*) FROM first) FROM streetgen.place_actors('town') n;
SELECT 'to the last digit', NOT EXISTS (SELECT to_jsonb(c) FROM town.car c UNION ALL SELECT to_jsonb(w) FROM town.walker w EXCEPT TABLE first);
SELECT 'another seed other ones', count(*) > 0 FROM streetgen.place_actors('town', 2);
SELECT 'elsewhere', EXISTS (SELECT to_jsonb(c) - 'car_id' FROM town.car c EXCEPT SELECT row - 'car_id' FROM first) AND EXISTS (SELECT to_jsonb(w) - 'walker_id' FROM town.walker w EXCEPT SELECT row - 'walker_id' FROM first);
DO $$ BEGIN PERFORM streetgen.place_actors('town', 1, ST_Transform('SRID=2154;POINT(650150 6860000)', 4326), 40); END $$;
SELECT 'nobody is placed about the start', bool_and(ST_Distance(geom, 'SRID=2154;POINT(650150 6860000)') > 39.5) AND count(*) > 10 FROM (SELECT geom FROM town.car_place UNION ALL SELECT geom FROM town.walker_place) p;
-- More than there is room for, buses among them.
UPDATE town.actor_rule SET density = 200 WHERE kind = 'car';
INSERT INTO town.actor_rule (kind, density, length, width) VALUES ('bus', 30, 12, 2.5);
INSERT INTO town.actor_rule (kind, class, headway) VALUES ('walker', 'nowhere', 2);
CREATE TABLE town.note (car_id bigint REFERENCES town.car ON DELETE CASCADE);
INSERT INTO town.note SELECT min(car_id) FROM town.car;
DO $$ BEGIN PERFORM streetgen.place_actors('town'); END $$;
SELECT 'tables of others may refer to cars', (SELECT count(*) FROM town.note) = 0 AND (SELECT min(car_id) FROM town.car) = 1;
DROP TABLE town.note;
SELECT 'a rule that fits no street is told', count(*) = 1 AND bool_and(id = (SELECT max(actor_rule_id) FROM town.actor_rule)) FROM streetgen.check_model('town') WHERE relation = 'actor_rule';
SELECT 'many are placed with 2 m between them, and cars and buses mix', count(*) > 60 AND min(gap) > 2 - 0.05 AND (SELECT count(*) FILTER (WHERE kind = 'bus' AND length = 12 AND width = 2.5) > 3 AND count(*) FILTER (WHERE kind = 'car' AND length = 5) > 30 FROM town.car) FROM streetgen.leaders('town') WHERE leader IS NOT NULL;
SELECT 'none need brake for the next one', count(*) > 50 AND bool_and(gap + 0.1 >= 2 + v * 1.6 + v * (v - ahead) / (2 * sqrt(0.73 * 1.67)) OR v < 0.1) AND max(v) > 3 FROM (SELECT p.metres, c.speed / 3.6 AS v, lead(c.speed / 3.6) OVER w AS ahead, lead(p.metres - c.length) OVER w - p.metres AS gap FROM town.car c JOIN town.car_place p USING (car_id) WINDOW w AS (PARTITION BY p.link_id ORDER BY p.metres)) c WHERE gap IS NOT NULL;
SELECT 'they can be driven on', count(DISTINCT car_id) > 60 FROM streetgen.simulate('town', 'idm', 2, 0.5);
-- The rule that names most counts.
INSERT INTO town.actor_rule (kind, class, density) VALUES ('car', 'residential', 0);
UPDATE town.actor_rule SET density = 0 WHERE kind IN ('bus', 'walker') AND class IS NULL;
SELECT 'a rule for a class stands before one for all', string_agg(kind, ' ' ORDER BY kind) FILTER (WHERE placed > 0) = 'car' FROM streetgen.place_actors('town');
SELECT 'and holds for streets of this class', count(*) > 20 AND bool_and(axis_id <> 3) FROM town.car;
DELETE FROM town.actor_rule;
INSERT INTO town.actor_rule (kind, headway) VALUES ('car', 9);
SELECT 'a headway is time by speed', placed BETWEEN 0.8 * n AND 1.2 * n FROM streetgen.place_actors('town'), (SELECT sum(length / (9 * speed / 3.6)) AS n FROM town.link WHERE kind = 'lane') l WHERE kind = 'car';
INSERT INTO town.walker (walker_id, axis_id, abscissa, side, across) VALUES (1, 1, 100, 'crossing', 3), (2, 1, 100, 'crossing', 30), (3, 99, 1, 'left', NULL);
SELECT 'who crosses is so far from the left kerb, at most across', string_agg(concat(walker_id, ' ', round((6860000 - ST_Y(geom))::numeric, 2)), ', ' ORDER BY walker_id) = '1 -4.00, 2 7.00' FROM town.walker_place;
SELECT 'who has no place is told', array_agg(id) = '{3}' FROM streetgen.check_model('town') WHERE rule = 'walker without its place';
SELECT 'half a rule or walker is refused', test.state($q$INSERT INTO town.actor_rule (kind) VALUES ('car')$q$) = '23514' AND test.state($q$INSERT INTO town.actor_rule (kind, density, headway) VALUES ('car', 1, 1)$q$) = '23514' AND test.state($q$INSERT INTO town.walker (axis_id, abscissa, side) VALUES (1, 1, 'crossing')$q$) = '23514'
  AND test.state($q$INSERT INTO town.actor_rule (kind, density) VALUES ('car', 'NaN')$q$) = '23514';
SELECT 'so is a free zone that is none', test.state($q$SELECT * FROM streetgen.place_actors('town', 1, NULL, -1)$q$) = '22023' AND test.state($q$SELECT * FROM streetgen.place_actors('town', NULL)$q$) = '22004' AND test.state($q$SELECT * FROM streetgen.place_actors('town', 1, NULL, 'NaN')$q$) = '22023';
SELECT 'so is a start that is no point', test.said($q$SELECT * FROM streetgen.place_actors('town', 1, 'SRID=2154;POINT EMPTY')$q$) = 'start is POINT EMPTY, expected a point' AND test.state($q$SELECT * FROM streetgen.place_actors('town', 1, 'SRID=2154;LINESTRING(0 0,1 1)')$q$) = '22023' AND test.state($q$INSERT INTO town.actor_rule (kind, density, lane_kind) VALUES ('walker', 1, 'bus')$q$) = '23514';
DROP TABLE town.actor_rule, town.walker CASCADE;
DO $$ BEGIN PERFORM streetgen.adopt_model('town'); END $$;
SELECT 'a model with traffic that came before scenes gets their tables', sum(placed) > 10 FROM streetgen.place_actors('town');

-- Events.
DELETE FROM town.car;
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, speed) VALUES (1, 1, 20, 4, true, 50);
INSERT INTO town.traffic_event (traffic_event_id, kind, trigger, at, axis_id, abscissa, lane_position, along_axis, car_id, speed, duration) VALUES
  (1, 'brake', 'time', 2, 1, 100, 4, true, 1, 20, 3), (2, 'brake', 'place', 0, 1, 120, 4, true, NULL, 10, 2), (3, 'cross', 'gap', 40, 1, 170, 4, true, NULL, 0, 15), (4, 'brake', 'place', 0, 3, 100, 2, true, 1, 10, 2), (5, 'pull_out', 'time', 30, 3, 100, 2, true, NULL, 0, 1);
SELECT 'an event is on the link of its lane', count(*) = 5 AND bool_and(ST_DWithin(p.geom, k.geom, 0.01)) AND bool_and(ST_Distance(p.geom, ST_SetSRID(CASE v.axis_id WHEN 1 THEN ST_MakePoint(650000 + v.abscissa, 6859994.75) ELSE ST_MakePoint(650201.75, 6859900) END, 2154)) < 0.05)
  FROM town.event_place p JOIN town.traffic_event v USING (traffic_event_id) JOIN town.link k USING (link_id);
CREATE TEMPORARY TABLE fired AS SELECT * FROM streetgen.fired_events('town', 45, 0.1);
CREATE TEMPORARY TABLE scene AS SELECT s.*, ST_X(s.geom) - 650000 AS x FROM streetgen.simulate('town', 'idm', 45, 0.1, options => '{"output": 0}') s;
SELECT 'each fires once, but for one whose trigger does not come', array_agg(traffic_event_id ORDER BY traffic_event_id) = '{1,2,3,5}' FROM fired;
SELECT 'by time in the step of that time', t BETWEEN 2 AND 2.1 AND car_id = 1 FROM fired WHERE traffic_event_id = 1;
SELECT 'by place in the step after the car passes', f.t BETWEEN p.t - 0.01 AND p.t + 0.11 FROM fired f, (SELECT min(t) AS t FROM scene WHERE car_id = 1 AND x >= 120) p WHERE traffic_event_id = 2;
SELECT 'by gap in the step after the car is so near', f.t BETWEEN p.t - 0.01 AND p.t + 0.11 FROM fired f, (SELECT min(t) AS t FROM scene WHERE car_id = 1 AND x >= 130) p WHERE traffic_event_id = 3;
SELECT 'the simulation obeys: the car brakes, and waits for who crosses', min(speed) FILTER (WHERE s.t BETWEEN 2.5 AND 5) < 40 AND min(speed) FILTER (WHERE x > 160) < 0.5 AND max(x) FILTER (WHERE s.t < f.t + 15) <= 169.1 AND max(x) > 190 FROM scene s, (SELECT t FROM fired WHERE traffic_event_id = 3) f WHERE car_id = 1;
SELECT 'a car pulls out where and when it is to', min(s.t) - 30 < 0.21 AND min(ST_Distance(s.geom, p.geom)) < 0.1 FROM scene s, town.event_place p WHERE p.traffic_event_id = 5 AND s.car_id <> 1;
INSERT INTO town.traffic_event (traffic_event_id, kind, trigger, at, axis_id, abscissa, lane_position, along_axis, car_id) VALUES (6, 'brake', 'place', 0, 1, 60, 4, true, -7), (7, 'brake', 'time', 1, 1, 60, 9, true, NULL);
SELECT 'an event on no lane, or for a car that is not there, happens to nobody', NOT EXISTS (SELECT * FROM streetgen.fired_events('town', 45, 0.1) EXCEPT TABLE fired);
SELECT 'and is told', string_agg(concat_ws(' ', id, rule), ', ' ORDER BY id) = '6 event without its car, 7 event without its lane' FROM streetgen.check_model('town') WHERE relation = 'traffic_event';
SELECT 'a flow knows no events', count(*) > 0 FROM streetgen.simulate('town', 'lwr', 5, 0.1);
-- At a hundred places of all lanes, by each trigger: once, within a step.
DELETE FROM town.traffic_event;
DELETE FROM town.actor_rule;
INSERT INTO town.actor_rule (kind, density) VALUES ('car', 20);
DO $$ BEGIN PERFORM streetgen.place_actors('town', 3); END $$;
INSERT INTO town.traffic_event (kind, trigger, at, axis_id, abscissa, lane_position, along_axis, duration)
  SELECT (ARRAY['brake', 'breakdown', 'overtake', 'pull_out', 'cross'])[1 + i % 5], (ARRAY['time', 'place', 'gap'])[1 + i % 3], CASE i % 3 WHEN 0 THEN i / 4.0 ELSE 20 END, l.axis_id, 20 + 12.3 * (i % 13), l.lane_position, l.along_axis, 0.5
  FROM generate_series(1, 100) i, LATERAL (SELECT e.axis_id, l.lane_position, l.along_axis FROM town.lane l JOIN town.edge e USING (edge_id) ORDER BY e.axis_id, l.lane_position OFFSET i % 10 LIMIT 1) l;
CREATE TEMPORARY TABLE many AS SELECT * FROM streetgen.fired_events('town', 60, 0.1, '{"flow": 400}');
SELECT 'of a hundred events most fire, and none twice', count(*) > 80 AND count(DISTINCT traffic_event_id) = count(*) FROM many;
SELECT 'those by time for nobody in particular in the step of that time', count(f.t) >= 5 AND bool_and(f.t - v.at BETWEEN -1e-6 AND 0.1 + 1e-6) FROM town.traffic_event v LEFT JOIN many f USING (traffic_event_id) WHERE v.trigger = 'time' AND v.kind = 'cross';
SELECT 'who brings an event by place is within a step behind it', count(*) > 10 AND bool_and(f.metres - p.metres BETWEEN 0 AND 1.5) FROM many f JOIN town.traffic_event v USING (traffic_event_id) JOIN town.event_place p USING (traffic_event_id) WHERE v.trigger = 'place' AND v.kind <> 'pull_out' AND f.link = p.link_id;
SELECT 'the same seed fires the same', NOT EXISTS (TABLE many EXCEPT SELECT * FROM streetgen.fired_events('town', 60, 0.1, '{"flow": 400}'));
SELECT 'an event that is none is refused', test.state($q$UPDATE town.traffic_event SET kind = 'fly'$q$) = '23514' AND test.state($q$UPDATE town.traffic_event SET at = 'NaN'$q$) = '23514' AND test.state($q$UPDATE town.traffic_event SET deceleration = 0$q$) = '23514' AND test.state($q$SELECT * FROM streetgen.fired_events('town', NULL)$q$) = '22004';
