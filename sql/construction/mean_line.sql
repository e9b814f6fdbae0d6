-- The line in the middle between two lines.

CREATE OR REPLACE FUNCTION streetgen._mean_line(bytea[]) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_mean_line';
COMMENT ON FUNCTION streetgen._mean_line(bytea[]) IS 'EWKB twin of streetgen.mean_line';

CREATE OR REPLACE FUNCTION streetgen.mean_line(lines geometry[]) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100 SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN cardinality(lines) = 1 THEN lines[1]
        ELSE streetgen._mean_line(ARRAY(SELECT line::bytea FROM unnest(lines) WITH ORDINALITY l(line, i)
            ORDER BY i))::geometry END $$;
COMMENT ON FUNCTION streetgen.mean_line(geometry[]) IS
    'The line in the middle of several (LINESTRING each, one direction): at each share of its length the mean of the '
    'places that they have there, without heights. One line comes back as it is. NULL where there is none, or the mean '
    'is one place. A line that is NULL: 22004; a bad one: 22023. NULL for NULL.';
