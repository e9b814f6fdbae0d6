-- The layers of footways and areas in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._footway_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'footways', 'MULTIPOLYGON', false, 'footway_id AS id, use, level, width, paved', 'surface',
        'footway_surface'),
    (36, 'areas', 'MULTIPOLYGON', false, 'street_area_id AS id, kind, level, paved', 'surface', 'area_surface') $$;
COMMENT ON FUNCTION streetgen._footway_layer() IS 'The layers of footways and areas in files.';
