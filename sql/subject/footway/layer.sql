-- The layers of footways, areas and the network on foot in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._footway_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'footways', 'MULTIPOLYGON', false, 'footway_id AS id, use, level, width, paved', 'surface',
        'footway_surface'),
    (36, 'areas', 'MULTIPOLYGON', false, 'street_area_id AS id, kind, level, paved', 'surface', 'area_surface'),
    (36, 'walk_links', 'LINESTRING', false, 'walk_link_id AS id, kind, from_node, to_node, level, metres, width, '
        'kerb_from, kerb_to, marking, surface, incline, climb, tactile_paving, wheelchair, foot, footway_id, edge_id, '
        'side',
        'geom', 'walk_link') $$;
COMMENT ON FUNCTION streetgen._footway_layer() IS 'The layers of footways, areas and the network on foot in files.';
