-- argument car_id: key of a row of table car
-- argument side: left or right of who drives
-- see leaders, get_leader
SELECT streetgen.create_model('beside', 2154, driving_side => 'right'), streetgen.create_traffic('beside');
INSERT INTO beside.axis (geom, width, lane_count)
    VALUES ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 14, 4);
INSERT INTO beside.car (car_id, axis_id, abscissa, lane_position, along_axis) VALUES (1, 1, 50, 4, true);
SELECT streetgen.move_car('beside', 1, 'left') IS NOT NULL AS moved;
