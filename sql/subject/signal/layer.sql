-- The layers of signals in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._signal_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (60, 'signal_heads', 'POINT', false, 'row_number() OVER (ORDER BY lane_id, along_axis) AS id, controller_id AS '
        'controller, lane_id AS lane, along_axis AS along, angle', 'geom', 'signal_head'),
    (61, 'controllers', 'POINT', false, 'controller_id AS id, program, cycle, start_offset AS offset_s, method',
        'geom', 'controller') $$;
COMMENT ON FUNCTION streetgen._signal_layer() IS 'The layers of signals in files.';
