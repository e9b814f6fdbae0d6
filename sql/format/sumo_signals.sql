-- Signals for SUMO: a program for each controller, of the crossings and the connections that it serves.

CREATE OR REPLACE FUNCTION streetgen._sumo_signals(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH crossed AS MATERIALIZED (SELECT * FROM streetgen._sumo_crossings(model, options)),
    -- A state for people alone goes where nobody can ask for it, unless a wave counts on it.
    state AS MATERIALIZED (
        SELECT s.* FROM streetgen._signal_states(model) s JOIN streetgen._signal_controllers(model) k
            USING (controller_id)
        WHERE s.kind <> 'walk' OR k.start_offset <> 0
            OR EXISTS (SELECT FROM crossed c WHERE c.controller_id = s.controller_id)),
    link AS MATERIALIZED (
        SELECT k.* FROM (SELECT array_agg(goes_to::bigint) AS places, array_agg(lane_in) AS lanes_in,
                array_agg(lane_out) AS lanes_out, array_agg(along_in) AS along_in, array_agg(along_out) AS along_out,
                array_agg(name_in) AS names_in, array_agg(index_in) AS indexes_in, array_agg(name_out) AS names_out,
                array_agg(index_out) AS indexes_out
            FROM streetgen._sumo_going_on(model, options) WHERE lane_in IS NOT NULL) w,
            streetgen._signal_links(model, options, places, lanes_in, lanes_out, along_in, along_out, names_in,
                indexes_in, names_out, indexes_out) k),
    served AS MATERIALIZED (
        SELECT controller_id, number, ordinality, ordinality = ANY (protected) AS protected
        FROM link, unnest(greens) ordinality),
    -- People on foot go while nobody drives in from there, or straight out. Who turns gives way to them.
    driven_over AS MATERIALIZED (
        SELECT c.controller_id, c.number, k.number AS link, k.name_in = ANY (names) OR k.turn = 'through' AS stops
        FROM crossed c JOIN link k USING (controller_id, place_id)
        WHERE k.name_in = ANY (names) OR k.name_out = ANY (names)),
    driven AS MATERIALIZED (
        SELECT DISTINCT o.controller_id, o.number, v.ordinality FROM driven_over o JOIN served v
            ON (v.controller_id, v.number) = (o.controller_id, o.link) WHERE stops),
    timed AS MATERIALIZED (
        SELECT *, sum(duration) OVER w - duration AS starts, sum(duration) OVER w AS ends,
            sum(duration) OVER (PARTITION BY controller_id) AS cycle
        FROM state WINDOW w AS (PARTITION BY controller_id ORDER BY ordinality)),
    -- People who step on last are across before somebody drives there.
    walked AS MATERIALIZED (
        SELECT controller_id, number, starts, until
        FROM (SELECT c.controller_id, c.number, s.starts, least(s.ends, min(t.starts
                    + CASE WHEN t.starts < s.starts THEN t.cycle ELSE 0 END)
                    - ceil(c.across / (SELECT value::float8 FROM setting WHERE name = 'walking_speed'))) AS until
            FROM crossed c JOIN timed s USING (controller_id) LEFT JOIN driven d ON (d.controller_id, d.number)
                = (c.controller_id, c.number) LEFT JOIN timed t ON (t.controller_id, t.ordinality) = (d.controller_id,
                d.ordinality)
            WHERE s.kind = 'walk' OR s.kind = 'green' AND NOT EXISTS (SELECT FROM driven o
                WHERE (o.controller_id, o.number, o.ordinality) = (c.controller_id, c.number, s.ordinality))
            GROUP BY c.controller_id, c.number, c.across, s.ordinality, s.starts, s.ends) w
        WHERE until - starts >= (SELECT value::float8 FROM setting WHERE name = 'walk_shortest')),
    -- A state is cut where a walk ends within it.
    part AS MATERIALIZED (
        SELECT s.controller_id, s.ordinality, s.kind, s.green, p.starts,
            lead(p.starts, 1, s.ends) OVER (PARTITION BY s.controller_id, s.ordinality ORDER BY p.starts) AS ends
        FROM timed s CROSS JOIN LATERAL (SELECT s.starts UNION SELECT w.until FROM walked w
            WHERE w.controller_id = s.controller_id AND w.until > s.starts + 0.005 AND w.until < s.ends - 0.005) p),
    yielding AS MATERIALIZED (SELECT controller_id, link FROM driven_over GROUP BY 1, 2 HAVING NOT bool_or(stops)),
    sign AS (
        -- Who has green in no state looks for a gap.
        SELECT p.controller_id, p.starts, 1 AS turn, c.number, CASE WHEN bool_or(w.starts <= p.starts
                AND w.until >= p.ends - 0.005) THEN 'G' WHEN count(w.starts) > 0 THEN 'r' ELSE 'g' END AS sign
        FROM part p JOIN crossed c USING (controller_id) LEFT JOIN walked w USING (controller_id, number)
        GROUP BY p.controller_id, p.starts, c.number
        UNION ALL
        SELECT s.controller_id, s.starts, 0, k.number, CASE WHEN k.open THEN 'g'
                WHEN v.number IS NULL OR s.kind IN ('all_red', 'walk') THEN 'r' WHEN s.kind = 'amber' THEN 'y'
                WHEN v.protected AND y.link IS NULL THEN 'G' ELSE 'g' END
        FROM part s JOIN link k USING (controller_id) LEFT JOIN served v ON (v.controller_id, v.number, v.ordinality)
            = (s.controller_id, k.number, s.green)
            LEFT JOIN yielding y ON (y.controller_id, y.link) = (s.controller_id, k.number)),
    shown AS (
        SELECT controller_id, starts, string_agg(sign, '' ORDER BY turn, number) AS signs
        FROM sign WHERE controller_id IN (SELECT controller_id FROM link) GROUP BY controller_id, starts)
    SELECT 1, controller_id, xmlelement(name "tlLogic", xmlattributes(controller_id AS id,
            options ->> 'programs' AS type, 'streetgen' AS "programID", round(min(c.start_offset)) AS "offset"),
        -- Tools of SUMO read whole seconds: what is beyond goes to the next phase, and the cycle lasts as long.
        xmlagg(xmlelement(name phase, xmlattributes(seconds AS duration, signs AS state,
            -- Detectors end a green after 5 s where nobody walks, and prolong it by half.
            CASE WHEN adapts AND NOT walks THEN least(seconds, 5) WHEN adapts THEN seconds END AS "minDur",
            CASE WHEN adapts THEN ceil(1.5 * seconds) END AS "maxDur")) ORDER BY s.starts))::text
    FROM shown JOIN part s USING (controller_id, starts)
        JOIN streetgen._signal_controllers(model) c USING (controller_id)
        JOIN (SELECT t.controller_id, t.ordinality, t.ends AS state_ends, EXISTS (SELECT FROM walked w
                WHERE w.controller_id = t.controller_id AND w.starts < t.ends AND w.until > t.starts) AS walks
            FROM timed t) t USING (controller_id, ordinality)
        CROSS JOIN LATERAL (SELECT round(s.ends) - round(s.starts) AS seconds,
            options ->> 'programs' = 'actuated' AND s.kind = 'green' AND s.ends = t.state_ends AS adapts) d
    WHERE seconds > 0
    GROUP BY controller_id
    UNION ALL SELECT 2, controller_id, xmlelement(name connection, xmlattributes(name_in AS "from", name_out AS "to",
        index_in AS "fromLane", index_out AS "toLane", controller_id AS tl, number AS "linkIndex"))::text
    FROM link;
END $$;
COMMENT ON FUNCTION streetgen._sumo_signals(name, jsonb) IS
    'The elements of a plain file of SUMO: the programs of controllers and the connections that they serve, before '
    'their crossings; nothing of a model that computes no signals.';
