-- A row in each table of decisions of the quarter of data/quarter.sql, made of all subjects; rules of objects, and objects by hand.
INSERT INTO quarter.axis (geom, width, lane_count, direction, kind, speed) VALUES
  ('SRID=2154;LINESTRING(652000 6860000, 652300 6860000)', 10.5, 3, 'direct', 'motorway', 100), ('SRID=2154;LINESTRING(652300 6860000, 652700 6860000)', 10.5, 3, 'direct', 'motorway', 100),
  ('SRID=2154;LINESTRING(652060 6859936, 652300 6860000)', 3.5, 1, 'direct', 'motorway_link', 50);
INSERT INTO quarter.control_point (geom, kind) SELECT geom, 'signals' FROM quarter.node WHERE ST_DWithin(geom, 'SRID=2154;POINT(650120 6860000)', 1);
UPDATE quarter.section_limit_editing SET abscissa = abscissa + 1 WHERE section_limit_id = (SELECT min(section_limit_id) FROM quarter.section_limit WHERE which = 'start');
UPDATE quarter.corner_editing SET radius = 3 WHERE corner_id = (SELECT min(corner_id) FROM quarter.corner);
UPDATE quarter.lane_editing SET width = 2.9 WHERE lane_id = (SELECT min(lane_id) FROM quarter.lane);
UPDATE quarter.lane_adjacency_editing SET change = 'forbidden' WHERE lane_adjacency_id = (SELECT min(lane_adjacency_id) FROM quarter.lane_adjacency WHERE change = 'allowed');
UPDATE quarter.interconnection_editing SET connecting = NOT connecting WHERE interconnection_id = (SELECT min(interconnection_id) FROM quarter.interconnection);
UPDATE quarter.sidewalk_editing SET width = width + 0.5 WHERE sidewalk_id = (SELECT min(sidewalk_id) FROM quarter.sidewalk_editing);
UPDATE quarter.junction_editing SET kind = 'stop' WHERE junction_id = (SELECT min(junction_id) FROM quarter.junction WHERE kind = 'priority');
UPDATE quarter.controller_editing SET start_offset = 5 WHERE controller_id = (SELECT min(controller_id) FROM quarter.controller);
UPDATE quarter.ramp_editing SET length = 90, tangent = 30;
UPDATE quarter.overpass_editing SET clearance = 6.5 WHERE overpass_id = (SELECT min(overpass_id) FROM quarter.overpass);
UPDATE quarter.roundabout_editing SET confirmed = true WHERE roundabout_id = (SELECT min(roundabout_id) FROM quarter.roundabout);
UPDATE quarter.block_editing SET kind = 'strip' WHERE block_id = (SELECT min(block_id) FROM quarter.block WHERE kind = 'block');
UPDATE quarter.road_arc_editing SET radius = 12 WHERE road_arc_id = (SELECT min(road_arc_id) FROM quarter.road_arc_editing);
INSERT INTO quarter.kerb_point_editing (geom) SELECT ST_Translate(ST_LineInterpolatePoint(geom, 0.5), 1, 5) FROM quarter.axis WHERE axis_id = 3;
INSERT INTO quarter.height_editing (height, geom) SELECT 12, ST_LineInterpolatePoint(geom, 0.3) FROM quarter.axis WHERE axis_id = 2;
INSERT INTO quarter.transition_override (axis_id, which, kind, length) VALUES (2, 'start', 'left', 15);
INSERT INTO quarter.turn_restriction (geom, from_axis, to_axis, kind) VALUES ('SRID=2154;POINT(650120 6860000)', 1, 5, 'no');
INSERT INTO quarter.placement_rule (type, along, side, every, axis_offset) VALUES ('lamp', 'border', 'alternating', 25, 0.8), ('parking_bay', 'border', 'right', 6, 0);
INSERT INTO quarter.placement_rule (type, along, side) VALUES ('crossing', 'arm', 'alternating');
INSERT INTO quarter.street_object_editing (type, geom) SELECT 'bench', ST_Translate(ST_LineInterpolatePoint(geom, 0.5), 1, 9) FROM quarter.axis WHERE axis_id = 1;
DELETE FROM quarter.street_object_editing WHERE street_object_id = (SELECT min(street_object_id) FROM quarter.street_object WHERE type = 'lamp');
UPDATE quarter.street_object_editing SET geom = ST_Translate(geom, 1, 0) WHERE street_object_id = (SELECT min(street_object_id) FROM quarter.street_object WHERE type = 'lamp');
