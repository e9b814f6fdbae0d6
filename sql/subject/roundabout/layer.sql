-- The layer of roundabouts in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._roundabout_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (11, 'roundabouts', 'LINESTRING', false,
        'roundabout_id AS id, kind, radius, score, accepted, confirmed, level, method', 'geom', 'roundabout') $$;
COMMENT ON FUNCTION streetgen._roundabout_layer() IS 'The layer of roundabouts in files.';
