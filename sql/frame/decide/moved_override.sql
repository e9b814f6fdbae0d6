-- Decisions by hand are put on the axis on which they lie now: each finds its axis, then their tables are written.

CREATE OR REPLACE FUNCTION streetgen._make_moved_overrides(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _move_overrides(axes bigint[], lines_before geometry[], lines_after geometry[],
        extent geometry) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET enable_seqscan = off
            SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        tolerance constant float8 := streetgen._tolerance(current_schema());
        decisions streetgen.placed_decision[];
        node_decisions streetgen.node_decision[];
        relations text[];
    BEGIN
        WITH changed AS MATERIALIZED (
            SELECT axis_id, ST_Force2D(line_before) AS before, ST_Force2D(line_after) AS after
            FROM unnest(axes, lines_before, lines_after) c(axis_id, line_before, line_after)),
        place AS MATERIALIZED (
            SELECT p.*, c.before, c.after, c.axis_id IS NOT NULL AS named, r.via_axes,
                p.relation IN ('interconnection_override', 'turn_restriction', 'corner_override', 'overpass_override')
                    AND p.role NOT LIKE 'via_axis %' AS at_node,
                CASE WHEN p.role = 'to_axis' AND r.via_axes IS NOT NULL THEN 'to_geom' ELSE 'geom' END AS node,
                (SELECT ST_Force2D(a.geom) FROM axis a WHERE a.axis_id = p.axis_id) AS line
            FROM override_place p LEFT JOIN changed c USING (axis_id) LEFT JOIN turn_restriction r
                ON p.relation = 'turn_restriction' AND r.turn_restriction_id = p.override_id
            WHERE p.geom && ST_Expand(extent, CASE p.relation WHEN 'kerb_point_override' THEN 110 ELSE 30 END)),
        -- The axes that meet at each node of a decision. A restriction via axes has a node at both ends of these.
        meeting AS MATERIALIZED (
            SELECT relation, override_id, node, role, axis_id, before, after, geom, reach FROM place WHERE at_node
            UNION ALL SELECT p.relation, p.override_id, p.node, p.role, v.axis_id, c.before, c.after, p.geom, p.reach
            FROM place p CROSS JOIN LATERAL (SELECT p.via_axes[CASE p.node WHEN 'geom' THEN 1
                    ELSE cardinality(p.via_axes) END]) v(axis_id) LEFT JOIN changed c ON c.axis_id = v.axis_id
            WHERE p.at_node AND p.via_axes IS NOT NULL),
        -- A moved node: the axes that met there no longer do, and all meet at the new place of a vertex that was there.
        moved AS MATERIALIZED (
            SELECT DISTINCT ON (relation, override_id, node) relation, override_id, node, v.geom AS new_place,
                (SELECT d.geom FROM ST_DumpPoints(p.before) d ORDER BY ST_Distance(d.geom, p.geom), d.path LIMIT 1)
                    AS old_place
            FROM meeting p CROSS JOIN LATERAL streetgen._moved_vertex(p.before, p.after, p.geom, p.reach) v(geom)
            WHERE EXISTS (SELECT FROM meeting o
                    WHERE (o.relation, o.override_id, o.node) = (p.relation, p.override_id, p.node)
                    AND NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = o.axis_id
                        AND ST_DWithin(a.geom, p.geom, p.reach)))
                AND NOT streetgen._remap_is_cut_back(p.before, p.after, tolerance)
                AND NOT EXISTS (SELECT FROM meeting o
                    WHERE (o.relation, o.override_id, o.node) = (p.relation, p.override_id, p.node)
                    AND NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = o.axis_id
                        AND ST_DWithin(a.geom, v.geom, o.reach)))
            ORDER BY relation, override_id, node, role, axis_id),
        -- Each is now on its own axis, if that still lies there (1); on one that came by and is not farther (2); on its
        -- own, redrawn and neither cut back nor, for an end, made longer (3); on one that lies along the line that its
        -- own left (4); on its own, which ends just short of it (5).
        heir AS (
            SELECT p.*, a.axis_id AS heir, ST_Force2D(a.geom) AS heir_line,
                CASE WHEN a.axis_id = p.axis_id THEN CASE WHEN ST_DWithin(p.line, p.geom, 3 * tolerance)
                        OR streetgen._metres_beyond(p.line, p.geom) <= tolerance THEN 1 ELSE 5 END
                    WHEN c.axis_id IS NOT NULL AND (p.line IS NULL
                            OR ST_Distance(a.geom, p.geom) <= ST_Distance(p.line, p.geom))
                        AND streetgen._remap_comes_by(p.relation, c.before, c.after, p.geom, p.reach) THEN 2
                    -- A control point on a node stands on all the axes that meet there.
                    WHEN p.before IS NOT NULL AND (p.line IS NULL AND p.relation = 'control_point'
                        OR streetgen._remap_lies_along(p.before, ST_Force2D(a.geom), p.geom, tolerance)) THEN 4
                    END AS turn
            FROM place p JOIN axis a ON ST_DWithin(a.geom, p.geom, p.reach)
                LEFT JOIN changed c ON c.axis_id = a.axis_id
            WHERE ST_DWithin(streetgen._remap_part_of_axis(p.relation, ST_Force2D(a.geom)), p.geom, p.reach)
            UNION ALL SELECT p.*, p.axis_id, p.after, 3 FROM place p
            WHERE NOT p.at_node AND ST_DWithin(streetgen._remap_part_of_axis(p.relation, p.before), p.geom, p.reach)
                AND NOT streetgen._remap_is_cut_back(p.before, p.after, tolerance)
                AND CASE p.relation
                    WHEN 'transition_override' THEN NOT streetgen._remap_is_cut_back(p.after, p.before, tolerance)
                    WHEN 'turn_restriction' THEN true ELSE streetgen._remap_lies_beside(p.after, p.geom) END),
        found AS MATERIALIZED (
            SELECT relation, override_id, role, geom, abscissa, heir AS axis_id, heir_line AS line,
                turn = 3 AS redrawn, before, CASE WHEN before IS NULL AND heir <> axis_id
                    THEN coalesce(streetgen._remap_joins_against(h.line, heir_line, tolerance), false)
                    ELSE streetgen._remap_runs_against(before, heir_line, geom) END AS turned
            FROM (SELECT DISTINCT ON (relation, override_id, role) * FROM heir h
                WHERE heir = axis_id OR turn IS NOT NULL
                    AND NOT EXISTS (SELECT FROM place o WHERE (o.relation, o.override_id, o.axis_id)
                        = (h.relation, h.override_id, h.heir) AND o.role <> h.role)
                ORDER BY relation, override_id, role, turn, ST_Distance(heir_line, geom), heir) h
            WHERE (named OR heir <> axis_id) AND NOT (at_node AND EXISTS (SELECT FROM moved m
                WHERE (m.relation, m.override_id, m.node) = (h.relation, h.override_id, h.node)))),
        -- A decision on one axis goes with its vertex, where that moved, and comes onto an axis that was redrawn.
        placed AS MATERIALIZED (
            SELECT f.relation, f.override_id, f.role, f.axis_id, f.line, f.before, f.geom AS place, f.redrawn, f.turned,
                at.abscissa, at.geom
            FROM found f LEFT JOIN changed c ON c.axis_id = f.axis_id
                CROSS JOIN LATERAL (SELECT CASE WHEN f.relation IN ('road_override', 'junction_override',
                    'controller_override') THEN streetgen._moved_vertex(c.before, c.after, f.geom,
                    CASE f.relation WHEN 'road_override' THEN 1 ELSE 3 END * tolerance) END AS vertex) v
                CROSS JOIN LATERAL streetgen._projected(f.line, coalesce(v.vertex, f.geom), f.redrawn
                    OR v.vertex IS NOT NULL OR f.relation IN ('kerb_point_override', 'control_point'), f.abscissa) at),
        -- A decision at a node goes with the node: its axes, and how far the node moved, metres.
        at_node AS MATERIALIZED (
            SELECT relation, override_id,
                max(axis_id) FILTER (WHERE role IN ('axis_a', 'axis_in', 'axis_above', 'from_axis')) AS first_axis,
                max(axis_id) FILTER (WHERE role IN ('axis_b', 'axis_out', 'axis_below', 'to_axis')) AS second_axis,
                coalesce(bool_or(turned) FILTER (WHERE role = 'axis_in'), false) AS first_turned,
                coalesce(bool_or(turned) FILTER (WHERE role = 'axis_out'), false) AS second_turned,
                coalesce(max(east) FILTER (WHERE node = 'geom'), 0) AS east,
                coalesce(max(north) FILTER (WHERE node = 'geom'), 0) AS north,
                coalesce(max(east) FILTER (WHERE node = 'to_geom'), 0) AS to_east,
                coalesce(max(north) FILTER (WHERE node = 'to_geom'), 0) AS to_north,
                (array_agg(new_place) FILTER (WHERE node = 'geom'))[1] AS new_place
            FROM (SELECT relation, override_id, role, axis_id, turned, NULL AS node, NULL::geometry AS new_place,
                    NULL::float8 AS east, NULL::float8 AS north FROM found
                UNION ALL SELECT relation, override_id, NULL, NULL, NULL, node, new_place,
                    ST_X(new_place) - ST_X(old_place), ST_Y(new_place) - ST_Y(old_place) FROM moved) n
            GROUP BY relation, override_id)
        SELECT ARRAY(SELECT ROW (p.*)::streetgen.placed_decision FROM placed p),
            ARRAY(SELECT ROW (n.*)::streetgen.node_decision FROM at_node n WHERE relation IN ('corner_override',
                'interconnection_override', 'overpass_override', 'turn_restriction')) INTO decisions, node_decisions;
        relations := ARRAY(SELECT relation FROM unnest(decisions) UNION SELECT relation FROM unnest(node_decisions));
        IF 'transition_override' = ANY (relations) THEN
            UPDATE transition_override o SET axis_id = n.axis_id, which = n.which, geom = n.geom, kind = CASE
                WHEN n.which = o.which THEN o.kind WHEN o.kind = 'left' THEN 'right' WHEN o.kind = 'right' THEN 'left'
                ELSE o.kind END
            FROM (SELECT t.transition_override_id, p.axis_id, w.which,
                    ST_SetSRID(streetgen._end_of(p.line, w.which), ST_SRID(p.line)) AS geom
                FROM unnest(decisions) p JOIN transition_override t ON t.transition_override_id = p.override_id
                    CROSS JOIN LATERAL (SELECT ST_Distance(streetgen._end_of(p.line, 'start'), p.place)
                        - ST_Distance(streetgen._end_of(p.line, 'end'), p.place) AS nearer_end) d
                    CROSS JOIN LATERAL (SELECT CASE WHEN p.redrawn OR nearer_end = 0 AND NOT p.turned THEN t.which
                        WHEN nearer_end = 0 THEN CASE t.which WHEN 'start' THEN 'end' ELSE 'start' END
                        WHEN nearer_end < 0 THEN 'start' ELSE 'end' END AS which) w
                WHERE p.relation = 'transition_override') n
            WHERE o.transition_override_id = n.transition_override_id
                AND (o.axis_id, o.which, o.geom) IS DISTINCT FROM (n.axis_id, n.which, n.geom);
        END IF;
        IF 'lane_override' = ANY (relations) THEN
            UPDATE lane_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom,
                along_axis = o.along_axis <> (p.turned AND o.both_ways IS NOT TRUE),
                line = CASE WHEN p.turned THEN ST_Reverse(o.line) ELSE o.line END,
                ordinality = CASE WHEN p.turned THEN streetgen._mirrored_ordinality(o.ordinality,
                    streetgen._lanes_at(current_schema(), o.axis_id, o.abscissa)) ELSE o.ordinality END
            FROM unnest(decisions) p WHERE p.relation = 'lane_override'
                AND o.lane_override_id = p.override_id
                AND (p.turned OR (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom));
        END IF;
        IF 'lane_adjacency_override' = ANY (relations) THEN
            UPDATE lane_adjacency_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom,
                lane_from = CASE WHEN p.turned THEN streetgen._mirrored_ordinality(o.lane_from,
                    streetgen._lanes_at(current_schema(), o.axis_id, o.abscissa)) ELSE o.lane_from END,
                lane_to = CASE WHEN p.turned THEN streetgen._mirrored_ordinality(o.lane_to,
                    streetgen._lanes_at(current_schema(), o.axis_id, o.abscissa)) ELSE o.lane_to END
            FROM unnest(decisions) p WHERE p.relation = 'lane_adjacency_override'
                AND o.lane_adjacency_override_id = p.override_id
                AND (p.turned OR (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom));
        END IF;
        IF 'section_limit_override' = ANY (relations) THEN
            UPDATE section_limit_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom,
                which = CASE WHEN NOT p.turned THEN o.which WHEN o.which = 'start' THEN 'end' ELSE 'start' END
            FROM unnest(decisions) p WHERE p.relation = 'section_limit_override'
                AND o.section_limit_override_id = p.override_id
                AND (p.turned OR (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom));
        END IF;
        IF 'sidewalk_override' = ANY (relations) THEN
            UPDATE sidewalk_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom,
                side = CASE WHEN NOT p.turned THEN o.side WHEN o.side = 'left' THEN 'right' ELSE 'left' END
            FROM unnest(decisions) p WHERE p.relation = 'sidewalk_override'
                AND o.sidewalk_override_id = p.override_id
                AND (p.turned OR (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom));
        END IF;
        IF 'road_override' = ANY (relations) THEN
            UPDATE road_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom
            FROM unnest(decisions) p WHERE p.relation = 'road_override'
                AND o.road_override_id = p.override_id
                AND (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom);
        END IF;
        IF 'ramp_override' = ANY (relations) THEN
            UPDATE ramp_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom
            FROM unnest(decisions) p WHERE p.relation = 'ramp_override'
                AND o.ramp_override_id = p.override_id
                AND (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom);
        END IF;
        IF 'height_override' = ANY (relations) THEN
            UPDATE height_override o SET axis_id = p.axis_id, abscissa = p.abscissa, geom = p.geom
            FROM unnest(decisions) p WHERE p.relation = 'height_override'
                AND o.height_override_id = p.override_id
                AND (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (p.axis_id, p.abscissa, p.geom);
        END IF;
        IF 'kerb_point_override' = ANY (relations) THEN
            UPDATE kerb_point_override o SET axis_id = p.axis_id, abscissa = p.abscissa,
                width = 2 * ST_Distance(p.line, p.place)
            FROM unnest(decisions) p WHERE p.relation = 'kerb_point_override'
                AND o.kerb_point_override_id = p.override_id
                -- One that an axis is drawn over, or far away from, says no width.
                AND 2 * ST_Distance(p.line, p.place) BETWEEN 0.001 AND 200
                AND (o.axis_id, o.abscissa, o.width)
                    IS DISTINCT FROM (p.axis_id, p.abscissa, 2 * ST_Distance(p.line, p.place));
        END IF;
        IF 'control_point' = ANY (relations) THEN
            UPDATE control_point o SET axis_id = p.axis_id, abscissa = p.abscissa,
                direction = CASE WHEN NOT p.turned THEN o.direction WHEN o.direction = 'direct' THEN 'reverse'
                    WHEN o.direction = 'reverse' THEN 'direct' ELSE o.direction END
            FROM unnest(decisions) p WHERE p.relation = 'control_point'
                AND o.control_point_id = p.override_id
                AND (p.turned OR (o.axis_id, o.abscissa) IS DISTINCT FROM (p.axis_id, p.abscissa));
        END IF;
        IF 'junction_override' = ANY (relations) THEN
            UPDATE junction_override o SET axis_id = p.axis_id, geom = p.geom
            FROM unnest(decisions) p WHERE p.relation = 'junction_override'
                AND o.junction_override_id = p.override_id
                AND (o.axis_id, o.geom) IS DISTINCT FROM (p.axis_id, p.geom);
        END IF;
        IF 'controller_override' = ANY (relations) THEN
            UPDATE controller_override o SET axis_id = p.axis_id, geom = p.geom
            FROM unnest(decisions) p WHERE p.relation = 'controller_override'
                AND o.controller_override_id = p.override_id
                AND (o.axis_id, o.geom) IS DISTINCT FROM (p.axis_id, p.geom);
        END IF;
        IF 'corner_override' = ANY (relations) THEN
            UPDATE corner_override o SET geom = ST_Translate(o.geom, n.east, n.north),
                axis_a = coalesce(n.first_axis, o.axis_a), axis_b = coalesce(n.second_axis, o.axis_b)
            FROM unnest(node_decisions) n WHERE n.relation = 'corner_override'
                AND o.corner_override_id = n.override_id
                AND (n.east, n.north, coalesce(n.first_axis, o.axis_a),
                    coalesce(n.second_axis, o.axis_b))
                    IS DISTINCT FROM (0, 0, o.axis_a, o.axis_b);
        END IF;
        IF 'overpass_override' = ANY (relations) THEN
            UPDATE overpass_override o SET geom = ST_Translate(o.geom, n.east, n.north),
                axis_above = coalesce(n.first_axis, o.axis_above), axis_below = coalesce(n.second_axis, o.axis_below)
            FROM unnest(node_decisions) n WHERE n.relation = 'overpass_override'
                AND o.overpass_override_id = n.override_id
                AND (n.east, n.north, coalesce(n.first_axis, o.axis_above),
                    coalesce(n.second_axis, o.axis_below))
                    IS DISTINCT FROM (0, 0, o.axis_above, o.axis_below);
        END IF;
        IF 'interconnection_override' = ANY (relations) THEN
            UPDATE interconnection_override o SET geom = coalesce(n.new_place, o.geom),
                control = ST_Translate(o.control, n.east, n.north),
                axis_in = coalesce(n.first_axis, o.axis_in), axis_out = coalesce(n.second_axis, o.axis_out),
                lane_in = CASE WHEN n.first_turned THEN streetgen._mirrored_ordinality(o.lane_in,
                    streetgen._lanes_by(current_schema(), o.axis_in, o.geom)) ELSE o.lane_in END,
                lane_out = CASE WHEN n.second_turned THEN streetgen._mirrored_ordinality(o.lane_out,
                    streetgen._lanes_by(current_schema(), o.axis_out, o.geom)) ELSE o.lane_out END,
                along_in = o.along_in <> n.first_turned, along_out = o.along_out <> n.second_turned
            FROM unnest(node_decisions) n WHERE n.relation = 'interconnection_override'
                AND o.interconnection_override_id = n.override_id
                AND (n.first_turned OR n.second_turned
                OR (coalesce(n.new_place, o.geom), coalesce(n.first_axis, o.axis_in),
                    coalesce(n.second_axis, o.axis_out)) IS DISTINCT FROM (o.geom, o.axis_in, o.axis_out));
        END IF;
        IF 'turn_restriction' = ANY (relations) THEN
            UPDATE turn_restriction o SET geom = n.geom, to_geom = n.to_geom, from_axis = n.from_axis,
                to_axis = n.to_axis, via_axes = n.via_axes, via_geom = n.via_geom
            FROM (SELECT r.turn_restriction_id, ST_Translate(r.geom, n.east, n.north) AS geom,
                    ST_Translate(r.to_geom, n.to_east, n.to_north) AS to_geom,
                    coalesce(n.first_axis, r.from_axis) AS from_axis, coalesce(n.second_axis, r.to_axis) AS to_axis,
                    v.axes AS via_axes, v.geom AS via_geom
                FROM unnest(node_decisions) n JOIN turn_restriction r ON r.turn_restriction_id = n.override_id
                    LEFT JOIN LATERAL (
                    SELECT array_agg(coalesce(f.axis_id, u.axis_id) ORDER BY u.i) AS axes,
                        -- On its axis redrawn: beside where it was, else as far along the line as before.
                        ST_Collect(CASE WHEN f.redrawn IS NOT TRUE THEN p.geom
                            WHEN streetgen._remap_lies_beside(f.line, p.geom) THEN ST_ClosestPoint(f.line, p.geom)
                            ELSE ST_LineInterpolatePoint(f.line, ST_LineLocatePoint(f.before, p.geom)) END ORDER BY u.i)
                            AS geom
                    FROM unnest(r.via_axes) WITH ORDINALITY u(axis_id, i)
                        CROSS JOIN LATERAL ST_GeometryN(r.via_geom, u.i::integer) p(geom)
                        LEFT JOIN unnest(decisions) f ON (f.relation, f.override_id, f.role)
                            = ('turn_restriction', r.turn_restriction_id, 'via_axis ' || u.i)) v
                    ON r.via_axes IS NOT NULL
                WHERE n.relation = 'turn_restriction') n
            WHERE o.turn_restriction_id = n.turn_restriction_id
                AND (o.geom::bytea, o.from_axis, o.to_axis, o.via_axes, o.via_geom::bytea, o.to_geom::bytea) IS DISTINCT
                    FROM (n.geom::bytea, n.from_axis, n.to_axis, n.via_axes, n.via_geom::bytea, n.to_geom::bytea);
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_move_overrides(bigint[], geometry[], geometry[], geometry)',
        'Puts the overrides beside changed axes, and within an extent, on the axis that they lie on now');
END $$;
COMMENT ON FUNCTION streetgen._make_moved_overrides(name) IS
    'Makes the function of a model that puts decisions by hand near changed axes on the axis that they lie on now. '
    'What fits nowhere stays as it is, until an axis comes by.';
