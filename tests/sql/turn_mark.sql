\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Turn marks of lanes hold to the junction ahead, over nodes at which a street goes on alone, and follow edits as far.
DO $$ BEGIN PERFORM streetgen.create_model('avenue', 2154), streetgen.create_model('scratch', 2154); END $$;
CREATE FUNCTION pg_temp.line(variadic at float8[]) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(650000 + at[2 * i - 1], 6860000 + at[2 * i]) FROM generate_series(1, cardinality(at) / 2) i)), 2154) $$;
-- Five pieces of 90 m that lead to a crossing; the first is marked, and the third was drawn against its traffic.
INSERT INTO avenue.axis (axis_id, geom, width, direction, lane_count, turn_forward) VALUES
    (1, pg_temp.line(-450, 0, -360, 0), 9, 'direct', 3, 'left|through|through;right'), (2, pg_temp.line(-360, 0, -270, 0), 9, 'direct', 3, NULL), (3, pg_temp.line(-180, 0, -270, 0), 9, 'reverse', 3, NULL),
    (4, pg_temp.line(-180, 0, -90, 0), 9, 'direct', 3, NULL), (5, pg_temp.line(-90, 0, 0, 0), 9, 'direct', 3, NULL), (6, pg_temp.line(0, 0, 120, 0), 12, 'both', 4, NULL),
    (7, pg_temp.line(0, 0, 0, 100), 6, 'both', 2, NULL), (8, pg_temp.line(0, 0, 0, -100), 6, 'both', 2, NULL);
UPDATE avenue.axis SET lanes_forward = 3, lanes_backward = 1 WHERE axis_id = 6;
CREATE FUNCTION pg_temp.marks(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(coalesce(turn, ''), '|' ORDER BY CASE WHEN along_axis THEN lane_position ELSE -lane_position END) FROM avenue.lane JOIN avenue.edge USING (edge_id) WHERE axis_id = axis $$;
-- Which lanes, from the left, lead from an axis to another.
CREATE FUNCTION pg_temp.ways(axis_in bigint, axis_out bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(lane::text, '' ORDER BY lane) FROM (SELECT DISTINCT i.lane_position AS lane FROM avenue.interconnection c JOIN avenue.lane i ON i.lane_id = lane_in
    JOIN avenue.lane o ON o.lane_id = lane_out JOIN avenue.edge a ON a.edge_id = i.edge_id JOIN avenue.edge b ON b.edge_id = o.edge_id WHERE plausible AND (a.axis_id, b.axis_id) = (axis_in, axis_out)) w $$;
SELECT 'marks hold on every piece', bool_and(pg_temp.marks(axis_id) = 'left|through|through;right') FROM avenue.axis WHERE axis_id <= 5;
SELECT 'and not beyond the crossing', NOT EXISTS (SELECT FROM avenue.lane JOIN avenue.edge USING (edge_id) WHERE axis_id > 5 AND turn IS NOT NULL);
SELECT 'traffic drives as they say', pg_temp.ways(5, 7) = '1' AND pg_temp.ways(5, 8) = '3' AND pg_temp.ways(5, 6) = '23';
SELECT 'arrows are painted there', count(*) = 3 AND count(DISTINCT ST_NPoints(surface)) = 3 FROM avenue.marking JOIN avenue.edge USING (edge_id) WHERE axis_id = 5 AND kind = 'arrow';
-- Edits, far from the crossing.
SELECT 'as from scratch', test.followed('avenue', 'scratch');
CREATE FUNCTION pg_temp.edited(what text, edit text) RETURNS TABLE(said text, holds boolean) LANGUAGE plpgsql AS $$
DECLARE
  differs text;
BEGIN
  EXECUTE edit;
  differs := test.difference('avenue', 'scratch');
  RETURN QUERY SELECT concat_ws(': ', what || ', as from scratch', differs), differs IS NULL;
END $$;
SELECT * FROM pg_temp.edited('marks changed', $$UPDATE avenue.axis SET turn_forward = 'left|left;through|right' WHERE axis_id = 1$$);
SELECT 'four pieces on they hold', pg_temp.marks(5) = 'left|left;through|right' AND pg_temp.ways(5, 7) = '12' AND pg_temp.ways(5, 6) = '2';
SELECT * FROM pg_temp.edited('a list of no turns farther on', $$UPDATE avenue.axis SET turn_forward = 'none|none|none' WHERE axis_id = 4$$);
SELECT * FROM pg_temp.edited('marks taken away', $$UPDATE avenue.axis SET turn_forward = NULL WHERE axis_id = 1$$);
SELECT 'they are gone everywhere', NOT EXISTS (SELECT FROM avenue.lane WHERE turn IS NOT NULL);
SELECT * FROM pg_temp.edited('marks given again', $$UPDATE avenue.axis SET turn_forward = 'left|through|right' WHERE axis_id = 1$$);
SELECT 'they are back everywhere', pg_temp.marks(5) = 'left|through|right';
SELECT 'an edit looks along streets with marks of another one', array_agg(DISTINCT axis_id ORDER BY axis_id) = '{2,3,4,5}' FROM avenue._marked_run('{1}');
BEGIN;
UPDATE avenue.axis SET turn_forward = 'left|through|right' WHERE axis_id IN (2, 3, 4, 5);
SELECT 'and not along those with marks of their own', count(*) = 0 FROM avenue._marked_run('{1}');
ROLLBACK;
SELECT * FROM pg_temp.edited('a side street before the third piece', $$INSERT INTO avenue.axis (axis_id, geom, width, lane_count) VALUES (9, pg_temp.line(-270, 0, -270, 80), 6, 2)$$);
SELECT 'the turn that it does not answer is meant for the next node', pg_temp.marks(2) = 'left|through|right' AND pg_temp.marks(3) = '|through|right' AND pg_temp.marks(5) = '|through|right';
SELECT * FROM pg_temp.edited('it goes on beyond the street', $$UPDATE avenue.axis SET geom = pg_temp.line(-270, -80, -270, 0, -270, 80) WHERE axis_id = 9$$);
SELECT 'marks end at it', pg_temp.marks(2) = 'left|through|right' AND pg_temp.marks(3) = '||' AND pg_temp.marks(5) = '||';
SELECT * FROM pg_temp.edited('the side street gone', $$DELETE FROM avenue.axis WHERE axis_id = 9$$);
SELECT 'marks go on to the crossing', pg_temp.marks(3) = 'left|through|right' AND pg_temp.marks(5) = 'left|through|right';
SELECT * FROM pg_temp.edited('marks of its own on the fourth piece', $$UPDATE avenue.axis SET turn_forward = 'through|through|right' WHERE axis_id = 4$$);
SELECT 'these hold from there', pg_temp.marks(3) = 'left|through|right' AND pg_temp.marks(5) = 'through|through|right';
SELECT * FROM pg_temp.edited('they are gone again', $$UPDATE avenue.axis SET turn_forward = NULL WHERE axis_id = 4$$);
SELECT * FROM pg_temp.edited('a lane begins on the third piece', $$UPDATE avenue.axis SET lane_count = 4, width = 12 WHERE axis_id IN (3, 4, 5)$$);
SELECT 'it takes the turn to its side', pg_temp.marks(3) = 'left|through|right|right' AND pg_temp.marks(5) = 'left|through|right|right';
SELECT * FROM pg_temp.edited('and ends', $$UPDATE avenue.axis SET lane_count = 3, width = 9 WHERE axis_id IN (3, 4, 5)$$);
SELECT * FROM pg_temp.edited('a street at the crossing moved', $$UPDATE avenue.axis SET geom = pg_temp.line(0, 0, 5, 100) WHERE axis_id = 7$$);
SELECT 'nothing is lost by it', pg_temp.marks(5) = 'left|through|right' AND pg_temp.ways(5, 7) = '1';
SELECT * FROM pg_temp.edited('the second piece turned round', $$UPDATE avenue.axis SET geom = ST_Reverse(geom), direction = 'reverse' WHERE axis_id = 2$$);
SELECT * FROM pg_temp.edited('it is moved away', $$UPDATE avenue.axis SET geom = pg_temp.line(-365, 10, -275, 10) WHERE axis_id = 2$$);
SELECT 'marks are not on what is cut off', pg_temp.marks(5) = '||';
SELECT * FROM pg_temp.edited('and put back', $$UPDATE avenue.axis SET geom = pg_temp.line(-270, 0, -360, 0) WHERE axis_id = 2$$);
SELECT * FROM pg_temp.edited('the first piece deleted', $$DELETE FROM avenue.axis WHERE axis_id = 1$$);
SELECT 'its marks go with it', NOT EXISTS (SELECT FROM avenue.lane WHERE turn IS NOT NULL);

-- Side streets on the right alone, and lanes that are marked to turn left.
SELECT streetgen.create_model('unanswered', 2154) \g /dev/null
INSERT INTO unanswered.axis (axis_id, geom, width, direction, lane_count, turn_forward) VALUES (1, pg_temp.line(-150, 0, 0, 0), 6, 'direct', 2, 'left|through'),
    (2, pg_temp.line(0, 0, 90, 0), 6, 'direct', 2, NULL), (3, pg_temp.line(0, 0, 0, -100), 6, 'both', 2, NULL), (4, pg_temp.line(90, 0, 180, 0), 6, 'direct', 2, NULL), (5, pg_temp.line(90, 0, 90, -100), 6, 'both', 2, NULL);
CREATE FUNCTION pg_temp.unanswered() RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(axis_id || ' ' || turn, ', ' ORDER BY axis_id) FROM streetgen.check_model('unanswered') f JOIN unanswered.lane ON lane_id = id JOIN unanswered.edge USING (edge_id) WHERE rule = 'lane marked for a turn that no way answers' $$;
INSERT INTO unanswered.axis (axis_id, geom, width) VALUES (6, pg_temp.line(180, 0, 180, -100), 6), (7, pg_temp.line(180, 0, 330, 0), 6);
SELECT 'a mark that no way answers is told where it ends: ' || coalesce(pg_temp.unanswered(), ''), pg_temp.unanswered() = '4 left';
UPDATE unanswered.axis SET turn_forward = 'through|right' WHERE axis_id = 2;
SELECT 'not where the street states others', pg_temp.unanswered() IS NULL;
UPDATE unanswered.axis SET turn_forward = NULL WHERE axis_id = 2;
INSERT INTO unanswered.axis (axis_id, geom, width) VALUES (8, pg_temp.line(90, 0, 90, 100), 6);
SELECT 'nor where a way answers it farther on', pg_temp.unanswered() IS NULL;
DELETE FROM unanswered.axis WHERE axis_id = 8;
SELECT 'it is told again without that way', pg_temp.unanswered() = '4 left';

-- A lane in the middle, for those who turn left.
SELECT streetgen.create_model('middle', 2154) \g /dev/null
INSERT INTO middle.axis (axis_id, geom, width, lanes_forward, lanes_backward, lanes_both) VALUES (1, pg_temp.line(-150, 0, 0, 0), 10.5, 1, 1, 1), (2, pg_temp.line(0, 0, 150, 0), 10.5, 1, 1, 1),
    (3, pg_temp.line(0, 0, 0, 100), 7, 1, 1, NULL), (4, pg_temp.line(150, 0, 300, 0), 7, 1, 1, NULL);
CREATE VIEW middle_way AS SELECT a.axis_id AS axis_in, b.axis_id AS axis_out, i.both_ways AS from_middle, o.both_ways AS to_middle FROM middle.interconnection c
    JOIN middle.lane i ON i.lane_id = lane_in JOIN middle.lane o ON o.lane_id = lane_out JOIN middle.edge a ON a.edge_id = i.edge_id JOIN middle.edge b ON b.edge_id = o.edge_id WHERE connecting;
SELECT 'from the middle one turns left alone', array_agg(concat(axis_in, '>', axis_out)) = '{1>3}' FROM middle_way WHERE from_middle;
SELECT 'nobody is led into it', NOT EXISTS (SELECT FROM middle_way WHERE to_middle);
SELECT 'one goes straight on beside it', count(*) = 4 FROM middle_way WHERE NOT from_middle AND (axis_in, axis_out) IN ((1, 2), (2, 1), (2, 4), (4, 2));
SELECT 'nothing is wrong with that', NOT EXISTS (SELECT FROM streetgen.check_model('middle') WHERE rule LIKE 'lane %');

-- A model without lanes has no marks, and is edited as before.
SELECT streetgen.create_model('bare', 2154, subjects => '{}') \g /dev/null
INSERT INTO bare.axis (axis_id, geom, width, direction, lane_count, turn_forward) VALUES (1, pg_temp.line(0, 0, 90, 0), 6, 'direct', 2, 'left|through'), (2, pg_temp.line(90, 0, 180, 0), 6, 'direct', 2, NULL);
UPDATE bare.axis SET turn_forward = NULL WHERE axis_id = 1;
SELECT 'a model without lanes is edited', count(*) = 2 FROM bare.section;
