-- The settings of lanes.

CREATE OR REPLACE FUNCTION streetgen._lane_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 15 SET search_path = pg_catalog
    AS $$ VALUES
    ('lane_width', '3.5', 'm', 'width of one lane, for estimates', 1, 10, NULL::text[]),
    ('lane_width_minimal', '2', 'm', 'lanes of unknown width get less only where all lanes of the roadway do', 0.5, 10,
        NULL),
    ('lane_width_maximal', '4', 'm', 'lanes of a stated number and unknown width grow at most so wide on a roadway of '
        'stated width; the rest lies beside them. NULL: they fill it', 2, 100, NULL),
    ('cycle_lane_width', '1.5', 'm', 'width of a cycle lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('parking_lane_width', '2', 'm', 'width of a parking lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('parking_depth_parallel', '2', 'm', 'depth of bays beside the roadway or on the kerb, for cars along the street',
        1, 10, NULL),
    ('parking_depth_diagonal', '4.5', 'm', 'the same for cars askew, and of parking lanes that say no width', 2.5, 10,
        NULL),
    ('parking_depth_perpendicular', '5', 'm', 'the same for cars across the street', 2.5, 10, NULL),
    ('lane_order', 'left_first', NULL, 'lanes are numbered from the middle outwards: left_first or right_first', NULL,
        NULL, ARRAY['left_first', 'right_first']),
    ('edge_line', 'none', NULL, 'line along the kerbs: none or solid', NULL, NULL, ARRAY['none', 'solid']),
    ('control_distance', '50', 'm',
        'a control point farther before its junction than this stands in the middle of its block', 0, 1000, NULL),
    ('queue_length', '25', 'm',
        'on a road between two signals that is no longer no queue has room: they are one junction', 0, 150, NULL),
    ('line_before_kerb', '0.5', 'm',
        'so far before the kerb of the street crossed, or of the ring, lies a line that no crossing moves', 0, 10,
        NULL),
    ('line_before_crossing', '1', 'm',
        'so far before a crossing of its arm lies a stop line, and a yield line away from rings', 0, 10, NULL),
    ('crossing_of_arm', '15', 'm',
        'a crossing so near to where the lanes of an arm end is one of the arm', 0, 50, NULL) $$;
COMMENT ON FUNCTION streetgen._lane_setting() IS 'The settings of lanes, with their defaults and ranges.';
