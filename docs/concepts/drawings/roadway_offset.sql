-- A street along its left kerb crosses another one; in the east it parts into two, each beside the line of both.
INSERT INTO drawn.axis (geom, width, roadway_offset, lane_count, direction, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 50 0)', 9, -4.5, 3, 'direct', 5), ('SRID=32631;LINESTRING(50 0, 110 0)', 9, -4.5, 3, 'direct', 5),
    ('SRID=32631;LINESTRING(40 -35, 50 0, 50 25)', 6, NULL, 2, 'both', 5),
    ('SRID=32631;LINESTRING(110 0, 150 8)', 3.5, -1.75, 1, 'direct', 5), ('SRID=32631;LINESTRING(110 0, 150 -6)', 5.5, -2.75, 2, 'direct', 5);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT geom, 'result', NULL FROM drawn.lane
UNION ALL SELECT geom, 'axis', NULL FROM drawn.axis
