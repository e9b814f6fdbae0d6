-- The one statement, surfaces: section limits, sections, corners, intersections.

CREATE OR REPLACE FUNCTION streetgen._upsert_surface(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',',
    streetgen._upsert_rows(places, 'section_limit',
        columns => 'edge_id, which, wanted_abscissa, abscissa, geom, border_line, method', rows => $part$
        SELECT number, edge_id, which, wanted_abscissa, abscissa, {geom_with_height} AS geom, border_line, method
        FROM streetgen._computed_section_limit((SELECT streets FROM computed), (SELECT ids FROM edge_ids)) c$part$),
    streetgen._upsert_rows(places, 'section', columns => 'level, surface, method, contested_area, borders',
        rows => $part$
        SELECT number, edge_id, level, surface, method, contested_area, borders
        FROM streetgen._computed_section((SELECT streets FROM computed), (SELECT ids FROM edge_ids))$part$),
    streetgen._upsert_rows(places, 'corner',
        columns => 'node_id, edge_a, end_a, edge_b, end_b, centre, radius_wanted, radius, arc, method', rows => $part$
        SELECT number, node_id, edge_a, end_a, edge_b, end_b, centre, radius_wanted, radius, arc, method
        FROM streetgen._computed_corner((SELECT streets FROM computed), (SELECT ids FROM node_ids),
            (SELECT ids FROM edge_ids))$part$,
        there => $part$
        SELECT corner_id FROM (
            SELECT c.corner_id, c.edge_a, c.edge_b FROM new_node n, LATERAL (SELECT * FROM {model}.corner c
                WHERE c.node_id = n.node_id {by_key}) c WHERE NOT n.fresh {by_key}) c
        WHERE edge_a IN (SELECT edge_id FROM new_edge) AND edge_b IN (SELECT edge_id FROM new_edge)$part$),
    streetgen._upsert_rows(places, 'intersection', columns => 'level, surface, method, contested_area', rows => $part$
        SELECT number, node_id, level, surface, method, contested_area
        FROM streetgen._computed_intersection((SELECT streets FROM computed), (SELECT ids FROM node_ids))$part$,
        there => 'SELECT node_id FROM new_node WHERE affected AND NOT fresh')) $$;
COMMENT ON FUNCTION streetgen._upsert_surface(jsonb) IS
    'Part of the one statement: section limits, sections, corners and intersections at new_edge and new_node.';
