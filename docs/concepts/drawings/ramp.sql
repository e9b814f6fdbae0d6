-- A ramp on and a ramp off, 3 lanes each way through; drawn to half of the length that motorways have.
SELECT streetgen.switch_subject('drawn', 'ramp', true);
SELECT streetgen.set('drawn', 'merging_length', '25'), streetgen.set('drawn', 'taper_ratio', '{"0": 10}');
INSERT INTO drawn.axis (geom, width, lane_count, direction, kind, speed) VALUES
    ('SRID=32631;LINESTRING(0 0, 70 0)', 10.5, 3, 'direct', 'motorway', 80), ('SRID=32631;LINESTRING(70 0, 270 0)', 10.5, 3, 'direct', 'motorway', 80),
    ('SRID=32631;LINESTRING(270 0, 340 0)', 10.5, 3, 'direct', 'motorway', 80), ('SRID=32631;LINESTRING(0 -23, 70 0)', 3.5, 1, 'direct', 'motorway_link', 40),
    ('SRID=32631;LINESTRING(270 0, 340 -23)', 3.5, 1, 'direct', 'motorway_link', 40);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT surface, 'result', NULL FROM drawn.lane WHERE kind = 'merging'
UNION ALL SELECT geom, 'helper', NULL FROM drawn.ramp_path
