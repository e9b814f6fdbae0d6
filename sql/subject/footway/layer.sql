-- The layer of footways in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._footway_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'footways', 'MULTIPOLYGON', false, 'footway_id AS id, use, level, width', 'surface', 'footway_surface') $$;
COMMENT ON FUNCTION streetgen._footway_layer() IS 'The layer of footways in files.';
