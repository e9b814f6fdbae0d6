-- What mapped signals, stops and give-ways of the model of variable model serve, and what its controllers are.
-- Run as psql -v model=NAME -f tests/measure/control_points.sql; subjects junction and signal are on. A row is a figure
-- with what was found, of how many, and its bar. Table `place` has the places afterwards, by figure.
\set ON_ERROR_STOP on
SET client_min_messages = warning;
CREATE TEMPORARY TABLE place (figure text, id bigint, geom geometry);
CREATE TEMPORARY TABLE way AS
SELECT edge_id, axis_id, from_node AS node, to_node AS far, start_abscissa, end_abscissa, true AS along,
    end_abscissa - start_abscissa AS length, importance FROM :"model".edge
UNION ALL SELECT edge_id, axis_id, to_node, from_node, start_abscissa, end_abscissa, false,
    end_abscissa - start_abscissa, importance FROM :"model".edge;
CREATE INDEX ON way (node);
CREATE INDEX ON way (axis_id);
CREATE TEMPORARY TABLE degree AS SELECT node, count(*) AS edges FROM way GROUP BY node;
CREATE UNIQUE INDEX ON degree (node);
CREATE TEMPORARY TABLE told AS
SELECT id, bool_or(rule LIKE '%dead end') AS ends FROM streetgen.check_model(:'model')
WHERE relation = 'control_point' AND rule LIKE 'control point%' GROUP BY id;
ANALYZE way, degree, told;

-- The ends of edges that a point comes to within the control distance, both ways, over nodes of two edges.
CREATE TEMPORARY TABLE reached AS
WITH RECURSIVE walk(control_point_id, kind, edge_id, along, node, metres) AS (
    SELECT p.control_point_id, p.kind, w.edge_id, w.along, w.far,
        greatest(0, CASE WHEN along THEN w.end_abscissa - p.abscissa ELSE p.abscissa - w.start_abscissa END)
    FROM :"model".control_point p JOIN way w ON w.axis_id = p.axis_id
        AND p.abscissa BETWEEN w.start_abscissa - 1.5 AND w.end_abscissa + 1.5
    WHERE p.kind IN ('signals', 'stop', 'yield')
    UNION SELECT k.control_point_id, k.kind, w.edge_id, w.along, w.far, k.metres + w.length
    FROM walk k JOIN degree d ON d.node = k.node AND d.edges = 2
        JOIN way w ON w.node = k.node AND w.edge_id <> k.edge_id
    WHERE k.metres + w.length <= (SELECT value::float8 FROM :"model".setting WHERE name = 'control_distance'))
SELECT * FROM walk
WHERE metres <= (SELECT value::float8 FROM :"model".setting WHERE name = 'control_distance');
CREATE INDEX ON reached (control_point_id);
-- A point on a node of an edge reaches the other ends of that node too.
CREATE TEMPORARY TABLE point AS
SELECT p.control_point_id, p.kind, p.geom, CASE p.kind WHEN 'signals' THEN EXISTS (
        SELECT FROM reached r JOIN :"model".junction_node n ON n.node_id = r.node
            JOIN :"model".controller c ON c.controller_id = n.junction_id
        WHERE r.control_point_id = p.control_point_id)
    ELSE EXISTS (
        SELECT FROM reached r JOIN :"model".marking m ON m.node_id = r.node AND m.kind IN ('stop', 'yield')
            AND (r.metres < 1.5 OR (m.edge_id, m.along_axis) = (r.edge_id, r.along))
        WHERE r.control_point_id = p.control_point_id) END AS serves,
    t.id IS NOT NULL AS told, coalesce(t.ends, false) AS ends
FROM :"model".control_point p LEFT JOIN told t ON t.id = p.control_point_id
WHERE p.kind IN ('signals', 'stop', 'yield');
INSERT INTO place SELECT kind || ' that serves nothing, ' || CASE WHEN ends THEN 'at a dead end' WHEN told THEN 'told'
    ELSE 'untold' END,
    control_point_id, geom FROM point WHERE NOT serves;

-- Controllers that a road joins within the length of a short queue.
CREATE TEMPORARY TABLE controlled AS
SELECT n.node_id AS node, n.junction_id AS controller FROM :"model".junction_node n
    JOIN :"model".controller c ON c.controller_id = n.junction_id;
CREATE INDEX ON controlled (node);
INSERT INTO place
WITH RECURSIVE walk(controller, node, edge_id, metres) AS (
    SELECT controller, node, NULL::bigint, 0::float8 FROM controlled
    UNION SELECT k.controller, w.far, w.edge_id, k.metres + w.length
    FROM walk k JOIN way w ON w.node = k.node AND w.edge_id IS DISTINCT FROM k.edge_id
    WHERE k.metres + w.length <= 25
        AND NOT EXISTS (SELECT FROM controlled c WHERE c.node = k.node AND c.controller <> k.controller))
SELECT DISTINCT 'controller within 25 m along a road of another', k.controller, c.geom
FROM walk k JOIN controlled o ON o.node = k.node AND o.controller <> k.controller
    JOIN :"model".controller c ON c.controller_id = k.controller;

-- Right before left where roads of importance 3 and better meet.
INSERT INTO place
SELECT 'right before left on importance 3 and better', j.junction_id, j.geom
FROM :"model".junction j WHERE j.kind = 'right_before_left' AND j.method <> 'by_hand' AND EXISTS (
    SELECT FROM :"model".junction_node n JOIN way w ON w.node = n.node_id
    WHERE n.junction_id = j.junction_id AND w.importance <= 3);

SELECT f.figure, (SELECT count(*) FROM place p WHERE p.figure = f.figure) AS found, f.of, f.bar
FROM (VALUES
    (1, 'signals that serves nothing, untold', (SELECT count(*) FROM point WHERE kind = 'signals'), '0'),
    (2, 'signals that serves nothing, told', (SELECT count(*) FROM point WHERE kind = 'signals'), '<= 1 %'),
    (2, 'signals that serves nothing, at a dead end', (SELECT count(*) FROM point WHERE kind = 'signals'), ''),
    (3, 'stop that serves nothing, untold', (SELECT count(*) FROM point WHERE kind = 'stop'), '0'),
    (4, 'stop that serves nothing, told', (SELECT count(*) FROM point WHERE kind = 'stop'), ''),
    (4, 'stop that serves nothing, at a dead end', (SELECT count(*) FROM point WHERE kind = 'stop'), ''),
    (5, 'yield that serves nothing, untold', (SELECT count(*) FROM point WHERE kind = 'yield'), '0'),
    (6, 'yield that serves nothing, told', (SELECT count(*) FROM point WHERE kind = 'yield'), ''),
    (7, 'controller within 25 m along a road of another', (SELECT count(*) FROM :"model".controller), '0'),
    (8, 'right before left on importance 3 and better',
        (SELECT count(*) FROM :"model".junction WHERE kind = 'right_before_left'), '0')) f(turn, figure, of, bar)
ORDER BY turn;
