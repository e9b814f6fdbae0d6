-- see import_osm, import_axes
CREATE TABLE sign (id integer, what text, geom geometry(Point, 2154));
INSERT INTO sign VALUES (1, 'stop', 'SRID=2154;POINT(650085 6859997)');
SELECT * FROM streetgen.import_control_points('town', 'sign', '{"kind": "what", "source_ref": "id"}');
