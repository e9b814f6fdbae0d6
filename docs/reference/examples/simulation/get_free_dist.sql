-- argument car_id: key of a row of table car
-- argument at: time of the signals, seconds
-- argument horizon: how far ahead, metres
-- see get_leader
SELECT streetgen.create_model('alone', 2154, driving_side => 'right'), streetgen.create_traffic('alone');
INSERT INTO alone.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2);
INSERT INTO alone.car (axis_id, abscissa, lane_position, along_axis) VALUES (1, 50, 2, true), (1, 80, 2, true);
SELECT round(streetgen.get_free_dist('alone', 1)) AS gap;
