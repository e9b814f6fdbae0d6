-- The paths of ramps.
CREATE OR REPLACE FUNCTION streetgen._make_ramp_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.ramp_path WITH (security_invoker = true) AS
SELECT i.interconnection_id, r.ramp_id, r.kind, i.lane_in, i.lane_out, i.geom
FROM %1$I.ramp r JOIN %1$I.interconnection i USING (node_id) JOIN %1$I.lane a ON a.lane_id = i.lane_in
    JOIN %1$I.lane b ON b.lane_id = i.lane_out
WHERE i.connecting AND r.edge_id IN (a.edge_id, b.edge_id);
COMMENT ON VIEW %1$I.ramp_path IS
    'The paths of traffic that comes upon a highway by its ramp, or leaves it: tangent to both lanes'
$sql$, model);
END $$;
COMMENT ON FUNCTION streetgen._make_ramp_views(name) IS 'Makes the view ramp_path of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._is_ramp(model name, node bigint) RETURNS boolean
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    found boolean := false;
BEGIN
    IF 'ramp' = ANY (streetgen._subjects(model)) THEN
        EXECUTE format('SELECT EXISTS (SELECT FROM %I.ramp WHERE node_id = $1)', model) INTO found USING node;
    END IF;
    RETURN found;
END $$;
COMMENT ON FUNCTION streetgen._is_ramp(name, bigint) IS
    'Whether a node is a ramp of a model that computes ramps.';
