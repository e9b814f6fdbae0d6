\set ECHO none
\ir shared/truths.sql
-- OSM lines as osm2pgsql writes them, to axes.  Each SELECT is one truth: (name, holds).
DO $$ BEGIN
  PERFORM streetgen.create_model('import_osm', 32631);
END $$;
CREATE TABLE import_line (way_id bigint, class text NOT NULL, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text,
  junction text, layer text, bridge text, tunnel text, maxspeed text, area text, geom geometry(LineString, 32631));
INSERT INTO import_line (way_id, class, lanes, lanes_forward, lanes_backward, width, oneway, junction, layer, bridge, tunnel, maxspeed, geom)
SELECT v.*, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631) FROM (VALUES
  (1::bigint, 'residential', '2', NULL, NULL, '7 m', 'yes', NULL, NULL, NULL, NULL, '30 mph'),
  (2, 'residential', NULL, '2', '1', '23 ft', '-1', NULL, '2', 'yes', NULL, 'FR:urban'),
  (3, 'tertiary', 'many', NULL, NULL, 'wide', NULL, 'roundabout', NULL, NULL, NULL, 'signals'),
  (4, 'primary_link', NULL, NULL, NULL, '0', NULL, NULL, NULL, 'viaduct', NULL, '50'),
  (5, 'secondary', NULL, NULL, NULL, NULL, 'no', NULL, NULL, NULL, 'yes', NULL),
  (6, 'runway', '1', NULL, NULL, '60', NULL, NULL, NULL, NULL, NULL, NULL),
  (7, 'cycleway', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  (8, 'motorway', '2', NULL, NULL, '30', NULL, NULL, NULL, 'no', NULL, NULL)) AS v (way_id);
CREATE TABLE import_report AS SELECT * FROM streetgen.import_osm('import_osm', 'import');

SELECT 'metres and feet are widths' AS name,
       (SELECT width = 7 FROM import_osm.axis WHERE source_ref = '1') AND (SELECT abs(width - 7.0104) < 1e-9 FROM import_osm.axis WHERE source_ref = '2') AS holds;
SELECT 'miles per hour and urban limits are speeds',
       (SELECT abs(speed - 48.28032) < 1e-9 FROM import_osm.axis WHERE source_ref = '1') AND (SELECT speed = 50 FROM import_osm.axis WHERE source_ref = '2');
SELECT 'what is no number is unknown', (SELECT width IS NULL AND lane_count IS NULL AND speed IS NULL FROM import_osm.axis WHERE source_ref = '3');
SELECT 'lanes forward and backward add up', (SELECT lane_count = 3 FROM import_osm.axis WHERE source_ref = '2');
SELECT 'oneway gives the direction, roundabouts and motorways are direct',
       (SELECT string_agg(u.direction, ',' ORDER BY source_ref) = 'direct,reverse,direct,both,both,both,direct' FROM import_osm.axis_used u JOIN import_osm.axis a USING (axis_id));
SELECT 'a direction that only a roundabout implies is left to its tag', (SELECT (direction, roundabout_tag) = ('both', 'roundabout') FROM import_osm.axis WHERE source_ref = '3');
SELECT streetgen.set('import_osm', 'roundabout_tags', 'false') \gset
SELECT 'tags that do not count imply no direction', (SELECT u.direction = 'both' FROM import_osm.axis_used u JOIN import_osm.axis USING (axis_id) WHERE source_ref = '3');
SELECT streetgen.set('import_osm', 'roundabout_tags', 'true') \gset
SELECT 'layer is the level; without it bridges are above and tunnels below',
       (SELECT string_agg(level::text, ',' ORDER BY source_ref) = '0,2,0,1,-1,0,0' FROM import_osm.axis);
SELECT 'a width of zero is unknown and named', (SELECT source_refs = '{4}' FROM import_report WHERE what LIKE 'width of zero%');
SELECT 'a width beyond the lanes is named, a runway''s is believed', (SELECT source_refs = '{8}' FROM import_report WHERE what = 'width not believed');
SELECT 'a cycleway makes no axis', (SELECT count = 1 FROM import_report WHERE what = 'taken as footway' AND class = 'cycleway') AND (SELECT count(*) = 1 FROM import_osm.footway);
SELECT 'the taken ways are axes', (SELECT count(*) = 7 FROM import_osm.axis);
-- Lanes, one by one.
ALTER TABLE import_line ADD turn_lanes text, ADD turn_lanes_forward text, ADD turn_lanes_backward text, ADD width_lanes text, ADD bus_lanes text, ADD lanes_bus text, ADD busway text,
  ADD cycleway text, ADD cycleway_left text, ADD cycleway_right text, ADD cycleway_left_oneway text, ADD parking_right text, ADD parking_lane_both text;
INSERT INTO import_line (way_id, class, geom, oneway, lanes, lanes_forward, turn_lanes, turn_lanes_forward, turn_lanes_backward, width_lanes, bus_lanes, lanes_bus, busway, cycleway, cycleway_left, cycleway_right,
    cycleway_left_oneway, parking_right, parking_lane_both)
SELECT way_id, 'primary', ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631), oneway, lanes, lanes_forward, turn, turn_forward, turn_backward, widths, buses, bus, busway, cycleway, cycle_left, cycle_right, left_oneway, parking, parking_both
FROM (VALUES
  (20::bigint, 'yes', '3', NULL, 'left|through;Right | none', NULL, NULL, '3.5|3 m|', NULL, NULL, NULL, NULL, NULL, 'lane', NULL, NULL, NULL),
  (21, '-1', '2', NULL, 'left|', NULL, NULL, NULL, 'yes|designated', NULL, NULL, 'lane', NULL, NULL, NULL, NULL, NULL),
  (22, NULL, '3', '2', NULL, 'left|through', 'through;right', NULL, NULL, NULL, NULL, 'lane', NULL, NULL, NULL, 'lane', NULL),
  (23, NULL, NULL, NULL, 'left|right', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  (24, 'yes', '2', NULL, 'left|next_lane', NULL, NULL, 'wide|3', NULL, '1', NULL, NULL, 'lane', NULL, '-1', NULL, NULL),
  (25, 'yes', '1', NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'opposite_lane', 'opposite_lane', NULL, NULL, NULL, NULL, 'parallel'),
  (26, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'lane', 'track', NULL, NULL, NULL, NULL, NULL)
) v(way_id, oneway, lanes, lanes_forward, turn, turn_forward, turn_backward, widths, buses, bus, busway, cycleway, cycle_left, cycle_right, left_oneway, parking, parking_both);
DELETE FROM import_report;
INSERT INTO import_report SELECT * FROM streetgen.import_osm('import_osm', 'import');
SELECT 'turns, widths and a cycle lane of a one-way street',
       (SELECT (lanes_forward, lanes_backward, turn_forward, lane_width_forward, kind_forward, kind_backward) IS NOT DISTINCT FROM (3, NULL::integer, 'left|through;right|none', '3.5|3|', 'general|general|general|cycle', NULL::text) FROM import_osm.axis WHERE source_ref = '20');
SELECT 'the same against the line', (SELECT (direction, lanes_backward, turn_backward, kind_backward, kind_forward) IS NOT DISTINCT FROM ('reverse', 2, 'left|', 'general|bus|cycle', NULL::text) FROM import_osm.axis WHERE source_ref = '21');
SELECT 'both directions of a two-way street',
       (SELECT (lanes_forward, lanes_backward, turn_forward, turn_backward, kind_forward, kind_backward) = (2, 1, 'left|through', 'through;right', 'general|general|cycle|parking', 'general|cycle') FROM import_osm.axis WHERE source_ref = '22');
SELECT 'turn:lanes of a two-way street is of no direction: left out and named', (SELECT turn_forward IS NULL AND turn_backward IS NULL FROM import_osm.axis WHERE source_ref = '23')
    AND (SELECT source_refs = '{23,24}' FROM import_report WHERE what LIKE 'lanes not understood%' AND class = 'turn:lanes');
SELECT 'words of lists that mean nothing are unknown and named, what is known stays', (SELECT (turn_forward, lane_width_forward, kind_forward, kind_backward) = ('left|', '|3', 'general|bus', 'cycle') FROM import_osm.axis WHERE source_ref = '24')
    AND (SELECT source_refs = '{24}' FROM import_report WHERE what LIKE 'lanes not understood%' AND class = 'width:lanes');
SELECT 'bus and cycle lanes against a one-way street, parking along both kerbs', (SELECT (kind_forward, kind_backward) = ('general|parking', 'bus|cycle|parking') FROM import_osm.axis WHERE source_ref = '25');
SELECT 'a bus lane each way beside the usual lane', (SELECT (kind_forward, kind_backward) = ('general|bus', 'general|bus') FROM import_osm.axis WHERE source_ref = '26');
SELECT 'importing again changes nothing', (SELECT count = 0 FROM streetgen.import_osm('import_osm', 'import') WHERE what = 'new or changed');
ALTER TABLE import_line ALTER class TYPE varchar(40), ALTER name TYPE varchar(80), ALTER lanes TYPE varchar(10), ALTER oneway TYPE varchar(10), ALTER width TYPE varchar(10);
SELECT 'nor where classes and names are varchar', (SELECT sum(count) FILTER (WHERE what = 'new or changed') = 0 AND count(*) FILTER (WHERE what = 'taken') > 1 FROM streetgen.import_osm('import_osm', 'import'));
SELECT 'their lanes are generated without an error', (SELECT bool_and(deleted = 0) FROM streetgen.generate('import_osm')) AND NOT EXISTS (SELECT FROM streetgen.check_model('import_osm') WHERE severity = 'error');
SELECT 'no list goes astray', NOT EXISTS (SELECT FROM streetgen.check_model('import_osm') WHERE rule LIKE '%not those of all lanes%');
-- Lanes for both directions, in the middle; one lane in all.
DO $$ BEGIN
  PERFORM streetgen.create_model('import_' || side, 32631), streetgen.set('import_' || side, 'driving_side', side) FROM unnest(ARRAY['right', 'left']) side;
END $$;
CREATE TABLE centre_line (LIKE import_line);
ALTER TABLE centre_line ADD lanes_both_ways text, ADD lanes_reversible text, ADD width_lanes_forward text, ADD bus_lanes_forward text, ADD ref text;
INSERT INTO centre_line (way_id, class, geom, oneway, lanes, lanes_forward, lanes_backward, lanes_both_ways, turn_lanes_forward, width_lanes_forward, bus_lanes_forward)
SELECT way_id, 'primary', ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631), oneway, lanes, forward, backward, both_ways, turns, widths, buses FROM (VALUES
  (1::bigint, NULL, '5', '2', '2', '1', 'through|right', '3|3.5', '|designated'), (2, NULL, '3', NULL, NULL, '1', NULL, NULL, NULL), (3, NULL, NULL, '1', '1', '1', NULL, NULL, NULL),
  (4, NULL, '4', '1', NULL, '1', NULL, NULL, NULL), (5, NULL, '4', NULL, '1', '1', NULL, NULL, NULL), (6, 'yes', '2', NULL, NULL, '1', NULL, NULL, NULL),
  (7, NULL, NULL, NULL, NULL, '1', NULL, NULL, NULL), (8, NULL, '2', NULL, NULL, '0', NULL, NULL, NULL), (9, NULL, NULL, '30', '1', '1', NULL, NULL, NULL),
  (10, NULL, '4', NULL, NULL, NULL, NULL, NULL, NULL), (11, NULL, '1', NULL, NULL, NULL, NULL, NULL, NULL), (12, NULL, '1', NULL, NULL, NULL, NULL, NULL, NULL), (13, NULL, '1', NULL, NULL, NULL, NULL, NULL, NULL),
  (14, NULL, '1', NULL, NULL, '1', NULL, NULL, NULL))
  v(way_id, oneway, lanes, forward, backward, both_ways, turns, widths, buses);
UPDATE centre_line SET lanes_reversible = '2' WHERE way_id = 10;
UPDATE centre_line SET cycleway = 'lane', parking_right = 'lane' WHERE way_id = 12;
UPDATE centre_line SET busway = 'lane' WHERE way_id = 13;
UPDATE centre_line SET ref = 'D 906;E 5' WHERE way_id = 14;
CREATE TABLE centre_report AS SELECT * FROM streetgen.import_osm('import_right', 'centre');
SELECT streetgen.import_osm('import_left', 'centre') \g /dev/null
SELECT 'the number of a route', array_agg(ref) FILTER (WHERE source_ref = '14') = '{D 906;E 5}' AND count(ref) = 1 FROM import_right.axis;
SELECT format('way %s: %s lanes, %s forward, %s backward, %s for both directions', source_ref, forward + backward + both_ways, forward, backward, both_ways),
       (u.lane_count, u.lanes_forward, u.lanes_backward, u.lanes_both) = (forward + backward + both_ways, forward, backward, both_ways)
  FROM (VALUES ('1', 2, 2, 1), ('2', 1, 1, 1), ('3', 1, 1, 1), ('4', 1, 2, 1), ('5', 2, 1, 1), ('6', 2, 0, 0), ('7', 1, 1, 1), ('8', 1, 1, 0), ('10', 1, 1, 2), ('11', 0, 0, 1), ('12', 0, 0, 1), ('13', 2, 2, 0), ('14', 0, 0, 1))
    v(source_ref, forward, backward, both_ways) JOIN import_right.axis a USING (source_ref) JOIN import_right.axis_used u USING (axis_id);
SELECT 'lists speak of the lanes of their direction alone', (turn_forward, lane_width_forward, kind_forward) = ('through|right', '3|3.5', 'general|bus') FROM import_right.axis WHERE source_ref = '1';
SELECT 'on either side of the road', (turn_forward, lane_width_forward, kind_forward) = ('through|right', '3|3.5', 'general|bus') FROM import_left.axis WHERE source_ref = '1';
SELECT 'cycle and parking lanes lie beside the lane of both', (kind_forward, kind_backward) = ('cycle|parking', 'cycle') FROM import_right.axis WHERE source_ref = '12';
SELECT 'buses with a lane of their own leave one each way', (kind_forward, kind_backward) = ('general|bus', 'general|bus') FROM import_right.axis WHERE source_ref = '13';
SELECT 'where it cannot be counted it is named', array_agg(DISTINCT source_ref ORDER BY source_ref) = '{13,6,9}' FROM import_right.unread_tag;
SELECT 'the estimated width is that of one lane', u.width = 3.5 FROM import_right.axis_used u JOIN import_right.axis USING (axis_id) WHERE source_ref = '11';
-- The flex file writes all tags of a way into one column; tables of older ones have a column for each.
CREATE TABLE tagged_line AS SELECT way_id, class, name, ref, geom, jsonb_strip_nulls(jsonb_build_object('oneway', oneway, 'lanes', lanes, 'lanes:forward', lanes_forward, 'lanes:backward', lanes_backward,
  'lanes:both_ways', lanes_both_ways, 'lanes:reversible', lanes_reversible, 'turn:lanes:forward', turn_lanes_forward, 'width:lanes:forward', width_lanes_forward, 'bus:lanes:forward', bus_lanes_forward,
  'cycleway', cycleway, 'parking:right', parking_right, 'busway', busway)) AS tags FROM centre_line;
SELECT streetgen.create_model('import_tagged', 32631) \gset
SELECT streetgen.import_osm('import_tagged', 'tagged') \g /dev/null
SELECT 'tags in one column mean what they mean in columns', count(*) = 14 AND bool_and((to_jsonb(t) - 'axis_id' - 'source') = (to_jsonb(c) - 'axis_id' - 'source'))
  FROM import_tagged.axis t JOIN import_right.axis c USING (source_ref);
-- The tables of the last flex file with columns have all of them.
SELECT format('CREATE TABLE wide_line (way_id bigint, class text, name text, ref text, %s, geom geometry(LineString, 32631))', string_agg(format('%I text', replace(tag, ':', '_')), ', ')) FROM unnest(streetgen._osm_column_tags()) tag \gexec
INSERT INTO wide_line (way_id, class, change_lanes, lanes, oneway, geom) VALUES (1, 'primary', 'yes|no', 2, 'yes', 'SRID=32631;LINESTRING(0 0, 100 0)');
SELECT streetgen.create_model('import_wide', 32631) \gset
SELECT streetgen.import_osm('import_wide', 'wide') \g /dev/null
SELECT 'a column of each tag is read', (lane_count, change_forward) = (2, 'yes|no') FROM import_wide.axis;
-- Levels, and ways of which the file lacks nodes.
CREATE TABLE way_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 32631));
INSERT INTO way_line SELECT n, 'residential', NULL, NULL, tags::jsonb, 2, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * n), ST_MakePoint(90, 100 * n)), 32631) FROM unnest(ARRAY['{"bridge": "yes"}', '{"bridge": "yes", "layer": "0"}', '{"bridge": "viaduct", "layer": "2"}', '{"bridge": "yes", "layer": "-1"}',
  '{"tunnel": "yes"}', '{"tunnel": "yes", "layer": "0"}', '{"tunnel": "yes", "layer": "-2"}', '{"tunnel": "yes", "layer": "1"}', '{"tunnel": "building_passage"}', '{"bridge": "no", "tunnel": "no"}', '{"layer": "-1"}', '{"bridge": "yes", "layer": "up"}', '{}']) WITH ORDINALITY t(tags, n);
SELECT streetgen.create_model('import_way', 32631) \gset
CREATE TABLE way_told AS SELECT * FROM streetgen.import_osm('import_way', 'way');
SELECT 'a bridge is above and a tunnel below, unless the layer says how far', array_agg(level ORDER BY source_ref::integer) = '{1,1,2,-1,-1,-1,-2,1,0,0,-1,1,0}' FROM import_way.axis;
SELECT 'where they contradict each other the layer stands, and it is told', array_agg(source_refs) = '{{4,8}}' FROM way_told WHERE what LIKE 'bridge on a layer below 0%';
SELECT 'no way lacks a node', NOT EXISTS (SELECT FROM way_told WHERE what LIKE 'fewer vertices%');
UPDATE way_line SET nodes = 5 WHERE way_id = 1;
UPDATE way_line SET nodes = 3, geom = NULL WHERE way_id IN (2, 3);
DELETE FROM way_line WHERE way_id = 13;
INSERT INTO way_line VALUES (14, 'residential', NULL, NULL, '{}', 2, NULL);
UPDATE import_way.axis SET name = 'by hand' WHERE source_ref = '3';
CREATE TABLE way_axis AS SELECT source_ref, name, geom FROM import_way.axis;
TRUNCATE way_told;
INSERT INTO way_told SELECT * FROM streetgen.import_osm('import_way', 'way');
SELECT 'a way that lacks nodes is told', (SELECT source_refs = '{1}' FROM way_told WHERE what LIKE 'fewer vertices%') AND (SELECT source_refs = '{14,2,3}' FROM way_told WHERE what = 'row without geometry, left out');
SELECT 'one that lost all but one of its nodes stays, and is told', (SELECT source_refs = '{2,3}' FROM way_told WHERE what = 'came without geometry, stays as it was') AND (SELECT count(*) = 2 FROM way_axis JOIN import_way.axis a USING (source_ref) WHERE source_ref IN ('2', '3') AND a.geom = way_axis.geom AND a.name IS NOT DISTINCT FROM way_axis.name);
SELECT 'one that is not in the file has vanished', (SELECT source_refs = '{13}' FROM way_told WHERE what LIKE 'vanished%') AND (SELECT count(*) = 12 FROM import_way.axis);
-- Misspelt tags of what is no street yet, as the flex file finds them.
CREATE TABLE way_misspelt (node_id bigint, way_id bigint, relation_id bigint, tag text NOT NULL, value text NOT NULL, meant text NOT NULL);
INSERT INTO way_misspelt VALUES (NULL, NULL, 7, 'route', 'buss', 'bus'), (NULL, 8, NULL, 'Highway', 'residential', 'highway'), (5, NULL, NULL, 'crosing', 'traffic_signals', 'crossing'), (6, NULL, NULL, 'crosing', 'traffic_signals', 'crossing');
TRUNCATE way_told;
INSERT INTO way_told SELECT * FROM streetgen.import_osm('import_way', 'way');
SELECT 'a misspelt tag is told with all objects that have it', string_agg(concat(class, ' ', count, source_refs), ', ' ORDER BY class COLLATE "C") = 'Highway=residential 1{"way 8"}, crosing=traffic_signals 2{"node 5","node 6"}, route=buss 1{"relation 7"}'
  FROM way_told WHERE what = 'tag misspelt, all in table unread_tag';
SELECT 'and stands with what is meant', string_agg(concat_ws(' ', source_ref, tag, value, reason), ', ' ORDER BY source_ref) = 'node 5 crosing traffic_signals it is not known; crossing is, node 6 crosing traffic_signals it is not known; crossing is, '
  'relation 7 route buss it is not known; bus is, way 8 Highway residential it is not known; highway is' FROM import_way.unread_tag WHERE source = 'way_misspelt';
DELETE FROM way_misspelt;
SELECT 'what the source mends is told no more', NOT EXISTS (SELECT FROM streetgen.import_osm('import_way', 'way') WHERE what LIKE 'tag misspelt%');
SELECT 'and stands no more', NOT EXISTS (SELECT FROM import_way.unread_tag WHERE source = 'way_misspelt');
