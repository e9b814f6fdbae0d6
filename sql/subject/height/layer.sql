-- The layer of heights in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._height_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (56, 'profiles', 'LINESTRINGZ', false, 'edge_id AS id, grade_max, method', 'geom', 'profile') $$;
COMMENT ON FUNCTION streetgen._height_layer() IS 'The layer of heights in files.';
