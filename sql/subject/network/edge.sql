-- The edge of an axis at a place.

CREATE OR REPLACE FUNCTION streetgen._edge_at(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT e.edge_id FROM edge e WHERE e.axis_id = axis ORDER BY ST_Distance(e.geom, place), e.edge_id LIMIT 1);
END $$;
COMMENT ON FUNCTION streetgen._edge_at(name, bigint, geometry) IS
    'Of the edges of an axis the nearest to a place; NULL where the axis has none.';
