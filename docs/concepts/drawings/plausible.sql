-- Two lanes come in from the left, the street goes on with one: blue is plausible, dotted is not.
INSERT INTO drawn.axis (geom, width, radius, direction, lane_count) VALUES
    ('SRID=32631;LINESTRING(-40 0, 0 0)', 7, 8, 'direct', 2), ('SRID=32631;LINESTRING(0 0, 40 4)', 6, 8, 'direct', 2), ('SRID=32631;LINESTRING(0 0, 8 -34)', 5, 8, 'direct', 1);
-- drawing
SELECT surface, 'section', NULL FROM drawn.section UNION ALL SELECT surface, 'intersection', NULL FROM drawn.intersection
UNION ALL SELECT geom, 'axis', NULL FROM drawn.lane
UNION ALL SELECT geom, 'helper', NULL FROM drawn.interconnection WHERE NOT plausible
UNION ALL SELECT geom, 'result', NULL FROM drawn.interconnection WHERE plausible
