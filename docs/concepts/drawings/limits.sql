-- The farther foot of both corners counts.
INSERT INTO drawn.axis (geom, width, radius) VALUES
    ('SRID=32631;LINESTRING(0 0, 46 0)', 8, 4), ('SRID=32631;LINESTRING(0 0, 16 30)', 6, 9), ('SRID=32631;LINESTRING(0 0, -36 0)', 8, 9), ('SRID=32631;LINESTRING(0 0, 4 -30)', 6, 3);
UPDATE drawn.axis SET radius = 9 WHERE axis_id = 2;
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT ST_MakeLine(c.centre, ST_ClosestPoint(e.geom, c.centre)), 'helper', NULL FROM drawn.corner c JOIN drawn.edge e ON edge_id IN (edge_a, edge_b) WHERE e.axis_id = 1 AND c.centre IS NOT NULL
UNION ALL SELECT centre, 'point', 'centre' FROM drawn.corner c WHERE centre IS NOT NULL AND (SELECT count(*) FROM drawn.edge WHERE edge_id IN (edge_a, edge_b) AND axis_id = 1) > 0
UNION ALL SELECT border_line, 'result', 'border line' FROM drawn.section_limit l JOIN drawn.edge USING (edge_id) WHERE axis_id = 1 AND which = 'start'
