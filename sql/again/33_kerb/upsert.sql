-- The one statement, kerbs: the border of what is affected, and of what lies beside ground that changed.

CREATE OR REPLACE FUNCTION streetgen._upsert_kerb(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._upsert_rows(places, 'kerb',
        columns => 'edge_id, node_id, level, side, part, geom, curve, surface, method', rows => $part$
        SELECT number, edge_id, node_id, level, side, part, geom, curve, surface, method
        FROM streetgen._computed_kerb((SELECT streets FROM computed), (SELECT ids FROM node_ids),
            (SELECT ids FROM edge_ids))$part$,
        there => $part$
        SELECT k.kerb_id FROM new_edge e, LATERAL (SELECT kerb_id FROM {model}.kerb k
            WHERE k.edge_id = e.edge_id AND k.node_id IS NULL {by_key}) k WHERE e.kerbs_affected AND NOT e.fresh
        -- One that names an edge which is not written belongs to the run for its axis.
        UNION ALL SELECT k.kerb_id FROM new_node n, LATERAL (SELECT kerb_id, edge_id FROM {model}.kerb k
            WHERE k.node_id = n.node_id {by_key}) k
        WHERE n.kerbs_affected AND NOT n.fresh AND k.edge_id IN (SELECT edge_id FROM new_edge)$part$) $$;
COMMENT ON FUNCTION streetgen._upsert_kerb(jsonb) IS 'Part of the one statement: kerbs at new_edge and new_node.';
