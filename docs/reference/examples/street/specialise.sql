-- Lamps get a table of their own, with a row for each.
SELECT streetgen.create_model('lit', srid => 2154, subjects => '{object}');
CREATE TABLE lit.lantern (street_object_id bigint PRIMARY KEY, watts integer DEFAULT 60);
INSERT INTO lit.street_object (type, geom) VALUES ('lamp', 'SRID=2154;POINT(650000 6860000)');
SELECT streetgen.specialise('lit', 'lamp', 'lantern') AS lamps;
SELECT * FROM lit.lantern;
