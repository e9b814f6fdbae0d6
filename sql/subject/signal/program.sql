-- Signal programs: those that are known, and one of the user.

CREATE OR REPLACE FUNCTION streetgen.signal_phases(movements streetgen.signal_request[], cycle float8 DEFAULT 120,
    all_red float8 DEFAULT 6, step float8 DEFAULT 1, walk float8 DEFAULT 4, importance integer DEFAULT 5,
    turn_phases boolean DEFAULT NULL)
    RETURNS SETOF streetgen.signal_answer
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000 ROWS 30 AS 'MODULE_PATHNAME', 'streetgen_signal_phases';
COMMENT ON FUNCTION streetgen.signal_phases(streetgen.signal_request[], float8, float8, float8, float8, integer,
    boolean) IS
    'The states of few phases: approaches whose through traffic does not meet share one, and turns give way within it '
    '(permitted). A turn across others has a phase of its own from two lanes, over three lanes, or from 70 km/h on; '
    'turn_phases says it for all. Approaches below an importance have none, and give way. Amber lasts 1 s and the '
    'time to stop at 3 m/s2, at least 3 s. All red lasts until who entered last has left where who begins next comes, '
    'turning at 30 km/h, in wide turns faster, and no longer than all_red; phases follow each other so that this '
    'takes least. Greens are shared out by Webster''s rule, in a cycle of at least 30 s, where all flows are known, '
    'else by lanes and importance. Each lasts at least 7 s; people on foot have time in one that leaves their '
    'crossing free, from walk seconds to step on, and else a state of kind walk. Where the longest cycle is too '
    'short, walks that leave no room for a phase go, then turns lose their phases, then the least important streets '
    'share one and give way. States last a number of steps. No movements: no rows. NULL for NULL movements. A number '
    'out of range, an unknown turn: 22023; NULL in a row, or for another argument but turn_phases: 22004.';

CREATE OR REPLACE FUNCTION streetgen.signal_pairs(movements streetgen.signal_request[], cycle float8 DEFAULT 120,
    all_red float8 DEFAULT 6, step float8 DEFAULT 1, walk float8 DEFAULT 4, importance integer DEFAULT 5,
    turn_phases boolean DEFAULT NULL)
    RETURNS SETOF streetgen.signal_answer
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000 ROWS 60 AS 'MODULE_PATHNAME', 'streetgen_signal_pairs';
COMMENT ON FUNCTION streetgen.signal_pairs(streetgen.signal_request[], float8, float8, float8, float8, integer,
    boolean) IS
    'The states of the paper (Wilkie, Sewall and Lin, 4.3.1): each pair of roads has green for 20 s, amber and all red '
    'within; who turns back goes with the first pair of his road. Of the rules step alone counts. Arguments and errors '
    'are those of signal_phases. NULL for NULL movements.';

CREATE OR REPLACE FUNCTION streetgen._check_signal_answers(program text, junction bigint,
    movements streetgen.signal_request[], answers streetgen.signal_answer[]) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wrong text;
BEGIN
    WITH request AS (SELECT r.* FROM unnest(movements) WITH ORDINALITY
            r(lane_in, lane_out, along_in, along_out, approach, exit, turn, length, speed, lanes, importance, flow,
                precedence, conflicts, reaches, walks, walk_seconds, walk_reaches, number)),
    answer AS (SELECT a.*, r.number, r.conflicts FROM unnest(answers) a LEFT JOIN request r
        ON (r.lane_in, r.lane_out, r.along_in, r.along_out) = (a.lane_in, a.lane_out, a.along_in, a.along_out)),
    state AS (SELECT ordinality, min(duration) AS duration, max(duration) AS longest, min(kind) AS kind,
        max(kind) AS other FROM answer GROUP BY ordinality)
    SELECT what INTO wrong FROM (
        SELECT 1 AS place, format('a state with number %s', coalesce(ordinality::text, 'NULL')) AS what FROM state
            WHERE ordinality IS NULL OR ordinality < 1 OR ordinality > (SELECT count(*) FROM state)
        UNION ALL SELECT 2, format('state %s of kind "%s"', ordinality, coalesce(kind, 'NULL')) FROM answer
            WHERE kind IS NULL OR kind NOT IN ('green', 'amber', 'all_red', 'walk')
        UNION ALL SELECT 3, format('state %s of %s s', ordinality, coalesce(duration::text, 'NULL')) FROM answer
            WHERE NOT coalesce(duration BETWEEN 0.1 AND 3600, false)
        UNION ALL SELECT 4, format('two kinds or durations in state %s', ordinality) FROM state
            WHERE kind <> other OR duration <> longest
        UNION ALL SELECT 5, format('green in state %s from lane %s to lane %s, which is no movement there', ordinality,
            coalesce(lane_in::text, 'NULL'), coalesce(lane_out::text, 'NULL')) FROM answer
            WHERE kind = 'green' AND number IS NULL AND num_nonnulls(lane_in, lane_out) > 0
        UNION ALL SELECT 6, format('right of way "%s"', coalesce(right_of_way, 'NULL')) FROM answer
            WHERE number IS NOT NULL AND (right_of_way IN ('protected', 'permitted')) IS NOT TRUE
        UNION ALL SELECT 7, format('no green from lane %s to lane %s', lane_in, lane_out) FROM request r
            WHERE NOT EXISTS (SELECT FROM answer a WHERE a.number = r.number AND a.kind = 'green')
        UNION ALL SELECT 8, format('two protected movements that meet in state %s, from lane %s and from lane %s',
            a.ordinality, a.lane_in, b.lane_in) FROM answer a JOIN answer b USING (ordinality)
            WHERE a.right_of_way = 'protected' AND b.right_of_way = 'protected' AND b.number = ANY (a.conflicts)) w
        ORDER BY place, what LIMIT 1;
    IF wrong IS NOT NULL THEN
        PERFORM streetgen._refuse('22023',
            format('signal program %s gives %s at junction %s', program, wrong, junction),
            hint => 'States count from 1, last 0.1 to 3600 s, and give each movement green; protected movements do not '
                'meet. Setting signal_program to phases needs no function.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_signal_answers(text, bigint, streetgen.signal_request[],
    streetgen.signal_answer[]) IS
    'Raises 22023 where a signal program of the user leaves out a movement, lets protected ones meet, or gives states '
    'that are none.';

CREATE OR REPLACE FUNCTION streetgen._signal_answers(model name, program text, junction bigint,
    movements streetgen.signal_request[], cycle float8, all_red float8, step float8, walk float8,
    importance integer, turn_phases boolean) RETURNS SETOF streetgen.signal_answer
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 30 SET search_path = pg_catalog, public
    AS $$
DECLARE
    called text;
    answers streetgen.signal_answer[];
BEGIN
    IF program = 'phases' THEN
        RETURN QUERY SELECT * FROM streetgen.signal_phases(movements, cycle, all_red, step, walk,
            importance, turn_phases);
        RETURN;
    ELSIF program = 'paper' THEN
        RETURN QUERY SELECT * FROM streetgen.signal_pairs(movements, cycle, all_red, step, walk,
            importance, turn_phases);
        RETURN;
    END IF;
    called := streetgen._called_function(model, 'signal_program', program);
    BEGIN
        EXECUTE format('SELECT coalesce(array_agg(a), ''{}'') FROM %s($1) a', called) INTO answers
            USING movements;
    EXCEPTION WHEN OTHERS THEN
        PERFORM streetgen._refuse(SQLSTATE,
            format('signal program %s fails at junction %s: %s', called, junction, SQLERRM),
            hint => 'Mend the function, or set signal_program to phases.');
    END;
    PERFORM streetgen._check_signal_answers(program, junction, movements, answers);
    RETURN QUERY SELECT * FROM unnest(answers);
END $$;
COMMENT ON FUNCTION streetgen._signal_answers(name, text, bigint, streetgen.signal_request[], float8, float8,
    float8, float8, integer, boolean) IS
    'The states of a junction by a program: phases, paper, or a function of the user, as _called_function has it. '
    'One that gives what no controller can run: 22023; what the function raises comes with its SQLSTATE, naming '
    'function and junction.';

CREATE OR REPLACE FUNCTION streetgen._timed(answers streetgen.signal_answer[], cycle float8, durations float8[],
    step float8) RETURNS SETOF streetgen.signal_answer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$
    WITH state AS (SELECT DISTINCT ordinality, kind, coalesce(durations[ordinality], duration) AS duration
        FROM unnest(answers)),
    sum AS (SELECT sum(duration) AS whole, sum(duration) FILTER (WHERE kind = 'green') AS green, count(*)
        FILTER (WHERE kind = 'green') AS greens FROM state),
    -- A cycle too short for its states stays as long as they last with greens of 5 s.
    wanted AS (SELECT ordinality, duration * green_wanted / green AS duration, green_wanted FROM state, sum,
            LATERAL (SELECT greatest(cycle - whole + green, 5.0 * greens) AS green_wanted) w
        WHERE kind = 'green' AND cycle IS NOT NULL AND green > 0),
    -- Whole steps first; what is left goes to those that lost most, and what is no step to the first of them.
    stepped AS (SELECT ordinality, floor(duration / step + 1e-9) * step AS duration, green_wanted, row_number()
        OVER (ORDER BY duration / step - floor(duration / step + 1e-9) DESC, ordinality) AS turn FROM wanted),
    rest AS (SELECT max(green_wanted) - sum(duration) AS seconds FROM stepped),
    green AS (SELECT ordinality, duration + CASE WHEN turn <= floor(seconds / step + 1e-9) THEN step ELSE 0 END
            + CASE WHEN turn = 1 THEN seconds - floor(seconds / step + 1e-9) * step ELSE 0 END AS duration
        FROM stepped, rest)
    SELECT a.ordinality, coalesce(g.duration, s.duration), a.kind, a.lane_in, a.lane_out, a.along_in, a.along_out,
        a.right_of_way
    FROM unnest(answers) a JOIN state s USING (ordinality) LEFT JOIN green g USING (ordinality) $$;
COMMENT ON FUNCTION streetgen._timed(streetgen.signal_answer[], float8, float8[], float8) IS
    'States with the durations that were decided by hand, greens stretched or shortened to a cycle (seconds, NULL: as '
    'long as the states last) by whole steps.';
