-- Views of lanes that depend on subjects, by name: streetgen._part gives each.

--{lane_adjacency
CREATE OR REPLACE VIEW lane_adjacency WITH (security_invoker = true) AS
SELECT 2 * s.lane_separator_id + (v.side = 'right')::integer AS lane_adjacency_id,
    CASE v.side WHEN 'right' THEN l.lane_id ELSE r.lane_id END AS lane_a,
    CASE v.side WHEN 'right' THEN r.lane_id ELSE l.lane_id END AS lane_b, v.side, p.start_abscissa, p.end_abscissa,
    CASE WHEN s.kind = 'centre' THEN 'opposite'
        WHEN CASE v.side WHEN 'left' THEN s.leftwards ELSE s.rightwards END THEN 'allowed'
        ELSE 'forbidden' END AS change,
    s.kind <> 'centre' AND EXISTS (SELECT FROM lane_adjacency_override o
        WHERE o.axis_id = e.axis_id AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
            AND (o.lane_from, o.lane_to) = (CASE v.side WHEN 'right' THEN l.ordinality ELSE r.ordinality END,
                CASE v.side WHEN 'right' THEN r.ordinality ELSE l.ordinality END)) AS by_hand, s.geom
FROM lane_separator s {beside}
    JOIN edge e ON e.edge_id = s.edge_id
    JOIN lane_extent x ON x.lane_id = l.lane_id CROSS JOIN (VALUES ('left'), ('right')) v(side)
    -- As far as both go: a merging lane is beside the others on a part of the edge.
    CROSS JOIN LATERAL (SELECT greatest(x.start_abscissa, r.start_abscissa) AS start_abscissa,
        least(x.end_abscissa, r.end_abscissa) AS end_abscissa) p

--{lanes_beside
JOIN lane l ON (l.edge_id, l.lane_position) = (s.edge_id, s.lane_position)
JOIN lane r ON (r.edge_id, r.lane_position) = (s.edge_id, s.lane_position + 1)

--{lanes_beside_merging
-- The outer one of two merging lanes on different parts of an edge lies beside the lanes that go all along.
JOIN lane on_left ON (on_left.edge_id, on_left.lane_position) = (s.edge_id, s.lane_position)
JOIN lane on_right ON (on_right.edge_id, on_right.lane_position)
    = (s.edge_id, s.lane_position + 1)
CROSS JOIN LATERAL (SELECT on_left.kind = 'merging' AND on_right.kind = 'merging' AND (on_left.start_abscissa,
    on_left.end_abscissa) IS DISTINCT FROM (on_right.start_abscissa, on_right.end_abscissa) AS apart) m
JOIN lane l ON l.lane_id = CASE WHEN apart AND on_left.side = 'right' THEN (SELECT lane_id FROM lane w
    WHERE w.edge_id = s.edge_id AND w.kind <> 'merging' ORDER BY w.lane_position DESC LIMIT 1)
    ELSE on_left.lane_id END
JOIN lane r ON r.lane_id = CASE WHEN apart AND on_left.side = 'left' THEN (SELECT lane_id FROM lane w
    WHERE w.edge_id = s.edge_id AND w.kind <> 'merging' ORDER BY w.lane_position LIMIT 1)
    ELSE on_right.lane_id END

--{marked_before
marked_before => (
    SELECT array_agg(DISTINCT ROW (e.axis_id)::streetgen.street_marked)
    FROM {model}.edge e JOIN {model}.axis a USING (axis_id)
        JOIN {model}.lane l ON l.edge_id = e.edge_id AND l.turn IS NOT NULL AND l.kind <> 'merging'
        CROSS JOIN LATERAL (SELECT CASE WHEN l.along_axis THEN a.turn_forward ELSE a.turn_backward END AS list) own
    -- A list that does not fit the lanes marks none of them, nor does one without a turn.
    WHERE NOT {whole} AND e.axis_id = ANY ($1)
        AND (list IS NULL OR list !~ 'left|right|through|reverse' OR cardinality(string_to_array(list, '|')) <> (
            SELECT count(*) FROM {model}.lane o WHERE o.edge_id = l.edge_id AND o.along_axis = l.along_axis
                AND NOT o.both_ways AND o.kind IN ('general', 'bus', 'carpool'))))
