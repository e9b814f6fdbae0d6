-- Signals for simulators: the programs of controllers, by the ways from lane to lane that they serve.

CREATE OR REPLACE FUNCTION streetgen._signal_controllers(model name)
    RETURNS TABLE(controller_id bigint, cycle float8, start_offset float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT c.controller_id, c.cycle, c.start_offset FROM controller c;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._signal_controllers(name) IS
    'The controllers of a model; none of one that computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_states(model name)
    RETURNS TABLE(controller_id bigint, ordinality integer, duration float8, kind text, green integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT s.controller_id, s.ordinality, s.duration, s.kind,
                max(s.ordinality) FILTER (WHERE s.kind = 'green')
                    OVER (PARTITION BY s.controller_id ORDER BY s.ordinality)
            FROM signal_state s;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._signal_states(name) IS
    'The states of controllers, each with the green one that it follows; none of a model that computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_movements(model name)
    RETURNS TABLE(controller_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
        interconnections bigint[], ordinality integer, protected boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT m.junction_id, m.lane_in, m.lane_out, m.along_in, m.along_out, m.interconnections,
                s.ordinality, s.right_of_way = 'protected'
            FROM movement m JOIN signal_movement s ON (s.controller_id, s.lane_in, s.lane_out, s.along_in, s.along_out)
                = (m.junction_id, m.lane_in, m.lane_out, m.along_in, m.along_out);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._signal_movements(name) IS
    'The movements of junctions in the states in which they have green; none of a model that computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_heads(model name)
    RETURNS TABLE(lane_id bigint, along_axis boolean, controller_id bigint, geom geometry, angle float8,
        greens integer[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT h.lane_id, h.along_axis, h.controller_id, h.geom, h.angle, ARRAY(
                SELECT DISTINCT m.ordinality FROM signal_movement m
                WHERE (m.controller_id, m.lane_in, m.along_in) = (h.controller_id, h.lane_id, h.along_axis)
                ORDER BY m.ordinality)
            FROM signal_head h;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._signal_heads(name) IS
    'The signals of lanes, with the states in which some movement from the lane has green; none of a model that '
    'computes no signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_links(model name, options jsonb, places bigint[], lanes_in bigint[],
    lanes_out bigint[], along_in boolean[], along_out boolean[], names_in text[], indexes_in bigint[],
    names_out text[], indexes_out bigint[])
    RETURNS TABLE(controller_id bigint, number bigint, place_id bigint, name_in text, index_in bigint, name_out text,
        index_out bigint, turn text, open boolean, greens integer[], protected integer[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Nothing is known of rows just computed: joins are on equal keys.
    SET enable_nestloop = off
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH signal_link AS MATERIALIZED (
        SELECT w.*, v.interconnections, v.turn, c.controller_id,
            row_number() OVER (PARTITION BY c.controller_id ORDER BY name_in COLLATE "C", index_in,
                name_out COLLATE "C", index_out) - 1 AS number,
            -- Who is within the junction leaves it.
            EXISTS (SELECT FROM lane l JOIN junction_edge e USING (edge_id) WHERE l.lane_id = w.lane_in) AS inside
        FROM unnest(places, lanes_in, lanes_out, _signal_links.along_in, _signal_links.along_out, names_in, indexes_in,
                names_out, indexes_out)
                w(place_id, lane_in, lane_out, along_in, along_out, name_in, index_in, name_out, index_out)
            JOIN streetgen._connecting_ways(model, options) v USING (lane_in, lane_out, along_in, along_out)
            JOIN (SELECT DISTINCT place_id, junction_id FROM streetgen._places(model, options)
                WHERE kind = 'signals') p USING (place_id)
            JOIN controller c ON c.controller_id = p.junction_id WHERE c.cycle > 0),
    served_way AS MATERIALIZED (
        SELECT k.controller_id, k.number, m.ordinality, bool_or(m.protected) AS protected
        FROM signal_link k JOIN streetgen._signal_movements(model) m ON m.controller_id = k.controller_id
            AND ((m.lane_in, m.lane_out, m.along_in, m.along_out) = (k.lane_in, k.lane_out, k.along_in, k.along_out)
                OR options ->> 'junctions' = 'node' AND k.interconnections <@ m.interconnections)
        WHERE NOT k.inside GROUP BY 1, 2, 3),
    -- No movement goes by each way of a junction of several nodes: others have green with their lane, else their edge.
    lent AS (
        SELECT k.controller_id, k.number, w.ordinality, l.index_in = k.index_in AS of_lane,
            bool_or(l.index_in = k.index_in) OVER (PARTITION BY k.controller_id, k.number) AS lane_served
        FROM signal_link k JOIN signal_link l USING (controller_id, name_in)
            JOIN served_way w ON (w.controller_id, w.number) = (l.controller_id, l.number)
        WHERE NOT k.inside AND NOT EXISTS (SELECT FROM served_way s
            WHERE (s.controller_id, s.number) = (k.controller_id, k.number))),
    served AS (
        SELECT controller_id, number, array_agg(ordinality ORDER BY ordinality) AS greens,
            array_agg(ordinality ORDER BY ordinality) FILTER (WHERE protected) AS protected
        FROM (TABLE served_way
            UNION ALL SELECT DISTINCT controller_id, number, ordinality, false FROM lent WHERE of_lane = lane_served) s
        GROUP BY controller_id, number)
    -- Who has green in no state does not wait for ever.
    SELECT k.controller_id, k.number, k.place_id, k.name_in, k.index_in, k.name_out, k.index_out, k.turn,
        inside OR s.number IS NULL, coalesce(s.greens, '{}'), coalesce(s.protected, '{}')
    FROM signal_link k LEFT JOIN served s USING (controller_id, number);
END $$;
COMMENT ON FUNCTION streetgen._signal_links(name, jsonb, bigint[], bigint[], bigint[], boolean[], boolean[], text[],
    bigint[], text[], bigint[]) IS
    'The ways at places of controllers, of those that are given with the names and numbers of their lanes in a file. '
    'They are counted for each controller from 0, open where they go in every state, and have green in the states '
    'greens, protected in some of these. None of a model that computes no signals.';
