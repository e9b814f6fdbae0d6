-- Symmetric above, left below, both of 20 m.
SELECT streetgen.set('drawn', 'transition_length', '20');
INSERT INTO drawn.axis (geom, width) VALUES
    ('SRID=32631;LINESTRING(0 30, 50 30)', 12), ('SRID=32631;LINESTRING(50 30, 100 34)', 6),
    ('SRID=32631;LINESTRING(0 0, 50 0)', 12), ('SRID=32631;LINESTRING(50 0, 100 4)', 6);
SELECT streetgen.set_transition('drawn', from_node, 'left') FROM drawn.edge WHERE axis_id = 4;
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT surface, 'result', NULL FROM drawn.intersection WHERE method = 'transition'
