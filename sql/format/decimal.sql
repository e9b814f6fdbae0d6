-- Numbers as texts of files. Functions that are bound when made use it, so that it comes before them.

CREATE OR REPLACE FUNCTION streetgen._decimal(value float8, digits integer) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_decimal';
COMMENT ON FUNCTION streetgen._decimal(float8, integer) IS
    'A number with so many digits behind the point (0 to 15), never -0. One that is not finite: 22023.';
