-- Axes that cross without a node: the more important one owns the ground.
INSERT INTO drawn.axis (geom, width, importance, name) VALUES
    ('SRID=32631;LINESTRING(0 0, 90 10)', 10, 2, 'importance 2'), ('SRID=32631;LINESTRING(30 -26, 62 36)', 8, 5, 'importance 5');
-- drawing
SELECT ST_Boundary(ST_Buffer(a.geom, u.width / 2, 'endcap=flat')), 'helper', NULL FROM drawn.axis a JOIN drawn.axis_used u USING (axis_id)
UNION ALL (SELECT surface, CASE axis_id WHEN 1 THEN 'section' ELSE 'contested' END, NULL FROM drawn.section JOIN drawn.edge USING (edge_id) ORDER BY axis_id)
UNION ALL SELECT geom, 'axis', name FROM drawn.axis
