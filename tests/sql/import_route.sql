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
INSERT INTO town_route SELECT 10, kind, '5', NULL, way, '', way FROM unnest('{bus,tram}'::text[]) kind, generate_series(1, 2) way;
CREATE TABLE several AS SELECT * FROM streetgen.import_osm('town', 'town');
SELECT 'a relation of two kinds is a route of each', pg_temp.routes() LIKE '10/bus 1 1 direct, 10/bus 2 2 reverse, 10/tram 1 1 direct, 10/tram 2 2 reverse, 7 1 1 direct%' AND (SELECT string_agg(class || count, ' ' ORDER BY class) = 'bicycle1 bus2 tram1' FROM several WHERE what = 'routes');
DELETE FROM town_route WHERE relation_id = 10;
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
-- Routes follow their axes: pieces of a cut axis, an axis drawn the other way or elsewhere, a deleted one.
SELECT FROM streetgen.create_model('line', 2154, subjects => '{}') \g /dev/null
CREATE TABLE line_line (LIKE town_line);
INSERT INTO line_line (way_id, class, geom) VALUES (1, 'residential', 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)'), (2, 'residential', 'SRID=2154;LINESTRING(650400 6860000,650300 6860000,650100 6860000)'),
  (3, 'residential', 'SRID=2154;LINESTRING(650400 6860000,650500 6860000)'), (4, 'residential', 'SRID=2154;LINESTRING(650400 6860000,650400 6860100)');
CREATE TABLE line_route (LIKE town_route);
INSERT INTO line_route VALUES (7, 'bus', '29', 'east', 1, '', 1), (7, 'bus', '29', 'east', 2, '', 2), (7, 'bus', '29', 'east', 3, '', 3), (8, 'bicycle', NULL, NULL, 1, '', 4), (8, 'bicycle', NULL, NULL, 2, '', 2);
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
CREATE FUNCTION pg_temp.led() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(format('%s %s.%s %s at %s', route, ordinality, piece, r.direction, round((ST_X(ST_StartPoint(a.geom)) - 650000)::numeric)), ', ' ORDER BY route, ordinality, piece) FROM line.axis_route r LEFT JOIN line.axis a USING (axis_id) $$;
SELECT 'a route leads from axis to axis', pg_temp.led() = '7 1.1 direct at 0, 7 2.1 reverse at 400, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 400';
-- As QGIS splits: what stays first, then the rest, one of them drawn the other way.
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650300 6860000)' WHERE source_ref = '2';
SELECT 'what stays of an axis is on the route', pg_temp.led() LIKE '7 1.1 direct at 0, 7 2.1 reverse at 400, 7 3.1%';
INSERT INTO line.axis (geom, kind) VALUES ('SRID=2154;LINESTRING(650200 6860000,650300 6860000)', 'residential'), ('SRID=2154;LINESTRING(650200 6860000,650100 6860000)', 'residential'), ('SRID=2154;LINESTRING(650350 6860000,650350 6860080)', 'residential');
SELECT 'so are the other pieces, in the order in which the route leads along them, each as it is drawn',
  pg_temp.led() = '7 1.1 direct at 0, 7 2.1 reverse at 200, 7 2.2 direct at 200, 7 2.3 reverse at 400, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 400, 8 2.2 both at 200, 8 2.3 both at 200';
CREATE TABLE led AS SELECT pg_temp.led() AS led;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'another delivery gives the pieces the same', pg_temp.led() = led FROM led;
UPDATE line.axis SET geom = ST_Reverse(geom) WHERE source_ref = '2';
SELECT 'an axis that is drawn the other way is driven the other way', pg_temp.led() LIKE '%7 2.3 direct at 300, 7 3.1%8 2.1 both at 300%';
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'also after another delivery', pg_temp.led() LIKE '%7 2.3 direct at 300, 7 3.1%8 2.1 both at 300%';
DELETE FROM line.axis WHERE source_ref = '3';
SELECT 'a deleted axis is on no route', pg_temp.led() NOT LIKE '% 7 3.%' AND pg_temp.led() LIKE '7 1.1 direct at 0, 7 2.1 %';
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650050 6860030,650100 6860000)' WHERE source_ref = '1';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650010 6860000,650090 6860000)');
SELECT 'one that is drawn elsewhere takes its routes along, and leaves none behind', pg_temp.led() LIKE '7 1.1 direct at 0, 7 2.1 %';
SELECT 'all routes are on axes', NOT EXISTS (SELECT FROM line.axis_route WHERE axis_id NOT IN (SELECT axis_id FROM line.axis));
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6860200,650050 6860250,650100 6860200,650150 6860200)');
INSERT INTO line.axis_route (route, ordinality, axis_id, kind, direction) SELECT 'mine', 1, max(axis_id), 'truck', 'direct' FROM line.axis;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650100 6860200,650150 6860200)' WHERE axis_id = (SELECT axis_id FROM line.axis_route WHERE route = 'mine');
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6860200,650100 6860200)');
SELECT 'a short cut between two vertices of a cut axis is no piece of it', pg_temp.led() LIKE '%, mine 1.1 direct at 100';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6860200,650050 6860250,650100 6860200)');
SELECT 'the piece with the bend is', pg_temp.led() LIKE '%, mine 1.1 direct at 0, mine 1.2 direct at 100';
TRUNCATE line.axis CASCADE;
SELECT 'where all axes go, all routes do', NOT EXISTS (SELECT FROM line.axis_route);
-- A street in the freed stretch of a trimmed axis, which leads on where it touches.
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6861000,650400 6861000)');
INSERT INTO line.axis_route (route, ordinality, axis_id, kind, direction) SELECT 'mine', 1, max(axis_id), 'truck', 'direct' FROM line.axis;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650000 6861000,650100 6861000)';
INSERT INTO line.axis (geom, kind, level) VALUES ('SRID=2154;LINESTRING(650100 6861000,650200 6861000)', 'footway', 1);
SELECT 'a bridge that begins where an axis was trimmed is no piece of it', pg_temp.led() = 'mine 1.1 direct at 0';
INSERT INTO line.axis (geom, kind) VALUES ('SRID=2154;LINESTRING(650100 6861000,650150 6861000)', 'footway');
SELECT 'nor is a footway on its level', pg_temp.led() = 'mine 1.1 direct at 0';
DELETE FROM line.axis WHERE kind = 'footway' AND level = 0;
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650200 6861000,650400 6861000)');
SELECT 'nor is a street apart from it', pg_temp.led() = 'mine 1.1 direct at 0';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650200 6861000,650100 6861000)');
SELECT 'until a piece leads from one to the other', pg_temp.led() = 'mine 1.1 direct at 0, mine 1.2 reverse at 200, mine 1.3 direct at 200';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650250 6861000,650400 6861000)');
SELECT 'a line upon a piece is none', pg_temp.led() LIKE '%, mine 1.3 direct at 200';
TRUNCATE line.axis CASCADE;
-- The cut of an axis is moved, one piece after the other.
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650200 6860000)' WHERE source_ref = '2';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650100 6860000,650200 6860000)');
UPDATE led SET led = '7 1.1 direct at 0, 7 2.1 direct at 100, 7 2.2 reverse at 400, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 400, 8 2.2 both at 100';
SELECT 'one piece is cut off', pg_temp.led() = led FROM led;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650100 6860000,650200 6860006)' WHERE source_ref IS NULL;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650200 6860006)' WHERE source_ref = '2';
SELECT 'pieces keep their order where their cut is moved', pg_temp.led() = led FROM led;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'and stay on their routes at another delivery', pg_temp.led() = led FROM led;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650300 6860003)' WHERE source_ref = '2';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650300 6860003,650200 6860006)');
UPDATE led SET led = '7 1.1 direct at 0, 7 2.1 direct at 100, 7 2.2 reverse at 300, 7 2.3 reverse at 400, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 400, 8 2.2 both at 300, 8 2.3 both at 100';
SELECT 'a moved piece is cut like another', pg_temp.led() = led FROM led;
-- The piece that has the id of the way is deleted.
DELETE FROM line.axis WHERE source_ref = '2';
CREATE TABLE stayed AS SELECT pg_temp.led() AS led;
SELECT 'who deletes a piece leaves the others', led = '7 1.1 direct at 0, 7 2.1 direct at 100, 7 2.2 reverse at 300, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.2 both at 300, 8 2.3 both at 100' FROM stayed;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'also at the next delivery', pg_temp.led() = '7 1.1 direct at 0, 7 2.1 direct at 100, 7 2.2 reverse at 300, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 300, 8 2.2 both at 100';
UPDATE line_route SET ordinality = ordinality + 1;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'and where their place is another one', pg_temp.led() = '7 2.1 direct at 0, 7 3.1 direct at 100, 7 3.2 reverse at 300, 7 4.1 direct at 400, 8 2.1 both at 400, 8 3.1 both at 300, 8 3.2 both at 100';
UPDATE line_route SET ordinality = ordinality - 1;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
TRUNCATE line.axis, line.delivered CASCADE;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650200 6860000)' WHERE source_ref = '2';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650100 6860000,650200 6860000)');
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650100 6860000,650200 6860006)' WHERE source_ref IS NULL;
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650200 6860006)' WHERE source_ref = '2';
UPDATE line.axis SET geom = 'SRID=2154;LINESTRING(650400 6860000,650300 6860003)' WHERE source_ref = '2';
INSERT INTO line.axis (geom) VALUES ('SRID=2154;LINESTRING(650300 6860003,650200 6860006)');
-- The end of the whole is moved along with the next street, and a piece becomes a bridge.
UPDATE line.axis SET geom = ST_SetPoint(geom, CASE source_ref WHEN '1' THEN 1 ELSE 0 END, 'SRID=2154;POINT(650100 6860009)') WHERE source_ref = '1' OR ST_X(ST_StartPoint(geom)) = 650100;
UPDATE line.axis SET level = 1 WHERE ST_X(ST_StartPoint(geom)) = 650300;
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'the ways beside a moved one are driven as they were', pg_temp.led() = led FROM led;
UPDATE line_line SET geom = 'SRID=2154;LINESTRING(650400 6860000,650300 6860000,650100 6860001.5)' WHERE way_id = 2;
SELECT FROM streetgen.set('line', 'delivery_wins', 'source') \g /dev/null
SELECT FROM streetgen.import_osm('line', 'line') \g /dev/null
SELECT 'an axis that the source makes whole again is one piece', pg_temp.led() LIKE '%, 7 2.1 reverse at 400, 7 3.1 direct at 400, 8 1.1 both at 400, 8 2.1 both at 400';
CREATE ROLE route_editor; CREATE ROLE route_reader;
SELECT streetgen.grant('line', 'route_editor', 'editor'), streetgen.grant('line', 'route_reader', 'reader') \g /dev/null
SET ROLE route_editor;
INSERT INTO line.axis_route (route, ordinality, axis_id, kind) SELECT 'theirs', 1, min(axis_id), 'bus' FROM line.axis;
UPDATE line.axis_route SET name = 'ring' WHERE route = 'theirs';
SELECT 'an editor writes a route', name = 'ring' FROM line.axis_route WHERE route = 'theirs';
DELETE FROM line.axis_route WHERE route = 'theirs';
SET ROLE route_reader;
SELECT 'a reader does not', test.state($$DELETE FROM line.axis_route$$) = '42501';
RESET ROLE;
SELECT FROM streetgen.drop_model('line') \g /dev/null
DROP OWNED BY route_editor, route_reader;
DROP ROLE route_editor, route_reader;
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
INSERT INTO town_control (node_id, class, geom, lights) VALUES (3, 'traffic_signals', 'SRID=2154;POINT(650200 6860012)', true), (4, 'traffic_signals', 'SRID=2154;POINT(650030 6860000)', false);
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT 'signals with a crossing are signals and a crossing', (SELECT string_agg(source_ref || kind, ' ' ORDER BY source_ref) = '3signals 3/crossingpedestrian_crossing 4signals' FROM town.control_point WHERE source_ref ~ '^[34]');
DELETE FROM town_control WHERE node_id > 2;
-- Those of a cycle track, 4 m beside the axis of its street.
INSERT INTO town_control (node_id, class, geom, lights) VALUES (5, 'crossing', 'SRID=2154;POINT(650088 6860004)', true), (6, 'traffic_signals', 'SRID=2154;POINT(650089 6860004)', false);
SELECT 'a crossing on no axis is none of the street beside it, nor are its lights', source_refs = '{5}' FROM streetgen.import_osm('town', 'town') WHERE (what, class) = ('control point off all axes, left out', 'pedestrian_crossing');
SELECT 'signals beside the roadway are', string_agg(source_ref || kind, ' ' ORDER BY source_ref) = '6signals' FROM town.control_point WHERE source_ref ~ '^[56]';
DELETE FROM town_control WHERE node_id > 2;
UPDATE town_control SET lights = false;
SELECT FROM streetgen.import_osm('town', 'town') \g /dev/null
SELECT 'which go with the tag', (SELECT array_agg(DISTINCT kind) = '{pedestrian_crossing}' FROM town.control_point);
SELECT FROM streetgen.drop_model('town') \g /dev/null
SELECT 'routes go with the model', to_regclass('town.axis_route') IS NULL;
