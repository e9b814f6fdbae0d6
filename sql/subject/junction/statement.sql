-- Pieces of statements about junctions, by name: streetgen._part gives each.

--{junction_chain
SELECT e.axis_id, j.junction_id AS chain FROM {model}.edge e, LATERAL (
    SELECT junction_id, node_id FROM {model}.junction_node j
    WHERE j.node_id IN (e.from_node, e.to_node) OFFSET 0) j
WHERE e.axis_id = ANY (written) AND (SELECT true FROM {model}.junction_node o
    WHERE o.junction_id = j.junction_id AND o.node_id <> j.node_id LIMIT 1)

--{junction_edge_editing
SELECT e.edge_id, EXISTS (SELECT FROM {model}.junction_edge j WHERE j.edge_id = e.edge_id) AS inside,
    EXISTS (SELECT FROM {model}.junction_override o WHERE o.axis_id = e.axis_id AND o.inside IS NOT NULL
        -- This does what streetgen._edge_at does, whose name may change before the model is adopted.
        AND e.edge_id = (SELECT n.edge_id FROM {model}.edge n WHERE n.axis_id = o.axis_id
            ORDER BY ST_Distance(n.geom, o.geom), n.edge_id LIMIT 1)) AS by_hand, e.geom
FROM {model}.edge e

--{overrides_at_junction
SELECT coalesce(array_agg(o.{override}_id ORDER BY o.{override}_id DESC), ARRAY[]::bigint[])
FROM {model}.{override} o CROSS JOIN LATERAL (
    SELECT v.node_id, ST_Distance(n.geom, o.geom) AS metres
    FROM {model}.edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id)
        JOIN {model}.node n USING (node_id) WHERE e.axis_id = o.axis_id
    ORDER BY metres, v.node_id LIMIT 1) n JOIN {model}.junction_node m USING (node_id)
WHERE m.junction_id = $1
    AND metres <= (SELECT value::float8 FROM {model}.setting WHERE name = 'control_distance')
