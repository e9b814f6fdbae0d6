-- Lines, arrows and signal heads before crossings.

CREATE OR REPLACE FUNCTION streetgen._lay_paint(way bytea, width float8, between_junctions boolean,
    crossings bytea[], lines bytea[], arrows boolean[], stays boolean[], ahead float8, of_arm float8)
    RETURNS TABLE(number integer, moves boolean, has_room boolean, cosine float8, sine float8, x float8, y float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500 ROWS 2 AS 'MODULE_PATHNAME', 'streetgen_lay_paint';
COMMENT ON FUNCTION streetgen._lay_paint(bytea, float8, boolean, bytea[], bytea[], boolean[], boolean[], float8,
    float8) IS
    'How paint on a lane moves, so that it lies before the crossings there: turned, and shifted by x and y. way: the '
    'line of the lane in driving direction (EWKB). between_junctions: the lane comes from a junction, too. crossings: '
    'their grounds (MULTIPOLYGON, EWKB). lines: across the lane, or of arrows from foot to tip; stays: they lie before '
    'a ring. ahead and of_arm as the settings line_before_crossing and crossing_of_arm. has_room false: nothing is '
    'painted.';

CREATE OR REPLACE FUNCTION streetgen._waiting_place(lane geometry, along_axis boolean, line geometry,
    OUT geom geometry, OUT angle float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT place, streetgen._direction_on(way::bytea, (streetgen._locate_on(way::bytea, place::bytea))[1], 0)
    FROM (SELECT CASE WHEN along_axis THEN lane ELSE ST_Reverse(lane) END AS way OFFSET 0) w,
        LATERAL (SELECT coalesce(ST_LineInterpolatePoint(line, 0.5::float8), ST_EndPoint(way)) AS place OFFSET 0) p $$;
COMMENT ON FUNCTION streetgen._waiting_place(geometry, boolean, geometry) IS
    'Where traffic of a lane waits, and its direction there, degrees clockwise from the north: in the middle of a '
    'line across the lane, painted or not, or where the lane ends (line NULL).';

CREATE OR REPLACE FUNCTION streetgen._line_statement(subjects text[], chosen text, OUT crossings text, OUT lay text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    places constant jsonb := jsonb_build_object('chosen', chosen);
    with_objects constant boolean := 'object' = ANY (subjects);
BEGIN
    crossings := streetgen._fill_template(streetgen._part('crossings_of_controls'), places || jsonb_build_object(
        'unknown', CASE WHEN with_objects THEN streetgen._part('without_object') ELSE '' END));
    IF with_objects THEN
        crossings := streetgen._fill_template(streetgen._part('crossings_of_objects'),
            places || jsonb_build_object('crossings_of_controls', crossings));
    END IF;
    lay := streetgen._fill_template(streetgen._part('lay_chosen_lines'), places || jsonb_build_object('crossings',
        crossings, 'or_accepted', CASE WHEN 'roundabout' = ANY (subjects) THEN streetgen._part('or_accepted')
            ELSE '' END, 'heads', CASE WHEN 'signal' = ANY (subjects)
            THEN streetgen._fill_template(streetgen._part('heads_at_lines'), places) ELSE '' END));
END $$;
COMMENT ON FUNCTION streetgen._line_statement(text[], text) IS
    'The query of the crossings of edges, and the statements that lay lines before them, of the edges e that are '
    'chosen by a condition.';

CREATE OR REPLACE FUNCTION streetgen._make_line_function(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (subjects) THEN
        PERFORM streetgen._drop_own_functions(model, '{_lay_lines}');
        RETURN;
    END IF;
    PERFORM streetgen._compose_function(model, '_lay_lines(axes bigint[])', 'void', streetgen._fill_template(
            streetgen._part('lay_lines'), jsonb_build_object('lay_all', whole.lay, 'lay_some', few.lay,
            'crossings_of_some', few.crossings)),
        '_lay_lines(bigint[])', 'Lays what is painted on the lanes of axes (NULL: of all) before the crossings there',
        'VOLATILE SET jit = off SET plan_cache_mode = auto')
    FROM streetgen._line_statement(subjects, 'true') whole,
        streetgen._line_statement(subjects, 'e.axis_id = ANY (axes)') few;
END $$;
COMMENT ON FUNCTION streetgen._make_line_function(name) IS
    'Makes the function of a model by which lines lie before crossings, or drops it where there are no lanes.';

CREATE OR REPLACE FUNCTION streetgen._settle_lane(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regprocedure(format('%I._lay_lines(bigint[])', model)) IS NOT NULL THEN
        PERFORM _lay_lines(axes);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._settle_lane(name, bigint[]) IS
    'After objects, junctions and signals are up to date: what is painted on the lanes of axes (NULL: of all) lies '
    'before the crossings there.';
