\set ECHO none
\ir shared/truths.sql
-- Carriageways of one street give way to each other, and where a street parts each has one direction of it.  (name, holds)
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, driving_side => 'right'); END $$;
CREATE FUNCTION way(x1 float8, y1 float8, x2 float8, y2 float8) RETURNS geometry LANGUAGE sql AS
  $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + x1, 6860000 + y1), ST_MakePoint(650000 + x2, 6860000 + y2)), 2154) $$;
CREATE TABLE here_line (way_id bigint, class text, name text, ref text, tags jsonb, geom geometry(LineString, 2154));
-- Pairs of carriageways 200 m long: the way there and the way back, so many metres apart.
CREATE FUNCTION pair(n integer, apart float8, there jsonb, back jsonb, name_there text DEFAULT 'Long Road', name_back text DEFAULT 'Long Road') RETURNS void LANGUAGE sql AS $$
  INSERT INTO here_line VALUES (2 * n, 'secondary', name_there, NULL, there, way(0, 100 * n, 200, 100 * n)), (2 * n + 1, 'secondary', name_back, NULL, back, way(200, 100 * n + apart, 0, 100 * n + apart)) $$;
DO $$ BEGIN
  PERFORM pair(1, 6.2, '{"oneway": "yes"}', '{"oneway": "yes"}'), pair(2, 6.2, '{"oneway": "yes"}', '{"oneway": "yes"}', name_back => 'Other Road'),
    pair(3, 6.2, '{"oneway": "yes", "width": "7"}', '{"oneway": "yes"}'), pair(4, 6.2, '{"oneway": "yes", "lanes": "2"}', '{"oneway": "yes", "lanes": "3"}'),
    pair(5, 12, '{"oneway": "yes"}', '{"oneway": "yes"}'), pair(6, 6.2, '{"oneway": "yes"}', '{"oneway": "-1"}'),
    pair(7, 6.2, '{"oneway": "yes"}', '{"oneway": "yes"}', NULL, NULL), pair(8, 6.2, '{"oneway": "yes"}', '{"oneway": "yes", "layer": "1"}'), pair(9, 2, '{"oneway": "yes"}', '{"oneway": "yes"}');
END $$;
-- Two lines that meet at one end lie near each other there alone.
INSERT INTO here_line VALUES (30, 'secondary', 'Wedge', NULL, '{"oneway": "yes"}', way(0, 1200, 200, 1220)), (31, 'secondary', 'Wedge', NULL, '{"oneway": "yes"}', way(200, 1180, 0, 1200));
-- A two-way street that parts before a roundabout, or anything else that both arms come to.
CREATE FUNCTION parting(n integer, arm jsonb, size float8 DEFAULT 40, street jsonb DEFAULT '{}', street_class text DEFAULT 'secondary') RETURNS void LANGUAGE sql AS $$
  INSERT INTO here_line VALUES (10 * n, street_class, NULL, NULL, street, way(-200, 100 * n, 0, 100 * n)), (10 * n + 1, 'secondary', NULL, NULL, '{"oneway": "yes"}' || arm, way(0, 100 * n, size, 100 * n - size / 5)),
    (10 * n + 2, 'secondary', NULL, NULL, '{"oneway": "yes"}' || arm, way(size, 100 * n + size / 5, 0, 100 * n)) $$;
DO $$ BEGIN
  PERFORM parting(20, '{}'), parting(21, '{"lanes": "2"}'), parting(22, '{}', 150), parting(23, '{"cycleway:right": "lane"}'), parting(24, '{}', 40, '{"lanes": "4"}'), parting(25, '{}', 40, '{}', 'residential');
END $$;
CREATE TABLE report AS SELECT * FROM streetgen.import_osm('town', 'here');
SELECT FROM streetgen.generate('town') \g /dev/null
CREATE FUNCTION told(way integer) RETURNS text LANGUAGE sql AS $$ SELECT round(u.width::numeric, 2) || ': ' || u.lanes_forward + u.lanes_backward FROM town.axis_used u JOIN town.axis USING (axis_id) WHERE source_ref = way::text $$;
SELECT 'each carriageway is as wide as the spacing less the median' AS name, (told(2), told(3)) = ('5.70: 2', '5.70: 2') AS holds;
SELECT 'so that ground stays between them', (SELECT ST_Distance(a.surface, b.surface) BETWEEN 0.499 AND 0.6 FROM town.section a JOIN town.edge ea ON ea.edge_id = a.edge_id JOIN town.axis xa ON xa.axis_id = ea.axis_id,
  town.section b JOIN town.edge eb ON eb.edge_id = b.edge_id JOIN town.axis xb ON xb.axis_id = eb.axis_id WHERE (xa.source_ref, xb.source_ref) = ('2', '3'));
SELECT 'two streets stay as wide as they are', (told(4), told(5)) = ('7.00: 2', '7.00: 2');
SELECT 'a stated width holds, and is told', (told(6), told(7)) = ('7.00: 2', '5.70: 2') AND (SELECT source_refs = '{6}' FROM report WHERE what LIKE 'stated width of a carriageway%');
SELECT 'stated lanes become narrower, to lane_width_minimal each', (told(8), told(9)) = ('5.70: 2', '6.00: 3');
SELECT 'carriageways that have room stay', (told(10), told(11)) = ('7.00: 2', '7.00: 2');
SELECT 'and so do two that run one way', (told(12), told(13)) = ('7.00: 2', '7.00: 2');
SELECT 'names may be unknown', (told(14), told(15)) = ('5.70: 2', '5.70: 2');
SELECT 'levels lie apart', (told(16), told(17)) = ('7.00: 2', '7.00: 2');
SELECT 'none is narrower than a car needs', (told(18), told(19)) = ('2.50: 1', '2.50: 1');
SELECT 'lines that only meet are no carriageways beside each other', (told(30), told(31)) = ('7.00: 2', '7.00: 2');
SELECT 'where a street parts each carriageway has one direction of it', (told(201), told(202), told(200)) = ('4.00: 1', '4.00: 1', '8.00: 2');
SELECT 'but where lanes are stated', (told(211), told(212)) = ('7.00: 2', '7.00: 2');
SELECT 'or it goes on for long', (told(221), told(222)) = ('7.00: 2', '7.00: 2');
SELECT 'a cycle lane lies beside the lane', (SELECT array_agg(DISTINCT kind_forward) = '{general|cycle}' FROM town.axis WHERE source_ref IN ('231', '232')) AND told(231) = '5.50: 1';
SELECT 'a wide street leaves each as many lanes as it has', (told(241), told(242)) = ('7.00: 2', '7.00: 2');
SELECT 'streets of two classes are no one', (told(251), told(252)) = ('7.00: 2', '7.00: 2');
SELECT 'the import tells of both', (SELECT count FROM report WHERE what LIKE 'carriageway as wide as its spacing%') = 9 AND (SELECT count FROM report WHERE what LIKE 'carriageway where a street parts%') = 4;
SELECT 'the same delivery changes nothing', coalesce(sum(count) FILTER (WHERE what = 'new or changed'), 0) = 0 FROM streetgen.import_osm('town', 'here');
UPDATE town.axis SET width = 6.5 WHERE source_ref = '2';
SELECT count(*) FROM streetgen.import_osm('town', 'here') \g /dev/null
SELECT 'a width by hand stays', told(2) = '6.50: 2';
UPDATE here_line SET geom = ST_Translate(geom, 0, 10) WHERE way_id = 15;
SELECT count(*) FROM streetgen.import_osm('town', 'here') \g /dev/null
SELECT 'where the other carriageway moves off it is wide again', (told(14), told(15)) = ('7.00: 2', '7.00: 2');
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'check_model has no error', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
