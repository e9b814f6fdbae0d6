-- Above as computed; below with a limit and a radius by hand.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 40 0)', 7, 7), ('SRID=32631;LINESTRING(0 0, -36 0)', 7, 7), ('SRID=32631;LINESTRING(0 0, 0 30)', 6, 7),
    ('SRID=32631;LINESTRING(0 -48, 40 -48)', 7, 7), ('SRID=32631;LINESTRING(0 -48, -36 -48)', 7, 7), ('SRID=32631;LINESTRING(0 -48, 0 -18)', 6, 7);
UPDATE drawn.section_limit_editing SET abscissa = 22 WHERE edge_id = (SELECT edge_id FROM drawn.edge WHERE axis_id = 4) AND which = 'start';
UPDATE drawn.corner_editing c SET radius = 3 WHERE EXISTS (SELECT FROM drawn.corner k JOIN drawn.edge a ON a.edge_id = edge_a JOIN drawn.edge b ON b.edge_id = edge_b
    WHERE k.corner_id = c.corner_id AND (a.axis_id, b.axis_id) = (6, 5));
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT border_line, 'result', 'limit by hand' FROM drawn.section_limit WHERE method = 'by_hand'
UNION ALL SELECT arc, 'result', 'radius by hand' FROM drawn.corner WHERE method = 'by_hand'
