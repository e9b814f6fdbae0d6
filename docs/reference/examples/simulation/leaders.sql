-- argument at: time of the signals, seconds
-- argument horizon: how far ahead, metres
-- see free_path, place_cars, simulate
SELECT streetgen.create_model('queue', 2154, driving_side => 'right'), streetgen.create_traffic('queue');
INSERT INTO queue.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2);
INSERT INTO queue.car (axis_id, abscissa, lane_position, along_axis, speed) VALUES (1, 50, 2, true, 50), (1, 80, 2, true, 30);
SELECT car_id, leader, virtual, round(gap) AS gap, speed FROM streetgen.leaders('queue') ORDER BY car_id;
