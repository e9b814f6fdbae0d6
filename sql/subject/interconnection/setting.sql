-- The settings of interconnections.

CREATE OR REPLACE FUNCTION streetgen._interconnection_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('u_turn', 'false', NULL::text, 'pairs also lanes of one edge at its nodes: true or false', NULL::float8,
        NULL::float8,
        ARRAY['true', 'false']),
    ('interconnections_maximal', '10000', NULL, 'at a node of more pairs of lanes none are made', 0, 1000000, NULL),
    ('trajectory', 'bezier', NULL,
        'path between two lanes: bezier or arcs, which follow the lanes towards the node where they would cross a '
        'kerb, or a function (lane_in geometry, lane_out geometry, centre geometry, tolerance float8) returning '
        'geometry, with its schema', NULL, NULL, ARRAY['bezier', 'arcs']),
    ('trajectory_radius', '15', 'm',
        'a Bezier path tighter than this bends nearer to the crossing of its lanes, away from the node, as far as '
        'the kerbs allow; 15 m is comfortable at 20 km/h; 0: the rule of the paper wherever its path stays on the '
        'roadway', 0, 100, NULL),
    ('look_ahead', '25', 'm',
        'where less lane than this is left to the next node nobody changes lanes, and lanes lead to those that serve '
        'the movements there; 0: lanes are chosen at each node alone', 0, 200, NULL),
    ('trajectory_tolerance', '0.05', 'm', 'chords of a path between lanes leave its curve by at most this', 0.001, 10,
        NULL) $$;
COMMENT ON FUNCTION streetgen._interconnection_setting() IS
    'The settings of interconnections, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('trajectory', 'geometry, geometry, geometry, float8', 'geometry', false, 'bezier, arcs, or a function (lane_in '
        'geometry, lane_out geometry, centre geometry, tolerance float8) returning geometry') $$;
COMMENT ON FUNCTION streetgen._interconnection_setting_function() IS
    'The function of the users that paths may come from, as streetgen._setting_function has it.';
