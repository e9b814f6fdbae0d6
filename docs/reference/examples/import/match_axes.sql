-- argument mapping: `geom`, `source_ref` or `name` to column of the source (a string), or to `{"value": constant}`
-- argument distance: metres by which axes and lines are dilated
-- see common_ground, import_axes
CREATE TABLE survey (id integer, street text, pace float8, geom geometry(LineString, 2154));
INSERT INTO survey VALUES (7, 'HIGH STREET', 30, 'SRID=2154;LINESTRING(650120 6860002, 650000 6860002)');
SELECT streetgen.create_model('matched', 2154);
INSERT INTO matched.axis (geom, width, name) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 'High Street');
SELECT axis_id, source_ref, round(shared::numeric, 2) AS shared, alike, round(score::numeric, 2) AS score
FROM streetgen.match_axes('matched', 'survey', '{"source_ref": "id", "name": "street"}');
