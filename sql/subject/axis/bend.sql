-- The bend of an axis near a place.

CREATE OR REPLACE FUNCTION streetgen._bend_of(axis geometry, place geometry, low float8, high float8,
    OUT abscissa float8, OUT vertex geometry, OUT half_angle float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT abscissa, geom, ST_Angle(before, geom, after) / 2 FROM (
        SELECT geom, lag(geom) OVER (ORDER BY n) AS before, lead(geom) OVER (ORDER BY n) AS after,
            sum(step) OVER (ORDER BY n) AS abscissa
        FROM (SELECT path[1] AS n, geom, coalesce(ST_Distance(geom, lag(geom) OVER (ORDER BY path)), 0) AS step
            FROM ST_DumpPoints(ST_Force2D(axis))) p) v
    WHERE before IS NOT NULL AND after IS NOT NULL AND abscissa > low + 0.001 AND abscissa < high - 0.001
        AND ST_DWithin(geom, place, 1)
    ORDER BY ST_Distance(geom, place), abscissa LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._bend_of(geometry, geometry, float8, float8) IS
    'The vertex of an axis within 1 m of a place, between two abscissas: the nearest, with half the angle (radians) '
    'between its segments; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._bend_at(axis geometry, place float8,
    OUT abscissa float8, OUT vertex geometry, OUT half_angle float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT b.* FROM streetgen._bend_of(axis, ST_LineInterpolatePoint(ST_Force2D(axis),
        least(place / ST_Length2D(axis), 1)), 0, ST_Length2D(axis)) b
    $$;
COMMENT ON FUNCTION streetgen._bend_at(geometry, float8) IS
    'The bend of an axis that a decision at an abscissa is about: the nearest vertex within 1 m, as _bend_of.';

CREATE OR REPLACE FUNCTION streetgen._bend_key(axis bigint, vertex geometry) RETURNS bigint
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    -- A program that reads keys as float8 reads 53 bits.
    AS $$ SELECT hash_record_extended(ROW(axis, ST_X(vertex), ST_Y(vertex)), 0) & 9007199254740991 $$;
COMMENT ON FUNCTION streetgen._bend_key(bigint, geometry) IS
    'Key of the bend of an axis at a vertex: two have the same once in a million models of a hundred thousand bends.';
