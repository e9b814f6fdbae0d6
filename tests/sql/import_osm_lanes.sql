\set ECHO none
\ir shared/truths.sql
-- Lanes that tags of OpenStreetMap state, as axes have them.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 32631), streetgen.create_model('left_hand', 32631, driving_side => 'left') \g /dev/null
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, geom geometry(LineString, 32631));
INSERT INTO osm_line (way_id, class, tags, geom)
SELECT n, class, tags::jsonb, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * n), ST_MakePoint(120, 100 * n)), 32631) FROM (VALUES
  (1, 'secondary', '{"oneway": "yes", "oneway:bus": "no", "lanes": "3", "lanes:forward": "2", "lanes:backward": "1", "bus:lanes:backward": "yes", "vehicle:lanes:forward": "no|yes"}'),
  (2, 'unclassified', '{"motor_vehicle": "no", "psv": "yes", "lanes": "2"}'),
  (3, 'secondary', '{"oneway": "yes", "lanes": "3", "turn:lanes": "left|through|through|right", "vehicle:lanes": "yes|yes|no|yes", "bicycle:lanes": "yes|no|designated|yes", "width:lanes": "3|3|1.5|3,5 m"}'),
  (4, 'tertiary', '{"lanes": "2", "cycleway": "lane", "bicycle:lanes:forward": "yes|designated", "vehicle:lanes:forward": "yes|no", "bicycle:lanes:backward": "yes|designated", "vehicle:lanes:backward": "yes|no"}'),
  (5, 'residential', '{"oneway": "yes", "oneway:bicycle": "no", "cycleway": "opposite_lane"}'),
  (6, 'residential', '{"oneway": "yes", "oneway:bicycle": "no", "cycleway": "opposite"}'),
  (7, 'secondary', '{"oneway": "-1", "lanes": "3", "turn:lanes": "left|through|right", "cycleway:left": "lane", "placement": "right_of:1"}'),
  (8, 'secondary', '{"oneway": "yes", "lanes": "3", "turn:lanes": "left|through|right", "cycleway:right": "lane", "placement": "right_of:1"}'),
  (9, 'secondary', '{}'), (10, 'primary', '{}'), (11, 'trunk', '{}'), (12, 'secondary', '{"width": "14"}'),
  (13, 'trunk', '{"oneway": "yes", "cycleway:right": "lane"}'), (14, 'trunk', '{"oneway": "yes"}'),
  (15, 'secondary', '{"lanes": "2", "cycleway:right": "lane", "cycleway:right:oneway": "no"}'),
  (16, 'secondary', '{"oneway": "reversible", "lanes": "2"}'), (17, 'secondary', '{"lanes": "1", "oneway": "alternating"}'),
  (18, 'secondary', '{"oneway": "yes", "lanes": "3", "busway:left": "lane", "turn:lanes": "left|through|through"}'),
  (19, 'secondary', '{"lanes": "2", "parking:lanes:forward": "|designated"}'),
  (20, 'secondary', '{"lanes": "3"}'), (21, 'footway', '{"lanes": "many"}'),
  (22, 'secondary', '{"oneway": "yes", "lanes": "2", "cycleway:right": "lane", "cycleway:right:width": "2.25"}'),
  (23, 'secondary', '{"width": "14", "cycleway:right": "lane"}'), (24, 'secondary', NULL), (25, NULL, '{"lanes": "2"}'), (26, 'secondary', '{"lanes": null, "oneway": "yes"}'), (27, 'secondary', '[1]'),
  (28, 'secondary', '{"oneway": "yes", "lanes": "2", "parking:both": "lane", "width": "13.5"}'), (29, 'busway', '{"lanes": "1"}'),
  (40, 'secondary', '{"oneway": "yes", "width": "4.9"}'), (41, 'secondary', '{"oneway": "-1", "width": "6", "cycleway:right": "lane"}'),
  (42, 'secondary', '{"oneway": "yes", "width": "7", "busway": "lane"}'), (43, 'residential', '{"junction": "roundabout", "lanes": "1", "width": "7"}'),
  (44, 'residential', '{"width": "7", "parking:both": "lane"}'), (45, 'residential', '{"width": "5", "parking:right": "lane"}'), (46, 'residential', '{"width": "6", "cycleway": "lane"}'), (47, 'residential', '{"width": "6", "parking:left": "lane"}'),
  (50, 'residential', '{"width": "10", "parking:both": "lane", "parking:both:orientation": "perpendicular"}'), (51, 'residential', '{"width": "13", "parking:both": "lane", "parking:both:orientation": "perpendicular"}'),
  (52, 'residential', '{"width": "5", "lanes": "2", "parking:both": "lane"}'), (53, 'residential', '{"width": "3", "oneway": "yes", "cycleway": "lane"}'), (54, 'residential', '{"width": "8", "lanes": "2", "parking:both": "lane"}'),
  (60, 'residential', '{"lanes": "2", "width": "5", "cycleway:right": "lane", "cycleway:right:width": "1.75"}'), (61, 'residential', '{"lanes": "2", "width": "5", "cycleway:right": "lane"}'),
  (62, 'residential', '{"lanes": "2", "parking:lane:both": "parallel", "parking:lane:both:parallel": "half_on_kerb"}'), (63, 'service', '{"access": "private", "psv": "yes", "busway": "lane"}'),
  (64, 'motorway_link', '{"lanes": "2", "lanes:backward": "1"}'), (65, 'primary', '{"oneway": "yes", "lanes": "2", "width": "8", "access:lanes": "private|yes", "turn:lanes": "|through"}'), (66, 'motorway', '{"oneway": "reversible", "lanes": "2", "hov": "designated"}')) v(n, class, tags);
CREATE TABLE report AS SELECT * FROM streetgen.import_osm('town', 'osm');
SELECT streetgen.import_osm('left_hand', 'osm') \g /dev/null
CREATE VIEW seen AS SELECT a.source_ref::integer AS way, concat_ws(' / ', coalesce(a.kind_forward, '-'), coalesce(a.kind_backward, '-')) AS kinds, u.lanes_forward AS forward, u.lanes_backward AS backward,
  u.lanes_both AS both_ways, u.width AS across, a.* FROM town.axis a JOIN town.axis_used u USING (axis_id);
SELECT format('way %s: %s', way, v.kinds), s.kinds = v.kinds FROM seen s JOIN (VALUES (1, 'bus|general / bus'), (2, 'bus / bus'), (3, 'general|general|cycle|general / -'), (4, 'general|cycle / general|cycle'), (5, '- / cycle'),
  (6, '- / -'), (7, '- / general|general|general|cycle'), (8, 'general|general|general|cycle / -'), (13, 'general|general|cycle / -'), (14, '- / -'), (15, 'general|cycle / -'), (18, 'bus|general|general / -'),
  (19, '- / -'), (62, '- / -'), (63, '- / -'), (64, '- / -'), (65, 'closed|general / -')) v(way, kinds) USING (way) ORDER BY way;
SELECT 'one lane for both directions lies where lanes of the kerbs leave no room for two: way ' || way, (forward, backward, both_ways, s.kinds) = (0, 0, 1, v.kinds) FROM seen s JOIN (VALUES (44, 'parking / parking'), (45, 'parking / -'), (46, 'cycle / cycle'), (47, '- / parking')) v(way, kinds) USING (way) ORDER BY way;
SELECT 'parking across the street leaves its lanes what is there', array_agg(round(across::numeric, 2) ORDER BY way) = '{10,13}' AND bool_and((forward, backward, both_ways) = (0, 0, 1)) FROM seen WHERE way IN (50, 51);
SELECT 'streets of which the kerbs leave no room for the other lanes are told', source_refs = '{52,53,60,61}' AND count = 4 FROM report WHERE what = 'parking, cycle or closed lanes leave less than 2 m for each other lane';
SELECT 'lists speak of lanes one by one', (turn_forward, lane_width_forward) = ('left|through|through|right', '3|3|1.5|3.5') FROM seen WHERE way = 3;
SELECT 'a width of the cycle lane alone', lane_width_forward = '||2.25' FROM seen WHERE way = 22;
SELECT 'a lane for cycling against the traffic leaves lanes of cars no narrower than they are', (forward, backward) = (1, 0) AND across - 1.5 BETWEEN 2.4 AND 4.5 FROM seen WHERE way = 5;
SELECT 'cycling without a lane adds none', (forward, backward) = (1, 0) AND across BETWEEN 2.4 AND 4.5 FROM seen WHERE way = 6;
SELECT 'lanes of unknown number have room beside those of the kerbs: way ' || way, s.kinds = v.kinds AND forward + backward = 1 + (way = 42)::integer
  FROM seen s JOIN (VALUES (40, '- / -'), (41, '- / cycle|general'), (42, 'general|bus / -')) v(way, kinds) USING (way) ORDER BY way;
SELECT 'the lane of a roundabout may be wide', across = 7 AND forward + backward = 1 FROM seen WHERE way = 43;
SELECT 'drawn the other way round, the same lanes lie on the same ground', (f.turn_forward, f.kind_forward, f.roadway_offset) = (b.turn_backward, b.kind_backward, -b.roadway_offset) FROM seen f, seen b WHERE f.way = 8 AND b.way = 7;
SELECT 'two-way streets of unknown lanes have as many each way: way ' || way, forward = backward AND forward = CASE way WHEN 12 THEN 2 ELSE 1 END FROM seen WHERE way BETWEEN 9 AND 12 ORDER BY way;
SELECT 'their lanes are 2.4 to 4.5 m wide', bool_and(across / (forward + backward) BETWEEN 2.4 AND 4.5) FROM seen WHERE way BETWEEN 9 AND 12;
SELECT 'a cycle lane leaves the usual lanes of cars', (SELECT forward FROM seen WHERE way = 13) = (SELECT forward FROM seen WHERE way = 14);
SELECT 'beside a cycle lane too, whichever side it lies on', (forward, backward, kinds) = (2, 2, 'general|general|cycle / general|general') FROM seen WHERE way = 23;
SELECT 'rows without tags or with NULL in them become streets like others', array_agg(way ORDER BY way) = '{24,25,26,27}' FROM seen WHERE way BETWEEN 24 AND 27;
SELECT 'a width of a source is believed beside the lanes of the kerbs', across = 13.5 FROM seen WHERE way = 28;
SELECT 'an odd lane of no direction lies in the middle', (forward, backward, both_ways) = (1, 1, 1) FROM seen WHERE way = 20;
SELECT 'all lanes of a reversible street are for both directions', bool_and(forward = 0 AND backward = 0 AND both_ways > 0) FROM seen WHERE way IN (16, 17);
SELECT 'what was not made is named', array_agg(source_ref || ' ' || tag ORDER BY source_ref) = '{"15 cycleway:right","19 parking:lanes:forward","20 lanes","50 width","65 access:lanes"}' FROM town.unread_tag WHERE source = 'osm_line';
SELECT 'with what it says, and why', bool_and(value = 'lane' AND reason LIKE 'a cycle lane at this kerb%') FROM town.unread_tag WHERE source_ref = '15';
SELECT 'and told', array_agg(class || ' ' || source_refs[1] ORDER BY class) = '{"access:lanes 65","cycleway:right 15","lanes 20","parking:lanes:forward 19","width 50"}' FROM report WHERE what LIKE 'lanes not understood%';
UPDATE osm_line SET tags = tags - 'parking:lanes:forward' WHERE way_id = 19;
SELECT 'what the next delivery mends is named no more', count(*) FILTER (WHERE what LIKE 'lanes not understood%') = 4 AND sum(count) FILTER (WHERE what = 'new or changed') = 0 FROM streetgen.import_osm('town', 'osm');
SELECT 'where one drives on the left, the near kerb is the left one', string_agg(kind_forward, ' ' ORDER BY source_ref) = 'general|general|cycle cycle|general|general' FROM (SELECT '1' AS source_ref, kind_forward FROM left_hand.axis WHERE source_ref = '22'
  UNION ALL SELECT '2', cycle FROM streetgen._osm_lanes('{oneway,lanes,cycleway}', '{yes,2,lane}', 'left', 3.5, 1.5, 2, 0, 1, 4.5, 2.625, 4.5, 5) l, LATERAL (SELECT l.kind_forward) k(cycle)) s;
SELECT 'the streets are sound', bool_and(deleted = 0) FROM streetgen.generate('town');
SELECT 'the one lane of a busway is for buses', array_agg(l.kind) = '{bus}' FROM town.lane l JOIN town.edge USING (edge_id) JOIN seen USING (axis_id) WHERE way = 29;
SELECT 'a stated width of a cycle lane holds where the roadway is short, and what is short is shared by others: way ' || way, array_agg(round(l.width::numeric, 3) ORDER BY l.lane_position) = widths
  FROM (VALUES (60, '{1.625,1.625,1.750}'::numeric[]), (61, '{1.818,1.818,1.364}')) v(way, widths) JOIN seen USING (way) JOIN town.edge USING (axis_id) JOIN town.lane l USING (edge_id) GROUP BY way, widths ORDER BY way;
SELECT 'a link with lanes both ways is driven both ways', (direction, forward, backward) = ('both', 1, 1) FROM seen WHERE way = 64;
SELECT 'a lane that is private is closed, and as wide as the other', array_agg(l.kind || round(l.width::numeric, 2) ORDER BY l.lane_position) = '{closed4.00,general4.00}' FROM town.lane l JOIN town.edge USING (edge_id) JOIN seen USING (axis_id) WHERE way = 65;
SELECT 'lanes for both directions are those of carpools', array_agg(l.kind) = '{carpool,carpool}' FROM town.lane l JOIN town.edge USING (edge_id) JOIN seen USING (axis_id) WHERE way = 66;
SELECT 'no list goes astray', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error' OR rule LIKE '%not those of all lanes%');
SELECT 'every tag that is read has a word on what becomes of it', count(*) > 40 AND bool_and(becomes <> '') AND count(DISTINCT (source, tag)) = count(*) FROM streetgen.tag_use();
-- Streets for buses alone are as wide as others, however tags say it.
CREATE TABLE bus_line (LIKE osm_line);
INSERT INTO bus_line (way_id, class, tags, geom)
SELECT n, class, tags::jsonb, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * n), ST_MakePoint(120, 100 * n)), 32631) FROM (VALUES
  (1, 'residential', '{"access": "no", "bus": "yes"}'), (2, 'residential', '{"motor_vehicle": "no", "psv": "designated"}'), (3, 'residential', '{"access": "private", "bus": "yes", "busway": "lane"}'), (4, 'residential', '{"access": "no", "taxi": "yes"}'), (5, 'residential', '{}'),
  (11, 'residential', '{"access": "no", "bus": "yes", "lanes": "2"}'), (12, 'residential', '{"access": "no", "bus:lanes": "designated|designated", "lanes": "2"}'), (13, 'residential', '{"motor_vehicle": "no", "lanes:psv": "2", "lanes": "2"}'),
  (14, 'residential', '{"motor_vehicle": "no", "psv:lanes": "designated|designated", "oneway": "yes"}'), (15, 'residential', '{"lanes": "2"}'), (21, 'busway', '{"oneway": "yes"}'), (22, 'busway', '{"oneway": "-1", "lanes": "1"}'), (23, 'residential', '{"motor_vehicle": "no", "bus": "yes", "oneway": "yes", "lanes": "1"}')) v(n, class, tags);
SELECT streetgen.create_model('buses', 32631) \g /dev/null
CREATE TABLE bus_report AS SELECT * FROM streetgen.import_osm('buses', 'bus');
SELECT FROM streetgen.generate('buses') \g /dev/null
CREATE VIEW bus_street AS SELECT source_ref::integer AS way, e.width, count(*) AS lanes, string_agg(DISTINCT l.kind, ' ') AS kinds FROM buses.axis JOIN buses.edge e USING (axis_id) JOIN buses.lane l USING (edge_id) GROUP BY source_ref, e.width;
SELECT 'streets for buses alone have lanes of buses: way ' || way, kinds = CASE WHEN way IN (5, 15) THEN 'general' ELSE 'bus' END FROM bus_street ORDER BY way;
SELECT 'and are as wide as the same street for all: way ' || b.way, (b.width, b.lanes) = (s.width, s.lanes) FROM bus_street b JOIN bus_street s ON s.way = b.way / 10 * 10 + 5 WHERE b.way < 20 ORDER BY b.way;
SELECT 'one way they have one lane, stated or not: way ' || way, (width, lanes) = (3.5, 1) FROM bus_street WHERE way > 20 ORDER BY way;
SELECT 'column access says so too', count(*) = 11 AND bool_and(access = 'bus') FROM buses.axis WHERE source_ref NOT IN ('5', '15');
SELECT 'nothing of them is told as not understood', NOT EXISTS (SELECT FROM buses.unread_tag);
-- Closed lanes count in every sum of what lies beside the lanes of cars.
SELECT 'widths of lanes that no motor traffic has', streetgen._kerbside_width(kinds, widths, 3.5, 1.5, 2) = sum FROM (VALUES ('closed|general', NULL, 3.5), ('closed|general|cycle', '2.5||', 4.0), ('closed|general', '3', 3.5), ('parking|general|cycle', NULL, 3.5), ('general', NULL, 0), (NULL, NULL, 0)) v(kinds, widths, sum);
INSERT INTO bus_line (way_id, class, tags, geom) VALUES (30, 'residential', '{"oneway": "yes", "lanes": "2", "width": "4.5", "access:lanes": "no|yes"}', 'SRID=32631;LINESTRING(0 9000, 120 9000)');
CREATE TABLE closed_report AS SELECT * FROM streetgen.import_osm('buses', 'bus');
SELECT 'a closed lane that leaves too little is told', (SELECT source_refs FROM closed_report WHERE what LIKE 'parking, cycle or closed lanes leave less%') = '{30}';
-- Areas, and levels that nobody builds.
INSERT INTO bus_line (way_id, class, tags, geom) VALUES (31, 'residential', '{"area": "yes"}', 'SRID=32631;LINESTRING(0 9100, 120 9100)'), (32, 'residential', '{"area": "no", "layer": "99"}', 'SRID=32631;LINESTRING(0 9200, 120 9200)'), (33, 'residential', '{"layer": "-10"}', 'SRID=32631;LINESTRING(0 9300, 120 9300)');
CREATE TABLE area_report AS SELECT * FROM streetgen.import_osm('buses', 'bus');
SELECT 'a line round an area is no street, and is told', (SELECT (class, source_refs) = ('residential', '{31}') FROM area_report WHERE what = 'area, and so no street') AND NOT EXISTS (SELECT FROM buses.axis WHERE source_ref = '31');
SELECT 'a level that cannot be is unknown, and told', (SELECT source_refs = '{32}' FROM area_report WHERE what = 'level not understood, taken as unknown') AND array_agg(level ORDER BY source_ref) = '{0,-10}' FROM buses.axis WHERE source_ref IN ('32', '33');
