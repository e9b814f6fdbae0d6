-- The centre lies at half width + radius of both axes.
INSERT INTO drawn.axis (geom, width, radius, name) VALUES
    ('SRID=32631;LINESTRING(0 0, 48 0)', 8, 9, 'a'), ('SRID=32631;LINESTRING(0 0, 14 38)', 6, 9, 'b');
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT ST_SetSRID(streetgen.offset_line('LINESTRING(0 0, 48 0)', 13), 32631), 'helper', 'half width + radius'
UNION ALL SELECT ST_SetSRID(streetgen.offset_line('LINESTRING(0 0, 14 38)', -12), 32631), 'helper', NULL
UNION ALL (SELECT ST_MakeLine(centre, ST_StartPoint(arc)), 'helper', 'r' FROM drawn.corner WHERE centre IS NOT NULL ORDER BY ST_X(centre) DESC LIMIT 1)
UNION ALL (SELECT arc, 'result', NULL FROM drawn.corner WHERE centre IS NOT NULL ORDER BY ST_X(centre) DESC LIMIT 1)
UNION ALL (SELECT centre, 'result', 'centre' FROM drawn.corner WHERE centre IS NOT NULL ORDER BY ST_X(centre) DESC LIMIT 1)
