-- Points that are one in files.

CREATE OR REPLACE FUNCTION streetgen._first_within(places float8[], groups bigint[], reach float8) RETURNS integer[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 AS 'MODULE_PATHNAME', 'streetgen_first_within';
COMMENT ON FUNCTION streetgen._first_within(float8[], bigint[], float8) IS
    'For each of places (x, y, z, …) the number of the one that stands for it, from 1: the nearest before it that '
    'stands for itself and lies within reach, metres, else itself. A place of a group other than 0 takes one of its '
    'own group alone. Arrays that do not fit: 22023 or 2202E.';
