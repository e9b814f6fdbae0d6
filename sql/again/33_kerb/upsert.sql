-- The one statement, kerbs: the border of what is affected, and of what lies beside ground that changed.

CREATE OR REPLACE FUNCTION streetgen._upsert_kerb(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template($part$
-- A kerb of an intersection may name an edge of an axis that is not written: as it is there.
kerb_edge AS MATERIALIZED (
    SELECT number, edge_id FROM new_edge
    UNION ALL SELECT c.number, e.edge_id
    FROM computed_edge c, LATERAL (SELECT edge_id FROM {model}.edge e
        WHERE (e.axis_id, e.start_abscissa, e.end_abscissa) = (c.axis_id, c.start_abscissa, c.end_abscissa) {by_key}) e
    WHERE NOT {whole} AND c.number NOT IN (SELECT number FROM written_edge)
        AND (c.from_node IN (SELECT number FROM new_node WHERE kerbs_affected)
            OR c.to_node IN (SELECT number FROM new_node WHERE kerbs_affected))),
kerb_edge_ids AS MATERIALIZED (SELECT streetgen._ids(number, edge_id) AS ids FROM kerb_edge)$part$, places),
    streetgen._upsert_rows(places, 'kerb',
        columns => 'edge_id, node_id, level, side, part, geom, curve, surface, method', rows => $part$
        SELECT number, edge_id, node_id, level, side, part, geom, curve, surface, method
        FROM streetgen._computed_kerb((SELECT streets FROM computed), (SELECT ids FROM node_ids),
            (SELECT ids FROM kerb_edge_ids))$part$,
        there => $part$
        SELECT k.kerb_id FROM new_edge e, LATERAL (SELECT kerb_id FROM {model}.kerb k
            WHERE k.edge_id = e.edge_id AND k.node_id IS NULL {by_key}) k WHERE e.kerbs_affected AND NOT e.fresh
        UNION ALL SELECT k.kerb_id FROM new_node n, LATERAL (SELECT kerb_id, edge_id FROM {model}.kerb k
            WHERE k.node_id = n.node_id {by_key}) k
        WHERE n.kerbs_affected AND NOT n.fresh AND k.edge_id IN (SELECT edge_id FROM kerb_edge)$part$)) $$;
COMMENT ON FUNCTION streetgen._upsert_kerb(jsonb) IS 'Part of the one statement: kerbs at new_edge and new_node.';
