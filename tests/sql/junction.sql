\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
\ir shared/switch.sql
-- Junctions of several nodes: their members, kinds, surfaces and paths; edits, hands, clusters and the subject itself.  (name, holds)
-- A two-way street crosses a dual carriageway; beside it streets that are no carriageways.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction}'), streetgen.create_model('anew', 2154, subjects => '{junction}');
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('bare', 2154);
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, name) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(649800 6860000,650000 6860000,650200 6860000)', 7, 2, 'direct', 2, 'avenue'), (2, 'SRID=2154;LINESTRING(650200 6860020,650000 6860020,649800 6860020)', 7, 2, 'direct', 2, 'avenue'),
    (3, 'SRID=2154;LINESTRING(650000 6859800,650000 6860000)', 7, 2, 'both', 3, 'lane'), (4, 'SRID=2154;LINESTRING(650000 6860000,650000 6860020)', 7, 2, 'both', 3, 'lane'),
    (5, 'SRID=2154;LINESTRING(650000 6860020,650000 6860200)', 7, 2, 'both', 3, 'lane'), (6, 'SRID=2154;LINESTRING(650000 6859900,650200 6859900)', 6, 2, 'both', 3, 'side');
END $$;
CREATE FUNCTION several() RETURNS bigint LANGUAGE sql AS $$ SELECT count(*) FROM (SELECT FROM town.junction_node GROUP BY junction_id HAVING count(*) > 1) j $$;
CREATE FUNCTION kinds() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(format('%s %s', n, kind), ', ' ORDER BY kind) FROM (SELECT kind, count(*) AS n FROM town.junction GROUP BY kind) k $$;
SELECT 'a new model has no junctions unless told so' AS name, to_regclass('bare.junction') IS NULL AS holds;
SELECT 'two carriageways and the street across are one junction', several() = 1 AND (SELECT array_agg(axis_id) = '{4}' FROM town.junction_edge JOIN town.edge USING (edge_id) WHERE role = 'inside');
SELECT 'each node of degree three and more lies in one', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule LIKE 'node of degree three%');
SELECT 'its smallest node names it', (SELECT bool_and(junction_id = least) FROM (SELECT junction_id, min(node_id) AS least FROM town.junction_node GROUP BY junction_id) j);
SELECT 'kinds come of the arms', kinds() = '7 end, 2 priority';
SELECT 'its surface is one piece', (SELECT ST_NumGeometries(surface) = 1 FROM town.junction WHERE method = 'grouped');
SELECT 'of the ground of its nodes and the edge inside', (SELECT abs(ST_Area(j.surface) - (SELECT sum(ST_Area(surface)) FROM (
    SELECT surface FROM town.intersection JOIN town.junction_node n USING (node_id) WHERE n.junction_id = j.junction_id
    UNION ALL SELECT surface FROM town.section JOIN town.junction_edge e USING (edge_id) WHERE e.junction_id = j.junction_id) s)) < 1e-6 FROM town.junction j WHERE method = 'grouped');
SELECT 'every edge links two junctions or lies in one', (SELECT count(*) FROM town.edge) = (SELECT count(*) FROM town.junction_link) + (SELECT count(*) FROM town.junction_edge);
-- Paths across.
CREATE VIEW pg_temp.across AS SELECT m.*, a.axis_id AS axis_in, b.axis_id AS axis_out, CASE WHEN along_in THEN i.geom ELSE ST_Reverse(i.geom) END AS line_in, CASE WHEN along_out THEN o.geom ELSE ST_Reverse(o.geom) END AS line_out
  FROM town.junction_movement m JOIN town.lane i ON i.lane_id = lane_in JOIN town.edge a ON a.edge_id = i.edge_id JOIN town.lane o ON o.lane_id = lane_out JOIN town.edge b ON b.edge_id = o.edge_id;
SELECT 'paths begin and end on their lanes', bool_and(ST_Distance(ST_EndPoint(line_in), ST_StartPoint(geom)) < 1e-6 AND ST_Distance(ST_StartPoint(line_out), ST_EndPoint(geom)) < 1e-6) FROM pg_temp.across;
SELECT 'and go on as they do', bool_and(abs(sin(ST_Azimuth(ST_PointN(line_in, -2), ST_EndPoint(line_in)) - ST_Azimuth(ST_StartPoint(geom), ST_PointN(geom, 2)))) < 1e-6
  AND abs(sin(ST_Azimuth(ST_StartPoint(line_out), ST_PointN(line_out, 2)) - ST_Azimuth(ST_PointN(geom, -2), ST_EndPoint(geom)))) < 1e-6) FROM pg_temp.across;
SELECT 'on the surface of the junction', bool_and(ST_Length(ST_Difference(m.geom, ST_Buffer(j.surface, 1e-3))) < 0.01) FROM pg_temp.across m JOIN town.junction j USING (junction_id) WHERE m.plausible;
SELECT 'a turn over two nodes is one path', (SELECT bool_or(turn = 'left' AND plausible) FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 5));
SELECT 'with the paths at single nodes on its way', (SELECT bool_and(cardinality(interconnections) >= 2) FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 5));
SELECT 'nobody drives against a carriageway', NOT EXISTS (SELECT FROM pg_temp.across WHERE (axis_in = 1 AND ST_X(ST_EndPoint(line_in)) > 650000) OR (axis_out = 2 AND ST_X(ST_StartPoint(line_out)) > 650000));
SELECT 'lanes and directions name a movement', count(*) = count(DISTINCT (lane_in, lane_out, along_in, along_out)) FROM town.movement;
SELECT 'every way across is one, and no path inside is', NOT EXISTS (SELECT FROM town.movement m JOIN town.lane l ON l.lane_id IN (lane_in, lane_out) JOIN town.junction_edge USING (edge_id));
SELECT 'conflicts know paths across', EXISTS (SELECT FROM town.conflict WHERE junction_movement_a IS NOT NULL AND kind = 'crossing' AND ST_Intersects(geom, (SELECT ST_Buffer(surface, 0.1) FROM town.junction WHERE method = 'grouped')));
SELECT 'and those at single nodes', EXISTS (SELECT FROM town.conflict WHERE interconnection_a IS NOT NULL);
SELECT 'the less important street waits', (SELECT array_agg(DISTINCT rule ORDER BY rule) = '{yield}' FROM town.right_of_way JOIN town.lane ON lane_id = lane_in JOIN town.edge USING (edge_id) WHERE axis_id = 5)
  AND (SELECT bool_and(rule = 'priority') FROM town.right_of_way JOIN town.lane ON lane_id = lane_in JOIN town.edge USING (edge_id) WHERE axis_id = 1);
SELECT 'lines are painted at the rim', NOT EXISTS (SELECT FROM town.rim_marking JOIN town.edge USING (edge_id) WHERE axis_id = 4) AND EXISTS (SELECT FROM town.rim_marking WHERE kind = 'yield');
INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind) VALUES (1, 4, 'SRID=2154;POINT(650000 6860000)', 'no');
SELECT 'a restriction at one node holds for the whole turn', (SELECT bool_and(NOT plausible AND reason = 'restriction') FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 5));
DELETE FROM town.turn_restriction;
-- Via axes.
INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind, via_axes, via_geom, to_geom) VALUES (1, 2, 'SRID=2154;POINT(650000 6860000)', 'no', '{4}', 'SRID=2154;MULTIPOINT(650000 6860010)', 'SRID=2154;POINT(650000 6860020)');
SELECT 'one via an axis forbids the turn over it, and no other', (SELECT bool_and(NOT plausible AND reason = 'restriction') FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 2)) AND (SELECT bool_or(plausible) FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 5)) AND test.followed('town', 'anew');
SELECT 'no path at a single node is bound by it', NOT EXISTS (SELECT FROM town.interconnection WHERE reason = 'restriction') AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'turn_restriction');
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860008)' WHERE axis_id = 4;
INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, name) OVERRIDING SYSTEM VALUE VALUES (14, 'SRID=2154;LINESTRING(650000 6860008,650000 6860020)', 7, 2, 'both', 3, 'lane');
SELECT 'a split via axis is found by its place', (SELECT via_axes = '{14}' FROM town.turn_restriction) AND (SELECT bool_and(reason = 'restriction') FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 2)) AND test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id = 14;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860020)' WHERE axis_id = 4;
SELECT 'and made one again', (SELECT via_axes = '{4}' FROM town.turn_restriction);
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650200 6860020,650000 6860020,649950 6860020)' WHERE axis_id = 2;
INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, name) OVERRIDING SYSTEM VALUE VALUES (12, 'SRID=2154;LINESTRING(649950 6860020,649800 6860020)', 7, 2, 'direct', 2, 'avenue');
SELECT 'what it leads to stays the piece at its place', (SELECT to_axis = 2 FROM town.turn_restriction);
DELETE FROM town.axis WHERE axis_id = 12;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650200 6860020,650000 6860020,649800 6860020)' WHERE axis_id = 2;
-- A node of the restriction is dragged, axis by axis and all at once, and dragged back; then the junction as a whole.
CREATE TABLE drawn AS SELECT axis_id, geom FROM town.axis;
CREATE FUNCTION pg_temp.drag(axes bigint[], x float8, y float8, dx float8, dy float8) RETURNS void LANGUAGE sql AS $$
  UPDATE town.axis a SET geom = (SELECT ST_MakeLine(CASE WHEN ST_DWithin(d.geom, ST_SetSRID(ST_MakePoint(x, y), 2154), 1e-6) THEN ST_Translate(d.geom, dx, dy) ELSE d.geom END ORDER BY d.path) FROM ST_DumpPoints(a.geom) d) WHERE axis_id = ANY (axes) $$;
CREATE FUNCTION pg_temp.held() RETURNS boolean LANGUAGE sql AS $$
  SELECT (SELECT bool_and(NOT plausible AND reason = 'restriction') FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 2)) AND (SELECT (from_axis, via_axes, to_axis) = (1, '{4}'::bigint[], 2) FROM town.turn_restriction)
    AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'turn_restriction') $$;
DO $$ BEGIN PERFORM pg_temp.drag('{1}', 650000, 6860000, 1, -2); PERFORM pg_temp.drag('{3}', 650000, 6860000, 1, -2); PERFORM pg_temp.drag('{4}', 650000, 6860000, 1, -2); END $$;
SELECT 'a restriction via an axis goes with its first node', pg_temp.held() AND (SELECT ST_DWithin(geom, 'SRID=2154;POINT(650001 6859998)', 1e-6) AND ST_DWithin(via_geom, (SELECT geom FROM town.axis WHERE axis_id = 4), 1.5) FROM town.turn_restriction) AND test.followed('town', 'anew');
SELECT pg_temp.drag('{2,4,5}', 650000, 6860020, -2, 2) \g /dev/null
SELECT 'and with its last', pg_temp.held() AND (SELECT ST_DWithin(to_geom, 'SRID=2154;POINT(649998 6860022)', 1e-6) AND ST_DWithin(via_geom, (SELECT geom FROM town.axis WHERE axis_id = 4), 1.5) FROM town.turn_restriction) AND test.followed('town', 'anew');
UPDATE town.axis a SET geom = ST_Translate(d.geom, 60, 45) FROM drawn d WHERE d.axis_id = a.axis_id;
SELECT 'and with all of the junction', pg_temp.held() AND (SELECT ST_DWithin(geom, 'SRID=2154;POINT(650060 6860045)', 1e-6) AND ST_DWithin(to_geom, 'SRID=2154;POINT(650060 6860065)', 1e-6) AND ST_DWithin(via_geom, (SELECT geom FROM town.axis WHERE axis_id = 4), 1.5) FROM town.turn_restriction) AND test.followed('town', 'anew');
UPDATE town.axis a SET geom = d.geom FROM drawn d WHERE d.axis_id = a.axis_id;
UPDATE town.turn_restriction SET geom = 'SRID=2154;POINT(650000 6860004)';
SELECT 'one off its node is told', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'turn restriction without a place');
UPDATE town.turn_restriction SET geom = 'SRID=2154;POINT(650000 6860000)', to_geom = 'SRID=2154;POINT(650000 6860016)';
SELECT 'at either end', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'turn restriction without a place');
UPDATE town.turn_restriction SET to_geom = 'SRID=2154;POINT(650000 6860020)';
UPDATE town.turn_restriction SET kind = 'only', to_axis = 5;
SELECT 'only that way forbids all others', (SELECT bool_and((axis_out = 5) = plausible) FROM pg_temp.across WHERE axis_in = 1 AND ST_X(ST_EndPoint(line_in)) < 650000) AND (SELECT bool_or(plausible) FROM pg_temp.across WHERE axis_in = 3) AND test.followed('town', 'anew');
UPDATE town.turn_restriction SET via_axes = '{3}', via_geom = 'SRID=2154;MULTIPOINT(650000 6859850)';
SELECT 'one via an axis outside is told', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'turn restriction via axes outside a junction, not obeyed') AND (SELECT bool_or(plausible) FROM pg_temp.across WHERE (axis_in, axis_out) = (1, 1));
SELECT 'each axis has its place', test.state($$UPDATE town.turn_restriction SET via_axes = '{3,4}'$$) = '23514' AND test.state($$UPDATE town.turn_restriction SET to_geom = NULL$$) = '23514';
DELETE FROM town.turn_restriction;
-- Edits.
SELECT 'a second run changes nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(649985 6860000)', 'signals');
SELECT 'signals of one arm make it a junction with signals', kinds() = '7 end, 1 priority, 1 signals' AND (SELECT bool_and(rule = 'signals') FROM town.right_of_way JOIN town.junction USING (junction_id) WHERE kind = 'signals');
DELETE FROM town.control_point;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650200 6860060,650000 6860060,649800 6860060)' WHERE axis_id = 2;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860060)' WHERE axis_id = 4;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860060,650000 6860200)' WHERE axis_id = 5;
SELECT 'carriageways drawn apart are two junctions', several() = 0 AND NOT EXISTS (SELECT FROM town.junction_movement) AND test.followed('town', 'anew');
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650200 6860020,650000 6860020,649800 6860020)' WHERE axis_id = 2;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860020)' WHERE axis_id = 4;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860020,650000 6860200)' WHERE axis_id = 5;
SELECT 'drawn together they are one again', several() = 1 AND test.followed('town', 'anew');
UPDATE town.axis SET direction = 'both' WHERE axis_id = 2;
SELECT 'a carriageway of both directions is none', several() = 0 AND test.followed('town', 'anew');
UPDATE town.axis SET direction = 'direct' WHERE axis_id = 2;
-- Hands.
INSERT INTO town.junction_override (axis_id, geom, inside) VALUES (4, 'SRID=2154;POINT(650000 6860010)', false);
SELECT 'parted by hand they are two', several() = 0 AND test.followed('town', 'anew');
UPDATE town.junction_override SET inside = true, axis_id = 3, geom = 'SRID=2154;POINT(650000 6859950)';
SELECT 'an edge is inside by hand', (SELECT array_agg(DISTINCT axis_id ORDER BY axis_id) @> '{3}' FROM town.junction_edge JOIN town.edge USING (edge_id)) AND test.followed('town', 'anew');
UPDATE town.junction_override SET inside = NULL, kind = 'stop', axis_id = 6, geom = 'SRID=2154;POINT(650000 6859900)';
SELECT 'so is a kind', (SELECT kind = 'stop' AND method = 'by_hand' FROM town.junction WHERE ST_DWithin(geom, 'SRID=2154;POINT(650000 6859900)', 1)) AND test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id = 6;
SELECT 'an override whose axis is gone is told', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'junction override without its axis');
DELETE FROM town.junction_override;
INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (4, 'SRID=2154;POINT(650000 6860000)', 'stop'), (5, 'SRID=2154;POINT(650000 6860020)', 'ramp');
SELECT 'of two kinds the younger holds', (SELECT kind = 'ramp' FROM town.junction WHERE ST_DWithin(geom, 'SRID=2154;POINT(650000 6860010)', 1));
DELETE FROM town.junction_override;
-- Links that chain through half a city: thirty carriageways 20 m apart.
DO $$ BEGIN
  PERFORM streetgen.create_model('wide', 2154, subjects => '{junction}');
  INSERT INTO wide.axis (geom, width, lane_count, direction, importance, name) SELECT ST_SetSRID(CASE WHEN i % 2 = 0 THEN line ELSE ST_Reverse(line) END, 2154), 7, 2, 'direct', 2, 'avenue'
    FROM generate_series(0, 29) i, LATERAL (SELECT ST_MakeLine(ARRAY[ST_MakePoint(649900, 6860000 + 20 * i), ST_MakePoint(650000, 6860000 + 20 * i), ST_MakePoint(650100, 6860000 + 20 * i)]) AS line) l;
  INSERT INTO wide.axis (geom, width, lane_count, importance, name) SELECT ST_SetSRID(ST_MakeLine(array_agg(ST_MakePoint(650000, 6859980 + 20 * i) ORDER BY i)), 2154), 7, 2, 3, 'lane' FROM generate_series(0, 31) i;
END $$;
SELECT 'links that chain are parted by the extent', (SELECT count(*) > 5 AND max(width) <= 80 AND max(nodes) > 1 FROM (SELECT junction_id, count(*) AS nodes, ST_MaxDistance(ST_Collect(geom), ST_Collect(geom)) AS width FROM wide.junction_node JOIN wide.node USING (node_id) GROUP BY 1) j);
SELECT 'and told', (SELECT count(*) > 0 FROM streetgen.check_model('wide') WHERE rule = 'edge that junction_extent keeps out of a junction') AND NOT EXISTS (SELECT FROM streetgen.check_model('wide') WHERE severity = 'error');
DO $$ BEGIN PERFORM streetgen.drop_model('wide'); END $$;
-- Edit views.
CREATE VIEW pg_temp.side AS SELECT * FROM town.junction_editing WHERE ST_DWithin(geom, 'SRID=2154;POINT(650000 6860010)', 11);
CREATE VIEW pg_temp.link AS SELECT v.* FROM town.junction_edge_editing v JOIN town.edge USING (edge_id) WHERE axis_id = 4;
CREATE TABLE before AS SELECT * FROM pg_temp.side;
UPDATE town.junction_editing SET kind = 'stop' WHERE junction_id = (SELECT junction_id FROM pg_temp.side);
SELECT 'a kind typed is that of the junction, a row for each of its nodes', (SELECT kind = 'stop' AND by_hand FROM pg_temp.side) AND (SELECT count(*) = 2 FROM town.junction_override) AND test.followed('town', 'anew');
CREATE VIEW pg_temp.painted AS SELECT m.kind, axis_id, count(*) AS lines FROM town.rim_marking m JOIN town.edge USING (edge_id) JOIN town.junction_node USING (node_id) WHERE m.kind <> 'arrow' AND junction_id = (SELECT junction_id FROM pg_temp.side) GROUP BY m.kind, axis_id;
CREATE FUNCTION pg_temp.lines() RETURNS text LANGUAGE sql AS $$ SELECT coalesce(string_agg(format('%s %s %s', axis_id, kind, lines), ', ' ORDER BY axis_id, kind), 'none') FROM pg_temp.painted $$;
SELECT 'a junction of stop by hand has stop lines where the classes say who waits', pg_temp.lines() = '3 stop 1, 5 stop 1';
UPDATE town.junction_editing SET kind = 'signals' WHERE by_hand;
SELECT 'typed anew it is one decision', (SELECT kind = 'signals' AND by_hand FROM pg_temp.side) AND (SELECT count(*) = 2 FROM town.junction_override);
SELECT 'signals by hand have stop lines on all arms', pg_temp.lines() = '1 stop 2, 2 stop 2, 3 stop 1, 5 stop 1' AND test.followed('town', 'anew');
SELECT 'and so it is from scratch, and a second run changes nothing', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town'));
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (3, 4, 5);
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,649990 6859900,650000 6859800)' WHERE axis_id = 3;
SELECT 'streets turned round or redrawn keep them', pg_temp.lines() = '1 stop 2, 2 stop 2, 3 stop 1, 5 stop 1' AND test.followed('town', 'anew');
UPDATE town.axis a SET geom = d.geom FROM drawn d WHERE d.axis_id = a.axis_id AND a.axis_id IN (3, 4, 5);
UPDATE town.junction_editing SET kind = 'priority' WHERE by_hand;
SELECT 'priority by hand has yield lines', pg_temp.lines() = '3 yield 1, 5 yield 1' AND test.followed('town', 'anew');
UPDATE town.junction_editing SET kind = 'right_before_left' WHERE by_hand;
SELECT 'right before left by hand has no line', pg_temp.lines() = 'none' AND test.followed('town', 'anew') AND (SELECT bool_and(rule = 'right_before_left') FROM town.right_of_way WHERE junction_id = (SELECT junction_id FROM pg_temp.side));
INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(649985 6860000)', 'signals');
UPDATE town.junction_editing SET kind = 'stop' WHERE by_hand;
SELECT 'a kind by hand goes before signals of a source', pg_temp.lines() = '3 stop 1, 5 stop 1' AND test.followed('town', 'anew');
DELETE FROM town.control_point;
SELECT streetgen.live('town', false) \g /dev/null
UPDATE town.junction_override SET kind = 'signals';
SELECT 'a kind by hand that nobody follows is stale', streetgen._stale_axes('town') > 0 AND pg_temp.lines() = '3 stop 1, 5 stop 1';
SELECT streetgen.live('town', true) \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'until a run', pg_temp.lines() = '1 stop 2, 2 stop 2, 3 stop 1, 5 stop 1' AND test.followed('town', 'anew');
UPDATE town.junction_editing SET kind = kind;
SELECT 'what changes nothing writes nothing', (SELECT count(*) = 2 FROM town.junction_override) AND (SELECT kind = 'signals' FROM pg_temp.side);
DELETE FROM town.junction_editing WHERE by_hand;
SELECT 'and without it as the classes say', pg_temp.lines() = '3 yield 1, 5 yield 1';
DROP VIEW pg_temp.painted;
SELECT 'deleted it is as the classifier says', (SELECT s = b FROM pg_temp.side s, before b) AND NOT EXISTS (SELECT FROM town.junction_override);
UPDATE town.junction_editing SET by_hand = true WHERE junction_id = (SELECT junction_id FROM pg_temp.side);
UPDATE town.axis SET importance = 3 WHERE axis_id IN (1, 2);
SELECT 'by hand it stays what it was', (SELECT s.kind = b.kind FROM pg_temp.side s, before b);
UPDATE town.junction_editing SET kind = NULL WHERE by_hand;
SELECT 'no kind takes it back', (SELECT kind = 'priority' AND NOT by_hand FROM pg_temp.side);
UPDATE town.axis SET importance = 2 WHERE axis_id IN (1, 2);
UPDATE town.junction_edge_editing SET inside = false WHERE edge_id = (SELECT edge_id FROM pg_temp.link);
SELECT 'an edge put outside parts the junction', several() = 0 AND (SELECT NOT inside AND by_hand FROM pg_temp.link) AND test.followed('town', 'anew');
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 4;
SELECT 'and stays so turned round', several() = 0 AND (SELECT by_hand FROM pg_temp.link);
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650004 6860010,650000 6860020)' WHERE axis_id = 4;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650008 6860010,650000 6860020)' WHERE axis_id = 4;
SELECT 'and redrawn, where it lies on the axis', several() = 0 AND (SELECT bool_and(ST_DWithin(o.geom, a.geom, 1e-6)) FROM town.junction_override o JOIN town.axis a USING (axis_id));
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650008 6860010)' WHERE axis_id = 4;
INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, name) OVERRIDING SYSTEM VALUE VALUES (14, 'SRID=2154;LINESTRING(650008 6860010,650000 6860020)', 7, 2, 'both', 3, 'lane');
SELECT 'a split leaves it on a piece', (SELECT count(*) = 1 FROM town.junction_edge_editing v JOIN town.edge USING (edge_id) WHERE v.by_hand AND axis_id IN (4, 14)) AND test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id = 14;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860020)' WHERE axis_id = 4;
DELETE FROM town.junction_edge_editing WHERE by_hand;
SELECT 'taken back they are one again', several() = 1 AND NOT EXISTS (SELECT FROM town.junction_override) AND test.followed('town', 'anew');
UPDATE town.junction_edge_editing SET inside = true WHERE edge_id = (SELECT e.edge_id FROM town.edge e WHERE axis_id = 3 ORDER BY start_abscissa DESC LIMIT 1);
SELECT 'an edge put inside merges what is at its ends, whatever the extent', (SELECT count(*) = 3 FROM town.junction_node WHERE junction_id = (SELECT junction_id FROM town.junction WHERE method = 'grouped')) AND test.followed('town', 'anew');
UPDATE town.junction_edge_editing SET by_hand = false WHERE by_hand;
SELECT 'not by hand they are apart', (SELECT count(*) = 2 FROM town.junction_node WHERE junction_id = (SELECT junction_id FROM pg_temp.side));
SELECT 'an edit that means nothing is refused: ' || name, test.state(statement) = state FROM (VALUES
  ('a junction drawn', $$INSERT INTO town.junction_editing (kind) VALUES ('stop')$$, '0A000'), ('an edge drawn', 'INSERT INTO town.junction_edge_editing (inside) VALUES (true)', '0A000'),
  ('a crossing as an end', $$UPDATE town.junction_editing SET kind = 'end' WHERE junction_id = (SELECT junction_id FROM pg_temp.side)$$, '22023'),
  ('a crossing as a roundabout', $$UPDATE town.junction_editing SET kind = 'roundabout' WHERE junction_id = (SELECT junction_id FROM pg_temp.side)$$, '22023'),
  ('a crossing as a continuation', $$UPDATE town.junction_editing SET kind = 'continuation' WHERE junction_id = (SELECT junction_id FROM pg_temp.side)$$, '22023'),
  ('an end as a priority junction', $$UPDATE town.junction_editing SET kind = 'priority' WHERE kind = 'end'$$, '22023'),
  ('a row of kind end at a crossing', $$INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (4, 'SRID=2154;POINT(650000 6860001)', 'end')$$, '22023'),
  ('a row of kind stop at an end', $$INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (1, 'SRID=2154;POINT(649800 6860000)', 'priority')$$, '22023'),
  ('a row of a kind that is none', $$INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (4, 'SRID=2154;POINT(650000 6860000)', 'circus')$$, '23514'),
  ('a kind that is none', $$UPDATE town.junction_editing SET kind = 'circus'$$, '23514'),
  ('a junction moved', 'UPDATE town.junction_editing SET geom = ST_Translate(geom, 1, 1)', '0A000'), ('another key', 'UPDATE town.junction_editing SET junction_id = junction_id + 1', '0A000'),
  ('an edge moved', 'UPDATE town.junction_edge_editing SET geom = ST_Translate(geom, 1, 1)', '0A000'), ('another edge', 'UPDATE town.junction_edge_editing SET edge_id = edge_id + 1000', '0A000')) v(name, statement, state);
SELECT 'a kind that does not fit is named', test.said($$INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (4, 'SRID=2154;POINT(650000 6860001)', 'end')$$) LIKE 'junction % cannot be of kind end';
-- Where axis 30 goes on as axis 31 there is no junction yet.
INSERT INTO town.axis (axis_id, geom, width) VALUES (30, 'SRID=2154;LINESTRING(650000 6862000,650080 6862000)', 7), (31, 'SRID=2154;LINESTRING(650080 6862000,650160 6862040)', 7);
SELECT 'a place that is no junction yet refuses ' || kind, (r).state = '22023' AND (r).said LIKE 'node % cannot be of kind ' || kind AND (r).detail = 'It has 2 arms.' FROM unnest('{end,roundabout}'::text[]) kind,
  LATERAL (SELECT test.refusal(format('INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (30, ''SRID=2154;POINT(650080 6862000)'', %L)', kind)) AS r) t;
INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (30, 'SRID=2154;POINT(650080 6862000)', 'continuation');
SELECT 'and takes what fits', count(*) = 1 FROM town.junction WHERE kind = 'continuation' AND method = 'by_hand';
SELECT 'a row that is put elsewhere fits there too', test.state($$UPDATE town.junction_override SET geom = 'SRID=2154;POINT(650000 6862000)' WHERE axis_id = 30$$) = '22023';
DELETE FROM town.axis WHERE axis_id IN (30, 31);
DELETE FROM town.junction_override WHERE axis_id = 30;
SELECT 'one on an axis that is not there is taken', test.state($$INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (999, 'SRID=2154;POINT(650000 6860000)', 'end')$$) = 'none';
DELETE FROM town.junction_override WHERE axis_id = 999;
SELECT 'and says what it expects', test.said($$UPDATE town.junction_editing SET kind = 'circus'$$) LIKE 'the kind of junction % cannot be "circus"%';
DROP TABLE before;
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'what an axis leaves behind is as from scratch', test.followed('town', 'anew');
INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, name) OVERRIDING SYSTEM VALUE VALUES (1, 'SRID=2154;LINESTRING(649800 6860000,650000 6860000,650200 6860000)', 7, 2, 'direct', 2, 'avenue');
SELECT 'and what it brings', several() = 1 AND test.followed('town', 'anew');
-- Of two ways over single nodes as short as each other the same holds, whatever came first.
DO $$ BEGIN
  PERFORM streetgen.create_model('knot', 2154, subjects => '{junction}'), streetgen.create_model('knot_anew', 2154, subjects => '{junction}');
  INSERT INTO knot.axis (axis_id, geom, width, direction, importance, level) OVERRIDING SYSTEM VALUE VALUES
    (4, 'SRID=2154;LINESTRING(650001.8723 6860079.2607,650078.6366 6860114.2103)', 6.49, 'both', NULL, 1), (9, 'SRID=2154;LINESTRING(650045.5593 6860052.4244,650078.6366 6860114.2103)', 3.44, 'direct', 4, 0),
    (10, 'SRID=2154;LINESTRING(650045.5593 6860052.4244,650126.6923 6860048.6798)', 4.32, 'both', 4, 0), (12, 'SRID=2154;LINESTRING(650078.6366 6860114.2103,650069.8992 6860179.1167)', 3.08, 'reverse', NULL, 0),
    (13, 'SRID=2154;LINESTRING(650078.6366 6860114.2103,650114.2103 6860137.9261)', 19.43, 'direct', 5, 0), (17, 'SRID=2154;LINESTRING(650126.6923 6860048.6798,650172.8757 6860046.1834)', 10.03, 'both', 5, 0);
  UPDATE knot.axis a SET geom = (SELECT ST_MakeLine(CASE WHEN ST_DWithin(p.geom, 'SRID=2154;POINT(650078.6366 6860114.2103)', 1e-6) THEN 'SRID=2154;POINT(650172.8757 6860046.1834)' ELSE p.geom END ORDER BY path) FROM ST_DumpPoints(a.geom) p);
  INSERT INTO knot.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) VALUES ('SRID=2154;POINT(650172.8757 6860046.1834)', 9, 1, 13, 6, true);
END $$;
SELECT 'of two chains of paths the first by place holds', test.followed('knot', 'knot_anew');
DO $$ BEGIN PERFORM streetgen.drop_model('knot'), streetgen.drop_model('knot_anew'); END $$;
-- A ring that is joined by hand to one junction.
DO $$ BEGIN
  PERFORM streetgen.create_model('ringed', 2154, subjects => '{junction,roundabout}');
  INSERT INTO ringed.axis (axis_id, geom, width, lane_count, direction, importance, roundabout_tag) OVERRIDING SYSTEM VALUE SELECT 1 + q, ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(650000 + 14 * cosd(90 * q + 11.25 * i), 6860000 + 14 * sind(90 * q + 11.25 * i)) FROM generate_series(0, 8) i)), 2154), 6, 1, 'direct', 3, 'roundabout' FROM generate_series(0, 3) q;
  INSERT INTO ringed.axis (axis_id, geom, width, lane_count, importance) OVERRIDING SYSTEM VALUE SELECT 5 + q, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 14 * cosd(90 * q), 6860000 + 14 * sind(90 * q)), ST_MakePoint(650000 + 100 * cosd(90 * q), 6860000 + 100 * sind(90 * q))), 2154), 7, 2, 3 FROM generate_series(0, 3) q;
  UPDATE ringed.junction_edge_editing SET inside = true WHERE edge_id IN (SELECT edge_id FROM ringed.edge WHERE axis_id <= 4);
END $$;
SELECT 'a ring joined to one junction is a roundabout', count(*) = 1 AND bool_and(kind = 'roundabout' AND (SELECT count(*) = 4 FROM ringed.junction_node n WHERE n.junction_id = j.junction_id)) FROM ringed.junction j WHERE method = 'grouped';
SELECT 'who comes yields', count(*) = 12 AND bool_and(rule = 'yield') FROM ringed.right_of_way;
SELECT 'paths go round it without a kink', count(*) = 12 AND max((SELECT max(degrees(acos(greatest(-1, least(1, cos(ST_Azimuth(p, q) - ST_Azimuth(q, r))))))) FROM (SELECT geom AS p, lead(geom) OVER w AS q, lead(geom, 2) OVER w AS r FROM ST_DumpPoints(m.geom) WINDOW w AS (ORDER BY path)) t WHERE r IS NOT NULL)) < 20
  FROM ringed.junction_movement m WHERE plausible;
UPDATE ringed.junction_editing SET kind = 'signals' WHERE kind = 'roundabout';
UPDATE ringed.junction_editing SET kind = 'roundabout' WHERE kind = 'signals';
SELECT 'and may be one by hand', count(*) = 1 FROM ringed.junction WHERE kind = 'roundabout' AND method = 'by_hand';
DO $$ BEGIN PERFORM streetgen.drop_model('ringed'); END $$;
-- Carriageways so near to each other that corners on both sides of a median run into each other.
DO $$ BEGIN
  PERFORM streetgen.create_model('near', 2154, subjects => '{junction}');
  INSERT INTO near.axis (geom, width, lane_count, direction, name) VALUES
    ('SRID=2154;LINESTRING(649900 6860000,650000 6860000,650100 6860000)', 7, 2, 'direct', 'avenue'), ('SRID=2154;LINESTRING(650100 6860010,650000 6860010,649900 6860010)', 7, 2, 'direct', 'avenue'),
    ('SRID=2154;LINESTRING(650000 6859900,650000 6860000,650000 6860010,650000 6860100)', 7, 2, 'both', 'lane');
END $$;
CREATE VIEW pg_temp.drawn_arc AS SELECT geom FROM streetgen._junction_drawn('near', ST_MakeEnvelope(649900, 6859900, 650100, 6860100, 2154), '{junction_arc}');
SELECT 'arcs are drawn where they are kerb, and not within the junction', count(*) >= 4 AND bool_and(ST_Length(ST_Difference(a.geom, ST_Buffer(ST_Boundary(j.surface), 0.1))) < 0.01)
  FROM pg_temp.drawn_arc a, near.junction j WHERE j.method = 'grouped';
DROP VIEW pg_temp.drawn_arc;
DO $$ BEGIN PERFORM streetgen.drop_model('near'); END $$;
-- Nine crossings of two avenues each, at places that no number holds exactly: nodes are numbered otherwise by clusters.
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154, subjects => '{junction}') FROM unnest('{once,parts}'::text[]) m;
  PERFORM streetgen.live(m, false) FROM unnest('{once,parts}'::text[]) m;
  CREATE TABLE avenue AS SELECT ST_SetSRID(ST_Translate(ST_Rotate(ST_Scale(ST_MakeLine(CASE WHEN across THEN ST_MakePoint(place, other) ELSE ST_MakePoint(other, place) END
      ORDER BY CASE WHEN place::integer % 300 = 0 THEN other ELSE -other END), 1.0 / 3, 1.0 / 3), 0.7), 650000, 6860000), 2154) AS geom, format('%s %s', across, place::integer / 300) AS name
    FROM (VALUES (false), (true)) a(across), unnest('{0,60,300,360,600,660}'::float8[]) place, unnest('{-150,0,60,300,360,600,660,800}'::float8[]) other GROUP BY across, place;
  INSERT INTO once.axis (geom, width, lane_count, direction, importance, name) SELECT geom, 7, 2, 'direct', 3, name FROM avenue ORDER BY name, ST_XMin(geom);
  INSERT INTO parts.axis SELECT * FROM once.axis;
  PERFORM streetgen.generate('once'), streetgen.plan_clusters('parts', 5);
END $$;
SELECT streetgen.generate_cluster('parts') FROM generate_series(1, 5) \g /dev/null
SELECT 'by clusters their junctions are the same to the last bit', (SELECT count(*) = 9 FROM once.junction WHERE method = 'grouped') AND test.same('once', 'parts');
DROP TABLE avenue;
DO $$ BEGIN PERFORM streetgen.drop_model(m) FROM unnest('{once,parts}'::text[]) m; END $$;
-- Classifiers.
DO $$ BEGIN PERFORM streetgen.set('town', 'classifier', 'paper'), streetgen.generate('town', wait => true); END $$;
SELECT 'as the paper has it all are signals', (SELECT bool_and(kind IN ('signals', 'end')) FROM town.junction);
CREATE FUNCTION public.by_width(arms streetgen.junction_arm[]) RETURNS text LANGUAGE sql IMMUTABLE AS $$ SELECT CASE WHEN max(a.width) > 100 THEN 'crossroads' WHEN count(*) > 3 THEN 'stop' ELSE 'end' END FROM unnest(arms) a $$;
DO $$ BEGIN PERFORM streetgen.set('town', 'classifier', 'public.by_width'), streetgen.generate('town', wait => true); END $$;
SELECT 'a function of the user decides', (SELECT bool_or(kind = 'stop') FROM town.junction);
SELECT 'an unknown word is refused', test.said($q$UPDATE town.axis SET width = 120 WHERE axis_id = 5$q$) LIKE 'classifier public.by_width gives "crossroads"%';
SELECT 'a function that is not there too', test.state($q$SELECT streetgen.set('town', 'classifier', 'public.no_such')$q$) = '22023';
CREATE FUNCTION public.broken(arms streetgen.junction_arm[]) RETURNS text LANGUAGE plpgsql IMMUTABLE AS $$ BEGIN IF (SELECT max(a.width) > 100 FROM unnest(arms) a) THEN RAISE EXCEPTION 'too wide' USING ERRCODE = '22003'; END IF; RETURN 'stop'; END $$;
DO $$ BEGIN PERFORM streetgen.set('town', 'classifier', 'public.broken'), streetgen.generate('town', wait => true); END $$;
SELECT 'one that raises is named with its words, its SQLSTATE and the junction', test.said($q$UPDATE town.axis SET width = 120 WHERE axis_id = 5$q$) LIKE 'classifier public.broken fails at junction %: too wide' AND test.state($q$UPDATE town.axis SET width = 120 WHERE axis_id = 5$q$) = '22003' AND (SELECT width = 7 FROM town.axis WHERE axis_id = 5);
DO $$ BEGIN PERFORM streetgen.set('town', 'classifier', 'streetgen.junction_kind'), streetgen.generate('town', wait => true); END $$;
SELECT 'an arm by which nobody comes claims no priority', array_agg(streetgen.junction_kind(ARRAY[ROW (1, NULL, 5, 50, 7, 1, 1, 0, NULL, false, NULL), ROW (2, NULL, 5, 50, 7, 1, 1, 180, NULL, false, NULL), ROW (3, NULL, 4, 50, 7, lanes_in, 1, 90, NULL, false, NULL)]::streetgen.junction_arm[]) ORDER BY lanes_in) = '{right_before_left,priority,priority}'
    FROM unnest('{0,1,NULL}'::integer[]) lanes_in;
SELECT 'without arms it is an end', streetgen.junction_kind('{}') = 'end' AND streetgen.junction_kind(NULL) = 'end';
-- Switched off and on.
DROP VIEW pg_temp.across, pg_temp.side, pg_temp.link;
SELECT test.switch_off('town', 'junction') AS needing \gset
SELECT 'switched off nothing is left of it', to_regclass('town.junction') IS NULL AND to_regclass('town.movement') IS NULL AND NOT EXISTS (SELECT FROM pg_proc WHERE pronamespace = 'town'::regnamespace AND proname = '_update_junctions');
SELECT 'and an edit goes on', test.state('UPDATE town.axis SET width = 8 WHERE axis_id = 3') = 'none';
SELECT test.switch_on('town', :'needing'::text[] || 'junction'::text) \g /dev/null
SELECT 'switched on it is as from scratch', several() = 1 AND test.followed('town', 'anew');
