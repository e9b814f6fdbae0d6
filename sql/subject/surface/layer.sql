-- The layers of the roadway in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._surface_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'roads', 'MULTIPOLYGON', false,
        'roadway_id AS id, part, edge_id, node_id, axis_id, name, kind, importance, level, width, lane_count, '
            '(SELECT p.roadway FROM %1$I.paving p WHERE p.edge_id = roadway.edge_id) AS paved', 'surface', 'roadway'),
    (9, 'corners', 'LINESTRING', false, 'corner_id AS id, node_id, edge_a, edge_b, radius, method',
        'ST_CurveToLine(arc, 16)', 'corner WHERE arc IS NOT NULL') $$;
COMMENT ON FUNCTION streetgen._surface_layer() IS 'The layers of the roadway in files.';
