\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Roads: chains of edges through nodes of degree two, their ids through edits, bends by hand.  (name, holds)
\o /dev/null
SELECT streetgen.create_model('town', 2154, subjects => '{interconnection,alignment}'), streetgen.create_model('anew', 2154, subjects => '{interconnection,alignment}');
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('bare', 2154);
RESET streetgen_test.subjects;
-- Every edge in one road, lengths add up, and roads = edges - nodes of degree two + closed roads.
CREATE FUNCTION pg_temp.counts_are_right(model name) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  right_counts boolean;
BEGIN
  EXECUTE replace($q$
    SELECT roads = edges - of_two + closed AND members = edges AND abs(length - of_edges) < 1e-6 * of_edges
    FROM (SELECT count(*) AS roads, count(*) FILTER (WHERE closed) AS closed, sum(length) AS length FROM @.road) r,
      (SELECT count(*) AS edges, sum(end_abscissa - start_abscissa) AS of_edges FROM @.edge) e, (SELECT count(*) AS members FROM @.road_edge) m,
      (SELECT count(*) AS of_two FROM (SELECT n FROM @.edge, LATERAL (VALUES (from_node), (to_node)) v(n) GROUP BY n HAVING count(*) = 2) d) d$q$, '@', quote_ident(model)) INTO right_counts;
  RETURN right_counts;
END $$;
CREATE FUNCTION pg_temp.follows() RETURNS boolean LANGUAGE sql AS $$
  SELECT test.followed('town', 'anew') AND pg_temp.counts_are_right('town') $$;
CREATE FUNCTION pg_temp.edges_of(road bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(CASE WHEN along_road THEN '' ELSE '-' END || axis_id, ' ' ORDER BY position) FROM town.road_edge JOIN town.edge USING (edge_id) WHERE road_id = road $$;
INSERT INTO town.axis (axis_id, geom, width) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 6 FROM (VALUES
  (1, 'LINESTRING(0 0, 100 0, 150 50)'), (2, 'LINESTRING(300 50, 200 80, 150 50)'), (3, 'LINESTRING(300 50, 400 0)'),
  (4, 'LINESTRING(0 300, 50 300, 50 350)'), (5, 'LINESTRING(50 350, 0 350, 0 300)'), (6, 'LINESTRING(200 300, 260 300, 260 360, 200 360, 200 300)'), (7, 'LINESTRING(260 300, 350 300)')) a(id, line);
\o

SELECT 'a new model has no roads unless told so', to_regclass('bare.road') IS NULL;
SELECT 'a chain of edges is one road', pg_temp.edges_of(1) = '1 -2 3';
SELECT 'along it each edge begins where the one before ends', array_agg(round(start_abscissa::numeric, 2) ORDER BY position) = '{0,170.71,333.42}' FROM town.road_edge WHERE road_id = 1;
SELECT 'a ring is one closed road', count(*) = 1 AND bool_and(from_node = to_node AND pg_temp.edges_of(road_id) = '4 5') FROM town.road WHERE closed;
SELECT 'a loop that meets a street is a road that is not closed', count(*) = 1 AND bool_and(NOT closed) FROM town.road WHERE from_node = to_node AND pg_temp.edges_of(road_id) LIKE '6%' AND NOT closed;
SELECT 'counts are those of the network', pg_temp.counts_are_right('town');
SELECT 'a road is a curve from node to node', bool_and(ST_Equals(ST_StartPoint(r.geom), a.geom) AND ST_Equals(ST_EndPoint(r.geom), b.geom)) FROM town.road r JOIN town.node a ON a.node_id = from_node JOIN town.node b ON b.node_id = to_node;
SELECT 'it bends where its axes do, and at nodes', count(*) = 6 AND min(radius) > 5 FROM town.road_arc WHERE road_id = 1;
SELECT 'arcs touch their neighbours', count(*) = 0 FROM town.road r, streetgen._arc_road_kinks(geom) WHERE road_id = 1;
SELECT 'no point of an axis is farther than the shift', bool_and(ST_Distance(ST_SetSRID(p.geom, 2154), streetgen.arc_road_line(r.geom, 0.001)) < 0.501) FROM town.road_edge JOIN town.road r USING (road_id) JOIN town.edge USING (edge_id) JOIN town.axis a USING (axis_id), ST_DumpPoints(a.geom) p
  WHERE road_id = 1;
SELECT 'the speed limit of a bend follows from its radius', bool_and(abs(speed_limit - streetgen.arc_road_speed_limit(radius, 0.7)) < 1e-9) FROM town.road_arc;
SELECT 'and from the friction', streetgen.set('town', 'road_friction', '0.35') IS NOT NULL;
SELECT 'of which streets know nothing', abs(max(speed_limit / streetgen.arc_road_speed_limit(radius, 0.35)) - 1) < 1e-9 AND NOT streetgen._setting_changed('town') FROM town.road_arc;
SELECT streetgen.set('town', 'road_friction', '0.7') \g /dev/null
SELECT 'a place along a road', ST_DWithin(geom, 'SRID=2154;POINT(650040 6860000)', 1e-6) AND edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 1) AND abs(heading - 90) < 1e-6 AND curvature = 0 FROM streetgen.road_at('town', 1, 40);
SELECT 'it is clamped', ST_Equals(geom, 'SRID=2154;POINT(650400 6860000)') FROM streetgen.road_at('town', 1, 1e6);
SELECT 'a road that is not there: 22023', test.state($$SELECT * FROM streetgen.road_at('town', 99, 1)$$) = '22023';
SELECT 'metres that are no number: 22023', test.state($$SELECT * FROM streetgen.road_at('town', 1, 'NaN')$$) = '22023';
SELECT 'a model without roads: 0A000', test.state($$SELECT * FROM streetgen.road_at('bare', 1, 1)$$) = '0A000';
SELECT 'the model is sound', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
SELECT 'bends that are tight or slow are told', count(DISTINCT rule) = 2 FROM streetgen.check_model('town') WHERE relation = 'road' AND severity = 'notice';
SELECT 'summary counts roads', (SELECT amount FROM streetgen.summary('town') WHERE subject = 'roads') = (SELECT count(*) FROM town.road WHERE NOT closed);
SELECT 'a picture has their arcs', streetgen.svg('town', width => 2000, theme => 'construction') ~ 'class="road"[^>]*>\s*<path d="M [^"]* A ';
SELECT 'a second run writes nothing', sum(inserted + updated + deleted) = 0 AND sum(unchanged) FILTER (WHERE relation = 'road') = (SELECT count(*) FROM town.road) FROM streetgen.generate('town');

-- Ids: a road keeps its own while its first edge is in it.
INSERT INTO town.axis (axis_id, geom, width) VALUES (8, 'SRID=2154;LINESTRING(650200 6860080, 650200 6860150)', 5);
SELECT 'a street that comes splits a road', pg_temp.edges_of(1) = '1 -2' AND pg_temp.follows();
SELECT 'the other part is new', count(*) = 1 FROM town.road_edge m JOIN town.edge USING (edge_id) WHERE axis_id = 3 AND m.road_id > 1 AND position = 1;
DELETE FROM town.axis WHERE axis_id = 8;
SELECT 'where it goes the parts join', pg_temp.edges_of(1) = '1 -2 3' AND pg_temp.follows();
INSERT INTO town.axis (axis_id, geom, width) VALUES (9, 'SRID=2154;LINESTRING(650400 6860000, 650300 6859900, 650100 6859900, 650000 6860000)', 5);
SELECT 'a road that comes back to its start is closed', closed AND pg_temp.edges_of(1) = '1 -2 3 9' FROM town.road WHERE road_id = 1;
SELECT 'and is as from scratch', pg_temp.follows();
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'without its first edge it is another road', NOT EXISTS (SELECT FROM town.road WHERE road_id = 1) AND pg_temp.follows();
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650150 6860050)', 6);
DELETE FROM town.axis WHERE axis_id = 9;
SELECT 'edits one after the other leave it as from scratch', pg_temp.follows();

-- Bends by hand.
CREATE TEMPORARY TABLE bend AS SELECT * FROM town.road_arc_editing WHERE axis_id = 1;
SELECT 'the bend of an axis can be edited', count(*) = 1 AND bool_and(abs(abscissa - 100) < 1e-6 AND NOT by_hand) FROM bend;
SELECT 'bends at nodes cannot', count(*) = count(DISTINCT (axis_id, abscissa)) AND bool_and(EXISTS (SELECT FROM town.axis a, ST_DumpPoints(a.geom) p WHERE a.axis_id = e.axis_id
  AND ST_DWithin(p.geom, ST_LineInterpolatePoint(a.geom, abscissa / ST_Length(a.geom)), 1e-6))) FROM town.road_arc_editing e;
UPDATE town.road_arc_editing SET radius = 20 WHERE axis_id = 1;
SELECT 'a radius is typed', abs(radius - 20) < 1e-6 AND by_hand AND abs(abscissa - 100) < 1e-6 FROM town.road_arc_editing WHERE axis_id = 1;
SELECT 'it is stored', count(*) = 1 AND bool_and(axis_id = 1 AND radius = 20 AND abs(abscissa - 100) < 1e-6) FROM town.road_override;
SELECT 'as from scratch', pg_temp.follows();
-- The centre lies on the line that halves the angle: 22.5 degrees from the normal of the first segment.
UPDATE town.road_arc_editing SET geom = ST_SetSRID(ST_Point(650100 - 30 * tan(radians(22.5)), 6860030), 2154) WHERE axis_id = 1;
SELECT 'a centre is dragged', abs(radius - 30) < 1e-6 AND abs(ST_Y(geom) - 6860030) < 1e-5 FROM town.road_arc_editing WHERE axis_id = 1;
BEGIN;
UPDATE town.road_arc_editing SET geom = ST_Translate(geom, 0, 20000) WHERE axis_id = 1;
SELECT 'dragged far off it has the greatest radius', max(radius) = 4000 FROM town.road_override WHERE axis_id = 1;
ROLLBACK;
UPDATE town.road_arc_editing SET radius = 3000 WHERE axis_id = 1;
SELECT 'a radius that does not fit becomes the greatest that does', radius BETWEEN 60 AND 171 AND by_hand FROM town.road_arc_editing WHERE axis_id = 1;
UPDATE town.road_arc_editing SET radius = 0 WHERE axis_id = 1;
SELECT 'a bend is made sharp, and stays at hand', radius = 0 AND by_hand AND ST_Equals(geom, 'SRID=2154;POINT(650100 6860000)') FROM town.road_arc_editing WHERE axis_id = 1;
SELECT 'as from scratch without an arc', pg_temp.follows();
UPDATE town.road_arc_editing SET radius = 15 WHERE axis_id = 1;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, 'SRID=2154;POINT(650105 6859990)') WHERE axis_id = 1;
SELECT 'a decision goes with its vertex', abs(radius - 15) < 1e-6 AND by_hand FROM town.road_arc_editing WHERE axis_id = 1;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'and with an axis turned round', abs(radius - 15) < 1e-6 AND by_hand AND pg_temp.follows() FROM town.road_arc_editing WHERE axis_id = 1;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650150 6860050, 650000 6860000)' WHERE axis_id = 1;
SELECT 'one without its bend is told', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'road override without its bend';
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650150 6860050)' WHERE axis_id = 1;
DELETE FROM town.road_override;
SELECT 'taken back, it is as it was', abs(e.radius - b.radius) < 1e-9 AND NOT e.by_hand AND pg_temp.follows() FROM town.road_arc_editing e JOIN bend b USING (axis_id);
UPDATE town.road_arc_editing SET radius = 20 WHERE axis_id = 1;
DELETE FROM town.road_arc_editing WHERE axis_id = 1;
SELECT 'by the view too', count(*) = 0 FROM town.road_override;
SELECT 'a radius out of range: 22023', test.state($$UPDATE town.road_arc_editing SET radius = -1 WHERE axis_id = 1$$) = '22023' AND test.state($$UPDATE town.road_arc_editing SET radius = 'NaN' WHERE axis_id = 1$$) = '22023';
SELECT 'a bend cannot be inserted: 0A000', test.state($$INSERT INTO town.road_arc_editing (axis_id, radius) VALUES (1, 5)$$) = '0A000';

-- A radius that wants all of a short segment leaves the next bend its arc.
INSERT INTO town.axis (axis_id, geom, width) VALUES (20, 'SRID=2154;LINESTRING(650500 6860000, 650505.8 6860002, 650509.2 6860006.5, 650514.9 6860015.2)', 5);
UPDATE town.road_arc_editing SET radius = 30 WHERE axis_id = 20 AND abscissa < 7;
SELECT 'a wish takes no arc from the next bend', count(*) = 2 AND min(radius) > 1 AND max(radius) FILTER (WHERE by_hand) BETWEEN 8 AND 30 FROM town.road_arc_editing WHERE axis_id = 20;
SELECT 'the road has one tangent', count(*) = 0 FROM streetgen.check_model('town') WHERE rule LIKE 'gap of tangent%';
UPDATE town.road_arc_editing SET radius = 0 WHERE axis_id = 20 AND abscissa < 7;
SELECT 'what is sharp by hand is no gap', count(*) = 0 FROM streetgen.check_model('town') WHERE rule LIKE 'gap of tangent%';
DELETE FROM town.axis WHERE axis_id = 20;
-- A bend by hand stays at its vertex, whatever number that has.
INSERT INTO town.axis (axis_id, geom, width) VALUES (21, 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000, 650580 6860040, 650640 6860040, 650660 6860000)', 5);
UPDATE town.road_arc_editing SET radius = 9 WHERE axis_id = 21 AND abscissa < 70;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 21;
SELECT 'turned round, the bend stays', count(*) = 1 AND bool_and(ST_Equals(geom, 'SRID=2154;POINT(650560 6860000)')) FROM town.road_override WHERE axis_id = 21;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650500 6860000, 650530 6860002, 650560 6860000, 650580 6860040, 650660 6860000)' WHERE axis_id = 21;
SELECT 'with a vertex more and one less, too', count(*) = 1 AND bool_and(ST_Equals(geom, 'SRID=2154;POINT(650560 6860000)')) FROM town.road_override WHERE axis_id = 21;
DELETE FROM town.axis WHERE axis_id = 21;

-- Bends that are edited by their keys in one transaction, as a GIS saves them.
INSERT INTO town.axis (axis_id, geom, width) VALUES (22, 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000, 650580 6860040, 650640 6860040, 650660 6860000, 650720 6860000)', 5);
CREATE TEMPORARY TABLE shown AS SELECT road_arc_id, abscissa, row_number() OVER (ORDER BY abscissa) AS nth FROM town.road_arc_editing WHERE axis_id = 22;
CREATE FUNCTION pg_temp.edit_bend(nth bigint, edit text) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format('UPDATE town.road_arc_editing SET %s WHERE road_arc_id = (SELECT road_arc_id FROM shown WHERE nth = %s)', edit, nth);
END $$;
CREATE FUNCTION pg_temp.bends() RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(CASE WHEN e.by_hand THEN round(e.radius)::text ELSE '-' END, ' ' ORDER BY nth) FROM shown LEFT JOIN town.road_arc_editing e USING (road_arc_id) WHERE abs(e.abscissa - shown.abscissa) < 1e-6 $$;
BEGIN;
SELECT pg_temp.edit_bend(1, 'radius = 0'), pg_temp.edit_bend(2, 'radius = 7'), pg_temp.edit_bend(4, 'radius = 8') \g /dev/null
SELECT 'each edit changes the bend that was chosen', pg_temp.bends() = '0 7 - 8';
INSERT INTO town.axis (axis_id, geom, width) VALUES (23, 'SRID=2154;LINESTRING(650610 6860040, 650610 6860100)', 5);
SELECT pg_temp.edit_bend(1, 'radius = 6'), pg_temp.edit_bend(3, 'radius = 5') \g /dev/null
SELECT 'also where its road was parted meanwhile', pg_temp.bends() = '6 7 5 8';
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 22;
SELECT pg_temp.edit_bend(2, 'radius = NULL') \g /dev/null
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 22;
SELECT 'and its axis turned round', pg_temp.bends() = '6 - 5 8';
COMMIT;
SELECT 'keys tell bends apart, and are whole numbers of a float8', count(DISTINCT road_arc_id) = count(*) AND max(road_arc_id) < 2 ^ 53 AND min(road_arc_id) >= 0 FROM town.road_arc_editing;
DELETE FROM town.axis WHERE axis_id IN (22, 23);
DELETE FROM town.road_override WHERE axis_id = 22;
-- Two bends closer than 1 m, and one beside a node where the road bends too.
INSERT INTO town.axis (axis_id, geom, width) VALUES (24, 'SRID=2154;LINESTRING(650500 6860000, 650560 6860000, 650560.6 6860000.5, 650600 6860090)', 5), (25, 'SRID=2154;LINESTRING(650600 6860090, 650600.7 6860090.3, 650660 6860080)', 5);
TRUNCATE shown;
INSERT INTO shown SELECT road_arc_id, abscissa, row_number() OVER (ORDER BY abscissa) FROM town.road_arc_editing WHERE axis_id = 24;
SELECT pg_temp.edit_bend(1, 'radius = 0.3'), pg_temp.edit_bend(2, 'radius = 0.4') \g /dev/null
SELECT 'close bends are decided apart', array_agg(radius ORDER BY abscissa) = '{0.3,0.4}' FROM town.road_override WHERE axis_id = 24;
SELECT pg_temp.edit_bend(1, 'by_hand = false') \g /dev/null
SELECT 'and taken back apart', array_agg(radius) = '{0.4}' FROM town.road_override WHERE axis_id = 24;
SELECT 'a bend at a node is not that of the vertex beside it', count(*) = 1 FROM town.road_arc_editing WHERE axis_id = 25;
DELETE FROM town.axis WHERE axis_id IN (24, 25);
DELETE FROM town.road_override WHERE axis_id = 24;

-- With smoothing the edges are the roads.
SELECT streetgen.set('town', 'smoothing', 'arcs') \g /dev/null
CREATE TEMPORARY TABLE drawn AS SELECT road_id, geom FROM town.road;
SELECT streetgen.generate('town', wait => true) \g /dev/null
SELECT 'roads do not depend on the setting', bool_and(ST_AsText(r.geom, 6) = ST_AsText(d.geom, 6)) FROM town.road r JOIN drawn d USING (road_id);
SELECT 'edges lie on them', bool_and(ST_HausdorffDistance(e.geom, streetgen.arc_road_line(e.curve, 0.001)) < 0.05) FROM town.edge e WHERE curve IS NOT NULL;
SELECT 'smoothed, the model is sound and as from scratch', pg_temp.follows();
UPDATE town.road_arc_editing SET radius = 25 WHERE axis_id = 1;
SELECT 'a bend by hand moves the edge', abs(ST_Distance(e.geom, a.corner) - (ST_Distance(a.corner, a.centre) - 25)) < 0.02 AND abs(a.radius - 25) < 1e-6 AND pg_temp.follows()
  FROM town.edge e, town.road_arc a WHERE axis_id = 1 AND ST_DWithin(a.corner, 'SRID=2154;POINT(650100 6860000)', 0.01);
SELECT streetgen.set('town', 'smoothing', 'none') \g /dev/null
SELECT streetgen.generate('town', wait => true) \g /dev/null

-- Random edits, followed as from scratch.
SELECT setseed(0.21) \g /dev/null
DO $$
DECLARE
  line geometry;
  wrong text := '';
BEGIN
  FOR i IN 1 .. 60 LOOP
    line := ST_SetSRID(ST_MakeLine(ST_Point(650000 + 50 * floor(random() * 6), 6861000 + 50 * floor(random() * 6)), ST_Point(650000 + 50 * floor(random() * 6), 6861000 + 50 * floor(random() * 6))), 2154);
    IF ST_Length(line) > 0 THEN
      INSERT INTO town.axis (axis_id, geom, width) VALUES (100 + i, line, 3);
    END IF;
    IF i % 3 = 0 THEN
      DELETE FROM town.axis WHERE axis_id = (SELECT axis_id FROM town.axis WHERE axis_id > 9 ORDER BY random() LIMIT 1);
    END IF;
    IF NOT pg_temp.counts_are_right('town') THEN wrong := wrong || ' ' || i; END IF;
  END LOOP;
  CREATE TEMPORARY TABLE result AS SELECT wrong;
END $$;
SELECT 'after each of random edits counts are right', wrong = '' FROM result;
SELECT 'and roads as from scratch', pg_temp.follows();

-- Clusters leave roads for their end; of a model with objects nothing waits.
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('parts', 2154, subjects => '{interconnection,alignment}'), streetgen.create_model('whole', 2154, subjects => '{interconnection,alignment}') \g /dev/null
RESET streetgen_test.subjects;
SET streetgen.live = off;
INSERT INTO parts.axis (axis_id, geom, width) SELECT n, ST_SetSRID(ST_MakeLine(ST_Point(650000 + 30 * (n % 40), 6860000 + 40 * (n / 40)), ST_Point(650030 + 30 * (n % 40), 6860000 + 40 * (n / 40) + 3 * (n % 3))), 2154), 4
  FROM generate_series(1, 1100) n;
INSERT INTO whole.axis SELECT * FROM parts.axis;
RESET streetgen.live;
SELECT streetgen.plan_clusters('parts', 3) \g /dev/null
SELECT streetgen.generate_cluster('parts') FROM generate_series(1, 3) \g /dev/null
SELECT 'no road is there before', count(*) = 0 FROM parts.road;
DO $$ BEGIN WHILE streetgen.finish_clusters('parts') IS NOT NULL LOOP END LOOP; END $$;
SELECT streetgen.generate('whole') \g /dev/null
SELECT 'after the last cluster roads are as one run makes them', count(*) > 0 AND test.same('parts', 'whole') FROM parts.road;
INSERT INTO whole.axis (axis_id, geom, width) VALUES (5000, 'SRID=2154;LINESTRING(655000 6860000,655100 6860000)', 4);
SET streetgen.live = off;
DELETE FROM whole.axis WHERE axis_id = 5000;
RESET streetgen.live;
SELECT 'a road goes with the last of its axes, also where nobody follows', count(*) > 10 AND bool_and(EXISTS (SELECT FROM whole.road_edge e WHERE e.road_id = r.road_id)) FROM whole.road r;

-- The subject, and rows changed by hand.
UPDATE town.road SET length = 1 WHERE road_id = (SELECT min(road_id) FROM town.road);
SELECT 'a wrong length is told', count(*) = 1 FROM streetgen.check_model('town') WHERE rule LIKE 'length of a road%';
DELETE FROM town.road WHERE road_id = (SELECT max(road_id) FROM town.road);
SELECT 'an edge in no road is told', count(*) > 0 FROM streetgen.check_model('town') WHERE rule = 'edge in no road';
SELECT streetgen.generate('town', wait => true) \g /dev/null
SELECT 'the next run repairs them', pg_temp.follows();
SELECT streetgen.switch_subject('town', 'alignment', false) \g /dev/null
SELECT 'switched off, roads and their views are gone', to_regclass('town.road') IS NULL AND to_regclass('town.road_edge') IS NULL AND to_regclass('town.road_arc') IS NULL AND to_regclass('town.road_arc_editing') IS NULL;
SELECT streetgen.switch_subject('town', 'alignment', true) \g /dev/null
SELECT 'switched on, they are back', pg_temp.counts_are_right('town') AND (SELECT count(*) > 0 FROM town.road_arc_editing);
