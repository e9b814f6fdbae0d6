-- The layers of bridges and tunnels in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._bridge_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (57, 'bridges', 'MULTIPOLYGON', false, 'bridge_id AS id, edge_id, start_abscissa AS at_start, '
        'end_abscissa AS at_end, method', 'surface', 'bridge'),
    (58, 'tunnels', 'MULTIPOLYGON', false, 'tunnel_id AS id, edge_id, start_abscissa AS at_start, '
        'end_abscissa AS at_end, method', 'surface', 'tunnel') $$;
COMMENT ON FUNCTION streetgen._bridge_layer() IS 'The layers of bridges and tunnels in files.';
