-- Tables that models with traffic of older builds lack.

CREATE OR REPLACE FUNCTION streetgen._mend_driving_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF streetgen._has_traffic(model) THEN
        PERFORM streetgen._make_tables(model, '{table}', '{driving}');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mend_driving_tables(name) IS
    'Adds the tables of scenes to a model with traffic that came before them.';
