\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Lanes lead to those that serve what one turns to at the next node, where no way is left to change lanes; edits follow.
DO $$ BEGIN PERFORM streetgen.create_model('right_hand', 2154), streetgen.create_model('left_hand', 2154), streetgen.create_model('scratch', 2154);
    PERFORM streetgen.set('left_hand', 'driving_side', 'left'); END $$;
CREATE FUNCTION pg_temp.line(variadic at float8[]) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(650000 + at[2 * i - 1], 6860000 + at[2 * i]) FROM generate_series(1, cardinality(at) / 2) i)), 2154) $$;
-- An avenue of two lanes to the east, which becomes one lane beyond a street to the left. The piece before is drawn backward. A street comes onto it from the right.
CREATE VIEW street AS SELECT * FROM (VALUES
    (1::bigint, pg_temp.line(-120, 0, 0, 0), 6::float8, 'direct', 2), (2, pg_temp.line(34, 0, 0, 0), 6, 'reverse', 2), (3, pg_temp.line(34, 0, 150, 0), 3, 'direct', 1),
    (4, pg_temp.line(0, -100, 0, 0), 3, 'direct', 1), (5, pg_temp.line(34, 0, 34, 100), 3, 'direct', 1)) v(axis_id, geom, width, direction, lane_count);
INSERT INTO right_hand.axis (axis_id, geom, width, direction, lane_count) TABLE street;
INSERT INTO left_hand.axis (axis_id, geom, width, direction, lane_count)
    SELECT axis_id, ST_Translate(ST_Scale(ST_Translate(geom, -650000, -6860000), 1, -1), 650000, 6860000), width, direction, lane_count FROM street;
-- Which lanes of an axis, from the left as one drives, another leads to.
CREATE FUNCTION pg_temp.reached(model name, axis_from bigint, axis_to bigint) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  found text;
BEGIN
  EXECUTE format('SELECT string_agg(lane::text, '''' ORDER BY lane) FROM (SELECT DISTINCT row_number AS lane FROM %1$I.interconnection c
      JOIN (SELECT lane_id, axis_id, row_number() OVER (PARTITION BY edge_id, along_axis ORDER BY CASE WHEN along_axis THEN lane_position ELSE -lane_position END) FROM %1$I.lane JOIN %1$I.edge USING (edge_id)) o
      ON o.lane_id = lane_out JOIN %1$I.lane i ON i.lane_id = lane_in JOIN %1$I.edge a ON a.edge_id = i.edge_id WHERE plausible AND (a.axis_id, o.axis_id) = ($1, $2)) w', model) INTO found USING axis_from, axis_to;
  RETURN found;
END $$;
CREATE FUNCTION pg_temp.edited(what text, edit text) RETURNS TABLE(said text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE edit;
  RETURN QUERY SELECT what || ': as from scratch', test.followed('right_hand', 'scratch');
END $$;
SELECT 'who enters reaches the lane that turns off', pg_temp.reached('right_hand', 4, 2) = '12';
SELECT 'and one says why', count(*) = 1 FROM right_hand.interconnection WHERE reason = 'look_ahead' AND plausible;
SELECT 'who comes along keeps his lanes', pg_temp.reached('right_hand', 1, 2) = '12' AND count(*) = 2
    FROM right_hand.interconnection JOIN right_hand.lane ON lane_id = lane_in JOIN right_hand.edge USING (edge_id) WHERE axis_id = 1 AND plausible;
SELECT 'so on the left', pg_temp.reached('left_hand', 4, 2) = '12' AND (SELECT count(*) FROM left_hand.interconnection WHERE plausible AND reason = 'look_ahead') = 1;
SELECT 'as from scratch', test.followed('right_hand', 'scratch');
SELECT * FROM pg_temp.edited('a street comes onto it at 40 degrees', $$UPDATE right_hand.axis SET geom = pg_temp.line(-92, -77, 0, 0) WHERE axis_id = 4$$);
SELECT 'it crosses who goes on', pg_temp.reached('right_hand', 4, 2) = '12';
SELECT * FROM pg_temp.edited('at 30 degrees', $$UPDATE right_hand.axis SET geom = pg_temp.line(-104, -60, 0, 0) WHERE axis_id = 4$$);
SELECT 'it merges', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('at a right angle', $$UPDATE right_hand.axis a SET geom = s.geom FROM street s WHERE s.axis_id = a.axis_id AND a.axis_id = 4$$);
SELECT * FROM pg_temp.edited('the street to the left comes in', $$UPDATE right_hand.axis SET direction = 'reverse' WHERE axis_id = 5$$);
SELECT 'nobody turns off', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('it goes off again', $$UPDATE right_hand.axis SET direction = 'direct' WHERE axis_id = 5$$);
SELECT 'one looks ahead again', pg_temp.reached('right_hand', 4, 2) = '12';
SELECT * FROM pg_temp.edited('the turn is forbidden', $$INSERT INTO right_hand.turn_restriction (from_axis, to_axis, geom, kind) VALUES (2, 5, ST_SetSRID(ST_MakePoint(650034, 6860000), 2154), 'no')$$);
SELECT 'nobody looks for it', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('it is allowed', $$DELETE FROM right_hand.turn_restriction$$);
SELECT * FROM pg_temp.edited('the street to the left gone', $$DELETE FROM right_hand.axis WHERE axis_id = 5$$);
SELECT 'nothing lies ahead', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('a street to the left', $$INSERT INTO right_hand.axis (axis_id, geom, width, direction, lane_count) SELECT * FROM street WHERE axis_id = 5$$);
SELECT * FROM pg_temp.edited('the next node farther off', $$UPDATE right_hand.axis SET geom = CASE axis_id WHEN 2 THEN pg_temp.line(94, 0, 0, 0) WHEN 3 THEN pg_temp.line(94, 0, 150, 0) ELSE pg_temp.line(94, 0, 94, 100) END WHERE axis_id IN (2, 3, 5)$$);
SELECT 'there is room to change lanes', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('and near', $$UPDATE right_hand.axis a SET geom = s.geom FROM street s WHERE s.axis_id = a.axis_id$$);
-- What is left of the lane is measured between the limits, and wide streets leave less.
SELECT streetgen.set('right_hand', 'look_ahead', '6'), streetgen.set('scratch', 'look_ahead', '6'), streetgen.generate('right_hand') \g /dev/null
SELECT 'enough lane is left', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT * FROM pg_temp.edited('the street to the left is wide', $$UPDATE right_hand.axis SET width = 20 WHERE axis_id = 5$$);
SELECT 'it leaves too little', pg_temp.reached('right_hand', 4, 2) = '12';
SELECT * FROM pg_temp.edited('it is narrow', $$UPDATE right_hand.axis SET width = 3 WHERE axis_id = 5$$);
SELECT 'enough is left again', pg_temp.reached('right_hand', 4, 2) = '2';
SELECT streetgen.set('right_hand', 'look_ahead', '0'), streetgen.generate('right_hand') \g /dev/null
SELECT 'by setting nobody looks ahead', pg_temp.reached('right_hand', 4, 2) = '2' AND NOT EXISTS (SELECT FROM right_hand.interconnection WHERE reason = 'look_ahead');
-- Carriageways of two streets cross, so many metres apart. Who turns back over a median turns left twice, and tightly.
SELECT streetgen.create_model('median', 2154) \g /dev/null
CREATE FUNCTION pg_temp.cross_apart(m float8) RETURNS void LANGUAGE sql AS $$
    DELETE FROM median.axis;
    INSERT INTO median.axis (axis_id, geom, width, direction, lane_count)
    SELECT 10 * street + piece, pg_temp.line(x + along_x * a, y + along_y * a, x + along_x * b, y + along_y * b),
        7, 'direct', 2
    FROM (VALUES (1, 0, 0, 1, 0), (2, m, 0, 0, 1), (3, m, m, -1, 0), (4, 0, m, 0, -1)) s(street, x, y, along_x, along_y),
        (VALUES (1, -99, 0), (2, 0, m), (3, m, 99)) p(piece, a, b) $$;
-- The radius of the first turn is half of that less half of a lane.
CREATE FUNCTION pg_temp.turned_on() RETURNS TABLE (lane integer, reason text) LANGUAGE sql AS $$
    SELECT o.lane_position, c.reason FROM median.interconnection c
        JOIN median.lane i ON i.lane_id = lane_in JOIN median.edge a ON a.edge_id = i.edge_id
        JOIN median.lane o ON o.lane_id = lane_out JOIN median.edge b ON b.edge_id = o.edge_id
    WHERE plausible AND (a.axis_id, b.axis_id) = (12, 22) $$;
SELECT pg_temp.cross_apart(8) \g /dev/null
SELECT 'who turns back over a median finds the lane that turns on, at a radius of 2.25 m',
    (SELECT reason = 'look_ahead' FROM pg_temp.turned_on() WHERE lane = 1);
SELECT pg_temp.cross_apart(11) \g /dev/null
SELECT 'at 3.75 m it is an ordinary turn', array_agg(lane) = '{1}' AND NOT bool_or(reason = 'look_ahead')
    FROM pg_temp.turned_on();
