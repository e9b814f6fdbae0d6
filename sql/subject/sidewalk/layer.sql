-- The layer of sidewalks in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalks', 'MULTIPOLYGON', false, 'sidewalk_id AS id, edge_id, node_id, side, part, width, method, '
            '(SELECT CASE side WHEN ''left'' THEN p.sidewalk_left WHEN ''right'' THEN p.sidewalk_right END '
            'FROM %1$I.paving p WHERE p.edge_id = sidewalk.edge_id) AS paved', 'surface', 'sidewalk'),
    (35, 'side_strips', 'MULTIPOLYGON', false, 'side_strip_id AS id, sidewalk_id, edge_id, side, "order", kind, '
            'level, paved', 'surface', 'side_strip'),
    (35, 'crossovers', 'MULTIPOLYGON', false, 'crossover_id AS id, edge_id, node_id, level, kerb, width', 'surface',
        'crossover') $$;
COMMENT ON FUNCTION streetgen._sidewalk_layer() IS 'The layers of sidewalks in files.';
