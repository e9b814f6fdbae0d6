\set ECHO none
\ir shared/truths.sql
-- Decisions by hand stay on the piece of road where they lie.  Each SELECT is one truth: (name, holds).
SET check_function_bodies = off;
CREATE FUNCTION pg_temp.place(x float8, y float8) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
CREATE FUNCTION pg_temp.line(wkt text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_Translate(wkt::geometry, 650000, 6860000), 2154) $$;
CREATE FUNCTION pg_temp.draw(id bigint, wkt text) RETURNS void LANGUAGE sql AS $$
  INSERT INTO town.axis (axis_id, geom, width, lane_count) VALUES (id, pg_temp.line(wkt), 7, 2) ON CONFLICT (axis_id) DO UPDATE SET geom = excluded.geom $$;

-- A street of 100 m (1) that goes on (2), with a side street (3) and another at its far end (4); a decision of each kind.
CREATE PROCEDURE pg_temp.decide() LANGUAGE plpgsql AS $$
BEGIN
  IF to_regnamespace('town') IS NOT NULL THEN PERFORM streetgen.drop_model('town'); END IF;
  PERFORM streetgen.create_model('town', 2154);
  PERFORM pg_temp.draw(1, 'LINESTRING(0 0, 50 0, 100 0)'), pg_temp.draw(2, 'LINESTRING(100 0, 200 0)'), pg_temp.draw(3, 'LINESTRING(100 0, 100 -80)'), pg_temp.draw(4, 'LINESTRING(200 0, 200 80)');
  PERFORM streetgen.generate('town');
  INSERT INTO town.transition_override (axis_id, which, kind, length, geom) VALUES (1, 'end', 'left', 8, pg_temp.place(100, 0));
  INSERT INTO town.lane_override (axis_id, abscissa, ordinality, along_axis, width, geom, line) VALUES (1, 80, 1, false, 4, pg_temp.place(80, 0), pg_temp.line('LINESTRING(60 1, 95 1)'));
  INSERT INTO town.section_limit_override (axis_id, abscissa, which, geom) VALUES (1, 90, 'end', pg_temp.place(90, 0));
  INSERT INTO town.kerb_point_override (axis_id, geom, abscissa, width) VALUES (1, pg_temp.place(75, 4), 75, 8);
  INSERT INTO town.corner_override (geom, axis_a, axis_b, radius) VALUES (pg_temp.place(100, 0), 1, 3, 9);
  INSERT INTO town.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting, control) VALUES (pg_temp.place(100, 0), 1, 2, 3, 2, true, pg_temp.place(98, -2));
  INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind) VALUES (1, 2, pg_temp.place(100, 0), 'no');
END $$;
-- All of them in one line of text; places as offsets.
CREATE FUNCTION pg_temp.decisions() RETURNS text LANGUAGE sql AS $$
  SELECT concat_ws('; ',
    (SELECT format('transition %s %s %s %s', axis_id, which, kind, pg_temp.at(geom)) FROM town.transition_override),
    (SELECT format('lane %s at %s %s %s %s %s', axis_id, round(abscissa), ordinality, along_axis, pg_temp.at(geom), pg_temp.at(ST_StartPoint(line))) FROM town.lane_override),
    (SELECT format('limit %s at %s %s %s', axis_id, round(abscissa), which, pg_temp.at(geom)) FROM town.section_limit_override),
    (SELECT format('kerb %s at %s %s %s', axis_id, round(abscissa), round(width), pg_temp.at(geom)) FROM town.kerb_point_override),
    (SELECT format('corner %s %s %s', axis_a, axis_b, pg_temp.at(geom)) FROM town.corner_override),
    (SELECT format('interconnection %s.%s %s.%s %s %s', axis_in, lane_in, axis_out, lane_out, pg_temp.at(geom), pg_temp.at(control)) FROM town.interconnection_override),
    (SELECT format('restriction %s %s %s', from_axis, to_axis, pg_temp.at(geom)) FROM town.turn_restriction)) $$;
CREATE FUNCTION pg_temp.at(place geometry) RETURNS text LANGUAGE sql AS $$ SELECT format('(%s %s)', round(ST_X(place) - 650000), round(ST_Y(place) - 6860000)) $$;
CREATE FUNCTION pg_temp.holds(name text, expected text) RETURNS TABLE (name text, holds boolean) LANGUAGE sql AS $$
  SELECT CASE WHEN expected = d THEN $1 ELSE format('%s: %s', $1, d) END, expected = d FROM pg_temp.decisions() d $$;

CALL pg_temp.decide();
SELECT 'as decided', pg_temp.decisions() = 'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)';

-- Split at 50, as QGIS does: the first piece in one transaction, the second in the next.
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 50 0)') \g /dev/null
SELECT * FROM pg_temp.holds('the first half of a split leaves all as it was',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
SELECT 'check_model lists what fits nowhere: ' || r, EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = r AND rule NOT LIKE 'stale%') FROM unnest('{lane_override,section_limit_override,corner_override,interconnection_override,turn_restriction}'::text[]) r;
UPDATE town.axis SET geom = ST_AddPoint(geom, pg_temp.place(200, 90)) WHERE axis_id = 4;
SELECT * FROM pg_temp.holds('an axis elsewhere does not catch them',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
SELECT pg_temp.draw(3, 'LINESTRING(100 0, 105 -40, 100 -80)') \g /dev/null
SELECT * FROM pg_temp.holds('nor does one that met the node before',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
SELECT pg_temp.draw(5, 'LINESTRING(50 0, 100 0)') \g /dev/null
SELECT * FROM pg_temp.holds('the second half takes what lies on it',
  'transition 5 end left (100 0); lane 5 at 30 1 f (80 0) (60 1); limit 5 at 40 end (90 0); kerb 5 at 25 8 (75 4); corner 5 3 (100 0); interconnection 5.2 3.2 (100 0) (98 -2); restriction 5 2 (100 0)');
SELECT 'and nothing more than before: ' || r, NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = r) FROM unnest('{lane_override,section_limit_override,corner_override,interconnection_override,turn_restriction}'::text[]) r;
SELECT 'the streets have them', (SELECT count(*) = 1 FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 5 AND method = 'by_hand') AND (SELECT abs(width - 8) < 1e-6 FROM town.edge WHERE axis_id = 5);
SELECT 'as generated from scratch', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');

-- Merge again: one extended, the other deleted, in either order.
BEGIN;
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 100 0)') \g /dev/null
DELETE FROM town.axis WHERE axis_id = 5;
SELECT * FROM pg_temp.holds('a merge that extends first',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
ROLLBACK;
DELETE FROM town.axis WHERE axis_id = 5;
SELECT * FROM pg_temp.holds('a deleted axis leaves its decisions',
  'transition 5 end left (100 0); lane 5 at 30 1 f (80 0) (60 1); limit 5 at 40 end (90 0); kerb 5 at 25 8 (75 4); corner 5 3 (100 0); interconnection 5.2 3.2 (100 0) (98 -2); restriction 5 2 (100 0)');
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 100 0)') \g /dev/null
SELECT * FROM pg_temp.holds('a merge that deletes first',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');

-- Split in one statement.
CALL pg_temp.decide();
WITH cut AS (UPDATE town.axis SET geom = pg_temp.line('LINESTRING(0 0, 50 0)') WHERE axis_id = 1)
INSERT INTO town.axis (axis_id, geom) VALUES (5, pg_temp.line('LINESTRING(50 0, 100 0)'));
SELECT * FROM pg_temp.holds('a split in one statement',
  'transition 5 end left (100 0); lane 5 at 30 1 f (80 0) (60 1); limit 5 at 40 end (90 0); kerb 5 at 25 8 (75 4); corner 5 3 (100 0); interconnection 5.2 3.2 (100 0) (98 -2); restriction 5 2 (100 0)');
-- A border between two axes that moves.
UPDATE town.axis SET geom = CASE axis_id WHEN 1 THEN pg_temp.line('LINESTRING(0 0, 85 0)') ELSE pg_temp.line('LINESTRING(85 0, 100 0)') END WHERE axis_id IN (1, 5);
SELECT * FROM pg_temp.holds('what lies between goes to the other axis',
  'transition 5 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 5 at 5 end (90 0); kerb 1 at 75 8 (75 4); corner 5 3 (100 0); interconnection 5.2 3.2 (100 0) (98 -2); restriction 5 2 (100 0)');

CALL pg_temp.decide();
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT * FROM pg_temp.holds('an axis turned round keeps its decisions on their side',
  'transition 1 start right (100 0); lane 1 at 20 2 t (80 0) (95 1); limit 1 at 10 start (90 0); kerb 1 at 25 8 (75 4); corner 1 3 (100 0); interconnection 1.1 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT * FROM pg_temp.holds('turned again, as it was',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');

-- Deleted, and drawn again from its other end: with another key, or with its own.
CALL pg_temp.decide();
INSERT INTO town.control_point (geom, kind, direction) VALUES (pg_temp.place(30, 2), 'stop', 'direct');
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'what lies on no axis keeps the heading and the lanes of the road', bool_and(abs(heading - pi() / 2) < 1e-9 AND lanes = 2) AND count(*) = 8 FROM town.lost_place;
SELECT pg_temp.draw(6, 'LINESTRING(100 0, 50 0, 0 0)') \g /dev/null
SELECT * FROM pg_temp.holds('a street drawn again from its other end has them on their side',
  'transition 6 start right (100 0); lane 6 at 20 2 t (80 0) (95 1); limit 6 at 10 start (90 0); kerb 6 at 25 8 (75 4); corner 6 3 (100 0); interconnection 6.1 3.2 (100 0) (98 -2); restriction 6 2 (100 0)');
SELECT 'and a stop sign speaks to the same traffic', (axis_id, direction) = (6, 'reverse') FROM town.control_point;
SELECT 'and nothing is lost any more', NOT EXISTS (SELECT FROM town.lost_place);
DELETE FROM town.axis WHERE axis_id = 6;
SELECT pg_temp.draw(6, 'LINESTRING(0 0, 100 0)') \g /dev/null
SELECT * FROM pg_temp.holds('also with the key that it had',
  'transition 6 end left (100 0); lane 6 at 80 1 f (80 0) (60 1); limit 6 at 90 end (90 0); kerb 6 at 75 8 (75 4); corner 6 3 (100 0); interconnection 6.2 3.2 (100 0) (98 -2); restriction 6 2 (100 0)');
-- Merged into a neighbour that is turned round with it.
DELETE FROM town.axis WHERE axis_id = 6;
SELECT pg_temp.draw(2, 'LINESTRING(200 0, 100 0, 0 0)') \g /dev/null
SELECT split_part(decisions, '; ', part) || ': a neighbour lengthened the other way has it on its side', split_part(decisions, '; ', part) = expected FROM pg_temp.decisions() decisions,
  (VALUES (2, 'lane 2 at 120 2 t (80 0) (95 1)'), (3, 'limit 2 at 110 start (90 0)'), (4, 'kerb 2 at 125 8 (75 4)')) v(part, expected);
-- In three pieces of which only the last lies at them, one after the other.
CALL pg_temp.decide();
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 50 0)') \g /dev/null
SELECT pg_temp.draw(1, 'LINESTRING(50 0, 0 0)') \g /dev/null
SELECT pg_temp.draw(5, 'LINESTRING(50 0, 100 0)') \g /dev/null
SELECT * FROM pg_temp.holds('the other half of a street that was turned round meanwhile has them as they were',
  'transition 5 end left (100 0); lane 5 at 30 1 f (80 0) (60 1); limit 5 at 40 end (90 0); kerb 5 at 25 8 (75 4); corner 5 3 (100 0); interconnection 5.2 3.2 (100 0) (98 -2); restriction 5 2 (100 0)');
-- A decision that is taken back is lost no more.
DELETE FROM town.axis WHERE axis_id = 5;
DELETE FROM town.lane_override;
DELETE FROM town.kerb_point_override;
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(50 0, 0 1)') WHERE axis_id = 1;
SELECT 'what is taken back is forgotten, the others are not', array_agg(relation ORDER BY relation) = '{corner_override,interconnection_override,section_limit_override,transition_override,turn_restriction}' FROM town.lost_place;
-- A model of an earlier build, which knows nothing of headings, gets the table.
DROP TABLE town.lost_place;
SELECT streetgen.adopt_model('town') \g /dev/null
DELETE FROM town.axis WHERE axis_id IN (1, 2);
SELECT 'a model of an earlier build gets the table', count(*) > 0 FROM town.lost_place;
CALL pg_temp.decide();

-- Two that change places.
INSERT INTO town.transition_override (axis_id, which, length, geom) VALUES (1, 'start', 3, pg_temp.place(0, 0));
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width, geom) VALUES (1, 50, 1, 3, pg_temp.place(50, 0)), (1, 50, 2, 4, pg_temp.place(50, 0));
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'both ends of an axis turned round', array_agg(concat_ws(' ', which, length) ORDER BY which) = '{end 3,start 8}' FROM town.transition_override;
SELECT 'and lanes side by side', array_agg(concat_ws(' ', ordinality, width) ORDER BY ordinality) = '{1 4,2 3}' FROM town.lane_override WHERE abscissa = 50;
-- One that comes to where another is.
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
INSERT INTO town.transition_override (axis_id, which, length, geom) VALUES (2, 'end', 5, pg_temp.place(200, 0));
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 200 0)') \g /dev/null
DELETE FROM town.axis WHERE axis_id = 2;
SELECT 'a merge keeps both', array_agg(concat_ws(' ', axis_id, which, length) ORDER BY transition_override_id) = '{1 end 8,1 start 3,1 end 5}' AND bool_and(ST_DWithin(geom, pg_temp.place(CASE length WHEN 8 THEN 100 WHEN 3 THEN 0 ELSE 200 END, 0), 1e-6)) FROM town.transition_override;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'what fits nowhere stays when its axis changes', concat_ws(' ', which, pg_temp.at(geom)) = 'end (100 0)' FROM town.transition_override WHERE length = 8;
CALL pg_temp.decide();

-- Redraw: a detour before, then the whole street aside.
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 0 10, 50 0, 100 0)') \g /dev/null
SELECT * FROM pg_temp.holds('a detour before them lengthens the way',
  'transition 1 end left (100 0); lane 1 at 91 1 f (80 0) (60 1); limit 1 at 101 end (90 0); kerb 1 at 86 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');
SELECT pg_temp.draw(1, 'LINESTRING(0 -2, 100 -2)') \g /dev/null
SELECT * FROM pg_temp.holds('an axis redrawn aside takes along what still meets, the kerb stays',
  'transition 1 end left (100 -2); lane 1 at 80 1 f (80 -2) (60 1); limit 1 at 90 end (90 -2); kerb 1 at 75 12 (75 4); corner 1 3 (100 -2); interconnection 1.2 3.2 (100 -2) (98 -4); restriction 1 2 (100 0)');

SELECT pg_temp.draw(1, 'LINESTRING(0 4, 100 4)') \g /dev/null
SELECT 'an axis drawn over its kerb point leaves it its width', (axis_id, width) = (1, 12) FROM town.kerb_point_override;
SELECT pg_temp.draw(1, 'LINESTRING(0 170, 100 170)') \g /dev/null
SELECT 'one drawn far away too, and that is told', (axis_id, width) = (1, 12) AND EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'kerb point override without its axis') FROM town.kerb_point_override;

-- The node is dragged: all its axes at once, or one after the other.
CALL pg_temp.decide();
UPDATE town.axis SET geom = CASE axis_id WHEN 1 THEN pg_temp.line('LINESTRING(0 0, 50 0, 100 9)') WHEN 2 THEN pg_temp.line('LINESTRING(100 9, 200 0)') ELSE pg_temp.line('LINESTRING(100 9, 100 -80)') END WHERE axis_id < 4;
SELECT split_part(decisions, '; ', part) || ': a node that moves takes it along', split_part(decisions, '; ', part) = expected FROM pg_temp.decisions() decisions,
  (VALUES (1, 'transition 1 end left (100 9)'), (5, 'corner 1 3 (100 9)'), (6, 'interconnection 1.2 3.2 (100 9) (98 7)'), (7, 'restriction 1 2 (100 9)')) v(part, expected);
CALL pg_temp.decide();
SELECT pg_temp.draw(3, 'LINESTRING(100 9, 100 -80)') \g /dev/null
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 50 0, 100 9)') \g /dev/null
SELECT split_part(decisions, '; ', part) || ': axis after axis too', split_part(decisions, '; ', part) = expected FROM pg_temp.decisions() decisions,
  (VALUES (1, 'transition 1 end left (100 9)'), (5, 'corner 1 3 (100 9)'), (6, 'interconnection 1.2 3.2 (100 9) (98 7)'), (7, 'restriction 1 2 (100 0)')) v(part, expected);

-- What is not meant stays untouched.
CALL pg_temp.decide();
CREATE TABLE decided AS SELECT xmin::text AS writer, ctid::text AS place FROM town.lane_override UNION ALL SELECT xmin::text, ctid::text FROM town.corner_override UNION ALL SELECT xmin::text, ctid::text FROM town.interconnection_override;
UPDATE town.axis SET width = 9;
UPDATE town.axis SET geom = ST_AddPoint(geom, pg_temp.place(0, -9), 0) WHERE axis_id = 4;
INSERT INTO town.axis (axis_id, geom) VALUES (9, pg_temp.line('LINESTRING(80 -40, 80 40)'));
SELECT 'decisions that lie where they did are not written', NOT EXISTS (TABLE decided EXCEPT (SELECT xmin::text, ctid::text FROM town.lane_override UNION ALL SELECT xmin::text, ctid::text FROM town.corner_override UNION ALL SELECT xmin::text, ctid::text FROM town.interconnection_override));
DELETE FROM town.axis WHERE axis_id = 1;
SELECT * FROM pg_temp.holds('an axis that only crosses the one that is gone takes nothing',
  'transition 1 end left (100 0); lane 1 at 80 1 f (80 0) (60 1); limit 1 at 90 end (90 0); kerb 1 at 75 8 (75 4); corner 1 3 (100 0); interconnection 1.2 3.2 (100 0) (98 -2); restriction 1 2 (100 0)');

-- A plain editor.
CALL pg_temp.decide();
CREATE ROLE streetgen_test_editor ROLE CURRENT_USER;
SELECT streetgen."grant"('town', 'streetgen_test_editor', 'editor') \g /dev/null
SET ROLE streetgen_test_editor;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
RESET ROLE;
SELECT 'an editor''s edit takes decisions along', pg_temp.decisions() LIKE 'transition 1 start right%';
SET ROLE streetgen_test_editor;
DELETE FROM town.axis WHERE axis_id = 1;
INSERT INTO town.axis (axis_id, geom, width, lane_count) VALUES (7, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 2);
RESET ROLE;
SELECT 'also where he draws the street again', pg_temp.decisions() LIKE 'transition 7 end left (100 0); lane 7 at 80 1 f (80 0) (60 1); limit 7 at 90 end (90 0);%';
SELECT 'nor writes what is known of lost places', NOT has_table_privilege('streetgen_test_editor', 'town.lost_place', 'INSERT, UPDATE, DELETE') AND has_table_privilege('streetgen_test_editor', 'town.lost_place', 'SELECT');
SELECT 'nobody calls a trigger by hand', NOT has_function_privilege('streetgen_test_editor', 'town.remap_update()', 'EXECUTE');
SELECT streetgen.drop_model('town') \g /dev/null
DROP ROLE streetgen_test_editor;

-- Decisions of several kinds that move with their street: all are followed by one computation.
CALL pg_temp.decide();
SELECT test.as_administrator('SET track_functions = ''pl''') \g /dev/null
BEGIN;
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 50 3, 100 0)') \g /dev/null
SELECT 'a street and what is decided on it are followed at once', pg_temp.decisions() <> '' AND calls = 1 FROM pg_stat_xact_user_functions WHERE (schemaname, funcname) = ('town', '_upsert_edited');
SELECT 'and leave nothing for the next edit', streetgen._remapped('town') IS NULL;
UPDATE town.lane_override SET width = 4.5;
SELECT 'an edit of a decision is followed on its own again', calls = 2 FROM pg_stat_xact_user_functions WHERE (schemaname, funcname) = ('town', '_upsert_edited');
COMMIT;
SELECT 'and are up to date', streetgen.live('town', true) = 0;

-- A user's trigger draws in another model whenever a decision moves: neither model follows the other's axes.
SELECT streetgen.create_model('sketch', 2154) \g /dev/null
CREATE FUNCTION pg_temp.sketch() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  INSERT INTO sketch.axis (geom) VALUES (pg_temp.line('LINESTRING(0 500, 100 500)'));
  RETURN NULL;
END $$;
CREATE TRIGGER a_sketch AFTER UPDATE ON town.transition_override FOR EACH STATEMENT EXECUTE FUNCTION pg_temp.sketch();
BEGIN;
-- Not yet handed in, what the transaction before called is counted too.
SELECT coalesce(sum(calls), 0) AS calls_before FROM pg_stat_xact_user_functions WHERE (schemaname, funcname) = ('town', '_upsert_edited') \gset
SELECT pg_temp.draw(1, 'LINESTRING(0 0, 50 -3, 100 0)') \g /dev/null
SELECT 'a decision that moves draws in another model', count(*) > 0 FROM sketch.edge;
SELECT 'and its own is followed by one computation all the same', calls = :calls_before + 1 FROM pg_stat_xact_user_functions WHERE (schemaname, funcname) = ('town', '_upsert_edited');
SELECT 'both leave nothing for the next edit', streetgen._remapped('town') IS NULL AND streetgen._remapped('sketch') IS NULL;
COMMIT;
SELECT 'and both are up to date', streetgen.live('town', true) = 0 AND streetgen.live('sketch', true) = 0;
SELECT streetgen.drop_model('sketch') \g /dev/null

-- A client that edits in place deletes rows and draws them again with their numbers, one by one, in any order.
CREATE FUNCTION pg_temp.redrawn(orders integer[]) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  CALL pg_temp.decide();
  CREATE TEMP TABLE was ON COMMIT DROP AS SELECT * FROM town.axis_editing;
  DELETE FROM town.axis_editing;
  INSERT INTO town.axis_editing SELECT * FROM was ORDER BY array_position(orders, axis_id::integer);
  DROP TABLE was;
  RETURN pg_temp.decisions();
END $$;
CALL pg_temp.decide();
CREATE TABLE as_decided AS SELECT pg_temp.decisions() AS decisions;
SELECT 'rows drawn again keep what was decided, in whatever order: ' || array_to_string(o, ' '), pg_temp.redrawn(o) = decisions
  FROM as_decided, (VALUES ('{1,2,3,4}'::integer[]), ('{1,3,2,4}'), ('{2,1,3,4}'), ('{2,3,1,4}'), ('{3,1,2,4}'), ('{3,2,1,4}'), ('{4,3,2,1}')) v(o);
SELECT 'none of it waits for its axis', NOT EXISTS (SELECT FROM town.lost_place);
SELECT 'the streets have it', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
SELECT test.as_administrator('RESET track_functions') \g /dev/null
SELECT streetgen.drop_model('town') \g /dev/null

-- What holds along an edge lies at its middle; its axis is cut just there.
SELECT streetgen.create_model('half', 2154, subjects => '{lane,sidewalk}') \g /dev/null
INSERT INTO half.axis (axis_id, geom, width, lane_count) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 7, 2);
UPDATE half.lane_editing SET width = 2.6 WHERE ordinality = 2;
BEGIN;
UPDATE half.axis SET geom = pg_temp.line('LINESTRING(0 0, 50 0)') WHERE axis_id = 1;
INSERT INTO half.axis (axis_id, geom, width, lane_count) VALUES (2, pg_temp.line('LINESTRING(50 0, 100 0)'), 7, 2);
COMMIT;
SELECT 'it holds on one of the pieces', count(*) = 1 FROM half.lane WHERE abs(width - 2.6) < 1e-9;
SELECT 'and nothing is without a place', NOT EXISTS (SELECT FROM streetgen.check_model('half') WHERE rule LIKE '%override without%');
