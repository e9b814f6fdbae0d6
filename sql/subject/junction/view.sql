-- Views of junctions: the collapsed graph, every movement, and who waits for whom.

CREATE OR REPLACE FUNCTION streetgen._make_junction_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW junction_link WITH (security_invoker = true) AS
    SELECT e.edge_id, e.axis_id, coalesce(f.junction_id, e.from_node) AS from_junction,
        coalesce(t.junction_id, e.to_node) AS to_junction, e.lanes_forward + e.lanes_both AS lanes_along,
        e.lanes_backward + e.lanes_both AS lanes_against, e.geom
    FROM edge e LEFT JOIN junction_node f ON f.node_id = e.from_node
        LEFT JOIN junction_node t ON t.node_id = e.to_node
    WHERE NOT EXISTS (SELECT FROM junction_edge j WHERE j.edge_id = e.edge_id);
    COMMENT ON VIEW junction_link IS
        'The network with each junction as one point: the edges that lie in none, each from junction to junction. '
        'Where an edge ends at a node that is no junction, that node stands in its place';
    COMMENT ON COLUMN junction_link.edge_id IS 'the edge';
    COMMENT ON COLUMN junction_link.axis_id IS 'its axis';
    COMMENT ON COLUMN junction_link.from_junction IS 'the junction at its start, or the node that is none';
    COMMENT ON COLUMN junction_link.to_junction IS 'the junction at its end, or the node that is none';
    COMMENT ON COLUMN junction_link.lanes_along IS 'lanes from start to end';
    COMMENT ON COLUMN junction_link.lanes_against IS 'lanes from end to start';
    COMMENT ON COLUMN junction_link.geom IS 'its line';
    CREATE OR REPLACE VIEW rim_marking WITH (security_invoker = true) AS
    SELECT m.* FROM marking m WHERE NOT EXISTS (SELECT FROM junction_edge j WHERE j.edge_id = m.edge_id);
    COMMENT ON VIEW rim_marking IS
        'What is painted on lanes, without the lanes inside junctions: traffic waits at the rim';
    COMMENT ON COLUMN rim_marking.marking_id IS 'its row of marking';
    COMMENT ON COLUMN rim_marking.edge_id IS 'the edge';
    COMMENT ON COLUMN rim_marking.lane_position IS 'the lane, from 1 at the left kerb';
    COMMENT ON COLUMN rim_marking.along_axis IS 'does the traffic that it speaks to run along the axis?';
    COMMENT ON COLUMN rim_marking.node_id IS 'where that traffic goes';
    COMMENT ON COLUMN rim_marking.kind IS 'stop, yield or arrow';
    COMMENT ON COLUMN rim_marking.geom IS 'across the lane, or from the foot of an arrow to its tip';
    COMMENT ON COLUMN rim_marking.surface IS 'the paint';
    COMMENT ON COLUMN rim_marking.free_geom IS 'geom as it would be without crossings; NULL: no crossing moves it';
    COMMENT ON COLUMN rim_marking.free_surface IS
        'surface as it would be without crossings; NULL: no crossing moves it';
    CREATE OR REPLACE VIEW movement WITH (security_invoker = true) AS
    SELECT m.junction_id, NULL::bigint AS node_id, m.lane_in, m.lane_out, m.along_in, m.along_out, m.turn, m.angle,
        m.plausible, m.reason, m.connecting, m.interconnections, m.junction_movement_id, m.geom, m.traffic
    FROM junction_movement m
    UNION ALL SELECT n.junction_id, i.node_id, i.lane_in, i.lane_out, i.along_in, i.along_out, i.turn, i.angle,
        i.plausible, i.reason, i.connecting, ARRAY[i.interconnection_id], NULL::bigint, i.geom, i.traffic
    FROM interconnection i LEFT JOIN junction_node n USING (node_id)
    WHERE NOT EXISTS (SELECT FROM junction_node o WHERE o.junction_id = n.junction_id AND o.node_id <> n.node_id);
    COMMENT ON VIEW movement IS
        'Every way from lane to lane: across junctions of several nodes, and at single nodes. Its two lanes, with the '
        'directions in which they are driven, name a movement';
    COMMENT ON COLUMN movement.junction_id IS 'the junction; NULL: a node that is none';
    COMMENT ON COLUMN movement.node_id IS 'the node; NULL: across a junction of several nodes';
    COMMENT ON COLUMN movement.lane_in IS 'the lane that comes in';
    COMMENT ON COLUMN movement.lane_out IS 'the lane that goes out';
    COMMENT ON COLUMN movement.along_in IS 'does one drive along the axis of lane_in?';
    COMMENT ON COLUMN movement.along_out IS 'does one drive along the axis of lane_out?';
    COMMENT ON COLUMN movement.turn IS 'through, left, right or u_turn';
    COMMENT ON COLUMN movement.angle IS 'from lane to lane, degrees, positive to the left';
    COMMENT ON COLUMN movement.plausible IS 'would traffic take it?';
    COMMENT ON COLUMN movement.reason IS 'why it is plausible or not';
    COMMENT ON COLUMN movement.connecting IS 'does traffic go that way?';
    COMMENT ON COLUMN movement.interconnections IS 'paths at single nodes that lead the same way, in their order';
    COMMENT ON COLUMN movement.junction_movement_id IS
        'its row of junction_movement; NULL: it is one of interconnection';
    COMMENT ON COLUMN movement.geom IS 'the path';
    COMMENT ON COLUMN movement.traffic IS
        'who alone may take it, by kinds of lanes such as bus|cycle; NULL: all';
    CREATE OR REPLACE VIEW junction_crossing WITH (security_invoker = true) AS
    SELECT junction_id, control_point_id, node_id, edge_id, inside, width,
        (SELECT value::float8 FROM setting WHERE name = 'walk_shortest')
            + width / (SELECT value::float8 FROM setting WHERE name = 'walking_speed') AS seconds, geom
    FROM (SELECT j.junction_id, p.control_point_id, j.node_id, e.edge_id, w.inside,
            CASE WHEN e.from_node = j.node_id THEN e.width ELSE e.width_end END AS width, p.geom, row_number() OVER (
                PARTITION BY j.junction_id, p.control_point_id, e.edge_id ORDER BY w.metres, j.node_id) AS turn
        FROM junction_node j JOIN edge e ON j.node_id IN (e.from_node, e.to_node)
            -- Signals in mid-block are there for people who cross, whether their crossing is mapped or not.
            JOIN control_point p ON p.axis_id = e.axis_id AND (p.kind = 'pedestrian_crossing' OR p.kind = 'signals'
                    AND 2 = (SELECT count(*) FROM junction_node o JOIN edge a ON o.node_id IN (a.from_node, a.to_node)
                        WHERE o.junction_id = j.junction_id)
                    AND NOT EXISTS (SELECT FROM control_point o WHERE o.axis_id = p.axis_id
                        AND o.kind = 'pedestrian_crossing' AND abs(o.abscissa - p.abscissa)
                            <= (SELECT value::float8 FROM setting WHERE name = 'crossing_of_arm')))
                AND p.abscissa BETWEEN e.start_abscissa - 0.01 AND e.end_abscissa + 0.01
            CROSS JOIN LATERAL (SELECT EXISTS (SELECT FROM junction_edge i WHERE i.edge_id = e.edge_id) AS inside,
                p.abscissa - e.start_abscissa AS from_start,
                CASE WHEN e.from_node = j.node_id THEN p.abscissa - e.start_abscissa
                    ELSE e.end_abscissa - p.abscissa END AS metres,
                CASE WHEN e.from_node = j.node_id THEN e.to_node ELSE e.from_node END AS other) w
        WHERE w.inside OR EXISTS (
            SELECT FROM section_limit a JOIN section_limit b USING (edge_id), LATERAL (
                SELECT w.from_start - a.abscissa AS behind_start, b.abscissa - w.from_start AS before_end) m,
                LATERAL (SELECT CASE WHEN e.from_node = j.node_id THEN behind_start ELSE before_end END AS near,
                    CASE WHEN e.from_node = j.node_id THEN before_end ELSE behind_start END AS far) l
            WHERE e.edge_id = a.edge_id AND (a.which, b.which) = ('start', 'end')
                AND near <= (SELECT value::float8 FROM setting WHERE name = 'crossing_of_arm')
                    + (SELECT c.width / 2 FROM streetgen._usual_crossing() c)
                -- A crossing between two junctions is the nearer one's: before the other one traffic waits without it.
                AND (near <= far + 0.01 OR far > 0.01 AND 2 >= (SELECT count(*) FROM edge o
                    WHERE o.from_node = w.other OR o.to_node = w.other)))) c
    WHERE turn = 1;
    COMMENT ON VIEW junction_crossing IS
        'The streets of junctions that people on foot cross there: control points of kind pedestrian_crossing on an '
        'edge within, or on an arm up to setting crossing_of_arm before its lanes end and nearer to them than to the '
        'next junction, and signals in mid-block without one';
    COMMENT ON COLUMN junction_crossing.junction_id IS 'the junction';
    COMMENT ON COLUMN junction_crossing.control_point_id IS
        'the control point of kind pedestrian_crossing; of signals in mid-block that have none the signals';
    COMMENT ON COLUMN junction_crossing.node_id IS 'the node of the junction that is nearest to it';
    COMMENT ON COLUMN junction_crossing.edge_id IS
        'the street that is crossed; two rows where the point lies on a node';
    COMMENT ON COLUMN junction_crossing.inside IS 'does the street lie within the junction?';
    COMMENT ON COLUMN junction_crossing.width IS 'of the roadway there, metres';
    COMMENT ON COLUMN junction_crossing.seconds IS
        'to cross: setting walk_shortest to step on, and the width at walking_speed';
    COMMENT ON COLUMN junction_crossing.geom IS 'the place of the control point';
    CREATE OR REPLACE VIEW right_of_way WITH (security_invoker = true) AS
    SELECT m.lane_in, m.lane_out, m.along_in, m.along_out, m.junction_id, m.turn, m.connecting,
        CASE WHEN j.kind IS NULL OR j.kind IN ('continuation', 'end', 'fork') THEN 'free'
            WHEN j.kind IN ('signals', 'right_before_left') THEN j.kind
            WHEN p.kind IS NOT NULL THEN p.kind
            WHEN j.kind = 'ramp' AND a.highway_role IN ('highway_link', 'link') THEN 'yield'
            ELSE 'priority' END AS rule
    FROM movement m LEFT JOIN junction j USING (junction_id) JOIN lane l ON l.lane_id = m.lane_in
        JOIN edge e USING (edge_id) LEFT JOIN (SELECT axis_id, highway_role FROM axis
            JOIN axis_class ON class = kind) a USING (axis_id)
        LEFT JOIN rim_marking p ON (p.edge_id, p.lane_position, p.along_axis) = (l.edge_id, l.lane_position,
            m.along_in) AND p.kind IN ('stop', 'yield');
    COMMENT ON VIEW right_of_way IS
        'What each movement obeys: signals, stop, yield, right_before_left, priority (others wait for it) or free '
        '(nothing to wait for)';
    COMMENT ON COLUMN right_of_way.lane_in IS 'the lane that comes in';
    COMMENT ON COLUMN right_of_way.lane_out IS 'the lane that goes out';
    COMMENT ON COLUMN right_of_way.along_in IS 'does one drive along the axis of lane_in?';
    COMMENT ON COLUMN right_of_way.along_out IS 'does one drive along the axis of lane_out?';
    COMMENT ON COLUMN right_of_way.junction_id IS 'the junction';
    COMMENT ON COLUMN right_of_way.turn IS 'through, left, right or u_turn';
    COMMENT ON COLUMN right_of_way.connecting IS 'does traffic go that way?';
    COMMENT ON COLUMN right_of_way.rule IS 'signals, stop, yield, right_before_left, priority or free';
    PERFORM streetgen._make_conflict_view(model);
END $$;
COMMENT ON FUNCTION streetgen._make_junction_views(name) IS
    'Makes the views of a model that computes junctions, again and again.';

CREATE OR REPLACE FUNCTION streetgen._junction_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES ('right_of_way'::name, 'junction'), ('movement', 'junction'), ('rim_marking', 'junction'),
        ('junction_link', 'junction'), ('junction_crossing', 'junction') $$;
COMMENT ON FUNCTION streetgen._junction_view() IS
    'Views of junctions, and the subjects whose tables they read.';
