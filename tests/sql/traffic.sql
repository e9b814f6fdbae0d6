\set ECHO none
\ir shared/truths.sql
\ir shared/quickest.sql
-- Traffic: who gives way, cars and their leaders, and simulations of them.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction,signal}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, speed) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 14, 4, 'both', 2, 50), (2, 'SRID=2154;LINESTRING(650200 6860000,650400 6860000)', 14, 4, 'both', 2, 50),
    (3, 'SRID=2154;LINESTRING(650200 6859800,650200 6860000)', 7, 2, 'both', 4, 50), (4, 'SRID=2154;LINESTRING(650200 6860000,650200 6860200)', 7, 2, 'both', 4, 50),
    (5, 'SRID=2154;LINESTRING(650400 6860000,650550 6860000)', 14, 4, 'both', 2, 50), (6, 'SRID=2154;LINESTRING(650400 6860000,650400 6860150)', 6, 2, 'both', 5, 30);
  INSERT INTO town.control_point (kind, geom) VALUES ('signals', 'SRID=2154;POINT(650200 6860000)');
  PERFORM streetgen.generate('town', wait => true);
  PERFORM streetgen.create_traffic('town');
END $$;

-- Who gives way.
CREATE TEMPORARY TABLE conflict AS SELECT * FROM streetgen.link_conflicts('town');
SELECT 'each pair stands twice, and both say the same' AS name, count(*) > 20 AND bool_and(EXISTS (SELECT FROM conflict o WHERE (o.link, o.other, o.starts, o.other_ends) = (c.other, c.link, c.other_starts, c.ends)
    AND o.precedence = CASE c.precedence WHEN 'goes_first' THEN 'gives_way' WHEN 'gives_way' THEN 'goes_first' ELSE c.precedence END)) AS holds FROM conflict c;
SELECT 'paths that cross need the same ground', NOT EXISTS (SELECT FROM town.conflict c JOIN town.link a ON a.interconnection_id = c.interconnection_a JOIN town.link b ON b.interconnection_id = c.interconnection_b
    WHERE NOT EXISTS (SELECT FROM conflict f WHERE (f.link, f.other) = (a.link_id, b.link_id)));
SELECT 'and the ground is about the place where they cross', bool_and(ST_LineLocatePoint(a.geom, c.geom) * a.length BETWEEN f.starts - 1 AND f.ends + 1) FROM town.conflict c JOIN town.link a ON a.interconnection_id = c.interconnection_a
    JOIN town.link b ON b.interconnection_id = c.interconnection_b JOIN conflict f ON (f.link, f.other) = (a.link_id, b.link_id) WHERE c.kind = 'crossing' AND GeometryType(c.geom) = 'POINT';
SELECT 'who comes by the side street gives way to who is on the main one', count(*) > 0 AND bool_and(c.precedence = 'gives_way') FROM conflict c JOIN town.link m ON m.link_id = c.link JOIN town.link o ON o.link_id = c.other
    JOIN town.lane l ON l.lane_id = m.lane_in JOIN town.edge e USING (edge_id) JOIN town.lane l2 ON l2.lane_id = o.lane_in JOIN town.edge e2 ON e2.edge_id = l2.edge_id WHERE e.axis_id = 6 AND e2.axis_id <> 6;
SELECT 'crossing streets of a signal have no green together', count(*) > 0 AND bool_and(c.precedence = 'by_signal') FROM conflict c JOIN town.movement m ON 4 * m.interconnections[1] + 2 = c.link JOIN town.movement o ON 4 * o.interconnections[1] + 2 = c.other
    JOIN town.lane l ON l.lane_id = m.lane_in JOIN town.edge e USING (edge_id) JOIN town.lane l2 ON l2.lane_id = o.lane_in JOIN town.edge e2 ON e2.edge_id = l2.edge_id WHERE e.axis_id IN (1, 2) AND e2.axis_id IN (3, 4) AND m.turn = 'through' AND o.turn = 'through';
SELECT 'of some movements the same rows come', count(*) = 4 FROM (SELECT link, count(*) AS n FROM conflict GROUP BY link ORDER BY link LIMIT 4) c, LATERAL (SELECT count(*) AS m FROM streetgen.link_conflicts('town', ARRAY[c.link])) p WHERE p.m = c.n;

-- Cars on links.
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, speed) VALUES (1, 1, 40, 4, true, 50), (2, 1, 90, 4, true, 30), (3, 1, 60, 3, true, 50), (4, 2, 100, 1, false, 20);
SELECT 'a car is on the link of its lane, at its place', bool_and(ST_Distance(p.geom, v.geom) < 2.8 AND ST_DWithin(k.geom, p.geom, 0.01)) AND count(*) = 4 FROM town.car_place p JOIN town.car USING (car_id) JOIN town.axis USING (axis_id)
    JOIN town.link k USING (link_id) CROSS JOIN LATERAL (SELECT ST_OffsetCurve(axis.geom, CASE lane_position WHEN 4 THEN -5.25 WHEN 3 THEN -1.75 ELSE 5.25 END) AS line) o, LATERAL (SELECT ST_LineInterpolatePoint(o.line, abscissa / 200) AS geom) v;
CREATE TEMPORARY TABLE leader AS SELECT * FROM streetgen.leaders('town');
SELECT 'the next one on the lane leads', (SELECT (leader, virtual IS NULL, abs(distance - 50) < 1e-3, abs(gap - 45) < 1e-3, speed) = (2, true, true, true, 30) FROM leader WHERE car_id = 1);
SELECT 'before a signal none leads but what it shows', (SELECT leader IS NULL AND virtual IS NOT NULL FROM leader WHERE car_id = 3);
SELECT 'at red a car stands there', bool_or(virtual = 'stationary' AND gap < 140) AND bool_or(gap > 400) FROM generate_series(0, 110, 5) s, streetgen.leaders('town', at => s) WHERE car_id = 3;
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, onto_axis, onto_position, onto_along, beyond) SELECT 5, 1, 195, 4, true, 2, 4, true, 3;
SELECT 'a car on its way across is on the movement', (SELECT (kind, metres) = ('movement', 3) AND k.lane_in = (SELECT link.lane_id FROM town.car_place JOIN town.link USING (link_id) WHERE car_id = 1) FROM town.car_place JOIN town.link k USING (link_id) WHERE car_id = 5);
SELECT 'and leads who comes after, at green', bool_or(leader = 5 AND gap BETWEEN 90 AND 115) FROM generate_series(0, 110, 5) s, streetgen.leaders('town', at => s) WHERE car_id = 2;
SELECT 'a path goes straight on', count(*) >= 3 AND bool_and(k.kind = CASE p.ordinality % 2 WHEN 1 THEN 'lane' ELSE 'movement' END) AND bool_and(a.axis_id IN (1, 2, 5)) FROM streetgen.free_path('town', (SELECT link_id FROM town.car_place WHERE car_id = 1), 40, 500) p
    JOIN town.link k USING (link_id) LEFT JOIN town.lane l USING (lane_id) LEFT JOIN town.edge a USING (edge_id);
CREATE TEMPORARY TABLE whole AS SELECT streetgen._network_of_links('town') AS bytes;
SELECT 'the same from each link as in the whole network', count(*) > 20 AND NOT bool_or(p.starts IS NULL OR w.starts IS NULL OR abs(p.starts - w.starts) > 1e-9) FROM whole, town.link l, LATERAL (SELECT * FROM streetgen._free_path(bytes, l.link_id, 0, 300, '{}') WITH ORDINALITY) w FULL JOIN LATERAL (SELECT * FROM streetgen.free_path('town', l.link_id, 0, 300)) p USING (ordinality, link_id) WHERE l.link_id % 3 = 0;
SELECT 'a car on a lane that is not there has no place', test.state($q$INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis) VALUES (9, 1, 50, 9, true)$q$) = 'none' AND NOT EXISTS (SELECT FROM town.car_place WHERE car_id = 9)
    AND NOT EXISTS (SELECT FROM streetgen.leaders('town') WHERE car_id = 9);
DELETE FROM town.car WHERE car_id = 9;
SELECT 'half of a way onto a lane is refused', test.state($q$INSERT INTO town.car (axis_id, abscissa, lane_position, along_axis, onto_axis) VALUES (1, 50, 4, true, 2)$q$) = '23514';
UPDATE town.axis SET width = 13.6 WHERE axis_id = 1;
SELECT 'an edit leaves cars where they are', (SELECT abs(ST_X(geom) - 650040) < 0.01 FROM town.car_place WHERE car_id = 1);
SELECT 'cars are placed as densely as asked', streetgen.place_cars('town', 20) BETWEEN 50 AND 80 AND (SELECT count(*) FROM town.car) = (SELECT count(*) FROM town.car_place);
CREATE TEMPORARY TABLE placed AS SELECT axis_id, abscissa, lane_position FROM town.car;
SELECT 'the same seed places the same cars, another one others', streetgen.place_cars('town', 20) > 0 AND NOT EXISTS (SELECT axis_id, abscissa, lane_position FROM town.car EXCEPT TABLE placed)
    AND streetgen.place_cars('town', 20, 7) > 0;
SELECT 'each car alone has the leader that it has among all', count(*) > 5 AND bool_and((o.leader, o.virtual, o.gap, o.distance, o.speed) IS NOT DISTINCT FROM (l.leader, l.virtual, l.gap, l.distance, l.speed)) AND bool_and(streetgen.get_free_dist('town', l.car_id, 20) = l.gap)
  FROM streetgen.leaders('town', 20) l LEFT JOIN LATERAL streetgen.get_leader('town', l.car_id, 20) o ON true WHERE l.car_id % 8 = 0;
UPDATE town.setting SET value = 'by_place' WHERE name = 'merging_leader';
SELECT 'also where others merge', count(*) > 5 AND bool_and((o.leader, o.virtual, o.gap, o.distance, o.speed) IS NOT DISTINCT FROM (l.leader, l.virtual, l.gap, l.distance, l.speed))
  FROM streetgen.leaders('town', 50) l LEFT JOIN LATERAL streetgen.get_leader('town', l.car_id, 50) o ON true WHERE l.car_id % 8 = 1;
UPDATE town.setting SET value = CASE name WHEN 'virtual_car' THEN 'stationary' ELSE 'none' END WHERE name IN ('virtual_car', 'merging_leader');
SELECT 'and at a short horizon with a car that stands there', bool_or(l.virtual = 'stationary' AND l.gap = 30) AND bool_and((o.leader, o.virtual, o.gap, o.speed) IS NOT DISTINCT FROM (l.leader, l.virtual, l.gap, l.speed))
  FROM streetgen.leaders('town', 0, 30) l LEFT JOIN LATERAL streetgen.get_leader('town', l.car_id, 0, 30) o ON true WHERE l.car_id % 8 = 0;
UPDATE town.setting SET value = 'moving' WHERE name = 'virtual_car';
SELECT 'a leader of nobody is refused', test.said($q$SELECT * FROM streetgen.get_leader('town', 77)$q$) = 'there is no car 77' AND test.state($q$SELECT * FROM streetgen.get_leader('town', 1, horizon => -1)$q$) = '22023';
SELECT 'they differ', EXISTS (SELECT axis_id, abscissa, lane_position FROM town.car EXCEPT TABLE placed);
SELECT 'more than fit are refused', test.state($q$SELECT streetgen.place_cars('town', 200)$q$) = '22023';

-- Routes.
SELECT 'without pgRouting a route is refused with the commands', (SELECT state = '0A000' AND hint LIKE '%CREATE EXTENSION pgrouting.' FROM test.refusal($q$SELECT * FROM streetgen.route('town', (SELECT min(link_id) FROM town.link), (SELECT max(link_id) FROM town.link))$q$));
SELECT test.as_administrator('CREATE EXTENSION pgrouting') \g /dev/null
CREATE TEMPORARY TABLE known AS SELECT * FROM pg_temp.quickest('town', ARRAY(SELECT link_id FROM town.link WHERE kind = 'lane'));
CREATE TEMPORARY TABLE asked AS SELECT k.origin, l.link_id AS link, r.links, r.seconds FROM (SELECT DISTINCT origin FROM known ORDER BY origin LIMIT 5) k, town.link l, LATERAL (
  SELECT array_agg(link_id ORDER BY ordinality) AS links, max(seconds) AS seconds FROM streetgen.route('town', k.origin, l.link_id)) r WHERE l.link_id % 5 = 1;
SELECT 'a route is as quick as plain SQL finds, and there is none where that finds none', count(*) > 20 AND count(a.seconds) > 5 AND count(*) > count(a.seconds) AND bool_and(abs(a.seconds - k.seconds) < 1e-9 IS NOT FALSE AND (a.seconds IS NULL) = (k.seconds IS NULL))
  FROM asked a LEFT JOIN known k USING (origin, link);
SELECT 'it has no gap, and changes lanes now and then', count(*) > 20 AND bool_and(next IS NULL OR o.comes_from = link OR o.link_id = l.leads_to OR a.change = 'allowed') AND bool_or(a.change = 'allowed') FROM (
    SELECT u.link, lead(u.link) OVER (PARTITION BY origin, asked.link ORDER BY n) AS next FROM asked, unnest(links) WITH ORDINALITY u(link, n)) p JOIN town.link l ON l.link_id = p.link
  LEFT JOIN town.link o ON o.link_id = p.next LEFT JOIN town.lane_adjacency a ON (a.lane_a, a.lane_b) = (l.lane_id, o.lane_id);
SELECT 'an unknown link is refused, and an unknown kind', test.said($q$SELECT * FROM streetgen.route('town', 7000001, 7000001)$q$) = 'there is no link 7000001' AND test.state($q$SELECT * FROM streetgen.route('town', 7000001, 7000001, 'ship')$q$) = '22023';
-- Cars on routes: one turns right from the lane beside the kerb, one comes there from the lane beside.
CREATE FUNCTION pg_temp.lane_link(axis bigint, lane integer, along boolean) RETURNS bigint LANGUAGE sql AS $$ SELECT k.link_id FROM town.link k JOIN town.lane l USING (lane_id) JOIN town.edge e USING (edge_id) WHERE (e.axis_id, l.lane_position, k.along_axis) = (axis, lane, along) $$;
CREATE FUNCTION pg_temp.way(from_link bigint, to_link bigint) RETURNS bigint[] LANGUAGE sql AS $$ SELECT array_agg(link_id ORDER BY ordinality) FROM streetgen.route('town', from_link, to_link) $$;
DELETE FROM town.car;
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, speed, route) VALUES (1, 1, 40, 4, true, 30, pg_temp.way(pg_temp.lane_link(1, 4, true), pg_temp.lane_link(3, 1, false))),
  (2, 3, 150, 1, false, 0, NULL), (3, 1, 20, 3, true, 30, pg_temp.way(pg_temp.lane_link(1, 3, true), pg_temp.lane_link(3, 1, false)));
SELECT 'a path follows a route, then goes straight on', bool_or(link_id = pg_temp.lane_link(3, 1, false)) AND NOT bool_or(link_id = pg_temp.lane_link(2, 4, true)) FROM town.car c, streetgen.free_path('town', pg_temp.lane_link(1, 4, true), 40, 500, c.route) WHERE car_id = 1;
SELECT 'so does who looks for a leader, alone too', bool_or(l.leader = 2) AND bool_and((o.leader, o.virtual, o.gap, o.speed) IS NOT DISTINCT FROM (l.leader, l.virtual, l.gap, l.speed)) FROM generate_series(0, 110, 20) s, streetgen.leaders('town', s) l, streetgen.get_leader('town', l.car_id, s) o WHERE l.car_id = 1;
SELECT 'before the place to change at stands a car', l.virtual = 'stationary' AND l.gap < 180 AND (o.virtual, o.gap) = (l.virtual, l.gap) FROM streetgen.leaders('town', 10) l, streetgen.get_leader('town', 3, 10) o WHERE l.car_id = 3;
DELETE FROM town.car WHERE car_id = 2;
SELECT 'both come to the end of their routes', count(DISTINCT car_id) = 2 FROM streetgen.simulate('town', 'idm', 150, 0.2) WHERE link = pg_temp.lane_link(3, 1, false);
UPDATE town.car SET route = ARRAY[route[1], route[cardinality(route)]] WHERE car_id = 1;
SELECT 'a route with a gap is refused with its car', test.said($q$SELECT * FROM streetgen.leaders('town')$q$) LIKE 'car 1: link % of the route neither follows link % nor lies beside it' AND test.said($q$SELECT count(*) FROM streetgen.simulate('town', 'idm', 1)$q$) LIKE 'car 1: link %'
    AND test.said($q$SELECT * FROM streetgen.get_leader('town', 1)$q$) LIKE 'link % of the route neither%' AND test.state($q$SELECT * FROM town.car c, streetgen.free_path('town', route[1], 0, 500, route)$q$) = '22023';
UPDATE town.car SET route = route || 7000001 WHERE car_id = 3;
SELECT 'so is one with a link that is gone', test.said($q$SELECT * FROM streetgen.leaders('town')$q$) = 'car 3: there is no link 7000001 of its route' AND test.said($q$SELECT * FROM streetgen.get_leader('town', 3)$q$) = 'car 3: there is no link 7000001 of its route';

-- Changes of lane.
DELETE FROM town.car;
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis) VALUES (1, 1, 50, 3, true), (2, 1, 53, 4, true), (3, 1, 60, 1, false);
SELECT 'nobody moves onto another one', test.said($q$SELECT streetgen.move_car('town', 1, 'right')$q$) = 'car 1 has no gap on its right' AND (SELECT lane_position = 3 FROM town.car WHERE car_id = 1);
UPDATE town.car SET abscissa = 43.5 WHERE car_id = 2;
SELECT 'nor closely before him', test.said($q$SELECT streetgen.move_car('town', 1, 'right')$q$) = 'car 1 has no gap on its right';
UPDATE town.car SET abscissa = 42.9 WHERE car_id = 2;
SELECT 'beside a gap a car moves, and stays at its place along the axis', streetgen.move_car('town', 1, 'right') = pg_temp.lane_link(1, 4, true);
SELECT 'which the table tells', (lane_position, abscissa) = (4, 50) FROM town.car WHERE car_id = 1;
SELECT 'sides are those of who drives', streetgen.move_car('town', 3, 'left') = pg_temp.lane_link(1, 2, false);
SELECT 'where no lane is, or traffic comes towards, a move is refused', test.said($q$SELECT streetgen.move_car('town', 1, 'right')$q$) = 'no lane lies on the right of car 1' AND test.said($q$SELECT streetgen.move_car('town', 3, 'left')$q$) = 'car 3 may not change to the lane on its left';
SELECT 'also over a solid line', test.state($q$UPDATE town.axis SET change_forward = 'no|no' WHERE axis_id = 1$q$) = 'none' AND test.said($q$SELECT streetgen.move_car('town', 1, 'left')$q$) = 'car 1 may not change to the lane on its left';
SELECT 'also of nobody, and to no side', test.said($q$SELECT streetgen.move_car('town', 77, 'left')$q$) = 'there is no car 77' AND test.state($q$SELECT streetgen.move_car('town', 1, 'up')$q$) = '22023';
-- Cars that are dragged, and those whose lane goes.
UPDATE town.car_editing SET geom = 'SRID=2154;POINT(650203 6860100)', speed = 20 WHERE car_id = 1;
SELECT 'a car that is dragged is on the nearest lane', (axis_id, lane_position, along_axis, speed) = (4, 2, true, 20) AND abs(abscissa - 100) < 0.01 AND ST_DWithin(p.geom, 'SRID=2154;POINT(650203 6860100)'::geometry, 1.5) FROM town.car JOIN town.car_place p USING (car_id) WHERE car_id = 1;
UPDATE town.car SET route = ARRAY[pg_temp.lane_link(1, 4, true)] WHERE car_id = 1;
SELECT 'a car off its route is found', array_agg(concat(id, ' ', rule)) = '{1 car that is not on its route}' FROM streetgen.check_model('town') WHERE relation = 'car';
\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=warning'
\! test "$(psql -qXAt -c "SELECT FROM streetgen.leaders('town')" -c "SELECT FROM streetgen.get_leader('town', 1)" 2>&1 | grep -oE '1 cars of table car stand on no link of their routes|car 1 stands on no link of its route' | wc -l)" = 2 && holds=t || holds=f; printf 'and leaders and get_leader warn of it\t%s\n' $holds
UPDATE town.car SET route = ARRAY[link_id] FROM town.car_place p WHERE p.car_id = 1 AND car.car_id = 1;
SELECT 'one that stands on its route is not', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'car');
\! test -z "$(psql -qXAt -c "SELECT FROM streetgen.get_leader('town', 1)" -c "SELECT FROM streetgen.leaders('town')" 2>&1 | grep WARNING)" && holds=t || holds=f; printf 'nor warned of\t%s\n' $holds
UPDATE town.car SET route = '{}' WHERE car_id = 1;
INSERT INTO town.car_editing (geom) VALUES ('SRID=2154;POINT(650100 6860005)');
SELECT 'a new point is a new car', (axis_id, lane_position, along_axis, length, kind) = (1, 1, false, 5, 'car') AND abs(abscissa - 100) < 0.01 FROM town.car WHERE car_id NOT IN (1, 2, 3);
INSERT INTO town.car_editing (car_id, geom) VALUES (50, 'SRID=2154;POINT(650120 6860005)');
SELECT 'under the key that it is given', test.state($q$INSERT INTO town.car_editing (car_id, geom) VALUES (1, 'SRID=2154;POINT(650100 6860005)')$q$) = '23505' AND EXISTS (SELECT FROM town.car WHERE car_id = 50 AND abs(abscissa - 120) < 0.01);
CREATE ROLE traffic_editor ROLE CURRENT_USER;
DO $$ BEGIN PERFORM streetgen.grant('town', 'traffic_editor', 'editor'); END $$;
SET ROLE traffic_editor;
INSERT INTO town.car_editing (geom) VALUES ('SRID=2154;POINT(650120 6860005)');
RESET ROLE;
SELECT 'an editor draws one too, and its key goes on after those by hand', max(car_id) > 50 FROM town.car;
DELETE FROM town.car_editing WHERE car_id NOT IN (1, 2, 3);
SELECT 'which goes as it came', count(*) = 3 FROM town.car;
SELECT 'far from lanes no car is', test.said($q$UPDATE town.car_editing SET geom = 'SRID=2154;POINT(650000 6870000)' WHERE car_id = 1$q$) = 'car 1 has no lane within 20 m' AND test.state($q$UPDATE town.car_editing SET geom = NULL WHERE car_id = 1$q$) = '22023';
SELECT 'what follows from the point is not typed', test.state($q$UPDATE town.car_editing SET abscissa = 3 WHERE car_id = 1$q$) = '0A000';
SELECT 'cars on their lanes are sound', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'car');
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, route) VALUES (4, 77, 10, 1, true, NULL), (5, 2, 50, 3, true, '{7000001}');
UPDATE town.axis SET lane_count = 2, change_forward = NULL WHERE axis_id = 1;
CREATE TEMPORARY TABLE found AS SELECT rule, id, geom FROM streetgen.check_model('town') WHERE relation = 'car';
SELECT 'cars whose lane or axis is gone are found, and routes', array_agg(concat(id, ' ', rule) ORDER BY id) = '{2 car without its lane,3 car without its lane,4 car without its axis,5 car whose route has links that are gone}' FROM found;
SELECT 'at their place on the axis', ST_DWithin(geom, 'SRID=2154;POINT(650042.9 6860000)'::geometry, 0.01) FROM found WHERE id = 2;
UPDATE town.car_editing SET geom = ST_Translate(geom, 0, -2) WHERE car_id = 2;
SELECT 'and are dragged back from there', (SELECT (axis_id, lane_position) = (1, 2) FROM town.car WHERE car_id = 2) AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'car' AND id = 2);
UPDATE town.axis SET lane_count = 4 WHERE axis_id = 1;

-- Simulations.
DO $$ BEGIN PERFORM streetgen.place_cars('town', 5); END $$;
CREATE TEMPORARY TABLE driven AS SELECT * FROM streetgen.simulate('town', 'idm', 90, 0.1, '{"flow": 300}', options => '{"output": 0.5}');
SELECT 'cars come in and drive', count(DISTINCT car_id) > 25 AND max(t) = 90 AND count(DISTINCT t) = 181 AND bool_and(speed BETWEEN 0 AND 51) AND max(speed) > 40 FROM driven;
SELECT 'nobody stands on another one', NOT EXISTS (SELECT FROM (SELECT metres - lead(metres) OVER (PARTITION BY t, link ORDER BY metres DESC) AS apart FROM driven) d WHERE apart < 5 - 1e-6);
SELECT 'nobody jumps', NOT EXISTS (SELECT FROM (SELECT ST_Distance(geom, lead(geom) OVER (PARTITION BY car_id ORDER BY t)) AS far FROM driven) d WHERE far > 51 / 3.6 * 0.5 + 3.6);
SELECT 'the same seed gives the same rows', NOT EXISTS (TABLE driven EXCEPT SELECT * FROM streetgen.simulate('town', 'idm', 90, 0.1, '{"flow": 300}', options => '{"output": 0.5}'));
SELECT 'a flow through cells keeps its cars', abs(sum(density * ST_Length(geom)) FILTER (WHERE t = 0) / 1000 - (SELECT count(*) FROM town.car_place)) < 0.6 AND count(DISTINCT t) = 11 AND bool_and(car_id IS NULL AND density BETWEEN 0 AND 143)
  FROM streetgen.simulate('town', 'lwr', 10, 0.1, '{}');
SELECT 'so does arz', count(*) > 0 AND bool_and(density BETWEEN 0 AND 143 AND speed BETWEEN 0 AND 51) FROM streetgen.simulate('town', 'arz', 10, 0.1, '{"flow": 300}');
SELECT 'a step of cells that is too long is told with the greatest one', test.said($q$SELECT count(*) FROM streetgen.simulate('town', 'lwr', 10, 60)$q$) ~ 'step 60 s .* [0-9]';
SELECT 'another method is refused', test.state($q$SELECT count(*) FROM streetgen.simulate('town', 'magic')$q$) = '22023';
SELECT 'so is a demand with a word that nobody knows', test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"flows": 3}')$q$) = 'demand has no "flows"';
SELECT 'so are entries at no link', test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"entries": [{"link": 77777, "flow": 3}]}')$q$) = 'there is no link 77777';
SELECT 'and NaN', test.state($q$SELECT count(*) FROM streetgen.simulate('town', duration => 'NaN')$q$) = '22023' AND test.state($q$SELECT count(*) FROM streetgen.simulate('town', step => 3600)$q$) = '22023';
CREATE TEMPORARY TABLE kept AS SELECT streetgen.keep_simulation('town', 'a', 'idm', 5) AS rows;
SELECT 'a run is kept by its name', rows > 0 AND rows = (SELECT count(*) FROM town.simulated WHERE run = 'a' AND car_id IS NOT NULL) FROM kept;
UPDATE kept SET rows = streetgen.keep_simulation('town', 'a', 'lwr', 5, 0.1);
SELECT 'and a new one replaces it', rows > 0 AND rows = (SELECT count(*) FROM town.simulated WHERE car_id IS NULL) AND rows = (SELECT count(*) FROM town.simulated) FROM kept;
-- Traffic in pictures.
DO $$ BEGIN PERFORM streetgen.keep_simulation('town', 'driven', 'idm', 20, 0.1, '{"flow": 600}', options => '{"output": 0.5}'), streetgen.keep_simulation('town', 'flow', 'lwr', 5, 0.1, '{"flow": 600}'); END $$;
CREATE TEMPORARY TABLE seen AS SELECT s.*, k.kind AS on_kind, k.geom AS line, streetgen._standing_car(s.geom, s.heading, s.length, s.width) AS ground FROM town.simulated s JOIN town.link k USING (link_id) WHERE run = 'driven';
SELECT 'a car is a rectangle of its length and width, its front in the middle of one side', count(*) > 500 AND bool_and(abs(ST_Area(ST_MakePolygon(ST_ExteriorRing(ground))) - length * width) < 1e-6 AND (length, width, kind) = (5, 1.8::real::float8, 'car')
    AND ST_Distance(ST_ExteriorRing(ground), geom) < 1e-6 AND abs(ST_Distance(ST_Centroid(ST_ExteriorRing(ground)), geom) - length / 2) < 1e-6) FROM seen;
SELECT 'on a lane it heads as the lane does', count(*) > 300 AND bool_and(abs(mod((heading - degrees(pi() / 2 - ST_Azimuth(ST_StartPoint(line), ST_EndPoint(line))) + 900)::numeric, 360) - 180) < 0.1) FROM seen WHERE on_kind = 'lane' AND metres BETWEEN 12 AND ST_Length(line) - 3;
SELECT 'its rear is on the way that it came, in a turn too', count(*) > 10 AND bool_and(least(ST_Distance(line, rear), (SELECT min(ST_Distance(l.geom, rear)) FROM town.link k JOIN town.link l ON l.link_id = k.comes_from WHERE k.link_id = seen.link_id)) < 0.4)
  FROM seen, LATERAL (SELECT ST_Translate(ST_Force2D(geom), -length * cosd(heading), -length * sind(heading)) AS rear) r WHERE on_kind = 'movement';
CREATE FUNCTION pg_temp.cars_of(svg text) RETURNS bigint LANGUAGE sql AS $$ SELECT count(*) FROM regexp_matches(svg, '<g class="car"[^>]*>(.*?)</g>', 'g') g, regexp_matches(g[1], '<path', 'g') $$;
SELECT 'a picture of a run has each car at that time', n > 0 AND pg_temp.cars_of(streetgen.svg('town', run => 'driven', at => 10.2)) = n FROM (SELECT count(*) AS n FROM seen WHERE t = 10) c;
SELECT 'without a run it has the cars of table car', n > 0 AND pg_temp.cars_of(streetgen.svg('town')) = n FROM (SELECT count(*) AS n FROM town.car_place) c;
SELECT 'a run of cells is drawn by how dense it is', svg LIKE '%class="density free"%' AND pg_temp.cars_of(svg) = 0 AND streetgen.svg('town', run => 'flow', at => 5, legend => true) LIKE '%up to 15 cars a kilometre%' FROM streetgen.svg('town', run => 'flow', at => 5) svg;
SELECT 'before a run nothing of it is there', pg_temp.cars_of(streetgen.svg('town', run => 'driven', at => -1)) = 0;
SELECT 'a run that was not kept is refused with those that were', state = '22023' AND hint LIKE '%''driven''%' FROM (VALUES ($q$svg('town', run => 'b')$q$), ($q$animated_svg('town', 'b')$q$)) v(call), test.refusal('SELECT streetgen.' || call);
SELECT 'so are a time and a pace that are none', bool_and(state = '22023' AND hint <> '') FROM (VALUES ($q$svg('town', at => 'NaN')$q$), ($q$animated_svg('town', 'driven', pace => 0)$q$)) v(call), test.refusal('SELECT streetgen.' || call);
CREATE TEMPORARY TABLE moving AS SELECT streetgen.animated_svg('town', 'driven', pace => 2) AS svg, streetgen.animated_svg('town', 'flow') AS flow;
SELECT 'a picture that moves is XML with every car of the run', xml_is_well_formed_document(svg) AND pg_temp.cars_of(svg) = (SELECT count(DISTINCT car_id) FROM seen) AND svg LIKE '%dur="10s"%' AND flow LIKE '%calcMode="discrete"%' AND xml_is_well_formed_document(flow) FROM moving;
SELECT 'its times grow from 0 to 1, a place for each', count(*) > 20 AND bool_and(times[1] = 0 AND times[cardinality(times)] = 1 AND times = ARRAY(SELECT DISTINCT t FROM unnest(times) t ORDER BY t) AND cardinality(times) = cardinality(string_to_array(m[1], ';')))
  FROM moving, regexp_matches(svg, 'type="translate"[^>]* values="([^"]*)" keyTimes="([^"]*)"', 'g') m, LATERAL (SELECT string_to_array(m[2], ';')::float8[] AS times) k;
SELECT 'no car spins between two states', bool_and(abs(b::float8 - a::float8) < 120) FROM moving, regexp_matches(svg, 'type="rotate"[^>]* values="([^"]*)"', 'g') m, LATERAL (SELECT v AS a, lead(v) OVER (ORDER BY n) AS b FROM string_to_table(m[1], ';') WITH ORDINALITY s(v, n)) p;
UPDATE town.simulated SET (heading, length, width, kind) = (NULL, NULL, NULL, NULL);
SELECT 'a run of cars without heading, of an older build, is refused with the call that keeps it anew', count(*) = 2 AND bool_and(state = '22023' AND hint LIKE '%keep_simulation(''town'', ''driven'')%') FROM (VALUES ($q$svg('town', run => 'driven', at => 10)$q$), ($q$animated_svg('town', 'driven')$q$)) v(call), test.refusal('SELECT streetgen.' || call);
SELECT 'one of cells is drawn', streetgen.svg('town', run => 'flow', at => 5) LIKE '%class="density free"%';

-- Cells.
CREATE TEMPORARY TABLE cell AS SELECT * FROM streetgen.cells('town');
SELECT 'each link is cut into equal cells of about the size', count(*) > 30 AND bool_and(abs(cells * each - greatest(length, 1e-7)) < 1e-6 AND cells = greatest(1, floor(length / 10 + 0.5)) AND spread < 1e-9)
  FROM (SELECT link_id, count(*) AS cells, avg(ends - starts) AS each, max(ends - starts) - min(ends - starts) AS spread FROM cell GROUP BY link_id) c JOIN town.link USING (link_id);
SELECT 'all links have some', (SELECT count(DISTINCT link_id) FROM cell) = (SELECT count(*) FROM town.link);
SELECT 'a cell comes before those that it leads to', count(*) > 100 AND NOT EXISTS (SELECT cell_id, unnest(next) FROM cell EXCEPT SELECT unnest(before), cell_id FROM cell) AND NOT EXISTS (SELECT unnest(before), cell_id FROM cell EXCEPT SELECT cell_id, unnest(next) FROM cell) FROM cell;
SELECT 'cells go on where links do', NOT EXISTS (SELECT FROM cell a, unnest(a.next) n JOIN cell b ON b.cell_id = n WHERE a.link_id <> b.link_id AND NOT EXISTS (SELECT FROM town.link k WHERE (k.link_id = a.link_id AND k.leads_to = b.link_id) OR (k.link_id = b.link_id AND k.comes_from = a.link_id)));
SELECT 'the cell beside has this one beside it, or its neighbour', count(*) > 20 AND bool_and(abs(CASE WHEN a.opposite_left THEN b.at_left ELSE b.at_right END - a.cell_id) <= 1 AND (a.opposite_left OR a.may_go_left = b.may_go_right)) FROM cell a JOIN cell b ON b.cell_id = a.at_left;
SELECT 'simulate counts cells alike', count(*) > 100 AND bool_and(c.link_id = s.link AND abs(s.metres - (c.starts + c.ends) / 2) < 1e-6) FROM streetgen.simulate('town', 'lwr', 0.1, 0.1) s JOIN cell c USING (cell_id);
SELECT 'a size that is none is refused', bool_and(test.state('SELECT count(*) FROM streetgen.cells(''town'', ' || size || ')') = '22023') FROM unnest('{0,-1,"''NaN''",1e9}'::text[]) size;

-- A law of one's own.
CREATE FUNCTION idm(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$
    SELECT array_agg(0.73 * (1 - share * share * share * share - near * near) ORDER BY n) FROM unnest(cars) WITH ORDINALITY c(speed, desired, gap, leader, acceleration, n),
    LATERAL (SELECT speed / desired AS share, CASE WHEN gap < 'Infinity' THEN (2 + greatest(0, speed * 1.6 + speed * (speed - leader) / (2 * sqrt(0.73 * 1.67::float8)))) / greatest(gap, 0.001) ELSE 0 END AS near) r $$;
SELECT 'the Intelligent Driver Model in SQL drives as the one that is there', count(*) > 200 AND count(*) FILTER (WHERE num_nulls(a.car_id, b.car_id) > 0) = 0 AND bool_and(a.link = b.link AND abs(a.metres - b.metres) < 1e-9 AND abs(a.speed - b.speed) < 1e-9)
  FROM streetgen.simulate('town', 'public.idm', 20, 0.2, '{"flow": 400}') a FULL JOIN streetgen.simulate('town', 'idm', 20, 0.2, '{"flow": 400}') b USING (t, car_id);
CREATE FUNCTION slow(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$ SELECT array_agg(-speed ORDER BY n) FROM unnest(cars) WITH ORDINALITY c(speed, desired, gap, leader, acceleration, n) $$;
SELECT 'another law drives otherwise', max(speed) < 0.1 FROM streetgen.simulate('town', 'public.slow', 20, 0.2) WHERE t = 20;
CREATE FUNCTION broken(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$ SELECT ARRAY[1 / (cardinality(cars) - cardinality(cars))]::float8[] $$;
CREATE FUNCTION short(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$ SELECT '{}'::float8[] $$;
CREATE FUNCTION nan(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$ SELECT array_agg('NaN'::float8) FROM unnest(cars) $$;
CREATE FUNCTION nothing(cars streetgen.following[]) RETURNS float8[] LANGUAGE sql IMMUTABLE AS $$ SELECT NULL::float8[] $$;
CREATE FUNCTION words(cars streetgen.following[]) RETURNS text LANGUAGE sql IMMUTABLE AS $$ SELECT 'a' $$;
SELECT 'what goes wrong in a law is told with its name: ' || law, r.state = v.state AND r.said LIKE '%' || law || '%' || v.said || CASE v.said WHEN '' THEN '%' ELSE '' END FROM (VALUES ('broken', '22012', 'division by zero'), ('short', '2202E', 'it gives 0 accelerations for % cars'), ('nan', '22023', 'that is not finite for a car at%'),
    ('nothing', '22004', 'it gives NULL'), ('words', '22023', '')) v(law, state, said), test.refusal(format($q$SELECT count(*) FROM streetgen.simulate('town', 'public.%s', 1)$q$, law)) r;
REVOKE EXECUTE ON FUNCTION slow(streetgen.following[]) FROM PUBLIC;
CREATE ROLE traffic_reader ROLE CURRENT_USER;
DO $$ BEGIN PERFORM streetgen.grant('town', 'traffic_reader', 'reader'); END $$;
SET ROLE traffic_reader;
SELECT 'a law that one may not run is refused', state = '42501' AND hint LIKE 'GRANT EXECUTE%' FROM test.refusal($q$SELECT count(*) FROM streetgen.simulate('town', 'public.slow', 1)$q$);
SELECT 'and where it is run: ' || law, state = expected FROM (VALUES ('''public.slow''::regproc', '42501'), ('''pg_catalog.pi''::regproc', '22023'), ('''pg_catalog.array_to_string(anyarray,text)''::regprocedure', '22023'), ('4294967290', '22023')) v(law, expected),
    test.refusal(format($q$SELECT count(*) FROM streetgen._simulate(streetgen._network_of_links('town'), '{}', '{}', '{}', '{}', '{}', '{}', 'idm', 1, 0.1, 1, 1, %s, '{}')$q$, law));
RESET ROLE;
DROP OWNED BY traffic_reader, traffic_editor;
DROP ROLE traffic_reader, traffic_editor;

-- Edits bring new keys: the same pairs of lanes meet as in a model made from scratch.
DO $$ BEGIN
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, speed) OVERRIDING SYSTEM VALUE VALUES (7, 'SRID=2154;LINESTRING(650200 6860000,650120 6860120)', 6, 2, 'both', 5, 30), (8, 'SRID=2154;LINESTRING(650400 6860000,650400 6859850)', 6, 2, 'both', 5, 30);
  PERFORM streetgen.create_model('anew', 2154, subjects => '{junction,signal}', driving_side => 'right');
  INSERT INTO anew.axis SELECT * FROM town.axis;
  INSERT INTO anew.control_point (kind, geom) VALUES ('signals', 'SRID=2154;POINT(650200 6860000)');
  PERFORM streetgen.generate('anew', wait => true);
END $$;
CREATE FUNCTION pg_temp.pairs(model name) RETURNS TABLE(pair text) LANGUAGE plpgsql AS $f$ BEGIN
  RETURN QUERY EXECUTE format($q$WITH named AS (SELECT m.link_id, concat(e.axis_id, '/', i.lane_position, '/', m.along_in, '>', f.axis_id, '/', o.lane_position, '/', m.along_out) AS name FROM %1$I.link m
    JOIN %1$I.lane i ON i.lane_id = m.lane_in JOIN %1$I.edge e ON e.edge_id = i.edge_id JOIN %1$I.lane o ON o.lane_id = m.lane_out JOIN %1$I.edge f ON f.edge_id = o.edge_id)
    SELECT concat(a.name, ' ', b.name, ' ', c.precedence) FROM streetgen.link_conflicts(%1$L) c JOIN named a ON a.link_id = c.link JOIN named b ON b.link_id = c.other$q$, model); END $f$;
SELECT 'after edits the same movements meet as from scratch', count(*) > 100 AND NOT EXISTS ((SELECT pg_temp.pairs('town') EXCEPT SELECT pg_temp.pairs('anew')) UNION ALL (SELECT pg_temp.pairs('anew') EXCEPT SELECT pg_temp.pairs('town'))) FROM pg_temp.pairs('town');

-- Odd numbers end soon, and say what is wrong.
SET statement_timeout = '5s';
SELECT 'an output that is hardly above 0 gives each step', count(DISTINCT t) = 3 FROM streetgen.simulate('town', 'idm', 1, 0.5, '{"flow": 300}', options => '{"output": 1e-300}') WHERE (SELECT streetgen.place_cars('town', 5)) > 0;
RESET statement_timeout;
SELECT 'a step too short for the duration is refused', test.said($q$SELECT count(*) FROM streetgen.simulate('town', 'idm', 10, 1e-300)$q$) = 'step 1e-300 s is too short for a duration of 10 s';
SELECT 'a demand that is no object too', test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '[1]')$q$) = 'demand is a JSON array, expected an object';
SELECT 'so are entries without numbers, a flow in words, and both at once', test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"entries": [{"link": 5}]}')$q$) = 'element 1 of entries has no number "flow"'
    AND test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"entries": 1}')$q$) = 'entries is a JSON number, expected an array' AND test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"flow": "a"}')$q$) = 'flow is "a", expected a number'
    AND test.said($q$SELECT count(*) FROM streetgen.simulate('town', demand => '{"flow": 1, "entries": []}')$q$) = 'demand has flow and entries';
DELETE FROM town.car;
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis, onto_axis, onto_position, onto_along, beyond) VALUES (1, 1, 195, 4, true, 2, 4, true, 1);
INSERT INTO town.car (car_id, axis_id, abscissa, lane_position, along_axis) VALUES (2, 1, 190, 4, true);
SELECT 'cars that stand on each other over a joint are named', test.said($q$SELECT count(*) FROM streetgen.simulate('town', 'idm', 1)$q$) LIKE 'cars _ and _ stand on each other%';

-- Heights, and a subject that goes.
DO $$ BEGIN
  PERFORM streetgen.create_model('hill', 2154, 3, subjects => '{interconnection}', driving_side => 'right');
  INSERT INTO hill.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000 0,650100 6860000 0)', 7, 2), ('SRID=2154;LINESTRING(650100 6860000 0,650200 6860000 4)', 7, 2);
  PERFORM streetgen.generate('hill', wait => true);
  PERFORM streetgen.create_traffic('hill');
END $$;
SELECT 'where heights are known each row has one, 0 too', count(*) > 0 AND bool_and(ST_NDims(geom) = 3) FROM streetgen.simulate('hill', 'idm', 20, 0.5, '{"flow": 600}');
SELECT 'and is kept with it', streetgen.keep_simulation('hill', 'a', 'idm', 20, 0.5, '{"flow": 600}') > 0 AND streetgen.keep_simulation('hill', 'b', 'lwr', 5, 0.1, '{"flow": 600}') > 0;
SELECT 'traffic without links says so', test.state($q$SELECT streetgen.switch_subject('hill', 'interconnection', false)$q$) = 'none' AND test.state($q$SELECT * FROM streetgen.leaders('hill')$q$) = '55000'
    AND test.state($q$SELECT streetgen.place_cars('hill', 5)$q$) = '55000' AND test.state($q$SELECT count(*) FROM streetgen.simulate('hill')$q$) = '55000';
SELECT 'tables of traffic go as they came', test.state($q$SELECT streetgen.create_traffic('town')$q$) = '55000' AND test.state($q$SELECT streetgen.drop_traffic('town')$q$) = 'none' AND to_regclass('town.car') IS NULL
    AND test.state($q$SELECT * FROM streetgen.leaders('town')$q$) = '55000';
