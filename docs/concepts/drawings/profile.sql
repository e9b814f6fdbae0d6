-- A street that passes over another one, by a height by hand, and under a third one that stays: heights ten times as great as lengths.
SELECT count(*) FROM streetgen.switch_subject('drawn', 'height', true);
INSERT INTO drawn.axis (geom, width, level, speed, name) VALUES ('SRID=32631;LINESTRING(0 0, 760 0)', 8, 0, 50, NULL),
    ('SRID=32631;LINESTRING(200 -300, 200 300)', 8, -1, 50, 'tunnel'), ('SRID=32631;LINESTRING(480 -300, 480 300)', 8, 0, 50, 'avenue');
INSERT INTO drawn.overpass_override (geom, axis_above, axis_below, clearance) VALUES ('SRID=32631;POINT(480 0)', 1, 3, 6);
INSERT INTO drawn.height_override (geom, axis_id, abscissa, height) VALUES ('SRID=32631;POINT(700 0)', 1, 700, 4);
-- drawing
SELECT 'SRID=32631;LINESTRING(0 0, 760 0)'::geometry, 'helper', NULL
UNION ALL SELECT ST_MakeLine(ST_SetSRID(ST_Point(ST_X(p.geom), 10 * ST_Z(p.geom)), 32631) ORDER BY p.path), 'result', NULL
    FROM drawn.profile JOIN drawn.edge e USING (edge_id), ST_DumpPoints(profile.geom) p WHERE axis_id = 1
UNION ALL SELECT ST_SetSRID(ST_Point(200, -60), 32631), 'point', 'tunnel'
UNION ALL SELECT ST_SetSRID(ST_Point(480, 0), 32631), 'point', 'avenue'
UNION ALL SELECT ST_SetSRID(ST_Point(700, 40), 32631), 'result', 'by hand'
