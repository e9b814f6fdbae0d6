-- Two junctions nearer than their arcs: the wanted limits cross and meet at one border line.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 34 0)', 6, 9), ('SRID=32631;LINESTRING(34 0, 50 0)', 6, 9), ('SRID=32631;LINESTRING(50 0, 84 0)', 6, 9),
    ('SRID=32631;LINESTRING(34 0, 34 30)', 6, 9), ('SRID=32631;LINESTRING(50 0, 50 -30)', 6, 9);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT streetgen.border_line(e.geom, wanted_abscissa, 6), 'helper', CASE which WHEN 'start' THEN 'wanted' END FROM drawn.section_limit l JOIN drawn.edge e USING (edge_id) WHERE method = 'crossed_limits'
UNION ALL (SELECT border_line, 'result', NULL FROM drawn.section_limit WHERE method = 'crossed_limits' ORDER BY section_limit_id LIMIT 1)
