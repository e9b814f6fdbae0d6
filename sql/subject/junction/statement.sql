-- Pieces of statements about junctions, by name: streetgen._part gives each.

--{junction_chain
SELECT e.axis_id, j.junction_id AS chain FROM {model}.edge e, LATERAL (
    SELECT junction_id, node_id FROM {model}.junction_node j
    WHERE j.node_id IN (e.from_node, e.to_node) OFFSET 0) j
WHERE e.axis_id = ANY (written) AND (SELECT true FROM {model}.junction_node o
    WHERE o.junction_id = j.junction_id AND o.node_id <> j.node_id LIMIT 1)
