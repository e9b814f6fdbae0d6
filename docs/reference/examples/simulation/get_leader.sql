-- argument car_id: key of a row of table car
-- argument at: time of the signals, seconds
-- argument horizon: how far ahead, metres
-- see leaders, get_free_dist
SELECT streetgen.create_model('led', 2154, driving_side => 'right'), streetgen.create_traffic('led');
INSERT INTO led.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2);
INSERT INTO led.car (axis_id, abscissa, lane_position, along_axis) VALUES (1, 50, 2, true), (1, 80, 2, true);
SELECT leader, round(gap) AS gap FROM streetgen.get_leader('led', 1);
