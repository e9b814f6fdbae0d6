-- Signals for SUMO: a program for each controller, of the crossings and the connections that it serves.

CREATE OR REPLACE FUNCTION streetgen._sumo_signals(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH crossed AS MATERIALIZED (SELECT * FROM streetgen._sumo_crossings(model, options)),
    state AS MATERIALIZED (SELECT * FROM streetgen._signal_states(model)),
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
    walked AS (
        SELECT c.controller_id, c.number, s.ordinality, CASE s.kind
            WHEN 'all_red' THEN s.duration >= 4 + c.across / 1.2
            WHEN 'green' THEN d.number IS NULL
            ELSE false END AS goes
        FROM crossed c JOIN state s USING (controller_id) LEFT JOIN driven d
            ON (d.controller_id, d.number, d.ordinality) = (c.controller_id, c.number, s.ordinality)),
    yielding AS MATERIALIZED (SELECT controller_id, link FROM driven_over GROUP BY 1, 2 HAVING NOT bool_or(stops)),
    sign AS (
        -- Who has green in no state looks for a gap.
        SELECT controller_id, ordinality, 0 AS turn, number, CASE WHEN goes THEN 'G'
            WHEN bool_or(goes) OVER (PARTITION BY controller_id, number) THEN 'r' ELSE 'g' END AS sign
        FROM walked
        UNION ALL
        SELECT s.controller_id, s.ordinality, 1, k.number, CASE WHEN k.open THEN 'g'
                WHEN v.number IS NULL OR s.kind = 'all_red' THEN 'r' WHEN s.kind = 'amber' THEN 'y'
                WHEN v.protected AND y.link IS NULL THEN 'G' ELSE 'g' END
        FROM state s JOIN link k USING (controller_id) LEFT JOIN served v ON (v.controller_id, v.number, v.ordinality)
            = (s.controller_id, k.number, s.green)
            LEFT JOIN yielding y ON (y.controller_id, y.link) = (s.controller_id, k.number)),
    shown AS (
        SELECT controller_id, ordinality, string_agg(sign, '' ORDER BY turn, number) AS signs
        FROM sign WHERE controller_id IN (SELECT controller_id FROM link) GROUP BY controller_id, ordinality)
    SELECT 1, controller_id, xmlelement(name "tlLogic", xmlattributes(controller_id AS id, 'static'
            AS type, 'streetgen' AS "programID", round(min(c.start_offset)::numeric, 2) AS "offset"),
        xmlagg(xmlelement(name phase, xmlattributes(round(s.duration::numeric, 2) AS duration, signs AS state))
            ORDER BY s.ordinality))::text
    FROM shown JOIN state s USING (controller_id, ordinality)
        JOIN streetgen._signal_controllers(model) c USING (controller_id)
    GROUP BY controller_id
    UNION ALL SELECT 2, controller_id, xmlelement(name connection, xmlattributes(name_in AS "from", name_out AS "to",
        index_in AS "fromLane", index_out AS "toLane", controller_id AS tl,
        number + (SELECT count(*) FROM crossed c WHERE c.controller_id = link.controller_id) AS "linkIndex"))::text
    FROM link;
END $$;
COMMENT ON FUNCTION streetgen._sumo_signals(name, jsonb) IS
    'The elements of a plain file of SUMO: the programs of controllers and the connections that they serve, after '
    'their crossings; nothing of a model that computes no signals.';
