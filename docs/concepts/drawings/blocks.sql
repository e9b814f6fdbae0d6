-- Figure 13 of the StreetGen paper: blocks with sidewalks, a traffic island, a blind alley, and a block too narrow for two sidewalks.
SELECT streetgen.switch_subject('drawn', subject, true) FROM unnest('{block,sidewalk}'::text[]) subject;
INSERT INTO drawn.axis (geom, width, radius, sidewalk_left, sidewalk_right) VALUES
    ('SRID=32631;LINESTRING(0 0, 90 0)', 8, 8, 3, 3), ('SRID=32631;LINESTRING(90 0, 122 6.4)', 8, 8, 3, 3), ('SRID=32631;LINESTRING(122 6.4, 160 14)', 8, 8, 3, 3),
    ('SRID=32631;LINESTRING(0 0, 5 70)', 7, 8, 2, 2), ('SRID=32631;LINESTRING(5 70, 88 70)', 7, 8, 2, 2), ('SRID=32631;LINESTRING(90 0, 89 32)', 9, 8, 4, 2),
    ('SRID=32631;LINESTRING(89 32, 88 70)', 9, 8, 4, 2), ('SRID=32631;LINESTRING(122 6.4, 89 32)', 6, 4, 0, 2), ('SRID=32631;LINESTRING(88 70, 150 82)', 7, 8, 2, 2),
    ('SRID=32631;LINESTRING(150 82, 160 14)', 7, 8, 2, 2), ('SRID=32631;LINESTRING(45 0, 45 32)', 5, 3, 1.5, 1.5), ('SRID=32631;LINESTRING(5 70, 2 80, 89 80.5, 88 70)', 4, 2, 2, 2);
-- drawing
SELECT * FROM pg_temp.streets('drawn')
UNION ALL SELECT surface, 'result', NULL FROM drawn.sidewalk
UNION ALL SELECT ST_Boundary(surface), 'kerb', NULL FROM drawn.block WHERE NOT ST_IsEmpty(surface)
UNION ALL SELECT ST_PointOnSurface(surface), 'point', kind FROM drawn.block WHERE kind <> 'roadway'
