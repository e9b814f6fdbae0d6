-- Three lanes along the axis and one against it; numbers are ordinalities.
INSERT INTO drawn.axis (geom, width, width_end, lanes_forward, lanes_backward) VALUES ('SRID=32631;LINESTRING(0 0, 40 0, 64 16, 100 16)', 13, 17, 3, 1);
-- drawing
SELECT surface, CASE WHEN along_axis THEN 'section' ELSE 'intersection' END, NULL FROM drawn.lane
UNION ALL SELECT geom, 'axis', NULL FROM drawn.axis
UNION ALL SELECT geom, 'result', ordinality::text FROM drawn.lane
