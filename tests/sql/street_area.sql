\set ECHO none
\ir shared/truths.sql
-- Areas of the street, as squares, car parks and platforms: drawn, imported, cut by what comes before them, live.
-- (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.shape(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154),
  650000, 6860000) $$;
CREATE FUNCTION pg_temp.box(west float8, south float8, east float8, north float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_Multi(ST_MakeEnvelope(650000 + west, 6860000 + south, 650000 + east, 6860000 + north, 2154)) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{footway}');
  INSERT INTO town.axis (axis_id, geom, width, importance, kind, sidewalk_left, sidewalk_right) VALUES (1,
  pg_temp.shape('LINESTRING(0 0,100 0)'), 8, 4, 'residential', 2, 2);
  INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (1, pg_temp.box(10, -30, 50, 30), 'square');
END $$;
CREATE FUNCTION ground(area bigint) RETURNS float8 LANGUAGE sql AS $$
  SELECT coalesce(round(sum(ST_Area(surface))::numeric, 1), 0)::float8 FROM town.area_surface
  WHERE street_area_id = area $$;
CREATE FUNCTION shared() RETURNS float8 LANGUAGE sql AS $$ SELECT coalesce(sum(ST_Area(ST_Intersection(a.surface,
  o.surface))), 0) FROM (SELECT 'area' AS of, street_area_id AS id, level, surface FROM town.area_surface) a JOIN (
  SELECT 'area' AS of, street_area_id AS id, level, surface FROM town.area_surface UNION ALL SELECT 'footway',
  footway_id, level, surface FROM town.footway_surface
  UNION ALL SELECT 'section', edge_id, 0, surface FROM town.section UNION ALL SELECT 'sidewalk', sidewalk_id, 0,
  surface FROM town.sidewalk) o ON (o.of, o.id) <> (a.of, a.id) AND o.level = a.level $$;
SELECT 'a square gives way to roadway and sidewalks', ground(1) = 40 * (60 - 8 - 4);
INSERT INTO town.footway (footway_id, geom, kind, width) VALUES (1, pg_temp.shape('LINESTRING(20 10,20 30)'),
  'cycleway', 2), (2, pg_temp.shape('LINESTRING(30 20,60 20)'), 'footway', 2);
SELECT 'to cycle tracks and walks', ground(1) = 40 * 48 - 2 * 20 - 2 * 20 AND (SELECT abs(ST_Area(surface) - 60) < 0.1
  FROM town.footway_surface WHERE footway_id = 2);
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (2, pg_temp.box(40, 10, 80, 30), 'parking_area'), (3,
  pg_temp.box(70, 10, 90, 12), 'platform'), (4, pg_temp.box(25, 15, 35, 25), 'walk');
SELECT 'a car park gives way to it, and a platform to the car park', ground(2) = 30 * 20 - 2 * 10
  AND ground(3) = 2 * 10;
SELECT 'a walk that is drawn as an area comes before a line, and both before the square', ground(4) = 100
  AND (SELECT abs(ST_Area(surface) - 2 * 25) < 0.1 FROM town.footway_surface WHERE footway_id = 2)
  AND ground(1) = 40 * 48 - 40 - 2 * 15 - 100;
SELECT 'nothing shares ground', shared() < 0.01;
UPDATE town.axis SET width = 10;
SELECT 'live, as the street is wider', ground(1) = 40 * 46 - 40 - 2 * 15 - 100 AND shared() < 0.01;
UPDATE town.axis SET width = 8;
INSERT INTO town.street_area (street_area_id, geom, kind, level) VALUES (5, pg_temp.box(10, -30, 50, 30), 'square',
  1);
SELECT 'one of another level gives way to nothing of this', ground(5) = 40 * 60;
DELETE FROM town.street_area WHERE street_area_id IN (2, 3, 4, 5);
DELETE FROM town.footway;
-- Its border runs 0.1 m beside the sidewalk's for 4 m.
UPDATE town.street_area SET geom = ST_Multi(ST_Difference(pg_temp.box(10, 6, 50, 30), ST_Union(pg_temp.box(20, 6, 24,
  6.1), pg_temp.box(30, 6, 40, 7)))) WHERE street_area_id = 1;
SELECT 'a hole too small to be one is filled, a larger one is not', ground(1) = 40 * 24 - 10;
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (6, pg_temp.box(5, 6.08, 10, 9), 'platform'), (7,
  pg_temp.box(0, 0, 5, 9), 'parking_area');
SELECT 'also one between several, by the first of them', ground(1) = 40 * 24 - 10 + 0.4 AND ground(7) = 5 * 3
  AND ground(6) = 14.6 AND shared() < 0.01;
SELECT 'an area of roadway has no ground of its own', ground(8) = 0 FROM (VALUES (1)) v,
  LATERAL (SELECT test.state($$INSERT INTO town.street_area (street_area_id, geom, kind) SELECT 8, geom, 'roadway'
  FROM town.street_area WHERE street_area_id = 1$$)) s;
SELECT 'a kind that nobody knows is refused, and so is no kind',
  test.state($$UPDATE town.street_area SET kind = 'garden'$$) = '23514'
  AND test.state($$INSERT INTO town.street_area (geom) SELECT geom FROM town.street_area$$) = '23502'
  AND test.state($$UPDATE town.street_area SET foot = 'maybe'$$) = '23514'
  AND test.state($$UPDATE town.street_area SET geom = 'SRID=2154;MULTIPOLYGON EMPTY'$$) = '23514';

-- What is amiss is told.
CREATE FUNCTION amiss() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(format('%s %s %s', id, rule,
  round(measure)), '; ' ORDER BY id, rule) FROM streetgen.check_model('town') WHERE relation = 'street_area' $$;
DELETE FROM town.street_area;
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (11,
  ST_Multi(pg_temp.shape('POLYGON((0 20,20 40,20 20,0 40,0 20))')), 'square');
SELECT 'an area that crosses itself is mended', ground(11) = 200;
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (12, pg_temp.box(10, 0, 30, 5), 'platform'), (13,
  pg_temp.box(60, -20, 90, 20), 'square'), (14, pg_temp.box(80, 0, 100, 20), 'square'), (15, pg_temp.box(60, -20, 100,
  20), 'roadway');
SELECT 'and told, as are overlaps, areas without ground, and those over streets',
  amiss() = '11 area that crosses itself, m2 200; 12 area over a street, m 20; 12 area without ground of its own, '
    'm2 100; 13 area over a street, m 30; 14 area over a street, m 20; 14 areas of one kind that overlap, m2 200';
SELECT 'the older of two of one kind has the ground that they share', ground(13) = 30 * 28 AND ground(14) = 10 * 14
  AND shared() < 0.01;
SELECT 'summary counts them', amount = 5 FROM streetgen.summary('town') WHERE subject = 'areas of the street';

-- Drawn, and in files.
SELECT 'pictures show them', count(*) FILTER (WHERE kind = 'square') = 3 FROM streetgen._footway_drawn('town',
  pg_temp.box(0, -50, 100, 50), '{area}');
SELECT 'files have a layer of them', source = 'area_surface' FROM streetgen._footway_layer() WHERE layer = 'areas';

-- A table of somebody else.
CREATE TABLE plan (id integer, what text, storey integer, shape geometry);
INSERT INTO plan VALUES (1, 'square', 0, ST_Force3D(pg_temp.shape('POLYGON((0 0,10 0,10 10,0 10,0 0))'))), (2,
  'platform', 1, pg_temp.shape('LINESTRING(0 0,10 0,10 10,0 0)')), (3, 'platform', NULL,
  pg_temp.shape('LINESTRING(0 0,10 0,10 10)')),
  (4, 'parking_area', 0, pg_temp.shape('MULTIPOLYGON(((0 20,20 40,20 20,0 40,0 20)))')), (5, 'square', 0,
  ST_Transform(pg_temp.box(0, 0, 10, 10), 4326)), (6, 'square', 0,
  pg_temp.shape('CURVEPOLYGON(CIRCULARSTRING(0 0,5 5,10 0,5 -5,0 0))'));
DO $$ BEGIN PERFORM streetgen.create_model('plain', 2154, subjects => '{}'); END $$;
CREATE TABLE told AS SELECT * FROM streetgen.import_areas('plain', 'plan',
  '{"geom": "shape", "kind": "what", "level": "storey", "source_ref": "id"}');
SELECT 'any table of areas is imported by a mapping, areas, closed lines and curves of any SRID',
  string_agg(format('%s%s%s %s', source_ref, kind, level, round(ST_Area(ST_MakeValid(geom)))), ', '
  ORDER BY source_ref) = '1square0 100, 2platform1 50, 4parking_area0 200, 5square0 100, 6square0 79'
  FROM plain.street_area;
SELECT 'and what is amiss is told', array_agg(concat_ws(' ', what, class, count, source_refs)
  ORDER BY what COLLATE "C", class) = '{"area that crosses itself, mended where it is used parking_area 1 '
    '{4}","area without a closed ring, left out platform 1 {3}","areas parking_area 1","areas platform 1","areas '
    'square 3"}' FROM told;
UPDATE plain.street_area SET kind = 'square' WHERE source_ref = '2';
UPDATE plan SET what = 'walk' WHERE id IN (1, 2);
DELETE FROM plan WHERE id = 5;
SELECT streetgen.import_areas('plain', 'plan',
  '{"geom": "shape", "kind": "what", "level": "storey", "source_ref": "id"}') \g /dev/null
SELECT 'again it is followed, and what is by hand stays', string_agg(source_ref || kind, ' '
  ORDER BY source_ref) = '1walk 2square 4parking_area 6square' FROM plain.street_area;
SELECT 'what both changed is in conflict', relation = 'street_area' AND column_name = 'kind' AND by_hand = 'square'
  AND source_new = 'walk' FROM plain.import_conflict;
UPDATE plain.street_area SET kind = 'walk' WHERE source_ref = '2';
SELECT 'until somebody settles it', NOT EXISTS (SELECT FROM plain.import_conflict);
SELECT 'bad rows are refused', test.state($$SELECT streetgen.import_areas('plain', 'plan',
  '{"geom": "shape", "kind": {"value": "garden"}, "source_ref": "id"}')$$) = '22023'
  AND test.state($$SELECT streetgen.import_areas('plain', 'plan', '{"geom": "shape", "kind": "what"}')$$) = '22023'
  AND test.state($$SELECT streetgen.import_areas('plain', 'plan',
  '{"geom": "shape", "kind": "what", "source_ref": {"value": "1"}}')$$) = '22023'
  AND test.state($$SELECT streetgen.import_areas('plain', 'plan',
  '{"geom": "shape", "kind": "what", "level": {"value": "99"}, "source_ref": "id"}')$$) = '22023'
  AND test.state($$SELECT streetgen.import_areas('plain', 'plan',
  '{"kind": "what", "source_ref": "id"}')$$) = '42703';
CREATE TABLE ring AS SELECT 'square' AS what, pg_temp.shape('MULTILINESTRING((0 0,9 0,9 9,0 0))') AS shape;
SELECT 'so are several lines as one area, with the row and a hint', state = '22023'
  AND said = 'source row square has a MULTILINESTRING as geom' AND hint LIKE '%or one line about it%'
  FROM test.refusal($$SELECT streetgen.import_areas('plain', 'ring', '{"geom": "shape", "kind": "what",
  "source_ref": "what"}')$$);

-- Of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer,
  geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2,
  pg_temp.shape('LINESTRING(0 0,200 0)'));
CREATE TABLE osm_area (way_id bigint, relation_id bigint, name text, tags jsonb, geom geometry(Geometry, 2154));
INSERT INTO osm_area SELECT n, NULL, 'nr ' || n, tags, ST_ExteriorRing(ST_GeometryN(pg_temp.box(10 * n, 0, 10 * n + 8,
  20), 1)) FROM unnest(ARRAY['{"highway": "pedestrian", "surface": "sett", "foot": "yes"}',
  '{"place": "square", "layer": "1"}', '{"amenity": "parking", "access": "private"}',
  '{"amenity": "parking", "parking": "underground"}', '{"amenity": "parking", "parking": "street_side"}',
  '{"railway": "platform"}', '{"public_transport": "platform", "highway": "platform"}',
  '{"area:highway": "footway", "footway": "sidewalk"}', '{"area:highway": "residential"}',
  '{"area:highway": "traffic_island"}',
  '{"highway": "pedestrian", "indoor": "yes"}', '{"highway": "pedestrian", "level": "-1"}', '{"highway": "steps"}',
  '{"area:highway": "cycleway"}', '{"highway": "footway"}',
  '{"area:highway": "pedestrian", "tunnel": "yes"}']::jsonb[]) WITH ORDINALITY u(tags, n);
INSERT INTO osm_area VALUES (NULL, 7, NULL, '{"highway": "pedestrian"}', ST_Difference(pg_temp.box(0, 50, 40, 90),
  pg_temp.box(10, 60, 20, 70))), (NULL, 8, NULL, '{"highway": "pedestrian"}', NULL);
DO $$ BEGIN PERFORM streetgen.create_model('mapped', 2154, subjects => '{footway}'); END $$;
TRUNCATE told;
INSERT INTO told SELECT * FROM streetgen.import_osm('mapped', 'osm');
SELECT 'what goes round an area is one of its kind', string_agg(format('%s:%s%s', source_ref, kind,
  CASE WHEN level <> 0 THEN level END), ' ' ORDER BY length(source_ref),
  source_ref) = '1:square 2:square1 3:parking_area 6:platform 7:platform 8:sidewalk 9:roadway 13:steps 14:cycle '
    '15:walk 16:square-1 relation/7:square' FROM mapped.street_area;
SELECT 'with its surface, its name, and who may walk there', name = 'nr 1' AND surface = 'sett' AND foot = 'yes'
  AND (SELECT foot = 'private' FROM mapped.street_area WHERE source_ref = '3') FROM mapped.street_area
  WHERE source_ref = '1';
SELECT 'what is left out is told', array_agg(concat_ws(' ', what, class, source_refs) ORDER BY what COLLATE "C",
  class) = '{"area of no kind that is known, left out traffic_island {10}","area within a building or on another '
    'floor, left out pedestrian {11,12}","area without a closed ring, left out square {relation/8}","bays of a '
    'street, left out as an area parking {5}","car park within a building, left out parking {4}"}' FROM told
  WHERE what LIKE '%left out%';
INSERT INTO osm_line SELECT way_id, 'pedestrian', NULL, NULL, '{"area": "yes"}'::jsonb, 5, geom FROM osm_area WHERE
    way_id = 1
  UNION ALL SELECT 99, 'pedestrian', NULL, NULL, '{"area": "yes"}'::jsonb, 5, geom FROM osm_area WHERE way_id = 1;
TRUNCATE told;
INSERT INTO told SELECT * FROM streetgen.import_osm('mapped', 'osm');
SELECT 'a line round an area that is taken is told once, with the areas',
  (SELECT source_refs = '{99}' FROM told WHERE what = 'area, and so no street')
  AND (SELECT source_refs = '{9}' FROM told WHERE what LIKE 'areas of which nothing is made%');
DELETE FROM osm_area WHERE way_id = 1;
SELECT streetgen.import_osm('mapped', 'osm') \g /dev/null
SELECT 'a source that comes again is followed', NOT EXISTS (SELECT FROM mapped.street_area WHERE source_ref = '1')
  AND (SELECT count(*) = 11 FROM mapped.street_area);

SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without the subject areas stay, and make nothing', to_regclass('town.area_surface') IS NULL
  AND (SELECT count(*) = 5 FROM town.street_area);
