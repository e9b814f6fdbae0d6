-- OpenDRIVE: signals and signs at the ends of roads, and the controllers of signals.

CREATE OR REPLACE FUNCTION streetgen._opendrive_signals(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN computed THEN $part$,
-- Lanes whose signals show the same in each state have one controller.
signal_group AS MATERIALIZED (
    SELECT *, dense_rank() OVER (ORDER BY controller_id, greens) AS number
    FROM (SELECT h.lane_id, h.along_axis, h.controller_id, h.geom, ARRAY(
            SELECT DISTINCT m.ordinality FROM %1$I.signal_movement m
            WHERE (m.controller_id, m.lane_in, m.along_in) = (h.controller_id, h.lane_id, h.along_axis)
            ORDER BY m.ordinality) AS greens
        FROM %1$I.signal_head h) g),
program AS MATERIALIZED (
    SELECT c.controller_id, 'cycle ' || round(min(c.cycle)::numeric, 2) || ' offset '
        || round(min(c.start_offset)::numeric, 2) || ': ' || string_agg(s.ordinality || ' ' || s.kind || ' '
        || round(s.duration::numeric, 2), ', ' ORDER BY s.ordinality) AS text
    FROM %1$I.controller c JOIN %1$I.signal_state s USING (controller_id) GROUP BY controller_id)$part$
    ELSE $part$,
signal_group AS (SELECT NULL::bigint AS lane_id, NULL::boolean AS along_axis, NULL::bigint AS controller_id,
    NULL::geometry AS geom, NULL::integer[] AS greens, NULL::bigint AS number WHERE false),
program AS (SELECT NULL::bigint AS controller_id, NULL::text AS text WHERE false)$part$ END || $part$,
-- A signal hangs above the end of its lane; a sign stands half a metre beside the lanes that it is for.
sign AS MATERIALIZED (
    SELECT p.road_id, s.station, s.aside, g.along_axis, 5 AS raised, p.number AS first, p.number AS last,
        'yes' AS dynamic, 'OpenDRIVE' AS country, '1000001' AS type, 'signal' AS name, g.number AS controller,
        CASE WHEN g.along_axis THEN e.to_node ELSE e.from_node END AS node_id, g.controller_id
    FROM signal_group g JOIN placed p ON (p.lane_id, p.at_end) = (g.lane_id, g.along_axis)
        JOIN written_edge e USING (edge_id) JOIN drawn d ON d.road_id = p.road_id,
        streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, ST_X(g.geom),
            ST_Y(g.geom)) s
    UNION ALL
    SELECT d.road_id, s.station, CASE WHEN m.along_axis = right_hand THEN
                border[cardinality(border) - CASE WHEN m.along_axis THEN 0 ELSE stations - 1 END] - 0.5
            ELSE border[CASE WHEN m.along_axis THEN stations ELSE 1 END] + 0.5 END,
        m.along_axis, 2, m.first, m.last, 'no', 'DE', m.type, m.kind, NULL, NULL, NULL
    FROM (SELECT p.road_id, m.along_axis, m.kind, CASE m.kind WHEN 'stop' THEN '206' ELSE '205' END AS type,
            min(p.number) AS first, max(p.number) AS last, (array_agg(m.geom ORDER BY p.number))[1] AS geom
        FROM %1$I.marking m JOIN %1$I.lane l USING (edge_id, lane_position)
            JOIN placed p ON (p.lane_id, p.at_end) = (l.lane_id, m.along_axis)
        WHERE m.kind <> 'arrow' AND NOT EXISTS (SELECT FROM signal_group g
            WHERE (g.lane_id, g.along_axis) = (l.lane_id, m.along_axis))
        GROUP BY p.road_id, m.along_axis, m.kind) m JOIN drawn d USING (road_id) CROSS JOIN side,
        LATERAL (SELECT cardinality(station) AS stations, ST_LineInterpolatePoint(m.geom, 0.5) AS place) c,
        streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, ST_X(place),
            ST_Y(place)) s),
numbered AS MATERIALIZED (SELECT *, row_number() OVER (ORDER BY road_id, along_axis, first, type) AS id FROM sign),
signal_text AS MATERIALIZED (
    SELECT road_id, '<signals>' || string_agg('<signal s="' || streetgen._decimal(station, 4) || '" t="'
        || streetgen._decimal(aside, 4) || '" id="' || id || '" name="' || name || '" dynamic="' || dynamic
        || '" orientation="' || CASE WHEN along_axis THEN '+' ELSE '-' END || '" zOffset="' || raised
        || '" country="' || country || '" type="' || type || '" subtype="-1"><validity fromLane="' || first
        || '" toLane="' || last || '"/></signal>', '' ORDER BY id) || '</signals>' AS text
    FROM numbered GROUP BY road_id),
controller_line AS (
    SELECT 4 AS turn, controller AS id, '<controller id="' || controller || '" name="' || min(controller_id)
        || '">' || string_agg('<control signalId="' || id || '" type="0"/>', '' ORDER BY id)
        || '<userData code="green" value="' || array_to_string(min(greens), ' ') || '"/></controller>' AS element
    FROM numbered JOIN (SELECT DISTINCT number AS controller, greens FROM signal_group) g USING (controller)
    GROUP BY controller),
junction_controller AS MATERIALIZED (
    SELECT place_id, string_agg('<controller id="' || controller || '" type="0"/>', '' ORDER BY controller)
        || string_agg(DISTINCT '<userData code="program" value="' || p.text || '"/>', '') AS text
    FROM (SELECT DISTINCT place_id, controller, controller_id FROM numbered JOIN joined_node USING (node_id)) n
        JOIN program p USING (controller_id)
    GROUP BY place_id)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_signals(boolean) IS
    'Queries of a file of OpenDRIVE, after streetgen._opendrive_roads(): signal_text, the element signals of each '
    'road, signs of stop and yield lines and, of a model that computes signals, a signal for each lane; '
    'controller_line, the lines of controllers; junction_controller, the controllers and the program of each place.';
