-- The layer of paths from lane to lane in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._interconnection_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (8, 'interconnections', 'LINESTRING', false,
        'interconnection_id AS id, node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, '
        'connecting', 'geom', 'interconnection') $$;
COMMENT ON FUNCTION streetgen._interconnection_layer() IS 'The layer of paths from lane to lane in files.';
