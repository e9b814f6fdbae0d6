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
-- What is by hand stays, column by column, and what the source changes too is told.
CREATE TABLE sign (id integer, kind text, turned float8, geom geometry(Point, 2154));
INSERT INTO sign SELECT i, 'sign', 90, ST_SetSRID(ST_MakePoint(650010 + 10 * i + 0.123, 6860007.457), 2154) FROM generate_series(1, 8) i;
CREATE FUNCTION pg_temp.deliver() RETURNS SETOF text LANGUAGE sql AS
  $$SELECT format('%s %s', what, source_refs) FROM streetgen.import_objects('town', 'sign', '{"type": "kind", "source_ref": "id", "orientation": "turned"}') WHERE what IN ('by hand, kept', 'in conflict') ORDER BY 1$$;
CREATE FUNCTION pg_temp.sign(ref integer) RETURNS text LANGUAGE sql AS
  $$SELECT format('%s %s %s %s', type, floor(abscissa), orientation, by_hand) FROM town.street_object WHERE source = 'sign' AND source_ref = ref::text$$;
SELECT count(*) FROM pg_temp.deliver() \g /dev/null
UPDATE town.street_object_editing SET abscissa = abscissa + 3 WHERE street_object_id IN (SELECT street_object_id FROM town.street_object WHERE source = 'sign' AND source_ref IN ('1', '2', '3', '8'));
UPDATE town.street_object_editing SET type = 'lamp' WHERE street_object_id = (SELECT street_object_id FROM town.street_object WHERE source = 'sign' AND source_ref = '4');
DELETE FROM town.street_object WHERE source = 'sign' AND source_ref IN ('5', '6');
SELECT 'what the source has as before stays by hand, deleted objects too', array_agg(t) = '{"by hand, kept {1,2,3,4,5,6,8}"}' FROM pg_temp.deliver() t;
UPDATE sign SET geom = ST_Translate(geom, 1, 0) WHERE id IN (2, 4, 6, 7);
UPDATE sign SET kind = 'bench' WHERE id = 3;
DELETE FROM sign WHERE id = 8;
SELECT 'what both changed is in conflict, and told', array_agg(t) = '{"by hand, kept {1,3,4,5}","in conflict {2,6,8}"}' FROM pg_temp.deliver() t;
SELECT 'the place by hand stays', pg_temp.sign(2) = 'sign 33 90 {geom}' AND pg_temp.sign(8) = 'sign 93 90 {geom}';
SELECT 'the type of one that was moved is taken', pg_temp.sign(3) = 'bench 43 90 {geom}';
SELECT 'the type by hand stays, and its place follows', pg_temp.sign(4) = 'lamp 51 90 {type}';
SELECT 'a deleted one stays away', count(*) = 0 FROM town.street_object WHERE source = 'sign' AND source_ref IN ('5', '6');
SELECT 'what nobody edited follows', pg_temp.sign(7) = 'sign 81 90 {}';
SELECT streetgen.settle_conflict('town', row_id, column_name, 'source', 'street_object') FROM town.import_conflict WHERE source = 'sign' \g /dev/null
SELECT 'settled for the source it has what that says', pg_temp.sign(2) = 'sign 31 90 {}' AND pg_temp.sign(6) = 'sign 71 90 {}' AND pg_temp.sign(8) IS NULL;
SELECT 'no conflict is left', count(*) = 0 FROM town.import_conflict;
UPDATE sign SET geom = ST_Translate(geom, 1, 0), turned = 45;
SELECT streetgen.set('town', 'delivery_wins', 'source') \g /dev/null
SELECT 'where the source wins, it is told too', array_agg(t) = '{"by hand, kept {4}","in conflict {1,3,5}"}' FROM pg_temp.deliver() t;
SELECT 'all is as the source has it but what it does not say', pg_temp.sign(1) = 'sign 21 45 {}' AND pg_temp.sign(3) = 'bench 41 45 {}' AND pg_temp.sign(4) = 'lamp 52 45 {type}' AND pg_temp.sign(5) = 'sign 61 45 {}';
SELECT streetgen.settle_conflict('town', row_id, column_name, 'hand', 'street_object') FROM town.import_conflict WHERE source = 'sign' AND column_name = 'geom' AND source_ref = '1' \g /dev/null
SELECT 'settled for the hand it stands where it did', pg_temp.sign(1) = 'sign 23 45 {geom}';
SELECT streetgen.settle_conflict('town', row_id, column_name, 'source', 'street_object') FROM town.import_conflict WHERE source = 'sign' \g /dev/null
SELECT streetgen.set('town', 'delivery_wins', 'hand') \g /dev/null
-- Directions from the axis, stretches, streets that move, and objects at their control points.
UPDATE town.street_object SET orientation_kind = 'axis' WHERE source = 'sign' AND source_ref = '2';
UPDATE town.street_object SET abscissa_end = abscissa + 4 WHERE source = 'sign' AND source_ref = '3';
INSERT INTO town.control_point (geom, kind) SELECT geom, 'stop' FROM town.street_object WHERE source = 'sign' AND source_ref = '6';
UPDATE town.street_object SET control_point_id = (SELECT max(control_point_id) FROM town.control_point) WHERE source = 'sign' AND source_ref = '6';
UPDATE town.street_object_editing SET orientation = 30 WHERE street_object_id = (SELECT street_object_id FROM town.street_object WHERE source = 'sign' AND source_ref = '6');
UPDATE town.axis SET geom = ST_Translate(geom, 0, 0.3), width = width + 1 WHERE axis_id = 1;
SELECT 'a street that moves is nobody''s hand', array_agg(t) = '{"by hand, kept {1,2,3,4,6}"}' FROM pg_temp.deliver() t;
UPDATE sign SET geom = ST_Translate(geom, 1, 0), turned = 60 WHERE id IN (2, 3, 5, 6);
SELECT 'what both changed of those is told', array_agg(t) = '{"by hand, kept {1,4}","in conflict {2,3,6}"}' FROM pg_temp.deliver() t;
SELECT 'a direction from the axis stays, and its place follows', pg_temp.sign(2) = 'sign 33 45 {orientation}' AND by_hand = '45 from the axis' AND source_new = '60' FROM town.import_conflict c WHERE c.source = 'sign' AND source_ref = '2';
SELECT 'a stretch stays', ST_Length(geom) > 3.9 AND abscissa_end IS NOT NULL FROM town.street_object WHERE source = 'sign' AND source_ref = '3';
SELECT 'of one at its control point what was turned stays', pg_temp.sign(6) = 'sign 73 30 {orientation}' AND orientation_kind = 'absolute' FROM town.street_object WHERE source = 'sign' AND source_ref = '6';
SELECT 'what nobody edited follows beside a street that moved', pg_temp.sign(5) = 'sign 62 60 {}';
SELECT streetgen.settle_conflict('town', row_id, column_name, 'source', 'street_object') FROM town.import_conflict WHERE source = 'sign' \g /dev/null
SELECT 'settled for the source nothing is by hand', pg_temp.sign(2) = 'sign 33 60 {}' AND pg_temp.sign(3) = 'bench 42 60 {}' AND pg_temp.sign(6) = 'sign 73 60 {}';
SELECT 'and the stretch is a point', abscissa_end IS NULL AND ST_Dimension(geom) = 0 FROM town.street_object WHERE source = 'sign' AND source_ref = '3';
UPDATE town.axis SET geom = ST_Translate(geom, 0, -0.3), width = width - 1 WHERE axis_id = 1;
DELETE FROM town.street_object WHERE source = 'sign';
DELETE FROM town.open_conflict;
-- Of OpenStreetMap.
CREATE TABLE osm_object (node_id bigint, class varchar(30), direction varchar(10), geom geometry(Point, 2154));
INSERT INTO osm_object VALUES (10, 'crossing', NULL, 'SRID=2154;POINT(650050 6860000)'), (11, 'tree', 'north', 'SRID=2154;POINT(650050 6860007)'), (12, 'bench', '180', 'SRID=2154;POINT(650055 6860007)'), (13, 'stop', NULL, 'SRID=2154;POINT(650090 6859994)');
INSERT INTO osm_object VALUES (17, 'tram_stop', NULL, 'SRID=2154;POINT(650070 6860001)'), (-18, 'platform', NULL, 'SRID=2154;POINT(650070 6860005)');
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'stops of trams and their platforms are objects', string_agg(type || ' ' || source_ref || ' ' || method, ', ' ORDER BY source_ref) = 'platform -18 relative, tram_stop 17 relative' FROM town.street_object WHERE type IN ('tram_stop', 'platform');
INSERT INTO osm_object VALUES (19, 'speed_hump', NULL, 'SRID=2154;POINT(650030 6860000)'), (20, 'traffic_island', NULL, 'SRID=2154;POINT(650020 6860000)');
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'what slows traffic stands on the roadway, and nobody minds', string_agg(type || ' ' || source_ref || ' ' || method, ', ' ORDER BY source_ref) = 'speed_hump 19 relative, traffic_island 20 relative' AND NOT EXISTS (
    SELECT FROM streetgen.check_model('town') f JOIN town.street_object o ON o.street_object_id = f.id WHERE f.relation = 'street_object' AND o.source_ref IN ('19', '20')) FROM town.street_object WHERE streetgen._is_below('town', type, 'traffic_calming');
DELETE FROM osm_object WHERE node_id IN (17, -18, 19, 20);
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'of OpenStreetMap', string_agg(type || ' ' || round(angle), ', ' ORDER BY source_ref) = 'crossing 90, tree 90, bench 180, sign 90' FROM town.street_object WHERE source = 'osm_object';
SELECT 'a crossing has its ground', ST_Area(surface) = 40 FROM town.pedestrian_crossing;
-- Crossings, signals and signs are control points too.
INSERT INTO town.control_point (geom, kind, source, source_ref) VALUES ('SRID=2154;POINT(650050 6860000)', 'pedestrian_crossing', 'osm_control', '10'), ('SRID=2154;POINT(650050 6860000.5)', 'pedestrian_crossing', 'osm_control', '14'),
  ('SRID=2154;POINT(650090 6859994)', 'stop', 'osm_control', '13'), ('SRID=2154;POINT(650050 6860007)', 'signals', 'osm_control', '11');
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
CREATE FUNCTION pg_temp.controlled() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(o.type || ' ' || c.source_ref, ', ' ORDER BY o.source_ref) FROM town.street_object o JOIN town.control_point c USING (control_point_id) $$;
SELECT 'an object points to the control point of its kind, once', pg_temp.controlled() = 'crossing 10, sign 13';
CREATE TABLE pointing AS SELECT source_ref, xmin::text AS written FROM town.street_object;
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'importing again writes nothing of it', bool_and(p.written = o.xmin::text) FROM pointing p JOIN town.street_object o USING (source_ref);
INSERT INTO osm_object VALUES (15, 'crossing', NULL, 'SRID=2154;POINT(650050 6860000.2)');
SELECT count(*) FROM streetgen.import_osm_objects('town') \g /dev/null
SELECT 'a second one takes the control point that is left', pg_temp.controlled() = 'crossing 10, sign 13, crossing 14';
DELETE FROM osm_object WHERE node_id = 15;
UPDATE town.control_point SET geom = 'SRID=2154;POINT(650055 6860000)' WHERE source_ref = '10';
SELECT 'it goes with its control point', ST_DWithin(geom, 'SRID=2154;POINT(650055 6860000)', 1e-6) AND axis_id = 1 AND abs(abscissa - 55) < 1e-6 FROM town.street_object WHERE source_ref = '10';
SELECT 'and the ground of the crossing with it', ST_DWithin(ST_Centroid(surface), 'SRID=2154;POINT(650055 6860000)', 1e-6) FROM town.pedestrian_crossing JOIN town.street_object USING (street_object_id) WHERE source_ref = '10';
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'also of an axis turned round', bool_and(ST_DWithin(o.geom, c.geom, 1e-6) AND o.axis_id = c.axis_id AND abs(o.abscissa - c.abscissa) < 1e-6) FROM town.street_object o JOIN town.control_point c USING (control_point_id) WHERE o.source_ref = '10';
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
DELETE FROM town.control_point WHERE source_ref = '10';
SELECT 'it stays where its control point goes', control_point_id IS NULL AND method = 'relative' FROM town.street_object WHERE source_ref = '10';
TRUNCATE town.control_point;
SELECT 'no object points to what is gone', count(*) = 0 FROM town.street_object WHERE control_point_id IS NOT NULL;

-- Names nearly alike, and objects that crowd.
CREATE TABLE post (id integer, street text, geom geometry(Point, 2154));
INSERT INTO post VALUES (1, 'Mil Lane', 'SRID=2154;POINT(650040 6860006.5)'), (2, 'mill lane', 'SRID=2154;POINT(650060 6860006.5)'), (3, 'Elsewhere', 'SRID=2154;POINT(650080 6860006.5)');
SELECT count(*) FROM streetgen.import_objects('town', 'post', '{"type": {"value": "pole"}, "source_ref": "id", "name": "street"}') \g /dev/null
SELECT 'plain, the same name counts', string_agg(axis_id::text, ',' ORDER BY source_ref) = '1,2,1' FROM town.street_object WHERE source = 'post';
SELECT streetgen.set('town', 'object_names', 'fuzzy') \g /dev/null
DELETE FROM town.street_object WHERE source = 'post';
DELETE FROM town.delivered WHERE source = 'post';
SELECT 'names by similarity want their extension', (r).state = '0A000' AND (r).hint LIKE 'CREATE EXTENSION pg_trgm; or set object_names to plain.' FROM (SELECT test.refusal($$SELECT streetgen.import_objects('town', 'post', '{"type": {"value": "pole"}, "source_ref": "id", "name": "street"}')$$) AS r) t;
CREATE EXTENSION pg_trgm;
UPDATE town.object_type SET distance_least = 25 WHERE type = 'pole';
CREATE TABLE crowded AS SELECT * FROM streetgen.import_objects('town', 'post', '{"type": {"value": "pole"}, "source_ref": "id", "name": "street"}');
SELECT 'fuzzy, a similar one too', string_agg(axis_id::text, ',' ORDER BY source_ref) = '2,2,1' FROM town.street_object WHERE source = 'post';
SELECT 'those nearer to another one than their distance are told', count = 3 AND source_refs = '{1,2,3}' FROM crowded WHERE what = 'object nearer to another one than distance_least, kept';
SELECT 'by check_model too', count(*) = 3 FROM streetgen.check_model('town') WHERE rule = 'object nearer to another one than distance_least';
SELECT 'other values of the setting are refused', test.state($$SELECT streetgen.set('town', 'object_names', 'loose')$$) = '22023';
SELECT 'they have edges', count(*) = (SELECT count(*) FROM town.street_object WHERE method = 'relative') FROM town.object_edge;
SELECT 'no error of check_model', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';
-- A crossing that was deleted by hand and comes back where there is no street.
CREATE TABLE zebra AS SELECT 1 AS id, 'SRID=2154;POINT(650030 6860000)'::geometry AS geom;
SELECT count(*) FROM streetgen.import_objects('town', 'zebra', '{"type": {"value": "crossing"}, "source_ref": "id"}') \g /dev/null
DELETE FROM town.street_object_editing WHERE street_object_id = (SELECT street_object_id FROM town.street_object WHERE source = 'zebra');
UPDATE zebra SET geom = 'SRID=2154;POINT(650030 6860500)';
SELECT streetgen.set('town', 'delivery_wins', 'source') \g /dev/null
CREATE TABLE zebra_told AS SELECT * FROM streetgen.import_objects('town', 'zebra', '{"type": {"value": "crossing"}, "source_ref": "id"}');
SELECT 'an import brings back what stands at no street, and tells it', count(*) = 1 AND bool_and(source_refs = '{1}') FROM zebra_told WHERE what = 'object off all axes, kept where it lies';
SELECT 'where it lies', method = 'absolute' AND ST_Distance(geom, 'SRID=2154;POINT(650030 6860500)') < 1e-6 AND placed_by = 'import' FROM town.street_object WHERE source = 'zebra' AND source_ref = '1';
SELECT 'check_model tells of it', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'pedestrian crossing without its roadway';
DELETE FROM town.street_object WHERE source = 'zebra';
SELECT streetgen.set('town', 'delivery_wins', 'hand') \g /dev/null
-- Bad input.
CREATE TABLE kept AS SELECT count(*) FROM town.street_object;
SELECT 'no such type', (r).state = '22023' AND (r).said ~ '^source row \d has type "rocket"$' FROM (SELECT test.refusal($$SELECT streetgen.import_objects('town', 'lamp', '{"type": {"value": "rocket"}, "source_ref": "id"}')$$) AS r) t;
SELECT 'no such column', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"type": "kind"}')$$) = '42703';
SELECT 'a mapping of something else', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"colour": "id"}')$$) = '22023';
SELECT 'a source_ref that comes twice', test.state($$SELECT streetgen.import_objects('town', 'lamp', '{"type": {"value": "lamp"}, "source_ref": {"value": "x"}}')$$) = '22023';
SELECT 'a line is no object', test.state($$SELECT streetgen.import_objects('town', 'town.axis', '{"type": {"value": "lamp"}}')$$) = '22023';
-- A crossing of a cycle track beside the street, as a source of OpenStreetMap has it.
INSERT INTO osm_object VALUES (16, 'crossing', NULL, 'SRID=2154;POINT(650050 6860004)');
SELECT 'a crossing of OpenStreetMap on no axis is left out and told', count = 1 AND source_refs = '{16}' FROM streetgen.import_osm_objects('town') WHERE what = 'crossing on no axis, left out';
SELECT 'it stands nowhere', count(*) = 0 FROM town.street_object WHERE source_ref = '16';
CREATE TABLE off_axis AS SELECT 'crossing' AS type, 'a' AS ref, 'SRID=2154;POINT(650050 6860004)'::geometry AS geom;
SELECT count(*) FROM streetgen.import_objects('town', 'off_axis', '{"geom": "geom", "type": "type", "source_ref": "ref"}') \g /dev/null
SELECT 'one of a table of one''s own is placed by the axis', method = 'relative' AND abs(axis_offset) = 4 FROM town.street_object WHERE source_ref = 'a';
DELETE FROM osm_object WHERE node_id = 16;
SELECT 'no table of an OSM file', test.state($$SELECT streetgen.import_osm_objects('town', 'elsewhere')$$) = '42P01';
SELECT 'and those that are there', test.hint($$SELECT streetgen.import_osm_objects('town', 'elsewhere')$$) = 'Prefixes that have one: "osm".';
SELECT 'nothing was lost', count = (SELECT count(*) FROM town.street_object) FROM kept;
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'a model without the subject', test.state($$SELECT streetgen.import_osm_objects('bare')$$) = '55000';
-- A table of a schema beside public.
CREATE SCHEMA gis_objects;
CREATE TABLE gis_objects.city_object (node_id bigint, class text, direction text, geom geometry);
SELECT streetgen.create_model('beside', 2154, subjects => '{object}') \g /dev/null
INSERT INTO gis_objects.city_object VALUES (1, 'street_lamp', NULL, 'SRID=2154;POINT(650000 6860000)');
SELECT 'a table of another schema is named with it', sum(count) FILTER (WHERE class = 'lamp') > 0 FROM streetgen.import_osm_objects('beside', 'gis_objects.city');
SELECT 'where no schema has one, the flex file makes it', test.hint($$SELECT streetgen.import_osm_objects('beside', 'elsewhere', '{gis_none}')$$) LIKE 'Load the file again%';
DROP SCHEMA gis_objects CASCADE;
