-- The layer of overpasses in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._overpass_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (55, 'overpasses', 'POINT', false, 'overpass_id AS id, edge_above, abscissa_above AS at_above, edge_below, '
        'abscissa_below AS at_below, clearance, method', 'geom', 'overpass') $$;
COMMENT ON FUNCTION streetgen._overpass_layer() IS 'The layer of overpasses in files.';
