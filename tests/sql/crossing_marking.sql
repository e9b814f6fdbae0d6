\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Crossings painted as they are tagged: of OpenStreetMap, of a layer, by hand, and by settings.  (name, holds)
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)');
CREATE TABLE osm_control (node_id bigint, class text, direction text, traffic_signals_direction text, lights boolean, crossing text, markings text, geom geometry(Point, 2154));
CREATE TABLE osm_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
CREATE TABLE osm_crossing_way (way_id bigint, crossing text, markings text, geom geometry(LineString, 2154));
CREATE TABLE tagged (node_id bigint, crossing text, markings text, lights boolean, means text, painted text);
INSERT INTO tagged VALUES
  (1, 'marked', 'zebra', false, 'zebra', 'zebra'), (2, 'uncontrolled', 'zebra:double', false, 'zebra', 'zebra'), (3, NULL, 'ladder:skewed', false, 'ladder', 'ladder'), (4, NULL, 'lines', false, 'lines', 'lines'),
  (5, 'traffic_signals', 'dashes', true, 'dashes', 'dashes'), (6, NULL, 'dots', false, 'dots', 'dots'), (7, NULL, 'rainbow', false, 'surface', 'surface'), (8, 'marked', 'yes', false, 'yes', 'zebra'),
  (9, 'unmarked', NULL, false, 'no', 'no'), (10, 'marked', 'no', false, 'no', 'no'), (11, 'zebra', NULL, false, 'zebra', 'zebra'), (12, 'traffic_signals', NULL, true, 'yes', 'zebra'), (13, 'uncontrolled', 'chessboard', false, 'yes', 'zebra'),
  (14, 'sometimes', NULL, false, NULL, 'zebra'), (15, NULL, NULL, false, NULL, 'zebra'), (16, 'traffic_signals;marked', 'pictograms', false, 'no', 'no'), (17, NULL, 'unknown;ladder', false, 'ladder', 'ladder'),
  (18, 'marked', 'zebra', false, 'lines', 'lines'), (19, 'marked', 'zebra', false, 'zebra', 'zebra');
INSERT INTO osm_control SELECT node_id, 'crossing', NULL, NULL, lights, crossing, markings, ST_SetSRID(ST_MakePoint(650000 + 30 * node_id, 6860000), 2154) FROM tagged;
-- The way over the street says more than node 18 does, and less than node 19.
INSERT INTO osm_crossing_way SELECT node_id, 'marked', CASE node_id WHEN 18 THEN 'lines' ELSE 'yes' END, ST_SetSRID(ST_MakeLine(ARRAY[ST_Translate(geom, 0, -6), geom, ST_Translate(geom, 0, 6)]), 2154) FROM osm_control WHERE node_id > 17;
INSERT INTO osm_object SELECT node_id, 'crossing', NULL, geom FROM osm_control;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,object}'); END $$;
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('town', 'osm');
SELECT streetgen.import_osm_objects('town', 'osm'), streetgen.generate('town') \g /dev/null
CREATE VIEW crossing AS SELECT t.node_id, t.means, t.painted, c.marking AS said, p.*, o.control_point_id FROM tagged t JOIN town.street_object o ON o.source_ref = t.node_id::text JOIN town.pedestrian_crossing p USING (street_object_id) LEFT JOIN town.control_point c USING (control_point_id);
SELECT 'each value of crossing:markings and of crossing has its marking, that of the way over the street first' AS name, count(*) = 19 AND bool_and(said IS NOT DISTINCT FROM means) AS holds FROM crossing;
SELECT 'and each crossing is painted by it', bool_and(painted_as = painted) FROM crossing;
SELECT 'values that nobody knows are told', array_agg(format('%s: %s %s', what, class, source_refs) ORDER BY what COLLATE "C") = '{"crossing not understood, taken as unknown: sometimes {14}","crossing:markings not understood, taken as unknown: chessboard {13}"}' FROM told WHERE what LIKE 'crossing%';
-- A street of 8 m: 7 stripes of 0.5 m on 4 m, lines of 0.2 m on 7.5 m.
CREATE FUNCTION paint(node bigint) RETURNS float8 LANGUAGE sql AS $$ SELECT ST_Area(stripes) FROM crossing WHERE node_id = node $$;
SELECT 'a zebra has stripes, a ladder lines about them', abs(paint(1) - 14) < 1e-6 AND abs(paint(3) - (14 + 3 - 1.4)) < 1e-6 AND abs(paint(4) - 3) < 1e-6;
SELECT 'dashes and dots lie along the lines', abs(paint(5) - 1.4) < 1e-6 AND abs(paint(6) - 14 * 0.09) < 1e-6;
SELECT 'a surface is all of its ground', abs(paint(7) - 32) < 1e-6;
SELECT 'people cross where nothing is painted too', bool_and(stripes IS NULL AND abs(ST_Area(surface) - 32) < 1e-6) AND count(*) = 3 FROM crossing WHERE painted_as = 'no';
SELECT 'an unmarked crossing is one of those that files have', count(*) = 19 FROM streetgen._marked_crossings('town') WHERE turn = 1;
SELECT 'OpenDRIVE says how each is painted', array_agg(n ORDER BY said) = '{5,3,11}' FROM (SELECT m[1] AS said, count(*) AS n FROM (SELECT string_agg(line, '' ORDER BY ordinality) AS file FROM streetgen.export_opendrive('town')) f,
  regexp_matches(file, 'type="crosswalk" subtype="(\w+)"', 'g') m GROUP BY m[1]) t;
SELECT 'pictures show a coloured one in a colour of its own', count(DISTINCT kind) = 2 FROM streetgen._object_drawn('town', ST_MakeEnvelope(650000, 6859990, 650600, 6860010, 2154), '{crossing}') d WHERE kind IN ('surface', 'zebra');

-- Settings, for what is painted of which no more is known.
SELECT streetgen.set('town', 'crossing_marking_at_signals', 'lines'), streetgen.set('town', 'crossing_marking', 'ladder'), streetgen.generate('town') \g /dev/null
SELECT 'a setting says it, another one at signals', array_agg(painted_as ORDER BY node_id) = '{ladder,lines,ladder,ladder,ladder}' FROM crossing WHERE node_id IN (8, 12, 13, 14, 15);
SELECT 'what is tagged stays', bool_and(painted_as = painted) FROM crossing WHERE node_id NOT IN (8, 12, 13, 14, 15);
UPDATE town.control_point SET geom = ST_Translate(geom, 0, 3) WHERE kind = 'signals' AND source_ref = '12/lights';
SELECT 'signals that move away leave it as elsewhere', painted_as = 'ladder' FROM crossing WHERE node_id = 12;
UPDATE town.control_point SET geom = ST_Translate(geom, 0, -3) WHERE kind = 'signals' AND source_ref = '12/lights';
SELECT 'and back', painted_as = 'lines' FROM crossing WHERE node_id = 12;
DELETE FROM town.control_point WHERE source_ref = '12/lights';
SELECT 'so do signals that go', painted_as = 'ladder' FROM crossing WHERE node_id = 12;
-- Live.
CREATE TABLE drawn AS SELECT node_id, painted_as, stripes FROM crossing WITH NO DATA;
CREATE FUNCTION as_run() RETURNS boolean LANGUAGE plpgsql AS $$ BEGIN
  TRUNCATE drawn; INSERT INTO drawn SELECT node_id, painted_as, stripes FROM crossing;
  PERFORM streetgen._update_object('town', NULL);
  RETURN (SELECT bool_and((c.painted_as, c.stripes::bytea) IS NOT DISTINCT FROM (d.painted_as, d.stripes::bytea)) FROM crossing c JOIN drawn d USING (node_id));
END $$;
UPDATE town.control_point SET marking = 'lines' WHERE source_ref = '1';
SELECT 'a marking of a control point paints its crossing anew', painted_as = 'lines' FROM crossing WHERE node_id = 1;
UPDATE town.pedestrian_crossing_editing SET marking = 'dots' WHERE street_object_id = (SELECT street_object_id FROM crossing WHERE node_id = 1);
SELECT 'by hand goes before the source', painted_as = 'dots' AND marking = 'dots' FROM crossing WHERE node_id = 1;
SELECT 'as a run over all', as_run();
SELECT streetgen.import_osm('town', 'osm'), streetgen.import_osm_objects('town', 'osm') \g /dev/null
SELECT 'and stays when the source comes again', painted_as = 'dots' FROM crossing WHERE node_id = 1;
UPDATE osm_control SET markings = 'lines' WHERE node_id = 3;
SELECT streetgen.import_osm('town', 'osm') \g /dev/null
SELECT 'what the source says anew is painted', painted_as = 'lines' FROM crossing WHERE node_id = 3;
UPDATE town.pedestrian_crossing_editing SET marking = NULL WHERE street_object_id = (SELECT street_object_id FROM crossing WHERE node_id = 1);
SELECT 'emptied it follows its control point', painted_as = (SELECT marking FROM town.control_point WHERE source_ref = '1') FROM crossing WHERE node_id = 1;
INSERT INTO town.pedestrian_crossing_editing (geom, marking) VALUES ('SRID=2154;POINT(650590 6860000)', 'ladder');
SELECT 'one is dropped with its paint', count(*) = 1 FROM town.pedestrian_crossing JOIN town.street_object USING (street_object_id) WHERE source IS NULL AND painted_as = 'ladder' AND ST_Area(stripes) > 15;
SELECT 'another word is refused', test.state($$UPDATE town.pedestrian_crossing_editing SET marking = 'stars'$$) = '23514' AND test.state($$UPDATE town.control_point SET marking = 'stars'$$) = '23514';
SELECT 'all as a run over all', as_run();

-- Of a layer.
CREATE TABLE layer (id integer, paint text, geom geometry(Point, 2154));
INSERT INTO layer VALUES (1, 'no', 'SRID=2154;POINT(650010 6860000)'), (2, NULL, 'SRID=2154;POINT(650020 6860000)');
SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "marking": "paint", "source_ref": "id"}') \g /dev/null
SELECT 'a mapping takes it', array_agg(coalesce(marking, '-') ORDER BY source_ref) = '{no,-}' FROM town.control_point WHERE source = 'layer';
UPDATE layer SET paint = 'stars' WHERE id = 2;
SELECT 'a word that is none is refused', test.state($$SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "marking": "paint", "source_ref": "id"}')$$) = '22023';
ALTER TABLE osm_control DROP crossing, DROP markings;
DROP TABLE osm_crossing_way;
SELECT streetgen.import_osm('town', 'osm') \g /dev/null
SELECT 'a table of an older flex file says nothing of it, and what is by hand stays', count(*) = 19 AND string_agg(source_ref, ' ') FILTER (WHERE marking IS NOT NULL) = '1' FROM town.control_point WHERE kind = 'pedestrian_crossing' AND source <> 'layer';
