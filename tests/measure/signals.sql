-- What a traffic engineer asks of the signals of the model of variable model, a row a figure with its bar.
-- Run as psql -v model=NAME -f tests/measure/signals.sql; subject signal is on. Paths and times are read from the
-- model, and what meets is found by geometry again. Table `fault` has the places afterwards, by figure.
\set ON_ERROR_STOP on
SET client_min_messages = warning;
CREATE TEMPORARY TABLE fault (figure text, controller_id bigint, ordinality integer, value float8, of_what text);
CREATE TEMPORARY TABLE state AS
SELECT s.*, sum(duration) OVER w - duration AS starts, sum(duration) OVER w AS ends, c.cycle
FROM :"model".signal_state s JOIN :"model".controller c USING (controller_id)
WINDOW w AS (PARTITION BY controller_id ORDER BY ordinality);
CREATE TEMPORARY TABLE path AS
SELECT m.junction_id AS controller_id, m.lane_in, m.lane_out, m.along_in, m.along_out, m.turn, m.geom,
    row_number() OVER () AS number, i.edge_id AS edge_in, o.edge_id AS edge_out,
    greatest(e.speed, 1) / 3.6 AS speed, a.kind = 'service' AS service,
    coalesce((SELECT ST_Distance(k.geom, ST_StartPoint(m.geom)) FROM :"model".marking k
        WHERE (k.edge_id, k.lane_position, k.along_axis, k.kind) = (i.edge_id, i.lane_position, m.along_in, 'stop')), 0)
        AS before
FROM :"model".movement m JOIN :"model".controller c ON c.controller_id = m.junction_id
    JOIN :"model".lane i ON i.lane_id = m.lane_in JOIN :"model".lane o ON o.lane_id = m.lane_out
    JOIN :"model".edge e ON e.edge_id = i.edge_id JOIN :"model".axis a USING (axis_id)
WHERE m.connecting;
CREATE INDEX ON path (controller_id);
CREATE TEMPORARY TABLE green AS
SELECT s.controller_id, s.ordinality, p.number, s.right_of_way, s.precedence
FROM :"model".signal_movement s JOIN path p USING (controller_id, lane_in, lane_out, along_in, along_out);
CREATE INDEX ON green (controller_id, ordinality);
CREATE INDEX ON green (number);
ANALYZE path, green, state;

-- Paths that meet, with the metres from the stop line to where they do along each; none from one lane.
CREATE TEMPORARY TABLE meeting AS
SELECT a.controller_id, a.number AS a, b.number AS b,
    a.before + ST_Length(a.geom) * ST_LineLocatePoint(a.geom, place) AS metres_a,
    b.before + ST_Length(b.geom) * ST_LineLocatePoint(b.geom, place) AS metres_b
FROM path a JOIN path b USING (controller_id), LATERAL (SELECT ST_ClosestPoint(a.geom, b.geom) AS place) p
WHERE a.number <> b.number AND (a.lane_in, a.along_in) <> (b.lane_in, b.along_in)
    AND ((a.lane_out, a.along_out) = (b.lane_out, b.along_out) OR ST_Intersects(a.geom, b.geom));
CREATE INDEX ON meeting (a, b);
ANALYZE meeting;
INSERT INTO fault SELECT 'pairs that meet in one state without who yields', m.controller_id, x.ordinality, 0,
    concat_ws(' ', m.a, m.b)
FROM meeting m JOIN green x ON x.number = m.a JOIN green y ON y.number = m.b AND y.ordinality = x.ordinality
WHERE m.a < m.b AND (x.right_of_way, y.right_of_way) <> ('protected', 'permitted')
    AND (x.right_of_way, y.right_of_way) <> ('permitted', 'protected')
    AND ('protected' IN (x.right_of_way, y.right_of_way) OR x.precedence IS NOT DISTINCT FROM y.precedence);

-- What drives over a crossing: who comes in from there, goes straight out there, or passes within the junction.
CREATE TEMPORARY TABLE over AS
SELECT c.junction_id AS controller_id, c.control_point_id, c.edge_id, c.width, p.number
FROM :"model".junction_crossing c JOIN path p ON p.controller_id = c.junction_id
WHERE p.edge_in = c.edge_id OR p.edge_out = c.edge_id AND p.turn = 'through'
    OR c.inside AND ST_DWithin(p.geom, c.geom, c.width / 2);
CREATE TEMPORARY TABLE walk AS SELECT w.*, s.starts FROM :"model".signal_crossing w
    JOIN state s USING (controller_id, ordinality);
-- The start of the next state in which somebody drives over it, from the start of the state in which people walk.
CREATE TEMPORARY TABLE cross_traffic AS
SELECT w.controller_id, w.ordinality, w.control_point_id, w.edge_id, min(s.starts
    + CASE WHEN s.starts < w.starts + 1e-6 THEN s.cycle ELSE 0 END) AS begins
FROM walk w JOIN over o USING (controller_id, control_point_id, edge_id)
    JOIN green g ON g.number = o.number
    JOIN state s ON (s.controller_id, s.ordinality) = (w.controller_id, g.ordinality)
GROUP BY w.controller_id, w.ordinality, w.control_point_id, w.edge_id;
INSERT INTO fault SELECT 'walkers not clear before cross traffic starts', controller_id, ordinality,
    w.walk_until + c.width / 1.2 - t.begins, concat_ws(' ', control_point_id, edge_id)
FROM walk w JOIN :"model".junction_crossing c USING (control_point_id, edge_id)
    JOIN cross_traffic t USING (controller_id, ordinality, control_point_id, edge_id)
WHERE c.junction_id = w.controller_id AND w.walk_until + c.width / 1.2 > t.begins + 1e-6;
INSERT INTO fault SELECT 'crossings at signals where people never walk', c.junction_id, NULL, c.width,
    concat_ws(' ', c.control_point_id, c.edge_id)
FROM :"model".junction_crossing c JOIN :"model".controller k ON k.controller_id = c.junction_id
WHERE NOT EXISTS (SELECT FROM walk w WHERE (w.controller_id, w.control_point_id, w.edge_id)
    = (c.junction_id, c.control_point_id, c.edge_id));

-- Crossings of an arm lie before its stop lines. One behind a line, or off the street, is another's.
INSERT INTO fault SELECT 'crossings behind a stop line, or off their street', c.junction_id, NULL,
    max(CASE WHEN off > 0.5 THEN off ELSE behind END), concat_ws(' ', c.control_point_id, c.edge_id)
FROM :"model".junction_crossing c JOIN :"model".controller k ON k.controller_id = c.junction_id
    JOIN :"model".edge e USING (edge_id) CROSS JOIN LATERAL (SELECT ST_Distance(e.geom, c.geom) AS off) d
    LEFT JOIN LATERAL (
        SELECT (ST_LineLocatePoint(e.geom, c.geom) - ST_LineLocatePoint(e.geom, ST_Centroid(m.geom)))
            * ST_Length(e.geom) * CASE WHEN e.from_node = c.node_id THEN 1 ELSE -1 END AS behind
        FROM :"model".marking m WHERE m.edge_id = c.edge_id AND m.kind = 'stop') m ON true
WHERE NOT c.inside AND (off > 0.5 OR behind > 0.5)
GROUP BY c.junction_id, c.control_point_id, c.edge_id;

-- A change is what lies between two states that somebody has green or walks in.
CREATE TEMPORARY TABLE change AS
SELECT s.controller_id, s.ordinality, n.ordinality AS next, n.amber, n.all_red
FROM state s CROSS JOIN LATERAL (
    SELECT sum(t.duration) FILTER (WHERE t.kind = 'amber') AS amber,
        coalesce(sum(t.duration) FILTER (WHERE t.kind = 'all_red'), 0) AS all_red, min(next) AS ordinality
    FROM (SELECT t.*, (SELECT coalesce(min(u.ordinality) FILTER (WHERE u.ordinality > s.ordinality), min(u.ordinality))
            FROM state u WHERE u.controller_id = s.controller_id AND u.kind IN ('green', 'walk')) AS next
        FROM state t WHERE t.controller_id = s.controller_id) t
    WHERE CASE WHEN next > s.ordinality THEN t.ordinality > s.ordinality AND t.ordinality < next
        ELSE t.ordinality > s.ordinality OR t.ordinality < next END) n
WHERE s.kind = 'green';
INSERT INTO fault SELECT 'changes with all red over 6 s', controller_id, ordinality, all_red, '' FROM change
WHERE all_red > 6 + 1e-6;
-- Who enters at the end of amber has left before who begins comes to where they meet. All leave
-- at 30 km/h at least; in a turn faster as far as 3 m/s2 sideways allow in a quarter of a circle.
INSERT INTO fault SELECT 'changes too short for pairs that meet', c.controller_id, c.ordinality,
    max((m.metres_a + 5) / across.a - m.metres_b / across.b - c.all_red), ''
FROM change c JOIN green x USING (controller_id, ordinality) JOIN meeting m ON m.a = x.number
    JOIN green y ON y.number = m.b AND y.ordinality = c.next JOIN path p ON p.number = m.a
    JOIN path q ON q.number = m.b, LATERAL (SELECT CASE p.turn WHEN 'through' THEN greatest(p.speed, 30 / 3.6)
        ELSE greatest(30 / 3.6, least(p.speed, sqrt(3 * ST_Length(p.geom) / (pi() / 2)))) END AS a,
        q.speed AS b) across
WHERE (m.metres_a + 5) / across.a - m.metres_b / across.b > c.all_red + 0.01 AND c.next <> c.ordinality
GROUP BY c.controller_id, c.ordinality;
INSERT INTO fault SELECT 'cycles over 120 s', controller_id, NULL, cycle, method FROM :"model".controller
WHERE cycle > 120 + 1e-6;
INSERT INTO fault SELECT 'states of broken seconds', controller_id, ordinality, duration, kind FROM state
WHERE abs(duration - round(duration)) > 1e-6;
INSERT INTO fault SELECT 'phases of service arms alone', controller_id, ordinality, NULL, ''
FROM green JOIN path p USING (controller_id, number) GROUP BY controller_id, ordinality
HAVING bool_and(p.service) AND NOT (SELECT bool_and(q.service) FROM path q WHERE q.controller_id = green.controller_id);
-- A turn across traffic that comes towards it: it begins beside, and ends on the other side.
INSERT INTO fault SELECT DISTINCT 'turns over three lanes, of two lanes, or from 70 km/h on without a phase',
    g.controller_id, g.ordinality, NULL::float8, concat_ws(' ', p.edge_in, p.edge_out)
FROM green g JOIN path p USING (controller_id, number) CROSS JOIN LATERAL (
    SELECT q.edge_in, count(DISTINCT q.lane_in) AS lanes, max(q.speed) AS speed
    FROM meeting m JOIN green h ON h.number = m.b AND h.ordinality = g.ordinality JOIN path q ON q.number = m.b
    WHERE m.a = g.number AND q.turn = 'through' AND q.edge_in <> p.edge_in AND NOT q.service
    GROUP BY q.edge_in) t
WHERE NOT p.service AND p.turn IN ('left', 'right') AND (t.lanes >= 3 OR greatest(t.speed, p.speed) * 3.6 >= 70 - 1e-6
    OR (SELECT count(DISTINCT r.lane_in) FROM green h JOIN path r USING (controller_id, number)
        WHERE (h.controller_id, h.ordinality) = (g.controller_id, g.ordinality)
            AND (r.edge_in, r.turn) = (p.edge_in, p.turn)) >= 2);
SELECT asked AS figure, count(f.figure) AS found, of AS "of", bar, round(max(f.value)::numeric, 1) AS worst
FROM (VALUES (1, 'pairs that meet in one state without who yields', (SELECT count(*) FROM meeting m JOIN green x
        ON x.number = m.a JOIN green y ON y.number = m.b AND y.ordinality = x.ordinality WHERE m.a < m.b), 0),
    (2, 'walkers not clear before cross traffic starts', (SELECT count(*) FROM walk), 0),
    (3, 'crossings at signals where people never walk', (SELECT count(*) FROM :"model".junction_crossing
        JOIN :"model".controller ON controller_id = junction_id), 0),
    (10, 'crossings behind a stop line, or off their street', (SELECT count(*) FROM :"model".junction_crossing
        JOIN :"model".controller ON controller_id = junction_id), 0),
    (4, 'cycles over 120 s', (SELECT count(*) FROM :"model".controller), 0),
    (5, 'changes with all red over 6 s', (SELECT count(*) FROM change), 0),
    (6, 'changes too short for pairs that meet', (SELECT count(*) FROM change), 0),
    (7, 'states of broken seconds', (SELECT count(*) FROM state), 0),
    (8, 'phases of service arms alone', (SELECT count(*) FROM state WHERE kind = 'green'), 0),
    (9, 'turns over three lanes, of two lanes, or from 70 km/h on without a phase', (SELECT count(DISTINCT
        (controller_id, edge_in, edge_out)) FROM path WHERE turn IN ('left', 'right')), 0)) v(turn, asked, of, bar)
    LEFT JOIN fault f ON f.figure = v.asked
GROUP BY v.turn, v.asked, of, bar ORDER BY v.turn;
SELECT count(*) AS controllers, round(avg(cycle)::numeric, 1) AS mean_cycle, max(cycle) AS longest_cycle,
    (SELECT max(all_red) FROM change) AS longest_all_red, (SELECT round(avg(all_red)::numeric, 2) FROM change)
        AS mean_all_red, (SELECT count(*) FROM state WHERE kind = 'walk') AS walk_states
FROM :"model".controller;
