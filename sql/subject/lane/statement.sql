-- Views of lanes that depend on subjects, by name: streetgen._part gives each.

--{lane_adjacency
CREATE OR REPLACE VIEW lane_adjacency WITH (security_invoker = true) AS
SELECT 2 * s.lane_separator_id + (v.side = 'right')::integer AS lane_adjacency_id, a.lane_id AS lane_a,
    b.lane_id AS lane_b, v.side, p.start_abscissa, p.end_abscissa,
    CASE WHEN s.kind = 'centre' THEN 'opposite'
        WHEN CASE v.side WHEN 'left' THEN s.leftwards ELSE s.rightwards END THEN 'allowed'
        ELSE 'forbidden' END AS change,
    s.kind <> 'centre' AND EXISTS (SELECT FROM lane_adjacency_override o
        WHERE o.axis_id = x.axis_id AND o.abscissa >= x.from_abscissa AND o.abscissa < x.to_abscissa
            AND (o.lane_from, o.lane_to) = (a.ordinality, b.ordinality)) AS by_hand, s.geom
FROM lane a JOIN lane_separator s USING (edge_id) CROSS JOIN (VALUES ('left'), ('right')) v(side)
    CROSS JOIN LATERAL ({beside}) l
    JOIN lane b ON b.edge_id = a.edge_id
        AND b.lane_position = CASE v.side WHEN 'left' THEN l.on_left ELSE l.on_right END
    -- The extent of each lane is looked up by its key, however many the planner expects.
    CROSS JOIN LATERAL (SELECT x.axis_id, x.start_abscissa, x.end_abscissa, e.start_abscissa AS from_abscissa,
            e.end_abscissa AS to_abscissa
        FROM lane_extent x JOIN edge e USING (edge_id) WHERE x.lane_id = a.lane_id OFFSET 0) x
    -- As far as both go: a merging lane is beside the others on a part of the edge.
    CROSS JOIN LATERAL (SELECT greatest(x.start_abscissa, b.start_abscissa) AS start_abscissa,
        least(x.end_abscissa, b.end_abscissa) AS end_abscissa) p
WHERE a.lane_position = CASE v.side WHEN 'left' THEN l.on_right ELSE l.on_left END

--{lanes_beside
SELECT s.lane_position AS on_left, s.lane_position + 1 AS on_right

--{lanes_beside_merging
-- The outer one of two merging lanes on different parts of an edge lies beside the lanes that go all along.
SELECT CASE WHEN apart AND at_left.side = 'right' THEN (SELECT max(w.lane_position) FROM lane w
        WHERE w.edge_id = s.edge_id AND w.kind <> 'merging') ELSE s.lane_position END AS on_left,
    CASE WHEN apart AND at_left.side = 'left' THEN (SELECT min(w.lane_position) FROM lane w
        WHERE w.edge_id = s.edge_id AND w.kind <> 'merging') ELSE s.lane_position + 1 END AS on_right
FROM lane at_left JOIN lane at_right USING (edge_id), LATERAL (
    SELECT at_left.kind = 'merging' AND at_right.kind = 'merging' AND (at_left.start_abscissa, at_left.end_abscissa)
        IS DISTINCT FROM (at_right.start_abscissa, at_right.end_abscissa) AS apart) m
WHERE (at_left.edge_id, at_left.lane_position, at_right.lane_position)
    = (s.edge_id, s.lane_position, s.lane_position + 1)

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

--{crossings_of_controls
-- As wide and as square as crossings of which nothing is said.
SELECT p.edge_id, g.ground
FROM (SELECT e.edge_id, e.geom, e.width, e.width_end, e.roadway_offset, p.abscissa - e.start_abscissa AS abscissa
    FROM control_point p JOIN edge e ON e.axis_id = p.axis_id AND p.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
    WHERE p.kind = 'pedestrian_crossing' AND {chosen} {unknown} OFFSET 0) p,
    streetgen._usual_crossing() usual,
    LATERAL (SELECT streetgen._crossing_ground(ST_Force2D(p.geom)::bytea, streetgen._even_borders(p.width, p.width_end,
        ST_Length2D(p.geom), p.roadway_offset), p.abscissa, usual.width, usual.angle)::geometry AS ground OFFSET 0) g
WHERE g.ground IS NOT NULL

--{without_object
-- Whoever placed a crossing there knows better.
AND NOT EXISTS (SELECT FROM street_object o WHERE o.control_point_id = p.control_point_id)
AND NOT EXISTS (SELECT FROM street_object o JOIN pedestrian_crossing USING (street_object_id)
    WHERE o.axis_id = p.axis_id AND abs(o.abscissa - p.abscissa) < (streetgen._usual_crossing()).width)

--{crossings_of_objects
SELECT e.edge_id, c.surface AS ground
FROM edge e JOIN section s USING (edge_id)
    -- Lines may lie beyond the section.
    CROSS JOIN LATERAL (SELECT ST_Extent(w.part)::geometry AS box FROM (SELECT s.surface AS part UNION ALL
        SELECT coalesce(m.free_geom, m.geom) FROM marking m WHERE m.edge_id = e.edge_id AND m.kind <> 'arrow') w) reach
    JOIN pedestrian_crossing c ON c.surface && reach.box
    JOIN street_object o USING (street_object_id) JOIN axis a ON a.axis_id = o.axis_id AND a.level = e.level
WHERE {chosen}
UNION ALL {crossings_of_controls}

--{or_accepted
OR EXISTS (SELECT FROM roundabout_edge x JOIN roundabout USING (roundabout_id) WHERE x.edge_id = r.edge_id AND accepted)

--{heads_at_lines
UPDATE signal_head h SET geom = w.geom, angle = w.angle
FROM edge e JOIN lane l USING (edge_id) JOIN marking m USING (edge_id, lane_position),
    LATERAL streetgen._waiting_place(l.geom, m.along_axis, m.geom) w
WHERE {chosen} AND m.kind = 'stop' AND (h.lane_id, h.along_axis) = (l.lane_id,
    m.along_axis) AND (h.geom::bytea, h.angle) IS DISTINCT FROM (w.geom::bytea, w.angle);

--{lay_lines
#variable_conflict use_column
BEGIN
    IF axes IS NULL THEN{lay_all}
    ELSIF EXISTS (SELECT FROM edge e JOIN marking m USING (edge_id)
            WHERE e.axis_id = ANY (axes) AND m.free_geom IS NOT NULL)
        OR EXISTS ({crossings_of_some}) THEN
        -- Planning anew costs an edit more than the plan does.
        PERFORM set_config('plan_cache_mode', 'force_generic_plan', true);{lay_some}
    END IF;
END

--{lay_chosen_lines
    WITH crossing AS MATERIALIZED (
        SELECT edge_id, array_agg(ST_Multi(ground)::bytea) AS grounds FROM ({crossings}) c GROUP BY edge_id),
    lane_way AS MATERIALIZED (
        SELECT m.edge_id, m.lane_position, m.along_axis, array_agg(m.marking_id ORDER BY marking_id) AS markings,
            array_agg(coalesce(m.free_geom, m.geom)::bytea ORDER BY marking_id) AS lines,
            array_agg(m.kind = 'arrow' ORDER BY marking_id) AS arrows,
            -- Who comes to a ring waits at the ring.
            array_agg(m.kind = 'yield' AND EXISTS (SELECT FROM edge r JOIN axis a USING (axis_id)
                WHERE m.node_id IN (r.from_node, r.to_node) AND (streetgen._names_ring(a.roundabout_tag)
                    AND (SELECT value = 'true' FROM setting WHERE name = 'roundabout_tags') {or_accepted}))
                ORDER BY marking_id) AS stays
        FROM edge e JOIN marking m USING (edge_id)
        WHERE {chosen} AND (m.free_geom IS NOT NULL OR m.edge_id IN (SELECT c.edge_id FROM crossing c))
        GROUP BY m.edge_id, m.lane_position, m.along_axis),
    laid AS MATERIALIZED (
        SELECT w.markings[p.number] AS marking_id, p.*
        FROM lane_way w JOIN lane l USING (edge_id, lane_position) JOIN edge e USING (edge_id)
            LEFT JOIN crossing c USING (edge_id),
            LATERAL (SELECT count(*) > 2 AS between_junctions FROM (
                SELECT FROM edge WHERE from_node = CASE WHEN w.along_axis THEN e.from_node ELSE e.to_node END
                UNION ALL SELECT FROM edge WHERE to_node = CASE WHEN w.along_axis THEN e.from_node ELSE e.to_node
                    END) a) j,
            LATERAL streetgen._lay_paint(CASE WHEN w.along_axis THEN l.geom ELSE ST_Reverse(l.geom) END::bytea,
                l.width, between_junctions, coalesce(c.grounds, ARRAY[]::bytea[]), w.lines, w.arrows, w.stays,
                (SELECT value::float8 FROM setting WHERE name = 'line_before_crossing'),
                (SELECT value::float8 FROM setting WHERE name = 'crossing_of_arm')) p
        WHERE l.method <> 'crossed_limits'),
    new AS MATERIALIZED (
        SELECT marking_id, CASE WHEN moves THEN ST_Affine(m.line, cosine, -sine, sine, cosine, x, y) ELSE m.line
                END AS geom,
            CASE WHEN NOT has_room THEN ST_SetSRID('MULTIPOLYGON EMPTY'::geometry, ST_SRID(m.line))
                WHEN moves THEN ST_Affine(m.paint, cosine, -sine, sine, cosine, x, y) ELSE m.paint END AS surface,
            CASE WHEN moves THEN m.line END AS free_geom, CASE WHEN moves THEN m.paint END AS free_surface
        FROM laid JOIN (SELECT marking_id, coalesce(free_geom, geom) AS line, coalesce(free_surface, surface) AS paint
            FROM marking) m USING (marking_id))
    UPDATE marking m SET geom = n.geom, surface = n.surface, free_geom = n.free_geom, free_surface = n.free_surface
    FROM new n WHERE n.marking_id = m.marking_id
        AND (m.geom::bytea, m.surface::bytea, m.free_geom::bytea, m.free_surface::bytea)
            IS DISTINCT FROM (n.geom::bytea, n.surface::bytea, n.free_geom::bytea, n.free_surface::bytea);
    {heads}

--{free_markings
SELECT number, edge_id, kind, lane_position, along_axis, node_id, geom, surface, NULL::geometry AS free_geom,
    NULL::geometry AS free_surface
FROM streetgen._computed_marking((SELECT streets FROM computed), (SELECT ids FROM node_ids),
    (SELECT ids FROM edge_ids))

--{laid_markings
-- The core knows no crossing: what one moved stays until lines are laid anew, where the core would put it as before.
SELECT f.number, f.edge_id, f.kind, f.lane_position, f.along_axis, f.node_id,
    CASE WHEN l.stays THEN l.geom ELSE f.geom END AS geom,
    CASE WHEN l.stays THEN l.surface ELSE f.surface END AS surface,
    CASE WHEN l.stays THEN l.free_geom END AS free_geom, CASE WHEN l.stays THEN l.free_surface END AS free_surface
FROM streetgen._computed_marking((SELECT streets FROM computed), (SELECT ids FROM node_ids),
        (SELECT ids FROM edge_ids)) f
    LEFT JOIN LATERAL (
        SELECT m.geom, m.surface, m.free_geom, m.free_surface,
            (m.free_geom::bytea, m.free_surface::bytea) = (f.geom::bytea, f.surface::bytea) AS stays
        FROM {model}.marking m WHERE m.free_geom IS NOT NULL AND (m.edge_id, m.kind, m.lane_position, m.along_axis)
            = (f.edge_id, f.kind, f.lane_position, f.along_axis) {by_key}) l ON true
