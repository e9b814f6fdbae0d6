-- Refuges: islands in the roadway on which people wait who cross it.

CREATE OR REPLACE FUNCTION streetgen._make_refuge_function(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._compose_function(model, '_refuge(axis bigint, line geometry, abscissa float8, width float8, '
            'angle float8, wanted float8)', 'geometry', streetgen._part('refuge'),
        '_refuge(bigint, geometry, float8, float8, float8, float8)',
        'The refuge (POLYGON) of a crossing that is to have one so wide: between the lanes of both directions, as wide '
        'as lanes of 2.5 m leave it, and 1.5 m longer than the crossing at both ends. NULL: without lanes, in a '
        'one-way street, on a lane for both directions, where it would be narrower than 1 m, or not all on the '
        'roadway',
        'STABLE');
END $$;
COMMENT ON FUNCTION streetgen._make_refuge_function(name) IS
    'Makes the function of a model that lays the refuge of a crossing.';
