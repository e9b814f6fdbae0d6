-- Two virtual towns with a divided highway between them.

CREATE OR REPLACE FUNCTION streetgen._two_towns(srid integer, x float8, y float8, seed bigint, keeps_left boolean,
    option_names text[], option_values float8[])
    RETURNS TABLE(geom bytea, width float8, lane_count integer, importance integer, name text, direction text,
        speed float8, kind text, bridge boolean, built_up boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 300 COST 1000000 AS 'MODULE_PATHNAME', 'streetgen_two_towns';
COMMENT ON FUNCTION streetgen._two_towns(integer, float8, float8, bigint, boolean, text[], float8[]) IS
    'The axes of streetgen.create_two_towns, geom as EWKB; options as of _virtual_city.';

CREATE OR REPLACE FUNCTION streetgen.two_towns_option()
    RETURNS TABLE(name text, value float8[], unit text, description text, minimum float8, maximum float8)
    LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 30 AS 'MODULE_PATHNAME', 'streetgen_two_towns_options';
COMMENT ON FUNCTION streetgen.two_towns_option() IS
    'The options of streetgen.create_two_towns that are numbers: default value (of a list, all its numbers), unit, '
    'meaning and range. Those of streetgen.city_option() are of each town.';

CREATE OR REPLACE FUNCTION streetgen._towns_driving_side(options jsonb) RETURNS text
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    side constant jsonb := coalesce(options -> 'driving_side', '"right"');
BEGIN
    IF side NOT IN ('"right"', '"left"') THEN
        RAISE EXCEPTION 'option "driving_side" is %, expected "right" or "left"', left(side::text, 100)
            USING ERRCODE = '22023', HINT = 'Where traffic keeps left all is mirrored from north to south.';
    END IF;
    RETURN side ->> 0;
END $$;
COMMENT ON FUNCTION streetgen._towns_driving_side(jsonb) IS
    'Option driving_side of streetgen.create_two_towns, right without it; raises 22023 for another word.';

CREATE OR REPLACE FUNCTION streetgen.create_two_towns(model name, srid integer, x float8, y float8, seed bigint,
    options jsonb DEFAULT '{}') RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    side text;
    given record;
    drawn bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_one_build(), streetgen._check_given('model', model, 'srid', srid::text, 'x', x::text,
        'y', y::text, 'seed', seed::text);
    side := streetgen._towns_driving_side(options);
    given := streetgen._city_options(CASE jsonb_typeof(options) WHEN 'object' THEN options - 'driving_side'
        ELSE options END, 'two_towns_option');
    PERFORM streetgen.create_model(model, srid, subjects => '{ramp,junction,height,bridge}', driving_side => side);
    -- What a car needs to reach the speed of the highway.
    PERFORM streetgen.set(model, 'merging_length', '250');
    PERFORM streetgen._pause();
    INSERT INTO axis (geom, width, lane_count, importance, name, direction, speed, kind, level, sidewalk_left,
            sidewalk_right, source, source_ref)
        SELECT t.geom::geometry, t.width, t.lane_count, t.importance, t.name, t.direction, t.speed, t.kind,
            t.bridge::integer, w.none, w.none, 'two towns', ordinality
        FROM streetgen._two_towns(srid, x, y, seed, side = 'left', given.names, given.numbers) WITH ORDINALITY t
            CROSS JOIN LATERAL (SELECT CASE WHEN NOT t.built_up THEN 0 END AS none) w;
    GET DIAGNOSTICS drawn = ROW_COUNT;
    PERFORM streetgen._check_scale(format('SELECT ''axis '' || axis_id AS label, geom FROM %I.axis', model));
    ANALYZE axis;
    RETURN drawn;
END $$;
COMMENT ON FUNCTION streetgen.create_two_towns(name, integer, float8, float8, bigint, jsonb) IS
    'Makes a model of two virtual towns, Weston and Easton, and the divided highway between them; returns how many '
    'axes. From x, y, the lower left corner, in metres, the highway leads from west to east: a carriageway each way, '
    'of kind motorway. The road of each town crosses it by a bridge, with four ramps to and from both directions, of '
    'kind motorway_link. A country road runs along either side, and roads that join the two pass over the highway. '
    'The model computes ramps, junctions, heights and bridges; its ground is at height 0, and merging_length is 250 '
    'm. Equal arguments give equal towns on every machine. options: driving_side, "right" or "left", which mirrors '
    'all from north to south, and what streetgen.two_towns_option() lists. The streets are for streetgen.generate. '
    'Bad options, options that leave no room for each other, and a corner that is no number: 22023 with a hint; NULL: '
    '22004; else errors as of create_virtual_city. A refused call leaves no model. Source: Wilkie, Sewall and Lin, '
    'figure 5a.';
