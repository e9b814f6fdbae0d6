\set ECHO none
\ir shared/truths.sql
-- Kerbs at both ends of crossings as they are tagged: of OpenStreetMap, of a layer, by hand.  (name, holds)
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)');
CREATE TABLE osm_control (node_id bigint, class text, direction text, traffic_signals_direction text, lights boolean, crossing text, markings text, kerb text, kerb_height text, geom geometry(Point, 2154));
CREATE TABLE osm_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
CREATE TABLE tagged (node_id bigint, kerb text, height text, means text, stands text);
INSERT INTO tagged VALUES (1, 'raised', NULL, 'raised', 'standing'), (2, 'lowered', NULL, 'lowered', 'lowered'), (3, 'rolled', NULL, 'rolled', 'rolled'), (4, 'flush', NULL, 'flush', 'flush'), (5, 'no', NULL, 'no', 'flush'),
  (6, NULL, '0.12', 'raised', 'standing'), (7, NULL, '3 cm', 'lowered', 'lowered'), (8, 'yes', '0', 'flush', 'flush'), (9, NULL, NULL, NULL, 'flush'), (10, 'wobbly', NULL, NULL, 'flush'), (11, 'lowered;raised', '0.12', 'lowered', 'lowered'), (12, 'yes', NULL, NULL, 'flush');
INSERT INTO osm_control SELECT node_id, 'crossing', NULL, NULL, false, 'marked', NULL, kerb, height, ST_SetSRID(ST_MakePoint(650000 + 40 * node_id, 6860000), 2154) FROM tagged;
INSERT INTO osm_object SELECT node_id, 'crossing', NULL, geom FROM osm_control;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{kerb,object}'); END $$;
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('town', 'osm');
SELECT streetgen.import_osm_objects('town', 'osm'), streetgen.generate('town') \g /dev/null
SELECT 'each value of kerb, else its height, has its word' AS name, count(*) = 12 AND bool_and(c.kerb IS NOT DISTINCT FROM t.means) AS holds FROM tagged t JOIN town.control_point c ON c.source_ref = t.node_id::text;
SELECT 'a value that nobody knows is told', array_agg(class || source_refs::text) = '{"wobbly{10}"}' FROM told WHERE what = 'kerb not understood, taken as unknown';
-- The kerbs at both ends, as the cross-section has them in the middle of the crossing.
CREATE VIEW at_crossing AS SELECT o.street_object_id, o.source_ref::integer AS node_id, string_agg(DISTINCT x.kerb, ' ') AS kerbs, count(*) AS sides FROM town.street_object o JOIN town.cross_section x ON x.axis_id = o.axis_id AND x.kind = 'kerb' AND o.abscissa BETWEEN x.start_abscissa + 0.1 AND x.end_abscissa - 0.1
  WHERE o.type = 'crossing' GROUP BY o.street_object_id;
SELECT 'at both ends of its crossing the kerb is as the tag says, flush where it says nothing', count(*) = 12 AND bool_and(kerbs = stands AND sides = 2) FROM at_crossing JOIN tagged USING (node_id);
SELECT 'elsewhere it stands', bool_and(kerb = 'standing') FROM town.cross_section WHERE kind = 'kerb' AND start_abscissa < 30 AND end_abscissa < 40;
UPDATE town.pedestrian_crossing_editing SET kerb = 'lowered' WHERE street_object_id = (SELECT street_object_id FROM at_crossing WHERE node_id = 1);
SELECT 'by hand goes before the tag', kerbs = 'lowered' FROM at_crossing WHERE node_id = 1;
UPDATE town.control_point SET kerb = 'raised' WHERE source_ref IN ('1', '2');
SELECT 'a control point speaks to its crossing', array_agg(kerbs ORDER BY node_id) = '{lowered,standing}' FROM at_crossing WHERE node_id IN (1, 2);
SELECT streetgen.import_osm('town', 'osm') \g /dev/null
SELECT 'what is by hand stays when the source comes again', array_agg(kerb ORDER BY source_ref) = '{raised,raised}' FROM town.control_point WHERE source_ref IN ('1', '2');
UPDATE town.pedestrian_crossing_editing SET kerb = NULL WHERE street_object_id = (SELECT street_object_id FROM at_crossing WHERE node_id = 1);
SELECT 'emptied it follows the control point', kerbs = 'standing' FROM at_crossing WHERE node_id = 1;
SELECT 'another word is refused', test.state($$UPDATE town.pedestrian_crossing_editing SET kerb = 'high'$$) = '23514' AND test.state($$UPDATE town.control_point SET kerb = 'high'$$) = '23514';
CREATE TABLE layer (id integer, stone text, geom geometry(Point, 2154));
INSERT INTO layer VALUES (1, 'rolled', 'SRID=2154;POINT(650010 6860000)');
SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "kerb": "stone", "source_ref": "id"}') \g /dev/null
SELECT 'a mapping takes it', kerb = 'rolled' FROM town.control_point WHERE source = 'layer';
UPDATE layer SET stone = 'high';
SELECT 'a word that is none is refused', test.state($$SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "kerb": "stone", "source_ref": "id"}')$$) = '22023';
