-- A slip lane leaves the street before a junction: arcs of 8 m would leave no ground within the triangle.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(-60 0, -24 0)', 7, 8), ('SRID=32631;LINESTRING(-24 0, 0 0)', 7, 8), ('SRID=32631;LINESTRING(0 0, 50 0)', 7, 8),
    ('SRID=32631;LINESTRING(0 0, 0 24)', 7, 8), ('SRID=32631;LINESTRING(0 24, 0 50)', 7, 8), ('SRID=32631;LINESTRING(-24 0, -12 9, 0 24)', 4, 8);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT arc, 'result', NULL FROM drawn.corner WHERE method = 'nose'
UNION ALL SELECT geom, 'point', NULL FROM drawn.node
