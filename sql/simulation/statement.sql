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
