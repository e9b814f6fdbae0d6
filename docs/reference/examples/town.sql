CREATE EXTENSION IF NOT EXISTS streetgen CASCADE;
SELECT streetgen.create_model('town', srid => 2154);
INSERT INTO town.axis (geom, width, name) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9, 'high street'),
    ('SRID=2154;LINESTRING(650100 6860000, 650200 6860000)', 7, 'high street'),
    ('SRID=2154;LINESTRING(650100 6860000, 650110 6859920)', 6, 'mill lane'),
    ('SRID=2154;LINESTRING(650200 6860000, 650280 6860040)', 5, 'hill road');
-- The same streets with sidewalks, for what people walk on.
SELECT streetgen.create_model('walked', srid => 2154, subjects => '{footway}');
INSERT INTO walked.axis (geom, width, radius, name, importance) SELECT geom, width, radius, name, 4 FROM town.axis;
-- A log of two who drive there.
CREATE TABLE drive_log AS SELECT i AS time, 650020 + 12.0 * i AS x, 6859998.0 AS y, 'driver' AS actor
    FROM generate_series(0, 8) i
    UNION ALL SELECT i, 650050 + 10.0 * i, 6859998.5, 'van' FROM generate_series(0, 8) i;
