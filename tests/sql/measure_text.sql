\set ECHO none
\ir shared/truths.sql
-- Lengths and speeds as people write them, from SQL and in each importer.  Each SELECT is one truth: (name, holds).
SELECT format('%s is %s m', said, metres) AS name, abs(streetgen._metres(said) - metres) < 1e-9 AS holds
  FROM (VALUES ('7', 7), ('3,5 m', 3.5), ('12''6"', 3.81), ('~6', 6), ('5-6', 5.5), ('350 cm', 3.5), ('6.5 metres', 6.5)) v(said, metres);
SELECT format('"%s" is no length', said), streetgen._metres(said) IS NULL FROM unnest('{"",abc,"1.234,5",30 mph,nan}'::text[]) said;
SELECT 'a length without a unit is in that of its column', streetgen._metres('100', 'ft') = 30.48 AND streetgen._metres('100 m', 'ft') = 100;
SELECT 'a unit that is none reads nothing', streetgen._metres('100', 'parsec') IS NULL AND streetgen._kmh('100', 'm') IS NULL;
SELECT format('%s is %s km/h', said, kmh), abs(streetgen._kmh(said) - kmh) < 1e-9
  FROM (VALUES ('50', 50), ('30 mph', 48.28032), ('20 knots', 37.04), ('walk', 7), ('30;50', 50), ('DE:zone30', 30), ('FR:urban', 50), ('GB:nsl_single', 96.56064)) v(said, kmh);
SELECT format('"%s" is no speed', said), streetgen._kmh(said) IS NULL FROM unnest('{"",none,signals,XX:urban,-30,50 @ (wet)}'::text[]) said;
SELECT 'widths of lanes are read each', streetgen._metres_by_lane('3,2 m|10 ft|') = '3.2|3.048|';
SELECT 'and none of a list with one that is no width: ' || list, streetgen._metres_by_lane(list) IS NULL FROM unnest('{3|wide,3|-2,3|100}'::text[]) list;
SELECT 'NULL is NULL', streetgen._metres(NULL) IS NULL AND streetgen._kmh(NULL) IS NULL AND streetgen._metres_by_lane(NULL) IS NULL;

SELECT streetgen.create_model('town', 32631) \g /dev/null
CREATE TABLE osm_line (way_id bigint, class text, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text, junction text, layer text, bridge text, tunnel text,
  maxspeed text, width_lanes text, geom geometry);
INSERT INTO osm_line (way_id, class, oneway, width, maxspeed, lanes, width_lanes, geom)
SELECT v.*, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631) FROM (VALUES
  (1::bigint, 'residential', 'yes', '7,5 m', 'RU:urban', '2', '3,5|12 ft'), (2, 'residential', NULL, '5-6', '20 knots', NULL, NULL),
  (3, 'residential', NULL, '-4', '-30', NULL, NULL), (4, 'residential', NULL, 'narrow', 'fast', NULL, NULL), (5, 'residential', NULL, '900', '900', NULL, NULL)) v(way_id, class, oneway, width, maxspeed, lanes, width_lanes);
CREATE TEMPORARY TABLE told AS SELECT * FROM streetgen.import_osm('town');
SELECT 'import_osm reads widths and speeds so', array_agg(ROW(width, round(speed::numeric, 2), lane_width_forward)::text ORDER BY source_ref) = '{"(7.5,60.00,3.5|3.658)","(5.5,37.04,)"}' FROM town.axis WHERE source_ref < '3';
SELECT 'and names the ways of others, which have none', (SELECT bool_and(width IS NULL AND speed IS NULL) FROM town.axis WHERE source_ref > '2')
   AND (SELECT array_agg(what || ' ' || source_refs::text ORDER BY what) = '{"speed not understood, taken as unknown {3,4,5}","width not understood, taken as unknown {3,4,5}"}' FROM told WHERE what LIKE '%not understood%');

-- Which tag of a way says its width and its speed.
CREATE TABLE tagged_line (way_id bigint, class text, name text, ref text, tags jsonb, geom geometry);
INSERT INTO tagged_line SELECT way_id, 'residential', NULL, NULL, tags::jsonb, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631) FROM (VALUES
  (1, '{"width": "14", "width:carriageway": "7", "est_width": "9"}'), (2, '{"est_width": "~4"}'), (3, '{"width": "wide", "est_width": "4 m"}'), (4, '{"maxwidth": "2", "width:effective": "3", "lane_width": "3"}'),
  (11, '{"maxspeed:forward": "70", "maxspeed:backward": "30"}'), (12, '{"maxspeed:lanes": "|50|30"}'), (13, '{"source:maxspeed": "DE:urban"}'), (14, '{"maxspeed:type": "GB:motorway"}'), (15, '{"zone:maxspeed": "DE:30"}'),
  (16, '{"maxspeed": "fast", "zone:maxspeed": "FR:30"}'), (17, '{"maxspeed": "20", "source:maxspeed": "XX:nowhere"}'), (18, '{"maxspeed": "none", "source:maxspeed": "sign"}'), (19, '{"source:maxspeed": "XX:urban"}'),
  (20, '{"maxspeed:advisory": "30"}'), (21, '{"maxspeed": "signals", "maxspeed:type": "DE:rural"}'), (22, '{"maxspeed:lanes": "none|none"}'),
  (31, '{"maxheight": "3.8"}'), (32, '{"maxheight": "13''6\""}'), (33, '{"maxheight": "default"}'), (34, '{"maxheight": "low"}'), (35, '{"maxheight": "380"}')) v(way_id, tags);
SELECT streetgen.create_model('village', 32631) \g /dev/null
CREATE TEMPORARY TABLE told_of_tags AS SELECT * FROM streetgen.import_osm('village', 'tagged');
SELECT 'width:carriageway goes before width, est_width comes last', jsonb_object_agg(source_ref, width) = '{"1": 7, "2": 4, "3": 4, "4": null}' FROM village.axis WHERE source_ref::integer < 10;
SELECT 'speeds of directions, lanes, zones and reasons are taken where maxspeed says none', jsonb_object_agg(source_ref, round(speed::numeric)) = '{"11": 70, "12": 50, "13": 50, "14": 113, "15": 30, "16": 30, "17": 20, "18": null, "19": null, "20": null, "21": 100, "22": null}'
  FROM village.axis WHERE source_ref::integer BETWEEN 11 AND 22;
SELECT 'maxheight is a height limit, in metres or feet', jsonb_object_agg(source_ref, round(height_limit::numeric, 3))
    = '{"31": 3.8, "32": 4.115, "33": null, "34": null, "35": null}' FROM village.axis WHERE source_ref::integer > 30;
SELECT 'tags that mean nothing are named, those behind a better one are not asked', array_agg(what || ' ' || source_refs::text ORDER BY what) = '{"height limit not understood, taken as unknown {34,35}","speed not understood, taken as unknown {16,19}","width not understood, taken as unknown {3}"}' FROM told_of_tags WHERE what LIKE '%not understood%';
