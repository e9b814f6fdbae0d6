-- The rows that junctions and the paths across them are computed from.
CREATE TYPE streetgen.junction_edge_input AS (edge_id bigint, axis_id bigint, start_abscissa float8,
    end_abscissa float8, from_node bigint, to_node bigint, geom bytea, along boolean, against boolean, name bigint,
    crossed boolean,
    on_ring boolean, by_hand boolean, importance integer, width float8, width_end float8);
COMMENT ON TYPE streetgen.junction_edge_input IS 'An edge, as far as the rules of junctions ask for it.';
COMMENT ON COLUMN streetgen.junction_edge_input.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.junction_edge_input.axis_id IS 'its axis';
COMMENT ON COLUMN streetgen.junction_edge_input.start_abscissa IS 'where it begins, m along its axis';
COMMENT ON COLUMN streetgen.junction_edge_input.end_abscissa IS 'where it ends, m along its axis';
COMMENT ON COLUMN streetgen.junction_edge_input.from_node IS 'the node at its start';
COMMENT ON COLUMN streetgen.junction_edge_input.to_node IS 'the node at its end';
COMMENT ON COLUMN streetgen.junction_edge_input.geom IS 'LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.junction_edge_input.along IS 'does traffic run along it?';
COMMENT ON COLUMN streetgen.junction_edge_input.against IS 'does traffic run against it?';
COMMENT ON COLUMN streetgen.junction_edge_input.name IS 'a hash of the name of its street; 0: unknown';
COMMENT ON COLUMN streetgen.junction_edge_input.crossed IS 'did its section limits cross?';
COMMENT ON COLUMN streetgen.junction_edge_input.on_ring IS 'is it part of a roundabout?';
COMMENT ON COLUMN streetgen.junction_edge_input.by_hand IS 'by hand: inside its junction or not; NULL: by the rules';
COMMENT ON COLUMN streetgen.junction_edge_input.importance IS '1 highest';
COMMENT ON COLUMN streetgen.junction_edge_input.width IS 'kerb to kerb at its start, m';
COMMENT ON COLUMN streetgen.junction_edge_input.width_end IS 'kerb to kerb at its end, m';

CREATE TYPE streetgen.junction_leg AS (junction_id bigint, edge_id bigint, at_start boolean, axis_id bigint,
    node_id bigint, importance integer, speed float8, on_ring boolean, border_line bytea);
COMMENT ON TYPE streetgen.junction_leg IS 'An end of an edge that leaves a junction.';
COMMENT ON COLUMN streetgen.junction_leg.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_leg.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.junction_leg.at_start IS 'is it the start of the edge?';
COMMENT ON COLUMN streetgen.junction_leg.axis_id IS 'the axis of the edge';
COMMENT ON COLUMN streetgen.junction_leg.node_id IS 'the node at that end';
COMMENT ON COLUMN streetgen.junction_leg.importance IS '1 highest';
COMMENT ON COLUMN streetgen.junction_leg.speed IS 'km/h';
COMMENT ON COLUMN streetgen.junction_leg.on_ring IS 'is its edge part of a roundabout?';
COMMENT ON COLUMN streetgen.junction_leg.border_line IS 'border line of the section limit there, LINESTRING, EWKB';

CREATE TYPE streetgen.junction_lane AS (junction_id bigint, edge_id bigint, at_start boolean, lane_id bigint,
    comes_in boolean, along_axis boolean, kind text, turn text, geom bytea);
COMMENT ON TYPE streetgen.junction_lane IS 'A lane that comes into a junction or leaves it.';
COMMENT ON COLUMN streetgen.junction_lane.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_lane.edge_id IS 'the edge of its leg';
COMMENT ON COLUMN streetgen.junction_lane.at_start IS 'is the leg the start of the edge?';
COMMENT ON COLUMN streetgen.junction_lane.lane_id IS 'the lane';
COMMENT ON COLUMN streetgen.junction_lane.comes_in IS 'does its traffic come in?';
COMMENT ON COLUMN streetgen.junction_lane.along_axis IS 'does that traffic run along the axis?';
COMMENT ON COLUMN streetgen.junction_lane.kind IS 'general, bus, carpool or cycle';
COMMENT ON COLUMN streetgen.junction_lane.turn IS 'turns painted on it; NULL: none';
COMMENT ON COLUMN streetgen.junction_lane.geom IS 'LINESTRING in the direction of that traffic, EWKB';

CREATE TYPE streetgen.junction_inner_edge AS (junction_id bigint, edge_id bigint, axis_id bigint, from_node bigint,
    to_node bigint, along text, against text, offset_along float8, offset_against float8, geom bytea);
COMMENT ON TYPE streetgen.junction_inner_edge IS 'An edge inside a junction.';
COMMENT ON COLUMN streetgen.junction_inner_edge.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_inner_edge.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.junction_inner_edge.axis_id IS 'its axis';
COMMENT ON COLUMN streetgen.junction_inner_edge.from_node IS 'the node at its start';
COMMENT ON COLUMN streetgen.junction_inner_edge.to_node IS 'the node at its end';
COMMENT ON COLUMN streetgen.junction_inner_edge.along IS
    'kinds of the lanes along it, parted by |; NULL: no traffic';
COMMENT ON COLUMN streetgen.junction_inner_edge.against IS 'the same against it';
COMMENT ON COLUMN streetgen.junction_inner_edge.offset_along IS
    'of the lanes of that traffic, m to the left of the edge';
COMMENT ON COLUMN streetgen.junction_inner_edge.offset_against IS 'the same of the traffic against it';
COMMENT ON COLUMN streetgen.junction_inner_edge.geom IS 'LINESTRING, EWKB';

CREATE TYPE streetgen.junction_step AS (junction_id bigint, interconnection_id bigint, lane_in bigint, lane_out bigint,
    along_in boolean, along_out boolean, plausible boolean);
COMMENT ON TYPE streetgen.junction_step IS 'A path from lane to lane at one node of a junction.';
COMMENT ON COLUMN streetgen.junction_step.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_step.interconnection_id IS 'the path';
COMMENT ON COLUMN streetgen.junction_step.lane_in IS 'the lane that it comes from';
COMMENT ON COLUMN streetgen.junction_step.lane_out IS 'the lane that it leads to';
COMMENT ON COLUMN streetgen.junction_step.along_in IS 'does one drive along the axis of the first?';
COMMENT ON COLUMN streetgen.junction_step.along_out IS 'does one drive along the axis of the second?';
COMMENT ON COLUMN streetgen.junction_step.plausible IS 'would traffic take it?';

CREATE TYPE streetgen.junction_restriction AS (junction_id bigint, from_axis bigint, to_axis bigint, x float8, y float8,
    kind text, turn text, except_kinds text);
COMMENT ON TYPE streetgen.junction_restriction IS 'What traffic may not do at a node of a junction, or only may.';
COMMENT ON COLUMN streetgen.junction_restriction.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_restriction.from_axis IS 'the axis that traffic comes by';
COMMENT ON COLUMN streetgen.junction_restriction.to_axis IS 'the axis that it goes on by';
COMMENT ON COLUMN streetgen.junction_restriction.x IS 'abscissa of the node in the plane';
COMMENT ON COLUMN streetgen.junction_restriction.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.junction_restriction.kind IS 'no or only';
COMMENT ON COLUMN streetgen.junction_restriction.turn IS 'through, left, right or u_turn; NULL: any';
COMMENT ON COLUMN streetgen.junction_restriction.except_kinds IS
    'kinds of lanes that it does not bind; NULL: it binds all';

CREATE TYPE streetgen.junction_way_restriction AS (junction_id bigint, turn_restriction_id bigint, from_axis bigint,
    to_axis bigint, edge_id bigint, kind text, except_kinds text);
COMMENT ON TYPE streetgen.junction_way_restriction IS
    'What traffic may not do via edges inside a junction, or only may: a row for each edge, in their order.';
COMMENT ON COLUMN streetgen.junction_way_restriction.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_way_restriction.turn_restriction_id IS 'the restriction';
COMMENT ON COLUMN streetgen.junction_way_restriction.from_axis IS 'the axis that traffic comes by';
COMMENT ON COLUMN streetgen.junction_way_restriction.to_axis IS 'the axis that it goes on by';
COMMENT ON COLUMN streetgen.junction_way_restriction.edge_id IS 'an edge that it passes';
COMMENT ON COLUMN streetgen.junction_way_restriction.kind IS 'no or only';
COMMENT ON COLUMN streetgen.junction_way_restriction.except_kinds IS
    'kinds of lanes that it does not bind; NULL: it binds all';

CREATE TYPE streetgen.junction_ground AS (junction_id bigint, surface bytea);
COMMENT ON TYPE streetgen.junction_ground IS 'The surface of a junction.';
COMMENT ON COLUMN streetgen.junction_ground.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.junction_ground.surface IS 'MULTIPOLYGON, EWKB';

CREATE TYPE streetgen.junction_arm AS (edge_id bigint, kind text, importance integer, speed float8, width float8,
    lanes_in integer, lanes_out integer, azimuth float8, control text, on_ring boolean, highway_role text);
COMMENT ON TYPE streetgen.junction_arm IS 'A street at a junction, as a classifier sees it.';
COMMENT ON COLUMN streetgen.junction_arm.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.junction_arm.kind IS 'class of its axis; NULL: unknown';
COMMENT ON COLUMN streetgen.junction_arm.importance IS '1 highest';
COMMENT ON COLUMN streetgen.junction_arm.speed IS 'km/h';
COMMENT ON COLUMN streetgen.junction_arm.width IS 'width kerb to kerb at the junction, m';
COMMENT ON COLUMN streetgen.junction_arm.lanes_in IS 'lanes that come to the junction';
COMMENT ON COLUMN streetgen.junction_arm.lanes_out IS 'lanes that leave it';
COMMENT ON COLUMN streetgen.junction_arm.azimuth IS 'direction in which it leaves, degrees clockwise from the north';
COMMENT ON COLUMN streetgen.junction_arm.control IS
    'its control point: signals, stop, yield, mini_roundabout or pedestrian_crossing; NULL: none';
COMMENT ON COLUMN streetgen.junction_arm.on_ring IS 'is it part of a roundabout?';
COMMENT ON COLUMN streetgen.junction_arm.highway_role IS
    'what its class is at ramps: highway, fast_road, highway_link or link; NULL: nothing';

CREATE TYPE streetgen.junction_member AS (node_id bigint, edge_id bigint, junction_id bigint, chain bigint, role text,
    parted boolean, control_from text, control_to text, control bigint);
COMMENT ON TYPE streetgen.junction_member IS
    'A node of a junction, an edge at such a node, or a control point that speaks at one.';
COMMENT ON COLUMN streetgen.junction_member.node_id IS 'the node; NULL: the row is of another';
COMMENT ON COLUMN streetgen.junction_member.edge_id IS 'the edge; NULL: the row is of another';
COMMENT ON COLUMN streetgen.junction_member.junction_id IS 'the junction; NULL: the edge lies in none';
COMMENT ON COLUMN streetgen.junction_member.chain IS
    'of a node: the smallest node of those that the rules would join, however wide';
COMMENT ON COLUMN streetgen.junction_member.role IS 'of an edge in a junction: inside or slip_lane';
COMMENT ON COLUMN streetgen.junction_member.parted IS 'does the extent keep the nodes of the edge apart?';
COMMENT ON COLUMN streetgen.junction_member.control_from IS
    'control point of the traffic that comes to the start of the edge';
COMMENT ON COLUMN streetgen.junction_member.control_to IS
    'control point of the traffic that comes to the end of the edge';
COMMENT ON COLUMN streetgen.junction_member.control IS
    'the control point: its place in the list; NULL: the row is of another';

CREATE TYPE streetgen.junction_made AS (junction_id bigint, kind text, method text, geom geometry, nodes bigint);
COMMENT ON TYPE streetgen.junction_made IS 'A junction that a run makes.';
COMMENT ON COLUMN streetgen.junction_made.junction_id IS 'its smallest node';
COMMENT ON COLUMN streetgen.junction_made.kind IS 'its kind';
COMMENT ON COLUMN streetgen.junction_made.method IS 'hypothesis, grouped or by_hand';
COMMENT ON COLUMN streetgen.junction_made.geom IS 'the middle of its nodes, POINT';
COMMENT ON COLUMN streetgen.junction_made.nodes IS 'how many nodes it has';

CREATE TYPE streetgen.street_junction AS (axis_id bigint, x float8, y float8, kind text);
COMMENT ON TYPE streetgen.street_junction IS 'The kind of a node by hand.';
COMMENT ON COLUMN streetgen.street_junction.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_junction.x IS 'abscissa of a place near a node of the axis, in the plane';
COMMENT ON COLUMN streetgen.street_junction.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_junction.kind IS 'a kind of junction';
