-- Where footways lead over streets: the pedestrian crossings that they make, of models that compute objects too.

CREATE OR REPLACE FUNCTION streetgen._make_footway_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
    crossing constant boolean := 'footway' = ANY (subjects);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' <> ALL (subjects) THEN
        PERFORM streetgen._drop_own_functions(model, '{_has_crossing_footways,_footway_crossings,_footway_over,'
            '_footway_kerb_at}');
        RETURN;
    END IF;
    PERFORM streetgen._compose_function(model, '_has_crossing_footways()', 'boolean', CASE WHEN crossing
            THEN streetgen._part('has_crossing_footways') ELSE 'BEGIN RETURN false; END' END,
            '_has_crossing_footways()', 'Whether footways make pedestrian crossings', 'STABLE'),
        streetgen._compose_function(model, '_footway_crossings(edges bigint[])',
            'SETOF streetgen.footway_crossing', CASE WHEN crossing
            THEN streetgen._part('footway_crossings') ELSE 'BEGIN END' END, '_footway_crossings(bigint[])',
            'Where footways lead over edges', 'STABLE ROWS 10'),
        streetgen._compose_function(model, '_footway_over(place geometry, level integer)', 'bigint', CASE WHEN crossing
            THEN streetgen._part('footway_over') ELSE 'BEGIN RETURN NULL; END' END,
            '_footway_over(geometry, integer)', 'The footway on which one crosses at a place of an axis', 'STABLE'),
        streetgen._compose_function(model, '_footway_kerb_at(place geometry, across geometry)', 'text',
            CASE WHEN crossing THEN streetgen._part('footway_kerb_at') ELSE 'BEGIN RETURN NULL; END' END,
            '_footway_kerb_at(geometry, geometry)', 'The kerb that footways come over at one end of a crossing, by '
            'that end and the one across', 'STABLE');
END $$;
COMMENT ON FUNCTION streetgen._make_footway_functions(name) IS
    'Makes the functions of a model that tell where footways lead over streets. They tell of none where it computes no '
    'footways, and are gone where it computes no objects.';
