-- One build: the functions of the module read their arguments and give rows as the SQL of their own build says.

CREATE OR REPLACE FUNCTION streetgen._build_mark() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$SELECT '{build_mark}'$$;
COMMENT ON FUNCTION streetgen._build_mark() IS
    'The build that this SQL is of: a hash of all of it. The module has the same, and looks here before each call.';

CREATE OR REPLACE FUNCTION streetgen._require_one_build() RETURNS void
    LANGUAGE c STABLE PARALLEL SAFE
    AS 'MODULE_PATHNAME', 'streetgen_require_one_build';
COMMENT ON FUNCTION streetgen._require_one_build() IS
    'Raises 55000 where the module is of another build than this SQL, as each function of the module does: for '
    'functions and triggers that would read or write before they call the module.';

CREATE OR REPLACE FUNCTION streetgen._require_its_build(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_one_build();
    IF EXISTS (SELECT FROM streetgen.model m WHERE m.name = model AND m.build IS DISTINCT FROM streetgen._build_mark()
        AND to_regnamespace(quote_ident(model)) IS NOT NULL) THEN
        PERFORM streetgen._refuse('55000', format('model "%s" came from another build', model),
            detail => 'A dump brought it with functions, views and triggers of that build.',
            hint => format('SELECT streetgen.adopt_model(%L), by its owner, gives it those of this build.', model));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_its_build(name) IS
    'Raises 55000 as _require_one_build does, and for a model whose functions, views and triggers another build made: '
    'a dump of a whole database brings such. A schema that is no model passes.';
