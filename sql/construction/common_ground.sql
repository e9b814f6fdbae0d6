-- The ground that two lines have in common, side by side.

CREATE OR REPLACE FUNCTION streetgen._common_ground(line bytea, other bytea, distance float8) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_common_ground';
COMMENT ON FUNCTION streetgen._common_ground(bytea, bytea, float8) IS 'EWKB twin of streetgen.common_ground';

CREATE OR REPLACE FUNCTION streetgen.common_ground(line geometry, other geometry, distance float8 DEFAULT 10)
    RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 1000 SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._common_ground(line::bytea, other::bytea, distance) $$;
COMMENT ON FUNCTION streetgen.common_ground(geometry, geometry, float8) IS
    'The share, 0 to 1, of a line''s ground that another line (LINESTRING each) has too, both dilated by distance '
    '(metres, 0.001 to 1000). Ground counts where the lines go side by side: within 30 degrees of one direction, '
    'either way. Where they part by g that is 1 - g / (2 distance); a line that crosses shares nothing. A line that is '
    'no LINESTRING, a distance out of range: 22023. NULL for NULL. StreetGen paper, 3.1, which compares dilated axes.';
