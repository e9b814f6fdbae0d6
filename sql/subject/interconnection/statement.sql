-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{interconnection
rule AS MATERIALIZED (
    SELECT v ->> 'trajectory' AS name, v ->> 'trajectory' IN ('bezier', 'arcs') AS of_core,
        (v ->> 'trajectory_tolerance')::float8 AS tolerance,
           3 * (v ->> 'tolerance')::float8 AS near FROM setting),
decided AS MATERIALIZED (
    SELECT DISTINCT ON (i.lane_id, o.lane_id, v.along, w.along) i.lane_id AS lane_in, o.lane_id AS lane_out,
        v.along AS along_in, w.along AS along_out,
           d.connecting, d.control
    FROM new_node n JOIN {model}.interconnection_override d ON ST_DWithin(d.geom, n.geom, (SELECT near FROM rule))
    JOIN new_lane i ON (i.axis_id, i.ordinality) = (d.axis_in, d.lane_in) JOIN new_edge e ON e.edge_id = i.edge_id
    JOIN LATERAL (VALUES (true, e.to_node), (false, e.from_node)) v(along, enters)
        ON enters = n.node_id AND (i.both_ways OR i.along_axis = v.along) AND (d.along_in = v.along) IS NOT FALSE
    JOIN new_lane o ON (o.axis_id, o.ordinality) = (d.axis_out, d.lane_out)
    JOIN (VALUES (true), (false)) w(along) ON (o.both_ways OR o.along_axis = w.along)
        AND (d.along_out = w.along) IS NOT FALSE
    ORDER BY i.lane_id, o.lane_id, v.along, w.along, d.interconnection_override_id DESC),
-- Pairs that are not all as computed: those decided by hand, or every one where a function of the user draws.
drawn AS MATERIALIZED (
    SELECT p.lane_in, p.lane_out, p.along_in, p.along_out, d.connecting, d.control, d.lane_in IS NOT NULL AS by_hand,
           CASE WHEN r.of_core AND d.control IS NULL THEN p.geom
                ELSE streetgen._trajectory('{model_name}', r.name, i.geom, p.along_in, o.geom, p.along_out, n.geom,
                    d.control, r.tolerance) END AS geom
    FROM rule r, streetgen._computed_interconnection((SELECT streets FROM computed), (SELECT ids FROM node_ids),
        (SELECT ids FROM lane_ids)) p
    JOIN new_node n USING (node_id) JOIN new_lane i ON i.lane_id = p.lane_in JOIN new_lane o ON o.lane_id = p.lane_out
    LEFT JOIN decided d USING (lane_in, lane_out, along_in, along_out)
    WHERE ((SELECT NOT of_core FROM rule) OR EXISTS (SELECT FROM decided))
        AND (NOT r.of_core OR d.lane_in IS NOT NULL))

--{interconnection_rows
SELECT number, node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, traffic,
    coalesce(d.connecting, plausible) AS connecting,
       CASE WHEN d.control IS NOT NULL THEN d.control WHEN (SELECT of_core FROM rule) THEN p.control
           END AS control,
       coalesce(d.geom, p.geom) AS geom, CASE WHEN d.by_hand THEN 'by_hand' ELSE 'hypothesis' END AS method
FROM streetgen._computed_interconnection((SELECT streets FROM computed), (SELECT ids FROM node_ids),
    (SELECT ids FROM lane_ids)) p
    -- LIMIT: taken for few, so that these are hashed and the others keep their order.
    LEFT JOIN (SELECT * FROM drawn LIMIT (SELECT count(*) FROM drawn)) d
        USING (lane_in, lane_out, along_in, along_out)

--{left_interconnection
-- A path with a lane on an axis that is not written belongs to the run for that axis.
left_interconnection AS MATERIALIZED (
    SELECT interconnection_id FROM (
        SELECT k.interconnection_id, k.lane_in, k.lane_out
        FROM (SELECT node_id FROM new_node WHERE affected AND NOT fresh UNION ALL SELECT node_id FROM left_node) n,
            LATERAL (SELECT * FROM {model}.interconnection k WHERE k.node_id = n.node_id {by_key}) k
        WHERE k.interconnection_id NOT IN (SELECT interconnection_id FROM new_interconnection
            WHERE NOT fresh) OFFSET 0) k
    WHERE {whole}
        OR (SELECT axis_id FROM {model}.edge WHERE edge_id = (SELECT edge_id FROM {model}.lane
            WHERE lane_id = k.lane_in))
                IN (SELECT axis_id FROM written_axis)
            AND (SELECT axis_id FROM {model}.edge WHERE edge_id = (SELECT edge_id FROM {model}.lane
                WHERE lane_id = k.lane_out))
                IN (SELECT axis_id FROM written_axis))

--{conflict
CREATE OR REPLACE VIEW conflict WITH (security_invoker = true) AS
SELECT a.node_id, a.interconnection_id AS interconnection_a, b.interconnection_id AS interconnection_b, kind,
    CASE WHEN kind = 'merging' OR meets_in_out THEN ST_EndPoint(a.geom)
        WHEN kind = 'opposing' THEN ST_StartPoint(a.geom) ELSE ST_Intersection(a.geom, b.geom) END AS geom,
    a.junction_id, a.junction_movement_id AS junction_movement_a, b.junction_movement_id AS junction_movement_b
-- The others of its node, or of its junction, are looked up for each path: one path asks for no more than these.
FROM ({path}) a CROSS JOIN LATERAL (
    SELECT * FROM ({path}) p WHERE p.node_id = a.node_id
    UNION ALL SELECT * FROM ({path}) p WHERE a.node_id IS NULL AND p.node_id IS NULL AND p.junction_id = a.junction_id
    OFFSET 0) b
-- A lane for both directions is entered and left at one end: the other way there.
CROSS JOIN LATERAL (SELECT (a.lane_out, a.along_out) = (b.lane_in, NOT b.along_in) AS meets_in_out,
    (a.lane_in, NOT a.along_in) = (b.lane_out, b.along_out) AS meets_in_in,
    (a.lane_out, a.along_out) = (b.lane_out, b.along_out) AS merges) m
CROSS JOIN LATERAL (
    SELECT CASE WHEN merges THEN 'merging' WHEN meets_in_out OR meets_in_in THEN 'opposing' ELSE 'crossing'
        END AS kind) k
WHERE a.number < b.number AND (a.lane_in, a.along_in) <> (b.lane_in, b.along_in)
    AND (merges OR meets_in_out OR meets_in_in OR ST_Intersects(a.geom, b.geom))

--{path_of_movement
SELECT node_id, junction_id, CASE WHEN junction_movement_id IS NULL THEN interconnections[1] END AS interconnection_id,
    junction_movement_id, coalesce(junction_movement_id, interconnections[1]) AS number,
    lane_in, lane_out, along_in, along_out, geom
FROM movement WHERE connecting

--{path_of_interconnection
SELECT node_id, NULL::bigint AS junction_id, interconnection_id, NULL::bigint AS junction_movement_id,
    interconnection_id AS number, lane_in, lane_out, along_in, along_out, geom
FROM interconnection WHERE connecting
