-- The tables of signals.

CREATE TABLE :"model".controller (
    controller_id bigint PRIMARY KEY REFERENCES :"model".junction ON DELETE CASCADE,
    program text NOT NULL, cycle float8 NOT NULL CHECK (cycle >= 0), start_offset float8 NOT NULL,
    method text NOT NULL CHECK (method IN ('hypothesis', 'classified', 'by_hand')),
    geom geometry(Point, :srid) NOT NULL);
CREATE INDEX controller_geom ON :"model".controller USING gist (geom);
COMMENT ON TABLE :"model".controller IS
    'The signals of each junction of kind signals: one program for all its nodes. Its key is that of the junction';
COMMENT ON COLUMN :"model".controller.controller_id IS 'key: that of the junction';
COMMENT ON COLUMN :"model".controller.program IS 'phases, paper, or a function';
COMMENT ON COLUMN :"model".controller.cycle IS 'seconds: the sum of its states; 0: the junction has no movement';
COMMENT ON COLUMN :"model".controller.start_offset IS
    'seconds after which its first state begins, and again each cycle';
COMMENT ON COLUMN :"model".controller.method IS
    'hypothesis: a control point or a kind by hand says that signals stand there; classified: the classifier alone; '
    'by_hand: program, cycle, offset or durations were decided by hand';
COMMENT ON COLUMN :"model".controller.geom IS 'the middle of its nodes';

CREATE TABLE :"model".signal_state (
    controller_id bigint NOT NULL REFERENCES :"model".controller ON DELETE CASCADE,
    ordinality integer NOT NULL CHECK (ordinality > 0), duration float8 NOT NULL,
    kind text NOT NULL CHECK (kind IN ('green', 'amber', 'all_red')),
    PRIMARY KEY (controller_id, ordinality));
COMMENT ON TABLE :"model".signal_state IS 'The states of a controller, one after the other, again and again';
COMMENT ON COLUMN :"model".signal_state.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".signal_state.ordinality IS 'number from 1 within the cycle';
COMMENT ON COLUMN :"model".signal_state.duration IS 'seconds';
COMMENT ON COLUMN :"model".signal_state.kind IS 'green, amber (of those that had green before) or all_red';

CREATE TABLE :"model".signal_movement (
    controller_id bigint NOT NULL, ordinality integer NOT NULL,
    lane_in bigint NOT NULL REFERENCES :"model".lane ON DELETE CASCADE,
    lane_out bigint NOT NULL REFERENCES :"model".lane ON DELETE CASCADE, along_in boolean NOT NULL,
    along_out boolean NOT NULL, right_of_way text NOT NULL CHECK (right_of_way IN ('protected', 'permitted')),
    PRIMARY KEY (controller_id, ordinality, lane_in, lane_out, along_in, along_out),
    FOREIGN KEY (controller_id, ordinality) REFERENCES :"model".signal_state ON DELETE CASCADE);
CREATE INDEX signal_movement_lane_in ON :"model".signal_movement (lane_in);
CREATE INDEX signal_movement_lane_out ON :"model".signal_movement (lane_out);
COMMENT ON TABLE :"model".signal_movement IS 'The movements that have green in a state of kind green';
COMMENT ON COLUMN :"model".signal_movement.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".signal_movement.ordinality IS 'the state';
COMMENT ON COLUMN :"model".signal_movement.lane_in IS 'the lane that it comes from';
COMMENT ON COLUMN :"model".signal_movement.lane_out IS 'the lane that it leads to';
COMMENT ON COLUMN :"model".signal_movement.along_in IS 'does one drive along the axis of the first?';
COMMENT ON COLUMN :"model".signal_movement.along_out IS 'does one drive along the axis of the second?';
COMMENT ON COLUMN :"model".signal_movement.right_of_way IS 'protected, or permitted: it gives way to who is protected';

CREATE TABLE :"model".signal_head (
    lane_id bigint NOT NULL REFERENCES :"model".lane ON DELETE CASCADE, along_axis boolean NOT NULL,
    controller_id bigint NOT NULL REFERENCES :"model".controller ON DELETE CASCADE,
    geom geometry(Point, :srid) NOT NULL, angle float8 NOT NULL,
    PRIMARY KEY (lane_id, along_axis));
CREATE INDEX signal_head_controller ON :"model".signal_head (controller_id);
CREATE INDEX signal_head_geom ON :"model".signal_head USING gist (geom);
COMMENT ON TABLE :"model".signal_head IS 'Where each lane waits for its signal';
COMMENT ON COLUMN :"model".signal_head.lane_id IS 'the lane that waits';
COMMENT ON COLUMN :"model".signal_head.along_axis IS 'does it wait for what drives along the axis?';
COMMENT ON COLUMN :"model".signal_head.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".signal_head.geom IS
    'the middle of the stop line of the lane; where there is none, where the lane ends';
COMMENT ON COLUMN :"model".signal_head.angle IS 'direction of who waits, degrees clockwise from the north';
