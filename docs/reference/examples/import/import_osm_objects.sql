-- argument prefix: prefix of the tables that osm2pgsql wrote
-- see import_objects, import_osm
CREATE TABLE city_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
INSERT INTO city_object VALUES (4, 'bench', '180', 'SRID=2154;POINT(650020 6860006)');
SELECT what, class, count FROM streetgen.import_osm_objects('lit', 'city');
