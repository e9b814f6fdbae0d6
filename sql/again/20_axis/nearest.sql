-- The nearest by true distance. An order of the index by <-> is not exact to the last digit, and PostgreSQL then
-- refuses it; the nearest box bounds the distance, and the exact distance decides within it.

CREATE OR REPLACE FUNCTION streetgen._nearest_axis(model name, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    nearest bigint;
BEGIN
    EXECUTE format('SELECT axis_id FROM %1$I.axis
        WHERE ST_DWithin(geom, $1, (SELECT ST_Distance(b.geom, $1) FROM (SELECT geom FROM %1$I.axis ORDER BY geom <#> $1
            LIMIT 1) b))
        ORDER BY ST_Distance(geom, $1), axis_id LIMIT 1', model) INTO nearest USING place;
    RETURN nearest;
END $$;
COMMENT ON FUNCTION streetgen._nearest_axis(name, geometry) IS
    'Key of the axis nearest to a place, the smallest of equal ones; NULL in a model without axes.';
