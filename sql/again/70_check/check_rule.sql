-- The rules of check_model, one by one, and the queries that they share.

CREATE OR REPLACE FUNCTION streetgen._check_part() RETURNS TABLE(place integer, subject text, kind text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 60 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'network', 'with', $part$
-- Without the radius, so that a predictor of the user's is not asked.
used AS MATERIALIZED (SELECT axis_id, geom, width, width_end, roadway_offset, lane_count, lanes_forward, lanes_backward,
    input_hash, setting_hash FROM %1$I.axis_used)$part$),
    (2, 'surface', 'with', $part$
invalid AS MATERIALIZED (
    SELECT 'section' AS relation, edge_id AS id, surface FROM %1$I.section
        WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
    UNION ALL SELECT 'intersection', node_id, surface FROM %1$I.intersection
        WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface))$part$),
    (3, 'surface', 'with', $part$
-- By lists, so that each is left out before its surface meets another.
valid_section AS NOT MATERIALIZED (SELECT * FROM %1$I.section
    WHERE edge_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'section')))$part$),
    (4, 'surface', 'with', $part$
valid_intersection AS NOT MATERIALIZED (SELECT * FROM %1$I.intersection
    WHERE node_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'intersection')))$part$),
    (5, 'surface', 'with', $part$
-- Neighbours share their border vertex for vertex, so that a relation without a grid would stumble over rounding.
-- It costs as much again, so that only what shares ground without one is looked at.
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
    WHERE streetgen._share_ground(a::bytea, b::bytea) AND ST_Area(ST_Intersection(a, b)) > 1e-6)$part$),
    (6, 'network', 'with', $part$
not_made AS MATERIALIZED (
    SELECT geom, greatest(width, width_end) / 2 + abs(roadway_offset) AS half FROM used u
        WHERE NOT EXISTS (SELECT FROM %1$I.edge e
        WHERE e.axis_id = u.axis_id))$part$),
    (7, 'surface', 'with', $part$
-- What of an edge lies on neither its section nor its nodes' intersections, nor, where ground was contested, on other
-- roadway.
-- Borders may run along the edge, so that a piece is bare only where its middle is off all of them; contested ground is
-- shared out on a grid of 10 micrometres. An axis beside the middle of its roadway leaves it where kerbs round a bend.
bare AS MATERIALIZED (
    SELECT edge_id, piece.geom, ST_Length(piece.geom) AS length
    FROM (SELECT e.edge_id, e.roadway_offset, from_node, to_node, s.contested_area + coalesce(a.contested_area,
        0) + coalesce(b.contested_area, 0) > 0 AS contested,
                 ST_Difference(ST_Difference(ST_Difference(ST_Force2D(e.geom), s.surface),
                     coalesce(a.surface, s.surface)), coalesce(b.surface, s.surface)) AS rest
          FROM %1$I.edge e JOIN valid_section s USING (edge_id)
          LEFT JOIN %1$I.intersection a ON a.node_id = from_node LEFT JOIN %1$I.intersection b ON b.node_id = to_node
          WHERE NOT ARRAY[from_node, to_node] && ARRAY(SELECT id FROM invalid WHERE relation = 'intersection')
            AND NOT streetgen._lies_on(
                e.geom::bytea, s.surface::bytea, coalesce(a.surface, s.surface)::bytea,
                    coalesce(b.surface, s.surface)::bytea)
          OFFSET 0) e, ST_Dump(rest) piece,
         LATERAL (SELECT ST_LineInterpolatePoint(piece.geom, 0.5) AS middle, abs(roadway_offset)
             + CASE WHEN contested THEN 1e-5 ELSE 1e-6 END AS off) p
    WHERE ST_Length(piece.geom) > 1e-6
      AND NOT EXISTS (SELECT FROM %1$I.section r WHERE ST_DWithin(surface, middle, off)
          AND (contested OR r.edge_id = e.edge_id))
      AND NOT EXISTS (SELECT FROM %1$I.intersection r WHERE ST_DWithin(surface, middle, off)
          AND (contested OR node_id IN (from_node, to_node)))
      -- Ground may wait for a street that is not made yet.
      AND NOT (contested AND EXISTS (SELECT FROM not_made WHERE ST_DWithin(not_made.geom, middle, half))))$part$),
    (8, 'interconnection', 'with', $part$
lane_node AS MATERIALIZED (
    -- A merging lane ends, or begins, between two nodes.
    SELECT l.lane_id, l.geom, v.along, v.leaves, v.enters FROM %1$I.lane l JOIN %1$I.edge e USING (edge_id)
    JOIN LATERAL (VALUES (true, CASE WHEN l.start_abscissa IS NULL THEN e.from_node END,
            CASE WHEN l.end_abscissa IS NULL THEN e.to_node END),
        (false, CASE WHEN l.end_abscissa IS NULL THEN e.to_node END,
            CASE WHEN l.start_abscissa IS NULL THEN e.from_node END)) v(along, leaves, enters)
        ON l.both_ways OR l.along_axis = v.along
    WHERE l.kind <> 'parking')$part$),
    (9, 'network', 'with', $part$
tolerance AS MATERIALIZED (SELECT value::float8 AS value FROM %1$I.setting WHERE name = 'tolerance')$part$),
    (10, 'network', 'with', $part$
ending AS MATERIALIZED (SELECT node_id, axis_id, geom FROM %1$I.node n
    JOIN LATERAL (SELECT from_node, axis_id FROM %1$I.edge
    UNION ALL SELECT to_node, axis_id FROM %1$I.edge) e(node_id, axis_id) USING (node_id)
    WHERE axis_id IN (SELECT unnest(ARRAY[from_axis, to_axis] || via_axes) FROM %1$I.turn_restriction))$part$),
    (11, 'interconnection', 'with', $part$
decided AS MATERIALIZED (
    SELECT DISTINCT ON (c.interconnection_id) d.*, c.interconnection_id, c.connecting AS was_connecting, c.plausible,
        c.control AS was_control, c.method AS was_method
    FROM %1$I.interconnection_override d JOIN %1$I.edge a ON a.axis_id = d.axis_in
        JOIN %1$I.lane i ON (i.edge_id, i.ordinality) = (a.edge_id, d.lane_in)
    JOIN %1$I.edge b ON b.axis_id = d.axis_out JOIN %1$I.lane o ON (o.edge_id, o.ordinality) = (b.edge_id, d.lane_out)
    JOIN %1$I.interconnection c ON (c.lane_in, c.lane_out) = (i.lane_id, o.lane_id) JOIN %1$I.node n USING (node_id)
        CROSS JOIN tolerance t
    WHERE (d.along_in = c.along_in) IS NOT FALSE AND (d.along_out = c.along_out) IS NOT FALSE
        AND ST_DWithin(d.geom, n.geom, 3 * t.value)
    ORDER BY c.interconnection_id, d.interconnection_override_id DESC)$part$),
    (12, 'lane', 'with', $part$
-- Parts of lanes outside their sections, where nothing was contested.
astray AS MATERIALIZED (
    SELECT l.lane_id, ST_Difference(l.geom, s.surface) AS outside FROM %1$I.lane l JOIN valid_section s USING (edge_id)
    WHERE s.contested_area = 0 AND s.method <> 'crossed_limits'
        AND NOT streetgen._lies_on(l.geom::bytea, s.surface::bytea))$part$),
    (13, 'network', 'with', $part$
listed AS MATERIALIZED (
    SELECT u.axis_id, u.geom, w.*, streetgen.driving_lanes(w.kinds) AS of_kinds FROM used u
        JOIN %1$I.axis a USING (axis_id),
    LATERAL (VALUES (a.kind_forward, a.lane_width_forward, a.turn_forward, a.lanes_forward, u.lanes_forward,
        a.direction = 'reverse'),
                    (a.kind_backward, a.lane_width_backward, a.turn_backward, a.lanes_backward, u.lanes_backward,
                        a.direction = 'direct')) w(kinds, widths, turns, stated, used, closed)
    WHERE coalesce(w.kinds, w.widths, w.turns, w.stated::text) IS NOT NULL)$part$),
    (14, 'interconnection', 'with', $part$
-- Nodes of more pairs of lanes than are made.
busy_node AS MATERIALIZED (
    SELECT node_id, sum(comes) * sum(goes) - CASE WHEN u_turn THEN 0 ELSE sum(comes * goes) END AS pairs
    FROM (SELECT node_id, edge_id, count(*) FILTER (WHERE comes) AS comes, count(*) FILTER (WHERE NOT comes) AS goes
          FROM lane_node l JOIN %1$I.lane USING (lane_id),
              LATERAL (VALUES (l.enters, true), (l.leaves, false)) v(node_id, comes)
          GROUP BY node_id, edge_id) e,
         (SELECT max(value) FILTER (WHERE name = 'interconnections_maximal') AS most, max(value)
             FILTER (WHERE name = 'u_turn') = 'true' AS u_turn FROM %1$I.setting) s
    GROUP BY node_id, u_turn, most HAVING sum(comes) * sum(goes) - CASE WHEN u_turn THEN 0 ELSE sum(comes * goes)
        END > most::float8)$part$),
    (15, 'network', 'with', $part$
degree AS MATERIALIZED (SELECT node_id, count(*) AS degree, max(e_axis) AS of_axis
    FROM (SELECT from_node AS node_id, axis_id AS e_axis FROM %1$I.edge
    UNION ALL SELECT to_node, axis_id FROM %1$I.edge) d GROUP BY node_id)$part$),
    (16, 'surface', 'rule', $part$
SELECT 'error', 'invalid surface', relation, id, ST_Area(surface), surface FROM invalid$part$),
    (17, 'network', 'rule', $part$
SELECT NULL, NULL, NULL, NULL, NULL, NULL WHERE streetgen._tell_check(1, 'overlaps')$part$),
    (18, 'surface', 'rule', $part$
SELECT 'error', 'overlap on one level, m2', relation, id, ST_Area(shared), shared FROM overlap
    WHERE ST_Area(shared) > 0.001$part$),
    (19, 'surface', 'rule', $part$
SELECT 'error', 'node of degree three and more without an intersection', 'node', n.node_id, d.degree, n.geom
    FROM %1$I.node n JOIN degree d USING (node_id) LEFT JOIN %1$I.intersection i USING (node_id) WHERE d.degree >= 3
        AND (i.node_id IS NULL OR ST_IsEmpty(i.surface) AND i.contested_area = 0)$part$),
    (20, 'network', 'rule', $part$
SELECT 'error', 'node without an edge', 'node', n.node_id, 0, n.geom FROM %1$I.node n
    WHERE NOT EXISTS (SELECT FROM degree d WHERE d.node_id = n.node_id)$part$),
    (21, 'surface', 'rule', $part$
SELECT 'error', 'edge without its two limits', 'edge', e.edge_id, count(l.edge_id), e.geom FROM %1$I.edge e
    LEFT JOIN %1$I.section_limit l USING (edge_id) GROUP BY e.edge_id HAVING count(l.edge_id) <> 2$part$),
    (22, 'surface', 'rule', $part$
SELECT 'error', 'edge without a section', 'edge', e.edge_id, 0, e.geom FROM %1$I.edge e
    WHERE NOT EXISTS (SELECT FROM %1$I.section s WHERE s.edge_id = e.edge_id)$part$),
    (23, 'network', 'rule', $part$
SELECT NULL, NULL, NULL, NULL, NULL, NULL WHERE streetgen._tell_check(2, 'edges on the roadway')$part$),
    (24, 'surface', 'rule', $part$
SELECT 'error', 'edge outside the roadway, m', 'edge', edge_id, length, geom FROM bare$part$),
    (25, 'surface', 'rule', $part$
SELECT 'error', 'limits out of order', 'edge', a.edge_id, a.abscissa - b.abscissa, a.geom
    FROM %1$I.section_limit a JOIN %1$I.section_limit b USING (edge_id) WHERE a.which = 'start' AND b.which = 'end'
        AND a.abscissa > b.abscissa + 1e-6$part$),
    (26, 'interconnection', 'rule', $part$
SELECT NULL, NULL, NULL, NULL, NULL, NULL WHERE streetgen._tell_check(3, 'interconnections')$part$),
    (27, 'interconnection', 'rule', $part$
SELECT 'error', 'interconnection off its lanes, m', 'interconnection', interconnection_id, off, geom FROM (
    SELECT c.interconnection_id, c.geom,
        greatest(ST_Distance(ST_StartPoint(c.geom), CASE WHEN c.along_in THEN ST_EndPoint(i.geom)
        ELSE ST_StartPoint(i.geom) END),
                                                  ST_Distance(ST_EndPoint(c.geom), CASE WHEN c.along_out
                                                      THEN ST_StartPoint(o.geom) ELSE ST_EndPoint(o.geom) END)) AS off
    FROM %1$I.interconnection c JOIN %1$I.lane i ON i.lane_id = c.lane_in JOIN %1$I.lane o ON o.lane_id = c.lane_out) p
        WHERE off > 0.001$part$),
    (28, 'interconnection', 'rule', $part$
SELECT 'notice', 'lane without a plausible way on', 'lane', l.lane_id, d.degree, l.geom FROM lane_node l
    JOIN degree d ON d.node_id = l.enters
    WHERE d.degree > 1 AND NOT EXISTS (SELECT FROM %1$I.interconnection c
        WHERE (c.lane_in, c.along_in) = (l.lane_id, l.along) AND c.plausible)
        AND d.node_id NOT IN (SELECT node_id FROM busy_node)$part$),
    (29, 'interconnection', 'rule', $part$
SELECT 'notice', 'lane that no plausible way reaches', 'lane', l.lane_id, d.degree, l.geom FROM lane_node l
    JOIN degree d ON d.node_id = l.leaves
    WHERE d.degree > 1 AND NOT EXISTS (SELECT FROM %1$I.interconnection c
        WHERE (c.lane_out, c.along_out) = (l.lane_id, l.along) AND c.plausible)
        AND d.node_id NOT IN (SELECT node_id FROM busy_node)$part$),
    (30, 'interconnection', 'rule', $part$
SELECT 'warning', 'pairs of lanes over interconnections_maximal, none made', 'node', node_id, pairs, n.geom
    FROM busy_node JOIN %1$I.node n USING (node_id)$part$),
    (31, 'network', 'rule', $part$
SELECT 'warning', 'turn restriction without a place', 'turn_restriction', r.turn_restriction_id, 0, r.geom
    FROM %1$I.turn_restriction r
    WHERE EXISTS (SELECT FROM (VALUES (r.from_axis, coalesce(r.via_axes[1], r.to_axis), r.geom),
            (r.via_axes[cardinality(r.via_axes)], r.to_axis, r.to_geom)) m(axis_a, axis_b, geom)
        WHERE m.geom IS NOT NULL AND NOT EXISTS (SELECT FROM tolerance t, ending a JOIN ending b USING (node_id)
            WHERE a.axis_id = m.axis_a AND b.axis_id = m.axis_b AND ST_DWithin(a.geom, m.geom, 3 * t.value)))
        OR EXISTS (SELECT FROM unnest(via_axes) u(axis_id)
            WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = u.axis_id))$part$),
    (32, 'network', 'rule', $part$
SELECT 'warning', 'contradictory turn restrictions', 'turn_restriction', a.turn_restriction_id,
    b.turn_restriction_id, a.geom FROM %1$I.turn_restriction a
    JOIN %1$I.turn_restriction b ON (a.from_axis, a.to_axis, a.kind, b.kind) = (b.from_axis, b.to_axis, 'no', 'only')
        AND (a.turn = b.turn) IS NOT FALSE AND a.via_axes IS NOT DISTINCT FROM b.via_axes CROSS JOIN tolerance t
    WHERE ST_DWithin(a.geom, b.geom, 3 * t.value)$part$),
    (33, 'interconnection', 'rule', $part$
SELECT 'warning', 'interconnection override without a place', 'interconnection_override',
    d.interconnection_override_id, 0, d.geom FROM %1$I.interconnection_override d
    WHERE NOT EXISTS (SELECT FROM %1$I.edge a JOIN %1$I.lane i USING (edge_id)
        JOIN %1$I.interconnection c ON c.lane_in = i.lane_id JOIN %1$I.lane o ON o.lane_id = c.lane_out
        JOIN %1$I.edge b ON b.edge_id = o.edge_id JOIN %1$I.node n ON n.node_id = c.node_id CROSS JOIN tolerance t
        WHERE (a.axis_id, i.ordinality, b.axis_id, o.ordinality) = (d.axis_in, d.lane_in, d.axis_out, d.lane_out)
            AND (d.along_in = c.along_in) IS NOT FALSE
            AND (d.along_out = c.along_out) IS NOT FALSE AND ST_DWithin(d.geom, n.geom, 3 * t.value))$part$),
    (34, 'interconnection', 'rule', $part$
SELECT 'warning', 'stale: an interconnection override changed since', 'interconnection_override',
    interconnection_override_id, 0, geom FROM decided
    WHERE was_method <> 'by_hand' OR was_connecting <> coalesce(connecting, plausible) OR control IS NOT NULL
        AND control::bytea IS DISTINCT FROM was_control::bytea$part$),
    (35, 'network', 'rule', $part$
SELECT NULL, NULL, NULL, NULL, NULL, NULL WHERE streetgen._tell_check(4, 'what changed')$part$),
    (36, 'network', 'rule', $part$
SELECT 'warning', 'stale: rows changed by hand since', 'edge', edge_id, 0, geom FROM %1$I.edge
    WHERE input_hash = streetgen._changed_by_hand()$part$),
    (37, 'network', 'rule', $part$
SELECT 'warning', 'stale: the axis changed since', 'axis', u.axis_id, 0, u.geom FROM used u
    WHERE EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = u.axis_id AND e.input_hash <> u.input_hash
    AND e.input_hash <> streetgen._changed_by_hand())$part$),
    (38, 'network', 'rule', $part$
SELECT 'warning', 'stale: the axis is gone', 'edge', e.edge_id, 0, e.geom FROM %1$I.edge e
    WHERE NOT EXISTS (SELECT FROM used u WHERE u.axis_id = e.axis_id)$part$),
    (39, 'network', 'rule', $part$
SELECT 'warning', 'stale: settings changed since, edges', 'setting', NULL, count(*), NULL FROM %1$I.edge e
    JOIN used u USING (axis_id) WHERE e.setting_hash <> u.setting_hash HAVING count(*) > 0$part$),
    (40, 'network', 'rule', $part$
SELECT 'notice', 'not_generated', 'axis', u.axis_id, ST_Length(u.geom), u.geom FROM used u
    WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = u.axis_id)
    AND NOT EXISTS (SELECT FROM %1$I.report r WHERE r.axis_a = u.axis_id AND r.issue = 'collapsed_axis')$part$),
    (41, 'network', 'rule', $part$
SELECT 'notice', 'kind that is no class, taken as unknown', 'axis', a.axis_id, 0, a.geom FROM %1$I.axis a
    WHERE NOT EXISTS (SELECT FROM %1$I.axis_class c WHERE c.class = a.kind) AND a.kind IS NOT NULL$part$),
    (42, 'network', 'rule', $part$
SELECT 'warning', CASE metres WHEN 0 THEN 'looks like degrees'
    ELSE 'outside the area of use of the SRID, m' END, 'axis', label::bigint, metres, place
    FROM streetgen._misplaced(format('SELECT axis_id AS label, geom FROM %%I.axis', %1$L))$part$),
    (43, 'network', 'rule', $part$
SELECT 'notice', attribute || ' not believed, m', 'axis', axis_id, width, geom
    FROM streetgen._unbelieved(%1$L)
UNION ALL SELECT 'notice', 'roadway_offset beyond half of the width, m', 'axis', axis_id, a.roadway_offset, a.geom
    FROM %1$I.axis a JOIN used u USING (axis_id) WHERE a.roadway_offset <> 0
        AND a.roadway_offset <> u.roadway_offset$part$),
    (44, 'surface', 'rule', $part$
SELECT 'notice', 'contested, m2', 'section', edge_id, contested_area, surface FROM %1$I.section
    WHERE contested_area > 1 AND method <> 'crowded'$part$),
    (45, 'surface', 'rule', $part$
SELECT 'notice', 'contested, m2', 'intersection', node_id, contested_area, surface FROM %1$I.intersection
    WHERE contested_area > 1 AND method <> 'crowded'$part$),
    (46, 'surface', 'rule', $part$
SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'section', edge_id,
    contested_area, geom
    FROM %1$I.section JOIN %1$I.edge USING (edge_id) WHERE method = 'crowded'$part$),
    (47, 'surface', 'rule', $part$
SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'intersection',
    node_id, contested_area, geom
    FROM %1$I.intersection JOIN %1$I.node USING (node_id) WHERE method = 'crowded'$part$),
    (48, 'surface', 'rule', $part$
SELECT 'warning', 'transition_override finds no change of width', 'transition_override',
    o.transition_override_id, 0, u.geom
    FROM %1$I.transition_override o LEFT JOIN used u USING (axis_id) WHERE NOT EXISTS (
        SELECT FROM %1$I.edge e JOIN %1$I.intersection i ON i.node_id = CASE o.which WHEN 'start' THEN e.from_node
            ELSE e.to_node END JOIN degree d USING (node_id)
        WHERE e.axis_id = o.axis_id AND d.degree = 2 AND i.method IN ('transition', 'contested', 'crowded')
            AND NOT EXISTS (SELECT FROM %1$I.edge f WHERE f.axis_id = e.axis_id AND CASE o.which WHEN 'start'
                THEN f.start_abscissa < e.start_abscissa ELSE f.end_abscissa > e.end_abscissa END))$part$),
    (49, 'network', 'rule', $part$
SELECT 'error', 'lanes of the directions do not sum up', 'edge', e.edge_id, e.lane_count, e.geom
    FROM %1$I.edge e
    WHERE e.lane_count <> e.lanes_forward + e.lanes_backward + e.lanes_both$part$),
    (50, 'lane', 'rule', $part$
SELECT NULL, NULL, NULL, NULL, NULL, NULL WHERE streetgen._tell_check(5, 'lanes')$part$),
    (51, 'lane', 'rule', $part$
SELECT 'error', 'edge without a lane', 'edge', e.edge_id, 0, e.geom FROM %1$I.edge e
    WHERE NOT EXISTS (SELECT FROM %1$I.lane l WHERE l.edge_id = e.edge_id)$part$),
    (52, 'lane', 'rule', $part$
SELECT 'error', 'invalid surface', 'lane', lane_id, ST_Area(surface), surface FROM %1$I.lane
    WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)$part$),
    (53, 'lane', 'rule', $part$
SELECT 'warning', 'lane outside its section, m', 'lane', lane_id, ST_Length(outside), outside FROM astray
    WHERE ST_Length(outside) > 0.1$part$),
    (54, 'lane', 'rule', $part$
SELECT 'warning', 'lane override without its lane', 'lane_override', o.lane_override_id, o.abscissa, o.geom
    FROM %1$I.lane_override o
    WHERE NOT EXISTS (SELECT FROM %1$I.edge e JOIN %1$I.lane l USING (edge_id) WHERE e.axis_id = o.axis_id
        AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa AND l.ordinality = o.ordinality)$part$),
    (84, 'lane', 'rule', $part$
SELECT 'warning', 'lane adjacency override without its lanes', 'lane_adjacency_override', o.lane_adjacency_override_id,
    o.abscissa, o.geom FROM %1$I.lane_adjacency_override o
    WHERE NOT EXISTS (SELECT FROM %1$I.edge e JOIN %1$I.lane f USING (edge_id) JOIN %1$I.lane t USING (edge_id)
        WHERE e.axis_id = o.axis_id AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
            AND (f.ordinality, t.ordinality) = (o.lane_from, o.lane_to)
            AND abs(f.lane_position - t.lane_position) = 1 AND f.along_axis = t.along_axis)$part$),
    (80, 'sidewalk', 'rule', $part$
SELECT 'error', 'invalid surface', 'sidewalk', sidewalk_id, ST_Area(surface), surface FROM %1$I.sidewalk
    WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)$part$),
    (81, 'sidewalk', 'rule', $part$
SELECT 'error', 'sidewalk without its kerb', 'sidewalk', s.sidewalk_id, ST_Area(s.surface), s.surface
    FROM %1$I.sidewalk s WHERE NOT EXISTS (SELECT FROM %1$I.kerb k
        WHERE (k.edge_id, k.side, k.part) = (s.edge_id, s.side, s.part)
            AND ST_DWithin(k.geom, s.surface, 0.001))$part$),
    (82, 'network', 'rule', $part$
SELECT 'warning', 'sidewalk override without its edge', 'sidewalk_override', o.sidewalk_override_id, o.width, o.geom
    FROM %1$I.sidewalk_override o WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = o.axis_id
        AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa)$part$),
    (55, 'network', 'rule', $part$
SELECT 'warning', 'section limit override without its limit', 'section_limit_override',
    o.section_limit_override_id, o.abscissa, o.geom FROM %1$I.section_limit_override o
    WHERE NOT EXISTS (SELECT FROM %1$I.edge e JOIN degree d ON d.node_id = CASE o.which WHEN 'start' THEN e.from_node
        ELSE e.to_node END WHERE e.axis_id = o.axis_id AND d.degree > 1
        AND CASE o.which WHEN 'start' THEN o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
            ELSE o.abscissa > e.start_abscissa AND o.abscissa <= e.end_abscissa END)$part$),
    (56, 'surface', 'rule', $part$
SELECT 'warning', 'corner override without its corner', 'corner_override', o.corner_override_id, o.radius,
    o.geom FROM %1$I.corner_override o
    WHERE NOT EXISTS (SELECT FROM tolerance t, %1$I.node n JOIN %1$I.corner c USING (node_id)
        JOIN %1$I.edge a ON a.edge_id = c.edge_a JOIN %1$I.edge b ON b.edge_id = c.edge_b
        WHERE (a.axis_id, b.axis_id) = (o.axis_a, o.axis_b) AND c.method <> 'transition'
            AND ST_DWithin(n.geom, o.geom, 3 * t.value))$part$),
    (57, 'network', 'rule', $part$
SELECT 'warning', 'kerb point override without its axis', 'kerb_point_override', o.kerb_point_override_id,
    o.width, o.geom FROM %1$I.kerb_point_override o
    WHERE NOT EXISTS (SELECT FROM used u WHERE u.axis_id = o.axis_id)$part$),
    (67, 'network', 'rule', $part$
SELECT 'warning', 'control point off all axes', 'control_point', p.control_point_id, 0, p.geom
    FROM %1$I.control_point p WHERE NOT EXISTS (SELECT FROM %1$I.axis a WHERE a.axis_id = p.axis_id)$part$),
    (58, 'lane', 'rule', $part$
SELECT 'notice', 'narrow lane, m', 'lane', l.lane_id, l.width, l.geom
    FROM %1$I.lane l, (SELECT value::float8 AS least FROM %1$I.setting WHERE name = 'lane_width_minimal') s
    WHERE l.kind IN ('general', 'bus') AND l.width < s.least - 1e-6$part$),
    (59, 'network', 'rule', $part$
SELECT 'notice', 'lanes for both directions of a one-way street, not taken', 'axis', axis_id, lanes_both,
    geom FROM %1$I.axis WHERE direction <> 'both' AND lanes_both > 0$part$),
    (60, 'network', 'rule', $part$
SELECT 'notice', 'lane_count is not that of the directions, which count', 'axis', a.axis_id, a.lane_count,
    a.geom FROM %1$I.axis a JOIN used u USING (axis_id)
    WHERE a.lane_count <> u.lane_count$part$),
    (61, 'network', 'rule', $part$
SELECT 'notice', 'lanes against a one-way street, not taken', 'axis', axis_id, stated, geom FROM listed
    WHERE closed AND stated > 0 AND kinds IS NULL$part$),
    (62, 'network', 'rule', $part$
SELECT 'notice', 'number of lanes is not that of their kinds, which count', 'axis', axis_id, stated, geom
    FROM listed WHERE stated <> of_kinds$part$),
    (63, 'network', 'rule', $part$
SELECT 'notice', what || ' are not those of all lanes, not taken', 'axis', axis_id,
    cardinality(string_to_array(list, '|')), geom
    FROM listed, LATERAL (VALUES ('widths', widths), ('turns', turns)) v(what, list)
    WHERE cardinality(string_to_array(list, '|')) NOT IN (used, coalesce(cardinality(string_to_array(kinds, '|')),
        used))$part$),
    (70, 'roundabout', 'rule', $part$
SELECT 'error', 'ring of a roundabout is not closed', 'roundabout', r.roundabout_id, count(n.edge_id), r.geom
    FROM %1$I.roundabout r LEFT JOIN %1$I.roundabout_edge n USING (roundabout_id)
    GROUP BY r.roundabout_id
    HAVING NOT ST_IsClosed(r.geom) OR count(n.edge_id) <> coalesce(max(n.ordinality), -1)$part$),
    (71, 'roundabout', 'rule', $part$
SELECT 'warning', 'traffic of a source against a roundabout', 'edge', e.edge_id, e.lane_count, e.geom
    FROM %1$I.roundabout r JOIN %1$I.roundabout_edge n USING (roundabout_id)
        JOIN %1$I.edge e ON e.edge_id = n.edge_id
    WHERE r.accepted AND CASE WHEN n.along_axis THEN lanes_backward ELSE lanes_forward END > 0
        -- Between two faces traffic goes as the axis says.
        AND NOT EXISTS (SELECT FROM %1$I.roundabout_edge o JOIN %1$I.roundabout p USING (roundabout_id)
            WHERE o.edge_id = n.edge_id AND o.along_axis <> n.along_axis AND p.accepted)$part$),
    (72, 'roundabout', 'rule', $part$
SELECT 'warning', 'arm of a roundabout that nobody may enter or leave', 'edge', e.edge_id, e.lane_count, e.geom
    FROM %1$I.roundabout r JOIN %1$I.roundabout_arm n USING (roundabout_id)
        JOIN %1$I.edge e ON e.edge_id = n.edge_id
    WHERE r.accepted AND lanes_forward + lanes_backward + lanes_both = 0$part$),
    (73, 'network', 'rule', $part$
SELECT 'warning', 'roundabout override without its ring', 'roundabout_override', o.roundabout_override_id, 0, o.geom
    FROM %1$I.roundabout_override o WHERE NOT streetgen._has_ring(%1$L, o.geom)$part$),
    (64, 'network', 'rule', $part$
SELECT 'notice', issue, 'axis', axis_a, measure, geom FROM %1$I.report$part$),
    (66, 'interconnection', 'rule', $part$
SELECT 'notice', 'path with a corner that no car drives, the only way', 'interconnection', interconnection_id, angle,
    geom FROM %1$I.interconnection WHERE plausible AND reason = 'not_drivable'$part$),
    (70, 'kerb', 'rule', $part$
SELECT 'error', 'kerb does not end where another one begins', 'kerb', k.kerb_id, 0, ST_EndPoint(k.geom)
    -- OFFSET: each looks up what lies at its end; a join by level would pair all with all.
    FROM %1$I.kerb k WHERE NOT EXISTS (SELECT FROM %1$I.kerb n WHERE n.level = k.level
        AND n.geom && ST_Expand(ST_EndPoint(k.geom), 1e-5)
        AND ST_DWithin(ST_StartPoint(n.geom), ST_EndPoint(k.geom), 1e-5) OFFSET 0)$part$),
    (71, 'block', 'rule', $part$
SELECT 'error', 'invalid surface', 'block', block_id, ST_Area(surface), surface FROM %1$I.block
    WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)$part$),
    (72, 'block', 'rule', $part$
SELECT 'error', 'block without an edge about it', 'block', block_id, ST_Area(surface), surface FROM %1$I.block b
    WHERE NOT EXISTS (SELECT FROM %1$I.block_edge e WHERE e.block_id = b.block_id)$part$),
    (73, 'block', 'rule', $part$
SELECT 'error', 'side of an edge that faces no block nor the outside', 'edge', e.edge_id, 0, e.geom
    FROM %1$I.edge e, (SELECT value::integer AS level FROM %1$I.setting WHERE name = 'ground_level') g
    WHERE e.level = g.level AND (SELECT count(DISTINCT side) FROM %1$I.block_edge b
        WHERE b.edge_id = e.edge_id) < 2$part$),
    (74, 'block', 'rule', $part$
SELECT 'notice', 'kerbs of a block cross or are missing', 'block', block_id, ST_Area(surface), surface
    FROM %1$I.block WHERE method = 'robust_fallback'$part$),
    (75, 'block', 'rule', $part$
SELECT 'warning', 'block override on no block', 'block_override', o.block_override_id, 0, o.geom
    FROM %1$I.block_override o WHERE NOT EXISTS (SELECT FROM %1$I.block b WHERE b.surface && o.geom
        AND ST_Intersects(b.surface, o.geom))$part$),
    (65, 'network', 'rule', $part$
SELECT 'warning', 'driving side is not that of the one-way axes', 'setting', NULL::bigint,
    sum(CASE side WHEN 'left' THEN count_left ELSE count_right END)::float8, NULL::geometry
    FROM streetgen.driving_side(%1$L) WHERE streetgen._found_driving_side(%1$L) <> streetgen._driving_side(%1$L)
        AND side IS NOT NULL HAVING count(*) > 0$part$),
    (70, 'alignment', 'with', $part$
-- The ends of each edge in the direction of its road.
member AS MATERIALIZED (
    SELECT m.road_id, m.position, m.edge_id, m.start_abscissa, e.end_abscissa - e.start_abscissa AS length, e.geom,
        e.speed, CASE WHEN along_road THEN from_node ELSE to_node END AS first_node,
        CASE WHEN along_road THEN to_node ELSE from_node END AS last_node
    FROM %1$I.road_edge m JOIN %1$I.edge e USING (edge_id))$part$),
    (71, 'alignment', 'rule', $part$
SELECT 'error', 'edge in no road', 'edge', edge_id, 0, e.geom FROM %1$I.edge e
    WHERE NOT EXISTS (SELECT FROM %1$I.road_edge m WHERE m.edge_id = e.edge_id)$part$),
    (72, 'alignment', 'rule', $part$
SELECT 'error', 'edges of a road do not follow each other', 'road', m.road_id, m.position, m.geom
    FROM member m LEFT JOIN member b ON (b.road_id, b.position) = (m.road_id, m.position - 1)
        LEFT JOIN %1$I.road r ON r.road_id = m.road_id AND m.position = 1
    WHERE m.first_node IS DISTINCT FROM coalesce(b.last_node, r.from_node)$part$),
    (73, 'alignment', 'rule', $part$
SELECT 'error', 'road goes through a node of other degree than two', 'road', m.road_id, d.degree, n.geom
    FROM member m JOIN degree d ON d.node_id = m.first_node JOIN %1$I.node n ON n.node_id = m.first_node
    WHERE m.position > 1 AND d.degree <> 2 AND NOT streetgen._is_ramp(%1$L, d.node_id)$part$),
    (74, 'alignment', 'rule', $part$
SELECT 'error', 'road ends at a node of degree two', 'road', r.road_id, 2, n.geom
    FROM %1$I.road r JOIN degree d ON d.node_id IN (r.from_node, r.to_node) JOIN %1$I.node n USING (node_id)
    WHERE NOT r.closed AND d.degree = 2$part$),
    (75, 'alignment', 'rule', $part$
SELECT 'error', 'length of a road is not that of its edges, m', 'road', r.road_id, r.length - m.length, r.geom
    FROM %1$I.road r LEFT JOIN (SELECT road_id, sum(length) AS length FROM member GROUP BY road_id) m USING (road_id)
    WHERE abs(r.length - m.length) <= 1e-6 IS NOT TRUE$part$),
    (76, 'alignment', 'rule', $part$
-- Edges that turn by more than a right angle, or change their level, meet at a corner.
SELECT 'error', 'gap of tangent, degrees', 'road', r.road_id, degrees(k.angle), k.place::geometry
    FROM %1$I.road r, LATERAL streetgen._arc_road_kinks(r.geom) k
    WHERE NOT EXISTS (SELECT FROM member m JOIN %1$I.node n ON n.node_id = m.first_node
        WHERE m.road_id = r.road_id AND ST_DWithin(n.geom, k.place::geometry, 1e-3))$part$),
    (77, 'network', 'rule', $part$
SELECT 'error', 'smoothed line off its axis, m', 'edge', e.edge_id, off, e.geom
    FROM %1$I.edge e JOIN used u USING (axis_id), (SELECT max(value) FILTER (WHERE name = 'smoothing') AS smoothing,
            (max(value) FILTER (WHERE name = 'smoothing_shift'))::float8
                + 3 * (max(value) FILTER (WHERE name = 'tolerance'))::float8 AS bound FROM %1$I.setting
            WHERE name IN ('smoothing', 'smoothing_shift', 'tolerance')) s,
        LATERAL (SELECT ST_HausdorffDistance(ST_Force2D(e.geom), ST_LineSubstring(ST_Force2D(u.geom),
            least(e.start_abscissa / ST_Length2D(u.geom), 1), least(e.end_abscissa / ST_Length2D(u.geom), 1)))
            AS off) o
    WHERE smoothing = 'arcs' AND e.curve IS NOT NULL AND off > bound AND NOT EXISTS (
        SELECT FROM %1$I.road_override o WHERE o.axis_id = e.axis_id)$part$),
    (78, 'network', 'rule', $part$
SELECT 'warning', 'road override without its bend', 'road_override', o.road_override_id, o.abscissa, o.geom
    FROM %1$I.road_override o WHERE NOT EXISTS (SELECT FROM used u JOIN %1$I.edge e USING (axis_id), LATERAL
        streetgen._bend_of(u.geom, ST_LineInterpolatePoint(ST_Force2D(u.geom),
            least(o.abscissa / ST_Length2D(u.geom), 1)), e.start_abscissa, e.end_abscissa) b
        WHERE u.axis_id = o.axis_id AND abs(b.abscissa - o.abscissa) <= 1)$part$),
    (79, 'alignment', 'rule', $part$
SELECT 'notice', 'road with a bend tighter than 5 m, m', 'road', road_id, min(radius),
    ST_Collect(centre) FROM %1$I.road_arc WHERE radius < 5 GROUP BY road_id$part$),
    (80, 'alignment', 'rule', $part$
SELECT 'notice', 'road with a bend slower than its speed, km/h', 'road', a.road_id, min(a.speed_limit),
    ST_Collect(a.centre) FROM %1$I.road_arc a
    JOIN (SELECT road_id, max(speed) AS speed FROM member GROUP BY road_id) m USING (road_id)
    WHERE a.speed_limit < m.speed GROUP BY a.road_id$part$) $$;
COMMENT ON FUNCTION streetgen._check_part() IS
    'The parts of the query of streetgen.check_model in their order, over a model %1$I. subject: the part stands only '
    'in models that compute it. kind with: a query that rules share, after WITH; kind rule: the rows of one rule '
    '(severity, rule, relation, id, measure, geom), or a step of the progress, without a row.';

CREATE OR REPLACE FUNCTION streetgen._check_statement(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT format('WITH ' || string_agg(query, ',' ORDER BY place) FILTER (WHERE kind = 'with')
        || string_agg(query, E'\nUNION ALL' ORDER BY place) FILTER (WHERE kind = 'rule'), model)
    FROM (SELECT * FROM (SELECT * FROM streetgen._check_part() UNION ALL SELECT * FROM streetgen._height_check_part()
                UNION ALL SELECT * FROM streetgen._junction_check_part()
                UNION ALL SELECT * FROM streetgen._ramp_check_part()
                UNION ALL SELECT * FROM streetgen._signal_check_part()
                UNION ALL SELECT * FROM streetgen._object_check_part())
            part WHERE subject = ANY (streetgen._subjects(model))
        UNION ALL SELECT 1000, 'design', 'rule', streetgen._design_check() WHERE streetgen._has_design(model)) p $$;
COMMENT ON FUNCTION streetgen._check_statement(name) IS
    'The query of streetgen.check_model for the subjects that a model computes, and its design.';
