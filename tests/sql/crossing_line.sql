\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Stop lines, yield lines, arrows and signal heads lie before the crossings of their arm.  (name, holds)
-- A side street comes from the south, 7 m wide with two lanes, to a road along the x axis; metres are from the middle of the road.
DO $$ BEGIN
  PERFORM streetgen.create_model('held', 2154, subjects => '{object,signal}'), streetgen.create_model('anew', 2154, subjects => '{object,signal}');
  INSERT INTO held.axis (geom, width, importance, lane_count, turn_forward) VALUES
    ('SRID=2154;LINESTRING(649800 6860000,650000 6860000)', 7, 2, 2, NULL), ('SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 7, 2, 2, NULL),
    ('SRID=2154;LINESTRING(650000 6859800,650000 6860000)', 7, 3, 2, 'left;right');
END $$;
-- The middle of the line across the lane that comes to the road, and the tip of its arrow.
CREATE FUNCTION waits(axis bigint DEFAULT 3) RETURNS float8 LANGUAGE sql AS $$
  SELECT round((6860000 - ST_Y(ST_LineInterpolatePoint(m.geom, 0.5)))::numeric, 6)::float8 FROM held.marking m JOIN held.edge e USING (edge_id) JOIN held.node n USING (node_id)
  WHERE e.axis_id = axis AND m.kind <> 'arrow' AND ST_Y(n.geom) = 6860000 $$;
CREATE FUNCTION tip() RETURNS float8 LANGUAGE sql AS $$
  SELECT round((6860000 - ST_Y(ST_EndPoint(m.geom)))::numeric, 6)::float8 FROM held.marking m JOIN held.edge e USING (edge_id) JOIN held.node n USING (node_id)
  WHERE e.axis_id = 3 AND m.kind = 'arrow' AND ST_Y(n.geom) = 6860000 $$;
CREATE TEMP TABLE before AS SELECT waits() AS line, tip() AS tip;
CREATE FUNCTION as_before() RETURNS boolean LANGUAGE sql AS $$ SELECT (waits(), tip()) = (line, tip) AND NOT EXISTS (SELECT FROM held.marking WHERE num_nonnulls(free_geom, free_surface) > 0) FROM before $$;
SELECT 'without a crossing the line lies where the lanes end' AS name, (SELECT line < 12 AND tip > line FROM before) AS holds;
INSERT INTO held.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650000 6859988)');
-- Half of the crossing, a metre, and half of the line.
SELECT 'the line lies a metre before a crossing', waits() = 12 + 2 + 1 + 0.25;
SELECT 'it is as wide as its lane', (SELECT round(ST_Length(geom)::numeric, 6) = 3.5 AND ST_Area(surface) > 0.5 AND ST_Distance(surface, geom) = 0 AND ST_Length(free_geom) > 3 FROM held.marking WHERE kind = 'yield');
SELECT 'the arrow lies before the line', tip() = 12 + 2 + 1 + 0.5 + 2;
SELECT 'the arrow of who leaves lies on no crossing', NOT EXISTS (SELECT FROM held.marking m, held.pedestrian_crossing c WHERE ST_Intersects(m.surface, c.surface));
SELECT 'and all is as from scratch', test.followed('held', 'anew');
SELECT 'a run that changes nothing writes nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('held') WHERE relation ~ 'marking|signal';
UPDATE held.pedestrian_crossing_editing SET geom = 'SRID=2154;POINT(650000 6859980)';
SELECT 'a crossing that moves takes the line along', waits() = 20 + 3.25 AND test.followed('held', 'anew');
UPDATE held.pedestrian_crossing_editing SET width = 6;
SELECT 'a wider one pushes it back', waits() = 20 + 4.25;
UPDATE held.pedestrian_crossing_editing SET width = 4, angle = 45;
-- Along the street it takes 4 m by the sine; the lane lies 1.75 m beside the axis, and is 3.5 m wide.
SELECT 'an oblique one as far as it lies on the lane', abs(abs(waits() - (20 + 2 * sqrt(2) + 1 + 0.25 + 1.75)) - 1.75) < 1e-6;
SELECT 'and the line lies on neither of both', NOT EXISTS (SELECT FROM held.marking m, held.pedestrian_crossing c WHERE ST_Intersects(m.surface, c.surface)) AND test.followed('held', 'anew');
UPDATE held.pedestrian_crossing_editing SET angle = 90, geom = 'SRID=2154;POINT(650000 6859960)';
SELECT 'one far off is none of the arm', as_before();
SELECT streetgen.set('held', 'crossing_of_arm', '40') \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'but by the setting', waits() = 40 + 3.25;
SELECT streetgen.set('held', 'crossing_of_arm', '15'), streetgen.set('held', 'line_before_crossing', '2.5') \g /dev/null
UPDATE held.pedestrian_crossing_editing SET geom = 'SRID=2154;POINT(650000 6859990)';
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'so far before it by the setting', waits() = 10 + 2 + 2.5 + 0.25 AND test.followed('held', 'anew');
SELECT streetgen.set('held', 'line_before_crossing', '1') \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
INSERT INTO held.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650000 6859983)');
SELECT 'of two it lies before the one that the driver meets first', waits() = 17 + 3.25 AND test.followed('held', 'anew');
UPDATE held.pedestrian_crossing_editing SET geom = 'SRID=2154;POINT(650000 6859970)' WHERE abscissa < 185;
SELECT 'of two far apart before the one at the junction', waits() = 10 + 3.25;
SELECT 'and the arrow lies between', tip() = 10 + 2 + 1 + 0.5 + 2 AND test.followed('held', 'anew');
DELETE FROM held.pedestrian_crossing_editing WHERE abscissa < 185;
UPDATE held.street_object SET geom = 'SRID=2154;POINT(649990 6860000)', axis_id = 1, abscissa = NULL, placement = 'axis';
SELECT 'one that goes to another street leaves the line', as_before() AND test.followed('held', 'anew');
DELETE FROM held.street_object;
-- Rules.
INSERT INTO held.placement_rule (type, along, distance_from_limit) VALUES ('crossing', 'arm', 4);
SELECT 'lines lie before crossings of rules', (SELECT abs(waits() - (6860000 - ST_Y(o.geom)) - 3.25) < 1e-6 FROM held.street_object o WHERE axis_id = 3) AND test.followed('held', 'anew');
UPDATE held.axis SET width = 14, lane_count = 4 WHERE axis_id IN (1, 2);
SELECT 'which go with the limits', waits() > 15 AND (SELECT abs(waits() - (6860000 - ST_Y(o.geom)) - 3.25) < 1e-6 FROM held.street_object o WHERE axis_id = 3) AND test.followed('held', 'anew');
UPDATE held.axis SET width = 7, lane_count = 2 WHERE axis_id IN (1, 2);
DELETE FROM held.placement_rule;
SELECT 'without the rule all is as before', as_before();
-- Control points, where no object says where the crossing is.
INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000 6859988)', 'pedestrian_crossing');
SELECT 'a control point is a crossing of usual width', waits() = 15.25 AND test.followed('held', 'anew');
INSERT INTO held.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650000 6859986)');
SELECT 'an object beside it knows better', waits() = 17.25 AND test.followed('held', 'anew');
-- Signals: a head on each lane that comes.
INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000 6860000)', 'signals');
SELECT 'a signal head stands at the stop line', count(*) = 3 AND bool_and(ST_Distance(h.geom, ST_LineInterpolatePoint(m.geom, 0.5)) < 1e-9) AND bool_or(abs(6860000 - ST_Y(h.geom) - 17.25) < 1e-6 AND abs(h.angle) < 1e-6)
  FROM held.signal_head h JOIN held.lane l USING (lane_id) JOIN held.marking m ON (m.edge_id, m.lane_position, m.along_axis, m.kind) = (l.edge_id, l.lane_position, h.along_axis, 'stop');
UPDATE held.pedestrian_crossing_editing SET geom = 'SRID=2154;POINT(650000 6859987)';
SELECT 'and goes with it', count(*) = 1 FROM held.signal_head h WHERE abs(6860000 - ST_Y(h.geom) - 16.25) < 1e-6;
SELECT 'all as from scratch', test.followed('held', 'anew');
UPDATE held.axis SET geom = ST_Reverse(geom) WHERE axis_id = 3;
SELECT 'a street drawn the other way has its line at the same place', waits() = 16.25 AND test.followed('held', 'anew');
SELECT streetgen.set('held', 'driving_side', 'left') \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'and where one drives on the left', waits() = 16.25 AND (SELECT ST_X(ST_Centroid(m.geom)) < 650000 FROM held.marking m JOIN held.edge USING (edge_id) WHERE axis_id = 3 AND kind = 'stop') AND test.followed('held', 'anew');
SELECT streetgen.switch_subject('held', 'object', false) \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'without objects the control point alone counts', waits() = 15.25;
DELETE FROM held.control_point WHERE kind = 'pedestrian_crossing';
SELECT 'and without it nothing', waits() < 12;
-- A street of 26 m between two junctions: each crossing belongs to the nearer one.
SELECT streetgen.drop_model('held'), streetgen.create_model('held', 2154, subjects => '{object,lane}') \g /dev/null
INSERT INTO held.axis (geom, width, importance, lane_count) VALUES
  ('SRID=2154;LINESTRING(649900 6860000,650000 6860000,650100 6860000)', 7, 2, 2), ('SRID=2154;LINESTRING(649900 6859960,650000 6859960,650100 6859960)', 7, 2, 2),
  ('SRID=2154;LINESTRING(650000 6859960,650000 6860000)', 7, 3, 2);
INSERT INTO held.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650000 6859988)'), ('SRID=2154;POINT(650000 6859972)');
SELECT 'each of two crossings between two junctions belongs to one', count(*) = 2 AND bool_and(abs(abs(ST_Y(ST_Centroid(geom)) - 6859980) - (8 - 3.25)) < 1e-6) FROM held.marking WHERE kind = 'yield';
-- Ring: who comes waits at the ring, not before the crossing of the arm.
SELECT streetgen.drop_model('held'), streetgen.create_model('held', 2154, subjects => '{object,lane,roundabout}') \g /dev/null
INSERT INTO held.axis (geom, width, importance, lane_count, direction, roundabout_tag)
  SELECT ST_Translate(ST_Scale(ST_SetSRID(ST_GeomFromText(line), 2154), 18, 18), 650000, 6860000), 7, 3, 1, 'direct', 'roundabout'
  FROM (SELECT 'LINESTRING(' || string_agg(cosd(30 * i) || ' ' || sind(30 * i), ',' ORDER BY i) || ')' AS line FROM generate_series(0, 12) i) l;
INSERT INTO held.axis (geom, width, importance, lane_count, turn_forward) SELECT ST_MakeLine(ST_SetSRID(ST_Point(650000 + x, 6860000 + y), 2154), ST_SetSRID(ST_Point(650000 + 18 * sign(x), 6860000 + 18 * sign(y)), 2154)), 7, 3, 2, 'right'
  FROM (VALUES (100, 0), (-100, 0), (0, 100)) v(x, y);
CREATE TEMP TABLE at_ring AS SELECT edge_id, geom::bytea FROM held.marking WHERE kind = 'yield';
INSERT INTO held.pedestrian_crossing_editing (geom) SELECT ST_LineInterpolatePoint(geom, 1 - 10.0 / 82) FROM held.axis WHERE roundabout_tag IS NULL;
SELECT 'yield lines stay at the ring', (SELECT count(*) = 3 FROM at_ring) AND NOT EXISTS (SELECT edge_id, geom::bytea FROM held.marking WHERE kind = 'yield' EXCEPT SELECT * FROM at_ring);
SELECT 'arrows before them lie on no crossing', count(*) > 0 AND bool_and(NOT ST_Intersects(m.surface, c.surface)) FROM held.marking m, held.pedestrian_crossing c WHERE m.kind = 'arrow' AND ST_DWithin(m.geom, c.surface, 30);

-- A model of lanes alone: control points move its lines, as they do where objects stand.
DO $$ BEGIN PERFORM streetgen.create_model('alone', 2154, subjects => '{interconnection}', driving_side => 'right'); END $$;
INSERT INTO alone.axis (geom, width, lane_count, importance) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650200 6860000)', 7, 2, 2), ('SRID=2154;LINESTRING(650100 6859900, 650100 6860000)', 7, 2, 5);
INSERT INTO alone.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6859985)', 'stop'), ('SRID=2154;POINT(650100 6859990)', 'pedestrian_crossing');
SELECT 'a control point moves the line of a model of lanes alone', count(*) = 1 AND bool_and(free_geom IS NOT NULL AND ST_Y(ST_StartPoint(geom)) < 6859988) FROM alone.marking WHERE kind = 'stop';
DELETE FROM alone.control_point WHERE kind = 'pedestrian_crossing';
SELECT 'without it the line lies where the lane ends', bool_and(free_geom IS NULL AND ST_Y(ST_StartPoint(geom)) > 6859988) FROM alone.marking WHERE kind = 'stop';
-- A ring that nobody tags, confirmed by hand: who comes to it waits at the ring.
DO $$ BEGIN PERFORM streetgen.create_model('ring', 2154, subjects => '{roundabout,interconnection}', driving_side => 'right'); END $$;
INSERT INTO ring.axis (geom, width, lane_count) SELECT ST_Boundary(ST_Buffer('SRID=2154;POINT(650000 6860000)'::geometry, 18)), 7, 2;
INSERT INTO ring.axis (geom, width, lane_count) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 18 * x, 6860000 + 18 * y), ST_MakePoint(650000 + 90 * x, 6860000 + 90 * y)), 2154), 6, 2 FROM (VALUES (1, 0), (0, 1), (-1, 0), (0, -1)) v(x, y);
INSERT INTO ring.control_point (geom, kind) SELECT ST_SetSRID(ST_MakePoint(650000 + 28 * x, 6860000 + 28 * y), 2154), 'pedestrian_crossing' FROM (VALUES (1, 0), (0, 1), (-1, 0), (0, -1)) v(x, y);
SELECT 'yield lines of an accepted ring stay at it', count(*) = 4 AND bool_and(free_geom IS NULL) AND (SELECT bool_and(accepted) FROM ring.roundabout) FROM ring.marking WHERE kind = 'yield';
UPDATE ring.axis SET width = 6.5 WHERE axis_id = 2;
SELECT 'and so they do after an edit', bool_and(free_geom IS NULL) FROM ring.marking WHERE kind = 'yield';

-- A delivery brings a crossing, and the next one takes it away.
DO $$ BEGIN PERFORM streetgen.create_model('brought', 2154, subjects => '{object,interconnection}', driving_side => 'right'); END $$;
INSERT INTO brought.axis SELECT * FROM alone.axis;
INSERT INTO brought.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6859985)', 'stop');
CREATE TABLE free_line AS SELECT geom FROM brought.marking WHERE kind = 'stop';
CREATE TABLE zebra AS SELECT 1 AS id, 'SRID=2154;POINT(650100 6859990)'::geometry AS geom;
SELECT count(*) FROM streetgen.import_objects('brought', 'zebra', '{"type": {"value": "crossing"}, "source_ref": "id"}') \g /dev/null
SELECT 'a line waits for a crossing that an import brings', count(*) = 1 AND bool_and(free_geom IS NOT NULL AND ST_Y(ST_StartPoint(geom)) < 6859988) FROM brought.marking WHERE kind = 'stop';
DELETE FROM zebra;
INSERT INTO zebra VALUES (2, 'SRID=2154;POINT(650180 6860000)');
SELECT count(*) FROM streetgen.import_objects('brought', 'zebra', '{"type": {"value": "crossing"}, "source_ref": "id"}') \g /dev/null
SELECT 'where the next one has none, it lies as before', count(*) = 1 AND bool_and(m.geom = l.geom AND free_geom IS NULL) FROM brought.marking m, free_line l WHERE kind = 'stop';
SELECT 'a run after imports writes nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('brought');

-- A crossing takes all of a short lane: nothing is painted, and the signal head stands where the line would lie.
DO $$ BEGIN PERFORM streetgen.create_model('short', 2154, subjects => '{object,signal}', driving_side => 'right'); END $$;
INSERT INTO short.axis (geom, width, importance, lane_count) VALUES ('SRID=2154;LINESTRING(649900 6860000,650000 6860000,650100 6860000)', 7, 2, 2),
  ('SRID=2154;LINESTRING(649900 6859976,650000 6859976,650100 6859976)', 7, 2, 2), ('SRID=2154;LINESTRING(650000 6859976,650000 6860000)', 7, 3, 2);
INSERT INTO short.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000 6860000)', 'signals');
INSERT INTO short.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650000 6859985.5)');
SELECT 'the head of a lane without room for a line stands where that would lie', count(*) = 1 AND bool_and(ST_IsEmpty(m.surface) AND ST_Distance(h.geom, m.geom) < 1e-9)
  FROM short.marking m JOIN short.edge USING (edge_id) JOIN short.lane l USING (edge_id, lane_position) JOIN short.signal_head h ON (h.lane_id, h.along_axis) = (l.lane_id, m.along_axis) WHERE axis_id = 3 AND m.kind = 'stop';
SELECT 'after a run too', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('short') WHERE relation ~ 'marking|signal';
SELECT 'check_model has nothing to say of it', NOT EXISTS (SELECT FROM streetgen.check_model('short') WHERE rule LIKE 'signal head%');
SELECT 'a file of Lanelet2 has the lines that are painted', (SELECT count(*) > 0 AND count(*) = (SELECT count(*) FROM short.marking WHERE kind <> 'arrow' AND NOT ST_IsEmpty(surface)) FROM streetgen.export_lanelet2('short') l WHERE l::text LIKE '%stop_line%');
