-- Parts of the view of links, by name: streetgen._part gives each.

--{link
CREATE OR REPLACE VIEW link WITH (security_invoker = true) AS
SELECT 4 * l.lane_id + v.along::integer AS link_id, 'lane' AS kind, l.lane_id, v.along AS along_axis,
    NULL::bigint AS interconnection_id, NULL::bigint AS junction_movement_id, NULL::bigint AS lane_in,
    NULL::boolean AS along_in, NULL::bigint AS lane_out, NULL::boolean AS along_out, NULL::bigint AS comes_from,
    NULL::bigint AS leads_to, ST_Length(l.geom) AS length, l.width, e.speed, a.kind AS class,
    CASE WHEN l.kind NOT IN ('general', 'merging') THEN l.kind END AS traffic,
    CASE WHEN v.along THEN e.from_node ELSE e.to_node END AS from_node, n.to_node,
    {junction_ahead} AS junction_id, CASE WHEN v.along THEN l.geom ELSE ST_Reverse(l.geom) END AS geom
FROM lane l JOIN (VALUES (true), (false)) v(along) ON l.both_ways OR l.along_axis = v.along
    JOIN edge e USING (edge_id) JOIN axis a USING (axis_id)
    CROSS JOIN LATERAL (SELECT CASE WHEN v.along THEN e.to_node ELSE e.from_node END AS to_node) n
WHERE l.kind NOT IN ('parking', 'closed') AND NOT {inside}
UNION ALL
SELECT CASE WHEN m.junction_movement_id IS NULL THEN 4 * m.interconnection_id + 2
        ELSE 4 * m.junction_movement_id + 3 END, 'movement', NULL::bigint, NULL::boolean, m.interconnection_id,
    m.junction_movement_id, m.lane_in, m.along_in, m.lane_out, m.along_out, 4 * m.lane_in + m.along_in::integer,
    4 * m.lane_out + m.along_out::integer, ST_Length(m.geom), o.width, least(f.speed, t.speed), a.kind, m.traffic,
    CASE WHEN m.along_in THEN f.to_node ELSE f.from_node END, CASE WHEN m.along_out THEN t.from_node ELSE t.to_node END,
    m.junction_id, m.geom
FROM ({movement}) m JOIN lane i ON i.lane_id = m.lane_in JOIN edge f ON f.edge_id = i.edge_id
    JOIN lane o ON o.lane_id = m.lane_out JOIN edge t ON t.edge_id = o.edge_id JOIN axis a ON a.axis_id = t.axis_id

--{link_inside
EXISTS (SELECT FROM junction_edge j WHERE j.edge_id = l.edge_id)

--{link_junction_ahead
(SELECT j.junction_id FROM junction_node j WHERE j.node_id = n.to_node)

--{link_of_movement
SELECT CASE WHEN junction_movement_id IS NULL THEN interconnections[1] END AS interconnection_id, junction_movement_id,
    lane_in, lane_out, along_in, along_out, traffic, junction_id, geom
FROM movement WHERE connecting

--{link_of_interconnection
SELECT interconnection_id, NULL::bigint AS junction_movement_id, lane_in, lane_out, along_in, along_out, traffic,
    NULL::bigint AS junction_id, geom
FROM interconnection WHERE connecting

--{car_place
CREATE OR REPLACE VIEW car_place WITH (security_invoker = true) AS
SELECT c.car_id, k.link_id, p.metres, ST_LineInterpolatePoint(k.geom, least(1, p.metres / nullif(k.length, 0))) AS geom
FROM car c CROSS JOIN LATERAL (
    -- Where a lane begins or ends within its edge, two may have one number.
    SELECT l.lane_id, l.geom, e.geom AS axis, x.start_abscissa - e.start_abscissa AS first,
        x.end_abscissa - e.start_abscissa AS last, c.abscissa - e.start_abscissa AS at, x.widest
    FROM edge e JOIN lane l USING (edge_id) JOIN lane_extent x USING (lane_id)
    WHERE e.axis_id = c.axis_id AND c.abscissa BETWEEN e.start_abscissa - 1e-6 AND e.end_abscissa + 1e-6
        AND l.lane_position = c.lane_position AND (l.both_ways OR l.along_axis = c.along_axis)
    ORDER BY c.abscissa BETWEEN x.start_abscissa AND x.end_abscissa DESC, e.start_abscissa DESC LIMIT 1) i
LEFT JOIN LATERAL (
    SELECT l.lane_id FROM edge e JOIN lane l USING (edge_id) JOIN link m ON m.lane_out = l.lane_id
    WHERE e.axis_id = c.onto_axis AND l.lane_position = c.onto_position AND m.lane_in = i.lane_id
        AND m.along_in = c.along_axis AND m.along_out = c.onto_along LIMIT 1) o ON c.onto_axis IS NOT NULL
JOIN LATERAL (
    SELECT * FROM link k WHERE c.onto_axis IS NULL AND k.lane_id = i.lane_id AND k.along_axis = c.along_axis
    UNION ALL SELECT * FROM link k WHERE c.onto_axis IS NOT NULL AND k.lane_in = i.lane_id AND k.lane_out = o.lane_id
        AND k.along_in = c.along_axis AND k.along_out = c.onto_along) k ON true
CROSS JOIN LATERAL (
    SELECT CASE WHEN c.onto_axis IS NOT NULL THEN least(c.beyond, k.length) WHEN c.along_axis THEN on_lane
        ELSE k.length - on_lane END AS metres
    FROM (SELECT streetgen._measure_at(m.on_axis, m.on_lane, i.at) AS on_lane FROM streetgen._lane_measures(
            ST_Force2D(i.axis)::bytea, i.geom::bytea, i.widest, i.first, i.last) m) a) p

--{car_editing
-- Whose lane is gone is shown on its axis, and can be dragged from there.
SELECT c.car_id, c.axis_id, c.abscissa, c.lane_position, c.along_axis, c.speed, c.length, c.width, c.kind, c.route,
    coalesce(p.geom, ST_LineInterpolatePoint(ST_Force2D(a.geom), least(1, c.abscissa / nullif(ST_Length2D(a.geom),
        0)))) AS geom
FROM {model}.car c LEFT JOIN {model}.car_place p USING (car_id) LEFT JOIN {model}.axis a ON a.axis_id = c.axis_id

--{route_way
WITH open AS MATERIALIZED (
    SELECT k.link_id, k.kind, k.lane_id, k.along_axis, k.comes_from, k.leads_to, 3.6 * k.length / k.speed AS seconds
    FROM link k WHERE k.traffic IS NULL OR {kind} = ANY (string_to_array(k.traffic, '|')) OR k.link_id = {from_link})
SELECT row_number() OVER (ORDER BY source, target) AS id, source, target, cost
FROM (SELECT m.comes_from AS source, m.link_id AS target, l.seconds AS cost
    FROM open m JOIN open l ON l.link_id = m.comes_from
    UNION ALL SELECT m.link_id, m.leads_to, m.seconds FROM open m JOIN open o ON o.link_id = m.leads_to
    UNION ALL SELECT a.link_id, b.link_id, 5::float8 FROM lane_adjacency j JOIN open a ON a.lane_id = j.lane_a
        JOIN open b ON (b.lane_id, b.along_axis) = (j.lane_b, a.along_axis)
    WHERE j.change = 'allowed' AND j.end_abscissa > j.start_abscissa) w

--{event_place
CREATE OR REPLACE VIEW event_place WITH (security_invoker = true) AS
SELECT DISTINCT ON (v.traffic_event_id) v.traffic_event_id, k.link_id, p.metres,
    ST_LineInterpolatePoint(k.geom, least(1, p.metres / nullif(k.length, 0))) AS geom
FROM traffic_event v JOIN edge e ON e.axis_id = v.axis_id AND v.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
    JOIN lane l USING (edge_id) JOIN lane_extent x USING (lane_id)
    JOIN link k ON k.lane_id = l.lane_id AND k.along_axis = v.along_axis
    CROSS JOIN LATERAL streetgen._lane_measures(ST_Force2D(e.geom)::bytea, l.geom::bytea, x.widest,
        x.start_abscissa - e.start_abscissa, x.end_abscissa - e.start_abscissa) m
    CROSS JOIN LATERAL (SELECT streetgen._measure_at(m.on_axis, m.on_lane, v.abscissa - e.start_abscissa) AS at) a
    CROSS JOIN LATERAL (SELECT CASE WHEN v.along_axis THEN a.at ELSE k.length - a.at END AS metres) p
WHERE l.lane_position = v.lane_position AND v.abscissa BETWEEN x.start_abscissa AND x.end_abscissa
ORDER BY v.traffic_event_id, e.start_abscissa DESC
