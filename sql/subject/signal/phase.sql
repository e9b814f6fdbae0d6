-- Durations by hand stay with the phase that they were typed for: with what has green in it, whatever its number is.

CREATE OR REPLACE FUNCTION streetgen._phases(movements streetgen.signal_request[], answers streetgen.signal_answer[])
    RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT array_agg(coalesce(greens, kind) ORDER BY ordinality)
    FROM (SELECT a.ordinality, a.kind, string_agg(DISTINCT m.approach || ' ' || m.turn, '|') AS greens
        FROM unnest(answers) a LEFT JOIN unnest(movements) m
            ON a.kind = 'green' AND (m.lane_in, m.lane_out, m.along_in, m.along_out)
                = (a.lane_in, a.lane_out, a.along_in, a.along_out)
        GROUP BY a.ordinality, a.kind) s $$;
COMMENT ON FUNCTION streetgen._phases(streetgen.signal_request[], streetgen.signal_answer[]) IS
    'What each state serves: the edges that traffic with green comes by and its turns, such as 7 left|7 through, or '
    'the kind of a state without any.';

CREATE OR REPLACE FUNCTION streetgen._same_states(former text[], phases text[]) RETURNS integer[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    WITH state AS (
        SELECT former, place, phase, phase ~ '^[0-9]' AS green FROM (VALUES (true, former), (false, phases)) v(former,
            phases), unnest(phases) WITH ORDINALITY s(phase, place)),
    -- The greens around each state, which the cycle brings again.
    around AS (
        SELECT *, coalesce(max(place) FILTER (WHERE green) OVER before, max(place) FILTER (WHERE green) OVER whole)
                AS ends, coalesce(min(place) FILTER (WHERE green) OVER after,
                min(place) FILTER (WHERE green) OVER whole) AS begins
        FROM state WINDOW whole AS (PARTITION BY former),
            before AS (PARTITION BY former ORDER BY place ROWS UNBOUNDED PRECEDING),
            after AS (PARTITION BY former ORDER BY place ROWS BETWEEN CURRENT ROW AND UNBOUNDED FOLLOWING)),
    served AS (SELECT former, place, string_to_array(phase, '|') AS serves FROM state WHERE green),
    -- A phase is the one that served most of what it serves, and least else.
    same AS (
        SELECT DISTINCT ON (n.place) n.place, f.place AS former
        FROM served n JOIN served f ON NOT n.former AND f.former AND n.serves && f.serves
            CROSS JOIN LATERAL (SELECT count(*)::float8 AS common FROM unnest(n.serves) s WHERE s = ANY (f.serves)) c
        ORDER BY n.place, common / (cardinality(n.serves) + cardinality(f.serves) - common) DESC, f.place),
    -- Amber belongs to the green before it, all red to the greens around it, and a walk to people on foot.
    between AS (
        SELECT a.former, a.place, a.phase, CASE WHEN a.phase = 'walk' THEN 0 WHEN a.former THEN a.ends
                ELSE e.former END AS ends, CASE WHEN a.phase IN ('walk', 'amber') THEN 0
                WHEN a.former THEN a.begins ELSE b.former END AS begins,
            row_number() OVER (PARTITION BY a.former, a.phase, CASE WHEN a.phase <> 'walk' THEN a.ends END
                ORDER BY a.phase <> 'walk' AND a.place < a.ends, a.place) AS nth
        FROM around a LEFT JOIN same e ON e.place = a.ends LEFT JOIN same b ON b.place = a.begins WHERE NOT a.green)
    SELECT array_agg(coalesce(s.former, f.place)::integer ORDER BY n.place)
    FROM state n LEFT JOIN same s ON s.place = n.place LEFT JOIN between b ON NOT b.former AND b.place = n.place
        LEFT JOIN between f ON f.former AND (f.phase, f.ends, f.begins, f.nth) = (b.phase, b.ends, b.begins, b.nth)
    WHERE NOT n.former $$;
COMMENT ON FUNCTION streetgen._same_states(text[], text[]) IS
    'For each of some states which of some former ones it is, by what they serve; NULL: none of them.';

CREATE OR REPLACE FUNCTION streetgen._approaches(model name, movements streetgen.signal_request[])
    RETURNS TABLE(edge_id bigint, line geometry, place geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    SELECT e.edge_id, l.line, ST_LineInterpolatePoint(l.line, least(0.5, 20 / ST_Length(l.line)))
    FROM (SELECT m.approach, bool_or(m.along_in) AS along FROM unnest(movements) m GROUP BY m.approach) a
        JOIN edge e ON e.edge_id = a.approach CROSS JOIN LATERAL (SELECT ST_Force2D(CASE WHEN a.along
            THEN ST_Reverse(e.geom) ELSE e.geom END) AS line) l
    ORDER BY e.axis_id, e.start_abscissa;
END $$;
COMMENT ON FUNCTION streetgen._approaches(name, streetgen.signal_request[]) IS
    'The edges that movements come by: the line from the junction on, and a place on it some 20 m away.';

CREATE OR REPLACE FUNCTION streetgen._approaches_at(model name, movements streetgen.signal_request[],
    approaches geometry) RETURNS TABLE(edge_id bigint, place integer)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
    WITH street AS MATERIALIZED (SELECT * FROM streetgen._approaches(model, movements)),
    near AS MATERIALIZED (SELECT s.edge_id, d.path[1] AS place, ST_Distance(s.line, d.geom) AS metres
        FROM street s, ST_Dump(approaches) d),
    -- A street that is gone leaves its place to nobody: each is the nearest one of the other, and no farther than 20 m.
    nearest AS (SELECT *, row_number() OVER (PARTITION BY edge_id ORDER BY metres, place) AS of_edge,
        row_number() OVER (PARTITION BY place ORDER BY metres, edge_id) AS of_place FROM near)
    SELECT edge_id, place FROM nearest WHERE of_edge = 1 AND of_place = 1 AND metres <= 20 $$;
COMMENT ON FUNCTION streetgen._approaches_at(name, streetgen.signal_request[], geometry) IS
    'Which of some places lies on each edge that movements come by.';

CREATE OR REPLACE FUNCTION streetgen._numbered_phases(phases text[], numbers bigint[], others bigint[]) RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT array_agg(coalesce(named, phase) ORDER BY n)
    FROM unnest(phases) WITH ORDINALITY p(phase, n) CROSS JOIN LATERAL (
        SELECT string_agg(coalesce(o.other, 0) || substr(s, length(split_part(s, ' ', 1)) + 1), '|') AS named
        FROM regexp_split_to_table(phase, '\|') s LEFT JOIN unnest(numbers, others) o(number, other)
            ON o.number::text = split_part(s, ' ', 1) WHERE phase ~ '^[0-9]') r $$;
COMMENT ON FUNCTION streetgen._numbered_phases(text[], bigint[], bigint[]) IS
    'Phases with other numbers of their streets; 0: a street without another number.';

CREATE OR REPLACE FUNCTION streetgen._former_states(model name, movements streetgen.signal_request[],
    answers streetgen.signal_answer[], phases text[], approaches geometry) RETURNS integer[]
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._same_states(phases, streetgen._numbered_phases(streetgen._phases(movements, answers),
        array_agg(edge_id), array_agg(place))) FROM streetgen._approaches_at(model, movements, approaches) $$;
COMMENT ON FUNCTION streetgen._former_states(name, streetgen.signal_request[], streetgen.signal_answer[], text[],
    geometry) IS
    'For each state which state it was when durations were typed; NULL: none.';

CREATE OR REPLACE FUNCTION streetgen._kept_durations(model name, movements streetgen.signal_request[],
    answers streetgen.signal_answer[], durations float8[], phases text[], approaches geometry) RETURNS float8[]
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN phases IS NULL THEN durations ELSE ARRAY(SELECT durations[former]
        FROM unnest(streetgen._former_states(model, movements, answers, phases, approaches))
            WITH ORDINALITY s(former, place) ORDER BY place) END $$;
COMMENT ON FUNCTION streetgen._kept_durations(name, streetgen.signal_request[], streetgen.signal_answer[], float8[],
    text[], geometry) IS
    'Durations by hand of the states that a program has now; NULL: computed. Where nobody says what states they were '
    'typed for, they are those of the states in order.';

CREATE OR REPLACE FUNCTION streetgen._answers_of(model name, controller bigint) RETURNS streetgen.signal_answer[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT ROW (s.ordinality, s.duration, s.kind, m.lane_in, m.lane_out, m.along_in, m.along_out,
            m.right_of_way)::streetgen.signal_answer
        FROM signal_state s LEFT JOIN signal_movement m USING (controller_id, ordinality)
        WHERE s.controller_id = controller);
END $$;
COMMENT ON FUNCTION streetgen._answers_of(name, bigint) IS 'The states of a controller as its program gave them.';

CREATE OR REPLACE FUNCTION streetgen._typed_durations(model name, controller bigint, durations float8[])
    RETURNS jsonb
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    typed jsonb;
BEGIN
    PERFORM streetgen._use_model(model);
    IF durations IS NULL THEN
        RETURN '{"durations": null, "phases": null, "approaches": null}';
    END IF;
    SELECT jsonb_build_object('durations', durations, 'approaches', a.places::text, 'phases',
            streetgen._numbered_phases(streetgen._phases(r.movements, streetgen._answers_of(model, controller)),
                a.edges, a.numbers))
        FROM _signal_requests(ARRAY[controller]) r CROSS JOIN LATERAL (
            SELECT array_agg(edge_id ORDER BY n) AS edges, array_agg(n ORDER BY n) AS numbers,
                ST_Collect(place ORDER BY n) AS places
            FROM streetgen._approaches(model, r.movements) WITH ORDINALITY p(edge_id, line, place, n)) a INTO typed;
    RETURN typed;
END $$;
COMMENT ON FUNCTION streetgen._typed_durations(name, bigint, float8[]) IS
    'Durations by hand with the phases that they are typed for, as columns of controller_override; NULL: none.';

CREATE OR REPLACE FUNCTION streetgen._lost_phases(model name, controller bigint, phases text[], approaches geometry)
    RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT count(*) FROM _signal_requests(ARRAY[controller]) r, unnest(phases) WITH ORDINALITY p(phase, n)
        WHERE phase NOT IN ('amber', 'all_red') AND n <> ALL (array_remove(streetgen._former_states(model, r.movements,
            streetgen._answers_of(model, controller), phases, approaches), NULL)));
END $$;
COMMENT ON FUNCTION streetgen._lost_phases(name, bigint, text[], geometry) IS
    'How many phases with durations by hand a controller has no more.';
