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
