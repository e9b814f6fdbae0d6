-- Rules of check_model for roads.

CREATE OR REPLACE FUNCTION streetgen._check_alignment(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model)),
    -- The ends of each edge in the direction of its road.
    member AS MATERIALIZED (
        SELECT m.road_id, m.position, m.edge_id, m.start_abscissa, e.end_abscissa - e.start_abscissa AS length, e.geom,
            e.speed, CASE WHEN along_road THEN from_node ELSE to_node END AS first_node,
            CASE WHEN along_road THEN to_node ELSE from_node END AS last_node
        FROM road_edge m JOIN edge e USING (edge_id))
    SELECT 'error', 'edge in no road', 'edge', edge_id, 0, e.geom FROM edge e
        WHERE NOT EXISTS (SELECT FROM road_edge m WHERE m.edge_id = e.edge_id)
    UNION ALL
    SELECT 'error', 'edges of a road do not follow each other', 'road', m.road_id, m.position, m.geom
        FROM member m LEFT JOIN member b ON (b.road_id, b.position) = (m.road_id, m.position - 1)
            LEFT JOIN road r ON r.road_id = m.road_id AND m.position = 1
        WHERE m.first_node IS DISTINCT FROM coalesce(b.last_node, r.from_node)
    UNION ALL
    SELECT 'error', 'road goes through a node of other degree than two', 'road', m.road_id, d.degree, n.geom
        FROM member m JOIN degree d ON d.node_id = m.first_node JOIN node n ON n.node_id = m.first_node
        WHERE m.position > 1 AND d.degree <> 2 AND NOT streetgen._is_ramp(model, d.node_id)
    UNION ALL
    SELECT 'error', 'road ends at a node of degree two', 'road', r.road_id, 2, n.geom
        FROM road r JOIN degree d ON d.node_id IN (r.from_node, r.to_node) JOIN node n USING (node_id)
        WHERE NOT r.closed AND d.degree = 2
    UNION ALL
    SELECT 'error', 'length of a road is not that of its edges, m', 'road', r.road_id, r.length - m.length, r.geom
        FROM road r LEFT JOIN (SELECT road_id, sum(length) AS length FROM member GROUP BY road_id) m USING (road_id)
        WHERE abs(r.length - m.length) <= 1e-6 IS NOT TRUE
    UNION ALL
    -- Edges that turn by more than a right angle, or change their level, meet at a corner. A bend may be sharp by hand.
    SELECT 'error', 'gap of tangent, degrees', 'road', r.road_id, degrees(k.angle), k.place::geometry
        FROM road r, LATERAL streetgen._arc_road_kinks(r.geom) k
        WHERE NOT EXISTS (SELECT FROM member m JOIN node n ON n.node_id = m.first_node
            WHERE m.road_id = r.road_id AND ST_DWithin(n.geom, k.place::geometry, 1e-3))
        AND NOT EXISTS (SELECT FROM road_override o JOIN edge USING (axis_id) JOIN road_edge m USING (edge_id)
            WHERE o.radius = 0 AND m.road_id = r.road_id AND ST_DWithin(o.geom, k.place::geometry, 1))
    UNION ALL
    SELECT 'notice', 'road with a bend tighter than 5 m, m', 'road', road_id, min(radius),
        ST_Collect(centre) FROM road_arc WHERE radius < 5 GROUP BY road_id
    UNION ALL
    SELECT 'notice', 'road with a bend slower than its speed, km/h', 'road', a.road_id, min(a.speed_limit),
        ST_Collect(a.centre) FROM road_arc a
        JOIN (SELECT road_id, max(speed) AS speed FROM member GROUP BY road_id) m USING (road_id)
        WHERE a.speed_limit < m.speed GROUP BY a.road_id
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_alignment(name) IS
    'The rows of streetgen.check_model for roads.';

CREATE OR REPLACE FUNCTION streetgen._alignment_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (30, 'alignment', $part$
    (SELECT 'roads' || CASE WHEN closed THEN ', closed' ELSE '' END, count(*), NULL FROM %1$I.road GROUP BY closed
    ORDER BY closed)$part$),
    (31, 'alignment', $part$
    SELECT 'roads, length', round((coalesce(sum(length), 0) / 1000)::numeric, 3), 'km' FROM %1$I.road$part$) $$;
COMMENT ON FUNCTION streetgen._alignment_summary() IS 'What streetgen.summary counts of roads.';

-- Its rows of road_edge may be gone with a road.
CREATE OR REPLACE FUNCTION streetgen._alignment_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('road'::name, 'NOT EXISTS (SELECT FROM road_edge m WHERE m.edge_id = e.edge_id AND m.road_id <> ($1).road_id)') $$;
COMMENT ON FUNCTION streetgen._alignment_marked_by_hand() IS
    'The edges that a change of roads by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('edge in no road', 'a row of road or road_edge was deleted by hand', '`generate` over all'),
    ('edges of a road do not follow each other', 'an edge inside the road is gone, or a row was changed by hand',
        '`generate` over all'),
    ('road goes through a node of other degree than two', 'a row was changed by hand', '`generate` over all'),
    ('road ends at a node of degree two', 'a row was changed by hand', '`generate` over all'),
    ('length of a road is not that of its edges, m', 'a row was changed by hand', '`generate` over all'),
    ('gap of tangent, degrees', 'an arc of the road does not touch what it joins', '`generate` over all');
INSERT INTO streetgen.check_rule (rule, meaning, hint, least_is_worst) VALUES
    ('road with a bend tighter than 5 m, m', 'the axis turns sharply, or setting smoothing_shift allows no more',
        'draw the bend wider, raise smoothing_shift, or give it a radius in road_arc_editing', true),
    ('road with a bend slower than its speed, km/h', 'the radius of the bend is small for the speed of the axis',
        'as above, or lower the speed', true);
