-- What models of older builds have otherwise.

CREATE OR REPLACE FUNCTION streetgen._mend_source_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- The pieces of a cut axis share its place.
    ALTER TABLE axis_route DROP CONSTRAINT IF EXISTS axis_route_source_route_ordinality_key;
END $$;
COMMENT ON FUNCTION streetgen._mend_source_tables(name) IS
    'Takes from the routes of a model the key that older ones have.';
