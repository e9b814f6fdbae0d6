-- Nodes that are one junction: the rules of the core over the edges near a change.

CREATE OR REPLACE FUNCTION streetgen._group_junctions(edges streetgen.junction_edge_input[],
    controls streetgen.street_control[], gap float8, extent float8, control_distance float8,
    queue_length float8)
    RETURNS SETOF streetgen.junction_member
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000 ROWS 500 AS 'MODULE_PATHNAME', 'streetgen_group_junctions';
COMMENT ON FUNCTION streetgen._group_junctions(streetgen.junction_edge_input[], streetgen.street_control[], float8,
    float8, float8, float8)
    IS 'The junctions of edges: a row for each node with its junction, named by its smallest node, and the chain of '
        'nodes that the rules would join; a row for each edge with its role in a junction, whether the extent keeps '
        'its nodes apart, and the control points that speak to the traffic which comes to its start and to its end; '
        'a row for each control point that speaks to somebody. gap, extent, control_distance and queue_length in m. '
        'No edges (NULL): no row. Bad geometry, a number out of range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._make_junction_members(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _junction_members(touched bigint[], OUT region bigint[],
        OUT members streetgen.junction_member[])
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        -- The settings bound how far from two nodes lies what joins them.
        rules record;
        near bigint[];
        rings bigint[];
        edges streetgen.junction_edge_input[];
        controls streetgen.street_control[];
        grown bigint[];
    BEGIN
        -- A run over all nodes reads most rows, and a change looks them up by keys: these are other plans.
        IF touched IS NULL THEN
            PERFORM set_config('plan_cache_mode', 'force_custom_plan', true);
        END IF;
        SELECT max(value::float8) FILTER (WHERE name = 'junction_gap') AS gap,
            max(value::float8) FILTER (WHERE name = 'junction_extent') AS extent,
            max(value::float8) FILTER (WHERE name = 'control_distance') AS control_distance,
            max(value::float8) FILTER (WHERE name = 'queue_length') AS queue_length INTO rules
            FROM setting WHERE name IN ('junction_gap', 'junction_extent', 'control_distance', 'queue_length');
        -- With the nodes that they were joined to: mostly the first round finds no others then.
        region := CASE WHEN touched IS NOT NULL THEN ARRAY(
            SELECT unnest(touched) UNION SELECT j.node_id FROM junction_node j WHERE j.junction_id IN (
                SELECT junction_id FROM junction_node WHERE node_id = ANY (touched))) END;
        LOOP
            near := CASE WHEN region IS NULL THEN ARRAY(SELECT edge_id FROM edge) ELSE ARRAY(
                SELECT DISTINCT e.edge_id FROM unnest(region) t(node_id)
                    JOIN node n USING (node_id), LATERAL (
                    SELECT edge_id FROM edge e
                    WHERE e.geom && ST_Expand(n.geom, greatest(rules.extent, rules.control_distance)
                        + 2 * greatest(rules.gap, rules.queue_length)) OFFSET 0) e) END;
            rings := streetgen._edges_on_rings(current_schema(), CASE WHEN region IS NOT NULL THEN near END);
            edges := ARRAY(
                SELECT ROW (e.edge_id, e.axis_id, e.start_abscissa, e.end_abscissa, e.from_node, e.to_node,
                    ST_Force2D(e.geom)::bytea, e.lanes_forward + e.lanes_both > 0, e.lanes_backward + e.lanes_both > 0,
                    coalesce(hashtextextended(lower(a.name), 0), 0),
                    s.method = 'crossed_limits'
                        AND EXISTS (SELECT FROM intersection i WHERE i.node_id = e.from_node OFFSET 0)
                        AND EXISTS (SELECT FROM intersection i WHERE i.node_id = e.to_node OFFSET 0),
                    e.edge_id IN (SELECT unnest(rings)),
                    (SELECT o.inside FROM junction_override o WHERE o.inside IS NOT NULL AND o.axis_id = e.axis_id
                        AND e.edge_id = streetgen._edge_at(current_schema(), o.axis_id, o.geom)
                        ORDER BY o.junction_override_id DESC LIMIT 1), e.importance, e.width,
                    e.width_end)::streetgen.junction_edge_input
                FROM edge e JOIN section s USING (edge_id) LEFT JOIN axis a USING (axis_id)
                WHERE e.edge_id IN (SELECT unnest(near)));
            controls := ARRAY(SELECT ROW (axis_id, abscissa, kind, direction)::streetgen.street_control
                FROM control_point WHERE axis_id IN (SELECT e.axis_id FROM edge e
                    WHERE e.edge_id IN (SELECT unnest(near))) ORDER BY control_point_id);
            members := ARRAY(SELECT g FROM streetgen._group_junctions(edges, controls, rules.gap, rules.extent,
                rules.control_distance, rules.queue_length) g);
            EXIT WHEN touched IS NULL;
            -- All nodes that the rules would join, those that they joined before, and those that lost their junction.
            grown := ARRAY(
                SELECT m.node_id FROM unnest(members) m WHERE m.node_id IS NOT NULL
                    AND m.chain IN (SELECT r.chain FROM unnest(members) r WHERE r.node_id = ANY (region))
                UNION SELECT j.node_id FROM junction_node j WHERE j.junction_id IN (
                    SELECT junction_id FROM junction_node WHERE node_id = ANY (region))
                UNION SELECT m.node_id FROM unnest(members) m WHERE m.node_id <> m.junction_id
                    AND NOT EXISTS (SELECT FROM junction_node j WHERE j.node_id = m.node_id)
                UNION SELECT node_id FROM node WHERE node_id = ANY (region));
            EXIT WHEN grown <@ region AND region <@ grown;
            region := grown;
        END LOOP;
        region := coalesce(region, ARRAY(SELECT node_id FROM node));
    END $body$;
    PERFORM streetgen._own_function(model, '_junction_members(bigint[])',
        'Of nodes touched by a change (NULL: all) those whose junctions may become others, and the junctions of these '
        'nodes and the roles of their edges');
END $$;
COMMENT ON FUNCTION streetgen._make_junction_members(name) IS
    'Makes the function of a model that groups nodes to junctions.';

CREATE OR REPLACE FUNCTION streetgen._make_made_junctions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _made_junctions(region bigint[], members streetgen.junction_member[])
        RETURNS streetgen.junction_made[]
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        classifier constant text := (SELECT value FROM setting WHERE name = 'classifier');
        rings constant bigint[] := streetgen._edges_on_rings(current_schema(),
            ARRAY(SELECT m.edge_id FROM unnest(members) m WHERE m.edge_id IS NOT NULL));
    BEGIN
        RETURN ARRAY(
            WITH member AS MATERIALIZED (
                SELECT m.node_id, m.junction_id FROM unnest(members) m WHERE m.node_id IN (SELECT unnest(region))),
            -- A ring that lies in one junction makes it a roundabout, though no arm lies on it.
            ring AS MATERIALIZED (
                SELECT m.junction_id FROM unnest(members) m
                WHERE m.role IS NOT NULL AND m.edge_id IN (SELECT unnest(rings))),
            -- Signals that stand inside a junction are its own.
            lit AS MATERIALIZED (
                SELECT DISTINCT m.junction_id FROM unnest(members) m
                WHERE m.role IS NOT NULL AND 'signals' IN (m.control_from, m.control_to)),
            arm AS MATERIALIZED (
                SELECT j.junction_id, array_agg(ROW (e.edge_id, a.kind, e.importance, e.speed,
                    CASE WHEN at_start THEN e.width ELSE e.width_end END,
                    CASE WHEN at_start THEN lanes_backward ELSE lanes_forward END + lanes_both,
                    CASE WHEN at_start THEN lanes_forward ELSE lanes_backward END + lanes_both,
                    90 - degrees(streetgen._direction_from(e.geom, CASE WHEN at_start THEN 'start' ELSE 'end' END)),
                    CASE WHEN j.junction_id IN (SELECT l.junction_id FROM lit l) THEN 'signals' ELSE own_control END,
                    e.edge_id IN (SELECT unnest(rings)) OR j.junction_id IN (SELECT r.junction_id FROM ring r),
                    a.highway_role)::streetgen.junction_arm
                    ORDER BY e.edge_id, at_start) AS arms,
                    bool_or(own_control IS NOT NULL) AS controlled
                FROM unnest(members) m JOIN edge e ON e.edge_id = m.edge_id CROSS JOIN LATERAL (
                    VALUES (e.from_node, true, m.control_from), (e.to_node, false, m.control_to)) v(node_id, at_start,
                    own_control) JOIN member j ON j.node_id = v.node_id
                    LEFT JOIN (SELECT axis_id, kind, highway_role FROM axis
                        LEFT JOIN axis_class ON class = kind) a USING (axis_id)
                WHERE m.role IS NULL GROUP BY j.junction_id),
            place AS MATERIALIZED (
                -- By place: the last bit of a mean is that of its order, and the order of keys is that of runs.
                SELECT junction_id, count(*) AS nodes, ST_Centroid(ST_Collect(ST_Force2D(n.geom)
                    ORDER BY ST_X(n.geom), ST_Y(n.geom))) AS geom,
                    array_agg(node_id) AS node_ids
                FROM member JOIN node n USING (node_id) GROUP BY junction_id),
            decided AS MATERIALIZED (
                SELECT DISTINCT ON (n.node_id) n.node_id, o.kind, o.junction_override_id
                FROM junction_override o, LATERAL (
                    SELECT v.node_id FROM edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id)
                        JOIN node n USING (node_id) WHERE e.axis_id = o.axis_id
                    ORDER BY ST_Distance(n.geom, o.geom), v.node_id LIMIT 1) n
                WHERE o.kind IS NOT NULL ORDER BY n.node_id, o.junction_override_id DESC)
            SELECT ROW (p.junction_id, CASE WHEN d.kind IS NOT NULL THEN d.kind
                    WHEN classifier = 'streetgen.junction_kind' THEN streetgen.junction_kind(arms)
                    WHEN classifier = 'paper' THEN streetgen._paper_kind(arms)
                    ELSE streetgen._classified(current_schema(), classifier, p.junction_id, arms) END,
                CASE WHEN d.kind IS NOT NULL THEN 'by_hand' WHEN p.nodes > 1 THEN 'grouped' ELSE 'hypothesis' END,
                p.geom, p.nodes)::streetgen.junction_made
            FROM place p LEFT JOIN arm USING (junction_id) LEFT JOIN LATERAL (
                SELECT d.kind FROM decided d WHERE d.node_id = ANY (p.node_ids)
                ORDER BY d.junction_override_id DESC LIMIT 1) d ON true
            WHERE p.nodes > 1 OR cardinality(arms) <> 2 OR arm.controlled OR d.kind IS NOT NULL
            ORDER BY p.junction_id);
    END $body$;
    PERFORM streetgen._own_function(model, '_made_junctions(bigint[], streetgen.junction_member[])',
        'The junctions of a region with their kinds: by hand, or by the classifier from their arms');
END $$;
COMMENT ON FUNCTION streetgen._make_made_junctions(name) IS
    'Makes the function of a model that tells the kinds of junctions.';
