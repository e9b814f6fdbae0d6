-- This says what each column of signals means.
CREATE OR REPLACE FUNCTION streetgen._signal_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$ VALUES
    ('controller'::name, 'controller_id'::name, 'key: that of the junction'),
    ('controller', 'program', 'phases, paper, or a function'),
    ('controller', 'cycle', 'seconds: the sum of its states; 0: the junction has no movement'),
    ('controller', 'start_offset', 'seconds after which its first state begins, and again each cycle'),
    ('controller', 'method', 'hypothesis: a control point or a kind by hand says that signals stand there; classified: '
        'the classifier alone; by_hand: program, cycle, offset or durations were decided by hand'),
    ('controller', 'geom', 'the middle of its nodes'),
    ('signal_state', 'controller_id', 'the controller'),
    ('signal_state', 'ordinality', 'number from 1 within the cycle'),
    ('signal_state', 'duration', 'seconds'),
    ('signal_state', 'kind', 'green, amber (of those that had green before) or all_red'),
    ('signal_movement', 'controller_id', 'the controller'),
    ('signal_movement', 'ordinality', 'the state'),
    ('signal_movement', 'lane_in', 'the lane that it comes from'),
    ('signal_movement', 'lane_out', 'the lane that it leads to'),
    ('signal_movement', 'along_in', 'does one drive along the axis of the first?'),
    ('signal_movement', 'along_out', 'does one drive along the axis of the second?'),
    ('signal_movement', 'right_of_way', 'protected, or permitted: it gives way to who is protected'),
    ('signal_head', 'lane_id', 'the lane that waits'),
    ('signal_head', 'along_axis', 'does it wait for what drives along the axis?'),
    ('signal_head', 'controller_id', 'the controller'),
    ('signal_head', 'geom', 'where the lane ends'),
    ('signal_head', 'angle', 'direction of who waits, degrees clockwise from the north'),
    ('signal_crossing', 'controller_id', 'the controller'),
    ('signal_crossing', 'ordinality', 'the state'),
    ('signal_crossing', 'control_point_id', 'the crossing: a control point'),
    ('signal_crossing', 'edge_id', 'the street that is crossed'),
    ('signal_crossing', 'right_of_way', 'protected, or permitted: who turns into the street gives way'),
    ('signal_crossing', 'geom', 'the place of the control point'),
    ('controller_override', 'controller_override_id', 'key'),
    ('controller_override', 'axis_id', 'an axis of the junction'),
    ('controller_override', 'geom', 'a place near the node of that axis'),
    ('controller_override', 'program', 'phases or paper; NULL: setting signal_program'),
    ('controller_override', 'cycle', 'seconds; greens stretch or shrink to it; NULL: as long as the states last'),
    ('controller_override', 'start_offset', 'seconds; NULL: 0'),
    ('controller_override', 'durations', 'seconds of the states in order; NULL in it: computed') $$;
COMMENT ON FUNCTION streetgen._signal_column() IS 'The columns of signals, and what each is.';
