-- The chains of junctions that a run locks.

CREATE OR REPLACE FUNCTION streetgen._junction_chain() RETURNS TABLE(relation name, touched text, at_end boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    -- Junctions are read and written by several statements: also what is only computed again is locked.
    ('junction'::name, $q$
        SELECT e.axis_id, j.junction_id AS chain FROM {model}.edge e, LATERAL (
            SELECT junction_id, node_id FROM {model}.junction_node j
            WHERE j.node_id IN (e.from_node, e.to_node) OFFSET 0) j
        WHERE e.axis_id = ANY (written) AND (SELECT true FROM {model}.junction_node o
            WHERE o.junction_id = j.junction_id AND o.node_id <> j.node_id LIMIT 1)$q$, false) $f$;
COMMENT ON FUNCTION streetgen._junction_chain() IS 'The chains of junctions, as streetgen._chain has them.';
