-- argument prefix: prefix of the tables that osm2pgsql wrote
-- argument schemas: schemas in which the table is looked for
-- see import_objects, import_osm
CREATE TABLE city_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
INSERT INTO city_object VALUES (4, 'bench', '180', 'SRID=2154;POINT(650020 6860006)');
SELECT streetgen.create_model('lit', 2154, subjects => '{object}');
INSERT INTO lit.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7);
SELECT what, class, count FROM streetgen.import_osm_objects('lit', 'city');
