-- see follow
CREATE TABLE survey AS SELECT 7 AS id, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)'::geometry AS geom;
SELECT what, count FROM streetgen.follow('town', 'survey', '{"source_ref": "id"}');
SELECT streetgen.unfollow('town', 'survey');
DELETE FROM survey;
SELECT count(*) AS axes_that_stay FROM town.axis WHERE source = 'survey';
