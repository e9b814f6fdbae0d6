-- The fit of streets to observations: it writes proposals, and no axis.

CREATE OR REPLACE FUNCTION streetgen._fit_hashes(model name, axes bigint[])
    RETURNS TABLE(axis_id bigint, axis_hash bigint)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT a.axis_id, hash_record_extended(ROW(a.geom::bytea, a.width, a.width_end, a.roadway_offset,
            a.sidewalk_left, a.sidewalk_right), 0)
        FROM axis a WHERE axes IS NULL OR a.axis_id = ANY (axes);
END $$;
COMMENT ON FUNCTION streetgen._fit_hashes(name, bigint[]) IS
    'A number of what a fit changes of each of some axes (NULL: of all): of an axis that was edited it is another.';

CREATE OR REPLACE FUNCTION streetgen._fit_moves(options jsonb) RETURNS text
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    unknown text;
    moves text;
BEGIN
    IF jsonb_typeof(options) IS DISTINCT FROM 'object' THEN
        RAISE EXCEPTION 'the options are %, expected an object', coalesce(options::text, 'NULL') USING
            ERRCODE = '22023', HINT = 'For example {"moves": "axis"}.';
    END IF;
    SELECT key INTO unknown FROM jsonb_object_keys(options) key WHERE key <> 'moves' LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'there is no option "%"', unknown USING ERRCODE = '22023',
            HINT = 'The option is moves; bounds and weights are settings, whose names begin with fit_.';
    END IF;
    moves := coalesce(options ->> 'moves', 'roadway');
    IF moves NOT IN ('roadway', 'axis', 'corner') THEN
        RAISE EXCEPTION 'option moves is "%", expected roadway, axis or corner', moves USING ERRCODE = '22023',
            HINT = 'roadway changes widths and offsets, axis also moves the axes, corner changes radii.';
    END IF;
    RETURN moves;
END $$;
COMMENT ON FUNCTION streetgen._fit_moves(jsonb) IS
    'Option moves of a fit: roadway, axis or corner. Another option or value: 22023.';

CREATE OR REPLACE FUNCTION streetgen._propose_fit(model name, of_axes bigint[], moves text) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    rules constant float8[] := streetgen._fit_rules(model, moves = 'axis');
    changed constant float8 := 0.01;
    model_name constant name := model;
    what_moves constant text := moves;
    run bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    WITH given AS MATERIALIZED (SELECT * FROM streetgen._fit_axes(model_name, of_axes)),
    seen AS MATERIALIZED (SELECT * FROM streetgen._fit_observations(model_name, of_axes, false)),
    fitted AS MATERIALIZED (
        SELECT f.* FROM given g, seen s, streetgen._fit_streets(g.lines, g.widths, g.lanes, g.moves, g.stretch_axes,
            g.stretches, g.nodes, s.kinds, s.relations, s.x, s.y, s.confidence, s.weight, s.width, rules,
            (SELECT value FROM setting WHERE name = 'fit_loss')) f),
    new AS MATERIALIZED (
        SELECT a.axis_id, a.geom AS line, f.geom, f.used, f.mean_before, f.mean_after, h.axis_hash,
            CASE WHEN widens THEN round(at_start::numeric, 3)::float8 END AS width,
            CASE WHEN widens AND tapers THEN round(at_end::numeric, 3)::float8 END AS width_end,
            CASE WHEN abs(f.new_offset - u.roadway_offset) > changed
                THEN round(f.new_offset::numeric, 3)::float8 END AS roadway_offset,
            CASE WHEN abs(f.new_sidewalk_left - coalesce(a.sidewalk_left, -1)) > changed
                THEN round(f.new_sidewalk_left::numeric, 2)::float8 END AS sidewalk_left,
            CASE WHEN abs(f.new_sidewalk_right - coalesce(a.sidewalk_right, -1)) > changed
                THEN round(f.new_sidewalk_right::numeric, 2)::float8 END AS sidewalk_right
        FROM fitted f JOIN given g ON f.number > 0 JOIN axis a ON a.axis_id = g.axis_ids[f.number]
            JOIN axis_used u ON u.axis_id = a.axis_id
            JOIN streetgen._fit_hashes(model_name, of_axes) h ON h.axis_id = a.axis_id,
            -- A taper of centimetres is none.
            LATERAL (SELECT abs(f.new_width - f.new_width_end) > 0.05 AS tapers,
                (f.new_width + f.new_width_end) / 2 AS mean) t,
            LATERAL (SELECT CASE WHEN tapers THEN f.new_width ELSE mean END AS at_start,
                CASE WHEN tapers THEN f.new_width_end ELSE mean END AS at_end) w,
            LATERAL (SELECT f.used > 0 AND (abs(at_start - u.width) > changed OR abs(at_end - u.width_end) > changed)
                AS widens) c
        WHERE g.moves[f.number]),
    proposed AS MATERIALIZED (
        SELECT * FROM new WHERE num_nonnulls(width, roadway_offset, sidewalk_left, sidewalk_right) > 0
            OR geom::bytea <> line::bytea),
    run AS (
        INSERT INTO fit_run (moves, axes, observations, used, mean_before, median_before, mean_after, median_after,
                iterations)
        SELECT what_moves, (SELECT count(*) FROM proposed), cardinality(s.kinds), f.used, f.mean_before,
            f.median_before, f.mean_after, f.median_after, f.iterations
        FROM fitted f, seen s WHERE f.number = 0 RETURNING fit_run),
    written AS (
        INSERT INTO fit_proposal (fit_run, axis_id, geom, width, width_end, roadway_offset, sidewalk_left,
                sidewalk_right, before, after, observations, axis_hash)
        SELECT r.fit_run, p.axis_id, p.geom, p.width, p.width_end, p.roadway_offset, p.sidewalk_left,
            p.sidewalk_right, p.mean_before, p.mean_after, p.used, p.axis_hash
        FROM run r, proposed p ORDER BY p.axis_id)
    SELECT r.fit_run INTO run FROM run r;
    RETURN run;
END $$;
COMMENT ON FUNCTION streetgen._propose_fit(name, bigint[], text) IS
    'Fits axes of a model (NULL: all), writes the run and a proposal for each axis that would change by over 1 cm, and '
    'gives the run. Widths are rounded to millimetres, sidewalks to centimetres.';

CREATE OR REPLACE FUNCTION streetgen._fit_touching(model name, run bigint) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wanted constant bigint := run;
    tolerance constant float8 := streetgen._tolerance(model);
    reach constant float8 := tolerance + 3 * streetgen._setting_number(model, 'fit_move');
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT DISTINCT v.axis_id
        FROM fit_proposal p JOIN axis a USING (axis_id), LATERAL (SELECT * FROM axis o
                WHERE o.geom && ST_Expand(p.geom, reach) AND o.axis_id <> p.axis_id AND o.level = a.level OFFSET 0) o
            LEFT JOIN fit_proposal q ON (q.fit_run, q.axis_id) = (wanted, o.axis_id),
            LATERAL (VALUES (p.axis_id), (q.axis_id)) v(axis_id)
        WHERE p.fit_run = wanted AND p.geom::bytea <> a.geom::bytea AND v.axis_id IS NOT NULL
            AND ST_DWithin(p.geom, coalesce(q.geom, o.geom), tolerance)
            AND NOT ST_DWithin(a.geom, o.geom, tolerance));
END $$;
COMMENT ON FUNCTION streetgen._fit_touching(name, bigint) IS
    'The axes of a run whose proposed lines come to touch others of their level, which would join streets.';

CREATE OR REPLACE FUNCTION streetgen._fit_without(model name, run bigint, of_axes bigint[], touching bigint[])
    RETURNS bigint[]
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wanted constant bigint := run;
BEGIN
    PERFORM streetgen._use_model(model);
    DELETE FROM fit_run r WHERE r.fit_run = wanted;
    RETURN ARRAY(SELECT a.axis_id FROM axis a WHERE (of_axes IS NULL OR a.axis_id = ANY (of_axes))
        AND a.axis_id <> ALL (touching) ORDER BY 1);
END $$;
COMMENT ON FUNCTION streetgen._fit_without(name, bigint, bigint[], bigint[]) IS
    'Forgets a run, and gives the axes that may change without those that came to touch others.';

CREATE OR REPLACE FUNCTION streetgen._fit(model name, of_axes bigint[], options jsonb) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    moves constant text := streetgen._fit_moves(options);
    most_rounds constant integer := 4;
    run bigint;
    touching bigint[];
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._require_subject(model, 'fit'),
        streetgen._require_axes(model, of_axes);
    IF moves = 'corner' THEN
        RETURN streetgen._propose_corners(model, of_axes);
    END IF;
    FOR round IN 1 .. most_rounds LOOP
        run := streetgen._propose_fit(model, of_axes, moves);
        touching := CASE moves WHEN 'axis' THEN streetgen._fit_touching(model, run) ELSE '{}' END;
        EXIT WHEN touching = '{}' OR round = most_rounds;
        -- An axis that would join another street stays, and its neighbours are fitted anew.
        of_axes := streetgen._fit_without(model, run, of_axes, touching);
    END LOOP;
    RETURN run;
END $$;
COMMENT ON FUNCTION streetgen._fit(name, bigint[], jsonb) IS
    'As streetgen.fit, and gives the run.';

CREATE OR REPLACE FUNCTION streetgen._fit_run_of(model name, run bigint)
    RETURNS TABLE(fit_run bigint, axes bigint, observations bigint, used bigint, mean_before float8,
        median_before float8, mean_after float8, median_after float8, iterations integer)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    wanted constant bigint := run;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT r.fit_run, r.axes, r.observations, r.used, r.mean_before, r.median_before, r.mean_after,
        r.median_after, r.iterations FROM fit_run r WHERE r.fit_run = wanted;
END $$;
COMMENT ON FUNCTION streetgen._fit_run_of(name, bigint) IS 'A run of streetgen.fit as that function tells of it.';

-- SQL, since PL/pgSQL refuses a column that has the name of an argument.
CREATE OR REPLACE FUNCTION streetgen.fit(model name, axes bigint[] DEFAULT NULL, options jsonb DEFAULT '{}')
    RETURNS TABLE(fit_run bigint, axes bigint, observations bigint, used bigint, mean_before float8,
        median_before float8, mean_after float8, median_after float8, iterations integer)
    LANGUAGE sql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$ SELECT * FROM streetgen._fit_run_of($1, streetgen._fit($1, $2, $3)) $$;
COMMENT ON FUNCTION streetgen.fit(name, bigint[], jsonb) IS
    'Fits streets to what table observation holds, and writes proposals to fit_proposal, one for each axis that would '
    'change; no axis changes before streetgen.accept_fit. axes: those that may change, NULL: all. options: moves is '
    'roadway (widths and where the roadway lies beside its axis; the default), axis (also nodes and vertices; an axis '
    'that would come to touch another street stays) or '
    'corner: radii, a proposal of corner_proposal for each corner that the arc of an observed kerb answers and whose '
    'radius is not by hand; fit widths first. Gives a row: the run, its proposals, points observed and used, mean and '
    'median distance (metres) of kerbs observed to those of the model, before and as proposed, and rounds of the '
    'solver; of corners they are arcs and differences of radii. Bounds and weights are settings fit_…; StreetGen '
    'paper, section 4.8. Tells its progress and can be cancelled. An unknown option or axis: 22023; without the '
    'subject: 55000; without rights to edit: 42501.';
