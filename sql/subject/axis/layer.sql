-- The layer of axes in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._axis_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (2, 'axes', 'LINESTRING', true,
        'axis_id AS id, name, ref, kind, u.importance, u.level, u.direction, u.width, u.width_end, '
        'u.roadway_offset AS offset_m, '
        'u.lane_count, '
        'u.lanes_forward AS lanes_fwd, u.lanes_backward AS lanes_bwd, u.lanes_both, u.sidewalk_left AS walk_left, '
        'u.sidewalk_right AS walk_right, u.speed, '
        'array_to_string(estimated, '','') AS estimated, source, source_ref', 'u.geom',
        'axis_used u JOIN %1$I.axis a USING (axis_id)') $$;
COMMENT ON FUNCTION streetgen._axis_layer() IS 'The layer of axes in files.';
