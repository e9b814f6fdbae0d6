-- The chains of roads that a run locks.

CREATE OR REPLACE FUNCTION streetgen._alignment_chain() RETURNS TABLE(relation name, touched text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    -- A run that changes a road of one edge, or a junction of one node, holds an axis there.
    ('road'::name, $q$
        SELECT t.axis_id, r.road_id AS chain FROM touched t, LATERAL (
            SELECT road_id FROM {model}.road_edge r WHERE r.edge_id = t.edge_id OFFSET 0) r
        WHERE (SELECT true FROM {model}.road_edge o
            WHERE o.road_id = r.road_id AND o.edge_id <> t.edge_id LIMIT 1)$q$) $f$;
COMMENT ON FUNCTION streetgen._alignment_chain() IS 'The chains of roads, as streetgen._chain has them.';
