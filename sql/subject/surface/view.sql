-- The roadway of a model as one layer, and intersections that touch.

CREATE OR REPLACE FUNCTION streetgen._make_surface_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW intersection_group WITH (security_invoker = true) AS
    WITH RECURSIVE crossed AS (
        SELECT from_node, to_node FROM edge JOIN section s USING (edge_id)
        WHERE s.method = 'crossed_limits' AND from_node IN (SELECT node_id FROM intersection)
            AND to_node IN (SELECT node_id FROM intersection)
    ), touching AS (
        SELECT from_node AS node_id, array_agg(to_node) AS others
        FROM (TABLE crossed UNION ALL SELECT to_node, from_node FROM crossed) c GROUP BY from_node
    ), joined AS (
        SELECT node_id, node_id AS other FROM touching
        UNION SELECT j.node_id, unnest(others) FROM joined j JOIN touching t ON t.node_id = j.other
    )
    SELECT node_id, i.level, coalesce(j.group_id, node_id) AS group_id
    FROM intersection i LEFT JOIN (SELECT node_id, min(other) AS group_id FROM joined GROUP BY node_id) j
        USING (node_id);
    CREATE OR REPLACE VIEW roadway WITH (security_invoker = true) AS
    SELECT 2 * edge_id AS roadway_id, 'section' AS part, edge_id, NULL::bigint AS node_id, axis_id, name, kind,
        importance,
        e.level, e.width, e.lane_count, surface
    FROM section JOIN edge e USING (edge_id) LEFT JOIN (SELECT axis_id, name, kind FROM axis) a
        USING (axis_id) WHERE NOT ST_IsEmpty(surface)
    UNION ALL
    SELECT 2 * node_id + 1, 'intersection', NULL, node_id, axis_id, name, kind, importance, level, width, lane_count,
        surface
    FROM intersection i LEFT JOIN LATERAL (
        SELECT axis_id, importance, greatest(CASE node_id WHEN from_node THEN width END, CASE node_id WHEN to_node
            THEN width_end END) AS width, lane_count
        FROM edge WHERE from_node = node_id OR to_node = node_id ORDER BY importance, width DESC, axis_id, edge_id
            LIMIT 1) first ON true
    LEFT JOIN (SELECT axis_id, name, kind FROM axis) a USING (axis_id) WHERE NOT ST_IsEmpty(surface);
    COMMENT ON VIEW roadway
        IS 'The polygons of the roads: sections and intersections, which tile the ground of each level without '
        'overlap. An intersection is named after its first edge: the most important, then the widest, then that of '
        'the smallest axis_id';
    COMMENT ON COLUMN roadway.roadway_id IS
        'unique and kept as long as the edge or node: twice edge_id, or twice node_id and one';
    COMMENT ON COLUMN roadway.part IS 'section or intersection';
    COMMENT ON COLUMN roadway.edge_id IS 'the edge of a section';
    COMMENT ON COLUMN roadway.node_id IS 'the node of an intersection';
    COMMENT ON COLUMN roadway.axis_id IS 'axis of the edge, or of the first edge of the node';
    COMMENT ON COLUMN roadway.name IS 'name of the axis';
    COMMENT ON COLUMN roadway.kind IS 'kind of the axis';
    COMMENT ON COLUMN roadway.importance IS 'importance of the edge, 1 the highest';
    COMMENT ON COLUMN roadway.level IS 'level of the surface';
    COMMENT ON COLUMN roadway.width IS
        'width of the edge kerb to kerb, metres: of a section at its start, of an intersection at its node';
    COMMENT ON COLUMN roadway.lane_count IS 'general, bus and carpool lanes of the edge';
    COMMENT ON COLUMN roadway.surface IS 'roadway, never empty';
    PERFORM streetgen._make_paving_view(model);
    COMMENT ON VIEW intersection_group
        IS 'Intersections that touch without a section between, over edges of crossed limits, as groups: the '
        'smallest node of each names it';
    COMMENT ON COLUMN intersection_group.node_id IS 'the node of the intersection';
    COMMENT ON COLUMN intersection_group.level IS 'level of the intersection';
    COMMENT ON COLUMN intersection_group.group_id IS 'the smallest node of the intersection and its neighbours';
END $$;
COMMENT ON FUNCTION streetgen._make_surface_views(name) IS
    'Makes the views roadway, paving and intersection_group of a model, again and again.';
