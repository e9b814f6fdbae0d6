\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Lanes: counts, directions, kinds, overrides, numbering; what is painted.  (name, holds)
CREATE FUNCTION pg_temp.street(y float8, x float8 DEFAULT 0) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + x, 6860000 + y), ST_MakePoint(650100 + x, 6860000 + y)), 2154) $$;
DO $$ BEGIN PERFORM streetgen.create_model('lanes', 2154); PERFORM streetgen.live('lanes', false); END $$;
-- Directions by ordinality: along, against, both.
CREATE FUNCTION pg_temp.ways(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(CASE WHEN both_ways THEN 'b' WHEN along_axis THEN 't' ELSE 'f' END, '' ORDER BY ordinality) FROM lanes.lane JOIN lanes.edge USING (edge_id) WHERE axis_id = axis $$;
CREATE FUNCTION pg_temp.kinds(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(concat(kind, CASE WHEN both_ways THEN '*' WHEN along_axis THEN '+' ELSE '-' END), ' ' ORDER BY lane_position) FROM lanes.lane JOIN lanes.edge USING (edge_id) WHERE axis_id = axis $$;
CREATE FUNCTION pg_temp.widths(axis bigint) RETURNS numeric[] LANGUAGE sql AS $$
  SELECT array_agg(round(l.width::numeric, 3) ORDER BY lane_position) FROM lanes.lane l JOIN lanes.edge USING (edge_id) WHERE axis_id = axis $$;
CREATE FUNCTION pg_temp.rules(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(rule, ', ' ORDER BY rule) FROM streetgen.check_model('lanes') WHERE relation = 'axis' AND id = axis AND severity = 'notice' $$;

DO $$ BEGIN
  INSERT INTO lanes.axis (axis_id, geom, width, lane_count, direction) VALUES
    (1, pg_temp.street(0), 3, 1, 'direct'), (2, pg_temp.street(20), 3, 1, 'reverse'), (3, pg_temp.street(40), 6, 2, 'both'), (4, pg_temp.street(60), 6, 2, 'direct'),
    (5, pg_temp.street(80), 6, 2, 'reverse'), (6, pg_temp.street(100), 9, 3, 'both'), (7, pg_temp.street(120), 9, 3, 'reverse'), (8, pg_temp.street(140), 12, 4, 'both'),
    (9, pg_temp.street(160), 12, 4, 'direct'), (10, pg_temp.street(180), 6, 1, 'both'), (11, pg_temp.street(200), 6, NULL, 'both'), (12, pg_temp.street(220), 6, 30, 'both');
  INSERT INTO lanes.axis (axis_id, geom, width, lane_count, lanes_forward, lanes_backward, direction) VALUES
    (20, pg_temp.street(300), 12, NULL, 3, 1, 'both'), (21, pg_temp.street(320), 12, 4, 3, NULL, 'both'), (22, pg_temp.street(340), 12, 4, NULL, 3, 'both'),
    (23, pg_temp.street(360), 12, 2, 2, 2, 'both'), (24, pg_temp.street(380), 4, 2, 1, 1, 'direct'), (25, pg_temp.street(400), 12, 3, 0, 0, 'both');
  INSERT INTO lanes.axis (axis_id, geom, width, direction, kind_forward, kind_backward, lane_width_forward, lane_width_backward, turn_forward, turn_backward) VALUES
    (30, pg_temp.street(500), 12, 'both', 'general|general|cycle|parking', 'general|bus', NULL, NULL, 'left|through;right', 'through|'),
    (31, pg_temp.street(520), 8, 'direct', 'parking|general', 'cycle', '|', '2.25', 'none', NULL),
    (32, pg_temp.street(540), 8, 'both', 'general|general', NULL, '5||', NULL, 'left|through|right', NULL),
    (33, pg_temp.street(560), 6, 'direct', 'general|general', NULL, '4|8', NULL, NULL, NULL);
  INSERT INTO lanes.axis (axis_id, geom, width, width_end, lane_count) VALUES (40, pg_temp.street(700), 6, 14, 4), (57, pg_temp.street(940), 4, 9, NULL);
  -- Lanes for both directions.
  INSERT INTO lanes.axis (axis_id, geom, width, direction, lane_count, lanes_forward, lanes_both, kind_forward, kind_backward) VALUES
    (50, pg_temp.street(800), 4.4, 'both', NULL, NULL, NULL, NULL, NULL), (51, pg_temp.street(820), 4.5, 'both', NULL, NULL, NULL, NULL, NULL), (52, pg_temp.street(840), 4, 'both', 2, NULL, NULL, NULL, NULL),
    (53, pg_temp.street(860), 4, 'direct', NULL, NULL, NULL, NULL, NULL), (54, pg_temp.street(880), 10, 'both', 3, NULL, 1, NULL, NULL), (55, pg_temp.street(900), 6, 'direct', 2, NULL, 1, NULL, NULL),
    (56, pg_temp.street(920), 6.5, 'both', 1, NULL, NULL, 'cycle', 'cycle'), (58, pg_temp.street(960), 12, 'both', 4, 2, 1, NULL, NULL), (59, pg_temp.street(980), 4, 'both', NULL, NULL, 1, NULL, NULL),
    (60, pg_temp.street(1000), 14, 'both', NULL, NULL, 2, NULL, NULL), (61, pg_temp.street(1020), 4, 'both', NULL, 1, NULL, NULL, NULL), (62, pg_temp.street(1040), 3, 'both', NULL, NULL, NULL, 'cycle', 'cycle');
END $$;
SELECT 'lanes are reported' AS name, (SELECT inserted > 0 FROM streetgen.generate('lanes') WHERE relation = 'lane') AS holds;

SELECT 'one-way streets have lanes of their way only, as published', pg_temp.ways(1) || ' ' || pg_temp.ways(2) || ' ' || pg_temp.ways(4) || ' ' || pg_temp.ways(5) || ' ' || pg_temp.ways(7) || ' ' || pg_temp.ways(9) = 't f tt ff fff tttt';
SELECT 'two-way streets keep to the right, an odd lane is of both directions', pg_temp.ways(3) || ' ' || pg_temp.ways(6) || ' ' || pg_temp.ways(8) = 'ft bft ftft';
SELECT 'one lane of a two-way street is of both directions', pg_temp.ways(10) = 'b' AND coalesce(pg_temp.rules(10), '') NOT LIKE '%direction%' AND (SELECT (lane_count, lanes_forward, lanes_backward, lanes_both) = (1, 0, 0, 1) FROM lanes.edge WHERE axis_id = 10);
SELECT 'so is that of a narrow street of unknown lanes, and of no other', pg_temp.ways(50) || ' ' || pg_temp.ways(51) || ' ' || pg_temp.ways(53) || ' ' || pg_temp.ways(57) || ' ' || pg_temp.ways(59) = 'b ft t ft b';
SELECT 'a stated count wins over the width', pg_temp.ways(52) = 'ft' AND pg_temp.ways(61) = 'ft';
SELECT 'lanes for both directions lie in the middle', pg_temp.kinds(54) = 'general- general* general+' AND pg_temp.kinds(58) = 'general- general* general+ general+' AND pg_temp.kinds(60) = 'general- general* general* general+';
SELECT 'and are counted', bool_and(lane_count = lanes_forward + lanes_backward + lanes_both) AND count(*) FILTER (WHERE lanes_both > 0) = 9 FROM lanes.edge;
SELECT 'a one-way street has none, and names them', pg_temp.ways(55) = 'tt' AND pg_temp.rules(55) = 'lanes for both directions of a one-way street, not taken';
SELECT 'cycle lanes run beside it, and a track for cycles gets none', pg_temp.kinds(56) = 'cycle- general* cycle+' AND pg_temp.widths(56) = '{1.5,3.5,1.5}' AND pg_temp.kinds(62) = 'cycle- cycle+';
SELECT 'one may cross the lines about it', (SELECT array_agg(concat(kind, ' ', dashed) ORDER BY axis_id, lane_position) = '{centre t,centre t,same_direction t,same_direction t}' FROM lanes.lane_separator JOIN lanes.edge USING (edge_id) WHERE axis_id IN (10, 54, 56));
SELECT 'a lane for both directions has no arrow', NOT EXISTS (SELECT FROM lanes.marking JOIN lanes.lane USING (edge_id, lane_position) WHERE both_ways);
SELECT 'and runs along the axis, as its line does', bool_and(along_axis) FROM lanes.lane WHERE both_ways;
SELECT 'a two-way street of unknown lanes has one each way', pg_temp.ways(11) = 'ft' AND (SELECT 'lane_count' = ANY (estimated) FROM lanes.edge WHERE axis_id = 11);
SELECT 'thirty lanes fill six metres', (SELECT count(*) = 30 AND abs(sum(l.width) - 6) < 1e-9 FROM lanes.lane l JOIN lanes.edge USING (edge_id) WHERE axis_id = 12)
    AND (SELECT count(*) = 30 FROM streetgen.check_model('lanes') c JOIN lanes.lane l ON l.lane_id = c.id JOIN lanes.edge e USING (edge_id) WHERE rule = 'narrow lane, m' AND axis_id = 12);
SELECT 'three lanes and one, given in three ways', pg_temp.kinds(20) = 'general- general+ general+ general+' AND pg_temp.kinds(21) = pg_temp.kinds(20) AND pg_temp.kinds(22) = 'general- general- general- general+';
SELECT 'the lanes of the directions count against their sum', pg_temp.ways(23) = 'ftft' AND pg_temp.rules(23) LIKE 'lane_count is not%';
SELECT 'lanes against a one-way street are left out and named', pg_temp.ways(24) = 't' AND pg_temp.rules(24) LIKE '%against a one-way street%';
SELECT 'zero lanes of a direction is unknown', pg_temp.ways(25) = 'bft';
SELECT 'edges say what was used', (SELECT (lane_count, lanes_forward, lanes_backward) = (4, 3, 1) FROM lanes.edge WHERE axis_id = 21);
SELECT 'no lane count of zero', test.state('UPDATE lanes.axis SET lane_count = 0') = '23514';
SELECT 'nor of forty', test.state('UPDATE lanes.axis SET lane_count = 40') = '23514' AND test.state('UPDATE lanes.axis SET lanes_forward = 40') = '23514';
SELECT 'kinds stand from kerb to kerb, those against the axis seen from it', pg_temp.kinds(30) = 'bus- general- general+ general+ cycle+ parking+';
SELECT 'cycle and parking lanes have their usual width, the others share the rest', pg_temp.widths(30) = '{2.125,2.125,2.125,2.125,1.5,2}';
SELECT 'a lane against the traffic', pg_temp.kinds(31) = 'cycle- parking+ general+' AND pg_temp.widths(31) = '{2.25,2,3.75}' AND pg_temp.rules(31) IS NULL;
SELECT 'turns belong to the driving lanes', (SELECT array_agg(coalesce(turn, '-') ORDER BY lane_position) = '{-,through,left,through;right,-,-}' FROM lanes.lane JOIN lanes.edge USING (edge_id) WHERE axis_id = 30);
SELECT 'lists of another number of lanes are left out and named', pg_temp.widths(32) = '{2.667,2.667,2.667}' AND pg_temp.rules(32) LIKE '%turns are not those%widths are not those%'
    AND NOT EXISTS (SELECT FROM lanes.lane JOIN lanes.edge USING (edge_id) WHERE axis_id = 32 AND turn IS NOT NULL);
SELECT 'widths that sum to more than the roadway are proportions', pg_temp.widths(33) = '{2,4}';
SELECT format('a list such as %s is refused', value), test.state(format('UPDATE lanes.axis SET %s = %L', name, value)) = '23514'
    FROM (VALUES ('kind_forward', 'tram'), ('kind_forward', ''), ('kind_backward', 'general|'), ('lane_width_forward', '3m'), ('lane_width_forward', '-1'), ('lane_width_backward', 'NaN'),
        ('turn_forward', 'up'), ('turn_backward', repeat('|', 40)), ('turn_forward', repeat('left;', 200))) v(name, value);

SELECT 'the lanes of a section tile it', bool_and(abs(area - ST_Area(s.surface)) < 1e-6 * area)
    FROM (SELECT edge_id, sum(ST_Area(surface)) AS area FROM lanes.lane GROUP BY edge_id) l JOIN lanes.section s USING (edge_id);
CREATE FUNCTION pg_temp.middles(axis bigint) RETURNS numeric[] LANGUAGE sql AS $$
  SELECT array_agg(round(l.axis_offset::numeric, 3) ORDER BY lane_position) FROM lanes.lane l JOIN lanes.edge USING (edge_id) WHERE axis_id = axis $$;
UPDATE lanes.axis SET width = 15 WHERE axis_id = 33;
SELECT FROM streetgen.generate('lanes') \g /dev/null
SELECT 'where the roadway is wider the rest lies beside them', pg_temp.widths(33) = '{4,8}' AND pg_temp.middles(33) = '{4,-2}' AND pg_temp.rules(33) IS NULL
    AND (SELECT array_agg(round(axis_offset::numeric, 3)) = '{2}' FROM lanes.lane_separator JOIN lanes.edge USING (edge_id) WHERE axis_id = 33);
UPDATE lanes.axis SET direction = 'reverse', kind_backward = kind_forward, lane_width_backward = lane_width_forward, kind_forward = NULL, lane_width_forward = NULL WHERE axis_id = 33;
SELECT FROM streetgen.generate('lanes') \g /dev/null
SELECT 'also against the line', pg_temp.widths(33) = '{8,4}' AND pg_temp.middles(33) = '{2,-4}';
UPDATE lanes.axis SET kind_backward = 'general|cycle', lane_width_backward = '3|' WHERE axis_id = 33;
SELECT FROM streetgen.generate('lanes') \g /dev/null
SELECT 'a cycle lane without a width has its usual one', pg_temp.widths(33) = '{1.5,3}';
UPDATE lanes.axis SET lane_width_backward = '|2' WHERE axis_id = 33;
SELECT FROM streetgen.generate('lanes') \g /dev/null
SELECT 'a lane of unknown width takes what is left', pg_temp.widths(33) = '{2,13}';
UPDATE lanes.axis SET width = 6, direction = 'direct', kind_forward = 'general|general', lane_width_forward = '4|8', kind_backward = NULL, lane_width_backward = NULL WHERE axis_id = 33;
SELECT FROM streetgen.generate('lanes') \g /dev/null
SELECT 'lanes stay inside a street that widens', (SELECT bool_and(ST_CoveredBy(l.geom, ST_Buffer(s.surface, 1e-6))) FROM lanes.lane l JOIN lanes.section s USING (edge_id) JOIN lanes.edge USING (edge_id) WHERE axis_id = 40)
    AND (SELECT abs(ST_Distance(ST_StartPoint(l.geom), ST_StartPoint(e.geom)) - 2.25) < 1e-6 AND abs(ST_Distance(ST_EndPoint(l.geom), ST_EndPoint(e.geom)) - 5.25) < 1e-6 FROM lanes.lane l JOIN lanes.edge e USING (edge_id) WHERE axis_id = 40 AND ordinality = 4);
SELECT 'between n lanes there are n - 1 lines', bool_and(separators = lanes - 1)
    FROM (SELECT edge_id, count(*) AS lanes FROM lanes.lane GROUP BY edge_id) l JOIN (SELECT edge_id, count(lane_separator_id) AS separators FROM lanes.edge LEFT JOIN lanes.lane_separator USING (edge_id) GROUP BY edge_id) s USING (edge_id);
SELECT 'one of them parts the directions', (SELECT array_agg(kind ORDER BY lane_position) = '{same_direction,centre,same_direction}' FROM lanes.lane_separator JOIN lanes.edge USING (edge_id) WHERE axis_id = 8);
SELECT 'arrows point the way of the traffic', bool_and(CASE WHEN l.along_axis THEN ST_X(ST_EndPoint(m.geom)) > ST_X(ST_StartPoint(m.geom)) ELSE ST_X(ST_EndPoint(m.geom)) < ST_X(ST_StartPoint(m.geom)) END)
    FROM lanes.marking m JOIN lanes.lane l USING (edge_id, lane_position) WHERE m.kind = 'arrow';
SELECT 'arrows lie on their lanes', bool_and(ST_CoveredBy(m.geom, ST_Buffer(l.surface, 1e-6))) FROM lanes.marking m JOIN lanes.lane l USING (edge_id, lane_position) WHERE m.kind = 'arrow';
SELECT 'parking lanes have no arrow', NOT EXISTS (SELECT FROM lanes.marking m JOIN lanes.lane l USING (edge_id, lane_position) WHERE m.kind = 'arrow' AND l.kind = 'parking');
SELECT 'paint is valid', bool_and(ST_IsValid(surface)) FROM (SELECT surface FROM lanes.marking UNION ALL SELECT surface FROM lanes.lane_separator) p;
SELECT 'the model has no error', count(*) = 0 FROM streetgen.check_model('lanes') WHERE severity = 'error';
SELECT 'a summary counts lanes by kind', (SELECT amount = 6 FROM streetgen.summary('lanes') WHERE subject = 'lanes, cycle');
SELECT 'a drawing shows paint', streetgen.svg('lanes', (SELECT ST_Expand(m.geom, 10) FROM lanes.marking m WHERE kind = 'arrow' LIMIT 1), scale => 1000) ~ '"(lane_separator|(rim_)?marking)"' AND streetgen.svg('lanes', width => 100) !~ '"(lane_separator|(rim_)?marking)"';

-- By hand.
CREATE TABLE lane_before AS SELECT l.*, e.axis_id FROM lanes.lane l JOIN lanes.edge e USING (edge_id);
CREATE TABLE content_before AS SELECT * FROM test.content('lanes');
INSERT INTO lanes.lane_override (axis_id, abscissa, ordinality, along_axis, width) VALUES (3, 50, 2, false, NULL), (6, 99, 1, NULL, 4), (6, 50, 9, true, NULL), (6, 500, 1, true, NULL), (999, 1, 1, true, NULL);
SELECT 'axes of overrides that generate has not seen are stale', (SELECT array_agg(id ORDER BY id) = '{3,6}' FROM streetgen.check_model('lanes') WHERE rule LIKE 'stale: the axis changed%');
SELECT 'overrides of lanes that are not there stay and are named', (SELECT count(*) = 3 FROM streetgen.check_model('lanes') WHERE rule = 'lane override without its lane');
SELECT 'an override changes its lane and those that share the roadway', (SELECT updated BETWEEN 2 AND 4 FROM streetgen.generate('lanes', '{3,6}') WHERE relation = 'lane');
SELECT 'a lane turned by hand', pg_temp.ways(3) = 'ff';
SELECT 'a lane widened by hand', pg_temp.widths(6) = '{2.5,4,2.5}';
SELECT 'they say so', (SELECT count(*) = 2 FROM lanes.lane WHERE method = 'by_hand');
SELECT 'lanes keep their ids', NOT EXISTS (SELECT FROM lane_before b WHERE NOT EXISTS (SELECT FROM lanes.lane l JOIN lanes.edge e USING (edge_id) WHERE (l.lane_id, e.axis_id, l.ordinality) = (b.lane_id, b.axis_id, b.ordinality)));
UPDATE lanes.axis SET geom = ST_Translate(geom, 5, 0), width = 10 WHERE axis_id = 6;
SELECT 'overrides survive a change of the axis', bool_and(fallbacks >= 0) AND pg_temp.widths(6) = '{3,4,3}' FROM streetgen.generate('lanes');
SELECT 'and a run over all', bool_and(inserted + updated + deleted = 0) AND pg_temp.ways(3) = 'ff' FROM streetgen.generate('lanes');
UPDATE lanes.axis SET geom = ST_Translate(geom, -5, 0), width = 9 WHERE axis_id = 6;
DELETE FROM lanes.lane_override;
SELECT 'so they are once these are gone', (SELECT array_agg(id ORDER BY id) = '{3,6}' FROM streetgen.check_model('lanes') WHERE rule LIKE 'stale: the axis changed%');
SELECT 'without overrides all is as it was', (SELECT count(*) > 0 FROM streetgen.generate('lanes')) AND NOT EXISTS ((SELECT * FROM test.content('lanes') EXCEPT ALL SELECT * FROM content_before) UNION ALL (SELECT * FROM content_before EXCEPT ALL SELECT * FROM test.content('lanes')));
SELECT 'an override needs a place', test.state('INSERT INTO lanes.lane_override (axis_id, abscissa, ordinality) VALUES (1, ''NaN'', 1)') = '23514'
    AND test.state('INSERT INTO lanes.lane_override (axis_id, abscissa, ordinality, width) VALUES (1, 1, 1, ''NaN'')') = '23514';

-- Opened to both directions by hand, and by settings.
INSERT INTO lanes.lane_override (axis_id, abscissa, ordinality, along_axis, both_ways) VALUES (3, 50, 1, NULL, true), (10, 50, 1, false, NULL), (54, 50, 1, true, false);
DO $$ BEGIN PERFORM streetgen.generate('lanes'); END $$;
SELECT 'a lane opened to both directions, others closed to one', pg_temp.ways(3) = 'bt' AND pg_temp.ways(10) = 'f' AND pg_temp.ways(54) = 'tft';
UPDATE lanes.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (3, 10);
DO $$ BEGIN PERFORM streetgen.generate('lanes'); END $$;
SELECT 'they keep their place and way when the axis is turned round', pg_temp.ways(3) = 'fb' AND pg_temp.ways(10) = 't';
UPDATE lanes.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (3, 10);
DELETE FROM lanes.lane_override;
DO $$ BEGIN PERFORM streetgen.set('lanes', 'two_way_width_minimal', '0'); PERFORM streetgen.generate('lanes'); END $$;
SELECT 'a width of zero leaves two lanes to narrow streets', pg_temp.ways(50) || ' ' || pg_temp.ways(10) = 'ft b';
DO $$ BEGIN PERFORM streetgen.set('lanes', 'two_way_width_minimal', '4.5'); PERFORM streetgen.generate('lanes'); END $$;

-- Fewer lanes than before, other numbers, another side of the road.
UPDATE lanes.axis SET lane_count = 2 WHERE axis_id = 8;
SELECT 'lanes that are gone are deleted', (SELECT deleted = 2 FROM streetgen.generate('lanes', '{8}') WHERE relation = 'lane') AND pg_temp.ways(8) = 'ft';
DELETE FROM lanes.axis WHERE axis_id = 9;
SELECT 'so are those of an axis that is gone', (SELECT count(*) > 0 FROM streetgen.generate('lanes', '{9}')) AND pg_temp.ways(9) IS NULL;
DO $$ BEGIN PERFORM streetgen.set('lanes', 'lane_order', 'right_first'); PERFORM streetgen.generate('lanes'); END $$;
SELECT 'lanes numbered from the right, as in the paper', pg_temp.ways(3) || ' ' || pg_temp.ways(6) = 'tf btf';
DO $$ BEGIN PERFORM streetgen.set('lanes', 'lane_order', 'left_first'); PERFORM streetgen.set('lanes', 'driving_side', 'left'); PERFORM streetgen.set('lanes', 'edge_line', 'solid'); PERFORM streetgen.generate('lanes'); END $$;
SELECT 'on the left side of the road', pg_temp.ways(3) = 'tf' AND pg_temp.kinds(30) = 'general+ general+ cycle+ parking+ bus- general-';
SELECT 'lines along the kerbs', (SELECT array_agg(kind ORDER BY lane_position) = '{edge,centre,edge}' FROM lanes.lane_separator JOIN lanes.edge USING (edge_id) WHERE axis_id = 3);
DO $$ BEGIN PERFORM streetgen.drop_model('lanes'); END $$;

-- Edges whose limits cross: two wide streets 10 m apart on a third.
DO $$ BEGIN
  PERFORM streetgen.create_model('crossed', 2154);
  INSERT INTO crossed.axis (axis_id, geom, width, lane_count) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 2), (2, 'SRID=2154;LINESTRING(650100 6860000,650110 6860000)', 7, 2),
    (3, 'SRID=2154;LINESTRING(650110 6860000,650210 6860000)', 7, 2), (4, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 14, 4), (5, 'SRID=2154;LINESTRING(650110 6860000,650110 6859900)', 14, 4);
  PERFORM streetgen.generate('crossed');
END $$;
SELECT 'an edge with crossed limits keeps its lanes', (SELECT count(*) = 2 AND bool_and(method = 'crossed_limits' AND ST_IsEmpty(l.surface)) FROM crossed.lane l JOIN crossed.edge USING (edge_id) WHERE axis_id = 2);
SELECT 'they lie where the limits meet, in the direction of the axis', (SELECT bool_and(ST_Distance(l.geom, a.border_line) < 1e-6 AND ST_X(ST_EndPoint(l.geom)) > ST_X(ST_StartPoint(l.geom)) AND ST_Length(l.geom) < 0.011
        AND abs(x.start_abscissa - ST_X(ST_StartPoint(l.geom)) + 650100) < 1e-6 AND abs(x.end_abscissa - ST_X(ST_EndPoint(l.geom)) + 650100) < 1e-6)
    FROM crossed.lane l JOIN crossed.edge e USING (edge_id) JOIN crossed.lane_extent x USING (lane_id) JOIN crossed.section_limit a ON a.edge_id = e.edge_id AND a.which = 'start' WHERE e.axis_id = 2);
SELECT 'they bear no paint', NOT EXISTS (SELECT FROM crossed.marking JOIN crossed.edge USING (edge_id) WHERE axis_id = 2) AND (SELECT bool_and(ST_IsEmpty(p.surface)) FROM crossed.lane_separator p JOIN crossed.edge USING (edge_id) WHERE axis_id = 2);
DO $$ BEGIN PERFORM streetgen.drop_model('crossed'); END $$;

-- Past a side street: three lanes go on as two.
DO $$ BEGIN
  PERFORM streetgen.create_model('tapered', 2154, driving_side => 'right');
  INSERT INTO tapered.axis (axis_id, geom, width, lane_count, direction, speed) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 10.5, 3, 'direct', 90), (2, 'SRID=2154;LINESTRING(650200 6860000,650400 6860000)', 7, 2, 'direct', 90),
    (3, 'SRID=2154;LINESTRING(650200 6860000,650200 6860100)', 6, 2, 'both', 50);
  PERFORM streetgen.generate('tapered');
END $$;
CREATE FUNCTION pg_temp.widths_at(axis bigint, at_start boolean) RETURNS numeric[] LANGUAGE sql AS $$
  WITH line AS (SELECT lane_position AS p, CASE WHEN at_start THEN ST_StartPoint(l.geom) ELSE ST_EndPoint(l.geom) END AS place FROM tapered.lane l JOIN tapered.edge USING (edge_id) WHERE axis_id = axis),
  kerb AS (SELECT ST_PointN(border_line, 1) AS place FROM tapered.section_limit JOIN tapered.edge USING (edge_id) WHERE axis_id = axis AND which = CASE WHEN at_start THEN 'start' ELSE 'end' END)
  -- A middle is half a width beyond the lanes before it, so widths add up by turns.
  SELECT array_agg(round(width::numeric, 3) ORDER BY p) FROM (
    SELECT n AS p, edge - coalesce(lag(edge) OVER (ORDER BY n), 0) AS width FROM (
      SELECT a.p AS n, 2 * sum(CASE WHEN (a.p - b.p) % 2 = 0 THEN 1 ELSE -1 END * ST_Distance(b.place, kerb.place)) AS edge FROM line a JOIN line b ON b.p <= a.p CROSS JOIN kerb GROUP BY a.p) e) w $$;
SELECT 'lanes are as wide as their street', pg_temp.widths_at(1, true) = '{3.5,3.5,3.5}' AND pg_temp.widths_at(2, false) = '{3.5,3.5}' AND (SELECT bool_and(abs(l.width - 3.5) < 1e-9) FROM tapered.lane l JOIN tapered.edge USING (edge_id) WHERE axis_id < 3);
SELECT 'the outer lane ends along the taper, the others keep their width', w[1:2] = '{3.5,3.5}' AND w[3] BETWEEN 2 AND 3.4 FROM pg_temp.widths_at(1, false) w;
SELECT 'beside it the lane that goes on is wider', w[1] = 3.5 AND w[2] BETWEEN 3.6 AND 5 FROM pg_temp.widths_at(2, true) w;
SELECT 'lanes tile their section', bool_and(abs(area - ST_Area(surface)) < 1e-6) FROM (SELECT edge_id, sum(ST_Area(surface)) AS area FROM tapered.lane GROUP BY edge_id) l JOIN tapered.section USING (edge_id);
DO $$ BEGIN UPDATE tapered.axis SET turn_forward = 'left|through|through' WHERE axis_id = 1; END $$;
SELECT 'a lane that turns off ends on its side', w[1] BETWEEN 2 AND 3.4 AND w[2:3] = '{3.5,3.5}' FROM pg_temp.widths_at(1, false) w;
DO $$ BEGIN UPDATE tapered.axis SET turn_forward = NULL WHERE axis_id = 1; UPDATE tapered.axis SET lane_count = 3 WHERE axis_id = 2; END $$;
SELECT 'lanes that all go on share the change, here and beyond', a[1] = a[3] AND a[1] < 3.5 AND b[1] = b[3] AND b[1] > 2.334 FROM pg_temp.widths_at(1, false) a, pg_temp.widths_at(2, true) b;
DO $$ BEGIN PERFORM streetgen.drop_model('tapered'); END $$;

-- Alone.
SELECT 'with one for both directions', (SELECT array_agg((along_axis, both_ways, round(lane_width::numeric, 2))::text ORDER BY lane_position) = '{"(f,f,3.00)","(t,t,3.00)","(t,f,3.00)"}' FROM streetgen.lanes('LINESTRING(0 0,50 0)', 9, lanes_both => 1))
    AND (SELECT count(*) = 1 AND bool_and(both_ways) FROM streetgen.lanes('LINESTRING(0 0,50 0)', 3.5, 0, 0, lanes_both => 1));
SELECT 'lanes of a line alone', (SELECT array_agg(along_axis ORDER BY ordinality) = '{t,f,t}' AND array_agg(ST_Length(geom) ORDER BY ordinality) = '{50,50,50}' FROM streetgen.lanes('SRID=2154;LINESTRING(0 0,50 0)', 9, 2, 1));
SELECT 'they tile the roadway of a bend', (SELECT abs(sum(ST_Area(surface)) - ST_Area(streetgen.section_surface('LINESTRING(0 0,50 0,50 50)', 9, 0, 100))) < 1e-6 FROM streetgen.lanes('LINESTRING(0 0,50 0,50 50)', 9, 2, 1));
SELECT 'an offset line', ST_AsText(streetgen.offset_line('LINESTRING(0 0,50 0,50 50)', 2)) = 'LINESTRING(0 2,48 2,48 50)' AND ST_AsText(streetgen.offset_line('LINESTRING(0 0,50 0)', 2, -1)) = 'LINESTRING(0 2,50 -1)';
SELECT format('%s is refused', statement), test.state(statement) = '22023' FROM (VALUES
    ($$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 'NaN')$$), ($$SELECT streetgen.lanes('POINT(0 0)', 7)$$), ($$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, 99)$$),
    ($$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, kind_forward => 'tram')$$), ($$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, lane_order => 'any')$$),
    ($$SELECT streetgen.offset_line('LINESTRING(0 0,50 0)', 'Infinity')$$), ($$SELECT streetgen.offset_line('LINESTRING EMPTY', 1)$$)) s(statement);

SELECT format('%s is named', argument), test.said(statement) LIKE argument || ' is %' FROM (VALUES ('width', $$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 0)$$), ('lanes_forward', $$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, -1)$$),
    ('lanes_backward', $$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, 1, 41)$$), ('lanes_both', $$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, lanes_both => 41)$$), ('axis_offset', $$SELECT streetgen.offset_line('LINESTRING(0 0,50 0)', 201)$$), ('offset_end', $$SELECT streetgen.offset_line('LINESTRING(0 0,50 0)', 1, 201)$$)) s(argument, statement);
SELECT format('widths for another number of lanes are refused: %s', widths), test.state(format($$SELECT streetgen.lanes('LINESTRING(0 0,50 0)', 7, kind_forward => 'general|general|cycle', lane_width_forward => %L)$$, widths)) = '22023' FROM unnest('{3,3|3|1|2}'::text[]) widths;
SELECT format('those of all lanes or of the driving lanes are not: %s', widths), (SELECT count(*) = 4 FROM streetgen.lanes('LINESTRING(0 0,50 0)', 7, kind_forward => 'general|general|cycle', lane_width_forward => widths)) FROM unnest('{3|3,3|3|1,""}'::text[]) widths;

-- Estimates of what is no width, no number of lanes.
SELECT 'no lanes of no width', bool_and(streetgen.estimated_lane_count(w, 50, l) IS NULL) FROM (VALUES ('NaN'::float8, 3.5), (7, 0), (7, 'NaN'), ('-Infinity', 3.5), (1e300, 1e-300)) v(w, l);
SELECT 'nor kinds of too many', bool_and(streetgen.lane_kinds(n, NULL, true, 'right', true, false, false, false) IS NULL) FROM unnest('{-1,41,2147483647,NULL}'::integer[]) n;
SELECT 'at most thirty lanes', streetgen.estimated_lane_count(200, 50, 1) = 30;
