\set ECHO none
\ir shared/truths.sql
-- Kerbs that footways come over, at the ends of crossings: drawn, imported, live.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,footway,object}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, kind) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4, 'residential'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 4, 'residential'), (3, pg_temp.line('LINESTRING(100 0,100 80)'), 6, 5, 'residential');
  INSERT INTO town.footway (footway_id, geom, kind, role) VALUES (1, pg_temp.line('LINESTRING(30 -12,30 12)'), 'footway', 'crossing'), (2, pg_temp.line('LINESTRING(60 -20,68 20)'), 'path', NULL), (3, pg_temp.line('LINESTRING(107 -9,107 9)'), 'footway', 'crossing');
END $$;
CREATE VIEW crossing AS SELECT c.*, o.axis_id, o.abscissa FROM town.pedestrian_crossing c JOIN town.street_object o USING (street_object_id);
CREATE FUNCTION kerbs(footway bigint) RETURNS text LANGUAGE sql AS $$ SELECT coalesce(kerb_left, 'unknown') || ' ' || coalesce(kerb_right, 'unknown') FROM crossing WHERE footway_id = footway $$;
CREATE FUNCTION across(footway bigint, side text) RETURNS text LANGUAGE sql AS $$ SELECT x.kerb FROM crossing c, LATERAL streetgen.cross_section('town', c.axis_id, c.abscissa) x WHERE c.footway_id = footway AND x.kind = 'kerb' AND x.side = across.side $$;
CREATE FUNCTION as_run() RETURNS boolean LANGUAGE plpgsql SET streetgen.computes = 'on' AS $$ DECLARE before constant text := (SELECT string_agg(kerbs(footway_id), ';' ORDER BY footway_id) FROM crossing); BEGIN
  UPDATE town.edge SET input_hash = 0; PERFORM FROM streetgen.generate('town', wait => true); RETURN before = (SELECT string_agg(kerbs(footway_id), ';' ORDER BY footway_id) FROM crossing); END $$;
SELECT 'of the kerbs of a crossing nothing is known', kerbs(1) = 'unknown unknown' AND kerbs(2) = 'unknown unknown';
CREATE FUNCTION pg_temp.place(x float8, y float8) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
INSERT INTO town.footway_kerb (footway_kerb_id, geom, kerb) VALUES (1, pg_temp.place(30, 4.3), 'lowered'), (2, pg_temp.place(30, -6), 'raised'), (3, pg_temp.place(30, -8), 'rolled'), (4, pg_temp.place(30, 30), 'no');
SELECT 'each end has the nearest kerb that footways come over there', kerbs(1) = 'lowered raised' AND kerbs(2) = 'unknown unknown' AND as_run();
SELECT 'cross-sections show it', across(1, 'left') = 'lowered' AND across(1, 'right') = 'standing';
INSERT INTO town.footway_kerb (footway_kerb_id, geom, kerb) VALUES (5, pg_temp.place(64.9, 5), 'rolled');
SELECT 'also where one crosses askew', kerbs(2) = 'rolled unknown' AND across(2, 'left') = 'rolled' AND as_run();
INSERT INTO town.footway_kerb (footway_kerb_id, geom, kerb) VALUES (6, pg_temp.place(107, 7), 'raised'), (7, pg_temp.place(107, -5), 'lowered');
SELECT 'and within a junction', kerbs(3) = 'raised lowered' AND as_run();
UPDATE town.footway_kerb SET kerb = 'flush' WHERE footway_kerb_id = 1;
SELECT 'live', kerbs(1) = 'flush raised' AND as_run();
UPDATE town.footway_kerb SET geom = pg_temp.place(30, -20) WHERE footway_kerb_id = 2;
SELECT 'one that moves away leaves the next one', kerbs(1) = 'flush rolled' AND as_run();
DELETE FROM town.footway_kerb WHERE footway_kerb_id = 3;
SELECT 'and none where none is left', kerbs(1) = 'flush unknown' AND as_run();
UPDATE town.axis SET width = 24 WHERE axis_id = 1;
SELECT 'the street moves its ends', kerbs(2) = 'unknown unknown' AND as_run();
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
UPDATE town.pedestrian_crossing_editing SET kerb = 'raised' WHERE street_object_id = (SELECT street_object_id FROM crossing WHERE footway_id = 2);
SELECT 'by hand goes first', kerbs(2) = 'raised raised' AND across(2, 'left') = 'standing' AND as_run();
INSERT INTO town.control_point (kind, geom, kerb) VALUES ('pedestrian_crossing', pg_temp.place(30, 0), 'rolled');
SELECT 'a node of the crossing tells where no kerb is mapped', kerbs(1) = 'flush rolled' AND as_run();
UPDATE town.control_point SET kerb = 'no';
SELECT 'live, too', kerbs(1) = 'flush no' AND as_run();
SELECT 'a kerb that nobody knows is refused', test.state($$UPDATE town.footway_kerb SET kerb = 'high'$$) = '23514' AND test.state($$INSERT INTO town.footway_kerb (geom) VALUES ('SRID=2154;POINT(0 0)')$$) = '23502';
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without footways nobody comes over them', (SELECT count(*) = 6 FROM town.footway_kerb) AND NOT EXISTS (SELECT FROM crossing WHERE num_nonnulls(kerb_left, kerb_right) > 0 AND kerb IS NULL);

-- Of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2, pg_temp.line('LINESTRING(0 0,200 0)')), (2, 'footway', NULL, NULL, '{"footway": "crossing"}', 2, pg_temp.line('LINESTRING(20 -8,20 8)'));
CREATE TABLE osm_control (node_id bigint, class text, direction text, traffic_signals_direction text, lights boolean, crossing text, markings text, kerb text, kerb_height text, geom geometry(Point, 2154));
INSERT INTO osm_control (node_id, class, kerb, kerb_height, geom) VALUES (1, 'kerb', 'lowered', NULL, pg_temp.place(20, 5)), (2, 'kerb', NULL, '0.12 m', pg_temp.place(20, -5)), (3, 'kerb', 'yes', NULL, pg_temp.place(20, -7)), (4, 'kerb', 'raised', NULL, pg_temp.place(90, 5)), (5, 'kerb', 'wavy', NULL, pg_temp.place(20, 7));
DO $$ BEGIN PERFORM streetgen.create_model('mapped', 2154, subjects => '{footway,object}'); END $$;
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('mapped', 'osm');
SELECT streetgen.generate('mapped') \g /dev/null
SELECT 'nodes of kerbs on footways', string_agg(source_ref || kerb, ' ' ORDER BY source_ref) = '1lowered 2raised' FROM mapped.footway_kerb;
SELECT 'those that say nothing, or lie on none, are told', array_agg(format('%s %s', what, source_refs) ORDER BY what COLLATE "C") = '{"kerb not understood, taken as unknown {5}","kerb of which nothing is said, left out {3,5}","kerb on no footway, left out {4}"}' FROM told WHERE what LIKE 'kerb %';
SELECT 'they are at the ends of the crossing', kerb_left = 'lowered' AND kerb_right = 'raised' FROM mapped.pedestrian_crossing;
UPDATE osm_control SET kerb = 'flush' WHERE node_id = 1;
DELETE FROM osm_control WHERE node_id = 2;
UPDATE mapped.footway_kerb SET kerb = 'no' WHERE source_ref = '1';
SELECT streetgen.import_osm('mapped', 'osm') \g /dev/null
SELECT 'a source that comes again is followed, and what is by hand stays', string_agg(source_ref || kerb, ' ') = '1no' FROM mapped.footway_kerb;
