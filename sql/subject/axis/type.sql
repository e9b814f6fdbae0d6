-- Axes and what stands at them, as the core takes them.

CREATE TYPE streetgen.street_axis AS (
    axis_id bigint, geom bytea, level integer, width float8, width_end float8, roadway_offset float8, radius float8,
        importance integer, speed float8,
    lanes_forward integer, lanes_backward integer, lanes_both integer, kind_forward text, kind_backward text,
    lane_width_forward text, lane_width_backward text, lane_width_maximal float8, turn_forward text,
    turn_backward text, access text, on_ring boolean, street bigint, changed boolean, outer_axis boolean,
    area bytea
);
COMMENT ON TYPE streetgen.street_axis IS 'An axis with the values used, and what an edit has to do with it.';
COMMENT ON COLUMN streetgen.street_axis.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_axis.geom IS 'LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.street_axis.level IS 'axes of other levels do not meet it';
COMMENT ON COLUMN streetgen.street_axis.width IS 'width kerb to kerb at its start, m';
COMMENT ON COLUMN streetgen.street_axis.width_end IS 'width kerb to kerb at its end, m';
COMMENT ON COLUMN streetgen.street_axis.roadway_offset IS
    'from the axis to the middle of the roadway, m, left positive';
COMMENT ON COLUMN streetgen.street_axis.radius IS 'radius that its corners want, m';
COMMENT ON COLUMN streetgen.street_axis.importance IS '1 highest';
COMMENT ON COLUMN streetgen.street_axis.speed IS 'km/h';
COMMENT ON COLUMN streetgen.street_axis.lanes_forward IS 'lanes along the axis';
COMMENT ON COLUMN streetgen.street_axis.lanes_backward IS 'lanes against the axis';
COMMENT ON COLUMN streetgen.street_axis.lanes_both IS 'lanes that both directions use';
COMMENT ON COLUMN streetgen.street_axis.kind_forward IS 'kinds of the lanes along the axis, parted by |; NULL: general';
COMMENT ON COLUMN streetgen.street_axis.kind_backward IS
    'kinds of the lanes against the axis, parted by |; NULL: general';
COMMENT ON COLUMN streetgen.street_axis.lane_width_forward IS
    'widths of the lanes along the axis, m, parted by |; NULL: shares';
COMMENT ON COLUMN streetgen.street_axis.lane_width_backward IS
    'widths of the lanes against the axis, m, parted by |; NULL: shares';
COMMENT ON COLUMN streetgen.street_axis.lane_width_maximal IS
    'lanes that say no width grow at most so wide, m; NULL: they fill the roadway';
COMMENT ON COLUMN streetgen.street_axis.turn_forward IS
    'turns painted on the lanes along the axis, parted by |; NULL: none';
COMMENT ON COLUMN streetgen.street_axis.turn_backward IS
    'turns painted on the lanes against the axis, parted by |; NULL: none';
COMMENT ON COLUMN streetgen.street_axis.access IS
    'who may drive, as in axis.access: the kind that general lanes become; NULL: all';
COMMENT ON COLUMN streetgen.street_axis.on_ring IS
    'does its source say that it is part of a roundabout?';
COMMENT ON COLUMN streetgen.street_axis.street IS 'a number of its name; 0: none';
COMMENT ON COLUMN streetgen.street_axis.changed IS 'was it changed? What that can change is asked for';
COMMENT ON COLUMN streetgen.street_axis.area IS
    'areas at whose border its surfaces end, MULTIPOLYGON, EWKB; NULL: none';
COMMENT ON COLUMN streetgen.street_axis.outer_axis IS 'is it there for the others only, its rows not to be written?';

CREATE TYPE streetgen.street_control AS (axis_id bigint, abscissa float8, kind text, direction text);
COMMENT ON TYPE streetgen.street_control IS 'A control point: what tells traffic to wait or to look out.';
COMMENT ON COLUMN streetgen.street_control.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_control.abscissa IS 'its place, m along the axis';
COMMENT ON COLUMN streetgen.street_control.kind IS 'signals, stop, yield, mini_roundabout or pedestrian_crossing';
COMMENT ON COLUMN streetgen.street_control.direction IS
    'the traffic that it speaks to: direct (along the axis), reverse or both; NULL: unknown';
