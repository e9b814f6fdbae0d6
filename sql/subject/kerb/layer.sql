-- The layer of kerbs in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._kerb_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (10, 'kerbs', 'LINESTRING', false, 'kerb_id AS id, edge_id, node_id, level, side, part, method', 'geom', 'kerb') $$;
COMMENT ON FUNCTION streetgen._kerb_layer() IS 'The layer of kerbs in files.';
