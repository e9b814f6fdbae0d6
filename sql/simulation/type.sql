-- What the network of links is made of.

CREATE TYPE streetgen.traffic_edge AS (edge_id bigint, geom bytea, widest float8);
COMMENT ON TYPE streetgen.traffic_edge IS 'An edge whose lanes are links.';
COMMENT ON COLUMN streetgen.traffic_edge.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.traffic_edge.geom IS 'its line (EWKB), with heights where they are known';
COMMENT ON COLUMN streetgen.traffic_edge.widest IS 'no lane lies farther from the line, m';

CREATE TYPE streetgen.traffic_lane AS (link_id bigint, edge_id bigint, along boolean, starts float8, ends float8,
    stop float8, width float8, speed float8, traffic text, from_node bigint, to_node bigint, junction_id bigint,
    other_way bigint, geom bytea);
COMMENT ON TYPE streetgen.traffic_lane IS 'A lane in one direction.';
COMMENT ON COLUMN streetgen.traffic_lane.link_id IS 'key of its link';
COMMENT ON COLUMN streetgen.traffic_lane.edge_id IS 'its edge';
COMMENT ON COLUMN streetgen.traffic_lane.along IS 'does its traffic run along the axis?';
COMMENT ON COLUMN streetgen.traffic_lane.starts IS 'where the lane starts, metres along the edge';
COMMENT ON COLUMN streetgen.traffic_lane.ends IS 'where it ends, metres along the edge';
COMMENT ON COLUMN streetgen.traffic_lane.stop IS 'of its stop line, metres before the end of the link';
COMMENT ON COLUMN streetgen.traffic_lane.width IS 'm';
COMMENT ON COLUMN streetgen.traffic_lane.speed IS 'that is allowed, km/h';
COMMENT ON COLUMN streetgen.traffic_lane.traffic IS 'who alone may drive there, by kinds of lanes; NULL: all';
COMMENT ON COLUMN streetgen.traffic_lane.from_node IS 'node where the link begins';
COMMENT ON COLUMN streetgen.traffic_lane.to_node IS 'node where it ends';
COMMENT ON COLUMN streetgen.traffic_lane.junction_id IS 'junction that it leads to; NULL: none';
COMMENT ON COLUMN streetgen.traffic_lane.other_way IS 'link of its other direction; NULL: it has one direction';
COMMENT ON COLUMN streetgen.traffic_lane.geom IS 'its line (EWKB), in the direction of its traffic';

CREATE TYPE streetgen.traffic_movement AS (link_id bigint, lane_in bigint, lane_out bigint, width float8,
    traffic text, turn text, rank integer, importance integer, precedence integer, junction_id bigint,
    controller_id bigint, geom bytea);
COMMENT ON TYPE streetgen.traffic_movement IS 'A movement from lane to lane.';
COMMENT ON COLUMN streetgen.traffic_movement.link_id IS 'key of its link';
COMMENT ON COLUMN streetgen.traffic_movement.lane_in IS 'link of the lane that it comes from';
COMMENT ON COLUMN streetgen.traffic_movement.lane_out IS 'link of the lane that it leads to';
COMMENT ON COLUMN streetgen.traffic_movement.width IS 'm';
COMMENT ON COLUMN streetgen.traffic_movement.traffic IS 'who alone may take it, by kinds of lanes; NULL: all';
COMMENT ON COLUMN streetgen.traffic_movement.turn IS 'through, left, right or u_turn';
COMMENT ON COLUMN streetgen.traffic_movement.rank IS 'of two movements the one of the smaller rank goes first';
COMMENT ON COLUMN streetgen.traffic_movement.importance IS
    'of two of equal rank the one of the smaller importance does';
COMMENT ON COLUMN streetgen.traffic_movement.precedence IS
    'of two that have green together the one of the smaller does';
COMMENT ON COLUMN streetgen.traffic_movement.junction_id IS 'junction that it crosses; NULL: none';
COMMENT ON COLUMN streetgen.traffic_movement.controller_id IS 'controller whose signal it obeys; NULL: none';
COMMENT ON COLUMN streetgen.traffic_movement.geom IS 'its line (EWKB), in the direction of its traffic';

CREATE TYPE streetgen.traffic_beside AS (link_id bigint, beside bigint, at_left boolean, may_change boolean,
    opposite boolean, starts float8, ends float8);
COMMENT ON TYPE streetgen.traffic_beside IS 'A lane beside another one.';
COMMENT ON COLUMN streetgen.traffic_beside.link_id IS 'a link';
COMMENT ON COLUMN streetgen.traffic_beside.beside IS 'the link that lies beside it';
COMMENT ON COLUMN streetgen.traffic_beside.at_left IS 'does that lie on the left of who drives on link_id?';
COMMENT ON COLUMN streetgen.traffic_beside.may_change IS 'may one change to it?';
COMMENT ON COLUMN streetgen.traffic_beside.opposite IS 'does its traffic come towards?';
COMMENT ON COLUMN streetgen.traffic_beside.starts IS 'from where, metres along the edge';
COMMENT ON COLUMN streetgen.traffic_beside.ends IS 'to where, metres along the edge';

CREATE TYPE streetgen.traffic_aspect AS (link_id bigint, since float8, aspect text);
COMMENT ON TYPE streetgen.traffic_aspect IS 'What a signal shows a movement.';
COMMENT ON COLUMN streetgen.traffic_aspect.link_id IS 'the movement';
COMMENT ON COLUMN streetgen.traffic_aspect.since IS 'from when on, seconds of the cycle';
COMMENT ON COLUMN streetgen.traffic_aspect.aspect IS 'red, amber, permitted or protected';

CREATE TYPE streetgen.traffic_plan AS (controller_id bigint, cycle float8, start_offset float8);
COMMENT ON TYPE streetgen.traffic_plan IS 'When the cycles of a controller begin.';
COMMENT ON COLUMN streetgen.traffic_plan.controller_id IS 'the controller';
COMMENT ON COLUMN streetgen.traffic_plan.cycle IS 'its length, seconds';
COMMENT ON COLUMN streetgen.traffic_plan.start_offset IS 'when a cycle begins, seconds';

CREATE TYPE streetgen.traffic_car AS (car_id bigint, link_id bigint, metres float8, speed float8, length float8,
    width float8, kind text, route bigint[]);
COMMENT ON TYPE streetgen.traffic_car IS 'A car at the place of its front.';
COMMENT ON COLUMN streetgen.traffic_car.car_id IS 'its key';
COMMENT ON COLUMN streetgen.traffic_car.link_id IS 'the link that its front is on';
COMMENT ON COLUMN streetgen.traffic_car.metres IS 'of its front, along the link';
COMMENT ON COLUMN streetgen.traffic_car.speed IS 'km/h';
COMMENT ON COLUMN streetgen.traffic_car.length IS 'm';
COMMENT ON COLUMN streetgen.traffic_car.width IS 'm';
COMMENT ON COLUMN streetgen.traffic_car.kind IS 'car, bus, carpool or cycle';
COMMENT ON COLUMN streetgen.traffic_car.route IS 'links that it follows; NULL: straight on';

CREATE TYPE streetgen.following AS (speed float8, desired_speed float8, gap float8, leader_speed float8,
    leader_acceleration float8);
COMMENT ON TYPE streetgen.following IS
    'A car and what is ahead of it, as a law of acceleration for streetgen.simulate takes it.';
COMMENT ON COLUMN streetgen.following.speed IS 'of the car, m/s';
COMMENT ON COLUMN streetgen.following.desired_speed IS 'that it would drive if nobody were ahead, m/s';
COMMENT ON COLUMN streetgen.following.gap IS
    'from its front to the rear of who is ahead, or to where it must stand, metres; infinite where nobody is';
COMMENT ON COLUMN streetgen.following.leader_speed IS 'of who is ahead, m/s';
COMMENT ON COLUMN streetgen.following.leader_acceleration IS 'of who is ahead, m/s2';

CREATE TYPE streetgen.traffic_event AS (event_id bigint, kind text, trigger text, link_id bigint, metres float8,
    at float8, car_id bigint, speed float8, deceleration float8, duration float8);
COMMENT ON TYPE streetgen.traffic_event IS 'What is to happen in a simulation.';
COMMENT ON COLUMN streetgen.traffic_event.event_id IS 'its key';
COMMENT ON COLUMN streetgen.traffic_event.kind IS 'brake, breakdown, overtake, pull_out or cross';
COMMENT ON COLUMN streetgen.traffic_event.trigger IS 'time, place or gap';
COMMENT ON COLUMN streetgen.traffic_event.link_id IS 'the link of its place';
COMMENT ON COLUMN streetgen.traffic_event.metres IS 'along the link';
COMMENT ON COLUMN streetgen.traffic_event.at IS 'seconds of a time, metres of a gap';
COMMENT ON COLUMN streetgen.traffic_event.car_id IS 'whose it is; NULL: of whichever comes first';
COMMENT ON COLUMN streetgen.traffic_event.speed IS 'km/h';
COMMENT ON COLUMN streetgen.traffic_event.deceleration IS 'm/s2';
COMMENT ON COLUMN streetgen.traffic_event.duration IS 'seconds';
