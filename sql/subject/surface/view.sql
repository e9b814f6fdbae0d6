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
        SELECT from_node, to_node FROM crossed UNION SELECT to_node, from_node FROM crossed
    ), joined AS (
        SELECT node_id, node_id AS other FROM intersection
        UNION SELECT j.node_id, t.to_node FROM joined j JOIN touching t ON t.from_node = j.other
    )
    SELECT node_id, i.level, min(j.other) AS group_id FROM joined j JOIN intersection i USING (node_id)
        GROUP BY node_id, i.level;
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
    COMMENT ON VIEW intersection_group
        IS 'Intersections that touch without a section between, over edges of crossed limits, as groups: the '
        'smallest node of each names it';
END $$;
COMMENT ON FUNCTION streetgen._make_surface_views(name) IS
    'Makes the views roadway and intersection_group of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._surface_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ VALUES
    ('roadway'::name, 'roadway_id'::name,
        'unique and kept as long as the edge or node: twice edge_id, or twice node_id and one'),
    ('roadway', 'part', 'section or intersection'),
    ('roadway', 'edge_id', 'the edge of a section'),
    ('roadway', 'node_id', 'the node of an intersection'),
    ('roadway', 'axis_id', 'axis of the edge, or of the first edge of the node'),
    ('roadway', 'name', 'name of the axis'),
    ('roadway', 'kind', 'kind of the axis'),
    ('roadway', 'importance', 'importance of the edge, 1 the highest'),
    ('roadway', 'level', 'level of the surface'),
    ('roadway', 'width',
        'width of the edge kerb to kerb, metres: of a section at its start, of an intersection at its node'),
    ('roadway', 'lane_count', 'general and bus lanes of the edge'),
    ('roadway', 'surface', 'roadway, never empty'),
    ('intersection_group', 'node_id', 'the node of the intersection'),
    ('intersection_group', 'level', 'level of the intersection'),
    ('intersection_group', 'group_id', 'the smallest node of the intersection and its neighbours') $$;
COMMENT ON FUNCTION streetgen._surface_column() IS 'The columns of these views, and what each is.';
