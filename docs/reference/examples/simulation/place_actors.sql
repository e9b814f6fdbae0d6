-- argument seed: same seed, same actors
-- argument start: of the driver, a point
-- argument free: metres about start
-- see place_cars, simulate
SELECT streetgen.create_model('staffed', 2154, driving_side => 'right'), streetgen.create_traffic('staffed');
INSERT INTO staffed.axis (geom, width, lane_count, speed)
    VALUES ('SRID=2154;LINESTRING(650000 6860000, 650500 6860000)', 7, 2, 50);
INSERT INTO staffed.actor_rule (kind, density, length, width) VALUES ('bus', 2, 12, 2.5);
SELECT kind, placed > 0 AS placed FROM streetgen.place_actors('staffed');
