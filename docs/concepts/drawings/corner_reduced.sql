-- The axis on the right is too short for the wanted arc (dotted): the largest radius that fits stands for it.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 30 0)', 6, 9), ('SRID=32631;LINESTRING(30 0, 38 0)', 6, 9), ('SRID=32631;LINESTRING(30 0, 30 26)', 6, 9);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT ST_SetSRID(streetgen.corner_arc('LINESTRING(30 0, 60 0)', 'LINESTRING(30 0, 30 26)', 6, 6, 9), 32631), 'helper', 'wanted'
UNION ALL SELECT arc, 'result', 'reduced' FROM drawn.corner WHERE method = 'radius_reduced'
