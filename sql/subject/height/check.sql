-- Rules of check_model for heights.

CREATE OR REPLACE FUNCTION streetgen._check_height(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'clearance not kept, m', 'overpass', o.overpass_id, h.over, o.geom
        FROM overpass o JOIN profile a ON a.edge_id = o.edge_above
            JOIN profile b ON b.edge_id = o.edge_below,
            LATERAL (SELECT streetgen._height_along(a.geom, o.abscissa_above)
                - streetgen._height_along(b.geom, o.abscissa_below) AS over) h
        WHERE h.over < o.clearance - 1e-3
    UNION ALL
    SELECT 'error', 'edges of one node at two heights, m', 'node', v.node_id, max(v.z) - min(v.z), n.geom
        FROM edge e JOIN profile p USING (edge_id), LATERAL (VALUES (e.from_node, ST_Z(ST_StartPoint(p.geom))),
            (e.to_node, ST_Z(ST_EndPoint(p.geom)))) v(node_id, z) JOIN node n USING (node_id)
        GROUP BY v.node_id, n.geom HAVING max(v.z) - min(v.z) > 1e-6
    UNION ALL
    SELECT 'warning', 'height by hand below the road, m', 'height_override', o.height_override_id, z.height - o.height,
        o.geom FROM height_override o JOIN edge e ON e.axis_id = o.axis_id
            AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa JOIN profile p USING (edge_id),
            LATERAL (SELECT streetgen._height_along(p.geom, (o.abscissa - e.start_abscissa)
                / (e.end_abscissa - e.start_abscissa) * ST_Length2D(e.geom)) AS height) z
        WHERE z.height - o.height > 1
    UNION ALL
    SELECT 'warning', 'height override without its axis', 'height_override', o.height_override_id, o.height, o.geom
        FROM height_override o WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = o.axis_id
            AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa)
    UNION ALL
    SELECT 'notice', 'height limit other than the clearance, m', 'overpass', l.overpass_id,
            l.height_limit - l.clearance, l.geom
        -- One sign is about the lowest of several decks, and of no deck where a tunnel has a ceiling of its own.
        FROM (SELECT DISTINCT ON (e.axis_id) u.* FROM underpass u JOIN edge e USING (edge_id)
            WHERE streetgen._off_ground(e.level, e.geom) >= 0 ORDER BY e.axis_id, u.clearance, u.overpass_id) l
        WHERE l.height_limit NOT BETWEEN l.clearance - 1.5 AND l.clearance
    UNION ALL
    SELECT 'notice', 'level crossing of water', 'edge', e.edge_id, NULL::float8, p.geom
        FROM edge e JOIN profile p USING (edge_id), setting s
        WHERE streetgen._off_ground(e.level, e.geom) = 1 AND p.method = 'ground'
            AND s.name = 'bridge_rise' AND s.value::float8 > 0
    UNION ALL
    SELECT 'warning', 'bridge or tunnel too near to the ground, m', 'edge', b.edge_id, min(rise), b.geom
        FROM (SELECT e.edge_id, e.geom AS line, p.geom, off_ground, ST_Length2D(e.geom) AS metres,
                streetgen._ground_of(model, e.geom, f.geom, t.geom) AS ground,
                -- A bridge of several pieces ends at some of their nodes.
                (SELECT ST_Collect(ST_Force2D(n.geom)) FROM node n WHERE ST_DWithin(n.geom, e.geom, 10)
                    AND streetgen._ends_off_ground(model, n.node_id)) AS ends
            FROM edge e JOIN profile p USING (edge_id) JOIN node f ON f.node_id = e.from_node
                JOIN node t ON t.node_id = e.to_node, streetgen._off_ground(e.level, e.geom) off_ground
            -- A short one may be level with the ground, and hang together with what is not.
            WHERE off_ground <> 0 AND p.method <> 'ground' AND NOT (ST_Length2D(e.geom) < (SELECT value::float8
                    FROM setting WHERE name = 'bridge_level_length')
                AND streetgen._ends_off_ground(model, e.from_node) AND streetgen._ends_off_ground(model, e.to_node)
                AND NOT EXISTS (SELECT FROM overpass o WHERE e.edge_id IN (o.edge_above, o.edge_below)))
            OFFSET 0) b,
            generate_series(0, floor(metres)::integer) at,
            LATERAL (SELECT off_ground * (streetgen._height_along(b.geom, at) - coalesce(streetgen._height_along(
                ST_Force3D(ground), at), 0)) AS rise) r
        WHERE coalesce(ST_Distance(ends, ST_LineInterpolatePoint(line, least(1, at / metres))) >= 10, true)
        GROUP BY b.edge_id, b.geom
        HAVING min(rise) < (SELECT value::float8 FROM setting WHERE name = 'bridge_rise') - 0.01
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_height(name) IS
    'The rows of streetgen.check_model for heights.';

CREATE OR REPLACE FUNCTION streetgen._height_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (23, 'height', $part$
    (SELECT 'profiles, ' || method, count(*), NULL FROM %1$I.profile GROUP BY method ORDER BY method)$part$) $$;
COMMENT ON FUNCTION streetgen._height_summary() IS 'What streetgen.summary counts of heights.';

INSERT INTO streetgen.check_rule (rule, meaning, hint, least_is_worst) VALUES
    ('clearance not kept, m', 'roads that pass over each other in turn lie too near, or a height by another rule',
        'move them apart, raise setting grade_maximal, or lower the clearance in overpass_editing', true),
    ('bridge or tunnel too near to the ground, m',
        'but for ten metres at each end it lies nearer to the ground than setting bridge_rise says: a tunnel and a '
        'bridge follow each other too closely',
        'type a height in height_editing, raise grade_maximal, or correct levels', true);

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('edges of one node at two heights, m', 'profiles of edges that meet end at different heights',
        'run generate; tell us, it should not happen'),
    ('height limit other than the clearance, m',
        'the lowest deck over the axis lies lower than its height_limit, or over 1.5 m higher',
        'type a height in height_editing or a clearance in overpass_editing, or correct height_limit'),
    ('level crossing of water', 'a bridge shorter than setting bridge_level_length that crosses no street lies as high '
        'as the ground: what flows below is no part of the model',
        'nothing; or type a height in height_editing'),
    ('height by hand below the road, m',
        'the road lies higher there by its ground or by another rule, so the height changes nothing',
        'raise the height, or delete it'),
    ('height override without its axis', 'its axis is gone, or ends before the place',
        'delete the row, or put it on another axis');
