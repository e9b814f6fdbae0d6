-- The one statement, interconnections: pairs of lanes as computed or as decided by hand.

CREATE OR REPLACE FUNCTION streetgen._upsert_interconnections(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._filled($part$
computed_interconnection AS MATERIALIZED (SELECT * FROM streetgen._computed_interconnection((SELECT streets FROM computed))),
decided AS MATERIALIZED (
    SELECT DISTINCT ON (p.lane_in, p.lane_out) p.lane_in, p.lane_out, d.connecting, d.control
    FROM {model}.interconnection_override d
    JOIN new_lane i ON (i.axis_id, i.ordinality) = (d.axis_in, d.lane_in) JOIN new_lane o ON (o.axis_id, o.ordinality) = (d.axis_out, d.lane_out)
    JOIN computed_interconnection p ON (p.lane_in, p.lane_out) = (i.lane, o.lane) JOIN new_node n USING (node)
    WHERE ST_DWithin(d.geom, n.geom, (SELECT 3 * (v ->> 'tolerance')::float8 FROM setting))
    ORDER BY p.lane_in, p.lane_out, d.interconnection_override_id DESC),
-- Paths of the core, or of a function of the user.
rule AS (SELECT v ->> 'trajectory' AS name, v ->> 'trajectory' IN ('bezier', 'arcs') AS drawn, (v ->> 'trajectory_tolerance')::float8 AS tolerance FROM setting)$part$, places),
    streetgen._upsert_rows(places, 'interconnection', id => 'interconnection_id', same => 'lane_in, lane_out',
        columns => 'node_id, turn, angle, plausible, reason, connecting, control, geom, method', rows => $part$
        SELECT n.node_id, i.lane_id AS lane_in, o.lane_id AS lane_out, p.turn, p.angle, p.plausible, p.reason, coalesce(d.connecting, p.plausible) AS connecting,
               CASE WHEN d.control IS NOT NULL THEN d.control WHEN (SELECT drawn FROM rule) THEN p.control END AS control,
               CASE WHEN d.control IS NULL AND (SELECT drawn FROM rule) THEN p.geom
                    ELSE streetgen._trajectory((SELECT name FROM rule), i.geom, i.along_axis, o.geom, o.along_axis, n.geom, d.control, (SELECT tolerance FROM rule)) END AS geom,
               CASE WHEN d.lane_in IS NULL THEN 'hypothesis' ELSE 'by_hand' END AS method
        FROM computed_interconnection p JOIN new_node n USING (node) JOIN new_lane i ON i.lane = p.lane_in JOIN new_lane o ON o.lane = p.lane_out
        LEFT JOIN decided d ON (d.lane_in, d.lane_out) = (p.lane_in, p.lane_out)$part$,
        there => 'SELECT interconnection_id FROM left_interconnection'),
    streetgen._filled($part$
-- One of which a lane lies on an axis that is not asked belongs to the run for that axis.
left_interconnection AS MATERIALIZED (
    SELECT interconnection_id FROM (
        SELECT k.interconnection_id, k.lane_in, k.lane_out
        FROM (SELECT node_id FROM new_node WHERE asked UNION ALL SELECT node_id FROM left_node) n,
            LATERAL (SELECT * FROM {model}.interconnection k WHERE k.node_id = n.node_id {by_key}) k
        EXCEPT SELECT interconnection_id, lane_in, lane_out FROM new_interconnection) k
    WHERE {whole} OR NOT EXISTS (
        SELECT FROM {model}.lane l JOIN {model}.edge e USING (edge_id)
        WHERE l.lane_id IN (k.lane_in, k.lane_out) AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis)))$part$, places)) $$;
COMMENT ON FUNCTION streetgen._upsert_interconnections(jsonb) IS 'Part of the one statement: the interconnections of new_lane, with what interconnection_override decides.';
