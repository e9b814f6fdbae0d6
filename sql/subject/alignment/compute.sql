-- The one statement, roads: of new edges and of what is left of the roads that these touch.

CREATE OR REPLACE FUNCTION streetgen._alignment_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (20, 'road', 'alignment', 'road_id', NULL, 'road', 1),
    (21, 'road_edge', 'alignment', 'edge_id', NULL, 'edge', 1) $$;
COMMENT ON FUNCTION streetgen._alignment_computed_table() IS 'The computed tables of roads.';

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
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT jsonb_build_object('ramp_end', streetgen._fill_template(streetgen._part('ramp_end'), places),
        'passed_ramps', 'EXCEPT SELECT node_id FROM ramp_end',
        'from_node', 'CASE WHEN EXISTS (SELECT FROM ramp_end r WHERE (r.edge_id, r.node_id) = (e.edge_id, e.from_node))
            THEN -e.from_node ELSE e.from_node END',
        'to_node', 'CASE WHEN EXISTS (SELECT FROM ramp_end r WHERE (r.edge_id, r.node_id) = (e.edge_id, e.to_node))
            THEN -e.to_node ELSE e.to_node END') $$;
COMMENT ON FUNCTION streetgen._upsert_ramp_end(jsonb) IS
    'Places of the part of roads where a model computes ramps: ramp_end, the links with the nodes of their ramps, and '
    'what it means for roads.';

CREATE OR REPLACE FUNCTION streetgen._upsert_road_part(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('road_part'),
    places || CASE WHEN places -> 'subjects' ? 'ramp' THEN streetgen._upsert_ramp_end(places) ELSE
        '{"ramp_end": "", "passed_ramps": "", "from_node": "e.from_node", "to_node": "e.to_node"}' END) $$;
COMMENT ON FUNCTION streetgen._upsert_road_part(jsonb) IS
    'Part of the one statement: found_road and found_member, the roads of what is written and of what goes on from it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_alignment(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._upsert_road_part(places),
    streetgen._upsert_rows(places, 'road', named => true, columns => 'from_node, to_node, closed, length, geom',
        rows => streetgen._part('road_rows'),
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
