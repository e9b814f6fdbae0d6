-- argument duration: seconds
-- argument step: seconds
-- argument demand: object of flow or entries, and turns
-- argument seed: same seed, same rows
-- see simulate
SELECT streetgen.create_model('eventful', 2154, driving_side => 'right'), streetgen.create_traffic('eventful');
INSERT INTO eventful.axis (geom, width, lane_count, speed)
    VALUES ('SRID=2154;LINESTRING(650000 6860000, 650500 6860000)', 7, 2, 50);
INSERT INTO eventful.car (axis_id, abscissa, lane_position, along_axis, speed) VALUES (1, 20, 2, true, 50);
INSERT INTO eventful.traffic_event (kind, trigger, at, axis_id, abscissa, lane_position, along_axis)
    VALUES ('cross', 'gap', 60, 1, 200, 2, true);
SELECT traffic_event_id, round(t::numeric, 1) AS t, car_id, round(metres) AS metres
FROM streetgen.fired_events('eventful', 60);
