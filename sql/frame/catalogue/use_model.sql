-- Functions of streetgen read and write the tables of a model by their names alone: the model is where names are found.

CREATE OR REPLACE FUNCTION streetgen._use_model(model name) RETURNS text
    -- PL/pgSQL, so that a session plans it once: an edit asks a dozen times.
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE
    AS $$
BEGIN
    RETURN pg_catalog.set_config('search_path', pg_catalog.concat(pg_catalog.quote_ident(model),
        pg_catalog.substr(pg_catalog.current_setting('search_path'), 11)), true);
END $$;
COMMENT ON FUNCTION streetgen._use_model(name) IS
    'From here to the end of the function that calls it, names without a schema are those of the system, then of the '
    'model, and what is made without one is made there. That function sets search_path itself, pg_catalog first, and '
    'so gets the path back when it ends. In a parallel plan: 25000.';
