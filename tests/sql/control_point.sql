\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Signals, signs and crossings: of OpenStreetMap, of a layer, by hand, and what is painted by them.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('held', 2154), streetgen.create_model('anew', 2154);
  -- A street in two pieces that a more important road crosses, and one far from both.
  INSERT INTO held.axis (geom, width, importance, lane_count) VALUES
    ('SRID=2154;LINESTRING(649800 6860000,650000 6860000)', 7, 3, 2), ('SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 7, 3, 2),
    ('SRID=2154;LINESTRING(650000 6859800,650000 6860000)', 7, 2, 2), ('SRID=2154;LINESTRING(650000 6860000,650000 6860200)', 7, 2, 2);
END $$;
CREATE FUNCTION lines() RETURNS text LANGUAGE sql AS
  $$ SELECT string_agg(format('%s:%s', axis_id, m.kind), ' ' ORDER BY axis_id, m.kind) FROM held.marking m JOIN held.edge USING (edge_id) WHERE m.kind <> 'arrow' $$;
SELECT 'without control points the class decides' AS name, lines() = '1:yield 2:yield' AS holds;
INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(649985 6859997)', 'stop');
SELECT 'a stop sign beside its axis makes a stop line', lines() = '1:stop 2:yield';
SELECT 'its axis and place are filled', (SELECT (axis_id, abscissa, axis_distance) = (1::bigint, 185::float8, 3::float8) FROM held.control_point);
UPDATE held.control_point SET geom = 'SRID=2154;POINT(650015 6860000)';
SELECT 'moved by hand it speaks to the other arm', lines() = '1:yield 2:stop';
UPDATE held.control_point SET direction = 'direct';
SELECT 'one for the traffic that leaves changes nothing', lines() = '1:yield 2:yield';
UPDATE held.control_point SET geom = 'SRID=2154;POINT(650150 6860000)', direction = NULL, kind = 'signals';
SELECT 'far from its junction it stands in mid-block, on a node of its own', lines() = '1:yield 2:stop 2:stop 2:yield' AND (SELECT array_agg(start_abscissa ORDER BY start_abscissa) = '{0,150}' FROM held.edge WHERE axis_id = 2);
SELECT 'before which both ways stop', (SELECT array_agg(round(ST_X(ST_LineInterpolatePoint(geom, 0.5))) ORDER BY ST_XMin(geom)) = '{650147,650153}' FROM (SELECT m.geom FROM held.marking m JOIN held.edge USING (edge_id) WHERE m.kind = 'stop') m(geom));
SELECT 'and it is the same from scratch', test.followed('held', 'anew');
UPDATE held.control_point SET direction = 'direct', geom = 'SRID=2154;POINT(650160 6860000)';
SELECT 'moved it takes its node along', (SELECT array_agg(start_abscissa ORDER BY start_abscissa) = '{0,160}' FROM held.edge WHERE axis_id = 2) AND test.followed('held', 'anew');
INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(650166 6860000)', 'signals'), ('SRID=2154;POINT(650162 6860000)', 'pedestrian_crossing');
SELECT 'signals within a queue stand at the crossing between them', (SELECT array_agg(start_abscissa ORDER BY start_abscissa) = '{0,162}' FROM held.edge WHERE axis_id = 2) AND test.followed('held', 'anew');
DELETE FROM held.control_point WHERE abscissa > 161;
UPDATE held.control_point SET kind = 'stop';
SELECT 'a stop sign in mid-block cuts nothing', lines() = '1:yield 2:yield' AND (SELECT count(*) = 1 FROM held.edge WHERE axis_id = 2) AND test.followed('held', 'anew');
UPDATE held.control_point SET direction = NULL, kind = 'signals';
UPDATE held.control_point SET geom = 'SRID=2154;POINT(650020 6860000)';
SELECT 'signals of one arm make a stop line on each', lines() = '1:stop 2:stop 3:stop 4:stop';
UPDATE held.control_point SET geom = 'SRID=2154;POINT(650000 6860000)';
SELECT 'signals on the node too', lines() = '1:stop 2:stop 3:stop 4:stop';
UPDATE held.control_point SET kind = 'stop';
SELECT 'a stop sign on the node binds the minor arms', lines() = '1:stop 2:stop';
UPDATE held.control_point SET kind = 'yield';
SELECT 'a yield sign too', lines() = '1:yield 2:yield';
UPDATE held.control_point SET kind = 'stop', direction = 'both';
SELECT 'one for all binds all', lines() = '1:stop 2:stop 3:stop 4:stop' AND test.followed('held', 'anew');
UPDATE held.control_point SET direction = NULL;
UPDATE held.control_point SET kind = 'mini_roundabout';
SELECT 'all that comes to a mini-roundabout yields', lines() = '1:yield 2:yield 3:yield 4:yield';
UPDATE held.control_point SET kind = 'pedestrian_crossing';
SELECT 'a crossing leaves it to the class', lines() = '1:yield 2:yield';
INSERT INTO held.control_point (geom, kind, direction) VALUES ('SRID=2154;POINT(649980 6860000)', 'yield', 'direct'), ('SRID=2154;POINT(649981 6860000)', 'stop', 'direct');
SELECT 'of two kinds the stricter holds', lines() = '1:stop 2:yield';
SELECT 'it is the same from scratch', test.followed('held', 'anew');
UPDATE held.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'an axis turned round turns their direction', (SELECT bool_and(direction = 'reverse') FROM held.control_point WHERE kind IN ('stop', 'yield')) AND lines() = '1:stop 2:yield';
UPDATE held.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,649900 6860000)' WHERE axis_id = 1;
INSERT INTO held.axis (axis_id, geom, width, importance, lane_count) OVERRIDING SYSTEM VALUE VALUES (11, 'SRID=2154;LINESTRING(649900 6860000,649800 6860000)', 7, 3, 2);
SELECT 'a split leaves them on the piece where they stand', (SELECT count(*) = 2 FROM held.control_point WHERE axis_id = 1 AND abscissa BETWEEN 1 AND 99);
SELECT 'and all is as from scratch', test.followed('held', 'anew');
DELETE FROM held.axis WHERE axis_id = 1;
SELECT 'one whose axis is gone stays and is told', (SELECT count(*) = 2 FROM streetgen.check_model('held') WHERE rule = 'control point off all axes');
INSERT INTO held.axis (axis_id, geom, width, importance, lane_count) OVERRIDING SYSTEM VALUE VALUES (1, 'SRID=2154;LINESTRING(649900 6860000,650000 6860000)', 7, 3, 2);
SELECT 'an axis that comes by takes them', (SELECT count(*) = 0 FROM streetgen.check_model('held') WHERE rule = 'control point off all axes');
INSERT INTO held.axis (axis_id, geom, width) OVERRIDING SYSTEM VALUE VALUES (901, 'SRID=2154;LINESTRING(660000 6860000,660000 6860000.4)', 7), (902, 'SRID=2154;LINESTRING(660000 6860000,660100 6860000)', 7);
INSERT INTO held.control_point (geom, kind, source_ref) VALUES ('SRID=2154;POINT(660000 6860000)', 'pedestrian_crossing', 'stub');
SELECT 'one at the end of an axis too short for an edge lies on the other axis', (SELECT axis_id = 902 AND EXISTS (SELECT FROM held.edge e WHERE e.axis_id = c.axis_id) AND NOT EXISTS (SELECT FROM held.edge WHERE axis_id = 901) FROM held.control_point c WHERE source_ref = 'stub');
DELETE FROM held.control_point WHERE source_ref = 'stub';
INSERT INTO held.axis (axis_id, geom, width) OVERRIDING SYSTEM VALUE VALUES (903, 'SRID=2154;LINESTRING(661000 6860000,661009.6 6860000,661010 6860000)', 7),
    (904, 'SRID=2154;LINESTRING(661010 6860000,661100 6860000)', 7);
INSERT INTO held.control_point (geom, kind, source_ref) VALUES ('SRID=2154;POINT(661010 6860000)', 'pedestrian_crossing', 'behind');
SELECT 'one behind the last node of an axis lies on the edge that goes on there', (SELECT axis_id = 904 AND EXISTS (SELECT FROM held.edge e WHERE e.axis_id = c.axis_id AND c.abscissa BETWEEN e.start_abscissa AND e.end_abscissa) AND EXISTS (SELECT FROM held.edge WHERE axis_id = 903 AND end_abscissa < 9.7) FROM held.control_point c WHERE source_ref = 'behind');
DELETE FROM held.control_point WHERE source_ref = 'behind';
DELETE FROM held.axis WHERE axis_id > 900;
INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860060)', 'stop');
SET statement_timeout = '20s';
UPDATE held.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650200 6860001)' WHERE axis_id = 2;
RESET statement_timeout;
SELECT 'an axis moves beside one that stands off all axes', (SELECT count(*) = 1 FROM held.control_point WHERE axis_id IS NULL);
UPDATE held.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650200 6860000)' WHERE axis_id = 2;
DELETE FROM held.control_point WHERE axis_id IS NULL;
SELECT 'a kind that is none is refused', test.state($q$INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT(0 0)', 'gate')$q$) = '23514';
SELECT 'an empty place is refused', test.state($q$INSERT INTO held.control_point (geom, kind) VALUES ('SRID=2154;POINT EMPTY', 'stop')$q$) = '23514';

-- A ring that its source calls a roundabout, in a model that looks for none: (0,0) is its middle, and each arm has another class.
DO $$ BEGIN
  PERFORM streetgen.create_model('ring', 2154, driving_side => 'right'), streetgen.create_model('ring_anew', 2154, driving_side => 'right');
  INSERT INTO ring.axis (geom, width, importance, lane_count, roundabout_tag)
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(660000 + 20 * cos(radians(6 * n)), 6860000 + 20 * sin(radians(6 * n))) ORDER BY n), 2154), 6, 4, 1, 'roundabout' FROM generate_series(0, 60) n;
  INSERT INTO ring.axis (geom, width, importance, lane_count)
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(660000 + 20 * cos(radians(90 * n)), 6860000 + 20 * sin(radians(90 * n))), ST_MakePoint(660000 + 120 * cos(radians(90 * n)), 6860000 + 120 * sin(radians(90 * n)))), 2154),
      7, (ARRAY[2, 4, 5, 6])[n + 1], 2 FROM generate_series(0, 3) n;
END $$;
CREATE FUNCTION ring_lines() RETURNS text LANGUAGE sql AS
  $$ SELECT string_agg(format('%s:%s', axis_id, m.kind), ' ' ORDER BY axis_id, m.kind) FROM ring.marking m JOIN ring.edge USING (edge_id) WHERE m.kind <> 'arrow' $$;
SELECT 'each arm of a tagged ring yields, whatever its class, and the ring does not', ring_lines() = '2:yield 3:yield 4:yield 5:yield';
SELECT 'these lines lie at the ring, not on it', min(off) BETWEEN 0.45 AND 0.55 AND max(off) < 1.75 FROM (SELECT ST_Distance(m.surface, 'SRID=2154;POINT(660000 6860000)') - 23 AS off FROM ring.marking m WHERE kind = 'yield') m;
INSERT INTO ring.control_point (geom, kind) VALUES ('SRID=2154;POINT(659970 6860000)', 'stop');
SELECT 'a stop sign at an arm holds', ring_lines() = '2:yield 3:yield 4:stop 5:yield';
SELECT 'a ring is the same from scratch', test.followed('ring', 'ring_anew');
UPDATE ring.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (2, 3);
SELECT 'arms that are drawn to the ring yield too', ring_lines() = '2:yield 3:yield 4:stop 5:yield';
UPDATE ring.axis SET roundabout_tag = NULL WHERE axis_id = 1;
SELECT 'without the word of the source the classes decide, where no subject looks for rings', ring_lines() LIKE '1:stop 1:stop %' OR to_regclass('ring.roundabout') IS NOT NULL;
SELECT 'and again it is the same from scratch', test.followed('ring', 'ring_anew');
UPDATE ring.axis SET roundabout_tag = 'roundabout' WHERE axis_id = 1;
SELECT 'the word put back puts the lines back', ring_lines() = '2:yield 3:yield 4:stop 5:yield';
INSERT INTO ring.control_point (geom, kind) SELECT 'SRID=2154;POINT(660000 6860034)', kind FROM unnest(ARRAY['signals', 'pedestrian_crossing']) kind;
SELECT 'a crossing with lights on an arm leaves the ring its way', ring_lines() = '2:yield 3:stop 3:stop 3:yield 4:stop 5:yield';
SELECT 'and the arm is the same from scratch', test.followed('ring', 'ring_anew');
-- An arm that parts before its ring, whose entry has no section of its own.
DO $$ BEGIN
  PERFORM streetgen.create_model('split', 2154, driving_side => 'right');
  INSERT INTO split.axis (geom, width, importance, lane_count, direction, roundabout_tag) SELECT ST_SetSRID(geom, 2154), width, 4, lanes, way, tag FROM (VALUES
    ((SELECT ST_MakeLine(ST_MakePoint(660000 + 15 * cos(radians(5 * n)), 6860000 + 15 * sin(radians(5 * n))) ORDER BY n) FROM generate_series(0, 72) n), 6, 1, 'direct', 'roundabout'),
    ('LINESTRING(660100 6860000, 660025 6860000)', 7, 2, 'both', NULL),
    (ST_MakeLine('POINT(660025 6860000)', ST_MakePoint(660000 + 15 * cos(radians(20)), 6860000 + 15 * sin(radians(20)))), 4, 1, 'direct', NULL),
    (ST_MakeLine('POINT(660025 6860000)', ST_MakePoint(660000 + 15 * cos(radians(20)), 6860000 - 15 * sin(radians(20)))), 4, 1, 'reverse', NULL)) v(geom, width, lanes, way, tag);
END $$;
SELECT 'an entry without a section of its own yields at the ring', count(*) = 1 AND bool_and(e.axis_id = 3 AND ST_Distance(m.surface, 'SRID=2154;POINT(660000 6860000)') - 18 BETWEEN 0.1 AND 1.5) AND NOT EXISTS (SELECT FROM split.section s JOIN split.edge USING (edge_id) WHERE axis_id = 3 AND ST_Area(surface) > 0)
  FROM split.marking m JOIN split.edge e USING (edge_id) WHERE kind IN ('yield', 'stop');

-- A crossing with lights that is of no arm: 40 m before a junction without signals.
DO $$ BEGIN
  PERFORM streetgen.create_model('pelican', 2154, driving_side => 'right');
  INSERT INTO pelican.axis (geom, width, importance, lane_count) VALUES
    ('SRID=2154;LINESTRING(649700 6860000,650000 6860000)', 7, 2, 2), ('SRID=2154;LINESTRING(650000 6860000,650300 6860000)', 7, 2, 2), ('SRID=2154;LINESTRING(650000 6859700,650000 6860000)', 6, 6, 2);
END $$;
INSERT INTO pelican.control_point (geom, kind) SELECT 'SRID=2154;POINT(649960 6860000)', kind FROM unnest(ARRAY['signals', 'pedestrian_crossing']) kind;
CREATE FUNCTION pelican_lines() RETURNS text LANGUAGE sql AS
  $$ SELECT string_agg(format('%s:%s', axis_id, m.kind), ' ' ORDER BY axis_id, m.kind) FROM pelican.marking m JOIN pelican.edge USING (edge_id) WHERE m.kind <> 'arrow' $$;
SELECT 'both ways stop before a crossing with lights 40 m before a junction, and there as without', pelican_lines() = '1:stop 1:stop 3:stop' AND (SELECT max(ST_Distance(m.geom, 'SRID=2154;POINT(649960 6860000)')) < 4 FROM pelican.marking m JOIN pelican.edge USING (edge_id) WHERE axis_id = 1);
UPDATE pelican.control_point SET geom = 'SRID=2154;POINT(649985 6860000)';
SELECT 'moved to an arm it is the junction''s', pelican_lines() = '1:stop 2:stop 3:stop';

-- A layer of anybody.
CREATE TABLE sign (id integer, place geometry, what text);
INSERT INTO sign VALUES (1, 'SRID=2154;POINT(649985 6860000)', 'signals'), (2, 'SRID=2154;POINT(640000 6860000)', 'stop'), (3, NULL, 'stop'), (4, ST_Transform('SRID=2154;POINT(650015 6860000)'::geometry, 4326), 'yield');
CREATE FUNCTION import_signs() RETURNS TABLE(what text, class text, count bigint, source_refs text[]) LANGUAGE sql AS
  $$ SELECT * FROM streetgen.import_control_points('held', 'sign', '{"geom": "place", "kind": "what", "source_ref": "id"}') $$;
CREATE TABLE report AS SELECT * FROM import_signs();
SELECT 'an import says what it took', (SELECT sum(count) = 3 FROM report WHERE what = 'control points');
SELECT 'and what has no place', (SELECT source_refs = '{3}' FROM report WHERE what = 'control point without geometry, left out');
SELECT 'and what stands off all axes', (SELECT source_refs = '{2}' FROM report WHERE what = 'control point off all axes, kept');
SELECT 'other projections are taken', (SELECT axis_id = 2 FROM held.control_point WHERE source_ref = '4');
SELECT 'the streets wait for generate', (SELECT count = 2 FROM report WHERE what = 'generate is due');
DELETE FROM sign WHERE id = 1;
SELECT FROM import_signs() \g /dev/null
SELECT 'importing again follows the table', (SELECT array_agg(source_ref ORDER BY source_ref) = '{2,4}' FROM held.control_point WHERE source = 'sign');
UPDATE sign SET what = 'gate' WHERE id = 4;
SELECT 'a row of an unknown kind is named', test.said('SELECT FROM import_signs()') LIKE 'source row 4 has kind "gate"%';
SELECT 'a column that is missing is refused', test.state($q$SELECT FROM streetgen.import_control_points('held', 'sign', '{"geom": "place", "kind": "colour"}')$q$) = '42703';
SELECT 'a target that is none is refused', test.state($q$SELECT FROM streetgen.import_control_points('held', 'sign', '{"width": "id"}')$q$) = '22023';
SELECT 'a NULL mapping is refused', test.state($q$SELECT FROM streetgen.import_control_points('held', 'sign', NULL)$q$) = '22004';
DROP TABLE sign, report;

-- OpenStreetMap: a stop on the node of a junction binds the minor arms, with stop=all each; on its way to it the arm alone.
CREATE TABLE four_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
CREATE TABLE four_control (node_id bigint, class text, direction text, traffic_signals_direction text, stop text, lights boolean, geom geometry(Point, 2154));
DO $$ BEGIN
  INSERT INTO four_line SELECT n, CASE WHEN n % 2 = 1 THEN 'tertiary' ELSE 'residential' END, NULL, NULL, '{"lanes": "2"}', 2,
    ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000), ST_MakePoint(650000 + 100 * round(sin(radians(90 * n))), 6860000 + 100 * round(cos(radians(90 * n))))), 2154) FROM generate_series(1, 4) n;
  PERFORM streetgen.create_model('four', 2154, driving_side => 'right');
END $$;
CREATE FUNCTION taken(class text, stop text, place geometry) RETURNS text LANGUAGE plpgsql AS $$ BEGIN
  DELETE FROM four_control;
  INSERT INTO four_control VALUES (2, class, NULL, NULL, stop, false, place);
  PERFORM streetgen.import_osm('four', 'four'), streetgen.generate('four');
  RETURN (SELECT string_agg(format('%s:%s', source_ref, m.kind), ' ' ORDER BY source_ref) FROM four.marking m JOIN four.edge USING (edge_id) JOIN four.axis USING (axis_id) WHERE m.kind <> 'arrow');
END $$;
SELECT 'a stop on a junction binds the minor arms', taken('stop', stop, 'SRID=2154;POINT(650000 6860000)') = '2:stop 4:stop' FROM (VALUES ('minor'), (NULL)) v(stop);
SELECT 'so does a give-way', taken('give_way', NULL, 'SRID=2154;POINT(650000 6860000)') = '2:yield 4:yield';
SELECT 'a stop for all binds all', taken('stop', 'all', 'SRID=2154;POINT(650000 6860000)') = '1:stop 2:stop 3:stop 4:stop';
SELECT 'a stop for all before the junction binds its arm', taken('stop', 'all', 'SRID=2154;POINT(650010 6860000)') = '1:stop 2:yield 4:yield';
