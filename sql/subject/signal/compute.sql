-- Signals after a run: they follow the junctions, whose movements they give green to.

CREATE OR REPLACE FUNCTION streetgen._signal_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (60, 'controller', 'signal', 'controller_id', NULL, 'controller', 1),
    (61, 'signal_state', 'signal', NULL, NULL, NULL, NULL),
    (62, 'signal_movement', 'signal', NULL, NULL, NULL, NULL),
    (63, 'signal_group', 'signal', NULL, NULL, NULL, NULL),
    (64, 'intergreen', 'signal', NULL, NULL, NULL, NULL),
    (65, 'signal_head', 'signal', NULL, NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._signal_computed_table() IS 'The computed tables of signals.';

CREATE OR REPLACE FUNCTION streetgen._make_signal_requests(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _signal_requests(junctions bigint[]) RETURNS SETOF streetgen.signal_asked
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        rules record;
    BEGIN
        SELECT max(value) FILTER (WHERE name = 'signal_importance')::integer AS importance,
            max(value) FILTER (WHERE name = 'signal_step')::float8 AS step,
            max(value) FILTER (WHERE name = 'walk_shortest')::float8 AS walk,
            max(value) FILTER (WHERE name = 'line_before_crossing')::float8
                + (SELECT c.width / 2 FROM streetgen._usual_crossing() c) AS ahead INTO rules FROM setting;
        RETURN QUERY
        WITH path AS MATERIALIZED (
            SELECT m.junction_id, m.lane_in, m.lane_out, m.along_in, m.along_out, m.turn, m.geom, m.metres,
                e.edge_id AS edge_in, o.edge_id AS edge_out, i.lane_position, e.geom AS street, e.axis_id, e.importance,
                greatest(e.speed, 1) AS speed,
                greatest(1, CASE WHEN m.along_in THEN e.lanes_forward ELSE e.lanes_backward END + e.lanes_both)
                    AS lanes,
                CASE WHEN e.lanes_both > 0 OR least(e.lanes_forward, e.lanes_backward) > 0 THEN 2 ELSE 1 END AS ways,
                -- By metres across the junction, of an approach and of a movement; then by what outlives a run from
                -- scratch: keys do not.
                row_number() OVER (PARTITION BY m.junction_id ORDER BY m.metres_of_approach DESC, e.axis_id,
                    e.start_abscissa, m.metres DESC, i.ordinality, m.along_in, b.axis_id, b.start_abscissa,
                    o.ordinality, m.along_out)::integer AS number
            FROM (SELECT m.*, l.edge_id AS approach, round(ST_Length(m.geom)::numeric, 3) AS metres,
                        round(sum(ST_Length(m.geom)) OVER (PARTITION BY m.junction_id, l.edge_id)::numeric, 3)
                            AS metres_of_approach
                    FROM movement m JOIN lane l ON l.lane_id = m.lane_in
                    WHERE m.connecting AND m.junction_id = ANY (junctions)) m
                JOIN lane i ON i.lane_id = m.lane_in JOIN edge e ON e.edge_id = m.approach
                JOIN lane o ON o.lane_id = m.lane_out JOIN edge b ON b.edge_id = o.edge_id),
        -- Streets without a phase go last, who turns back before them; then what goes straight on, by importance, and
        -- shorter turns before longer ones.
        first AS (
            SELECT junction_id, number, row_number() OVER (PARTITION BY junction_id
                ORDER BY importance > rules.importance, CASE turn WHEN 'through' THEN 0 WHEN 'u_turn' THEN 2 ELSE 1 END,
                    CASE turn WHEN 'through' THEN importance END, metres, number)::integer AS precedence FROM path),
        pair AS MATERIALIZED (
            SELECT a.junction_id, a.number AS a, b.number AS b, a.metres AS metres_a, b.metres AS metres_b, in_out,
                in_in, CASE WHEN crosses THEN ST_ClosestPoint(a.geom, b.geom) END AS place, a.geom AS geom_a,
                b.geom AS geom_b
            FROM path a JOIN path b ON b.junction_id = a.junction_id AND a.number < b.number
                CROSS JOIN LATERAL (SELECT (a.lane_out, a.along_out) = (b.lane_out, b.along_out) AS merges,
                    (a.lane_out, a.along_out) = (b.lane_in, NOT b.along_in) AS in_out,
                    (a.lane_in, NOT a.along_in) = (b.lane_out, b.along_out) AS in_in,
                    ST_Intersects(a.geom, b.geom) AS crosses) w
            WHERE (a.lane_in, a.along_in) <> (b.lane_in, b.along_in)
                -- As in the view conflict: they merge, they oppose each other in a lane for both directions, or cross.
                AND (merges OR in_out OR in_in OR crosses)),
        crossed AS MATERIALIZED (
            SELECT c.junction_id, c.control_point_id, c.edge_id, c.inside, c.width, c.geom,
                ceil((c.seconds - rules.walk) / rules.step - 1e-6) * rules.step AS clear,
                row_number() OVER (PARTITION BY c.junction_id ORDER BY e.axis_id, e.start_abscissa, c.control_point_id)
                    AS walk
            FROM junction_crossing c JOIN edge e USING (edge_id) WHERE c.junction_id = ANY (junctions)),
        -- Traffic waits before the first crossing of its arm, and drives from there to where its path begins.
        passed AS MATERIALIZED (
            SELECT p.junction_id, p.number, c.walk, (ST_LineLocatePoint(street, ST_StartPoint(p.geom))
                - ST_LineLocatePoint(street, c.geom)) * ST_Length(street) * CASE WHEN p.along_in THEN 1 ELSE -1 END
                AS before
            FROM path p JOIN crossed c ON c.junction_id = p.junction_id AND c.edge_id = p.edge_in AND NOT c.inside),
        lead AS MATERIALIZED (
            SELECT p.junction_id, p.number, greatest(0, max(c.before) + rules.ahead,
                ST_Distance(coalesce(s.free_geom, s.geom), ST_StartPoint(p.geom)))::float8 AS lead
            FROM path p LEFT JOIN passed c USING (junction_id, number) LEFT JOIN marking s
                ON (s.edge_id, s.kind, s.lane_position, s.along_axis) = (p.edge_in, 'stop', p.lane_position, p.along_in)
            GROUP BY p.junction_id, p.number, s.free_geom, s.geom, p.geom),
        conflict AS MATERIALIZED (
            SELECT junction_id, number, array_agg(other ORDER BY other) AS others,
                array_agg(lead + reach ORDER BY other) AS reaches
            FROM (SELECT junction_id, a AS number, b AS other, CASE WHEN place IS NOT NULL
                        THEN metres_a * ST_LineLocatePoint(geom_a, place) WHEN in_in AND NOT in_out THEN 0
                        ELSE metres_a END::float8 AS reach FROM pair
                UNION ALL SELECT junction_id, b, a, CASE WHEN place IS NOT NULL
                        THEN metres_b * ST_LineLocatePoint(geom_b, place) WHEN in_out AND NOT in_in THEN 0
                        ELSE metres_b END FROM pair) p
                JOIN lead USING (junction_id, number)
            GROUP BY junction_id, number),
        -- People wait for who comes in over their crossing, goes straight out there, or passes within the junction.
        walked AS MATERIALIZED (
            SELECT p.junction_id, p.number, array_agg(c.walk::integer ORDER BY walk) AS walks,
                array_agg(rules.walk + c.clear ORDER BY walk) AS seconds,
                array_agg(lead + coalesce(-b.before, p.metres * ST_LineLocatePoint(p.geom, c.geom))::float8
                    ORDER BY walk) AS reaches
            FROM path p JOIN crossed c USING (junction_id) JOIN lead USING (junction_id, number)
                LEFT JOIN passed b USING (junction_id, number, walk)
            WHERE p.edge_in = c.edge_id OR p.edge_out = c.edge_id AND p.turn = 'through'
                OR c.inside AND ST_DWithin(p.geom, c.geom, c.width / 2)
            GROUP BY p.junction_id, p.number)
        SELECT p.junction_id, array_agg(ROW (p.lane_in, p.lane_out, p.along_in, p.along_out, p.edge_in, p.edge_out,
                p.turn, ST_Length(p.geom), p.speed, p.lanes, p.importance, a.flow / p.ways, f.precedence,
                coalesce(c.others, '{}'), coalesce(c.reaches, '{}'), coalesce(w.walks, '{}'),
                coalesce(w.seconds, '{}'), coalesce(w.reaches, '{}'))::streetgen.signal_request ORDER BY p.number),
            coalesce(k.control_points, '{}'), coalesce(k.edges, '{}'), coalesce(k.clear, '{}')
        FROM path p JOIN first f USING (junction_id, number) LEFT JOIN axis a ON a.axis_id = p.axis_id
            LEFT JOIN conflict c USING (junction_id, number) LEFT JOIN walked w USING (junction_id, number)
            LEFT JOIN (SELECT junction_id, array_agg(control_point_id ORDER BY walk) AS control_points,
                    array_agg(edge_id ORDER BY walk) AS edges, array_agg(clear ORDER BY walk) AS clear
                FROM crossed GROUP BY junction_id) k USING (junction_id)
        GROUP BY p.junction_id, k.control_points, k.edges, k.clear;
    END $body$;
    PERFORM streetgen._own_function(model, '_signal_requests(bigint[])',
        'What junctions ask their signal programs for');
END $$;
COMMENT ON FUNCTION streetgen._make_signal_requests(name) IS
    'Makes the function of a model that gathers what signal programs are asked for.';

CREATE OR REPLACE FUNCTION streetgen._make_found_signals(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _found_signals(junctions bigint[], asked streetgen.signal_asked[])
        RETURNS SETOF streetgen.signal_found
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        rules record;
    BEGIN
        SELECT max(value) FILTER (WHERE name = 'signal_program') AS program,
            max(value) FILTER (WHERE name = 'signal_cycle')::float8 AS cycle,
            max(value) FILTER (WHERE name = 'signal_all_red')::float8 AS all_red,
            max(value) FILTER (WHERE name = 'signal_step')::float8 AS step,
            max(value) FILTER (WHERE name = 'walk_shortest')::float8 AS walk,
            max(value) FILTER (WHERE name = 'signal_importance')::integer AS importance INTO rules FROM setting;
        RETURN QUERY
        WITH place AS MATERIALIZED (SELECT j.junction_id, j.method = 'by_hand' AS by_hand FROM junction j
            WHERE j.kind = 'signals' AND j.junction_id = ANY (junctions)),
        decided AS MATERIALIZED (
            SELECT DISTINCT ON (m.junction_id) m.junction_id, o.program, o.cycle, o.start_offset, o.durations,
                o.turn_phases, o.phases, o.approaches
            FROM controller_override o CROSS JOIN LATERAL (
                SELECT v.node_id, ST_Distance(n.geom, o.geom) AS metres
                FROM edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id) JOIN node n USING (node_id)
                WHERE e.axis_id = o.axis_id ORDER BY metres, v.node_id LIMIT 1) n JOIN junction_node m USING (node_id)
            -- A decision on signals that are gone is about no others on the street.
            WHERE metres <= (SELECT value::float8 FROM setting WHERE name = 'control_distance')
            ORDER BY m.junction_id, o.controller_override_id DESC),
        -- Signals that nobody mapped and nobody decided: the classifier alone says that they stand there. Control
        -- points speak over nodes of two edges.
        about AS MATERIALIZED (
            WITH RECURSIVE walk(junction_id, node_id, edge_id, axis_id, metres) AS (
                SELECT m.junction_id, m.node_id, NULL::bigint, NULL::bigint, 0::float8 FROM junction_node m
                    WHERE m.junction_id = ANY (junctions)
                UNION SELECT w.junction_id, e.far, e.edge_id, e.axis_id, w.metres + e.length
                FROM walk w CROSS JOIN LATERAL (
                    SELECT o.*, count(*) OVER () AS degree FROM (
                        SELECT edge_id, axis_id, to_node AS far, end_abscissa - start_abscissa AS length FROM edge
                            WHERE from_node = w.node_id
                        UNION ALL SELECT edge_id, axis_id, from_node, end_abscissa - start_abscissa FROM edge
                            WHERE to_node = w.node_id) o) e
                WHERE e.edge_id IS DISTINCT FROM w.edge_id AND (w.edge_id IS NULL OR e.degree = 2 AND w.metres <
                    (SELECT value::float8 FROM setting WHERE name = 'control_distance')))
            SELECT DISTINCT junction_id, axis_id FROM walk WHERE edge_id IS NOT NULL),
        mapped AS MATERIALIZED (
            SELECT DISTINCT a.junction_id FROM about a
                JOIN control_point p ON p.axis_id = a.axis_id AND p.kind = 'signals'),
        answer AS MATERIALIZED (
            SELECT p.junction_id, coalesce(d.program, rules.program) AS program, coalesce(d.start_offset, 0)
                    AS start_offset, CASE WHEN d.junction_id IS NOT NULL THEN 'by_hand'
                    WHEN p.by_hand OR p.junction_id IN (TABLE mapped) THEN 'hypothesis' ELSE 'classified' END AS method,
                d.turn_phases, t.ordinality, t.duration, t.kind, t.lane_in, t.lane_out, t.along_in, t.along_out,
                t.right_of_way
            FROM place p LEFT JOIN decided d USING (junction_id) LEFT JOIN unnest(asked) r USING (junction_id)
                LEFT JOIN LATERAL (SELECT ARRAY(SELECT a FROM streetgen._signal_answers(current_schema(),
                    coalesce(d.program, rules.program), p.junction_id, r.movements, rules.cycle, rules.all_red,
                    rules.step, rules.walk, rules.importance, d.turn_phases) a) AS answers OFFSET 0) s
                    ON r.movements IS NOT NULL
                LEFT JOIN LATERAL streetgen._timed(s.answers, d.cycle, CASE WHEN d.durations IS NOT NULL
                    THEN streetgen._kept_durations(current_schema(), r.movements, s.answers, d.durations, d.phases,
                        d.approaches) END, rules.step) t ON r.movements IS NOT NULL),
        request AS (SELECT m.lane_in, m.lane_out, m.along_in, m.along_out, m.approach, m.precedence, m.number
            FROM unnest(asked) r, unnest(r.movements) WITH ORDINALITY m(lane_in, lane_out, along_in, along_out,
                approach, exit, turn, length, speed, lanes, importance, flow, precedence, conflicts, reaches, walks,
                walk_seconds, walk_reaches, number)),
        -- Movements of a street that have green in the same states are a signal group.
        grouped AS (
            SELECT junction_id, lane_in, lane_out, along_in, along_out, precedence, dense_rank() OVER (
                PARTITION BY junction_id ORDER BY greens, first_of_street)::integer AS signal_group
            FROM (SELECT a.junction_id, r.lane_in, r.lane_out, r.along_in, r.along_out, r.precedence,
                    min(r.number) OVER (PARTITION BY a.junction_id, r.approach) AS first_of_street,
                    array_agg(a.ordinality ORDER BY a.ordinality) AS greens
                FROM answer a JOIN request r USING (lane_in, lane_out, along_in, along_out)
                GROUP BY a.junction_id, r.lane_in, r.lane_out, r.along_in, r.along_out, r.precedence, r.approach,
                    r.number) g)
        SELECT a.junction_id, a.program, a.start_offset, a.method, a.ordinality, a.duration, a.kind, a.lane_in,
            a.lane_out, a.along_in, a.along_out, a.right_of_way, g.precedence, g.signal_group, a.turn_phases
        FROM answer a LEFT JOIN grouped g USING (junction_id, lane_in, lane_out, along_in, along_out);
    END $body$;
    PERFORM streetgen._own_function(model, '_found_signals(bigint[], streetgen.signal_asked[])',
        'The signals of junctions: a row for each movement in each state, and for each state without one');
END $$;
COMMENT ON FUNCTION streetgen._make_found_signals(name) IS
    'Makes the function of a model that computes signals.';

CREATE OR REPLACE FUNCTION streetgen._make_signal_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model,
            '{_update_signals,_update_signal_groups,_found_signals,_signal_requests}');
        RETURN;
    END IF;
    PERFORM streetgen._make_signal_requests(model), streetgen._make_found_signals(model),
        streetgen._make_update_signal_groups(model);
    CREATE OR REPLACE FUNCTION _update_signals(junctions bigint[], former bigint[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        known constant bigint[] := junctions || former;
        asked constant streetgen.signal_asked[] := ARRAY(SELECT a FROM _signal_requests(junctions) a);
        found constant streetgen.signal_found[] := ARRAY(SELECT f FROM _found_signals(junctions, asked) f);
    BEGIN
        RETURN QUERY WITH new AS MATERIALIZED (
            SELECT s.controller_id, s.program,
                coalesce(sum(s.duration ORDER BY s.ordinality) FILTER (WHERE s.first), 0) AS cycle,
                s.start_offset, s.method, j.geom, s.turn_phases
            FROM (SELECT *, row_number() OVER (PARTITION BY controller_id, ordinality) = 1 AS first
                FROM unnest(found)) s
                JOIN junction j ON j.junction_id = s.controller_id
            GROUP BY s.controller_id, s.program, s.start_offset, s.method, j.geom, s.turn_phases),
        there AS (SELECT * FROM controller WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM controller c USING there t WHERE c.controller_id = t.controller_id
            AND t.controller_id NOT IN (SELECT controller_id FROM new) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, (t.program, t.cycle, t.start_offset, t.method,
                t.geom::bytea, t.turn_phases) IS DISTINCT FROM (n.program, n.cycle, n.start_offset, n.method,
                n.geom::bytea, n.turn_phases) AS changed
            FROM new n LEFT JOIN there t USING (controller_id)),
        put AS (INSERT INTO controller (controller_id, program, cycle, start_offset, method, geom, turn_phases)
            SELECT controller_id, program, cycle, start_offset, method, geom, turn_phases FROM compared WHERE changed
            ORDER BY controller_id
            ON CONFLICT (controller_id) DO UPDATE SET (program, cycle, start_offset, method, geom, turn_phases)
                = ROW (excluded.program, excluded.cycle, excluded.start_offset, excluded.method, excluded.geom,
                    excluded.turn_phases))
        SELECT 'controller', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), count(*) FILTER (WHERE method =
                'classified')
        FROM compared;
        RETURN QUERY WITH new AS (SELECT DISTINCT controller_id, ordinality, duration, kind FROM unnest(found)
            WHERE ordinality IS NOT NULL),
        there AS (SELECT * FROM signal_state WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM signal_state o USING there t WHERE (o.controller_id, o.ordinality) = (t.controller_id,
            t.ordinality) AND NOT EXISTS (SELECT FROM new n WHERE (n.controller_id, n.ordinality) = (t.controller_id,
            t.ordinality)) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, (t.duration, t.kind) IS DISTINCT FROM (n.duration,
            n.kind) AS changed FROM new n LEFT JOIN there t USING (controller_id, ordinality)),
        put AS (INSERT INTO signal_state (controller_id, ordinality, duration, kind)
            SELECT controller_id, ordinality, duration, kind FROM compared WHERE changed ORDER BY 1, 2
            ON CONFLICT (controller_id, ordinality) DO UPDATE SET (duration, kind) = ROW (excluded.duration,
                excluded.kind))
        SELECT 'signal_state', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
        RETURN QUERY WITH new AS (SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out,
                right_of_way, precedence, signal_group FROM unnest(found) WHERE lane_in IS NOT NULL),
        there AS (SELECT * FROM signal_movement WHERE controller_id = ANY (known)),
        -- Differences of sets are found by hashes, however many rows the planner expects.
        gone AS (DELETE FROM signal_movement o USING (
                SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out FROM there
                EXCEPT SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out FROM new) t
            WHERE (o.controller_id, o.ordinality, o.lane_in, o.lane_out, o.along_in, o.along_out)
                = (t.controller_id, t.ordinality, t.lane_in, t.lane_out, t.along_in, t.along_out) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, (t.right_of_way, t.precedence, t.signal_group)
                IS DISTINCT FROM (n.right_of_way, n.precedence, n.signal_group) AS changed
            FROM new n LEFT JOIN there t USING (controller_id, ordinality, lane_in, lane_out, along_in, along_out)),
        put AS (INSERT INTO signal_movement (controller_id, ordinality, lane_in, lane_out, along_in, along_out,
                right_of_way, precedence, signal_group)
            SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out, right_of_way, precedence,
                signal_group FROM compared
            WHERE changed ORDER BY 1, 2, 3, 4, 5, 6
            ON CONFLICT (controller_id, ordinality, lane_in, lane_out, along_in, along_out)
                DO UPDATE SET (right_of_way, precedence, signal_group)
                    = ROW (excluded.right_of_way, excluded.precedence, excluded.signal_group))
        SELECT 'signal_movement', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
        RETURN QUERY SELECT * FROM _update_signal_groups(known, asked, found);
        RETURN QUERY WITH new AS MATERIALIZED (
            SELECT l.lane_id, m.along_in AS along_axis, m.controller_id, w.geom, w.angle
            FROM (SELECT DISTINCT controller_id, lane_in, along_in FROM unnest(found) WHERE lane_in IS NOT NULL) m
                JOIN lane l ON l.lane_id = m.lane_in
                LEFT JOIN marking s ON (s.edge_id, s.kind, s.lane_position, s.along_axis)
                    = (l.edge_id, 'stop', l.lane_position, m.along_in)
                CROSS JOIN LATERAL streetgen._waiting_place(l.geom, m.along_in, s.geom) w),
        there AS (SELECT * FROM signal_head WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM signal_head o USING there t WHERE (o.lane_id, o.along_axis) = (t.lane_id, t.along_axis)
            AND NOT EXISTS (SELECT FROM new n WHERE (n.lane_id, n.along_axis) = (t.lane_id, t.along_axis)) RETURNING 1),
        compared AS (SELECT n.*, t.lane_id IS NULL AS fresh, (t.controller_id, t.geom::bytea, t.angle)
                IS DISTINCT FROM (n.controller_id, n.geom::bytea, n.angle) AS changed
            FROM new n LEFT JOIN there t USING (lane_id, along_axis)),
        put AS (INSERT INTO signal_head (lane_id, along_axis, controller_id, geom, angle)
            SELECT lane_id, along_axis, controller_id, geom, angle FROM compared WHERE changed ORDER BY 1, 2
            ON CONFLICT (lane_id, along_axis) DO UPDATE SET (controller_id, geom, angle) = ROW (excluded.controller_id,
                excluded.geom, excluded.angle))
        SELECT 'signal_head', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
    END $body$;
    PERFORM streetgen._own_function(model, '_update_signals(bigint[], bigint[])',
        'Brings the signals of junctions, as they are and were, up to date; a row per table');
END $$;
COMMENT ON FUNCTION streetgen._make_signal_functions(name) IS
    'Makes the functions of a model that bring its signals up to date, or drops them where it computes none.';
