-- Signals after a run: they follow the junctions, whose movements they give green to.

CREATE OR REPLACE FUNCTION streetgen._signal_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    (60, 'controller', 'signal', 'controller_id', NULL, 'controller', 1),
    (61, 'signal_state', 'signal', NULL, NULL, NULL, NULL),
    (62, 'signal_movement', 'signal', NULL, NULL, NULL, NULL),
    (63, 'signal_head', 'signal', NULL, NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._signal_computed_table() IS 'The computed tables of signals.';

CREATE OR REPLACE FUNCTION streetgen._make_signal_requests(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _signal_requests(junctions bigint[])
        RETURNS TABLE(junction_id bigint, movements streetgen.signal_request[])
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        RETURN QUERY
        WITH path AS MATERIALIZED (
            SELECT m.junction_id, m.lane_in, m.lane_out, m.along_in, m.along_out, m.turn, m.geom,
                -- By metres across the junction, of an approach and of a movement; then by what outlives a run from
                -- scratch: keys do not.
                row_number() OVER (PARTITION BY m.junction_id ORDER BY m.metres_of_approach DESC, a.axis_id,
                    a.start_abscissa, m.metres DESC, i.ordinality, m.along_in, b.axis_id, b.start_abscissa,
                    o.ordinality, m.along_out)::integer AS number
            FROM (SELECT m.*, l.edge_id AS approach, round(ST_Length(m.geom)::numeric, 3) AS metres,
                        round(sum(ST_Length(m.geom)) OVER (PARTITION BY m.junction_id, l.edge_id)::numeric, 3)
                            AS metres_of_approach
                    FROM movement m JOIN lane l ON l.lane_id = m.lane_in
                    WHERE m.connecting AND m.junction_id = ANY (junctions)) m
                JOIN lane i ON i.lane_id = m.lane_in JOIN edge a ON a.edge_id = m.approach
                JOIN lane o ON o.lane_id = m.lane_out JOIN edge b ON b.edge_id = o.edge_id),
        conflict AS MATERIALIZED (
            SELECT a.junction_id, a.number, array_agg(b.number ORDER BY b.number) AS others FROM path a JOIN path b
                ON b.junction_id = a.junction_id AND b.number <> a.number
            WHERE (a.lane_in, a.along_in) <> (b.lane_in, b.along_in)
                -- As in the view conflict: they merge, they oppose each other in a lane for both directions, or cross.
                AND ((a.lane_out, a.along_out) IN ((b.lane_out, b.along_out), (b.lane_in, NOT b.along_in))
                    OR (a.lane_in, NOT a.along_in) = (b.lane_out, b.along_out) OR ST_Intersects(a.geom, b.geom))
            GROUP BY a.junction_id, a.number),
        crossed AS MATERIALIZED (
            SELECT c.junction_id, c.edge_id, max(c.seconds) AS seconds FROM junction_crossing c
            WHERE c.junction_id = ANY (junctions) GROUP BY c.junction_id, c.edge_id)
        SELECT p.junction_id, array_agg(ROW (p.lane_in, p.lane_out, p.along_in, p.along_out, i.edge_id, o.edge_id,
            p.turn, ST_Length(p.geom), greatest(e.speed, 1), greatest(1, CASE WHEN p.along_in THEN e.lanes_forward
                ELSE e.lanes_backward END + e.lanes_both), e.importance,
            a.flow / CASE WHEN e.lanes_both > 0 OR least(e.lanes_forward, e.lanes_backward) > 0 THEN 2 ELSE 1 END,
            ci.seconds, co.seconds, coalesce(c.others, '{}'))::streetgen.signal_request ORDER BY p.number)
        FROM path p JOIN lane i ON i.lane_id = p.lane_in JOIN lane o ON o.lane_id = p.lane_out
            JOIN edge e ON e.edge_id = i.edge_id LEFT JOIN axis a ON a.axis_id = e.axis_id
            LEFT JOIN conflict c ON (c.junction_id, c.number) = (p.junction_id, p.number)
            LEFT JOIN crossed ci ON (ci.junction_id, ci.edge_id) = (p.junction_id, i.edge_id)
            LEFT JOIN crossed co ON (co.junction_id, co.edge_id) = (p.junction_id, o.edge_id)
        GROUP BY p.junction_id;
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
    CREATE OR REPLACE FUNCTION _found_signals(junctions bigint[])
        RETURNS SETOF streetgen.signal_found
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        RETURN QUERY
        WITH place AS MATERIALIZED (SELECT j.junction_id, j.method = 'by_hand' AS by_hand FROM junction j
            WHERE j.kind = 'signals' AND j.junction_id = ANY (junctions)),
        decided AS MATERIALIZED (
            SELECT DISTINCT ON (m.junction_id) m.junction_id, o.program, o.cycle, o.start_offset, o.durations
            FROM controller_override o CROSS JOIN LATERAL (
                SELECT v.node_id FROM edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id)
                    JOIN node n USING (node_id) WHERE e.axis_id = o.axis_id
                ORDER BY ST_Distance(n.geom, o.geom), v.node_id LIMIT 1) n JOIN junction_node m USING (node_id)
            ORDER BY m.junction_id, o.controller_override_id DESC),
        -- Signals that nobody mapped and nobody decided: the classifier alone says that they stand there.
        mapped AS MATERIALIZED (
            SELECT DISTINCT m.junction_id FROM junction_node m
                JOIN edge e ON m.node_id IN (e.from_node, e.to_node)
                JOIN control_point p ON p.axis_id = e.axis_id AND p.kind = 'signals'
            WHERE m.junction_id = ANY (junctions))
        SELECT p.junction_id, coalesce(d.program, s.value), coalesce(d.start_offset, 0),
            CASE WHEN d.junction_id IS NOT NULL THEN 'by_hand' WHEN p.by_hand OR p.junction_id IN (TABLE mapped)
                THEN 'hypothesis' ELSE 'classified' END, t.ordinality, t.duration, t.kind, t.lane_in, t.lane_out,
            t.along_in, t.along_out, t.right_of_way
        FROM place p LEFT JOIN decided d USING (junction_id) LEFT JOIN _signal_requests(ARRAY(SELECT junction_id
                FROM place)) r USING (junction_id) CROSS JOIN setting s
            LEFT JOIN LATERAL streetgen._timed(ARRAY(SELECT a FROM streetgen._signal_answers(current_schema(),
                coalesce(d.program, s.value), p.junction_id, r.movements) a), d.cycle, d.durations) t
            ON r.movements IS NOT NULL
        WHERE s.name = 'signal_program';
    END $body$;
    PERFORM streetgen._own_function(model, '_found_signals(bigint[])',
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
        PERFORM streetgen._drop_own_functions(model, '{_update_signals,_found_signals,_signal_requests}');
        RETURN;
    END IF;
    PERFORM streetgen._make_signal_requests(model), streetgen._make_found_signals(model);
    CREATE OR REPLACE FUNCTION _update_signals(junctions bigint[], former bigint[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        known constant bigint[] := junctions || former;
        found streetgen.signal_found[];
    BEGIN
        found := ARRAY(SELECT f FROM _found_signals(junctions) f);
        RETURN QUERY WITH new AS MATERIALIZED (
            SELECT s.controller_id, s.program,
                coalesce(sum(s.duration ORDER BY s.ordinality) FILTER (WHERE s.first), 0) AS cycle,
                s.start_offset, s.method, j.geom
            FROM (SELECT *, row_number() OVER (PARTITION BY controller_id, ordinality) = 1 AS first
                FROM unnest(found)) s
                JOIN junction j ON j.junction_id = s.controller_id
            GROUP BY s.controller_id, s.program, s.start_offset, s.method, j.geom),
        there AS (SELECT * FROM controller WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM controller c USING there t WHERE c.controller_id = t.controller_id
            AND t.controller_id NOT IN (SELECT controller_id FROM new) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, (t.program, t.cycle, t.start_offset, t.method,
                t.geom::bytea) IS DISTINCT FROM (n.program, n.cycle, n.start_offset, n.method, n.geom::bytea) AS changed
            FROM new n LEFT JOIN there t USING (controller_id)),
        put AS (INSERT INTO controller (controller_id, program, cycle, start_offset, method, geom)
            SELECT controller_id, program, cycle, start_offset, method, geom FROM compared WHERE changed
            ORDER BY controller_id
            ON CONFLICT (controller_id) DO UPDATE SET (program, cycle, start_offset, method, geom)
                = ROW (excluded.program, excluded.cycle, excluded.start_offset, excluded.method, excluded.geom))
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
        RETURN QUERY WITH new AS (SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out, right_of_way
            FROM unnest(found) WHERE lane_in IS NOT NULL),
        there AS (SELECT * FROM signal_movement WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM signal_movement o USING there t WHERE (o.controller_id, o.ordinality, o.lane_in,
                o.lane_out, o.along_in, o.along_out) = (t.controller_id, t.ordinality, t.lane_in, t.lane_out,
                    t.along_in,
                t.along_out)
            AND NOT EXISTS (SELECT FROM new n WHERE (n.controller_id, n.ordinality, n.lane_in, n.lane_out, n.along_in,
                n.along_out) = (t.controller_id, t.ordinality, t.lane_in, t.lane_out, t.along_in, t.along_out))
            RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, t.right_of_way IS DISTINCT
            FROM n.right_of_way AS changed
            FROM new n LEFT JOIN there t USING (controller_id, ordinality, lane_in, lane_out, along_in, along_out)),
        put AS (INSERT INTO signal_movement (controller_id, ordinality, lane_in, lane_out, along_in, along_out,
                right_of_way)
            SELECT controller_id, ordinality, lane_in, lane_out, along_in, along_out, right_of_way FROM compared
            WHERE changed ORDER BY 1, 2, 3, 4, 5, 6
            ON CONFLICT (controller_id, ordinality, lane_in, lane_out, along_in, along_out)
                DO UPDATE SET right_of_way = excluded.right_of_way)
        SELECT 'signal_movement', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
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
