-- Lanes in the middle: for those who turn off, of both directions.

CREATE OR REPLACE FUNCTION streetgen._lanes_in_middle(model name, edge bigint DEFAULT NULL)
    RETURNS TABLE(lane_id bigint, edge_id bigint)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT m.lane_id, m.edge_id FROM lane m WHERE (edge IS NULL OR m.edge_id = edge) AND both_ways
        AND kind IN ('general', 'bus', 'carpool') AND (SELECT count(DISTINCT o.along_axis) = 2 FROM lane o
            WHERE o.edge_id = m.edge_id AND NOT o.both_ways AND o.kind IN ('general', 'bus', 'carpool'));
END $$;
COMMENT ON FUNCTION streetgen._lanes_in_middle(name, bigint) IS
    'The lanes of a model, or of an edge, that both directions use although each has lanes of its own beside them: '
    'they are for those who turn off across the other direction, and never a way through.';
