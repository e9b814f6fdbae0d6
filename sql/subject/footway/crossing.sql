-- Footways that lead over streets make pedestrian crossings, in models that compute objects too.

CREATE OR REPLACE FUNCTION streetgen._way_across(axis geometry, abscissa float8, way geometry) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    -- Nobody paints one that runs on nearly along the street.
    AS $$ SELECT greatest(30, least(150, round((across - 180 * floor(across / 180))::numeric, 6)))::float8
        FROM (SELECT ST_LineLocatePoint(way, ST_LineInterpolatePoint(axis, least(1, abscissa / ST_Length(axis))))
                AS share, 4 / ST_Length(way) AS step) w,
            LATERAL (SELECT streetgen._direction_on(axis::bytea, abscissa, 0) - degrees(ST_Azimuth(
                ST_LineInterpolatePoint(way, greatest(0, share - step)),
                ST_LineInterpolatePoint(way, least(1, share + step)))) AS across) a $$;
COMMENT ON FUNCTION streetgen._way_across(geometry, float8, geometry) IS
    'The angle at which a way (LINESTRING) leads over an axis at an abscissa, degrees counter-clockwise from the axis, '
    '30 to 150, by how it runs within 4 m of there.';

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
