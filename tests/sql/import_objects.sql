\set ECHO none
\ir shared/truths.sql
-- Objects of a table of points, and of OpenStreetMap.
SELECT streetgen.create_model('town', 2154, subjects => '{object}') \g /dev/null
INSERT INTO town.axis (geom, width, name) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 8, 'High Street'), ('SRID=2154;LINESTRING(650000 6860014, 650100 6860014)', 6, 'Mill Lane');
CREATE TABLE lamp (id integer, street text, turned float8, geom geometry(Point, 4326));
INSERT INTO lamp SELECT v.id, v.street, v.turned, ST_Transform(ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154), 4326)
  FROM (VALUES (1, NULL, NULL::float8, 20, 5), (2, 'mill lane', 45, 40, 6), (3, 'High Street', NULL, 60, -5), (4, NULL, NULL, 50, 400)) v(id, street, turned, x, y);
INSERT INTO lamp VALUES (5, NULL, NULL, NULL);
CREATE TABLE told AS SELECT * FROM streetgen.import_objects('town', 'lamp', '{"type": {"value": "lamp"}, "source_ref": "id", "name": "street", "orientation": "turned"}');
SELECT 'what was imported is told', array_agg((what, class, count)::text ORDER BY what) = '{"(\"object off all axes, kept where it lies\",lamp,1)","(\"object without geometry, left out\",lamp,1)","(objects,lamp,4)"}' FROM (SELECT what, class, count FROM told) t;
SELECT 'beside the nearest street', axis_id = 1 AND side = 'left' AND abs(axis_offset - 1) < 1e-6 AND abs(abscissa - 20) < 1e-6 AND placed_by = 'import' FROM town.street_object WHERE source_ref = '1';
SELECT 'of a name beside the street of that name', axis_id = 2 AND side = 'right' AND round(angle) = 45 FROM town.street_object WHERE source_ref = '2';
SELECT 'what stands off all axes stays there', method = 'absolute' AND ST_DWithin(geom, 'SRID=2154;POINT(650050 6860400)', 1e-6) FROM town.street_object WHERE source_ref = '4';
-- Again.
CREATE TABLE before AS SELECT source_ref, xmin::text AS written FROM town.street_object;
SELECT count(*) FROM streetgen.import_objects('town', 'lamp', '{"type": {"value": "lamp"}, "source_ref": "id", "name": "street", "orientation": "turned"}') \g /dev/null
SELECT 'importing again writes nothing', bool_and(b.written = o.xmin::text) AND count(*) = 4 FROM before b JOIN town.street_object o USING (source_ref);
UPDATE town.street_object_editing SET abscissa = 70 WHERE street_object_id = (SELECT street_object_id FROM town.street_object WHERE source_ref = '3');
UPDATE lamp SET geom = ST_Transform('SRID=2154;POINT(650030 6860005)'::geometry, 4326) WHERE id = 1;
DELETE FROM lamp WHERE id = 4;
SELECT count(*) FROM streetgen.import_objects('town', 'lamp', '{"type": {"value": "lamp"}, "source_ref": "id", "name": "street", "orientation": "turned"}') \g /dev/null
SELECT 'a row that moved is followed, one by hand stays, one that is gone goes', string_agg(source_ref || ' ' || round(abscissa), ', ' ORDER BY source_ref) = '1 30, 2 40, 3 70' FROM town.street_object;
SELECT 'they follow their street', count(*) = 1 FROM (SELECT FROM town.street_object WHERE source_ref = '1' AND ST_Y(geom) > 6860004.9) s;
UPDATE town.axis SET width = 10 WHERE axis_id = 1;
SELECT 'as it widens', abs(ST_Y(geom) - 6860006) < 1e-6 FROM town.street_object WHERE source_ref = '1';
-- Of OpenStreetMap.
CREATE TABLE osm_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
INSERT INTO osm_object VALUES (10, 'crossing', NULL, 'SRID=2154;POINT(650050 6860000)'), (11, 'tree', 'north', 'SRID=2154;POINT(650050 6860007)'), (12, 'bench', '180', 'SRID=2154;POINT(650055 6860007)'), (13, 'stop', NULL, 'SRID=2154;POINT(650090 6859994)');
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'of OpenStreetMap', string_agg(type || ' ' || round(angle), ', ' ORDER BY source_ref) = 'crossing 90, tree 90, bench 180, sign 90' FROM town.street_object WHERE source = 'osm_object';
SELECT 'a crossing has its ground', ST_Area(surface) = 40 FROM town.pedestrian_crossing;
SELECT 'they have edges', count(*) = (SELECT count(*) FROM town.street_object WHERE method = 'relative') FROM town.object_edge;
SELECT 'no error of check_model', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';
-- Bad input.
CREATE TABLE kept AS SELECT count(*) FROM town.street_object;
SELECT 'no such type', (r).state = '22023' AND (r).said ~ '^source row \d has type "rocket"$' FROM (SELECT test.refusal($$SELECT streetgen.import_objects('town', 'lamp', '{"type": {"value": "rocket"}, "source_ref": "id"}')$$) AS r) t;
SELECT 'no such column', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"type": "kind"}')$$) = '42703';
SELECT 'a mapping of something else', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"colour": "id"}')$$) = '22023';
SELECT 'a source_ref that comes twice', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"type": {"value": "lamp"}, "source_ref": {"value": "x"}}')$$) = '22023';
SELECT 'a line is no object', test.state($$SELECT streetgen.import_objects('town', 'town.axis', '{"type": {"value": "lamp"}}')$$) = '22023';
SELECT 'no table of an OSM file', test.state($$SELECT streetgen.import_osm_objects('town', 'elsewhere')$$) = '42P01';
SELECT 'nothing was lost', count = (SELECT count(*) FROM town.street_object) FROM kept;
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'a model without the subject', test.state($$SELECT streetgen.import_osm_objects('bare')$$) = '55000';
