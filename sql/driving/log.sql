-- A user's log of drives: which of its columns say what.

CREATE OR REPLACE FUNCTION streetgen._log_number(samples regclass, mapping jsonb, name text, needed boolean)
    RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wanted constant text := coalesce(mapping ->> name, name);
    held text;
    type regtype;
BEGIN
    IF needed OR mapping ? name THEN
        held := streetgen._source_column(samples, wanted);
    END IF;
    SELECT a.attname, a.atttypid INTO held, type FROM pg_attribute a WHERE a.attrelid = samples
        AND a.attname = coalesce(held, wanted) AND a.attnum > 0 AND NOT a.attisdropped;
    IF NOT FOUND THEN
        RETURN 'NULL::float8';
    ELSIF name = 'time' AND type IN ('timestamp', 'timestamptz', 'interval', 'time') THEN
        RETURN concat('extract(epoch FROM log.', quote_ident(held), ')::float8');
    ELSIF type NOT IN ('float8', 'float4', 'numeric', 'integer', 'bigint', 'smallint') THEN
        RAISE EXCEPTION 'column "%" of table % is of type %, expected a number', held, samples, type
            USING ERRCODE = '22023', HINT = 'Map "' || name || '" to a column of numbers, or cast it in a view.';
    END IF;
    RETURN concat('log.', quote_ident(held), '::float8');
END $$;
COMMENT ON FUNCTION streetgen._log_number(regclass, jsonb, text, boolean) IS
    'SQL of a number of a log: the column that the mapping names, else the one of this name; NULL where it is not '
    'needed and not there. No column of that name: 42703; one of no numbers: 22023.';

CREATE OR REPLACE FUNCTION streetgen._log_coordinate(samples regclass, mapping jsonb, name text, srid integer)
    RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    held text;
BEGIN
    IF NOT mapping ? 'geom' THEN
        RETURN streetgen._log_number(samples, mapping, name, name <> 'z');
    ELSIF mapping ? name THEN
        RAISE EXCEPTION 'the mapping has geom and %', name USING ERRCODE = '22023',
            HINT = 'The point of geom says where a sample is.';
    END IF;
    held := streetgen._source_column(samples, mapping ->> 'geom');
    IF NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = samples AND attname = held
        AND atttypid = 'geometry'::regtype) THEN
        RAISE EXCEPTION 'column "%" of table % is no geometry', held, samples USING ERRCODE = '22023',
            HINT = 'Map "geom" to a column of points.';
    END IF;
    held := concat('log.', quote_ident(held));
    held := concat('CASE WHEN GeometryType(', held, ') = ''POINT'' AND NOT ST_IsEmpty(', held, ') THEN ', held,
        ' END');
    RETURN format('ST_%s(ST_Transform(CASE WHEN ST_SRID(%2$s) = 0 THEN ST_SetSRID(%2$s, %3$s) ELSE %2$s END, %3$s))',
        upper(name), held, srid);
END $$;
COMMENT ON FUNCTION streetgen._log_coordinate(regclass, jsonb, text, integer) IS
    'SQL of x, y or z of a log: a number, or that of the point that the mapping names as geom, one without SRID in '
    'that of the model. A geom that is no geometry, or beside x, y or z: 22023.';

CREATE OR REPLACE FUNCTION streetgen._log_query(model name, samples regclass, mapping jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    actor text;
    odd text;
BEGIN
    PERFORM streetgen._known_keys(mapping, 'the mapping', '{time,x,y,z,geom,actor,speed,length}');
    SELECT key INTO odd FROM jsonb_each(mapping) WHERE jsonb_typeof(value) <> 'string' ORDER BY key LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'the mapping of "%" is %, expected a column name', odd, mapping -> odd
            USING ERRCODE = '22023', HINT = 'For example {"time": "t", "actor": "car_id"}.';
    END IF;
    IF mapping ? 'actor' THEN
        actor := streetgen._source_column(samples, mapping ->> 'actor');
    ELSE
        SELECT a.attname INTO actor FROM pg_attribute a WHERE a.attrelid = samples AND a.attname = 'actor'
            AND a.attnum > 0 AND NOT a.attisdropped;
    END IF;
    RETURN streetgen._fill_template(streetgen._part('drive_log'), jsonb_build_object(
        'samples', samples, 'actor', coalesce('log.' || quote_ident(actor), 'NULL'),
        'time', streetgen._log_number(samples, mapping, 'time', true),
        'x', streetgen._log_coordinate(samples, mapping, 'x', srid),
        'y', streetgen._log_coordinate(samples, mapping, 'y', srid),
        'z', streetgen._log_coordinate(samples, mapping, 'z', srid),
        'speed', streetgen._log_number(samples, mapping, 'speed', false),
        'length', streetgen._log_number(samples, mapping, 'length', false)));
END $$;
COMMENT ON FUNCTION streetgen._log_query(name, regclass, jsonb) IS
    'The query of a log of drives as arrays, in the order of time and actor: seconds, actors and their numbers from 0, '
    'places, speeds and lengths, NaN where nothing is logged. A mapping that is none: 22023; a missing column: 42703.';
