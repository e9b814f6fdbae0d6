-- Rules of check_model for signals.

CREATE OR REPLACE FUNCTION streetgen._check_signal(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'junction of kind signals without a controller', 'junction', j.junction_id, 0, j.geom
        FROM junction j WHERE j.kind = 'signals' AND NOT EXISTS (SELECT FROM controller c
            WHERE c.controller_id = j.junction_id)
    UNION ALL
    SELECT 'error', 'movement that never has green', 'controller', c.controller_id, m.lane_in, m.geom
        FROM controller c JOIN movement m ON m.junction_id = c.controller_id
        WHERE m.connecting AND NOT EXISTS (SELECT FROM signal_movement s WHERE (s.lane_in, s.lane_out, s.along_in,
            s.along_out) = (m.lane_in, m.lane_out, m.along_in, m.along_out))
    UNION ALL
    SELECT 'notice', 'crossing at signals where people never have green', 'control_point', c.control_point_id,
        c.seconds, c.geom FROM junction_crossing c JOIN controller k ON k.controller_id = c.junction_id
        -- The view is computed once so, and not for each crossing.
        WHERE (c.junction_id, c.control_point_id, c.edge_id) NOT IN (
            SELECT s.controller_id, s.control_point_id, s.edge_id FROM signal_crossing s)
    UNION ALL
    SELECT 'notice', 'signals that the classifier alone says', 'controller', c.controller_id, c.cycle, c.geom
        FROM controller c WHERE c.method = 'classified'
    UNION ALL
    SELECT 'warning', 'green that begins before others have left, s', 'controller', c.controller_id,
        max(i.seconds - between), c.geom
    FROM controller c JOIN intergreen i USING (controller_id)
        JOIN signal_green a ON (a.controller_id, a.signal_group) = (c.controller_id, i.ends)
        JOIN signal_green b ON (b.controller_id, b.signal_group) = (c.controller_id, i.begins)
            AND b.ordinality <> a.ordinality,
        LATERAL (SELECT b.green_from - a.green_until
            + CASE WHEN b.green_from < a.green_until - 1e-6 THEN c.cycle ELSE 0 END AS between) t
    WHERE i.seconds > between + 1e-6 GROUP BY c.controller_id, c.geom
    UNION ALL
    SELECT 'warning', 'cycle longer than signal_cycle, s', 'controller', c.controller_id, c.cycle, c.geom
        FROM controller c CROSS JOIN setting s WHERE s.name = 'signal_cycle' AND c.program = 'phases'
            AND c.method <> 'by_hand' AND c.cycle > s.value::float8 + 1e-6
    UNION ALL
    SELECT 'notice', 'through traffic that gives way at signals', 'controller', c.controller_id, count(*), c.geom
    FROM controller c JOIN signal_movement a USING (controller_id) JOIN lane i ON i.lane_id = a.lane_in
        JOIN edge e USING (edge_id) CROSS JOIN setting s
        CROSS JOIN LATERAL (SELECT w.turn, w.geom FROM movement w WHERE (w.lane_in, w.lane_out, w.along_in,
            w.along_out) = (a.lane_in, a.lane_out, a.along_in, a.along_out) OFFSET 0) w
    WHERE c.program = 'phases' AND a.right_of_way = 'permitted' AND w.turn = 'through'
        AND s.name = 'signal_importance' AND e.importance <= s.value::integer AND EXISTS (
            SELECT FROM signal_movement b JOIN lane o ON o.lane_id = b.lane_in CROSS JOIN LATERAL (
                SELECT v.turn, v.geom FROM movement v WHERE (v.lane_in, v.lane_out, v.along_in, v.along_out)
                    = (b.lane_in, b.lane_out, b.along_in, b.along_out) OFFSET 0) v
            WHERE (b.controller_id, b.ordinality, b.right_of_way) = (a.controller_id, a.ordinality, 'protected')
                AND o.edge_id <> i.edge_id AND v.turn = 'through' AND ST_Intersects(v.geom, w.geom))
    GROUP BY c.controller_id, c.geom
    UNION ALL
    SELECT 'warning', 'cycle longer than decided, since its states last longer, s', 'controller', c.controller_id,
        c.cycle, c.geom FROM controller c JOIN controller_override o ON o.controller_override_id
            = (streetgen._overrides_at_junction(model, 'controller_override', c.controller_id))[1]
        WHERE c.cycle > o.cycle + 1e-6
    UNION ALL
    SELECT 'warning', 'durations by hand of another number of states', 'controller', c.controller_id,
        cardinality(o.durations), c.geom FROM controller c JOIN controller_override o
            ON o.controller_override_id
                = (streetgen._overrides_at_junction(model, 'controller_override', c.controller_id))[1]
        WHERE o.phases IS NULL AND cardinality(o.durations) <> (SELECT count(*) FROM signal_state s
            WHERE s.controller_id = c.controller_id)
    UNION ALL
    SELECT 'warning', 'durations by hand without their street', 'controller', c.controller_id, lost, c.geom
        FROM controller c JOIN controller_override o ON o.controller_override_id
                = (streetgen._overrides_at_junction(model, 'controller_override', c.controller_id))[1]
            CROSS JOIN LATERAL streetgen._lost_phases(model, c.controller_id, o.phases, o.approaches) lost
        WHERE o.durations IS NOT NULL AND lost > 0
    UNION ALL
    SELECT 'warning', 'controller override without its axis', 'controller_override', o.controller_override_id, 0, o.geom
        FROM controller_override o WHERE NOT EXISTS (SELECT FROM edge e JOIN axis a USING (axis_id)
            WHERE e.axis_id = o.axis_id AND streetgen._metres_beyond(ST_Force2D(a.geom), o.geom) <= 3 * tolerance)
    UNION ALL
    SELECT 'warning', 'controller override away from signals', 'controller_override', o.controller_override_id, 0,
        o.geom FROM controller_override o WHERE EXISTS (SELECT FROM edge e WHERE e.axis_id = o.axis_id)
            AND o.controller_override_id NOT IN (SELECT unnest(streetgen._overrides_at_junction(model,
                'controller_override', c.controller_id)) FROM controller c)
    UNION ALL
    SELECT 'warning', 'signal head off its stop line, m', 'lane', h.lane_id, ST_Distance(h.geom, m.geom), h.geom
        FROM signal_head h JOIN lane l USING (lane_id) JOIN marking m ON (m.edge_id, m.kind, m.lane_position,
            m.along_axis) = (l.edge_id, 'stop', l.lane_position, h.along_axis)
        WHERE NOT ST_DWithin(h.geom, m.geom, 0.01)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_signal(name) IS
    'The rows of streetgen.check_model for signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (45, 'signal', $part$
    (SELECT 'controllers, ' || method, count(*), NULL FROM %1$I.controller GROUP BY method ORDER BY method)$part$) $$;
COMMENT ON FUNCTION streetgen._signal_summary() IS 'What streetgen.summary counts of signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    ('controller'::name, 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id'),
    ('signal_state', 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id'),
    ('signal_movement', 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id'),
    ('signal_group', 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id'),
    ('intergreen', 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id'),
    ('signal_head', 'e.from_node = ($1).controller_id OR e.to_node = ($1).controller_id') $$;
COMMENT ON FUNCTION streetgen._signal_marked_by_hand() IS
    'The edges that a change of signals by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('junction of kind signals without a controller', 'the junction should have a program', '`generate`'),
    ('signal head off its stop line, m', 'traffic would wait elsewhere than its signal stands', '`generate`'),
    ('movement that never has green', 'the program forgets it', '`generate`; mend the program of the controller'),
    ('signals that the classifier alone says', 'no control point and no decision says that signals stand there',
        'put a control point, or decide the kind of the junction'),
    ('cycle longer than decided, since its states last longer, s',
        'amber, all red and the shortest greens need more than the cycle by hand',
        'type a longer cycle'),
    ('durations by hand of another number of states', 'the program has other states since',
        'type the durations anew, or delete the decision'),
    ('durations by hand without their street', 'no phase serves any more what they were typed for',
        'type the durations anew, or delete the decision'),
    ('controller override without its axis', 'the axis is gone, or ends before the place',
        'delete the row, or draw the axis'),
    ('controller override away from signals', 'no signals stand within control_distance of the place any more',
        'delete the row, or put the signals back'),
    ('green that begins before others have left, s', 'the junction is too long for signal_all_red, or durations by '
        'hand are too short: who begins has to let others out',
        'give signals more all red, or make two junctions of it'),
    ('cycle longer than signal_cycle, s', 'the shortest greens, walks and changes need more',
        'set signal_cycle to more seconds, or type durations'),
    ('through traffic that gives way at signals', 'a phase for each street makes a longer cycle than signal_cycle',
        'set signal_cycle to more seconds'),
    ('crossing at signals where people never have green', 'each state of the controller lets somebody drive over it',
        'give the controller another program, or move the control point to the street that people cross');
