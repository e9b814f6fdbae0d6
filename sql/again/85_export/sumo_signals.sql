-- Signals for SUMO: a program for each controller, of the crossings and the connections that it serves.

CREATE OR REPLACE FUNCTION streetgen._sumo_signals(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN 'signal' <> ALL (subjects) THEN $part$, line AS (
    SELECT 1 AS turn, 0 AS id, NULL::xml AS element WHERE false)$part$
    ELSE streetgen._sumo_going_on(subjects) || streetgen._sumo_crossings(subjects) || $part$,
signal_way AS (SELECT *, goes_to::bigint AS place_id FROM going_on WHERE lane_in IS NOT NULL)$part$
    || streetgen._export_signals() || $part$,
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
    FROM sign WHERE controller_id IN (SELECT controller_id FROM link) GROUP BY controller_id, ordinality),
line AS (
    SELECT 1 AS turn, controller_id AS id, xmlelement(name "tlLogic", xmlattributes(controller_id AS id, 'static'
            AS type, 'streetgen' AS "programID", round(min(c.start_offset)::numeric, 2) AS "offset"),
        xmlagg(xmlelement(name phase, xmlattributes(round(s.duration::numeric, 2) AS duration, signs AS state))
            ORDER BY s.ordinality)) AS element
    FROM shown JOIN state s USING (controller_id, ordinality) JOIN %1$I.controller c USING (controller_id)
    GROUP BY controller_id
    UNION ALL SELECT 2, controller_id, xmlelement(name connection, xmlattributes(name_in AS "from", name_out AS "to",
        index_in AS "fromLane", index_out AS "toLane", controller_id AS tl,
        number + (SELECT count(*) FROM crossed c WHERE c.controller_id = link.controller_id) AS "linkIndex"))
    FROM link)$part$
    END $$;
COMMENT ON FUNCTION streetgen._sumo_signals(text[]) IS
    'Queries of a plain file of SUMO as streetgen._export_lines takes them: the programs of controllers and the '
    'connections that they serve, after their crossings; nothing of a model that computes no signals.';
