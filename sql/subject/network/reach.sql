-- The reach of a change by control points, which speak at the junction ahead.

CREATE OR REPLACE FUNCTION streetgen._network_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT value::float8 FROM setting WHERE name = 'control_distance');
END $$;
COMMENT ON FUNCTION streetgen._network_reach(name) IS
    'How far a change of an axis reaches by signals, which stand in mid-block where no junction is near, metres.';
