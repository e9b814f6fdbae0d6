-- Signals for simulators: the programs of controllers, by the ways from lane to lane that they serve.

CREATE OR REPLACE FUNCTION streetgen._export_signals() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
signal_link AS MATERIALIZED (
    SELECT w.*, c.controller_id, row_number() OVER (PARTITION BY c.controller_id ORDER BY name_in COLLATE "C",
            index_in, name_out COLLATE "C", index_out) - 1 AS number,
        -- Who is within the junction leaves it.
        EXISTS (SELECT FROM %1$I.lane l JOIN %1$I.junction_edge e USING (edge_id) WHERE l.lane_id = w.lane_in) AS inside
    FROM signal_way w JOIN (SELECT DISTINCT place_id, junction_id FROM place WHERE kind = 'signals') p USING (place_id)
        JOIN %1$I.controller c ON c.controller_id = p.junction_id WHERE c.cycle > 0),
served_way AS MATERIALIZED (
    SELECT k.controller_id, k.number, s.ordinality, bool_or(s.right_of_way = 'protected') AS protected
    FROM signal_link k JOIN %1$I.movement m ON m.junction_id = k.controller_id
        AND ((m.lane_in, m.lane_out, m.along_in, m.along_out) = (k.lane_in, k.lane_out, k.along_in, k.along_out)
            OR $1 ->> 'junctions' = 'node' AND k.id = ANY (m.interconnections))
        JOIN %1$I.signal_movement s ON (s.controller_id, s.lane_in, s.lane_out, s.along_in, s.along_out)
            = (k.controller_id, m.lane_in, m.lane_out, m.along_in, m.along_out)
    WHERE NOT k.inside GROUP BY 1, 2, 3),
-- No movement goes by each way of a junction of several nodes: others have green with their lane, else their edge.
lent AS (
    SELECT k.controller_id, k.number, w.ordinality, l.index_in = k.index_in AS of_lane,
        bool_or(l.index_in = k.index_in) OVER (PARTITION BY k.controller_id, k.number) AS lane_served
    FROM signal_link k JOIN signal_link l USING (controller_id, name_in)
        JOIN served_way w ON (w.controller_id, w.number) = (l.controller_id, l.number)
    WHERE NOT k.inside AND NOT EXISTS (SELECT FROM served_way s
        WHERE (s.controller_id, s.number) = (k.controller_id, k.number))),
served AS MATERIALIZED (
    SELECT * FROM served_way
    UNION ALL SELECT DISTINCT controller_id, number, ordinality, false FROM lent WHERE of_lane = lane_served),
-- Who has green in no state does not wait for ever.
link AS MATERIALIZED (
    SELECT k.*, inside OR NOT EXISTS (SELECT FROM served s
        WHERE (s.controller_id, s.number) = (k.controller_id, k.number)) AS open
    FROM signal_link k),
state AS MATERIALIZED (
    SELECT s.*, max(ordinality) FILTER (WHERE kind = 'green') OVER (PARTITION BY controller_id ORDER BY ordinality)
        AS green FROM %1$I.signal_state s)$part$ $$;
COMMENT ON FUNCTION streetgen._export_signals() IS
    'Queries of writers over a model that computes signals, after signal_way: the ways with id, place_id, names and '
    'numbers of their lanes in the file (name_in, index_in, name_out, index_out), and lanes of the model. They are '
    'link, the ways at places of controllers, counted for each from 0, open where they go in every state; served, in '
    'which states each has green; state, the states, each with the green one that it follows.';
