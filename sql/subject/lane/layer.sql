-- The layers of lanes in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._lane_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (5, 'lanes', 'LINESTRING', false,
        'lane_id AS id, edge_id, ordinality, lane_position AS position, side, along_axis, both_ways, kind, width, '
        'turn', 'geom', 'lane'),
    (6, 'lane_separators', 'MULTIPOLYGON', false,
        'lane_separator_id AS id, edge_id, lane_position AS position, kind, dashed', 'surface', 'lane_separator'),
    (7, 'markings', 'MULTIPOLYGON', false,
        'marking_id AS id, edge_id, lane_position AS position, along_axis, node_id, kind', 'surface', 'marking') $$;
COMMENT ON FUNCTION streetgen._lane_layer() IS 'The layers of lanes in files.';
