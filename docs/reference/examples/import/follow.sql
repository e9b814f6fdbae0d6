-- see unfollow, import_axes
CREATE TABLE survey AS SELECT 7 AS id, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)'::geometry AS geom;
SELECT what, count FROM streetgen.follow('town', 'survey', '{"source_ref": "id"}');
INSERT INTO survey VALUES (8, 'SRID=2154;LINESTRING(650000 6860090, 650060 6860150)');
SELECT source_ref FROM town.axis WHERE source = 'survey' ORDER BY source_ref;
