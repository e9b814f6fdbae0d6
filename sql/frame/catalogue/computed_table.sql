-- The one list of computed tables, with the subject of each.

CREATE OR REPLACE FUNCTION streetgen._computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 15 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'node', 'network', 'node_id', NULL, 'node', 1),
    (2, 'edge', 'network', 'edge_id', NULL, 'edge', 1),
    (3, 'section_limit', 'surface', 'section_limit_id', 'edge_id, which', 'edge', 2),
    (4, 'section', 'surface', 'edge_id', NULL, 'edge', 1),
    (5, 'corner', 'surface', 'corner_id', 'node_id, edge_a, end_a, edge_b, end_b', 'corner', 1),
    (6, 'intersection', 'surface', 'node_id', NULL, 'intersection', 1),
    (7, 'lane', 'lane', 'lane_id', 'edge_id, ordinality', 'lane', 1),
    (8, 'lane_separator', 'lane', 'lane_separator_id', 'edge_id, lane_position', 'lane_separator', 1),
    (9, 'marking', 'lane', 'marking_id', 'edge_id, kind, lane_position, along_axis', 'marking', 1),
    (10, 'interconnection', 'interconnection', 'interconnection_id', 'lane_in, lane_out, along_in, along_out',
        'interconnection',
        1),
    (11, 'kerb', 'kerb', 'kerb_id', 'edge_id, side, part', 'kerb', 1),
    (12, 'ramp', 'ramp', 'ramp_id', 'node_id', 'ramp', 1),
    (20, 'road', 'alignment', 'road_id', NULL, 'road', 1),
    (21, 'road_edge', 'alignment', 'edge_id', NULL, 'edge', 1),
    (30, 'block', 'block', 'block_id', NULL, 'block', 1),
    (31, 'block_edge', 'block', NULL, NULL, NULL, NULL),
    (25, 'roundabout', 'roundabout', 'roundabout_id', 'edge_id, along_axis', 'roundabout', 1),
    (26, 'roundabout_edge', 'roundabout', 'roundabout_edge_id', 'edge_id, along_axis', 'roundabout_edge', 1),
    (27, 'roundabout_arm', 'roundabout', 'roundabout_arm_id', 'roundabout_id, edge_id, along_axis',
        'roundabout_arm', 1),
    (35, 'sidewalk', 'sidewalk', 'sidewalk_id', 'edge_id, side, part', 'sidewalk', 1),
    (40, 'junction', 'junction', 'junction_id', NULL, 'junction', 1),
    (41, 'junction_node', 'junction', 'node_id', NULL, 'junction_node', 1),
    (42, 'junction_edge', 'junction', 'edge_id', NULL, 'junction_edge', 1),
    (43, 'junction_movement', 'junction', 'junction_movement_id', 'lane_in, lane_out, along_in, along_out',
        'junction_movement', 1),
    (60, 'controller', 'signal', 'controller_id', NULL, 'controller', 1),
    (61, 'signal_state', 'signal', NULL, NULL, NULL, NULL),
    (62, 'signal_movement', 'signal', NULL, NULL, NULL, NULL),
    (63, 'signal_head', 'signal', NULL, NULL, NULL, NULL),
    (55, 'overpass', 'overpass', 'overpass_id', 'edge_above, edge_below, ordinality', 'overpass',
        1),
    (56, 'profile', 'height', 'edge_id', NULL, 'edge', 1),
    (57, 'bridge', 'bridge', 'bridge_id', 'edge_id, start_abscissa', 'bridge', 1),
    (58, 'tunnel', 'bridge', 'tunnel_id', 'edge_id, start_abscissa', 'tunnel', 1),
    (70, 'object_edge', 'object', 'street_object_id', NULL, 'object_edge', 1),
    (99, 'report', 'network', NULL, NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._computed_table() IS
    'The tables that generate writes, in the order in which their rows are given. subject: the part of a model that '
        'the '
    'table belongs to. key: its primary key. identity: the columns that tell which row of a former run is the same, '
    'which then keeps its key; NULL: the query of the rows gives the key. gone_with: the table whose deleted rows take '
    'rows of this one along, gone_each for each; the table itself where its own rows are deleted. A table without a '
    'key is written by a part of the one statement of its own.';

CREATE OR REPLACE FUNCTION streetgen._computed_tables(model name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT array_agg(relation ORDER BY place) FROM streetgen._computed_table()
    JOIN unnest(streetgen._subjects(model)) s(subject) USING (subject) $$;
COMMENT ON FUNCTION streetgen._computed_tables(name) IS
    'The tables that generate writes in a model, in the order in which their rows are given.';
