-- The aspects of signals: at a time, and as a plan.

CREATE OR REPLACE FUNCTION streetgen._require_signals(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" computes no signals', model USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, ''signal'', true) computes them.', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_signals(name) IS
    'Raises 55000 where a model computes no signals.';

CREATE OR REPLACE FUNCTION streetgen.signals(model name, at float8)
    RETURNS TABLE(controller_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
        aspect text, right_of_way text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('at', at::text),
        streetgen._require_signals(model);
    IF NOT at BETWEEN -1e9 AND 1e9 THEN
        RAISE EXCEPTION 'at is % s', at USING ERRCODE = '22023', HINT = 'Expected -1e9 to 1e9 s.';
    END IF;
    RETURN QUERY
    WITH clock AS (SELECT controller_id, mod(((at - start_offset)::numeric), cycle::numeric) AS into_cycle, cycle
        FROM controller WHERE cycle > 0),
    state AS (SELECT s.*, sum(s.duration) OVER (PARTITION BY s.controller_id ORDER BY s.ordinality) AS ends,
        -- The green that an amber ends.
        max(s.ordinality) FILTER (WHERE s.kind = 'green') OVER (PARTITION BY s.controller_id ORDER BY s.ordinality)
            AS green FROM signal_state s),
    now AS (SELECT DISTINCT ON (c.controller_id) s.* FROM clock c JOIN state s USING (controller_id)
        WHERE s.ends > CASE WHEN into_cycle < 0 THEN into_cycle + cycle::numeric ELSE into_cycle END
        ORDER BY c.controller_id, s.ordinality),
    movement AS (SELECT DISTINCT controller_id, lane_in, lane_out, along_in, along_out FROM signal_movement)
    SELECT m.controller_id, m.lane_in, m.lane_out, m.along_in, m.along_out,
        CASE WHEN o.lane_in IS NULL OR n.kind IN ('all_red', 'walk') THEN 'red' ELSE n.kind END,
        CASE WHEN n.kind IN ('green', 'amber') THEN o.right_of_way END
    FROM movement m JOIN now n USING (controller_id) LEFT JOIN signal_movement o
        ON (o.controller_id, o.ordinality, o.lane_in, o.lane_out, o.along_in, o.along_out)
            = (m.controller_id, n.green, m.lane_in, m.lane_out, m.along_in, m.along_out)
    ORDER BY 1, 2, 3, 4, 5;
END $$;
COMMENT ON FUNCTION streetgen.signals(name, float8) IS
    'What each movement sees at a time (seconds since any moment, -1e9 to 1e9): aspect green, amber or red, and while '
    'it is not red its right of way (protected or permitted). A function of the time alone: the same again after each '
    'cycle. Another time: 22023; NULL: 22004; a model without signals: 55000.';

CREATE OR REPLACE FUNCTION streetgen.signal_plan(model name, controller bigint)
    RETURNS TABLE(ordinality integer, kind text, starts float8, ends float8, lane_in bigint, lane_out bigint,
        turn text, right_of_way text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    there boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('controller', controller::text),
        streetgen._require_signals(model);
    SELECT EXISTS (SELECT FROM controller WHERE controller_id = signal_plan.controller) INTO there;
    IF NOT there THEN
        RAISE EXCEPTION 'model "%" has no controller %', model, controller USING ERRCODE = '22023',
            HINT = format('SELECT controller_id FROM %I.controller lists them.', model);
    END IF;
    RETURN QUERY
    SELECT s.ordinality, s.kind, s.ends - s.duration, s.ends, m.lane_in, m.lane_out, t.turn, m.right_of_way
    FROM (SELECT *, sum(duration) OVER (ORDER BY ordinality) AS ends FROM signal_state
        WHERE controller_id = signal_plan.controller) s
        LEFT JOIN signal_movement m USING (controller_id, ordinality)
        LEFT JOIN movement t ON (t.lane_in, t.lane_out, t.along_in, t.along_out)
            = (m.lane_in, m.lane_out, m.along_in, m.along_out)
    ORDER BY s.ordinality, m.lane_in, m.lane_out, m.along_in, m.along_out;
END $$;
COMMENT ON FUNCTION streetgen.signal_plan(name, bigint) IS
    'The cycle of a controller: a row for each movement that has green in a state, and one for each state without. '
    'starts and ends are seconds from the start of the cycle. No such controller: 22023; NULL: 22004; a model without '
    'signals: 55000.';
