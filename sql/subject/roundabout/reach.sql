-- The reach of a change by rings.

CREATE OR REPLACE FUNCTION streetgen._roundabout_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT 2 * value::float8 + 10 FROM setting WHERE name = 'roundabout_radius_greatest');
END $$;
COMMENT ON FUNCTION streetgen._roundabout_reach(name) IS
    'How far a change of an axis reaches by a ring, which is touched as far off as it is wide, metres.';
