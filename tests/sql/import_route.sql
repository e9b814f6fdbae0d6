\set ECHO none
\ir shared/truths.sql
-- Routes of buses, trams, bicycles and trucks, and crossings with lights, as osm2pgsql writes them.  (name, holds)
SELECT FROM streetgen.create_model('town', 2154, subjects => '{junction}', driving_side => 'right') \g /dev/null
CREATE TABLE town_line (way_id bigint, class text NOT NULL, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text, junction text, layer text, bridge text, tunnel text, maxspeed text, geom geometry(LineString, 2154));
INSERT INTO town_line (way_id, class, geom) VALUES
  (1, 'residential', 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)'), (2, 'residential', 'SRID=2154;LINESTRING(650200 6860000,650100 6860000)'),
  (3, 'residential', 'SRID=2154;LINESTRING(650200 6860000,650200 6860100)'), (4, 'footway', 'SRID=2154;LINESTRING(650200 6860100,650200 6860200)'), (5, 'residential', 'SRID=2154;LINESTRING(650100 6860000,650100 6859900)');
SELECT 'without a table of routes it is said', count(*) = 1 FROM streetgen.import_osm('town', 'town') WHERE what LIKE 'no table of routes%';
CREATE TABLE town_route (relation_id bigint, kind text, ref text, name text, ordinality integer, role text, way_id bigint);
INSERT INTO town_route VALUES (7, 'bus', '29', 'east', 1, '', 1), (7, 'bus', '29', 'east', 2, '', 2), (7, 'bus', '29', 'east', 3, '', 3), (7, 'bus', '29', 'east', 5, '', 4),
  (8, 'bicycle', NULL, 'round', 1, '', 1), (8, 'bicycle', NULL, 'round', 2, 'backward', 2), (9, 'tram', 'T1', NULL, 1, '', 5);
CREATE TABLE report AS SELECT * FROM streetgen.import_osm('town', 'town');
CREATE FUNCTION pg_temp.routes() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(concat_ws(' ', route, ordinality, source_ref, coalesce(r.direction, '-')), ', ' ORDER BY route, ordinality) FROM town.axis_route r JOIN town.axis USING (axis_id) $$;
SELECT 'axes stand in the order of the route, each driven as its neighbours tell', pg_temp.routes() LIKE '7 1 1 direct, 7 2 2 reverse, 7 3 3 direct,%';
SELECT 'a role says the direction, and whoever cycles rides either way without one', pg_temp.routes() LIKE '%8 1 1 both, 8 2 2 reverse%';
SELECT 'where nothing tells the direction is unknown, and what is no axis is left out', pg_temp.routes() LIKE '%9 1 5 -' AND pg_temp.routes() NOT LIKE '%7 5%';
SELECT 'routes are counted by kind', (SELECT string_agg(class || count, ' ' ORDER BY class) = 'bicycle1 bus1 tram1' FROM report WHERE what = 'routes');
INSERT INTO town.axis_route (route, ordinality, axis_id, kind) SELECT 'mine', 1, axis_id, 'truck' FROM town.axis WHERE source_ref = '1';
UPDATE town_route SET ref = '30' WHERE relation_id = 7;
DELETE FROM town_route WHERE relation_id = 9;
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT 'a second delivery follows the source and leaves what is by hand', (SELECT string_agg(DISTINCT concat(route, ref), ' ' ORDER BY concat(route, ref)) = '730 8 mine' FROM town.axis_route);
-- Crossings.
CREATE TABLE town_control (node_id bigint, class text NOT NULL, direction text, traffic_signals_direction text, geom geometry(Point, 2154));
INSERT INTO town_control (node_id, class, geom) VALUES (1, 'crossing', 'SRID=2154;POINT(650088 6860000)'), (2, 'crossing', 'SRID=2154;POINT(650150 6860000)');
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT 'a table of an older flex file says nothing of lights', (SELECT array_agg(DISTINCT kind) = '{pedestrian_crossing}' FROM town.control_point);
ALTER TABLE town_control ADD lights boolean;
UPDATE town_control SET lights = node_id = 1;
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'a crossing with lights is a crossing and signals', (SELECT string_agg(source_ref || kind, ' ' ORDER BY source_ref) = '1pedestrian_crossing 1/lightssignals 2pedestrian_crossing' FROM town.control_point);
SELECT 'the junction beyond it has signals', EXISTS (SELECT FROM town.junction WHERE kind = 'signals');
UPDATE town_control SET lights = false;
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT 'which go with the tag', (SELECT array_agg(DISTINCT kind) = '{pedestrian_crossing}' FROM town.control_point);
SELECT FROM streetgen.drop_model('town') \g /dev/null
SELECT 'routes go with the model', to_regclass('town.axis_route') IS NULL;
