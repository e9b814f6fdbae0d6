-- Functions of streetgen read and write the tables of a model by their names alone: the model is where names are found.

CREATE OR REPLACE FUNCTION streetgen._use_model(model name) RETURNS text
    LANGUAGE sql VOLATILE PARALLEL UNSAFE
    AS $$
SELECT pg_catalog.set_config('search_path', pg_catalog.concat(pg_catalog.quote_ident(model),
    pg_catalog.substr(pg_catalog.current_setting('search_path'), 11)), true) WHERE model IS NOT NULL
$$;
COMMENT ON FUNCTION streetgen._use_model(name) IS
    'From here to the end of the function that calls it, names without a schema are those of the system, then of the '
    'model, and what is made without one is made there. That function sets search_path itself, pg_catalog first, and '
    'so gets the path back when it ends. In a parallel plan: 25000.';
