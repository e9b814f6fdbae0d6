-- The one statement, lanes and what is painted on them.

CREATE OR REPLACE FUNCTION streetgen._lane_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (7, 'lane', 'lane', 'lane_id', 'edge_id, ordinality', 'lane', 1),
    (8, 'lane_separator', 'lane', 'lane_separator_id', 'edge_id, lane_position', 'lane_separator', 1),
    (9, 'marking', 'lane', 'marking_id', 'edge_id, kind, lane_position, along_axis', 'marking', 1) $$;
COMMENT ON FUNCTION streetgen._lane_computed_table() IS 'The computed tables of lanes.';

CREATE OR REPLACE FUNCTION streetgen._computed_lane(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, axis_id bigint, ordinality integer, lane_position integer, side text,
        along_axis boolean, both_ways boolean, kind text,
        width float8, axis_offset float8, turn text, geom geometry, surface geometry, method text,
        start_abscissa float8, end_abscissa float8, borders float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_lane';
COMMENT ON FUNCTION streetgen._computed_lane(bigint, bigint[]) IS 'The lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._computed_lane_separator(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, lane_position integer, kind text, dashed boolean,
        leftwards boolean, rightwards boolean, axis_offset float8, geom geometry, surface geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_lane_separator';
COMMENT ON FUNCTION streetgen._computed_lane_separator(bigint, bigint[]) IS
    'The lines between the lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._computed_marking(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, lane_position integer, along_axis boolean, node_id bigint, kind text,
        geom geometry, surface geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_marking';
COMMENT ON FUNCTION streetgen._computed_marking(bigint, bigint[], bigint[]) IS
    'What is painted across and on the lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._upsert_lane(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',',
    streetgen._upsert_rows(places, 'lane', named => true,
        columns => 'edge_id, ordinality, lane_position, side, along_axis, both_ways, kind, width, axis_offset, turn, '
            'geom, surface, method, start_abscissa, end_abscissa, borders', rows => $part$
        SELECT number, edge_id, axis_id, ordinality, lane_position, side, along_axis, both_ways, kind, width,
               axis_offset, turn, geom, surface, method, start_abscissa, end_abscissa, borders
        FROM streetgen._computed_lane((SELECT streets FROM computed), (SELECT ids FROM edge_ids))$part$,
        there => $part$
        SELECT l.lane_id FROM new_edge e, LATERAL (SELECT lane_id FROM {model}.lane l
            WHERE l.edge_id = e.edge_id {by_key}) l WHERE e.affected AND NOT e.fresh$part$),
    streetgen._upsert_rows(places, 'lane_separator',
        columns => 'edge_id, lane_position, kind, dashed, leftwards, rightwards, axis_offset, geom, surface',
        rows => $part$
        SELECT number, edge_id, lane_position, kind, dashed, leftwards, rightwards, axis_offset, geom, surface
        FROM streetgen._computed_lane_separator((SELECT streets FROM computed), (SELECT ids FROM edge_ids))$part$,
        there => $part$
        SELECT s.lane_separator_id FROM new_edge e, LATERAL (
            SELECT lane_separator_id FROM {model}.lane_separator s WHERE s.edge_id = e.edge_id {by_key}) s
                WHERE e.affected AND NOT e.fresh$part$),
    streetgen._upsert_rows(places, 'marking',
        columns => 'edge_id, lane_position, along_axis, node_id, kind, geom, surface, free_geom, free_surface',
        rows => streetgen._part(CASE places ->> 'run' WHEN 'empty' THEN 'free_markings' ELSE 'laid_markings' END),
        there => $part$
        SELECT m.marking_id FROM new_edge e, LATERAL (SELECT marking_id FROM {model}.marking m
            WHERE m.edge_id = e.edge_id {by_key}) m WHERE e.affected AND NOT e.fresh$part$)) $$;
COMMENT ON FUNCTION streetgen._upsert_lane(jsonb) IS
    'Part of the one statement: lanes, separators and markings at new_edge.';

CREATE OR REPLACE FUNCTION streetgen._lane_arguments(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(concat_ws(',',
        $part$lanes => (
            SELECT array_agg(ROW (axis_id, abscissa, ordinality, along_axis, both_ways, width,
                line::bytea)::streetgen.street_lane ORDER BY lane_override_id)
            FROM {model}.lane_override WHERE {whole} OR axis_id = ANY ($2))$part$,
        $part$changes => (
            SELECT array_agg(ROW (axis_id, abscissa, lane_from, lane_to, change)::streetgen.street_lane_change
                ORDER BY lane_adjacency_override_id)
            FROM {model}.lane_adjacency_override WHERE {whole} OR axis_id = ANY ($2))$part$,
        $part$leaving => (
            SELECT array_agg(ROW (axis_id, change_forward, change_backward,
                coalesce(lane_markings = 'no', false))::streetgen.street_leaving ORDER BY axis_id)
            FROM {model}.axis WHERE ({whole} OR axis_id = ANY ($2))
                AND (coalesce(change_forward, change_backward) IS NOT NULL OR lane_markings = 'no'))$part$,
        CASE WHEN places -> 'subjects' ? 'lane' THEN streetgen._part('marked_before') END), places) $$;
COMMENT ON FUNCTION streetgen._lane_arguments(jsonb) IS
    'Part of the one statement: what the core gets of lanes.';
