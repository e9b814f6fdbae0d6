-- The one statement, nodes and edges: which of them are written, and which keep the id of one that is there.

CREATE OR REPLACE FUNCTION streetgen._network_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'node', 'network', 'node_id', NULL, 'node', 1),
    (2, 'edge', 'network', 'edge_id', NULL, 'edge', 1),
    (99, 'report', 'network', NULL, NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._network_computed_table() IS 'The computed tables of the network.';

CREATE OR REPLACE FUNCTION streetgen._computed_node(streets bigint)
    RETURNS TABLE(number integer, affected boolean, kerbs_affected boolean, geom geometry, anchor_axis bigint[],
        anchor_abscissa float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_node';
COMMENT ON FUNCTION streetgen._computed_node(bigint) IS
    'The nodes of streets computed in this statement. number: by which other things computed name it, from 1 on, as '
    'in all these; affected: its intersection and lanes come out; kerbs_affected: the kerbs of its '
    'intersection do; axes that have a vertex there and its abscissa on '
    'each, m. Streets that are not kept: 55000, as in all these. Limits, surfaces, corners, lanes and what is painted '
    'are given once, so that what they took is free for their tables.';

CREATE OR REPLACE FUNCTION streetgen._computed_edge(streets bigint)
    RETURNS TABLE(number integer, affected boolean, lanes_affected boolean, kerbs_affected boolean,
        spreads_to boolean, axis_id bigint, from_node integer, to_node integer, level integer,
        start_abscissa float8, end_abscissa float8, geom geometry, curve geometry, beside_left text,
        beside_right text, median_left float8[], median_right float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_edge';
COMMENT ON FUNCTION streetgen._computed_edge(bigint) IS
    'The edges of streets computed in this statement: affected: its section comes out; lanes_affected: its lanes do; '
    'kerbs_affected: the kerbs of its section do; spreads_to: the change goes on beyond it, so that a run for its '
    'axis is due; abscissas along the axis, m; curve: the arc road of which geom is chords, NULL '
    'where there is none; beside_left, beside_right, median_left, median_right: as in table edge.';

CREATE OR REPLACE FUNCTION streetgen._upsert_written(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('written'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_written(jsonb) IS
    'Part of the one statement: the axes, edges and nodes whose rows are written, and the edges that are there.';

CREATE OR REPLACE FUNCTION streetgen._upsert_node(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._upsert_rows(places, 'node', named => true, columns => 'geom',
        rows => streetgen._part('node_rows'), there => 'SELECT node_id FROM left_node') $$;
COMMENT ON FUNCTION streetgen._upsert_node(jsonb) IS
    'Part of the one statement: new_node, and node_ids, the ids of nodes by their numbers.';

CREATE OR REPLACE FUNCTION streetgen._upsert_edge(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template($part$
same_edge AS MATERIALIZED (SELECT e.number, o.edge_id FROM written_edge e
    JOIN old_edge o USING (axis_id, start_abscissa, end_abscissa))$part$, places),
    streetgen._upsert_rows(places, 'edge', named => true,
        columns => 'axis_id, from_node, to_node, level, start_abscissa, end_abscissa, geom, curve, '
            'width, width_end, roadway_offset, lane_count, lanes_forward, lanes_backward, lanes_both, sidewalk_left, '
            'sidewalk_right, beside_left, beside_right, median_left, median_right, speed, importance, '
            'estimated, input_hash, setting_hash',
        rows => streetgen._part('edge_rows'),
        there => 'SELECT edge_id FROM old_edge WHERE written')) $$;
COMMENT ON FUNCTION streetgen._upsert_edge(jsonb) IS
    'Part of the one statement: new_edge, and edge_ids, the ids of edges by their numbers.';

-- LIMIT: an edge is looked up for each node, and not joined.
CREATE OR REPLACE FUNCTION streetgen._upsert_left_node(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('left_node'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_left_node(jsonb) IS
    'Part of the one statement: left_node, the nodes that no edge begins or ends at any more.';

CREATE OR REPLACE FUNCTION streetgen._upsert_network(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._upsert_written(places), streetgen._upsert_node(places),
        streetgen._upsert_edge(places), streetgen._upsert_left_node(places)) $$;
COMMENT ON FUNCTION streetgen._upsert_network(jsonb) IS
    'Part of the one statement: new_node and new_edge, and node_ids and edge_ids, by which surfaces and lanes find '
    'the ids of theirs.';
