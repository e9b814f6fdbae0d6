-- The layers of the fit in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._fit_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (80, 'kerb_distances', 'LINESTRING', false, 'kerb_distance_id AS id, edge_id, side, observations, mean, median',
        'geom', 'kerb_distance'),
    (80, 'fit_changes', 'MULTILINESTRING', false, 'fit_proposal_id AS id, fit_run, axis_id, wider', 'geom',
        'fit_change') $$;
COMMENT ON FUNCTION streetgen._fit_layer() IS 'The layers of the fit in files.';
