-- see drop_traffic, place_cars
SELECT streetgen.create_model('driven', 2154, driving_side => 'right');
INSERT INTO driven.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2);
SELECT streetgen.create_traffic('driven');
INSERT INTO driven.car (axis_id, abscissa, lane_position, along_axis) VALUES (1, 50, 2, true);
SELECT car_id, round(metres) AS metres FROM driven.car_place;
