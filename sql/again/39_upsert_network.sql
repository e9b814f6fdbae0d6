-- The one statement, nodes and edges: which of them are written, and which keep the id of one that is there.

CREATE OR REPLACE FUNCTION streetgen._upsert_network(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._filled($part$
computed_edge AS MATERIALIZED (SELECT * FROM streetgen._computed_edge((SELECT streets FROM computed))),
-- The axes whose rows come out, and those that are gone.
asked_axis AS MATERIALIZED (
    SELECT axis_id FROM computed_edge WHERE (asked OR lanes_asked) AND axis_id = ANY ($1) UNION SELECT unnest($3)),
written_edge AS MATERIALIZED (SELECT * FROM computed_edge WHERE {whole} OR axis_id IN (SELECT axis_id FROM asked_axis)),
written_node AS MATERIALIZED (
    SELECT * FROM streetgen._computed_node((SELECT streets FROM computed))
    WHERE node IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge)),
old_edge AS MATERIALIZED (
    SELECT *, {whole} OR axis_id IN (SELECT axis_id FROM asked_axis) AS asked FROM {model}.edge WHERE NOT {bare} AND ({whole} OR axis_id = ANY ($1 || $2))),
-- Identity of nodes: an axis end is known by its side, a shared vertex by its abscissa.
old_span AS (SELECT axis_id, min(start_abscissa) AS first, max(end_abscissa) AS last FROM old_edge GROUP BY axis_id),
old_anchor AS (
    SELECT axis_id, CASE WHEN start_abscissa = first THEN -1 ELSE round((start_abscissa * 100)::numeric) END AS place, from_node AS node_id
    FROM old_edge JOIN old_span USING (axis_id)
    UNION SELECT axis_id, CASE WHEN end_abscissa = last THEN -2 ELSE round((end_abscissa * 100)::numeric) END, to_node
    FROM old_edge JOIN old_span USING (axis_id)),
new_span AS (SELECT axis_id, min(start_abscissa) AS first, max(end_abscissa) AS last FROM computed_edge GROUP BY axis_id),
new_anchor AS (
    SELECT node, axis_id, CASE WHEN abscissa = first THEN -1 WHEN abscissa = last THEN -2 ELSE round((abscissa * 100)::numeric) END AS place
    FROM (SELECT node, unnest(anchor_axis) AS axis_id, unnest(anchor_abscissa) AS abscissa FROM written_node WHERE NOT {bare}) a LEFT JOIN new_span USING (axis_id)),
claim_of AS (SELECT node, node_id, min(axis_id) AS axis_id FROM new_anchor JOIN old_anchor USING (axis_id, place) GROUP BY node, node_id),
heir AS (SELECT DISTINCT ON (node_id) node_id, node FROM claim_of ORDER BY node_id, axis_id, node),
kept_node AS (SELECT node, min(node_id) AS node_id FROM heir GROUP BY node)$part$, places),
    streetgen._upsert_rows(places, 'node', id => 'node_id', columns => 'geom', rows => $part$
        SELECT coalesce(node_id, nextval('{quoted_model}.node_node_id_seq')) AS node_id, node, asked,
               CASE WHEN {has_height} THEN streetgen._with_height(geom, (SELECT a.geom FROM {model}.axis a WHERE a.axis_id = anchor_axis[1])) ELSE geom END AS geom
        FROM (SELECT n.*, k.node_id FROM written_node n LEFT JOIN kept_node k USING (node) ORDER BY node OFFSET 0) n$part$,
        there => 'SELECT node_id FROM left_node'),
    streetgen._filled($part$
-- Identity of edges: by their ends along the axis, then by the node they begin at and their turn there.
same_edge AS MATERIALIZED (SELECT e.edge, o.edge_id FROM written_edge e JOIN old_edge o USING (axis_id, start_abscissa, end_abscissa)),
old_turn AS (
    SELECT edge_id, axis_id, from_node, row_number() OVER (PARTITION BY axis_id, from_node ORDER BY start_abscissa) AS turn
    FROM old_edge o WHERE NOT EXISTS (SELECT FROM same_edge s WHERE s.edge_id = o.edge_id)),
new_turn AS (
    SELECT e.edge, s.edge_id, a.node_id AS from_node, b.node_id AS to_node,
           row_number() OVER (PARTITION BY e.axis_id, a.node_id, s.edge_id IS NULL ORDER BY e.start_abscissa) AS turn
    FROM written_edge e LEFT JOIN same_edge s USING (edge) JOIN new_node a ON a.node = e.from_node JOIN new_node b ON b.node = e.to_node)$part$, places),
    streetgen._upsert_rows(places, 'edge', id => 'edge_id',
        columns => 'axis_id, from_node, to_node, level, start_abscissa, end_abscissa, geom, width, width_end, lane_count, lanes_forward, lanes_backward, speed, importance, estimated, input_hash, setting_hash',
        rows => $part$
        SELECT coalesce(edge_id, nextval('{quoted_model}.edge_edge_id_seq')) AS edge_id, edge, lanes_asked AS asked, axis_id, from_node, to_node, level, start_abscissa, end_abscissa,
               CASE WHEN {has_height} THEN streetgen._with_height(geom, axis) ELSE geom END AS geom,
               width, width_end, lane_count, lanes_forward, lanes_backward, speed, importance, estimated, input_hash, setting_hash
        FROM (SELECT e.edge, e.lanes_asked, e.axis_id, t.from_node, t.to_node, e.level, e.start_abscissa, e.end_abscissa, e.geom, u.geom AS axis, u.width, u.width_end,
                     u.lane_count, u.lanes_forward, u.lanes_backward, u.speed, u.importance, u.estimated, u.input_hash, u.setting_hash, coalesce(t.edge_id, o.edge_id) AS edge_id
              FROM written_edge e JOIN new_turn t USING (edge) JOIN used u ON u.axis_id = e.axis_id
              LEFT JOIN old_turn o ON t.edge_id IS NULL AND (o.axis_id, o.from_node, o.turn) = (e.axis_id, t.from_node, t.turn) ORDER BY e.edge OFFSET 0) e$part$,
        there => 'SELECT edge_id FROM old_edge WHERE asked'),
    -- LIMIT: asked of each node, and not joined.
    streetgen._filled($part$
left_node AS MATERIALIZED (
    SELECT node_id FROM (
        SELECT from_node AS node_id FROM old_edge WHERE asked UNION SELECT to_node FROM old_edge WHERE asked UNION SELECT node_id FROM {model}.node WHERE {whole} AND NOT {bare}
        EXCEPT SELECT node_id FROM new_node) o
    WHERE {whole}
        OR (SELECT true FROM {model}.edge e WHERE e.from_node = o.node_id AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis) LIMIT 1) IS NULL
            AND (SELECT true FROM {model}.edge e WHERE e.to_node = o.node_id AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis) LIMIT 1) IS NULL)$part$, places)) $$;
COMMENT ON FUNCTION streetgen._upsert_network(jsonb) IS 'Part of the one statement: new_node and new_edge, which have the ids that their surfaces and lanes refer to, and number node and edge of the computation.';
