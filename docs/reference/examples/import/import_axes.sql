-- see follow, import_osm, import_bdtopo
CREATE TABLE survey AS SELECT 7 AS id, 6.5 AS breadth, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)'::geometry AS geom;
SELECT * FROM streetgen.import_axes('town', 'survey', '{"source_ref": "id", "width": "breadth", "importance": {"value": 4}}');
SELECT width, importance, source, source_ref FROM town.axis WHERE source = 'survey';
