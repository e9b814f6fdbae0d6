-- The layer of roads in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._alignment_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (12, 'roads_arcs', 'LINESTRING', false, 'road_id AS id, from_node, to_node, closed, length',
        'streetgen.arc_road_line(geom, 0.01)', 'road') $$;
COMMENT ON FUNCTION streetgen._alignment_layer() IS 'The layer of roads in files.';
