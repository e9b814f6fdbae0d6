-- The kerbs of both streets overlap: each point goes to the nearer axis.
INSERT INTO drawn.axis (geom, width, name) VALUES
    ('SRID=32631;LINESTRING(0 0, 90 0)', 12, NULL), ('SRID=32631;LINESTRING(0 17, 30 12, 60 9, 90 16)', 12, NULL);
-- drawing
SELECT ST_Boundary(ST_Buffer(geom, 6, 'endcap=flat join=round')), 'helper', NULL FROM drawn.axis
UNION ALL (SELECT surface, CASE axis_id WHEN 1 THEN 'section' ELSE 'contested' END, NULL FROM drawn.section JOIN drawn.edge USING (edge_id) ORDER BY axis_id)
UNION ALL SELECT geom, 'axis', NULL FROM drawn.axis
UNION ALL SELECT ST_Intersection(ST_Boundary(a.surface), ST_Boundary(b.surface)), 'result', 'nearest axis' FROM drawn.section a, drawn.section b WHERE a.edge_id < b.edge_id
