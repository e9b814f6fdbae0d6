-- The nearest by true distance. An order of the index by <-> is not exact to the last digit, and PostgreSQL then
-- refuses it; the nearest box bounds the distance, and the exact distance decides within it.

CREATE OR REPLACE FUNCTION streetgen._nearest_axis(model name, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    nearest bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT axis_id FROM axis
        WHERE ST_DWithin(geom, place, (SELECT ST_Distance(b.geom, place) FROM (SELECT geom FROM axis
            ORDER BY geom <#> place
            LIMIT 1) b))
        ORDER BY ST_Distance(geom, place), axis_id LIMIT 1 INTO nearest;
    RETURN nearest;
END $$;
COMMENT ON FUNCTION streetgen._nearest_axis(name, geometry) IS
    'Key of the axis nearest to a place, the smallest of equal ones; NULL in a model without axes.';
