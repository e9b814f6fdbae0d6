-- Rules of check_model for the network.

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
    WITH used AS MATERIALIZED (SELECT axis_id, geom, width, width_end, roadway_offset, input_hash,
        setting_hash FROM axis_used),
    ending AS MATERIALIZED (SELECT node_id, axis_id, geom FROM node n
        JOIN LATERAL (SELECT from_node, axis_id FROM edge
        UNION ALL SELECT to_node, axis_id FROM edge) e(node_id, axis_id) USING (node_id)
        WHERE axis_id IN (SELECT unnest(ARRAY[from_axis, to_axis] || via_axes) FROM turn_restriction)),
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
        AND NOT EXISTS (SELECT FROM report r WHERE r.axis_a = u.axis_id
            AND r.issue IN ('collapsed_axis', 'axis lies on another'))
    UNION ALL
    SELECT 'notice', 'kind that is no class, taken as unknown', 'axis', a.axis_id, 0, a.geom FROM axis a
        WHERE NOT EXISTS (SELECT FROM axis_class c WHERE c.class = a.kind) AND a.kind IS NOT NULL
    UNION ALL
    SELECT 'warning', CASE metres WHEN 0 THEN 'looks like degrees'
        ELSE 'outside the area of use of the SRID, m' END, 'axis', label::bigint, metres, place
        FROM streetgen._misplaced(format('SELECT axis_id AS label, geom FROM %I.axis', model))
    UNION ALL
    SELECT 'notice', CASE WHEN too_small AND attribute = 'width' THEN 'width too small, m'
        WHEN too_small THEN 'width_end too small, m' WHEN attribute = 'width' THEN 'width not believed, m'
        ELSE 'width_end not believed, m' END, 'axis', axis_id, width, geom
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
        WHERE NOT EXISTS (SELECT FROM used u WHERE u.axis_id = o.axis_id
            AND ST_DWithin(u.geom, o.geom, o.width / 2 + tolerance)
            AND streetgen._metres_beyond(ST_Force2D(u.geom), o.geom) <= tolerance)
    UNION ALL
    SELECT * FROM streetgen._contradictions(model)
    UNION ALL
    SELECT 'notice', issue, 'axis', axis_a, measure, geom FROM report
    UNION ALL
    SELECT 'warning', 'driving side is not that of the one-way axes', 'setting', NULL::bigint,
        sum(CASE side WHEN 'left' THEN count_left ELSE count_right END)::float8, NULL::geometry
        FROM streetgen.driving_side(model) WHERE streetgen._found_driving_side(model) <> streetgen._driving_side(model)
            AND side IS NOT NULL HAVING count(*) > 0
    UNION ALL
    SELECT 'warning', 'control point off all axes', 'control_point', p.control_point_id, 0, p.geom
        FROM control_point p WHERE NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = p.axis_id
            AND streetgen._metres_beyond(ST_Force2D(a.geom), p.geom) <= coalesce(p.axis_distance, 0) + tolerance)
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
    SELECT 'notice', 'roundabout tag that is not known', 'axis', a.axis_id, NULL, a.geom
        FROM axis a WHERE roundabout_tag IS NOT NULL AND NOT streetgen._names_ring(roundabout_tag)
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

CREATE OR REPLACE FUNCTION streetgen._network_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'network', $part$
    SELECT 'axes', count(*)::numeric, NULL::text FROM %1$I.axis$part$),
    (2, 'network', $part$
    SELECT 'axes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.axis$part$),
    (3, 'network', $part$
    SELECT 'nodes', count(*), NULL FROM %1$I.node$part$),
    (4, 'network', $part$
    SELECT 'edges', count(*), NULL FROM %1$I.edge$part$),
    (5, 'network', $part$
    (SELECT 'edges with estimated ' || what, count(*), NULL FROM %1$I.edge, unnest(estimated) what
        GROUP BY what ORDER BY what)$part$),
    (99, 'network', $part$
    (SELECT 'reports, ' || issue, count(*), NULL FROM %1$I.report GROUP BY issue ORDER BY issue)$part$) $$;
COMMENT ON FUNCTION streetgen._network_summary() IS 'What streetgen.summary counts of nodes, edges and reports.';

CREATE OR REPLACE FUNCTION streetgen._network_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('edge'::name, 'e.axis_id = ($1).axis_id'),
    ('node', 'e.from_node = ($1).node_id OR e.to_node = ($1).node_id') $$;
COMMENT ON FUNCTION streetgen._network_marked_by_hand() IS
    'The edges that a change of nodes and edges by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('node without an edge', 'the node is a leftover', '`generate`'),
    ('lanes of the directions do not sum up',
        '`edge.lane_count` is not the sum of lanes along, against and for both directions',
        '`generate`'),
    ('turn restriction without a place', 'its two axes meet at no node near it, or an axis that it leads via is gone',
        'move or delete the restriction'),
    ('contradictory turn restrictions', 'one forbids what another demands', 'delete one of both'),
    ('stale: rows changed by hand since', 'somebody other than a run changed or deleted derived rows of the edge',
        '`generate`; decide by hand in the edit views'),
    ('stale: the axis changed since', 'the streets do not know the edit yet', '`generate`'),
    ('stale: the axis is gone', 'results of a deleted axis are left', '`generate`'),
    ('stale: settings changed since, edges', 'so many edges were made with other settings', '`generate` over all'),
    ('not_generated', 'the axis has no streets yet', '`generate`'),
    ('kind that is no class, taken as unknown', '`axis.kind` stands in no row of `axis_class`',
        'add the class or correct the kind'),
    ('width not believed, m',
        'the width of a source is more than its lanes can need, and the street gets an estimated one',
        'put the width by hand, correct the lanes, or change setting `max_width_per_lane`'),
    ('width_end not believed, m', 'the same of the width at the end of the axis', 'the same'),
    ('width too small, m',
        'no car has room on each lane, so that the roadway is as wide as setting `lane_width_minimal` for each of them',
        'put the width by hand, or correct the lanes'),
    ('width_end too small, m', 'the same of the width at the end of the axis', 'the same'),
    ('roadway_offset beyond half of the width, m', 'the roadway would lie beside its axis, and lies at it instead',
        'correct `roadway_offset`, or widen the axis'),
    ('driving side is not that of the one-way axes',
        'one-way rings and pairs of carriageways run as they do where one drives on the other side',
        '`streetgen.set(model, ''driving_side'', …)`, or turn the axes round'),
    ('looks like degrees', 'the axes are shorter than a metre, in the mean, where degrees would lie',
        'transform the axes to the SRID of the model'),
    ('outside the area of use of the SRID, m',
        'the farthest axis lies so far outside the area that the reference is made for',
        'choose the SRID of the place, or correct the coordinates'),
    ('section limit override without its limit', 'no intersection ends there', 'delete the override'),
    ('control point off all axes', 'it stands on no roadway, or its axis is gone or ends before it',
        'move it onto a street, or delete it'),
    ('kerb point override without its axis', 'the axis is gone, or lies no more beside the point',
        'delete the override, or draw the axis'),
    ('smoothed line off its axis, m',
        'an edge leaves its axis by more than setting smoothing_shift and the tolerance allow',
        '`generate` over all'),
    ('roundabout tag that is not known',
        '`roundabout_tag` says another word than roundabout, circular or Rond-point, and counts for nothing',
        'write one of these words, or empty it'),
    ('road override without its bend', 'the axis has no vertex within 1 m of that place any more',
        'move or delete the override'),
    ('sidewalk override without its edge', 'no edge lies at the place of the override any more',
        'delete the override, or move it to another axis'),
    ('wide_cluster',
        'ends of axes join to a cluster wider than three tolerances; only its coinciding points are one node',
        'move the ends together or apart, or change setting `tolerance`'),
    ('crossing', 'two axes of one level cross without a node',
        'give the axes a common vertex or another level, or set `crossing` to split'),
    ('collapsed_axis', 'an axis is shorter than the tolerance and has no edge',
        'delete the axis, or make `tolerance` smaller'),
    ('axis lies on another',
        'so many metres of the axis lie in the middle half of another street and run along it; they make no street '
        'where the other one leads as well',
        'accept the proposal of view `axis_to_mend`, or delete the axis; without a proposal it alone leads in its '
        'direction, or to another street'),
    ('end of an axis in the roadway of another, without a node',
        'the end misses the other axis by the measure, and no traffic turns there',
        'accept the proposal of view `axis_to_mend`, or set `tolerance` to the measure or more');
