-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{ramp_axis
(
SELECT array_agg(ROW (u.axis_id, part, NOT 'lane_count' = ANY (u.estimated))::streetgen.street_ramp_axis
    ORDER BY u.axis_id)
FROM used u, LATERAL (SELECT streetgen._ramp_part(a.kind, c.highway_role, u.speed) AS part
    FROM {model}.axis a LEFT JOIN {model}.axis_class c ON c.class = a.kind
    WHERE a.axis_id = u.axis_id {by_key}) a WHERE part IS NOT NULL)

--{ramp
-- An edge of an axis that is not written is as it is there.
ramp_edge AS MATERIALIZED (
    SELECT number, edge_id FROM new_edge
    UNION ALL SELECT c.number, e.edge_id
    FROM computed_edge c, LATERAL (SELECT edge_id FROM {model}.edge e
        WHERE (e.axis_id, e.start_abscissa, e.end_abscissa) = (c.axis_id, c.start_abscissa, c.end_abscissa) {by_key}) e
    WHERE NOT {whole} AND c.number NOT IN (SELECT number FROM written_edge)),
ramp_edge_ids AS MATERIALIZED (SELECT streetgen._ids(number, edge_id) AS ids FROM ramp_edge)

--{ramp_editing
-- The length typed, also where an auxiliary lane goes on beyond it or the next junction cuts it.
SELECT r.ramp_id, e.axis_id, r.kind, r.tangent, coalesce(d.length, r.length) AS length,
    r.method = 'by_hand' AS by_hand, r.geom
FROM {model}.ramp r JOIN {model}.edge e USING (edge_id) LEFT JOIN LATERAL (
    SELECT o.length FROM {model}.ramp_override o WHERE o.axis_id = e.axis_id AND o.length IS NOT NULL
        AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
        AND (2 * o.abscissa <= e.start_abscissa + e.end_abscissa) = (e.from_node = r.node_id)
    ORDER BY o.ramp_override_id DESC LIMIT 1) d ON r.method = 'by_hand'
