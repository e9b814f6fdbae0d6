-- The layers of the network in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._network_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (3, 'edges', 'LINESTRING', true,
        'edge_id AS id, axis_id, from_node, to_node, importance, level, start_abscissa AS from_m, end_abscissa AS '
        'to_m, width, width_end, roadway_offset AS offset_m, lane_count, lanes_forward AS lanes_fwd, '
        'lanes_backward AS lanes_bwd, lanes_both, '
        'speed', 'geom', 'edge'),
    (4, 'nodes', 'POINT', true, 'node_id AS id', 'geom', 'node') $$;
COMMENT ON FUNCTION streetgen._network_layer() IS 'The layers of the network in files.';
