-- The one statement, surfaces: section limits, sections, corners, intersections.

CREATE OR REPLACE FUNCTION streetgen._surface_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    (3, 'section_limit', 'surface', 'section_limit_id', 'edge_id, which', 'edge', 2),
    (4, 'section', 'surface', 'edge_id', NULL, 'edge', 1),
    (5, 'corner', 'surface', 'corner_id', 'node_id, edge_a, end_a, edge_b, end_b', 'corner', 1),
    (6, 'intersection', 'surface', 'node_id', NULL, 'intersection', 1) $$;
COMMENT ON FUNCTION streetgen._surface_computed_table() IS 'The computed tables of the roadway.';

CREATE OR REPLACE FUNCTION streetgen._computed_section_limit(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, axis_id bigint, which text, wanted_abscissa float8, abscissa float8,
        geom geometry, border_line geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_section_limit';
COMMENT ON FUNCTION streetgen._computed_section_limit(bigint, bigint[]) IS
    'The section limits of streets computed in this statement; abscissas along the edge, m. edges: the ids of the '
    'edges by their numbers, 0 where one has none, as nodes and lanes below; what belongs to one without is left out. '
    'A list with a NULL: 22023.';

CREATE OR REPLACE FUNCTION streetgen._computed_section(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, level integer, surface geometry, method text, contested_area float8,
        borders float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_section';
COMMENT ON FUNCTION streetgen._computed_section(bigint, bigint[]) IS
    'The sections of streets computed in this statement: those of affected edges; borders in abscissas along the edge.';

CREATE OR REPLACE FUNCTION streetgen._computed_corner(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, node_id bigint, edge_a bigint, end_a text, edge_b bigint, end_b text,
        centre geometry, radius_wanted float8, radius float8, arc geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_corner';
COMMENT ON FUNCTION streetgen._computed_corner(bigint, bigint[], bigint[]) IS
    'The corners of streets computed in this statement; centre and arc are NULL where there is no arc; radii in m.';

CREATE OR REPLACE FUNCTION streetgen._computed_intersection(streets bigint, nodes bigint[])
    RETURNS TABLE(number integer, node_id bigint, level integer, surface geometry, method text, contested_area float8)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_intersection';
COMMENT ON FUNCTION streetgen._computed_intersection(bigint, bigint[]) IS
    'The intersections of streets computed in this statement: those of affected nodes where edges meet.';

CREATE OR REPLACE FUNCTION streetgen._upsert_surface(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
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
                WHERE c.node_id = n.node_id {by_key}) c WHERE n.affected AND NOT n.fresh {by_key}) c
        WHERE edge_a IN (SELECT edge_id FROM new_edge) AND edge_b IN (SELECT edge_id FROM new_edge)$part$),
    streetgen._upsert_rows(places, 'intersection', columns => 'level, surface, method, contested_area', rows => $part$
        SELECT number, node_id, level, surface, method, contested_area
        FROM streetgen._computed_intersection((SELECT streets FROM computed), (SELECT ids FROM node_ids))$part$,
        there => 'SELECT node_id FROM new_node WHERE affected AND NOT fresh')) $$;
COMMENT ON FUNCTION streetgen._upsert_surface(jsonb) IS
    'Part of the one statement: section limits, sections, corners and intersections at new_edge and new_node.';

CREATE OR REPLACE FUNCTION streetgen._surface_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(concat_ws(',',
        $part$transitions => (
            SELECT array_agg(ROW (axis_id, which, coalesce(kind, v ->> 'transition_kind'),
                coalesce(length, (v ->> 'transition_length')::float8))::streetgen.street_transition)
            FROM (SELECT DISTINCT ON (axis_id, which) * FROM {model}.transition_override
            WHERE {whole} OR axis_id = ANY ($2) ORDER BY axis_id, which, transition_override_id DESC) o, setting)$part$,
        $part$limits => (
            SELECT array_agg(ROW (axis_id, abscissa, which)::streetgen.street_limit ORDER BY section_limit_override_id)
            FROM {model}.section_limit_override WHERE {whole} OR axis_id = ANY ($2))$part$,
        $part$corners => (
            SELECT array_agg(ROW (axis_a, axis_b, ST_X(geom), ST_Y(geom), radius)::streetgen.street_corner
                ORDER BY corner_override_id)
            FROM {model}.corner_override WHERE {whole} OR axis_a = ANY ($2))$part$), places) $$;
COMMENT ON FUNCTION streetgen._surface_arguments(jsonb) IS
    'Part of the one statement: what the core gets of the roadway.';
