-- The layers of heights in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._height_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (56, 'profiles', 'LINESTRINGZ', false, 'edge_id AS id, grade_max, method', 'geom', 'profile'),
    (59, 'underpasses', 'POINT', false, 'overpass_id AS id, edge_id, abscissa AS at, clearance, height_limit', 'geom',
        'underpass') $$;
COMMENT ON FUNCTION streetgen._height_layer() IS 'The layers of heights in files.';
