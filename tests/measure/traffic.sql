-- Joins of lanes in the model of variable model, into temporary tables: what tests/measure/quality.sql counts.

-- Paths that traffic takes, with the least radius of the circles through successive quarter points.
CREATE FUNCTION pg_temp.circumradius(a geometry, b geometry, c geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT ST_Distance(a, b) * ST_Distance(b, c) * ST_Distance(c, a) / nullif(4 * ST_Area(ST_MakePolygon(ST_MakeLine(ARRAY[a, b, c, a]))), 0) $$;
CREATE TEMPORARY TABLE path AS
SELECT c.*, i.edge_id AS edge_in, o.edge_id AS edge_out, 'crossed_limits' IN (i.method, o.method) AS crossed, (SELECT min(pg_temp.circumradius(ST_LineInterpolatePoint(c.geom, t), ST_LineInterpolatePoint(c.geom, t + 0.25), ST_LineInterpolatePoint(c.geom, t + 0.5)))
            FROM unnest(ARRAY[0, 0.25, 0.5]) t WHERE abs(angle) > 20) AS radius
FROM :"model".interconnection c JOIN :"model".lane i ON i.lane_id = c.lane_in JOIN :"model".lane o ON o.lane_id = c.lane_out WHERE c.plausible;

-- Could a wider path join the two edges: by any of their lanes, or by an arc of 3 m about the corner.
CREATE TEMPORARY TABLE tight AS
SELECT p.*, EXISTS (SELECT FROM :"model".interconnection c JOIN :"model".lane i ON i.lane_id = c.lane_in JOIN :"model".lane o ON o.lane_id = c.lane_out
                    CROSS JOIN LATERAL (SELECT min(pg_temp.circumradius(ST_LineInterpolatePoint(c.geom, t), ST_LineInterpolatePoint(c.geom, t + 0.25), ST_LineInterpolatePoint(c.geom, t + 0.5))) AS radius
                                        FROM unnest(ARRAY[0, 0.25, 0.5]) t) r
                    WHERE c.node_id = p.node_id AND (i.edge_id, o.edge_id) = (p.edge_in, p.edge_out) AND c.reason <> 'lane_kind' AND coalesce(r.radius >= 3, true)) AS allowed
FROM path p WHERE radius < 3;

-- Length of each path, plausible or not, and of what of it lies within the intersection and the two sections.
CREATE TEMPORARY TABLE inside AS
SELECT interconnection_id, plausible, ST_Length(p.geom) AS length, ST_Length(ST_Intersection(p.geom, ST_Buffer(ST_Union(ARRAY[n.surface, a.surface, b.surface]), 0.1, 4))) AS inside
FROM :"model".interconnection p JOIN :"model".lane i ON i.lane_id = p.lane_in JOIN :"model".lane o ON o.lane_id = p.lane_out
    JOIN :"model".intersection n USING (node_id) JOIN :"model".section a ON a.edge_id = i.edge_id JOIN :"model".section b ON b.edge_id = o.edge_id
WHERE n.contested_area + a.contested_area + b.contested_area = 0 AND ST_IsValid(n.surface) AND ST_IsValid(a.surface) AND ST_IsValid(b.surface);

CREATE TEMPORARY TABLE joined_lane AS
SELECT l.lane_id, v.along, v.leaves, v.enters FROM :"model".lane l JOIN :"model".edge e USING (edge_id)
JOIN LATERAL (VALUES (true, e.from_node, e.to_node), (false, e.to_node, e.from_node)) v(along, leaves, enters) ON l.both_ways OR l.along_axis = v.along WHERE l.kind <> 'parking';
CREATE TEMPORARY TABLE dead AS
SELECT (SELECT count(*) FROM joined_lane l JOIN degree d ON d.node_id = l.enters AND d.degree > 1 WHERE NOT EXISTS (SELECT FROM path WHERE (lane_in, along_in) = (lane_id, along))) AS lanes_in,
       (SELECT count(*) FROM joined_lane l JOIN degree d ON d.node_id = l.leaves AND d.degree > 1 WHERE NOT EXISTS (SELECT FROM path WHERE (lane_out, along_out) = (lane_id, along))) AS lanes_out,
       -- where the network itself has no way on: a street of another one-way direction, a restriction
       (SELECT count(*) FROM joined_lane l JOIN degree d ON d.node_id = l.enters AND d.degree > 1 WHERE NOT EXISTS (SELECT FROM :"model".interconnection WHERE (lane_in, along_in) = (lane_id, along) AND reason <> 'restriction')) AS sinks,
       (SELECT count(*) FROM joined_lane l JOIN degree d ON d.node_id = l.leaves AND d.degree > 1 WHERE NOT EXISTS (SELECT FROM :"model".interconnection WHERE (lane_out, along_out) = (lane_id, along) AND reason <> 'restriction')) AS sources;

-- Movements of lanes that are marked with turns, where there is a choice: with the marks read, and without.
CREATE TEMPORARY TABLE choice AS
SELECT c.lane_in, o.edge_id AS edge_out, bool_or(c.plausible) AS marked
FROM :"model".interconnection c JOIN :"model".lane i ON i.lane_id = c.lane_in JOIN :"model".lane o ON o.lane_id = c.lane_out
WHERE i.turn IS NOT NULL AND c.turn <> 'u_turn' AND c.reason <> 'restriction'
    AND (SELECT count(DISTINCT m.edge_id) > 1 FROM :"model".interconnection k JOIN :"model".lane m ON m.lane_id = k.lane_out WHERE k.lane_in = c.lane_in AND k.turn <> 'u_turn' AND k.reason <> 'restriction')
GROUP BY c.lane_in, o.edge_id;
UPDATE :"model".axis SET turn_forward = NULL, turn_backward = NULL WHERE turn_forward IS NOT NULL OR turn_backward IS NOT NULL;
SELECT count(*) FROM streetgen.generate(:'model') \g /dev/null
CREATE TEMPORARY TABLE guess AS
SELECT h.*, coalesce((SELECT bool_or(c.plausible) FROM :"model".interconnection c JOIN :"model".lane o ON o.lane_id = c.lane_out WHERE c.lane_in = h.lane_in AND o.edge_id = h.edge_out), false) AS guessed
FROM choice h;
