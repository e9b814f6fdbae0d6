\set ECHO none
\ir shared/truths.sql
-- Refuges in the middle of crossings: of OpenStreetMap, of a layer, by hand, live.  (name, holds)
SET client_min_messages = warning;
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', 'both ways', NULL, '{"width": "9", "lanes": "2"}', 2, 'SRID=2154;LINESTRING(650000 6860000, 650300 6860000)'),
  (2, 'residential', 'one way', NULL, '{"width": "9", "lanes": "2", "oneway": "yes"}', 2, 'SRID=2154;LINESTRING(650000 6860100, 650300 6860100)'),
  (3, 'residential', 'narrow', NULL, '{"width": "5.6", "lanes": "2"}', 2, 'SRID=2154;LINESTRING(650000 6860200, 650300 6860200)'),
  (4, 'secondary', 'turn lane', NULL, '{"width": "10", "lanes": "3", "lanes:forward": "1", "lanes:backward": "1", "lanes:both_ways": "1"}', 2, 'SRID=2154;LINESTRING(650000 6860300, 650300 6860300)');
CREATE TABLE osm_control (node_id bigint, class text, direction text, traffic_signals_direction text, lights boolean, crossing text, markings text, kerb text, kerb_height text, island text, geom geometry(Point, 2154));
INSERT INTO osm_control SELECT 10 * way_id + n, 'crossing', NULL, NULL, false, 'marked', 'zebra', NULL, NULL, CASE n WHEN 1 THEN 'yes' WHEN 2 THEN 'no' WHEN 3 THEN 'maybe' END, ST_SetSRID(ST_MakePoint(650000 + 60 * n, 6859900 + 100 * way_id), 2154)
  FROM generate_series(1, 4) way_id, generate_series(1, 4) n;
CREATE TABLE osm_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
INSERT INTO osm_object SELECT node_id, 'crossing', NULL, geom FROM osm_control;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{lane,kerb,object}', driving_side => 'right'); END $$;
SELECT streetgen.import_osm('town', 'osm'), streetgen.import_osm_objects('town', 'osm'), streetgen.generate('town') \g /dev/null
CREATE VIEW at_node AS SELECT o.source_ref::integer AS node_id, c.*, o.axis_id, o.abscissa FROM town.pedestrian_crossing c JOIN town.street_object o USING (street_object_id);
SELECT 'a refuge comes where the tag says yes' AS name, array_agg(node_id ORDER BY node_id) FILTER (WHERE island IS NOT NULL) = '{11,41}' AS holds FROM at_node;
SELECT 'between both directions, as wide as the setting, and longer than the crossing', abs(ST_YMax(island) - ST_YMin(island) - 2) < 1e-6 AND abs(ST_XMax(island) - ST_XMin(island) - (width + 3)) < 1e-6
  AND ST_DWithin(ST_Centroid(island), 'SRID=2154;POINT(650060 6860000)', 1e-6) FROM at_node WHERE node_id = 11;
SELECT 'its crossing is not painted on it', ST_Area(ST_Intersection(stripes, island)) < 1e-9 AND ST_Area(stripes) < (SELECT ST_Area(stripes) FROM at_node WHERE node_id = 12) FROM at_node WHERE node_id = 11;
SELECT 'it lies on the roadway', bool_and(ST_Area(ST_Difference(c.island, s.surface)) < 1e-9) FROM at_node c JOIN town.edge e USING (axis_id) JOIN town.section s USING (edge_id) WHERE c.island IS NOT NULL;
SELECT 'in the middle of a lane for turning', ST_DWithin(ST_Centroid(island), 'SRID=2154;POINT(650060 6860300)', 1e-6) FROM at_node WHERE node_id = 41;
SELECT 'one without room is told, and none of a one-way street', array_agg(o.source_ref) = '{31}' FROM streetgen.check_model('town') f JOIN town.street_object o ON o.street_object_id = f.id WHERE f.rule = 'refuge without room, m';
UPDATE town.axis SET width = 8 WHERE name = 'narrow';
SELECT 'a wider street has room', abs(ST_YMax(island) - ST_YMin(island) - 2) < 1e-6 FROM at_node WHERE node_id = 31;
UPDATE town.axis SET width = 6.5 WHERE name = 'narrow';
SELECT 'a narrow one makes it narrower, since a lane of 2.5 m passes it', abs(ST_YMax(island) - ST_YMin(island) - 1.5) < 1e-6 FROM at_node WHERE node_id = 31;
UPDATE town.pedestrian_crossing_editing SET refuge = 0 WHERE street_object_id = (SELECT street_object_id FROM at_node WHERE node_id = 11);
UPDATE town.pedestrian_crossing_editing SET refuge = 1.4 WHERE street_object_id = (SELECT street_object_id FROM at_node WHERE node_id = 12);
SELECT 'by hand goes before the source', (SELECT island IS NULL FROM at_node WHERE node_id = 11) AND abs(ST_YMax(island) - ST_YMin(island) - 1.4) < 1e-6 FROM at_node WHERE node_id = 12;
UPDATE town.control_point SET refuge = 'yes' WHERE source_ref = '14';
SELECT 'a control point speaks to its crossing', island IS NOT NULL FROM at_node WHERE node_id = 14;
-- A way that its source cuts at the crossing, a street that tapers, and a crossing by hand at a control point by hand.
SELECT streetgen.create_model('cut', 2154, subjects => '{lane,kerb,object}', driving_side => 'left') \g /dev/null
INSERT INTO cut.axis (axis_id, geom, width, width_end, lane_count) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650050 6860000)', 9, NULL, 2), (2, 'SRID=2154;LINESTRING(650050 6860000, 650100 6860000)', 9, NULL, 2),
  (3, 'SRID=2154;LINESTRING(650000 6860200, 650100 6860200)', 8, 16, 4), (4, 'SRID=2154;LINESTRING(650000 6860300, 650100 6860300)', 4, NULL, NULL);
UPDATE cut.axis SET lanes_forward = 1, lanes_backward = 3 WHERE axis_id = 3;
INSERT INTO cut.control_point (geom, kind, refuge, marking) VALUES ('SRID=2154;POINT(650050 6860000)', 'pedestrian_crossing', 'yes', 'ladder');
INSERT INTO cut.pedestrian_crossing_editing (geom, refuge) VALUES ('SRID=2154;POINT(650050 6860000)', NULL), ('SRID=2154;POINT(650080 6860200)', 1), ('SRID=2154;POINT(650050 6860300)', 2);
SELECT 'it lies over the end of a way that is cut there, as the control point beside says', painted_as = 'ladder' AND ST_DWithin(ST_Centroid(island), 'SRID=2154;POINT(650050 6860000)', 1e-6) AND abs(ST_XMax(island) - ST_XMin(island) - (width + 3)) < 1e-6 FROM cut.pedestrian_crossing JOIN cut.street_object USING (street_object_id) WHERE axis_id IN (1, 2);
SELECT 'on a tapering street it lies where its lanes are there', ST_Area(ST_Intersection(c.island, a.surface)) > 0.45 * ST_Area(c.island) AND ST_Area(ST_Intersection(c.island, b.surface)) > 0.45 * ST_Area(c.island)
  FROM cut.pedestrian_crossing c JOIN cut.street_object o USING (street_object_id) JOIN cut.edge e USING (axis_id) JOIN cut.lane a ON a.edge_id = e.edge_id AND a.along_axis JOIN cut.lane b ON b.edge_id = e.edge_id AND NOT b.along_axis AND abs(b.lane_position - a.lane_position) = 1 WHERE axis_id = 3;
SELECT 'one on a lane for both directions is told', array_agg(o.axis_id) = '{4}' FROM streetgen.check_model('cut') f JOIN cut.street_object o ON o.street_object_id = f.id WHERE f.rule = 'refuge without room, m';
SELECT streetgen.set('town', 'refuge_width', '3') \g /dev/null
SELECT streetgen.generate('town', wait => true) \g /dev/null
SELECT 'the setting says how wide', abs(ST_YMax(island) - ST_YMin(island) - 3) < 1e-6 FROM at_node WHERE node_id = 14;
UPDATE town.pedestrian_crossing_editing SET angle = 60 WHERE street_object_id = (SELECT street_object_id FROM at_node WHERE node_id = 14);
SELECT 'a crossing aslant has it where it meets the middle', ST_DWithin(ST_Centroid(island), 'SRID=2154;POINT(650240 6860000)', 1e-6) FROM at_node WHERE node_id = 14;
SELECT 'it is drawn', count(*) = 4 FROM streetgen._object_drawn('town', ST_MakeEnvelope(649900, 6859900, 650400, 6860400, 2154), '{refuge}');
UPDATE town.axis SET geom = ST_Reverse(geom);
SELECT 'a street that turns round keeps it', count(island) = 4 AND bool_or(node_id = 14 AND ST_DWithin(ST_Centroid(island), 'SRID=2154;POINT(650240 6860000)', 1e-6)) FROM at_node;
CREATE TABLE before AS SELECT street_object_id, island::bytea FROM town.pedestrian_crossing;
DO $$ BEGIN SET LOCAL streetgen.computes = 'on'; UPDATE town.edge SET input_hash = 0; END $$;
SELECT streetgen.generate('town', wait => true) \g /dev/null
SELECT 'edits equal a run over all', NOT EXISTS (SELECT street_object_id, island::bytea FROM town.pedestrian_crossing EXCEPT TABLE before);
SELECT FROM streetgen.switch_subject('town', 'lane', false);
SELECT 'without lanes it has no place', count(island) = 0 FROM town.pedestrian_crossing;
SELECT FROM streetgen.switch_subject('town', 'lane', true);
SELECT 'with them it is back', NOT EXISTS (SELECT street_object_id, island::bytea FROM town.pedestrian_crossing EXCEPT TABLE before);
CREATE TABLE layer (id integer, isle text, geom geometry(Point, 2154));
INSERT INTO layer VALUES (1, 'yes', 'SRID=2154;POINT(650010 6860000)');
SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "refuge": "isle", "source_ref": "id"}') \g /dev/null
SELECT 'a mapping takes it', refuge = 'yes' FROM town.control_point WHERE source = 'layer';
UPDATE layer SET isle = 'perhaps';
SELECT 'a word that is none is refused', test.state($$SELECT streetgen.import_control_points('town', 'layer', '{"kind": {"value": "pedestrian_crossing"}, "refuge": "isle", "source_ref": "id"}')$$) = '22023' AND test.state($$UPDATE town.control_point SET refuge = 'perhaps'$$) = '23514';
SELECT 'so is a width out of range', test.state($$UPDATE town.pedestrian_crossing_editing SET refuge = -1$$) = '23514';
