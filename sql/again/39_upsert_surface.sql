-- The one statement, surfaces: section limits, sections, corners, intersections.

CREATE OR REPLACE FUNCTION streetgen._upsert_surfaces(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',',
    streetgen._upsert_rows(places, 'section_limit', id => 'section_limit_id', same => 'edge_id, which', columns => 'wanted_abscissa, abscissa, geom, border_line, method', rows => $part$
        SELECT e.edge_id, l.which, l.wanted_abscissa, l.abscissa, l.border_line, l.method,
               CASE WHEN {has_height} THEN streetgen._with_height(l.geom, (SELECT a.geom FROM {model}.axis a WHERE a.axis_id = e.axis_id)) ELSE l.geom END AS geom
        FROM streetgen._computed_section_limit((SELECT streets FROM computed)) l JOIN new_edge e USING (edge)$part$,
        gone => '(SELECT 2 * count(*) FROM gone_edge)'),
    streetgen._upsert_rows(places, 'section', id => 'edge_id', columns => 'level, surface, method, contested_area', rows => $part$
        SELECT e.edge_id, s.level, s.surface, s.method, s.contested_area
        FROM streetgen._computed_section((SELECT streets FROM computed)) s JOIN new_edge e USING (edge)$part$,
        gone => '(SELECT count(*) FROM gone_edge)'),
    streetgen._upsert_rows(places, 'corner', id => 'corner_id', same => 'node_id, edge_a, end_a, edge_b, end_b', columns => 'centre, radius_wanted, radius, arc, method', rows => $part$
        SELECT n.node_id, a.edge_id AS edge_a, c.end_a, b.edge_id AS edge_b, c.end_b, c.centre, c.radius_wanted, c.radius, c.arc, c.method
        FROM streetgen._computed_corner((SELECT streets FROM computed)) c
        JOIN new_node n USING (node) JOIN new_edge a ON a.edge = c.edge_a JOIN new_edge b ON b.edge = c.edge_b$part$,
        there => $part$
        SELECT c.corner_id FROM new_node n, LATERAL (SELECT * FROM {model}.corner c WHERE c.node_id = n.node_id {by_key}) c
        WHERE c.edge_a IN (SELECT edge_id FROM new_edge) AND c.edge_b IN (SELECT edge_id FROM new_edge)$part$),
    streetgen._upsert_rows(places, 'intersection', id => 'node_id', columns => 'level, surface, method, contested_area', rows => $part$
        SELECT n.node_id, i.level, i.surface, i.method, i.contested_area
        FROM streetgen._computed_intersection((SELECT streets FROM computed)) i JOIN new_node n USING (node)$part$,
        there => 'SELECT node_id FROM new_node WHERE asked')) $$;
COMMENT ON FUNCTION streetgen._upsert_surfaces(jsonb) IS 'Part of the one statement: section limits, sections, corners and intersections of new_edge and new_node.';
