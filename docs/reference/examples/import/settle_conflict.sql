-- argument row_id: the key of the row: of an axis its axis_id
-- argument column_name: the column, as import_conflict says it; * is the whole row
-- argument holds: hand or source: whose value is to hold
-- argument relation: the table of the row
-- see import_axes, import_osm, import_bdtopo, follow
CREATE TABLE survey AS SELECT 7 AS id, 50 AS pace, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)'::geometry AS geom;
SELECT count(*) FROM streetgen.import_axes('town', 'survey', '{"source_ref": "id", "speed": "pace"}');
UPDATE town.axis SET speed = 20 WHERE source_ref = '7';
UPDATE survey SET pace = 30;
SELECT what, count, source_refs FROM streetgen.import_axes('town', 'survey', '{"source_ref": "id", "speed": "pace"}');
SELECT column_name, by_hand, source_old, source_new FROM town.import_conflict;
SELECT streetgen.settle_conflict('town', axis_id, column_name, 'source') FROM town.import_conflict;
SELECT speed FROM town.axis WHERE source_ref = '7';
