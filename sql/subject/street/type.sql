-- The rows that streetgen._streets computes streets from.
CREATE TYPE streetgen.street_axis AS (
    axis_id bigint, geom bytea, level integer, width float8, width_end float8, roadway_offset float8, radius float8,
        importance integer, speed float8,
    lanes_forward integer, lanes_backward integer, lanes_both integer, kind_forward text, kind_backward text,
    lane_width_forward text, lane_width_backward text, turn_forward text, turn_backward text,
    changed boolean, outer_axis boolean
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
COMMENT ON COLUMN streetgen.street_axis.turn_forward IS
    'turns painted on the lanes along the axis, parted by |; NULL: none';
COMMENT ON COLUMN streetgen.street_axis.turn_backward IS
    'turns painted on the lanes against the axis, parted by |; NULL: none';
COMMENT ON COLUMN streetgen.street_axis.changed IS 'was it changed? What that can change is asked for';
COMMENT ON COLUMN streetgen.street_axis.outer_axis IS 'is it there for the others only, its rows not to be written?';

CREATE TYPE streetgen.street_transition AS (axis_id bigint, which text, kind text, length float8);
COMMENT ON TYPE streetgen.street_transition IS
    'The change of width at one end of an axis, instead of the settings transition_kind and transition_length.';
COMMENT ON COLUMN streetgen.street_transition.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_transition.which IS 'which end: start or end';
COMMENT ON COLUMN streetgen.street_transition.kind IS 'symmetric, left or right';
COMMENT ON COLUMN streetgen.street_transition.length IS 'm';

CREATE TYPE streetgen.street_limit AS (axis_id bigint, abscissa float8, which text);
COMMENT ON TYPE streetgen.street_limit IS 'Where the intersection at one end of an edge ends, by hand.';
COMMENT ON COLUMN streetgen.street_limit.axis_id IS 'the axis of the edge';
COMMENT ON COLUMN streetgen.street_limit.abscissa IS 'the place, m along the axis';
COMMENT ON COLUMN streetgen.street_limit.which IS 'which end of the edge: start or end';

CREATE TYPE streetgen.street_corner AS (axis_a bigint, axis_b bigint, x float8, y float8, radius float8);
COMMENT ON TYPE streetgen.street_corner IS
    'The radius of a corner by hand, counter-clockwise from one axis to the next at a node.';
COMMENT ON COLUMN streetgen.street_corner.axis_a IS 'the axis it begins at';
COMMENT ON COLUMN streetgen.street_corner.axis_b IS 'the axis it ends at';
COMMENT ON COLUMN streetgen.street_corner.x IS 'abscissa of a place near the node, in the plane';
COMMENT ON COLUMN streetgen.street_corner.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_corner.radius IS 'm';

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

CREATE TYPE streetgen.street_restriction AS (from_axis bigint, to_axis bigint, x float8, y float8, kind text,
    turn text, except_kinds text);
COMMENT ON TYPE streetgen.street_restriction IS 'What traffic may not do at a node, or only may.';
COMMENT ON COLUMN streetgen.street_restriction.from_axis IS 'the axis that traffic comes by';
COMMENT ON COLUMN streetgen.street_restriction.to_axis IS 'the axis that it goes on by';
COMMENT ON COLUMN streetgen.street_restriction.x IS 'abscissa of a place near the node, in the plane';
COMMENT ON COLUMN streetgen.street_restriction.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_restriction.kind IS 'no or only';
COMMENT ON COLUMN streetgen.street_restriction.turn IS
    'through, left, right or u_turn, where both axes go on beyond the node; NULL: any';
COMMENT ON COLUMN streetgen.street_restriction.except_kinds IS
    'kinds of lanes that it does not bind, parted by |; NULL: it binds all';

CREATE TYPE streetgen.street_control AS (axis_id bigint, abscissa float8, kind text, direction text);
COMMENT ON TYPE streetgen.street_control IS 'A control point: what tells traffic to wait or to look out.';
COMMENT ON COLUMN streetgen.street_control.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_control.abscissa IS 'its place, m along the axis';
COMMENT ON COLUMN streetgen.street_control.kind IS 'signals, stop, yield, mini_roundabout or pedestrian_crossing';
COMMENT ON COLUMN streetgen.street_control.direction IS
    'the traffic that it speaks to: direct (along the axis), reverse or both; NULL: unknown';
CREATE TYPE streetgen.street_junction AS (axis_id bigint, x float8, y float8, kind text);
COMMENT ON TYPE streetgen.street_junction IS 'The kind of a node by hand.';
COMMENT ON COLUMN streetgen.street_junction.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_junction.x IS 'abscissa of a place near a node of the axis, in the plane';
COMMENT ON COLUMN streetgen.street_junction.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_junction.kind IS 'a kind of junction';
CREATE TYPE streetgen.street_lane_change AS (axis_id bigint, abscissa float8, lane_from integer, lane_to integer,
    change text);
COMMENT ON TYPE streetgen.street_lane_change IS 'Whether one may leave a lane for the one beside it, by hand.';
COMMENT ON COLUMN streetgen.street_lane_change.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_lane_change.abscissa IS 'a place on the edge of the lanes, m along the axis';
COMMENT ON COLUMN streetgen.street_lane_change.lane_from IS 'ordinality of the lane that one leaves';
COMMENT ON COLUMN streetgen.street_lane_change.lane_to IS 'ordinality of the lane beside it';
COMMENT ON COLUMN streetgen.street_lane_change.change IS 'allowed or forbidden';
CREATE TYPE streetgen.street_leaving AS (axis_id bigint, forward text, backward text);
COMMENT ON TYPE streetgen.street_leaving IS 'What a source says of leaving the lanes of an axis.';
COMMENT ON COLUMN streetgen.street_leaving.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_leaving.forward IS 'axis.change_forward';
COMMENT ON COLUMN streetgen.street_leaving.backward IS 'axis.change_backward';
CREATE TYPE streetgen.street_overpass AS (axis_above bigint, axis_below bigint, x float8, y float8,
    clearance float8);
COMMENT ON TYPE streetgen.street_overpass IS 'Which of two axes passes over the other where they cross, by hand.';
COMMENT ON COLUMN streetgen.street_overpass.axis_above IS 'the axis that passes over';
COMMENT ON COLUMN streetgen.street_overpass.axis_below IS 'the axis below';
COMMENT ON COLUMN streetgen.street_overpass.x IS 'abscissa of a place near the crossing, in the plane';
COMMENT ON COLUMN streetgen.street_overpass.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_overpass.clearance IS 'm from roadway to roadway; NULL: setting clearance';

CREATE TYPE streetgen.street_circulation AS (axis_id bigint, abscissa float8, along_axis boolean, turned boolean);
COMMENT ON TYPE streetgen.street_circulation IS 'An edge of a roundabout, on which traffic goes round.';
COMMENT ON COLUMN streetgen.street_circulation.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_circulation.abscissa IS 'a place on the edge, m along the axis';
COMMENT ON COLUMN streetgen.street_circulation.along_axis IS 'does this traffic drive along the axis?';
COMMENT ON COLUMN streetgen.street_circulation.turned IS
    'do all its lanes go round, since no source states a direction?';

CREATE TYPE streetgen.former_edge AS (
    axis_id bigint, start_abscissa float8, end_abscissa float8, geom bytea, wanted_start float8, start float8,
        border_start bytea, wanted_end float8, "end" float8, border_end bytea, surface bytea,
        contested boolean, level integer, borders bytea
);
COMMENT ON TYPE streetgen.former_edge IS 'An edge as it was before a change, with its section limits and its section.';
COMMENT ON COLUMN streetgen.former_edge.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.former_edge.start_abscissa IS 'where it began, m along its axis';
COMMENT ON COLUMN streetgen.former_edge.end_abscissa IS 'where it ended, m along its axis';
COMMENT ON COLUMN streetgen.former_edge.geom IS 'LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.wanted_start IS 'limit wanted at its start, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.start IS 'limit at its start, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.border_start IS 'border line there, LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.wanted_end IS 'limit wanted at its end, m along the edge';
COMMENT ON COLUMN streetgen.former_edge."end" IS 'limit at its end, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.border_end IS 'border line there, LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.surface IS 'its section, MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.former_edge.contested IS 'did part of the section''s ground belong to another surface?';
COMMENT ON COLUMN streetgen.former_edge.level IS 'level of the section';
COMMENT ON COLUMN streetgen.former_edge.borders IS
    'numbers of column borders of the section, each as float8send writes it; empty: there were none';

CREATE TYPE streetgen.former_node AS (x float8, y float8, surface bytea, contested boolean, level integer);
COMMENT ON TYPE streetgen.former_node IS 'A node as it was before a change, with its intersection.';
COMMENT ON COLUMN streetgen.former_node.x IS 'abscissa in the plane';
COMMENT ON COLUMN streetgen.former_node.y IS 'ordinate in the plane';
COMMENT ON COLUMN streetgen.former_node.surface IS 'its intersection, MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.former_node.level IS 'level of the intersection';
COMMENT ON COLUMN streetgen.former_node.contested IS
    'did part of the intersection''s ground belong to another surface?';

CREATE TYPE streetgen.street_neighbour AS (x float8, y float8, x_end float8, y_end float8, surface bytea,
    level integer);
COMMENT ON TYPE streetgen.street_neighbour IS
    'A section or an intersection beside what a change writes, as it is there and stays.';
COMMENT ON COLUMN streetgen.street_neighbour.x IS
    'abscissa in the plane of the intersection''s node, or of that at the section''s start';
COMMENT ON COLUMN streetgen.street_neighbour.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_neighbour.x_end IS
    'abscissa in the plane of the node at the section''s end; NULL: it is an intersection';
COMMENT ON COLUMN streetgen.street_neighbour.y_end IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_neighbour.surface IS 'MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.street_neighbour.level IS 'level of the surface';

CREATE TYPE streetgen.street_bend AS (axis_id bigint, abscissa float8, radius float8);
COMMENT ON TYPE streetgen.street_bend IS 'The radius of a bend of an axis, by hand.';
COMMENT ON COLUMN streetgen.street_bend.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_bend.abscissa IS 'the place, m along the axis';
COMMENT ON COLUMN streetgen.street_bend.radius IS 'm; 0: it stays sharp';

CREATE TYPE streetgen.road_part AS (edge_id bigint, axis_id bigint, from_node bigint, to_node bigint, level integer,
    start_abscissa float8, end_abscissa float8, line bytea);
COMMENT ON TYPE streetgen.road_part IS 'An edge that is to become part of a road.';
COMMENT ON COLUMN streetgen.road_part.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.road_part.axis_id IS 'its axis';
COMMENT ON COLUMN streetgen.road_part.from_node IS 'node at its start';
COMMENT ON COLUMN streetgen.road_part.to_node IS 'node at its end';
COMMENT ON COLUMN streetgen.road_part.level IS 'its level';
COMMENT ON COLUMN streetgen.road_part.start_abscissa IS 'where it starts, m along the axis';
COMMENT ON COLUMN streetgen.road_part.end_abscissa IS 'where it ends, m along the axis';
COMMENT ON COLUMN streetgen.road_part.line IS 'its line, LINESTRING, or its arc road, COMPOUNDCURVE; EWKB';
