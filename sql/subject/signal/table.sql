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
ALTER TABLE :"model".controller ADD COLUMN IF NOT EXISTS turn_phases boolean;
COMMENT ON COLUMN :"model".controller.turn_phases IS
    'by hand: do turns across others have a phase of their own? NULL: as lanes and speed say';

CREATE TABLE :"model".signal_state (
    controller_id bigint NOT NULL REFERENCES :"model".controller ON DELETE CASCADE,
    ordinality integer NOT NULL CHECK (ordinality > 0), duration float8 NOT NULL,
    kind text NOT NULL CHECK (kind IN ('green', 'amber', 'all_red', 'walk')),
    PRIMARY KEY (controller_id, ordinality));
COMMENT ON TABLE :"model".signal_state IS 'The states of a controller, one after the other, again and again';
COMMENT ON COLUMN :"model".signal_state.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".signal_state.ordinality IS 'number from 1 within the cycle';
COMMENT ON COLUMN :"model".signal_state.duration IS 'seconds';
COMMENT ON COLUMN :"model".signal_state.kind IS
    'green, amber (of those that had green before), all_red, or walk: nobody drives, and people on foot cross';

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
ALTER TABLE :"model".signal_movement ADD COLUMN IF NOT EXISTS precedence integer,
    ADD COLUMN IF NOT EXISTS signal_group integer;
COMMENT ON COLUMN :"model".signal_movement.precedence IS
    'place in the order of who goes first: of two permitted movements that meet the greater number gives way';
COMMENT ON COLUMN :"model".signal_movement.signal_group IS 'its row of signal_group';

CREATE TABLE :"model".signal_group (
    controller_id bigint NOT NULL REFERENCES :"model".controller ON DELETE CASCADE,
    signal_group integer NOT NULL CHECK (signal_group > 0),
    kind text NOT NULL CHECK (kind IN ('traffic', 'walk')),
    edge_id bigint NOT NULL REFERENCES :"model".edge ON DELETE CASCADE, control_point_id bigint, clear float8,
    PRIMARY KEY (controller_id, signal_group));
CREATE INDEX signal_group_edge ON :"model".signal_group (edge_id);
COMMENT ON TABLE :"model".signal_group IS
    'What shows the same signal: the movements of a street that have green in the same states, or people on foot at a '
    'crossing';
COMMENT ON COLUMN :"model".signal_group.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".signal_group.signal_group IS 'number from 1 within the controller, traffic first';
COMMENT ON COLUMN :"model".signal_group.kind IS 'traffic, or walk: people on foot';
COMMENT ON COLUMN :"model".signal_group.edge_id IS 'the street that traffic comes by, or that people cross';
COMMENT ON COLUMN :"model".signal_group.control_point_id IS 'the crossing: a control point; NULL: traffic';
COMMENT ON COLUMN :"model".signal_group.clear IS
    'whole steps of seconds in which people who have stepped on are across; NULL: traffic';

CREATE TABLE :"model".intergreen (
    controller_id bigint NOT NULL, ends integer NOT NULL, begins integer NOT NULL,
    seconds float8 NOT NULL CHECK (seconds >= 0),
    PRIMARY KEY (controller_id, ends, begins),
    FOREIGN KEY (controller_id, ends) REFERENCES :"model".signal_group ON DELETE CASCADE,
    FOREIGN KEY (controller_id, begins) REFERENCES :"model".signal_group ON DELETE CASCADE);
CREATE INDEX intergreen_begins ON :"model".intergreen (controller_id, begins);
COMMENT ON TABLE :"model".intergreen IS
    'The time between greens of signal groups that meet: who enters last has passed before who begins comes there';
COMMENT ON COLUMN :"model".intergreen.controller_id IS 'the controller';
COMMENT ON COLUMN :"model".intergreen.ends IS 'the signal group whose green ends';
COMMENT ON COLUMN :"model".intergreen.begins IS 'the signal group whose green begins';
COMMENT ON COLUMN :"model".intergreen.seconds IS
    'from the end of the one green to the start of the other one, at least';

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
