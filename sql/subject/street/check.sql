-- Rules of check_model for the network and its surfaces.

CREATE OR REPLACE FUNCTION streetgen._node_degrees(model name) RETURNS TABLE(node_id bigint, degree bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT e.end_node, count(*) FROM (SELECT from_node AS end_node FROM edge
        UNION ALL SELECT to_node FROM edge) e GROUP BY e.end_node;
END $$;
COMMENT ON FUNCTION streetgen._node_degrees(name) IS 'How many ends of edges meet at each node of a model.';

CREATE OR REPLACE FUNCTION streetgen._check_network(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    -- Without the radius, so that a predictor of the user's is not asked.
    WITH used AS MATERIALIZED (SELECT axis_id, geom, width, width_end, roadway_offset, lane_count, lanes_forward,
        lanes_backward, input_hash, setting_hash FROM axis_used),
    ending AS MATERIALIZED (SELECT node_id, axis_id, geom FROM node n
        JOIN LATERAL (SELECT from_node, axis_id FROM edge
        UNION ALL SELECT to_node, axis_id FROM edge) e(node_id, axis_id) USING (node_id)
        WHERE axis_id IN (SELECT unnest(ARRAY[from_axis, to_axis] || via_axes) FROM turn_restriction)),
    listed AS MATERIALIZED (
        SELECT u.axis_id, u.geom, w.*, streetgen.driving_lanes(w.kinds) AS of_kinds FROM used u
            JOIN axis a USING (axis_id),
        LATERAL (VALUES (a.kind_forward, a.lane_width_forward, a.turn_forward, a.lanes_forward, u.lanes_forward,
            a.direction = 'reverse'),
                        (a.kind_backward, a.lane_width_backward, a.turn_backward, a.lanes_backward, u.lanes_backward,
                            a.direction = 'direct')) w(kinds, widths, turns, stated, used, closed)
        WHERE coalesce(w.kinds, w.widths, w.turns, w.stated::text) IS NOT NULL),
    degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model))
    SELECT 'error', 'node without an edge', 'node', n.node_id, 0, n.geom FROM node n
        WHERE NOT EXISTS (SELECT FROM degree d WHERE d.node_id = n.node_id)
    UNION ALL
    SELECT 'warning', 'turn restriction without a place', 'turn_restriction', r.turn_restriction_id, 0, r.geom
        FROM turn_restriction r
        WHERE EXISTS (SELECT FROM (VALUES (r.from_axis, coalesce(r.via_axes[1], r.to_axis), r.geom),
                (r.via_axes[cardinality(r.via_axes)], r.to_axis, r.to_geom)) m(axis_a, axis_b, geom)
            WHERE m.geom IS NOT NULL AND NOT EXISTS (SELECT FROM ending a JOIN ending b USING (node_id)
                WHERE a.axis_id = m.axis_a AND b.axis_id = m.axis_b AND ST_DWithin(a.geom, m.geom, 3 * tolerance)))
            OR EXISTS (SELECT FROM unnest(via_axes) u(axis_id)
                WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = u.axis_id))
    UNION ALL
    SELECT 'warning', 'contradictory turn restrictions', 'turn_restriction', a.turn_restriction_id,
        b.turn_restriction_id, a.geom FROM turn_restriction a
        JOIN turn_restriction b ON (a.from_axis, a.to_axis, a.kind, b.kind) = (b.from_axis, b.to_axis, 'no', 'only')
            AND (a.turn = b.turn) IS NOT FALSE AND a.via_axes IS NOT DISTINCT FROM b.via_axes
        WHERE ST_DWithin(a.geom, b.geom, 3 * tolerance)
    UNION ALL
    SELECT 'warning', 'stale: rows changed by hand since', 'edge', edge_id, 0, geom FROM edge
        WHERE input_hash = streetgen._changed_by_hand()
    UNION ALL
    SELECT 'warning', 'stale: the axis changed since', 'axis', u.axis_id, 0, u.geom FROM used u
        WHERE EXISTS (SELECT FROM edge e WHERE e.axis_id = u.axis_id AND e.input_hash <> u.input_hash
        AND e.input_hash <> streetgen._changed_by_hand())
    UNION ALL
    SELECT 'warning', 'stale: the axis is gone', 'edge', e.edge_id, 0, e.geom FROM edge e
        WHERE NOT EXISTS (SELECT FROM used u WHERE u.axis_id = e.axis_id)
    UNION ALL
    SELECT 'warning', 'stale: settings changed since, edges', 'setting', NULL, count(*), NULL FROM edge e
        JOIN used u USING (axis_id) WHERE e.setting_hash <> u.setting_hash HAVING count(*) > 0
    UNION ALL
    SELECT 'notice', 'not_generated', 'axis', u.axis_id, ST_Length(u.geom), u.geom FROM used u
        WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = u.axis_id)
        AND NOT EXISTS (SELECT FROM report r WHERE r.axis_a = u.axis_id AND r.issue = 'collapsed_axis')
    UNION ALL
    SELECT 'notice', 'kind that is no class, taken as unknown', 'axis', a.axis_id, 0, a.geom FROM axis a
        WHERE NOT EXISTS (SELECT FROM axis_class c WHERE c.class = a.kind) AND a.kind IS NOT NULL
    UNION ALL
    SELECT 'warning', CASE metres WHEN 0 THEN 'looks like degrees'
        ELSE 'outside the area of use of the SRID, m' END, 'axis', label::bigint, metres, place
        FROM streetgen._misplaced(format('SELECT axis_id AS label, geom FROM %I.axis', model))
    UNION ALL
    SELECT 'notice', attribute || ' not believed, m', 'axis', axis_id, width, geom
        FROM streetgen._unbelieved(model)
    UNION ALL SELECT 'notice', 'roadway_offset beyond half of the width, m', 'axis', axis_id, a.roadway_offset, a.geom
        FROM axis a JOIN used u USING (axis_id) WHERE a.roadway_offset <> 0
            AND a.roadway_offset <> u.roadway_offset
    UNION ALL
    SELECT 'error', 'lanes of the directions do not sum up', 'edge', e.edge_id, e.lane_count, e.geom
        FROM edge e
        WHERE e.lane_count <> e.lanes_forward + e.lanes_backward + e.lanes_both
    UNION ALL
    SELECT 'warning', 'section limit override without its limit', 'section_limit_override',
        o.section_limit_override_id, o.abscissa, o.geom FROM section_limit_override o
        WHERE NOT EXISTS (SELECT FROM edge e JOIN degree d ON d.node_id = CASE o.which WHEN 'start' THEN e.from_node
            ELSE e.to_node END WHERE e.axis_id = o.axis_id AND d.degree > 1
            AND CASE o.which WHEN 'start' THEN o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
                ELSE o.abscissa > e.start_abscissa AND o.abscissa <= e.end_abscissa END)
    UNION ALL
    SELECT 'warning', 'kerb point override without its axis', 'kerb_point_override', o.kerb_point_override_id,
        o.width, o.geom FROM kerb_point_override o
        WHERE NOT EXISTS (SELECT FROM used u WHERE u.axis_id = o.axis_id)
    UNION ALL
    SELECT 'notice', 'lanes for both directions of a one-way street, not taken', 'axis', axis_id, lanes_both,
        geom FROM axis WHERE direction <> 'both' AND lanes_both > 0
    UNION ALL
    SELECT 'notice', 'lane_count is not that of the directions, which count', 'axis', a.axis_id, a.lane_count,
        a.geom FROM axis a JOIN used u USING (axis_id)
        WHERE a.lane_count <> u.lane_count
    UNION ALL
    SELECT 'notice', 'lanes against a one-way street, not taken', 'axis', axis_id, stated, geom FROM listed
        WHERE closed AND stated > 0 AND kinds IS NULL
    UNION ALL
    SELECT 'notice', 'number of lanes is not that of their kinds, which count', 'axis', axis_id, stated, geom
        FROM listed WHERE stated <> of_kinds
    UNION ALL
    SELECT 'notice', what || ' are not those of all lanes, not taken', 'axis', axis_id,
        cardinality(string_to_array(list, '|')), geom
        FROM listed, LATERAL (VALUES ('widths', widths), ('turns', turns)) v(what, list)
        WHERE cardinality(string_to_array(list, '|')) NOT IN (used, coalesce(cardinality(string_to_array(kinds, '|')),
            used))
    UNION ALL
    SELECT 'notice', issue, 'axis', axis_a, measure, geom FROM report
    UNION ALL
    SELECT 'warning', 'driving side is not that of the one-way axes', 'setting', NULL::bigint,
        sum(CASE side WHEN 'left' THEN count_left ELSE count_right END)::float8, NULL::geometry
        FROM streetgen.driving_side(model) WHERE streetgen._found_driving_side(model) <> streetgen._driving_side(model)
            AND side IS NOT NULL HAVING count(*) > 0
    UNION ALL
    SELECT 'warning', 'control point off all axes', 'control_point', p.control_point_id, 0, p.geom
        FROM control_point p WHERE NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = p.axis_id)
    UNION ALL
    SELECT 'warning', 'roundabout override without its ring', 'roundabout_override', o.roundabout_override_id, 0, o.geom
        FROM roundabout_override o WHERE NOT streetgen._has_ring(model, o.geom)
    UNION ALL
    SELECT 'error', 'smoothed line off its axis, m', 'edge', e.edge_id, off, e.geom
        FROM edge e JOIN used u USING (axis_id), (SELECT max(value) FILTER (WHERE name = 'smoothing') AS smoothing,
                (max(value) FILTER (WHERE name = 'smoothing_shift'))::float8
                    + 3 * (max(value) FILTER (WHERE name = 'tolerance'))::float8 AS bound FROM setting
                WHERE name IN ('smoothing', 'smoothing_shift', 'tolerance')) s,
            LATERAL (SELECT ST_HausdorffDistance(ST_Force2D(e.geom), ST_LineSubstring(ST_Force2D(u.geom),
                least(e.start_abscissa / ST_Length2D(u.geom), 1), least(e.end_abscissa / ST_Length2D(u.geom), 1)))
                AS off) o
        WHERE smoothing = 'arcs' AND e.curve IS NOT NULL AND off > bound AND NOT EXISTS (
            SELECT FROM road_override o WHERE o.axis_id = e.axis_id)
    UNION ALL
    SELECT 'warning', 'road override without its bend', 'road_override', o.road_override_id, o.abscissa, o.geom
        FROM road_override o WHERE NOT EXISTS (SELECT FROM used u JOIN edge e USING (axis_id), LATERAL
            streetgen._bend_of(u.geom, ST_LineInterpolatePoint(ST_Force2D(u.geom),
                least(o.abscissa / ST_Length2D(u.geom), 1)), e.start_abscissa, e.end_abscissa) b
            WHERE u.axis_id = o.axis_id AND abs(b.abscissa - o.abscissa) <= 1)
    UNION ALL
    SELECT 'warning', 'sidewalk override without its edge', 'sidewalk_override', o.sidewalk_override_id, o.width, o.geom
        FROM sidewalk_override o WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = o.axis_id
            AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_network(name) IS
    'The rows of streetgen.check_model for the network: axes, edges and nodes, and what is by hand on them.';

CREATE OR REPLACE FUNCTION streetgen._check_surface(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model)),
    not_made AS MATERIALIZED (
        SELECT geom, greatest(width, width_end) / 2 + abs(roadway_offset) AS half FROM axis_used u
            WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = u.axis_id)),
    invalid AS MATERIALIZED (
        SELECT 'section' AS relation, edge_id AS id, surface FROM section
            WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
        UNION ALL SELECT 'intersection', node_id, surface FROM intersection
            WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)),
    -- By lists, so that each is left out before its surface meets another.
    valid_section AS NOT MATERIALIZED (SELECT * FROM section
        WHERE edge_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'section'))),
    valid_intersection AS NOT MATERIALIZED (SELECT * FROM intersection
        WHERE node_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'intersection'))),
    -- Neighbours share their border vertex for vertex, so that a relation without a grid would stumble over rounding.
    -- A grid costs as much again, so that only pairs that share ground without one are looked at.
    -- Levels are compared by difference, since a hash join of a whole level would pass over the spatial index.
    overlap AS MATERIALIZED (
        SELECT relation, id, ST_CollectionExtract(ST_Intersection(a, b, 1e-5), 3) AS shared FROM (
            SELECT 'section' AS relation, a.edge_id AS id, a.surface AS a, b.surface AS b
            FROM valid_section a JOIN valid_section b ON a.surface && b.surface AND a.level - b.level = 0
                AND a.edge_id < b.edge_id
            UNION ALL SELECT 'section', a.edge_id, a.surface, b.surface
            FROM valid_section a JOIN valid_intersection b ON a.surface && b.surface AND a.level - b.level = 0
            UNION ALL SELECT 'intersection', a.node_id, a.surface, b.surface
            FROM valid_intersection a JOIN valid_intersection b ON a.surface && b.surface AND a.level - b.level = 0
                AND a.node_id < b.node_id) pair
        WHERE streetgen._share_ground(a::bytea, b::bytea) AND ST_Area(ST_Intersection(a, b)) > 1e-6),
    -- A part of an edge on neither its section nor its nodes' intersections, nor, where ground was contested, on other
    -- roadway. Borders may run along the edge, so that a piece is bare only where its middle is off all of them;
    -- contested ground is shared out on a grid of 10 micrometres. An axis beside the middle of its roadway leaves it
    -- where kerbs round a bend.
    bare AS MATERIALIZED (
        SELECT edge_id, piece.geom, ST_Length(piece.geom) AS length
        FROM (SELECT e.edge_id, e.roadway_offset, from_node, to_node, s.contested_area + coalesce(a.contested_area,
            0) + coalesce(b.contested_area, 0) > 0 AS contested,
                     ST_Difference(ST_Difference(ST_Difference(ST_Force2D(e.geom), s.surface),
                         coalesce(a.surface, s.surface)), coalesce(b.surface, s.surface)) AS rest
              FROM edge e JOIN valid_section s USING (edge_id)
              LEFT JOIN intersection a ON a.node_id = from_node LEFT JOIN intersection b ON b.node_id = to_node
              WHERE NOT ARRAY[from_node, to_node] && ARRAY(SELECT id FROM invalid WHERE relation = 'intersection')
                AND NOT streetgen._lies_on(
                    e.geom::bytea, s.surface::bytea, coalesce(a.surface, s.surface)::bytea,
                        coalesce(b.surface, s.surface)::bytea)
              OFFSET 0) e, ST_Dump(rest) piece,
             LATERAL (SELECT ST_LineInterpolatePoint(piece.geom, 0.5) AS middle, abs(roadway_offset)
                 + CASE WHEN contested THEN 1e-5 ELSE 1e-6 END AS off) p
        WHERE ST_Length(piece.geom) > 1e-6
          AND NOT EXISTS (SELECT FROM section r WHERE ST_DWithin(surface, middle, off)
              AND (contested OR r.edge_id = e.edge_id))
          AND NOT EXISTS (SELECT FROM intersection r WHERE ST_DWithin(surface, middle, off)
              AND (contested OR node_id IN (from_node, to_node)))
          -- Ground may wait for a street that is not made yet.
          AND NOT (contested AND EXISTS (SELECT FROM not_made WHERE ST_DWithin(not_made.geom, middle, half))))
    SELECT 'error', 'invalid surface', relation, id, ST_Area(surface), surface FROM invalid
    UNION ALL
    SELECT 'error', 'overlap on one level, m2', relation, id, ST_Area(shared), shared FROM overlap
        WHERE ST_Area(shared) > 0.001
    UNION ALL
    SELECT 'error', 'node of degree three and more without an intersection', 'node', n.node_id, d.degree, n.geom
        FROM node n JOIN degree d USING (node_id) LEFT JOIN intersection i USING (node_id) WHERE d.degree >= 3
            AND (i.node_id IS NULL OR ST_IsEmpty(i.surface) AND i.contested_area = 0)
    UNION ALL
    SELECT 'error', 'edge without its two limits', 'edge', e.edge_id, count(l.edge_id), e.geom FROM edge e
        LEFT JOIN section_limit l USING (edge_id) GROUP BY e.edge_id HAVING count(l.edge_id) <> 2
    UNION ALL
    SELECT 'error', 'edge without a section', 'edge', e.edge_id, 0, e.geom FROM edge e
        WHERE NOT EXISTS (SELECT FROM section s WHERE s.edge_id = e.edge_id)
    UNION ALL
    SELECT 'error', 'edge outside the roadway, m', 'edge', edge_id, length, geom FROM bare
    UNION ALL
    SELECT 'error', 'limits out of order', 'edge', a.edge_id, a.abscissa - b.abscissa, a.geom
        FROM section_limit a JOIN section_limit b USING (edge_id) WHERE a.which = 'start' AND b.which = 'end'
            AND a.abscissa > b.abscissa + 1e-6
    UNION ALL
    SELECT 'notice', 'contested, m2', 'section', edge_id, contested_area, surface FROM section
        WHERE contested_area > 1 AND method <> 'crowded'
    UNION ALL
    SELECT 'notice', 'contested, m2', 'intersection', node_id, contested_area, surface FROM intersection
        WHERE contested_area > 1 AND method <> 'crowded'
    UNION ALL
    SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'section', edge_id,
        contested_area, geom
        FROM section JOIN edge USING (edge_id) WHERE method = 'crowded'
    UNION ALL
    SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'intersection',
        node_id, contested_area, geom
        FROM intersection JOIN node USING (node_id) WHERE method = 'crowded'
    UNION ALL
    SELECT 'warning', 'transition_override finds no change of width', 'transition_override',
        o.transition_override_id, 0, u.geom
        FROM transition_override o LEFT JOIN axis u USING (axis_id) WHERE NOT EXISTS (
            SELECT FROM edge e JOIN intersection i ON i.node_id = CASE o.which WHEN 'start' THEN e.from_node
                ELSE e.to_node END JOIN degree d USING (node_id)
            WHERE e.axis_id = o.axis_id AND d.degree = 2 AND i.method IN ('transition', 'contested', 'crowded')
                AND NOT EXISTS (SELECT FROM edge f WHERE f.axis_id = e.axis_id AND CASE o.which WHEN 'start'
                    THEN f.start_abscissa < e.start_abscissa ELSE f.end_abscissa > e.end_abscissa END))
    UNION ALL
    SELECT 'warning', 'corner override without its corner', 'corner_override', o.corner_override_id, o.radius,
        o.geom FROM corner_override o
        WHERE NOT EXISTS (SELECT FROM node n JOIN corner c USING (node_id)
            JOIN edge a ON a.edge_id = c.edge_a JOIN edge b ON b.edge_id = c.edge_b
            WHERE (a.axis_id, b.axis_id) = (o.axis_a, o.axis_b) AND c.method <> 'transition'
                AND ST_DWithin(n.geom, o.geom, 3 * tolerance))
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_surface(name) IS
    'The rows of streetgen.check_model for sections, intersections and corners.';
