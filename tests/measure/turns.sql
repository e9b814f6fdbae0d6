-- Turns and merges of the model of variable model: psql -v model=NAME -f tests/measure/turns.sql prints a row. Table place keeps where.
--   same         nodes where two paths of cars from one edge to one next edge cross
--   merge        nodes where two nearly straight paths into one edge cross; diverge: out of one edge
--   weave        chains of three edges, the middle one under 25 m, of which no lane has both movements; of those under
--                7.5 m.
--                An edge is as long as the shortest of its lanes.
--   trapped      edges that cars cannot leave, though another edge for cars goes on; unreached: that cars cannot come to, though others come
--   lost         movements of two-way streets without restriction, no lanes of which are joined
-- The first three and the last leave nodes out where a street is drawn twice.
SET client_min_messages = error;
CREATE TEMPORARY TABLE driven AS
SELECT l.lane_id, l.edge_id, v.along, l.kind IN ('general', 'carpool', 'merging') AS cars, ST_Length(l.geom) AS length, v.leaves, v.enters, e.axis_id
FROM :"model".lane l JOIN :"model".edge e USING (edge_id)
JOIN LATERAL (VALUES (true, e.from_node, e.to_node), (false, e.to_node, e.from_node)) v(along, leaves, enters) ON l.both_ways OR l.along_axis = v.along WHERE l.kind NOT IN ('parking', 'closed');
CREATE TEMPORARY TABLE joined AS
SELECT c.interconnection_id, c.node_id, c.turn, c.angle, i.edge_id AS edge_in, c.along_in, o.edge_id AS edge_out, c.along_out, c.lane_in, c.lane_out, c.geom, c.reason
FROM :"model".interconnection c JOIN driven i ON (i.lane_id, i.along) = (c.lane_in, c.along_in) JOIN driven o ON (o.lane_id, o.along) = (c.lane_out, c.along_out) WHERE c.plausible AND i.cars AND o.cars;
CREATE INDEX ON joined (node_id);
ANALYZE joined;
CREATE TEMPORARY TABLE place AS
SELECT 'same' AS measure, a.node_id, ST_Centroid(ST_Collect(ST_Intersection(a.geom, b.geom))) AS geom FROM joined a JOIN joined b USING (node_id, edge_in, edge_out, along_in, along_out)
WHERE a.lane_in < b.lane_in AND a.lane_out <> b.lane_out AND ST_Crosses(a.geom, b.geom) GROUP BY a.node_id
UNION ALL SELECT 'merge', a.node_id, ST_Centroid(ST_Collect(ST_Intersection(a.geom, b.geom))) FROM joined a JOIN joined b USING (node_id, edge_out, along_out)
WHERE a.edge_in < b.edge_in AND a.lane_out <> b.lane_out AND abs(a.angle) < 35 AND abs(b.angle) < 35 AND ST_Crosses(a.geom, b.geom) GROUP BY a.node_id
UNION ALL SELECT 'diverge', a.node_id, ST_Centroid(ST_Collect(ST_Intersection(a.geom, b.geom))) FROM joined a JOIN joined b USING (node_id, edge_in, along_in)
WHERE a.edge_out < b.edge_out AND a.lane_in <> b.lane_in AND abs(a.angle) < 35 AND abs(b.angle) < 35 AND ST_Crosses(a.geom, b.geom) GROUP BY a.node_id;
-- Streets drawn twice are a fault of the data.
CREATE TEMPORARY TABLE twice AS
SELECT DISTINCT n.node_id FROM :"model".node n JOIN :"model".edge a ON n.node_id IN (a.from_node, a.to_node) JOIN :"model".edge b ON n.node_id IN (b.from_node, b.to_node)
WHERE a.edge_id < b.edge_id AND a.level = b.level AND ST_Length(ST_Intersection(a.geom, ST_Buffer(b.geom, 1))) > 4;
DELETE FROM place WHERE node_id IN (SELECT node_id FROM twice);
-- Chains: whoever comes by edge a, passes edge e and leaves by edge b.
CREATE TEMPORARY TABLE chain AS
SELECT a.edge_in, a.edge_out AS edge, a.along_out AS along, b.edge_out, bool_or(a.lane_out = b.lane_in) AS keeps_lane, min(l.length) AS length
FROM joined a JOIN joined b ON (b.edge_in, b.along_in) = (a.edge_out, a.along_out) JOIN driven l ON (l.lane_id, l.along) = (a.lane_out, a.along_out)
WHERE a.edge_in <> a.edge_out AND b.edge_out <> a.edge_out
GROUP BY 1, 2, 3, 4 HAVING min(l.length) < 25;
INSERT INTO place SELECT DISTINCT 'weave', NULL::bigint, ST_Force2D(e.geom) FROM chain c JOIN :"model".edge e ON e.edge_id = c.edge WHERE NOT keeps_lane;
CREATE TEMPORARY TABLE for_cars AS SELECT DISTINCT edge_id, along, leaves, enters FROM driven WHERE cars;
INSERT INTO place SELECT 'trapped', d.enters, ST_Force2D(e.geom) FROM for_cars d JOIN :"model".edge e USING (edge_id)
WHERE NOT EXISTS (SELECT FROM joined j WHERE (j.edge_in, j.along_in) = (d.edge_id, d.along)) AND EXISTS (SELECT FROM for_cars o WHERE o.leaves = d.enters AND o.edge_id <> d.edge_id);
INSERT INTO place SELECT 'unreached', d.leaves, ST_Force2D(e.geom) FROM for_cars d JOIN :"model".edge e USING (edge_id)
WHERE NOT EXISTS (SELECT FROM joined j WHERE (j.edge_out, j.along_out) = (d.edge_id, d.along)) AND EXISTS (SELECT FROM for_cars o WHERE o.enters = d.leaves AND o.edge_id <> d.edge_id);
-- Movements between streets of both directions at nodes of three and more edges.
CREATE TEMPORARY TABLE lost AS
SELECT i.enters AS node_id, i.edge_id AS edge_in, o.edge_id AS edge_out, mode() WITHIN GROUP (ORDER BY c.reason) AS reason FROM driven i JOIN driven o ON o.leaves = i.enters AND o.edge_id <> i.edge_id
LEFT JOIN :"model".interconnection c ON (c.lane_in, c.along_in, c.lane_out, c.along_out) = (i.lane_id, i.along, o.lane_id, o.along)
WHERE i.cars AND o.cars AND EXISTS (SELECT FROM for_cars d WHERE d.edge_id = i.edge_id AND d.along <> i.along) AND EXISTS (SELECT FROM for_cars d WHERE d.edge_id = o.edge_id AND d.along <> o.along)
    AND (SELECT count(*) FROM :"model".edge e WHERE i.enters IN (e.from_node, e.to_node)) >= 3
    AND i.enters NOT IN (SELECT node_id FROM twice)
GROUP BY 1, 2, 3, i.along, o.along HAVING NOT coalesce(bool_or(c.plausible OR c.reason IN ('restriction', 'ring')), false);
SELECT :'model' AS model, count(*) FILTER (WHERE measure = 'same') AS same, count(*) FILTER (WHERE measure = 'merge') AS merge, count(*) FILTER (WHERE measure = 'diverge') AS diverge,
    (SELECT count(*) FROM chain WHERE NOT keeps_lane) AS weave, (SELECT count(*) FROM chain WHERE NOT keeps_lane AND length < 7.5) AS "weave 7.5 m",
    count(*) FILTER (WHERE measure = 'trapped') AS trapped, count(*) FILTER (WHERE measure = 'unreached') AS unreached,
    (SELECT count(*) FROM lost) AS lost, (SELECT count(*) FROM lost WHERE reason = 'u_turn') AS "lost as u_turn",
    (SELECT count(*) FROM :"model".node n WHERE (SELECT count(*) FROM :"model".edge e WHERE n.node_id IN (e.from_node, e.to_node)) >= 3) AS nodes FROM place;
