-- see import_objects, import_osm
-- argument mapping: `geom`, `kind`, `level`, `name`, `surface`, `foot` or `source_ref` to column of the source (a
-- string), or to `{"value": constant}`
CREATE TABLE plan (id integer, what text, geom geometry(Polygon, 2154));
INSERT INTO plan VALUES (1, 'square',
    'SRID=2154;POLYGON((650000 6860010, 650040 6860010, 650040 6860040, 650000 6860040, 650000 6860010))'),
    (2, 'parking_area', 'SRID=2154;POLYGON((650040 6860010, 650070 6860010, 650070 6860040, 650040 6860040, 650040 6860010))');
SELECT * FROM streetgen.import_areas('town', 'plan', '{"kind": "what", "source_ref": "id"}');
