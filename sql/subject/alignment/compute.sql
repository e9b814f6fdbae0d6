-- The one statement, roads: of new edges and of what is left of the roads that these touch.

CREATE OR REPLACE FUNCTION streetgen._roads(parts streetgen.road_part[], branching bigint[], shift float8,
    bends streetgen.street_bend[])
    RETURNS TABLE(number integer, from_node bigint, to_node bigint, closed boolean, length float8, geom bytea,
        edges bigint[], start_abscissas float8[])
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_roads';
COMMENT ON FUNCTION streetgen._roads(streetgen.road_part[], bigint[], float8, streetgen.street_bend[]) IS
    'The roads of edges, in the order of their first edges. branching: nodes where further edges meet, so that roads '
    'end there. shift: how far the arc road of a line may leave its points, m. bends: radii by hand, NULL: none. '
    'edges: ids in the order of the road, negative where the edge runs against it; start_abscissas: where each begins, '
    'm along the road; geom: COMPOUNDCURVE, EWKB. No edges (NULL): no row. Bad geometry, a number out of its range: '
    '22023.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ramp_end(places jsonb) RETURNS jsonb
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT jsonb_build_object('ramp_end', streetgen._fill_template($part$
-- A highway goes on past a ramp: there the link ends at a node of its own, minus that of the ramp.
ramp_end AS MATERIALIZED (
    SELECT edge_id, node_id FROM new_ramp
    UNION ALL SELECT edge_id, node_id FROM {model}.ramp WHERE NOT {whole}
        AND node_id NOT IN (SELECT node_id FROM new_node)),$part$, places),
        'passed_ramps', 'EXCEPT SELECT node_id FROM ramp_end',
        'from_node', 'CASE WHEN EXISTS (SELECT FROM ramp_end r WHERE (r.edge_id, r.node_id) = (e.edge_id, e.from_node))
            THEN -e.from_node ELSE e.from_node END',
        'to_node', 'CASE WHEN EXISTS (SELECT FROM ramp_end r WHERE (r.edge_id, r.node_id) = (e.edge_id, e.to_node))
            THEN -e.to_node ELSE e.to_node END') $$;
COMMENT ON FUNCTION streetgen._upsert_ramp_end(jsonb) IS
    'Places of the part of roads where a model computes ramps: ramp_end, the links with the nodes of their ramps, and '
    'what it means for roads.';

CREATE OR REPLACE FUNCTION streetgen._upsert_road_part(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$ {ramp_end}
-- Edges that meet what is written: whether a road goes on there may have changed.
meeting_edge AS MATERIALIZED (
    SELECT e.edge_id FROM (SELECT node_id FROM new_node UNION SELECT node_id FROM left_node) n, LATERAL (
        SELECT edge_id FROM {model}.edge WHERE from_node = n.node_id
        UNION ALL SELECT edge_id FROM {model}.edge WHERE to_node = n.node_id OFFSET 0) e WHERE NOT {whole}),
touched_road AS MATERIALIZED (
    SELECT DISTINCT r.road_id
    FROM (SELECT edge_id FROM old_edge WHERE written UNION SELECT edge_id FROM meeting_edge) e,
        LATERAL (SELECT road_id FROM {model}.road_edge o WHERE o.edge_id = e.edge_id OFFSET 0) r WHERE NOT {whole}),
-- Other edges, which are not looked at, may meet where roads end away from what is written.
far_end AS MATERIALIZED (
    SELECT unnest(ARRAY[r.from_node, r.to_node]) AS node_id FROM touched_road t,
        LATERAL (SELECT * FROM {model}.road o WHERE o.road_id = t.road_id OFFSET 0) r WHERE NOT r.closed
    EXCEPT SELECT node_id FROM new_node {passed_ramps}),
road_part AS MATERIALIZED (
    SELECT edge_id, axis_id, {from_node} AS from_node, {to_node} AS to_node, level, start_abscissa, end_abscissa,
        coalesce(curve, geom)::bytea AS line
    FROM new_edge e
    UNION ALL SELECT e.edge_id, e.axis_id, {from_node}, {to_node}, e.level, e.start_abscissa, e.end_abscissa,
        coalesce(e.curve, e.geom)::bytea
    FROM (SELECT m.edge_id FROM touched_road t,
            LATERAL (SELECT edge_id FROM {model}.road_edge o WHERE o.road_id = t.road_id OFFSET 0) m
        UNION SELECT edge_id FROM meeting_edge) k,
        LATERAL (SELECT * FROM {model}.edge o WHERE o.edge_id = k.edge_id OFFSET 0) e
    WHERE NOT {whole} AND e.axis_id NOT IN (SELECT axis_id FROM written_axis)),
found_road AS MATERIALIZED (
    SELECT * FROM streetgen._roads(
        (SELECT array_agg(ROW (edge_id, axis_id, from_node, to_node, level, start_abscissa, end_abscissa,
            line)::streetgen.road_part) FROM road_part),
        ARRAY(SELECT node_id FROM far_end), (SELECT (v ->> 'smoothing_shift')::float8 FROM setting),
        (SELECT array_agg(ROW (axis_id, abscissa, radius)::streetgen.street_bend ORDER BY road_override_id)
            FROM {model}.road_override WHERE {whole} OR axis_id IN (SELECT axis_id FROM road_part)))),
found_member AS MATERIALIZED (
    SELECT number, abs(edge) AS edge_id, position, edge > 0 AS along_road, start_abscissa
    FROM found_road, unnest(edges, start_abscissas) WITH ORDINALITY m(edge, start_abscissa, position))$part$,
    places || CASE WHEN places -> 'subjects' ? 'ramp' THEN streetgen._upsert_ramp_end(places) ELSE
        '{"ramp_end": "", "passed_ramps": "", "from_node": "e.from_node", "to_node": "e.to_node"}' END) $$;
COMMENT ON FUNCTION streetgen._upsert_road_part(jsonb) IS
    'Part of the one statement: found_road and found_member, the roads of what is written and of what goes on from it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_alignment(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._upsert_road_part(places),
    streetgen._upsert_rows(places, 'road', named => true, columns => 'from_node, to_node, closed, length, geom',
        rows => $part$
        SELECT coalesce(road_id, {next_id}) AS road_id, number, abs(from_node) AS from_node, abs(to_node) AS to_node,
            closed, length,
            geom::geometry AS geom
        FROM (SELECT f.*, heir.road_id FROM found_road f LEFT JOIN (
            -- Identity of roads: by their first edges.
            SELECT n.number, min(o.road_id) AS road_id FROM found_member n, LATERAL (
                SELECT road_id FROM {model}.road_edge o
                WHERE NOT {empty} AND o.edge_id = n.edge_id AND o.position = 1 {by_key}) o
            GROUP BY n.number) heir USING (number) ORDER BY f.number OFFSET 0) r$part$,
        there => 'SELECT road_id FROM touched_road UNION ALL SELECT road_id FROM {model}.road WHERE {whole}'),
    streetgen._upsert_rows(places, 'road_edge', columns => 'road_id, position, along_road, start_abscissa',
        rows => $part$
        SELECT number, edge_id, (SELECT ids FROM road_ids)[number] AS road_id, position::integer AS position,
            along_road, start_abscissa
        FROM found_member$part$)) $$;
COMMENT ON FUNCTION streetgen._upsert_alignment(jsonb) IS
    'Part of the one statement: roads and the edges in them.';

CREATE OR REPLACE FUNCTION streetgen._drop_alignment_rows(model name, gone bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A run finds by their edges what is left of other roads.
    WITH member AS (SELECT m.road_id FROM edge e JOIN road_edge m USING (edge_id) WHERE e.axis_id = ANY (gone))
    DELETE FROM road r WHERE r.road_id IN (SELECT road_id FROM member) AND NOT EXISTS (
        SELECT FROM road_edge m JOIN edge e USING (edge_id) WHERE m.road_id = r.road_id
            AND e.axis_id <> ALL (gone));
END $$;
COMMENT ON FUNCTION streetgen._drop_alignment_rows(name, bigint[]) IS
    'Removes the roads of a model that consist of edges of axes that are gone.';

CREATE OR REPLACE FUNCTION streetgen._alignment_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$bends => (
            SELECT array_agg(ROW (axis_id, abscissa, radius)::streetgen.street_bend ORDER BY road_override_id)
            FROM {model}.road_override WHERE {whole} OR axis_id = ANY ($2))$part$, places) $$;
COMMENT ON FUNCTION streetgen._alignment_arguments(jsonb) IS
    'Part of the one statement: what the core gets of roads.';
