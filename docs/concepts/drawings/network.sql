-- Ends within the tolerance join (left), an end near the inside of an axis makes a node there (right).
SELECT streetgen.set('drawn', 'tolerance', '2');
INSERT INTO drawn.axis (geom, width) VALUES
    ('SRID=32631;LINESTRING(0 0, 29.2 0.5)', 5), ('SRID=32631;LINESTRING(30.6 -0.6, 60 0, 90 4)', 5),
    ('SRID=32631;LINESTRING(30 1, 34 24)', 5), ('SRID=32631;LINESTRING(62 24, 64 2.4)', 5);
-- drawing
SELECT geom, 'helper', NULL FROM drawn.axis
UNION ALL SELECT ST_Boundary(ST_Buffer(geom, 2, 16)), 'helper', NULL FROM drawn.node
UNION ALL SELECT geom, 'result', NULL FROM drawn.edge
UNION ALL SELECT geom, 'point', NULL FROM drawn.node
