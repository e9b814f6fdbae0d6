-- The layer of ramps in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._ramp_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (42, 'ramps', 'POINT', false, 'ramp_id AS id, node_id, edge_id, edge_before AS before, edge_after AS after, kind, '
        'side, lanes_missing AS missing, lanes_merging AS merging, length, taper, tangent, auxiliary, cut, method',
        'geom', 'ramp') $$;
COMMENT ON FUNCTION streetgen._ramp_layer() IS 'The layer of ramps in files.';
