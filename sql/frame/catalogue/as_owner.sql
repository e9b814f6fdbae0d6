-- Work for the owner of a model is done with his rights alone.

CREATE OR REPLACE FUNCTION streetgen._as_owner(model name, called text) RETURNS bigint
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE AS 'MODULE_PATHNAME', 'streetgen_as_owner';
COMMENT ON FUNCTION streetgen._as_owner(name, text) IS
    'Calls a function of streetgen that takes the name of a model with the rights of its owner: triggers that he hung '
    'on tables run with these alone, and cannot change the role. Returns the number that the function returns; NULL: '
    'none. A caller who is no member of that role: 42501.';
