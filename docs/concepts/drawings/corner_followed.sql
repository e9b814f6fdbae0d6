-- The first piece of the straight street is shorter than the place where the kerbs part: the corner follows the street.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 4 0)', 7, 4), ('SRID=32631;LINESTRING(4 0, 40 0)', 7, 4),
    ('SRID=32631;LINESTRING(0 0, 11 30)', 7, 4), ('SRID=32631;LINESTRING(0 0, -24 0)', 7, 4);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT ST_Boundary(ST_Buffer(centre, radius, 32)), 'helper', NULL FROM drawn.corner WHERE method = 'followed'
UNION ALL SELECT arc, 'result', 'followed' FROM drawn.corner WHERE method = 'followed'
UNION ALL SELECT geom, 'point', NULL FROM drawn.node
