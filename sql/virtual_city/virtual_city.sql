-- A virtual city to order: test data of any size, and a model of it.

CREATE OR REPLACE FUNCTION streetgen._virtual_city(srid integer, x float8, y float8, extent_width float8,
    extent_height float8, seed bigint, option_names text[], option_values float8[])
    RETURNS TABLE(geom bytea, width float8, lane_count integer, importance integer, name text, direction text,
        speed float8, kind text, bridge boolean, built_up boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 1500 COST 1000000 AS 'MODULE_PATHNAME', 'streetgen_virtual_city';
COMMENT ON FUNCTION streetgen._virtual_city(integer, float8, float8, float8, float8, bigint, text[], float8[]) IS
    'The axes of streetgen.virtual_city as EWKB, in the columns of _two_towns; options as pairs of name and number, a '
    'list by repeating its name.';

CREATE OR REPLACE FUNCTION streetgen._city_density(at_x float8, at_y float8, x float8, y float8, width float8,
    height float8, option_names text[], option_values float8[]) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_city_density';
COMMENT ON FUNCTION streetgen._city_density(float8, float8, float8, float8, float8, float8, text[], float8[]) IS
    'streetgen.city_density with its options as pairs of name and number.';

CREATE OR REPLACE FUNCTION streetgen.city_option()
    RETURNS TABLE(name text, value float8[], unit text, description text, minimum float8, maximum float8)
    LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 30 AS 'MODULE_PATHNAME', 'streetgen_city_options';
COMMENT ON FUNCTION streetgen.city_option() IS
    'The options of streetgen.virtual_city: default value (of a list, all its numbers), unit, meaning and range.';

CREATE OR REPLACE FUNCTION streetgen._city_options(options jsonb, list text, OUT names text[], OUT numbers float8[])
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wrong record;
BEGIN
    IF jsonb_typeof(options) IS DISTINCT FROM 'object' THEN
        RAISE EXCEPTION 'the options are %, expected an object', coalesce(options::text, 'NULL')
            USING ERRCODE = '22023',
            HINT = format('For example {"right_angles": 1}; {} takes the defaults. SELECT * FROM streetgen.%s() '
            'lists them.', list);
    END IF;
    SELECT o.key, o.value INTO wrong FROM jsonb_each(options) o
        WHERE jsonb_typeof(o.value) NOT IN ('number', 'array')
            OR NOT EXISTS (SELECT FROM jsonb_path_query(o.value, 'lax $[*][*]'))
            OR EXISTS (SELECT FROM jsonb_path_query(o.value, 'lax $[*][*]') v WHERE jsonb_typeof(v) <> 'number'
                OR NOT abs(v::text::numeric) < 1e300)
        ORDER BY o.key LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'option "%" is %, expected a number or a list of numbers', wrong.key,
            left(wrong.value::text, 100) USING ERRCODE = '22023',
            HINT = format('SELECT * FROM streetgen.%s() lists the options with their ranges.', list);
    END IF;
    SELECT coalesce(array_agg(o.key ORDER BY o.key, v.i), '{}'),
        coalesce(array_agg(v.number::text::float8 ORDER BY o.key, v.i), '{}') INTO names, numbers
        FROM jsonb_each(options) o, jsonb_path_query(o.value, 'lax $[*][*]') WITH ORDINALITY v(number, i);
END $$;
COMMENT ON FUNCTION streetgen._city_options(jsonb, text) IS
    'Options as pairs of name and number; raises 22023 for what is neither a number nor a list of numbers. The hint '
    'names the function that lists them.';

CREATE OR REPLACE FUNCTION streetgen._check_city(srid integer, x float8, y float8, width float8, height float8,
    seed bigint) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_given('srid', srid::text, 'x', x::text, 'y', y::text, 'width', width::text, 'height',
        height::text, 'seed', seed::text);
    PERFORM streetgen._check_srid(srid);
END $$;
COMMENT ON FUNCTION streetgen._check_city(integer, float8, float8, float8, float8, bigint) IS
    'Raises 22023 as _check_srid, 22004 for an argument that is NULL.';

CREATE OR REPLACE FUNCTION streetgen.virtual_city(srid integer, x float8, y float8, width float8, height float8,
    seed bigint, options jsonb DEFAULT '{}')
    RETURNS SETOF streetgen.city_axis
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 1500 SET search_path = pg_catalog, public
    AS $$
DECLARE
    given record;
BEGIN
    PERFORM streetgen._check_city(srid, x, y, width, height, seed);
    given := streetgen._city_options(options, 'city_option');
    RETURN QUERY SELECT c.geom::geometry, c.width, c.lane_count, c.importance, c.name, c.direction, c.speed
        FROM streetgen._virtual_city(srid, x, y, width, height, seed, given.names, given.numbers) c;
END $$;
COMMENT ON FUNCTION streetgen.virtual_city(integer, float8, float8, float8, float8, bigint, jsonb) IS
    'Axes of a virtual city by the fractal of Pluciennik (2011), first road first: LINESTRINGs on whole millimetres '
    'in a projection in metres, with a vertex wherever two of them meet, all connected. Lower left corner, width and '
    'height in metres; streetgen.city_option() lists the options. Equal arguments give an equal city on every '
    'machine. An unfit SRID, an extent under about 80 m or over 1000 km, an unknown option or one out of range: 22023 '
    'with a hint; NULL: 22004.';

CREATE OR REPLACE FUNCTION streetgen.city_density(at_x float8, at_y float8, x float8, y float8, width float8,
    height float8, options jsonb DEFAULT '{}') RETURNS float8
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    given record := streetgen._city_options(options, 'city_option');
BEGIN
    RETURN streetgen._city_density(at_x, at_y, x, y, width, height, given.names, given.numbers);
END $$;
COMMENT ON FUNCTION streetgen.city_density(float8, float8, float8, float8, float8, float8, jsonb) IS
    'Density of a virtual city at a place, 0 to 1: exp(-dx^2 / 2 sx^2 - dy^2 / 2 sy^2) about the centre where it is '
    'greatest, sx and sy the share deviation of width and height. A road starts only where it is at least a number '
    'drawn anew from option threshold. Bad values: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.create_virtual_city(model name, srid integer, x float8, y float8, width float8,
    height float8, seed bigint, options jsonb DEFAULT '{}') RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    drawn bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_one_build(), streetgen._check_given('model', model);
    PERFORM streetgen._check_city(srid, x, y, width, height, seed);
    PERFORM streetgen.create_model(model, srid);
    PERFORM streetgen._pause();
    INSERT INTO axis (geom, width, lane_count, importance, name, direction, speed, source, source_ref)
        SELECT c.geom, c.width, c.lane_count, c.importance, c.name, c.direction, c.speed, 'virtual city', ordinality
        FROM streetgen.virtual_city(srid, x, y, width, height, seed, options) WITH ORDINALITY c;
    GET DIAGNOSTICS drawn = ROW_COUNT;
    PERFORM streetgen._check_scale(format('SELECT ''axis '' || axis_id AS label, geom FROM %I.axis', model));
    ANALYZE axis;
    RETURN drawn;
END $$;
COMMENT ON FUNCTION streetgen.create_virtual_city(name, integer, float8, float8, float8, float8, bigint, jsonb) IS
    'Makes a model and fills its axes with streetgen.virtual_city; returns how many. The streets are for '
    'streetgen.generate. Errors as of create_model and virtual_city, and 22023 where the projection is more than 1 % '
    'off in scale; then there is no model.';
