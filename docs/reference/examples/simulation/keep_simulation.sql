-- argument run: its name
-- argument method: idm, lwr, arz or a function
-- argument duration: seconds
-- argument step: seconds
-- argument demand: object of flow or entries, and turns
-- argument seed: same seed, same rows
-- argument options: object of output: seconds between the states that are given
-- see simulate
SELECT streetgen.create_model('kept', 2154, driving_side => 'right'), streetgen.create_traffic('kept');
INSERT INTO kept.axis (geom, width, lane_count) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2),
    ('SRID=2154;LINESTRING(650200 6860000, 650400 6860000)', 7, 2);
SELECT streetgen.keep_simulation('kept', 'morning', 'lwr', 10, 0.2, '{"flow": 600}') > 0 AS rows;
SELECT run, count(*) > 0 AS rows FROM kept.simulated GROUP BY run;
