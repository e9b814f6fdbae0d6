-- The layers of junctions in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._junction_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (40, 'junctions', 'MULTIPOLYGON', false, 'junction_id AS id, kind, method', 'surface', 'junction'),
    (41, 'movements', 'LINESTRING', false, 'row_number() OVER (ORDER BY lane_in, lane_out, along_in, along_out) AS id, '
        'junction_id AS junction, node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, '
        'connecting', 'geom', 'movement') $$;
COMMENT ON FUNCTION streetgen._junction_layer() IS 'The layers of junctions in files.';
