-- The layers of what stands at streets in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._object_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (70, 'objects', 'POINT', false, 'street_object_id AS id, type, angle, placement, axis_id, abscissa, side, '
        'axis_offset AS aside, edge_id, placed_by, source, source_ref, method', 'geom',
        'object_edge RIGHT JOIN %1$I.street_object USING (street_object_id) WHERE ST_Dimension(geom) = 0'),
    (71, 'objects_line', 'LINESTRING', false, 'street_object_id AS id, type, placement, axis_id, abscissa, '
        'abscissa_end AS at_end, side, axis_offset AS aside, placed_by, source, source_ref, method', 'geom',
        'object_edge RIGHT JOIN %1$I.street_object USING (street_object_id) WHERE ST_Dimension(geom) = 1'),
    (72, 'crossings', 'POLYGON', false, 'street_object_id AS id, width, angle, painted_as', 'surface',
        'pedestrian_crossing'),
    (75, 'refuges', 'POLYGON', false, 'street_object_id AS id', 'island',
        'pedestrian_crossing WHERE island IS NOT NULL'),
    (73, 'parking_bays', 'POLYGON', false, 'street_object_id AS id, length, width, angle', 'surface', 'parking_bay'),
    (74, 'bus_stops', 'POLYGON', false, 'street_object_id AS id, kind, width, edge_id, lane_id, level', 'surface',
        'bus_stop_box') $$;
COMMENT ON FUNCTION streetgen._object_layer() IS 'The layers of what stands at streets in files.';
