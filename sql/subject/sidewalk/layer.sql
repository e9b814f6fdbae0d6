-- The layer of sidewalks in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalks', 'MULTIPOLYGON', false, 'sidewalk_id AS id, edge_id, node_id, side, part, width, method',
        'surface', 'sidewalk') $$;
COMMENT ON FUNCTION streetgen._sidewalk_layer() IS 'The layer of sidewalks in files.';
