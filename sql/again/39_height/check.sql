-- Rules of check_model for overpasses, heights and bridges.

CREATE OR REPLACE FUNCTION streetgen._height_check_part()
    RETURNS TABLE(place integer, subject text, kind text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (67, 'overpass', 'rule', $part$
SELECT 'warning', 'overpass override without its crossing', 'overpass_override', o.overpass_override_id,
    o.clearance, o.geom FROM %1$I.overpass_override o
    WHERE NOT EXISTS (SELECT FROM %1$I.overpass p JOIN %1$I.edge a ON a.edge_id = p.edge_above
        JOIN %1$I.edge b ON b.edge_id = p.edge_below
        WHERE (a.axis_id, b.axis_id) = (o.axis_above, o.axis_below) AND p.method = 'by_hand'
            AND ST_DWithin(p.geom, o.geom, 20))$part$),
    (68, 'height', 'rule', $part$
SELECT 'error', 'clearance not kept, m', 'overpass', o.overpass_id, h.over, o.geom
    FROM %1$I.overpass o JOIN %1$I.profile a ON a.edge_id = o.edge_above
        JOIN %1$I.profile b ON b.edge_id = o.edge_below,
        LATERAL (SELECT streetgen._height_along(a.geom, o.abscissa_above)
            - streetgen._height_along(b.geom, o.abscissa_below) AS over) h
    WHERE h.over < o.clearance - 1e-3$part$),
    (68, 'height', 'rule', $part$
SELECT 'error', 'edges of one node at two heights, m', 'node', v.node_id, max(v.z) - min(v.z), n.geom
    FROM %1$I.edge e JOIN %1$I.profile p USING (edge_id), LATERAL (VALUES (e.from_node, ST_Z(ST_StartPoint(p.geom))),
        (e.to_node, ST_Z(ST_EndPoint(p.geom)))) v(node_id, z) JOIN %1$I.node n USING (node_id)
    GROUP BY v.node_id, n.geom HAVING max(v.z) - min(v.z) > 1e-6$part$),
    (68, 'height', 'rule', $part$
SELECT 'warning', 'height by hand below the road, m', 'height_override', o.height_override_id, z.height - o.height,
    o.geom FROM %1$I.height_override o JOIN %1$I.edge e ON e.axis_id = o.axis_id
        AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa JOIN %1$I.profile p USING (edge_id),
        LATERAL (SELECT streetgen._height_along(p.geom, (o.abscissa - e.start_abscissa)
            / (e.end_abscissa - e.start_abscissa) * ST_Length2D(e.geom)) AS height) z
    WHERE z.height - o.height > 1$part$),
    (68, 'height', 'rule', $part$
SELECT 'warning', 'height override without its axis', 'height_override', o.height_override_id, o.height, o.geom
    FROM %1$I.height_override o WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = o.axis_id
        AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa)$part$),
    (69, 'bridge', 'rule', $part$
SELECT 'notice', 'bridge ends at a node above what it crosses, m', 'bridge', b.bridge_id, d.apart, o.geom
    FROM %1$I.bridge b JOIN %1$I.overpass o ON o.edge_above = b.edge_id JOIN %1$I.edge e ON e.edge_id = b.edge_id
        JOIN %1$I.edge c ON c.edge_id = o.edge_below, LATERAL (SELECT min(ST_Distance(v.place, c.geom)) AS apart
            FROM (VALUES (0, ST_StartPoint(e.geom)), (ST_Length2D(e.geom), ST_EndPoint(e.geom))) v(at, place)
            WHERE v.at BETWEEN b.start_abscissa AND b.end_abscissa) d
    WHERE b.method = 'overpass' AND d.apart < greatest(c.width, c.width_end) / 2
        AND o.abscissa_above BETWEEN b.start_abscissa AND b.end_abscissa$part$) $$;
COMMENT ON FUNCTION streetgen._height_check_part() IS
    'The parts of the query of streetgen.check_model for subjects overpass, height and bridge, as '
    'streetgen._check_part.';
