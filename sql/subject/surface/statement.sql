-- The query of an edit view, by name: streetgen._part gives it.

--{corner_editing
SELECT c.corner_id, c.node_id, c.radius,
    EXISTS (SELECT FROM {model}.corner_override o WHERE (o.axis_a, o.axis_b) = (a.axis_id, b.axis_id)
        AND ST_DWithin(o.geom, n.geom, 3 * (SELECT value::float8 FROM {model}.setting WHERE name = 'tolerance'))
        AND (streetgen._on_side(o.geom, n.geom, of_a, of_b) OR NOT EXISTS (SELECT FROM {model}.corner t
            JOIN {model}.edge u ON u.edge_id = t.edge_a JOIN {model}.edge v ON v.edge_id = t.edge_b
            WHERE t.node_id = c.node_id AND t.corner_id <> c.corner_id
                AND (u.axis_id, v.axis_id) = (a.axis_id, b.axis_id)))) AS by_hand, c.geom
FROM (SELECT *, centre AS geom FROM {model}.corner WHERE centre IS NOT NULL
    UNION ALL SELECT k.*, CASE l.which WHEN 'start' THEN ST_StartPoint(l.border_line)
        ELSE ST_EndPoint(l.border_line) END::geometry(Point, {srid})
    FROM {model}.corner k JOIN {model}.section_limit l ON (l.edge_id, l.which) = (k.edge_a, k.end_a)
    WHERE k.centre IS NULL) c
    JOIN {model}.node n USING (node_id) JOIN {model}.edge a ON a.edge_id = c.edge_a
    JOIN {model}.edge b ON b.edge_id = c.edge_b
    CROSS JOIN LATERAL (SELECT streetgen._direction_from(a.geom, c.end_a) AS of_a,
        streetgen._direction_from(b.geom, c.end_b) AS of_b) d
