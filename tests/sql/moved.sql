\set ECHO none
\ir shared/truths.sql
\ir shared/moved.sql
-- Streets do not turn with the paper: a model of moved input is the moved model, row by row, to a micrometre.
CREATE FUNCTION pg_temp.differs() RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(format('%s: %s and %s rows, %s alone, %s differ by %s m, %s m2 in %s at %s', relation, rows, rows_moved, alone, differ, widest, round(area::numeric, 4), cols, place), '; ')
  FROM test.moved_difference() WHERE alone > 0 OR differ > 0 OR rows <> rows_moved $$;
CREATE FUNCTION pg_temp.holds(sentence text) RETURNS TABLE (truth text, holds boolean) LANGUAGE plpgsql AS $$
DECLARE
  said constant text := pg_temp.differs();
BEGIN
  RETURN QUERY SELECT sentence || coalesce(' -- ' || said, ''), said IS NULL;
END $$;

-- Decisions by hand, in the quarter with all subjects.
\o /dev/null
\ir ../../data/quarter.sql
\o
INSERT INTO quarter.turn_restriction (from_axis, to_axis, geom, kind)
  SELECT a.axis_id, b.axis_id, ST_EndPoint(a.geom), 'no' FROM quarter.axis a JOIN quarter.axis b ON a.name = 'avenue west' AND b.name = 'cross street one, south';
INSERT INTO quarter.corner_override (geom, axis_a, axis_b, radius)
  SELECT ST_EndPoint(a.geom), a.axis_id, b.axis_id, 3 FROM quarter.axis a JOIN quarter.axis b ON a.name = 'avenue west' AND b.name = 'cross street one, south';
INSERT INTO quarter.section_limit_override (axis_id, abscissa, which) SELECT axis_id, 20, 'start' FROM quarter.axis WHERE name = 'avenue middle';
INSERT INTO quarter.sidewalk_override (axis_id, abscissa, side, width) SELECT axis_id, 40, 'left', 4 FROM quarter.axis WHERE name = 'avenue east';
INSERT INTO quarter.lane_override (axis_id, abscissa, ordinality, width) SELECT axis_id, 40, 3, 2.5 FROM quarter.axis WHERE name = 'avenue east';
UPDATE quarter.axis SET roadway_offset = 1, turn_forward = 'left|through;right' WHERE name = 'avenue west';
SELECT count(*) FROM streetgen.generate('quarter') \g /dev/null
CALL test.move('quarter', 'turned', turn => 90);
SELECT * FROM pg_temp.holds('a quarter turned by 90 degrees is the quarter turned');
CALL test.move('quarter', 'aslant', turn => 53, shift_x => -2000, shift_y => 12000);
SELECT * FROM pg_temp.holds('aslant and elsewhere too');
CALL test.move('quarter', 'mirrored', mirrored => true);
SELECT * FROM pg_temp.holds('in the mirror, where one drives on the other side');
CALL test.move('quarter', 'drawn_back', reversed => true);
SELECT * FROM pg_temp.holds('with every second axis drawn backwards');
CALL test.move('quarter', 'renumbered', renumbered => true);
SELECT * FROM pg_temp.holds('with other numbers of its axes');

-- Places where little decides: ends a step apart, a street drawn twice, one that crosses itself, equal streets that cross.
SELECT streetgen.create_model('ties', 2154) \g /dev/null
INSERT INTO ties.axis (geom, width, importance)
  SELECT ST_Translate(ST_SetSRID(wkt::geometry, 2154), 650000 + 300 * place, 6860000), width, 4 FROM (VALUES
    -- Three ends 0.3 m apart.
    (0, 'LINESTRING(0 0, -60 20)', 8), (0, 'LINESTRING(0.3 0, 70 -10)', 7), (0, 'LINESTRING(0.15 0.26, 10 80)', 6),
    -- Two that meet, and one that ends beside.
    (1, 'LINESTRING(-60 -3, 0 0)', 8), (1, 'LINESTRING(0 0, 70 5)', 8), (1, 'LINESTRING(0.2 0.3, -8 60)', 6),
    -- Drawn twice, a hand aside.
    (2, 'LINESTRING(0 0, 40 10, 90 12)', 7), (2, 'LINESTRING(1 60, 41 11.5, 91 13)', 7), (2, 'LINESTRING(0 0, -30 -40)', 6),
    -- A street that crosses itself.
    (3, 'LINESTRING(0 0, 60 0, 60 40, 31 38, 29 -40)', 7), (3, 'LINESTRING(0 0, -50 10)', 7),
    -- Equal streets that cross without a node.
    (4, 'LINESTRING(-50 0, 52 1)', 7), (4, 'LINESTRING(3 -55, -4 61)', 7), (4, 'LINESTRING(52 1, 90 30)', 7),
    -- Neighbouring nodes with equal streets.
    (5, 'LINESTRING(-60 0, 0 0, 11 0, 70 0)', 7), (5, 'LINESTRING(0 0, -3 50)', 7), (5, 'LINESTRING(11 0, 14 49)', 7), (5, 'LINESTRING(11 0, 8 -52)', 7)) t(place, wkt, width);
SELECT count(*) FROM streetgen.generate('ties') \g /dev/null
CALL test.move('ties', 'ties_moved', renumbered => true);
SELECT * FROM pg_temp.holds('ties go by no number');
CALL test.move('ties', 'ties_moved', reversed => true);
SELECT * FROM pg_temp.holds('by no direction of an axis');
CALL test.move('ties', 'ties_moved', mirrored => true, turn => 22);
SELECT * FROM pg_temp.holds('and by no side');
CALL test.move('ties', 'ties_moved', turn => 45, renumbered => true, reversed => true);
SELECT * FROM pg_temp.holds('by nothing of these together');

-- Signals where equal streets meet: who comes first has green first.
SELECT streetgen.create_model('lights', 2154, subjects => '{signal}', driving_side => 'right') \g /dev/null
INSERT INTO lights.axis (geom, width, importance)
  SELECT ST_MakeLine(node, ST_Translate(node, 80 * cosd(degrees), 80 * sind(degrees))), 8, 4
  FROM (VALUES (0), (71), (147), (218), (291)) d(degrees), ST_SetSRID(ST_MakePoint(650000, 6860000), 2154) node;
INSERT INTO lights.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000 6860000)', 'signals');
SELECT count(*) FROM streetgen.generate('lights') \g /dev/null
SELECT 'five equal streets meet at signals', count(DISTINCT ordinality) > 2 FROM lights.signal_movement;
CALL test.move('lights', 'lights_moved', renumbered => true);
SELECT * FROM pg_temp.holds('signals go by no number');
CALL test.move('lights', 'lights_moved', mirrored => true, turn => 22);
SELECT * FROM pg_temp.holds('nor by a side');
