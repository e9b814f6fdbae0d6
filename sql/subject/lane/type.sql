-- Decisions about lanes, as the core takes them.

CREATE TYPE streetgen.street_lane AS (axis_id bigint, abscissa float8, ordinality integer, along_axis boolean,
    both_ways boolean, width float8, line bytea);
COMMENT ON TYPE streetgen.street_lane IS
    'A lane by hand: direction, width and line, each NULL where it stays as computed.';
COMMENT ON COLUMN streetgen.street_lane.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_lane.abscissa IS 'a place on the edge, m along the axis';
COMMENT ON COLUMN streetgen.street_lane.ordinality IS 'number of the lane on the edge';
COMMENT ON COLUMN streetgen.street_lane.along_axis IS 'does traffic run along the axis?';
COMMENT ON COLUMN streetgen.street_lane.both_ways IS 'do both directions use it? Then along_axis counts for nothing';
COMMENT ON COLUMN streetgen.street_lane.width IS 'm';
COMMENT ON COLUMN streetgen.street_lane.line IS 'LINESTRING, EWKB';

CREATE TYPE streetgen.street_lane_change AS (axis_id bigint, abscissa float8, lane_from integer, lane_to integer,
    change text);
COMMENT ON TYPE streetgen.street_lane_change IS 'Whether one may leave a lane for the one beside it, by hand.';
COMMENT ON COLUMN streetgen.street_lane_change.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_lane_change.abscissa IS 'a place on the edge of the lanes, m along the axis';
COMMENT ON COLUMN streetgen.street_lane_change.lane_from IS 'ordinality of the lane that one leaves';
COMMENT ON COLUMN streetgen.street_lane_change.lane_to IS 'ordinality of the lane beside it';
COMMENT ON COLUMN streetgen.street_lane_change.change IS 'allowed or forbidden';

CREATE TYPE streetgen.street_leaving AS (axis_id bigint, forward text, backward text, bare boolean);
COMMENT ON TYPE streetgen.street_leaving IS 'What a source says of leaving the lanes of an axis, and of their paint.';
COMMENT ON COLUMN streetgen.street_leaving.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_leaving.forward IS 'axis.change_forward';
COMMENT ON COLUMN streetgen.street_leaving.backward IS 'axis.change_backward';
COMMENT ON COLUMN streetgen.street_leaving.bare IS 'is axis.lane_markings no? Then nothing is painted on the lanes';

CREATE TYPE streetgen.street_marked AS (axis_id bigint);
COMMENT ON TYPE streetgen.street_marked IS 'An axis on whose lanes lay turn marks of another before the change.';
COMMENT ON COLUMN streetgen.street_marked.axis_id IS 'the axis';
