-- argument mapping: `geom`, `kind`, `confidence`, `weight`, `relation` or `source_ref` to column of the source (a string), or to `{"value": constant}`
-- see fit, import_areas
CREATE TABLE kerb_line (id integer, geom geometry(LineString, 2154));
INSERT INTO kerb_line VALUES (1, 'SRID=2154;LINESTRING(650000 6860004, 650100 6860004)');
SELECT streetgen.create_model('surveyed', 2154, subjects => '{fit}');
INSERT INTO surveyed.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 6);
SELECT * FROM streetgen.observe('surveyed', 'kerb_line', '{"source_ref": "id"}');
