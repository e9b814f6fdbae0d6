-- argument density: cars a kilometre of lane
-- argument seed: throws what a lane lacks for a whole car
-- see leaders
SELECT streetgen.create_model('filled', 2154, driving_side => 'right'), streetgen.create_traffic('filled');
INSERT INTO filled.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650300 6860000)', 7, 2);
SELECT streetgen.place_cars('filled', 20) BETWEEN 8 AND 16 AS some;
