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
    BEGIN
        WITH changed AS MATERIALIZED (
            SELECT axis_id, ST_Force2D(line_before) AS before, ST_Force2D(line_after) AS after
            FROM unnest(axes, lines_before, lines_after) c(axis_id, line_before, line_after)),
        place AS MATERIALIZED (
            SELECT p.*, c.before, c.after, c.axis_id IS NOT NULL AS named, l.heading AS lost,
                l.leaves,
                CASE WHEN p.ordinality = 2 AND p.next_axis IS NOT NULL THEN 'to_geom' ELSE 'geom' END AS node,
                (SELECT ST_Force2D(a.geom) FROM axis a WHERE a.axis_id = p.axis_id) AS line
            FROM override_place p LEFT JOIN changed c USING (axis_id)
                LEFT JOIN lost_place l USING (relation, override_id, role, axis_id)
            WHERE p.geom && ST_Expand(extent, CASE p.anchor WHEN 'beside' THEN 110 ELSE 30 END)),
        -- The axes that meet at each node of a decision. A route via axes has a node at both ends of these.
        meeting AS MATERIALIZED (
            SELECT relation, override_id, node, role, axis_id, before, after, geom, reach FROM place
            WHERE anchor = 'node'
            UNION ALL SELECT p.relation, p.override_id, p.node, p.role, p.next_axis, c.before, c.after, p.geom, p.reach
            FROM place p LEFT JOIN changed c ON c.axis_id = p.next_axis
            WHERE p.anchor = 'node' AND p.next_axis IS NOT NULL),
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
        -- own left (4); on its own, which ends just short of it (5). At a node an axis that leaves it otherwise than
        -- the one that is gone, by more than half of a right angle, is another arm, and its own may still come.
        heir AS (
            SELECT p.*, a.axis_id AS heir, ST_Force2D(a.geom) AS heir_line,
                CASE WHEN a.axis_id = p.axis_id THEN CASE WHEN ST_DWithin(p.line, p.geom, 3 * tolerance)
                        OR streetgen._metres_beyond(p.line, p.geom) <= tolerance THEN 1 ELSE 5 END
                    WHEN c.axis_id IS NOT NULL AND (p.line IS NULL
                            OR ST_Distance(a.geom, p.geom) <= ST_Distance(p.line, p.geom))
                        AND streetgen._remap_comes_by(p.anchor, c.before, c.after, p.geom, p.reach)
                        AND NOT (p.anchor IN ('node', 'end') AND coalesce(cos(p.leaves
                            - streetgen._remap_leaves(ST_Force2D(a.geom), p.geom, p.reach)) < sqrt(0.5), false)) THEN 2
                    -- A place on the ground at a node stands on all the axes that meet there.
                    WHEN p.before IS NOT NULL AND (p.line IS NULL AND p.anchor = 'ground'
                        OR streetgen._remap_lies_along(p.before, ST_Force2D(a.geom), p.geom, tolerance)) THEN 4
                    END AS turn
            FROM place p JOIN axis a ON ST_DWithin(a.geom, p.geom, p.reach)
                LEFT JOIN changed c ON c.axis_id = a.axis_id
            WHERE ST_DWithin(streetgen._remap_part_of_axis(p.anchor, ST_Force2D(a.geom)), p.geom, p.reach)
            UNION ALL SELECT p.*, p.axis_id, p.after, 3 FROM place p
            WHERE p.anchor <> 'node' AND ST_DWithin(streetgen._remap_part_of_axis(p.anchor, p.before), p.geom, p.reach)
                AND NOT streetgen._remap_is_cut_back(p.before, p.after, tolerance)
                AND CASE p.anchor
                    WHEN 'end' THEN NOT streetgen._remap_is_cut_back(p.after, p.before, tolerance)
                    WHEN 'via' THEN true ELSE streetgen._remap_lies_beside(p.after, p.geom) END),
        found AS MATERIALIZED (
            SELECT relation, override_id, role, anchor, ordinality, geom, reach, abscissa, heir AS axis_id,
                heir_line AS line, turn = 3 AS redrawn, before,
                CASE WHEN lost IS NULL AND before IS NULL AND heir <> axis_id
                    THEN coalesce(streetgen._remap_joins_against(h.line, heir_line, tolerance), false)
                    ELSE streetgen._remap_runs_against(coalesce(lost, streetgen._heading(before, geom)), heir_line,
                        geom) END AS turned
            FROM (SELECT DISTINCT ON (relation, override_id, role) * FROM heir h
                WHERE heir = axis_id OR turn IS NOT NULL
                    AND NOT EXISTS (SELECT FROM place o WHERE (o.relation, o.override_id, o.axis_id)
                        = (h.relation, h.override_id, h.heir) AND o.role <> h.role)
                ORDER BY relation, override_id, role, turn, ST_Distance(heir_line, geom), heir) h
            WHERE (named OR heir <> axis_id) AND NOT (anchor = 'node' AND EXISTS (SELECT FROM moved m
                WHERE (m.relation, m.override_id, m.node) = (h.relation, h.override_id, h.node)))),
        -- A decision on one axis goes with its vertex, where that moved, and comes onto an axis that was redrawn.
        placed AS MATERIALIZED (
            SELECT f.relation, f.override_id, f.role, f.axis_id, f.line, f.before, f.geom AS place, f.redrawn, f.turned,
                at.abscissa, at.geom
            FROM found f LEFT JOIN changed c ON c.axis_id = f.axis_id
                CROSS JOIN LATERAL (SELECT CASE f.anchor WHEN 'vertex'
                    THEN streetgen._moved_vertex(c.before, c.after, f.geom, f.reach) END AS vertex) v
                CROSS JOIN LATERAL streetgen._projected(f.line, coalesce(v.vertex, f.geom), f.redrawn
                    -- A decision along an edge lies before its end, also where its axis was cut there.
                    OR v.vertex IS NOT NULL, f.anchor = 'along', f.abscissa) at),
        -- One that lies on no axis any more keeps the heading of the road there, until an axis comes by.
        lost AS (
            INSERT INTO lost_place (relation, override_id, role, axis_id, abscissa, geom, heading, leaves)
            SELECT relation, override_id, role, axis_id, abscissa, ST_Force2D(geom), streetgen._heading(before, geom),
                streetgen._remap_leaves(before, geom, reach)
            FROM place p WHERE before IS NOT NULL AND lost IS NULL
                AND NOT EXISTS (SELECT FROM found f
                    WHERE (f.relation, f.override_id, f.role) = (p.relation, p.override_id, p.role))
            ON CONFLICT (relation, override_id, role) DO UPDATE SET axis_id = excluded.axis_id,
                abscissa = excluded.abscissa, geom = excluded.geom, heading = excluded.heading,
                leaves = excluded.leaves, lanes = NULL),
        -- A decision at a node goes with the node: its axes, and how far the node moved, metres.
        at_node AS MATERIALIZED (
            SELECT relation, override_id,
                max(axis_id) FILTER (WHERE anchor = 'node' AND ordinality = 1) AS first_axis,
                max(axis_id) FILTER (WHERE anchor = 'node' AND ordinality = 2) AS second_axis,
                coalesce(bool_or(turned) FILTER (WHERE anchor = 'node' AND ordinality = 1), false) AS first_turned,
                coalesce(bool_or(turned) FILTER (WHERE anchor = 'node' AND ordinality = 2), false) AS second_turned,
                coalesce(max(east) FILTER (WHERE node = 'geom'), 0) AS east,
                coalesce(max(north) FILTER (WHERE node = 'geom'), 0) AS north,
                coalesce(max(east) FILTER (WHERE node = 'to_geom'), 0) AS to_east,
                coalesce(max(north) FILTER (WHERE node = 'to_geom'), 0) AS to_north,
                (array_agg(new_place) FILTER (WHERE node = 'geom'))[1] AS new_place
            FROM (SELECT relation, override_id, anchor, ordinality, axis_id, turned, NULL AS node,
                    NULL::geometry AS new_place, NULL::float8 AS east, NULL::float8 AS north FROM found
                    WHERE anchor IN ('node', 'via')
                UNION ALL SELECT relation, override_id, NULL, NULL, NULL, NULL, node, new_place,
                    ST_X(new_place) - ST_X(old_place), ST_Y(new_place) - ST_Y(old_place) FROM moved) n
            GROUP BY relation, override_id)
        SELECT ARRAY(SELECT ROW (p.*)::streetgen.placed_decision FROM placed p),
            ARRAY(SELECT ROW (n.*)::streetgen.node_decision FROM at_node n) INTO decisions, node_decisions;
        PERFORM streetgen._note_lost_places(current_schema()), _write_decisions(decisions, node_decisions),
            streetgen._forget_lost_places(current_schema(), extent);
    END $body$;
    PERFORM streetgen._own_function(model, '_move_overrides(bigint[], geometry[], geometry[], geometry)',
        'Puts the overrides beside changed axes, and within an extent, on the axis that they lie on now');
END $$;
COMMENT ON FUNCTION streetgen._make_moved_overrides(name) IS
    'Makes the function of a model that puts decisions by hand near changed axes on the axis that they lie on now. '
    'What fits nowhere stays as it is, until an axis comes by.';
