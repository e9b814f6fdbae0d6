\set ECHO none
\ir shared/truths.sql
-- PostGIS in another schema than public, and models under a search_path that names neither.  Each SELECT is one truth: (name, holds).
DROP EXTENSION streetgen, postgis;
CREATE SCHEMA "gis Data";
CREATE EXTENSION postgis SCHEMA "gis Data";
CREATE EXTENSION streetgen;
CREATE SCHEMA town_osm;
SET search_path = town_osm;
SELECT 'nothing of streetgen looks for PostGIS in public' AS name,
       count(*) = 0 AS holds FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace AND array_to_string(proconfig, ' ') ~ 'search_path=[^=]*public';
SELECT streetgen.create_model('town', 2154), streetgen.create_model('hill', 2154, 3) \g /dev/null
CREATE TABLE osm_line (way_id bigint, class text NOT NULL, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text,
  junction text, layer text, bridge text, tunnel text, maxspeed text, area text, geom "gis Data".geometry("LineString", 2154));
INSERT INTO osm_line (way_id, class, width, geom)
SELECT id, 'residential', '7', "gis Data".ST_GeomFromText(line, 2154) FROM (VALUES (1, 'LINESTRING(650000 6860000,650050 6860000,650100 6860000)'),
  (2, 'LINESTRING(650100 6860000,650100 6860090)'), (3, 'LINESTRING(650100 6860000,650190 6860010)')) v(id, line);
SELECT 'import_osm finds the tables of the prefix by search_path', (SELECT count = 3 FROM streetgen.import_osm('town') WHERE what = 'new or changed');
SELECT 'and fills the axes', count(*) = 3 FROM town.axis;
SELECT 'import_osm takes a schema before the prefix', (SELECT count = 3 FROM streetgen.import_osm('hill', 'town_osm.osm') WHERE what = 'new or changed');
CREATE TABLE lines AS SELECT 5 AS id, 6.0 AS width, "gis Data".ST_GeomFromText('LINESTRING Z(650190 6860010 3,650300 6860010 4)', 2154) AS shape;
SELECT 'import_axes works', (SELECT count = 1 FROM streetgen.import_axes('town', 'lines', '{"geom": "shape", "width": "width", "source_ref": "id"}') WHERE what = 'new or changed');
SELECT 'follow works', test.state($$SELECT streetgen.follow('town', 'lines', '{"geom": "shape", "width": "width", "source_ref": "id"}')$$) = 'none';
UPDATE lines SET width = 5;
SELECT 'and the axes follow', width = 5 FROM town.axis WHERE source_ref = '5';
CREATE TABLE troncon AS SELECT 'T1' AS cleabs, 'Route à 1 chaussée' AS nature, 5.5 AS largeur_de_chaussee, shape FROM lines;
SELECT 'import_bdtopo works', (SELECT count = 1 FROM streetgen.import_bdtopo('hill', 'troncon') WHERE what = 'new or changed');
SELECT 'generate works: ' || m, (SELECT sum(inserted) > 0 FROM streetgen.generate(m)) AND (SELECT sum(inserted + updated + deleted) = 0 FROM streetgen.generate(m)) FROM unnest('{town,hill}'::name[]) m;
SELECT 'the model is sound: ' || m, NOT EXISTS (SELECT FROM streetgen.check_model(m) WHERE severity = 'error') FROM unnest('{town,hill}'::name[]) m;
SELECT 'a model without errors has intersections', count(*) = 2 FROM town.intersection;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
SELECT 'an edit is followed', count(*) = 1 FROM town.edge WHERE axis_id = 1 AND width = 8;
INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) SELECT a.axis_id, b.axis_id, 2, n.geom FROM town.corner c JOIN town.edge a ON a.edge_id = c.edge_a JOIN town.edge b ON b.edge_id = c.edge_b JOIN town.node n USING (node_id) WHERE c.radius > 2 LIMIT 1;
SELECT 'and what is decided by hand', count(*) = 1 FROM town.corner WHERE radius = 2 AND method = 'by_hand';
SELECT 'summary and svg work', EXISTS (SELECT FROM streetgen.summary('town') WHERE subject = 'edges' AND amount = 4) AND streetgen.svg('town') LIKE '<svg%</svg>%';
SELECT 'primitives work: ' || call, test.state('SELECT streetgen.' || replace(replace(call, '%a', '''LINESTRING(0 0,50 0)''::"gis Data".geometry'), '%b', '''LINESTRING(0 0,0 50)''::"gis Data".geometry')) = 'none'
FROM unnest(ARRAY['arc_centre(%a, %b, 7, 6, 5)', 'corner_arc(%a, %b, 7, 6, 5)', 'max_corner_radius(%a, %b, 7, 6)', 'border_line(%a, 10, 7)', 'section_surface(%a, 7, 5, 40)', 'clean(%a, ARRAY[]::boolean[], 1, 1)',
    'intersection_surface(ARRAY[%a, %b], ARRAY[7.0, 6], ARRAY[5.0, 0], true)', 'variable_buffer(%a, ARRAY[3.0, 4])', 'turning_radius(50, 7)']) call;
SELECT 'refusals are the same: ' || call, test.state(call) = wanted FROM (VALUES ('SELECT streetgen.create_model(''x'', 4326)', '22023'), ('SELECT streetgen.create_model(''x'', 999999)', '22023'),
    ('SELECT streetgen.import_osm(''town'', ''no such'')', '42P01'), ('SELECT streetgen.border_line(''POINT(0 0)''::"gis Data".geometry, 0, 7)', '22023')) v(call, wanted);
ALTER SCHEMA hill RENAME TO mount;
SELECT 'a model is adopted', test.state($$SELECT streetgen.adopt_model('mount')$$) = 'none';
SELECT 'with its SRID and dimension', srid = 2154 AND dimension = 3 FROM streetgen.model WHERE name = 'mount';
SELECT 'a model is dropped', test.state($$SELECT streetgen.drop_model('town')$$) = 'none';
