-- The control point lies half way from the crossing of the straight continuations to the node.
INSERT INTO drawn.axis (geom, width, radius, direction, lane_count) VALUES
    ('SRID=32631;LINESTRING(-40 0, 0 0)', 8, 9, 'both', 2), ('SRID=32631;LINESTRING(0 0, 34 0)', 8, 9, 'both', 2), ('SRID=32631;LINESTRING(0 0, 6 -36)', 8, 9, 'both', 2);
-- drawing
SELECT surface, 'section', NULL FROM drawn.section UNION ALL SELECT surface, 'intersection', NULL FROM drawn.intersection
UNION ALL SELECT geom, 'axis', NULL FROM drawn.lane
UNION ALL SELECT ST_MakeLine(ARRAY[ST_StartPoint(geom), control, ST_EndPoint(geom)]), 'helper', NULL FROM drawn.interconnection WHERE turn = 'left'
UNION ALL SELECT control, 'point', CASE angle WHEN max(angle) OVER () THEN 'control' END FROM drawn.interconnection WHERE turn = 'left'
UNION ALL SELECT geom, 'result', NULL FROM drawn.interconnection WHERE turn = 'left'
