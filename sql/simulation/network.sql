-- The network of links, on which simulators drive.

CREATE OR REPLACE FUNCTION streetgen._traffic_network(edges streetgen.traffic_edge[], lanes streetgen.traffic_lane[],
    movements streetgen.traffic_movement[], beside streetgen.traffic_beside[], aspects streetgen.traffic_aspect[],
    plans streetgen.traffic_plan[], left_hand boolean) RETURNS bytea
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_traffic_network';
COMMENT ON FUNCTION streetgen._traffic_network(streetgen.traffic_edge[], streetgen.traffic_lane[],
    streetgen.traffic_movement[], streetgen.traffic_beside[], streetgen.traffic_aspect[], streetgen.traffic_plan[],
    boolean) IS
    'The network of some links as one value, which functions of simulation take: smooth courses, heights, neighbours, '
    'conflicts, and what signals show. left_hand: traffic keeps left. NULL for rows: none. A movement whose lanes are '
    'not there is left out; a lane without length or edge, a link that stands twice: 22023.';

CREATE OR REPLACE FUNCTION streetgen._movement_aspects(model name, lanes bigint[])
    RETURNS TABLE(controller_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
        since float8, aspect text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH served AS MATERIALIZED (
        SELECT s.* FROM signal_movement s WHERE s.lane_in = ANY (lanes)),
    state AS MATERIALIZED (
        SELECT s.*, sum(s.duration) OVER w - s.duration AS since, max(s.ordinality) FILTER (WHERE s.kind = 'green')
            OVER w AS green
        FROM signal_state s WHERE s.controller_id IN (SELECT v.controller_id FROM served v)
        WINDOW w AS (PARTITION BY s.controller_id ORDER BY s.ordinality))
    SELECT m.controller_id, m.lane_in, m.lane_out, m.along_in, m.along_out, s.since,
        CASE WHEN s.kind NOT IN ('green', 'amber') OR v.ordinality IS NULL THEN 'red' WHEN s.kind = 'amber' THEN s.kind
            ELSE v.right_of_way END
    FROM (SELECT DISTINCT o.controller_id, o.lane_in, o.lane_out, o.along_in, o.along_out FROM served o) m
        JOIN state s USING (controller_id)
        LEFT JOIN served v ON (v.controller_id, v.lane_in, v.lane_out, v.along_in, v.along_out, v.ordinality)
            = (m.controller_id, m.lane_in, m.lane_out, m.along_in, m.along_out, s.green);
END $$;
COMMENT ON FUNCTION streetgen._movement_aspects(name, bigint[]) IS
    'What signals show each movement from some lanes, from since on, seconds of the cycle: '
    'red, amber, permitted or protected; none of a model that computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._movement_rights(model name, lanes bigint[])
    RETURNS TABLE(lane_in bigint, lane_out bigint, along_in boolean, along_out boolean, turn text, rank integer,
        importance integer, precedence integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT r.lane_in, r.lane_out, r.along_in, r.along_out, r.turn,
                CASE r.rule WHEN 'yield' THEN 1 WHEN 'stop' THEN 2 ELSE 0 END,
                -- Where nobody has priority, the street counts for nothing.
                CASE WHEN r.rule <> 'right_before_left' THEN e.importance ELSE 0 END, coalesce(s.precedence, 0)
            FROM right_of_way r JOIN lane l ON l.lane_id = r.lane_in JOIN edge e USING (edge_id)
                LEFT JOIN streetgen._signal_precedences(model, lanes) s USING (lane_in, lane_out, along_in, along_out)
            WHERE r.connecting AND r.lane_in = ANY (lanes);
    ELSE
        RETURN QUERY SELECT i.lane_in, i.lane_out, i.along_in, i.along_out, i.turn,
                CASE m.kind WHEN 'yield' THEN 1 WHEN 'stop' THEN 2 ELSE 0 END, e.importance, 0
            FROM interconnection i JOIN lane l ON l.lane_id = i.lane_in JOIN edge e USING (edge_id)
                LEFT JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis) = (l.edge_id, l.lane_position,
                    i.along_in) AND m.kind IN ('stop', 'yield')
            WHERE i.connecting AND i.lane_in = ANY (lanes);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._movement_rights(name, bigint[]) IS
    'Turn and right of way of each movement from some lanes that connects. rank: 0 goes first, 1 gives '
    'way, 2 stops. importance: that of its street, of two of one rank. precedence: of two that have green together. '
    'Of each the smaller goes first.';

CREATE OR REPLACE FUNCTION streetgen._signal_precedences(model name, lanes bigint[])
    RETURNS TABLE(lane_in bigint, lane_out bigint, along_in boolean, along_out boolean, precedence integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT s.lane_in, s.lane_out, s.along_in, s.along_out, min(s.precedence)
            FROM signal_movement s WHERE s.lane_in = ANY (lanes) GROUP BY 1, 2, 3, 4;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._signal_precedences(name, bigint[]) IS
    'The place of each movement from some lanes that has a signal, in the order of who goes first; none of a '
    'model that computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._network_of_lanes(model name, lanes bigint[]) RETURNS bytea
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (WITH lane_link AS MATERIALIZED (
        SELECT k.*, l.edge_id, l.lane_position, CASE WHEN l.both_ways THEN k.link_id # 1 END AS other_way
        FROM link k JOIN lane l USING (lane_id)
        WHERE k.kind = 'lane' AND k.lane_id = ANY (lanes)),
    movement_link AS MATERIALIZED (
        SELECT k.* FROM link k WHERE k.kind = 'movement' AND k.lane_in = ANY (lanes)),
    aspect AS MATERIALIZED (
        SELECT k.link_id, a.controller_id, a.since, a.aspect FROM movement_link k
            JOIN streetgen._movement_aspects(model, lanes) a USING (lane_in, lane_out, along_in, along_out)),
    rights AS MATERIALIZED (
        SELECT k.link_id, r.turn, r.rank, r.importance, r.precedence FROM movement_link k
            JOIN streetgen._movement_rights(model, lanes) r USING (lane_in, lane_out, along_in, along_out)),
    signalled AS (SELECT DISTINCT a.link_id, a.controller_id FROM aspect a),
    extent AS MATERIALIZED (
        SELECT x.lane_id, x.edge_id, x.widest, x.start_abscissa - e.start_abscissa AS starts,
            x.end_abscissa - e.start_abscissa AS ends
        FROM lane_extent x JOIN edge e USING (edge_id) WHERE x.lane_id = ANY (lanes)),
    edge_of_lane AS MATERIALIZED (
        SELECT e.edge_id, e.start_abscissa, coalesce(h.geom, ST_Force2D(e.geom)) AS geom, w.widest
        FROM (SELECT x.edge_id, max(x.widest) AS widest FROM extent x GROUP BY x.edge_id) w
            JOIN edge e USING (edge_id) LEFT JOIN streetgen._heights_of(model,
                ARRAY(SELECT x.edge_id FROM extent x)) h USING (edge_id)),
    waiting AS (
        SELECT k.link_id, max(k.length * (1 - ST_LineLocatePoint(k.geom, ST_Centroid(m.geom)))) AS stop
        FROM lane_link k JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis)
            = (k.edge_id, k.lane_position, k.along_axis) AND m.kind IN ('stop', 'yield') GROUP BY k.link_id),
    beside AS (
        SELECT k.link_id, o.link_id AS other, (a.side = 'left') = k.along_axis AS at_left, a.change = 'allowed'
                AND k.along_axis = o.along_axis AS may_change, k.along_axis <> o.along_axis AS opposite,
            a.start_abscissa - e.start_abscissa AS starts, a.end_abscissa - e.start_abscissa AS ends
        FROM lane_adjacency a JOIN lane_link k ON k.lane_id = a.lane_a JOIN lane_link o ON o.lane_id = a.lane_b
            JOIN edge e ON e.edge_id = k.edge_id
        WHERE a.end_abscissa > a.start_abscissa)
    SELECT streetgen._traffic_network(
        (SELECT array_agg((e.edge_id, ST_AsEWKB(e.geom), e.widest)::streetgen.traffic_edge ORDER BY e.edge_id)
            FROM edge_of_lane e),
        (SELECT array_agg((k.link_id, k.edge_id, k.along_axis, x.starts, x.ends, coalesce(w.stop, 0), k.width, k.speed,
                k.traffic, k.from_node, k.to_node, k.junction_id, k.other_way,
                ST_AsEWKB(k.geom))::streetgen.traffic_lane ORDER BY k.link_id)
            FROM lane_link k JOIN extent x USING (lane_id) LEFT JOIN waiting w USING (link_id)),
        (SELECT array_agg((k.link_id, k.comes_from, k.leads_to, k.width, k.traffic, r.turn, r.rank, r.importance,
                r.precedence, k.junction_id, s.controller_id, ST_AsEWKB(k.geom))::streetgen.traffic_movement
                ORDER BY k.link_id)
            FROM movement_link k JOIN rights r USING (link_id) LEFT JOIN signalled s USING (link_id)),
        (SELECT array_agg((b.link_id, b.other, b.at_left, b.may_change, b.opposite, b.starts,
                b.ends)::streetgen.traffic_beside ORDER BY b.link_id, b.other) FROM beside b),
        (SELECT array_agg((a.link_id, a.since, a.aspect)::streetgen.traffic_aspect ORDER BY a.link_id, a.since)
            FROM aspect a),
        (SELECT array_agg((c.controller_id, c.cycle, c.start_offset)::streetgen.traffic_plan ORDER BY c.controller_id)
            FROM streetgen._signal_controllers(model) c WHERE c.cycle > 0),
        streetgen._setting_text(model, 'driving_side') = 'left'));
END $$;
COMMENT ON FUNCTION streetgen._network_of_lanes(name, bigint[]) IS
    'The network of some lanes and of the movements between them. Its statement is planned for these lanes, or once a '
    'session, as plan_cache_mode says.';

CREATE OR REPLACE FUNCTION streetgen._network_of_links(model name) RETURNS bytea
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN streetgen._network_of_lanes(model, ARRAY(SELECT l.lane_id FROM lane l));
END $$;
COMMENT ON FUNCTION streetgen._network_of_links(name) IS 'The network of all links of a model.';

CREATE OR REPLACE FUNCTION streetgen._link_pieces(network bytea)
    RETURNS TABLE(link_id bigint, starts float8, ends float8, x float8, y float8, heading float8, curvature float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_link_pieces';
COMMENT ON FUNCTION streetgen._link_pieces(bytea) IS
    'The courses of the links of a network: straight lines, and arcs where there is a curvature (1/m, positive to the '
    'left). Each piece begins at x and y in its heading (radians), and reaches from starts to ends, metres along the '
    'course. Bytes that are no network: 22023.';
