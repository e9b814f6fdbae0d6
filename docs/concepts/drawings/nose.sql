-- Two carriageways part by 18 degrees: the arc of the wanted radius would pave 37 m of the median.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(-24 0, 0 0)', 7, 6), ('SRID=32631;LINESTRING(0 0, 80 13)', 7, 6), ('SRID=32631;LINESTRING(0 0, 80 -13)', 7, 6);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT ST_Boundary(ST_Buffer(centre, radius, 32)), 'helper', NULL FROM drawn.corner WHERE method = 'nose'
UNION ALL SELECT arc, 'result', 'nose' FROM drawn.corner WHERE method = 'nose'
UNION ALL SELECT geom, 'point', NULL FROM drawn.node
