-- argument method: idm, lwr, arz or a function
-- argument duration: seconds
-- argument step: seconds
-- argument demand: object of flow or entries, and turns
-- argument seed: same seed, same rows
-- argument options: object of output: seconds between the states that are given
-- see keep_simulation, leaders
SELECT streetgen.create_model('flowing', 2154, driving_side => 'right');
INSERT INTO flowing.axis (geom, width, lane_count) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2),
    ('SRID=2154;LINESTRING(650200 6860000, 650400 6860000)', 7, 2);
SELECT t, count(*) > 0 AS driven FROM streetgen.simulate('flowing', 'idm', 30,
    demand => '{"flow": 600}', options => '{"output": 30}') GROUP BY t ORDER BY t;
-- drawing
WITH state AS (SELECT * FROM streetgen.simulate('town', 'idm', 60, demand => '{"flow": 500}',
        options => '{"output": 60}') WHERE t = 60)
SELECT s.surface, 'section', NULL FROM town.roadway s
    UNION ALL SELECT ST_Buffer(geom, 1.5), 'result', NULL FROM state
