-- Signals for SymuVia: the programs of controllers in whole seconds, a sequence for each green.

CREATE OR REPLACE FUNCTION streetgen._symuvia_signals(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN NOT computed THEN $part$,
controlled AS (SELECT 0::bigint AS place_id, ''::text AS controller WHERE false),
controller_line AS (SELECT 1 AS turn, 0::bigint AS id, NULL::xml AS element WHERE false)$part$
    ELSE $part$,
signal_way AS MATERIALIZED (
    SELECT way_id AS id, a.to_place AS place_id, a.name AS name_in, a.i AS index_in, b.name AS name_out,
        b.i AS index_out, k.lane_in, k.lane_out, k.along_in, k.along_out
    FROM way k JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in)
        JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out))$part$
    || streetgen._export_signals() || $part$,
controlled AS (SELECT DISTINCT place_id, 'F_' || controller_id AS controller FROM link),
-- What is left of a second in one state is shown in the next one, so that the cycle lasts as long.
whole_state AS (
    SELECT controller_id, coalesce(green, 0) AS green, kind,
        (round(ends::numeric) - round((ends - duration)::numeric))::integer AS seconds
    FROM (SELECT *, sum(duration) OVER (PARTITION BY controller_id ORDER BY ordinality) AS ends FROM state) s
    WHERE controller_id IN (SELECT controller_id FROM link)),
signal_sequence AS MATERIALIZED (
    SELECT controller_id, green, sum(seconds) AS seconds,
        coalesce(sum(seconds) FILTER (WHERE kind = 'green'), 0) AS shown,
        coalesce(sum(seconds) FILTER (WHERE kind = 'amber'), 0) AS amber
    FROM whole_state GROUP BY controller_id, green HAVING sum(seconds) > 0),
-- Troncons are what SymuVia gives green to. A sequence has a signal, if it were one that stays red.
signal_shown AS (
    SELECT s.controller_id, s.green, name_in, name_out, bool_or(k.open) AS open,
        bool_or(k.open OR v.number IS NOT NULL) AS serves,
        row_number() OVER (PARTITION BY s.controller_id, s.green
            ORDER BY bool_or(k.open OR v.number IS NOT NULL) DESC, name_in COLLATE "C", name_out COLLATE "C") AS turn
    FROM signal_sequence s JOIN link k USING (controller_id) LEFT JOIN served v
        ON (v.controller_id, v.number, v.ordinality) = (k.controller_id, k.number, s.green)
    GROUP BY s.controller_id, s.green, name_in, name_out),
sequence_line AS (
    SELECT s.controller_id, s.green, xmlelement(name "SEQUENCE", xmlattributes(s.seconds AS duree_totale),
        xmlelement(name "SIGNAUX_ACTIFS", xmlagg(xmlelement(name "SIGNAL_ACTIF", xmlattributes(
            0 AS duree_retard_allumage,
            CASE WHEN open THEN seconds WHEN serves THEN shown ELSE 0 END AS duree_vert,
            CASE WHEN serves AND NOT open THEN amber ELSE 0 END AS duree_orange, name_in AS troncon_entree,
            name_out AS troncon_sortie)) ORDER BY g.turn))) AS element
    FROM signal_sequence s JOIN signal_shown g USING (controller_id, green)
    WHERE serves OR turn = 1 GROUP BY s.controller_id, s.green, s.seconds),
controller_line AS (
    SELECT 1 AS turn, c.controller_id AS id, xmlelement(name "CONTROLEUR_DE_FEUX", xmlattributes(
        'F_' || c.controller_id AS id, 1 AS duree_vert_min, 1 AS duree_rouge_degagement), xmlelement(
        name "PLANS_DE_FEUX", xmlelement(name "PLAN_DE_FEUX", xmlattributes('P_' || c.controller_id AS id,
            -- A cycle before the simulation begins, and later by the offset.
            CASE WHEN round(start_offset) > 0 THEN (time '07:00' + (mod(start_offset::numeric, cycle::numeric)
                - cycle::numeric)::integer * interval '1 second')::text END AS debut),
            xmlelement(name "SEQUENCES", xmlagg(s.element ORDER BY green))))) AS element
    FROM sequence_line s JOIN %1$I.controller c USING (controller_id)
    GROUP BY c.controller_id, c.start_offset, c.cycle)$part$ END $$;
COMMENT ON FUNCTION streetgen._symuvia_signals(boolean) IS
    'Queries of the network of SymuVia, after streetgen._symuvia_network(): controlled, the controller of each place '
    'that has one; controller_line, the controllers with their programs. Nothing of a model that computes no signals.';
