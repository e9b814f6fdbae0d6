-- The acute pair on the right makes the intersection long: a curve from limit to limit (dotted) cuts the kerb, the path does not.
INSERT INTO drawn.axis (geom, width, radius, lane_count) VALUES
    ('SRID=32631;LINESTRING(0 0, 62 0)', 8, 3, 2), ('SRID=32631;LINESTRING(0 0, 60 17)', 8, 3, 2), ('SRID=32631;LINESTRING(0 0, 0 26)', 8, 3, 2);
-- drawing
WITH shown AS (
    SELECT c.geom, n.geom AS node, CASE WHEN i.along_axis THEN i.geom ELSE ST_Reverse(i.geom) END AS lane_in, CASE WHEN o.along_axis THEN o.geom ELSE ST_Reverse(o.geom) END AS lane_out
    FROM drawn.interconnection c JOIN drawn.node n USING (node_id) JOIN drawn.lane i ON i.lane_id = lane_in JOIN drawn.lane o ON o.lane_id = lane_out
    JOIN drawn.edge a ON a.edge_id = i.edge_id JOIN drawn.edge b ON b.edge_id = o.edge_id WHERE (a.axis_id, b.axis_id) = (2, 3))
SELECT surface, 'section', NULL FROM drawn.section UNION ALL SELECT surface, 'intersection', NULL FROM drawn.intersection
UNION ALL SELECT streetgen.interconnection(lane_in, lane_out, node), 'helper', NULL FROM shown
UNION ALL SELECT geom, 'result', NULL FROM shown
