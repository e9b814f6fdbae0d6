-- The reach of a change by observations.

CREATE OR REPLACE FUNCTION streetgen._fit_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- An observation between two streets lies as far from the kerb of each.
    RETURN 2 * streetgen._setting_number(model, 'fit_reach');
END $$;
COMMENT ON FUNCTION streetgen._fit_reach(name) IS
    'How far a change of an axis reaches by observations, of which each street takes those nearest to its kerbs, '
    'metres.';
