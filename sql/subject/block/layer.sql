-- The layer of blocks in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._block_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (13, 'blocks', 'MULTIPOLYGON', false, 'block_id AS id, kind, method', 'surface', 'block') $$;
COMMENT ON FUNCTION streetgen._block_layer() IS 'The layer of blocks in files.';
