-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{height
bridge_edge AS MATERIALIZED (
    SELECT edge_id, from_node, to_node, streetgen._off_ground(level, geom) AS off_ground FROM new_edge
    WHERE streetgen._off_ground(level, geom) <> 0),
-- A bridge ends where it meets an edge that is none.
bridge_end AS MATERIALIZED (
    WITH place AS MATERIALIZED (SELECT from_node AS node_id FROM bridge_edge UNION SELECT to_node FROM bridge_edge),
    beside AS (SELECT p.node_id, e.edge_id, e.level, e.geom FROM place p, LATERAL (
        SELECT edge_id, level, geom FROM {model}.edge WHERE from_node = p.node_id
        UNION ALL SELECT edge_id, level, geom FROM {model}.edge WHERE to_node = p.node_id) e)
    SELECT node_id FROM (
        SELECT from_node AS node_id, level, geom FROM new_edge JOIN place ON node_id = from_node
        UNION ALL SELECT to_node, level, geom FROM new_edge JOIN place ON node_id = to_node
        UNION ALL SELECT node_id, level, geom FROM beside WHERE edge_id NOT IN (SELECT edge_id FROM new_edge)
            AND edge_id NOT IN (SELECT edge_id FROM old_edge WHERE written)) e
    GROUP BY node_id HAVING count(DISTINCT streetgen._off_ground(level, geom)) > 1),
profile_edges AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (e.edge_id, e.from_node, e.to_node,
        streetgen._ground_of('{model_name}', e.geom, f.geom, t.geom)::bytea,
        streetgen._by_speed((v ->> 'grade_usual')::jsonb, e.speed) / 100,
        streetgen._by_speed((v ->> 'grade_maximal')::jsonb, e.speed) / 100, e.speed,
        (v ->> 'bridge_rise')::float8 * coalesce(b.off_ground, 0),
        e.from_node IN (SELECT node_id FROM bridge_end), e.to_node IN (SELECT node_id FROM bridge_end)
        )::streetgen.profile_edge), ARRAY[]::streetgen.profile_edge[]) AS list
    FROM setting, new_edge e JOIN new_node f ON f.node_id = e.from_node JOIN new_node t ON t.node_id = e.to_node
        LEFT JOIN bridge_edge b USING (edge_id)),
profile_lifts AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (o.edge_above, o.abscissa_above, o.edge_below, o.abscissa_below, o.clearance,
        o.sinks)::streetgen.profile_lift), ARRAY[]::streetgen.profile_lift[]) AS list FROM found_overpass o),
profile_heights AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (e.edge_id, (o.abscissa - e.start_abscissa) / (e.end_abscissa - e.start_abscissa)
        * ST_Length2D(e.geom), o.height)::streetgen.profile_height), ARRAY[]::streetgen.profile_height[]) AS list
    FROM {model}.height_override o JOIN new_edge e ON e.axis_id = o.axis_id
        AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa),
profile_gone AS MATERIALIZED (
    SELECT ARRAY(SELECT edge_id FROM old_edge WHERE written EXCEPT SELECT edge_id FROM new_edge) AS list)

--{height_chain
SELECT t.axis_id, 0::bigint AS chain FROM touched t JOIN {model}.profile p USING (edge_id)
    WHERE p.method <> 'ground' OR p.tied_from OR p.tied_to
UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.overpass o ON o.edge_above = t.edge_id
UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.overpass o ON o.edge_below = t.edge_id
-- The ground at a node without a height is that of an axis near (streetgen._node_ground).
UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.edge e USING (edge_id)
    JOIN {model}.node n ON ST_DWithin(n.geom, e.geom, 500) WHERE ST_Z(n.geom) NOT BETWEEN -500 AND 10000
UNION SELECT a.axis_id, 0 FROM {model}.axis a JOIN {model}.node n ON ST_DWithin(n.geom, a.geom, 500)
    WHERE a.axis_id = ANY (axes) AND ST_Z(n.geom) NOT BETWEEN -500 AND 10000
UNION SELECT axis_id, 0 FROM {model}.height_override WHERE axis_id = ANY (axes)
UNION SELECT axis_id, 0 FROM {model}.axis WHERE axis_id = ANY (axes) AND level <> 0
UNION SELECT a.axis_id, 0 FROM {model}.axis a JOIN {model}.axis b ON ST_Crosses(a.geom, b.geom)
    WHERE a.axis_id = ANY (axes) AND (a.level <> b.level
        -- Axes of one level cross where they do not both have a vertex, which would be a node.
        OR EXISTS (SELECT FROM {model}.setting s, ST_Dump(ST_Intersection(a.geom, b.geom)) p
            WHERE s.name = 'tolerance' AND NOT (ST_DWithin(p.geom, ST_Points(a.geom), s.value::float8)
                AND ST_DWithin(p.geom, ST_Points(b.geom), s.value::float8))))
