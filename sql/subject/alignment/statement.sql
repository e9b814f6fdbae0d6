-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{ramp_end
-- A highway goes on past a ramp: there the link ends at a node of its own, minus that of the ramp.
ramp_end AS MATERIALIZED (
    SELECT edge_id, node_id FROM new_ramp
    UNION ALL SELECT edge_id, node_id FROM {model}.ramp WHERE NOT {whole}
        AND node_id NOT IN (SELECT node_id FROM new_node)),

--{road_part
{ramp_end}
-- Edges that meet what is written: whether a road goes on there may have changed.
meeting_edge AS MATERIALIZED (
    SELECT e.edge_id FROM (SELECT node_id FROM new_node UNION SELECT node_id FROM left_node) n, LATERAL (
        SELECT edge_id FROM {model}.edge WHERE from_node = n.node_id
        UNION ALL SELECT edge_id FROM {model}.edge WHERE to_node = n.node_id OFFSET 0) e WHERE NOT {whole}),
touched_road AS MATERIALIZED (
    SELECT DISTINCT r.road_id
    FROM (SELECT edge_id FROM old_edge WHERE written UNION SELECT edge_id FROM meeting_edge) e,
        LATERAL (SELECT road_id FROM {model}.road_edge o WHERE o.edge_id = e.edge_id OFFSET 0) r WHERE NOT {whole}),
-- Other edges, which are not looked at, may meet where roads end away from what is written.
far_end AS MATERIALIZED (
    SELECT unnest(ARRAY[r.from_node, r.to_node]) AS node_id FROM touched_road t,
        LATERAL (SELECT * FROM {model}.road o WHERE o.road_id = t.road_id OFFSET 0) r WHERE NOT r.closed
    EXCEPT SELECT node_id FROM new_node {passed_ramps}),
road_part AS MATERIALIZED (
    SELECT edge_id, axis_id, {from_node} AS from_node, {to_node} AS to_node, level, start_abscissa, end_abscissa,
        coalesce(curve, geom)::bytea AS line
    FROM new_edge e
    UNION ALL SELECT e.edge_id, e.axis_id, {from_node}, {to_node}, e.level, e.start_abscissa, e.end_abscissa,
        coalesce(e.curve, e.geom)::bytea
    FROM (SELECT m.edge_id FROM touched_road t,
            LATERAL (SELECT edge_id FROM {model}.road_edge o WHERE o.road_id = t.road_id OFFSET 0) m
        UNION SELECT edge_id FROM meeting_edge) k,
        LATERAL (SELECT * FROM {model}.edge o WHERE o.edge_id = k.edge_id OFFSET 0) e
    WHERE NOT {whole} AND e.axis_id NOT IN (SELECT axis_id FROM written_axis)),
found_road AS MATERIALIZED (
    SELECT * FROM streetgen._roads(
        (SELECT array_agg(ROW (edge_id, axis_id, from_node, to_node, level, start_abscissa, end_abscissa,
            line)::streetgen.road_part) FROM road_part),
        ARRAY(SELECT node_id FROM far_end), (SELECT (v ->> 'smoothing_shift')::float8 FROM setting),
        (SELECT array_agg(ROW (axis_id, abscissa, radius)::streetgen.street_bend ORDER BY road_override_id)
            FROM {model}.road_override WHERE {whole} OR axis_id IN (SELECT axis_id FROM road_part)))),
found_member AS MATERIALIZED (
    SELECT number, abs(edge) AS edge_id, position, edge > 0 AS along_road, start_abscissa
    FROM found_road, unnest(edges, start_abscissas) WITH ORDINALITY m(edge, start_abscissa, position))

--{road_rows
SELECT coalesce(road_id, {next_id}) AS road_id, number, abs(from_node) AS from_node, abs(to_node) AS to_node,
    closed, length,
    geom::geometry AS geom
FROM (SELECT f.*, heir.road_id FROM found_road f LEFT JOIN (
    -- Identity of roads: by their first edges.
    SELECT n.number, min(o.road_id) AS road_id FROM found_member n, LATERAL (
        SELECT road_id FROM {model}.road_edge o
        WHERE NOT {empty} AND o.edge_id = n.edge_id AND o.position = 1 {by_key}) o
    GROUP BY n.number) heir USING (number) ORDER BY f.number OFFSET 0) r

--{road_arc
-- No road has a million arcs.
CREATE OR REPLACE VIEW road_arc WITH (security_invoker = true) AS
SELECT r.road_id * 1000000 + b.ordinality AS road_arc_id, r.road_id, b.start_abscissa, b.end_abscissa, b.radius,
    streetgen.arc_road_speed_limit(b.radius, (SELECT value::float8 FROM setting WHERE name = 'road_friction'))
        AS speed_limit,
    b.centre::geometry(Point, {srid}) AS centre, b.corner::geometry(Point, {srid}) AS corner,
    b.arc::geometry(CircularString, {srid}) AS arc
FROM road r, LATERAL streetgen._arc_road_bends(r.geom) WITH ORDINALITY b

--{road_arc_editing
-- A bend at a node is of no axis. One that is sharp by hand has no arc: its handle is its vertex.
SELECT streetgen._bend_key(b.axis_id, b.vertex) AS road_arc_id, b.axis_id, b.abscissa, a.radius,
    EXISTS (SELECT FROM {model}.road_override o WHERE o.axis_id = b.axis_id
    AND abs((streetgen._bend_at(b.axis, o.abscissa)).abscissa - b.abscissa) < 1e-6) AS by_hand, a.centre AS geom
FROM {model}.road_arc a, LATERAL (
    SELECT e.axis_id, x.geom AS axis, v.abscissa, v.vertex
    FROM {model}.road_edge m JOIN {model}.edge e USING (edge_id) JOIN {model}.axis x USING (axis_id),
        LATERAL streetgen._bend_of(x.geom, a.corner, e.start_abscissa, e.end_abscissa) v
    WHERE m.road_id = a.road_id AND ST_DWithin(x.geom, a.corner, 1) AND ST_DWithin(v.vertex, a.corner, 0.001)
    ORDER BY ST_Distance(v.vertex, a.corner), e.axis_id LIMIT 1) b
UNION ALL SELECT streetgen._bend_key(axis_id, place), axis_id, abscissa, 0, true, place::geometry(Point, {srid})
FROM streetgen._sharp_bends({name})
