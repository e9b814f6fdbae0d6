-- Rules of check_model for signals.

CREATE OR REPLACE FUNCTION streetgen._signal_check_part()
    RETURNS TABLE(place integer, subject text, kind text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (90, 'signal', 'rule', $part$
SELECT 'error', 'junction of kind signals without a controller', 'junction', j.junction_id, 0, j.geom
    FROM %1$I.junction j WHERE j.kind = 'signals' AND NOT EXISTS (SELECT FROM %1$I.controller c
        WHERE c.controller_id = j.junction_id)$part$),
    (91, 'signal', 'rule', $part$
SELECT 'error', 'movement that never has green', 'controller', c.controller_id, m.lane_in, m.geom
    FROM %1$I.controller c JOIN %1$I.movement m ON m.junction_id = c.controller_id
    WHERE m.connecting AND NOT EXISTS (SELECT FROM %1$I.signal_movement s WHERE (s.lane_in, s.lane_out, s.along_in,
        s.along_out) = (m.lane_in, m.lane_out, m.along_in, m.along_out))$part$),
    (92, 'signal', 'rule', $part$
SELECT 'notice', 'crossing at signals where people never have green', 'control_point', c.control_point_id,
    c.seconds, c.geom FROM %1$I.junction_crossing c JOIN %1$I.controller k ON k.controller_id = c.junction_id
    -- The view is computed once so, and not for each crossing.
    WHERE (c.junction_id, c.control_point_id, c.edge_id) NOT IN (
        SELECT s.controller_id, s.control_point_id, s.edge_id FROM %1$I.signal_crossing s)$part$),
    (92, 'signal', 'rule', $part$
SELECT 'notice', 'signals that the classifier alone says', 'controller', c.controller_id, c.cycle, c.geom
    FROM %1$I.controller c WHERE c.method = 'classified'$part$),
    (93, 'signal', 'rule', $part$
SELECT 'warning', 'cycle longer than decided, since its states last longer, s', 'controller', c.controller_id,
    c.cycle, c.geom FROM %1$I.controller c JOIN %1$I.controller_override o ON o.controller_override_id
        = (streetgen._overrides_at_junction(%1$L, 'controller_override', c.controller_id))[1]
    WHERE c.cycle > o.cycle + 1e-6$part$),
    (94, 'signal', 'rule', $part$
SELECT 'warning', 'durations by hand of another number of states', 'controller', c.controller_id,
    cardinality(o.durations), c.geom FROM %1$I.controller c JOIN %1$I.controller_override o
        ON o.controller_override_id
            = (streetgen._overrides_at_junction(%1$L, 'controller_override', c.controller_id))[1]
    WHERE cardinality(o.durations) <> (SELECT count(*) FROM %1$I.signal_state s
        WHERE s.controller_id = c.controller_id)$part$),
    (95, 'signal', 'rule', $part$
SELECT 'warning', 'controller override without its axis', 'controller_override', o.controller_override_id, 0, o.geom
    FROM %1$I.controller_override o WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = o.axis_id)$part$) $$;
COMMENT ON FUNCTION streetgen._signal_check_part() IS 'The parts of streetgen._check_part() for signals.';
