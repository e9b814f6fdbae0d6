-- The ring of an intersection: border line, kerb, arc, kerb, border line, and so on about the node.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 40 4)', 8, 7), ('SRID=32631;LINESTRING(0 0, 8 34)', 6, 7), ('SRID=32631;LINESTRING(0 0, -20 2, -38 12)', 8, 7), ('SRID=32631;LINESTRING(0 0, -6 -30)', 6, 7);
-- drawing
SELECT surface, 'section', NULL FROM drawn.section
UNION ALL SELECT surface, 'intersection', NULL FROM drawn.intersection
UNION ALL SELECT ST_Boundary(surface), 'kerb', NULL FROM drawn.intersection
UNION ALL SELECT arc, 'result', NULL FROM drawn.corner
UNION ALL SELECT border_line, 'helper', NULL FROM drawn.section_limit
UNION ALL SELECT p.geom, 'point', NULL FROM drawn.section_limit l JOIN drawn.edge USING (edge_id), ST_DumpPoints(border_line) p WHERE which = 'start'
