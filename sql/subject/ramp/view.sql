-- The paths of ramps.
CREATE OR REPLACE FUNCTION streetgen._make_ramp_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW ramp_path WITH (security_invoker = true) AS
    SELECT i.interconnection_id, r.ramp_id, r.kind, i.lane_in, i.lane_out, i.geom
    FROM ramp r JOIN interconnection i USING (node_id) JOIN lane a ON a.lane_id = i.lane_in
        JOIN lane b ON b.lane_id = i.lane_out
    WHERE i.connecting AND r.edge_id IN (a.edge_id, b.edge_id);
    COMMENT ON VIEW ramp_path IS
        'The paths of traffic that comes upon a highway by its ramp, or leaves it: tangent to both lanes';
    COMMENT ON COLUMN ramp_path.interconnection_id IS 'the interconnection';
    COMMENT ON COLUMN ramp_path.ramp_id IS 'the ramp';
    COMMENT ON COLUMN ramp_path.kind IS 'on or off the highway';
    COMMENT ON COLUMN ramp_path.lane_in IS 'lane that traffic comes by';
    COMMENT ON COLUMN ramp_path.lane_out IS 'lane that it goes on';
    COMMENT ON COLUMN ramp_path.geom IS 'the path';
END $$;
COMMENT ON FUNCTION streetgen._make_ramp_views(name) IS 'Makes the view ramp_path of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._is_ramp(model name, node bigint) RETURNS boolean
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    found boolean := false;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'ramp' = ANY (streetgen._subjects(model)) THEN
        SELECT EXISTS (SELECT FROM ramp WHERE node_id = node) INTO found;
    END IF;
    RETURN found;
END $$;
COMMENT ON FUNCTION streetgen._is_ramp(name, bigint) IS
    'Whether a node is a ramp of a model that computes ramps.';

CREATE OR REPLACE FUNCTION streetgen._ramp_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('ramp_path'::name, 'ramp') $$;
COMMENT ON FUNCTION streetgen._ramp_view() IS
    'Views of ramps, and the subjects whose tables they read.';
