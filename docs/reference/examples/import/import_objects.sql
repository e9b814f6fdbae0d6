-- argument mapping: `geom`, `type`, `orientation`, `name` or `source_ref` to column of the source (a string), or to `{"value": constant}`
-- see import_osm_objects, import_axes
CREATE TABLE lamp (id integer, geom geometry(Point, 2154));
INSERT INTO lamp VALUES (1, 'SRID=2154;POINT(650010 6860005)');
SELECT streetgen.create_model('lit', 2154, subjects => '{object}');
INSERT INTO lit.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7);
SELECT what, class, count FROM streetgen.import_objects('lit', 'lamp', '{"type": {"value": "lamp"}, "source_ref": "id"}');
