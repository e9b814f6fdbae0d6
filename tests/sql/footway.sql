\set ECHO none
\ir shared/truths.sql
-- Footways beside streets: the sidewalks that they map, live, by hand and of several rights.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.widths(model name) RETURNS text LANGUAGE plpgsql AS $$ DECLARE said text; BEGIN
  EXECUTE format('SELECT string_agg(concat_ws('':'', axis_id, round(sidewalk_left::numeric, 6), round(sidewalk_right::numeric, 6)), '' '' ORDER BY axis_id, start_abscissa) FROM %I.edge', model) INTO said; RETURN said; END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{footway}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, radius, importance, sidewalk_left, roadway_offset, width_end) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 5, 4, NULL, NULL, NULL), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 5, 4, NULL, NULL, NULL),
    (3, pg_temp.line('LINESTRING(100 0,100 90)'), 6, 5, 4, 2.5, NULL, NULL), (4, pg_temp.line('LINESTRING(0 300,100 300)'), 8, 5, 4, NULL, 1, NULL),
    (5, pg_temp.line('LINESTRING(0 400,100 400)'), 6, 5, 4, NULL, NULL, 10);
END $$;
SELECT 'without footways sidewalks are estimated', pg_temp.widths('town') = '1:2.000000:2.000000 2:2.000000:2.000000 3:2.500000:2.000000 4:2.000000:2.000000 5:2.000000:2.000000';
INSERT INTO town.footway (footway_id, geom, role, width) VALUES (1, pg_temp.line('LINESTRING(5 6,90 6)'), 'sidewalk', NULL), (2, pg_temp.line('LINESTRING(195 -5.5,5 -5.5)'), 'sidewalk', NULL),
  (3, pg_temp.line('LINESTRING(110 6,190 6)'), 'sidewalk', 1.8), (4, pg_temp.line('LINESTRING(95 10,95 80)'), 'sidewalk', NULL), (5, pg_temp.line('LINESTRING(5 306.5,95 306.5)'), 'sidewalk', NULL),
  (6, pg_temp.line('LINESTRING(0 406,100 406)'), 'sidewalk', NULL), (7, pg_temp.line('LINESTRING(5 295,95 295)'), NULL, NULL), (8, pg_temp.line('LINESTRING(50 -20,50 20)'), 'sidewalk', NULL),
  (9, pg_temp.line('LINESTRING(5 394,95 394)'), 'crossing', NULL);
SELECT 'twice as wide as the footway lies from the kerb', sidewalk_left = 4 AND sidewalk_right BETWEEN 2.999999 AND 3.000001 AND NOT estimated && '{sidewalk_left,sidewalk_right}' FROM town.edge WHERE axis_id = 1;
SELECT 'as wide as the footway says, and what leads to it', abs(sidewalk_left - (2 + 0.9)) < 1e-6 FROM town.edge WHERE axis_id = 2;
SELECT 'what the axis says comes first', sidewalk_left = 2.5 FROM town.edge WHERE axis_id = 3;
SELECT 'from the kerb of a roadway beside its axis', abs(sidewalk_left - 3) < 1e-6 AND sidewalk_right = 2 AND estimated @> '{sidewalk_right}' FROM town.edge WHERE axis_id = 4;
SELECT 'a footway of two streets is of both', count(*) = 2 AND count(DISTINCT edge_id) = 2 AND bool_and(side = 'right') FROM town.sidewalk_source WHERE footway_id = 2;
SELECT 'where the kerb runs away, from its middle', abs(distance - 2) < 0.2 FROM town.sidewalk_source WHERE footway_id = 6;
SELECT 'one across a street, over it, or of no role is of none', NOT EXISTS (SELECT FROM town.sidewalk_source WHERE footway_id IN (7, 8, 9));
SELECT 'stretches lie on their edges', bool_and(s.start_abscissa >= 0 AND s.end_abscissa <= ST_Length(e.geom) + 1e-6 AND s.start_abscissa < s.end_abscissa) FROM town.sidewalk_source s JOIN town.edge e USING (edge_id);
SELECT 'the footway lies on its sidewalk', bool_and(ST_Length(ST_Intersection(f.geom, w.geom)) > 0.85 * ST_Length(f.geom)) FROM town.footway f, (SELECT ST_Union(surface) AS geom FROM town.sidewalk) w WHERE footway_id IN (1, 2, 5, 6);
-- A line that leads away from the kerb, and one beside an axis that says 0. Near its ends a line may lead to a crossing, so the sidewalk is as wide as 10 m from there.
SELECT streetgen.create_model('slant', 2154, subjects => '{footway}', driving_side => 'right') \g /dev/null
INSERT INTO slant.axis (axis_id, geom, width, importance, sidewalk_left, sidewalk_right) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4, 0, 0), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 8, 4, NULL, NULL);
INSERT INTO slant.footway (footway_id, geom, role, width) VALUES (1, pg_temp.line('LINESTRING(0 5,100 9)'), 'sidewalk', NULL), (2, pg_temp.line('LINESTRING(0 106,40 106)'), 'sidewalk', 2), (3, pg_temp.line('LINESTRING(60 107,100 107)'), 'sidewalk', 2);
SELECT 'a line counts where the axis says 0, and there alone', abs(sidewalk_left - 6) < 0.1 AND sidewalk_right = 0 FROM slant.edge WHERE axis_id = 1;
SELECT 'a sidewalk becomes wider where its line leads away', abs(s.widest - 6) < 0.01 AND cardinality(places) = 2 AND cardinality(widths) = 2 FROM slant.sidewalk_source s WHERE footway_id = 1;
SELECT 'its line lies on it all along', ST_Length(ST_Intersection(w.surface, f.geom)) > 99 AND abs(ST_Area(w.surface) - 100 * (3 + 6) / 2) < 100 * 0.05 FROM slant.sidewalk w JOIN slant.edge USING (edge_id), slant.footway f WHERE axis_id = 1 AND side = 'left' AND footway_id = 1;
SELECT 'a cross-section shows what lies there', bool_and(abs(offset_to - (4 + 3 + 3 * start_abscissa / 100)) < 0.1 AND abs(offset_to_end - (4 + 3 + 3 * end_abscissa / 100)) < 0.1) FROM slant.cross_section WHERE axis_id = 1 AND side = 'left' AND kind = 'sidewalk';
SELECT 'from one line to the next the width runs straight', bool_and(ST_Covers(ST_Buffer(w.surface, 1e-6), pg_temp.line(inner_line)) AND NOT ST_Intersects(w.surface, pg_temp.line(outer_line)))
  FROM slant.sidewalk w JOIN slant.edge USING (edge_id), (VALUES ('POINT(20 105.95)', 'POINT(20 106.05)'), ('POINT(50 106.9)', 'POINT(50 107.1)'), ('POINT(80 107.95)', 'POINT(80 108.05)')) v(inner_line, outer_line) WHERE axis_id = 2 AND side = 'left';
UPDATE slant.sidewalk_editing SET width = 0 WHERE side = 'left' AND edge_id = (SELECT edge_id FROM slant.edge WHERE axis_id = 1);
SELECT '0 by hand holds', sidewalk_left = 0 FROM slant.edge WHERE axis_id = 1;

-- Edits of all kinds, each against a run over all.
CREATE FUNCTION pg_temp.as_from_scratch(model name) RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE before text; again text; was text;
  stands constant text := 'SELECT string_agg(md5(concat_ws('','', e.axis_id, e.start_abscissa::numeric(12, 6), s.side, s.part, s.footway_id, s.start_abscissa::numeric(12, 6), s.width::numeric(12, 6), s.places::numeric(12, 6)[], s.widths::numeric(12, 6)[])), '''' ORDER BY e.axis_id, e.start_abscissa, s.side, s.part) FROM %I.sidewalk_source s JOIN %1$I.edge e USING (edge_id)'; BEGIN
  EXECUTE format(stands, model) INTO before; was := pg_temp.widths(model);
  EXECUTE format('UPDATE %I.edge SET input_hash = 0', model); PERFORM FROM streetgen.generate(model, wait => true);
  EXECUTE format(stands, model) INTO again;
  RETURN (before, was) IS NOT DISTINCT FROM (again, pg_temp.widths(model)); END $$;
CREATE FUNCTION pg_temp.stale(model name) RETURNS void LANGUAGE plpgsql SET streetgen.computes = 'on' AS $$ BEGIN EXECUTE format('UPDATE %I.edge SET input_hash = 0', model); END $$;
UPDATE town.footway SET geom = ST_Translate(geom, 0, 1) WHERE footway_id = 1;
SELECT 'a sidewalk follows its footway', sidewalk_left = 6 FROM town.edge WHERE axis_id = 1;
UPDATE town.axis SET width = 10 WHERE axis_id = 1;
SELECT 'and its street', abs(sidewalk_left - 4) < 1e-6 FROM town.edge WHERE axis_id = 1;
UPDATE town.sidewalk_editing SET width = 1.2 WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 1) AND side = 'left';
SELECT 'a width by hand comes first', sidewalk_left = 1.2 FROM town.edge WHERE axis_id = 1;
DELETE FROM town.sidewalk_editing WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 1) AND side = 'left';
UPDATE town.footway SET role = NULL WHERE footway_id = 5;
SELECT 'a footway that is none any more leaves an estimate', sidewalk_left = 2 AND estimated @> '{sidewalk_left}' FROM town.edge WHERE axis_id = 4;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 2;
SELECT 'a street that turns round keeps its sides', abs(sidewalk_right - 2.9) < 1e-6 FROM town.edge WHERE axis_id = 2;
DELETE FROM town.footway WHERE footway_id = 3;
SELECT 'one that is gone leaves no row', NOT EXISTS (SELECT FROM town.sidewalk_source WHERE footway_id IN (3, 5));
DELETE FROM town.axis WHERE axis_id = 4;
UPDATE town.footway SET level = 1 WHERE footway_id = 6;
SELECT 'one of another level is of no street of this', NOT EXISTS (SELECT FROM town.sidewalk_source WHERE footway_id = 6);
BEGIN;
SELECT streetgen.live('town', false) \g /dev/null
INSERT INTO town.footway (geom, role) VALUES (pg_temp.line('LINESTRING(40 -20,40 20)'), 'crossing');
SELECT 'a crossing is no sidewalk, and no street waits for it but one that has objects', streetgen._stale_axes('town') = (to_regclass('town.street_object') IS NOT NULL)::integer;
DELETE FROM town.footway WHERE ST_DWithin(geom, pg_temp.line('LINESTRING(40 -20,40 20)'), 0) AND role = 'crossing' AND ST_Length(geom) = 40 AND ST_XMin(geom) = 650040;
UPDATE town.footway SET geom = ST_Translate(geom, 0, -0.4) WHERE footway_id = 1;
SELECT 'what is not followed is due', streetgen._stale_axes('town') > 0;
SELECT streetgen.live('town', true) \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'and done then', abs(sidewalk_left - 3.2) < 1e-6 FROM town.edge WHERE axis_id = 1;
COMMIT;

-- Random streets and footways, edited at random: all as from scratch.
DO $$ DECLARE n integer; BEGIN
  PERFORM setseed(0.48), streetgen.create_model('random', 2154, subjects => '{footway}', driving_side => 'right');
  INSERT INTO random.axis (geom, width, importance) SELECT pg_temp.line(format('LINESTRING(%s %s,%s %s)', 60 * i, 0, 60 * i + 8 * random(), 180)), CASE WHEN i < 2 THEN 5 + 5 * random() END, 4 FROM generate_series(0, 3) i
    UNION ALL SELECT pg_temp.line(format('LINESTRING(%s %s,%s %s)', -20, 60 * i + 5, 210, 60 * i + 5 + 6 * random())), CASE WHEN i < 2 THEN 5 + 5 * random() END, 4 FROM generate_series(0, 3) i;
  FOR n IN 1..40 LOOP
    CASE floor(6 * random())::integer
      WHEN 0 THEN UPDATE random.axis SET width = CASE WHEN n % 2 = 0 THEN 5 + 8 * random() END WHERE axis_id = 1 + floor(8 * random());
      WHEN 1 THEN UPDATE random.axis SET geom = ST_Translate(geom, 4 * random() - 2, 4 * random() - 2) WHERE axis_id = 1 + floor(8 * random());
      WHEN 2 THEN DELETE FROM random.footway WHERE footway_id = (SELECT footway_id FROM random.footway ORDER BY random() LIMIT 1);
      WHEN 3 THEN UPDATE random.footway SET geom = ST_Translate(geom, 3 * random() - 1.5, 3 * random() - 1.5) WHERE footway_id % 3 = n % 3;
      ELSE INSERT INTO random.footway (geom, role) SELECT ST_OffsetCurve(ST_LineSubstring(geom, 0.3 * random(), 0.6 + 0.4 * random()), (2 + 8 * random()) * sign(random() - 0.5)), 'sidewalk' FROM random.axis ORDER BY random() LIMIT 2;
    END CASE;
  END LOOP;
END $$;
CREATE TABLE test.before AS SELECT e.axis_id, e.start_abscissa, s.side, s.part, s.footway_id, s.start_abscissa AS at, s.distance, s.width FROM random.sidewalk_source s JOIN random.edge e USING (edge_id);
CREATE TABLE test.widths AS SELECT pg_temp.widths('random') AS said, (SELECT sum(ST_Area(surface)) FROM random.sidewalk) AS area;
SELECT pg_temp.stale('random'), count(*) FROM streetgen.generate('random', wait => true) \g /dev/null
SELECT 'there are mapped sidewalks', count(*) > 5 FROM test.before;
SELECT 'and kerbs that give way', count(*) > 1 FROM random.axis_used WHERE width_moved > 0;
SELECT count(*) FROM streetgen.generate('random', wait => true) \g /dev/null
SELECT 'and another run writes nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('random', wait => true);
SELECT 'random edits give what a run over all gives', NOT EXISTS (SELECT axis_id, start_abscissa, side, part, footway_id, at, distance, width FROM test.before EXCEPT SELECT e.axis_id, e.start_abscissa, s.side, s.part, s.footway_id, s.start_abscissa, s.distance, s.width FROM random.sidewalk_source s JOIN random.edge e USING (edge_id))
  AND (SELECT count(*) FROM test.before) = (SELECT count(*) FROM random.sidewalk_source) AND (SELECT said = pg_temp.widths('random') AND abs(area - (SELECT sum(ST_Area(surface)) FROM random.sidewalk)) < 1e-3 FROM test.widths);
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('random') WHERE severity = 'error');

-- A footway within the kerb of an estimated width moves the kerb.
SELECT streetgen.create_model('within', 2154, subjects => '{footway}', driving_side => 'right') \g /dev/null
INSERT INTO within.axis (axis_id, geom, width, lane_count, importance, kind, lane_width_forward, roadway_offset) VALUES
  (1, pg_temp.line('LINESTRING(0 0,100 0)'), NULL, 2, 4, NULL, NULL, NULL), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 7, 2, 4, NULL, NULL, NULL),
  (3, pg_temp.line('LINESTRING(0 200,100 200)'), NULL, 2, 4, NULL, '3.5', NULL), (4, pg_temp.line('LINESTRING(0 300,100 300)'), NULL, NULL, 4, 'residential', NULL, NULL),
  (5, pg_temp.line('LINESTRING(0 400,100 400)'), NULL, 2, 4, NULL, NULL, 1), (6, pg_temp.line('LINESTRING(0 500,400 500)'), NULL, 2, 4, NULL, NULL, NULL);
INSERT INTO within.footway (footway_id, geom, role) SELECT n, pg_temp.line(format('LINESTRING(2 %s,98 %1$s)', y)), 'sidewalk' FROM (VALUES (1, 3), (2, 103), (3, 203), (4, 302.4), (5, 396.9), (6, 501.2)) v(n, y);
CREATE FUNCTION pg_temp.kerbs(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT concat_ws(' ', round((width / 2 + roadway_offset)::numeric, 6), round((width / 2 - roadway_offset)::numeric, 6)) FROM within.edge WHERE axis_id = axis $$;
SELECT 'half of the least width lies before it, on its side alone', pg_temp.kerbs(1) = '2.000000 3.500000' AND (SELECT sidewalk_left = 2 AND estimated @> '{width}' FROM within.edge WHERE axis_id = 1);
SELECT 'a stated width stays, and so do widths of lanes', pg_temp.kerbs(2) = '3.500000 3.500000' AND pg_temp.kerbs(3) = '3.500000 3.500000';
SELECT 'a narrow street has fewer lanes', pg_temp.kerbs(4) = '1.400000 3.000000' AND (SELECT forward_lanes + backward_lanes + both_lanes = 1 FROM (SELECT lanes_forward AS forward_lanes, lanes_backward AS backward_lanes, lanes_both AS both_lanes FROM within.axis_used WHERE axis_id = 4) u);
SELECT 'an offset of the roadway counts', pg_temp.kerbs(5) = '4.500000 2.100000';
UPDATE within.footway SET geom = pg_temp.line('LINESTRING(2 503,98 503)') WHERE footway_id = 6;
SELECT 'a footway along less than 0.3 of a side moves no kerb', pg_temp.kerbs(6) = '3.500000 3.500000';
UPDATE within.footway SET geom = pg_temp.line('LINESTRING(2 501.2,398 501.2)') WHERE footway_id = 6;
SELECT 'what lies nearer to the axis than to the kerb is no sidewalk', pg_temp.kerbs(6) = '3.500000 3.500000';
SELECT 'the street is told, and counted', (SELECT array_agg(id || ' ' || round(measure::numeric, 3) ORDER BY id) FROM streetgen.check_model('within') WHERE rule ~ '^kerb that gives way') = '{"1 1.500","4 1.600","5 0.400"}'
  AND (SELECT amount = 3 FROM streetgen.summary('within') s WHERE subject ~ 'give way');
UPDATE within.footway SET geom = ST_Translate(geom, 0, -0.3) WHERE footway_id = 1;
SELECT 'the kerb follows its footway', pg_temp.kerbs(1) = '1.700000 3.500000';
UPDATE within.footway SET geom = ST_Translate(geom, 0, 1) WHERE footway_id = 1;
SELECT 'and comes back', pg_temp.kerbs(1) = '2.700000 3.500000';
UPDATE within.axis SET width = 7 WHERE axis_id = 1;
SELECT 'a width by hand stays', pg_temp.kerbs(1) = '3.500000 3.500000';
UPDATE within.axis SET width = NULL WHERE axis_id = 1;
SELECT 'and gives way where it is taken back', pg_temp.kerbs(1) = '2.700000 3.500000';
SELECT streetgen.set('within', 'mapped_sidewalk_distance', '0') \g /dev/null
SELECT count(*) FROM streetgen.generate('within', wait => true) \g /dev/null
DELETE FROM within.footway WHERE footway_id = 1;
SELECT 'a kerb that gave way is found by the footway that goes, however near it is looked for', pg_temp.kerbs(1) = '3.500000 3.500000';
SELECT 'lanes keep their least width', width >= 4 FROM within.edge WHERE axis_id = 6;
DELETE FROM within.footway WHERE footway_id = 6;
INSERT INTO within.footway (geom, role) VALUES (pg_temp.line('LINESTRING(0 502,390 502)'), 'sidewalk'), (pg_temp.line('LINESTRING(0 498,390 498)'), 'sidewalk');
SELECT 'also where footways leave none', pg_temp.kerbs(6) = '2.000000 2.000000';
SELECT 'nothing is wrong with narrower streets', NOT EXISTS (SELECT FROM streetgen.check_model('within') WHERE severity = 'error');

-- Off, they make nothing; the rows stay.
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without the subject footways stay and make nothing', (SELECT count(*) = 8 FROM town.footway) AND sidewalk_left = 2 AND to_regclass('town.sidewalk_source') IS NULL FROM town.edge WHERE axis_id = 1;
UPDATE town.footway SET geom = ST_Translate(geom, 0, 0.1);
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', true) \g /dev/null
SELECT 'on again, they do', abs(sidewalk_left - 3.4) < 1e-6 FROM town.edge WHERE axis_id = 1;

-- Sides whose sidewalk is a line of its own.
DO $$ BEGIN
  PERFORM streetgen.create_model('apart', 2154, subjects => '{footway}', driving_side => 'left');
  INSERT INTO apart.axis (axis_id, geom, width, importance, sidewalk_apart, sidewalk_right) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4, 'both', NULL), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 8, 4, 'left', NULL), (3, pg_temp.line('LINESTRING(0 200,100 200)'), 8, 4, 'right', 2.5);
  INSERT INTO apart.footway (footway_id, geom, kind, role) VALUES (1, pg_temp.line('LINESTRING(0 5.5,100 5.5)'), 'footway', NULL), (2, pg_temp.line('LINESTRING(0 94,100 94)'), 'footway', NULL), (3, pg_temp.line('LINESTRING(0 -5.5,100 -5.5)'), 'steps', NULL);
END $$;
SELECT 'a side apart has its footway, whatever the role, or nothing; steps are none', pg_temp.widths('apart') = '1:3.000000:0.000000 2:0.000000:2.000000 3:2.000000:2.500000';
SELECT 'nothing there is estimated', NOT estimated && '{sidewalk_left,sidewalk_right}' FROM apart.edge WHERE axis_id = 1;
INSERT INTO apart.footway (footway_id, geom, kind, role) VALUES (4, pg_temp.line('LINESTRING(0 150,100 150)'), 'footway', 'sidewalk');
SELECT 'what is drawn in vain, or not drawn, is told', array_agg(rule || ' ' || id ORDER BY rule, id) = '{"side whose sidewalk apart is not drawn, m 1","side whose sidewalk apart is not drawn, m 2","sidewalk along no street, m 4"}' FROM streetgen.check_model('apart') WHERE rule LIKE 's%' AND rule !~ 'on foot';
SELECT 'and counted', count(*) = 2 FROM streetgen.summary('apart') s WHERE s::text ~ 'footways';
UPDATE apart.axis SET sidewalk_apart = NULL WHERE axis_id = 1;
SELECT 'what is said no more counts no more', pg_temp.widths('apart') LIKE '1:2.000000:2.000000 2:0%';
SELECT streetgen.set('apart', 'mapped_sidewalk_missing', 'estimated') \g /dev/null
SELECT count(*) FROM streetgen.generate('apart', wait => true) \g /dev/null
SELECT 'by setting a side without a footway is estimated', pg_temp.widths('apart') = '1:2.000000:2.000000 2:2.000000:2.000000 3:2.000000:2.500000';

-- Several lines along one side, classes on which nobody walks, and bays.
DO $$ BEGIN
  PERFORM streetgen.create_model('several', 2154, subjects => '{lane,footway,object}', driving_side => 'right');
  INSERT INTO several.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
  INSERT INTO several.axis (axis_id, geom, width, importance, lanes_forward, lanes_backward, sidewalk_apart, kind, parking_left) SELECT n, pg_temp.line(format('LINESTRING(0 %1$s,100 %1$s)', 100 * n)), 8, 4, 1, 1, 'both', CASE n WHEN 5 THEN 'motorway' END, CASE n WHEN 6 THEN 'street_side' WHEN 7 THEN 'street_side|perpendicular' END FROM generate_series(1, 7) n;
  INSERT INTO several.footway (geom, kind, role, width) SELECT pg_temp.line(format('LINESTRING(0 %1$s,100 %1$s)', 100 * n + y)), k, r, w FROM (VALUES (1, 6, 'footway', 'sidewalk', NULL::float8), (1, 14, 'path', NULL, NULL), (2, 5.5, 'footway', 'sidewalk', NULL), (2, 11, 'footway', 'sidewalk', NULL),
    (3, 5, 'cycleway', NULL, NULL), (3, 8, 'footway', NULL, NULL), (4, 5, 'cycleway', NULL, NULL), (5, 6, 'footway', 'sidewalk', NULL), (6, 7, 'footway', 'sidewalk', 2), (7, 10.5, 'footway', 'sidewalk', NULL)) v(n, y, k, r, w);
  PERFORM FROM streetgen.generate('several', wait => true);
END $$;
SELECT 'a line that says that it is a sidewalk counts, else the nearer one; cycle tracks and what runs along a motorway are none; bays lie before it', pg_temp.widths('several') = '1:4.000000:0.000000 2:3.000000:0.000000 3:6.000000:0.000000 4:0.000000:0.000000 5:0.000000:0.000000 6:4.000000:0.000000 7:8.000000:0.000000';
SELECT 'the distance is that from the kerb behind the bays', array_agg(round(distance::numeric, 6) ORDER BY axis_id) = '{1,1.5}' FROM several.sidewalk_source JOIN several.edge USING (edge_id) WHERE axis_id > 5;
SELECT 'and the walk lies behind them', count(*) > 5 AND max(ST_Area(ST_Intersection(w.surface, b.surface))) < 1e-3 AND sum(ST_Area(ST_Intersection(w.strip, b.surface))) > 10 FROM several.parking_bay b JOIN several.street_object o USING (street_object_id) JOIN several.edge e USING (axis_id) JOIN several.sidewalk w ON w.edge_id = e.edge_id AND w.side = o.side WHERE axis_id = 6;

-- Bad lines.
CREATE FUNCTION pg_temp.refused(statement text) RETURNS text LANGUAGE plpgsql AS $$ BEGIN EXECUTE statement; RETURN 'taken'; EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;
SELECT 'a role that nobody knows is refused', pg_temp.refused($$UPDATE town.footway SET role = 'stairs'$$) = '23514';
SELECT 'a line without length is one without a street', pg_temp.refused($$INSERT INTO town.footway (geom, role) VALUES (pg_temp.line('LINESTRING(5 6,5 6)'), 'sidewalk')$$) = '23514';
SELECT 'zigzags and loops are taken', pg_temp.refused($$INSERT INTO town.footway (geom, role) VALUES (pg_temp.line('LINESTRING(5 6,20 7,5 8,40 6,60 9,30 4,90 6,5 6)'), 'sidewalk')$$) = 'taken' AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');

-- The ground of footways beside streets.
DO $$ BEGIN
  PERFORM streetgen.create_model('ground', 2154, subjects => '{footway}', driving_side => 'right');
  INSERT INTO ground.axis (axis_id, geom, width, importance) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4);
  INSERT INTO ground.footway (footway_id, geom, kind, role, width) VALUES (1, pg_temp.line('LINESTRING(0 6,100 6)'), 'footway', 'sidewalk', NULL), (2, pg_temp.line('LINESTRING(50 -30,50 30)'), 'footway', NULL, 3), (3, pg_temp.line('LINESTRING(0 20,100 20)'), 'cycleway', NULL, 4),
    (4, pg_temp.line('LINESTRING(60 30,60 10)'), 'steps', NULL, NULL), (5, pg_temp.line('LINESTRING(0 -40,100 -40)'), NULL, NULL, NULL), (6, pg_temp.line('LINESTRING(20 -50,20 50)'), 'footway', NULL, 2);
  UPDATE ground.footway SET level = 1 WHERE footway_id = 6;
END $$;
SELECT 'a sidewalk is no ground of its own', NOT EXISTS (SELECT FROM ground.footway_surface WHERE footway_id = 1);
-- 60 m, less the roadway of 8 m, a sidewalk of 4 m and one of 2 m, and the cycle track.
SELECT 'a walk gives way to roadway, sidewalks and cycle tracks', abs(ST_Area(surface) - 3 * (60 - 8 - 4 - 2 - 4)) < 0.1 FROM ground.footway_surface WHERE footway_id = 2;
UPDATE ground.footway SET surface = 'sett' WHERE footway_id = 3;
SELECT 'the ground says what it is paved with', (SELECT paved = 'sett' FROM ground.footway_surface WHERE footway_id = 3) AND (SELECT paved IS NULL FROM ground.footway_surface WHERE footway_id = 2);
SELECT 'a cycle track to none of them', abs(ST_Area(surface) - 400) < 0.01 AND use = 'cycle' FROM ground.footway_surface WHERE footway_id = 3;
SELECT 'steps are as wide as their class, and give way', abs(ST_Area(surface) - 2 * (20 - 4)) < 0.01 AND use = 'steps' FROM ground.footway_surface WHERE footway_id = 4;
SELECT 'one of no class is a walk of the least width', use = 'walk' AND width = 2 FROM ground.footway_surface WHERE footway_id = 5;
SELECT 'one of another level gives way to nothing of this', abs(ST_Area(surface) - 200) < 0.01 FROM ground.footway_surface WHERE footway_id = 6;
SELECT 'they share no ground', coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) < 1e-3 FROM ground.footway_surface a JOIN ground.footway_surface b ON a.footway_id < b.footway_id AND a.level = b.level;
SELECT 'pictures show them', count(*) = 5 AND streetgen.svg('ground', ST_Expand(pg_temp.line('LINESTRING(0 0,100 0)'), 50), scale => 1000) ~ '"footway"' FROM streetgen._footway_drawn('ground', ST_Expand(pg_temp.line('LINESTRING(0 0,100 0)'), 50), '{footway}');

-- An editor draws footways, a reader does not.
CREATE ROLE footway_editor ROLE CURRENT_USER; CREATE ROLE footway_reader ROLE CURRENT_USER;
SELECT streetgen.grant('town', 'footway_editor', 'editor'), streetgen.grant('town', 'footway_reader', 'reader') \g /dev/null
SET ROLE footway_editor;
INSERT INTO town.footway (geom, role, width) SELECT ST_Translate(geom, 0, -10.7), 'sidewalk', 2.2 FROM town.footway WHERE footway_id = 1;
SELECT 'an editor draws a footway, and the street follows', abs(sidewalk_right - 2.2) < 1e-6 FROM town.edge WHERE axis_id = 1;
SET ROLE footway_reader;
SELECT 'a reader does not', pg_temp.refused('DELETE FROM town.footway') = '42501';
RESET ROLE;
SELECT streetgen.revoke('town', 'footway_editor'), streetgen.revoke('town', 'footway_reader') \g /dev/null
DROP ROLE footway_editor; DROP ROLE footway_reader;

-- Lines of a source, again and again.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry);
INSERT INTO osm_line VALUES (1, 'residential', 'high street', NULL, '{}', 2, pg_temp.line('LINESTRING(0 0,100 0)')), (2, 'footway', NULL, NULL, '{"footway": "sidewalk", "width": "3"}', 2, pg_temp.line('LINESTRING(0 7,100 7)')),
  (3, 'footway', NULL, NULL, '{"footway": "crossing"}', 2, pg_temp.line('LINESTRING(50 -7,50 7)')), (4, 'steps', 'stairs', NULL, '{"layer": "-1"}', 2, pg_temp.line('LINESTRING(0 20,10 20)')),
  (5, 'footway', NULL, NULL, '{"footway": "sidewalk", "level": "2"}', 2, pg_temp.line('LINESTRING(0 -7,100 -7)')), (6, 'corridor', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(0 -9,100 -9)')), (7, 'cycleway', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(0 40,100 40)')),
  (9, 'residential', 'a', NULL, '{"sidewalk": "separate"}', 2, pg_temp.line('LINESTRING(0 500,100 500)')), (10, 'residential', 'b', NULL, '{"sidewalk:left": "separate", "sidewalk:right": "no"}', 2, pg_temp.line('LINESTRING(0 600,100 600)')),
  (11, 'residential', 'c', NULL, '{"sidewalk:both": "yes"}', 2, pg_temp.line('LINESTRING(0 700,100 700)'));
SELECT streetgen.create_model('source', 2154, subjects => '{footway}', driving_side => 'right') \g /dev/null
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('source');
SELECT 'walked lines become footways, driven ones axes', (SELECT array_agg(concat_ws(' ', source_ref, kind, role, width, level, name) ORDER BY source_ref) = '{2 footway sidewalk 3 0,3 footway crossing 0,4 steps -1 stairs,7 cycleway 0}' FROM source.footway) AND (SELECT array_agg(source_ref || coalesce(sidewalk_apart, '') ORDER BY source_ref) = '{1,10left,11,9both}' FROM source.axis);
SELECT 'those of other floors and unknown classes are told', (SELECT count = 1 FROM told WHERE what LIKE 'within a building%') AND (SELECT count = 1 FROM told WHERE class = 'corridor' AND what LIKE 'not taken%');
SELECT count(*) FROM streetgen.generate('source', wait => true) \g /dev/null
-- The street is 6 m wide: 4 m to the footway, and half of its 3 m.
SELECT 'the street has what is mapped', (e.sidewalk_left, 'sidewalk_right' = ANY (estimated)) = (5.5, true) FROM source.edge e JOIN source.axis a USING (axis_id) WHERE source_ref = '1';
UPDATE source.footway SET width = 2.4 WHERE source_ref = '2';
UPDATE osm_line SET tags = tags || '{"width": "3.5"}' WHERE way_id = 2; DELETE FROM osm_line WHERE way_id IN (3, 7); UPDATE osm_line SET class = 'footway', tags = '{"footway": "sidewalk"}', geom = ST_Translate(geom, 0, -6) WHERE way_id = 1;
INSERT INTO osm_line VALUES (8, 'residential', 'high street', NULL, '{}', 2, pg_temp.line('LINESTRING(0 0,100 0)'));
TRUNCATE told; INSERT INTO told SELECT * FROM streetgen.import_osm('source');
SELECT 'what is by hand stays', width = 2.4 FROM source.footway WHERE source_ref = '2';
SELECT 'and what the source says otherwise is in conflict', (column_name, by_hand, source_new) = ('width', '2.4', '3.5') FROM source.import_conflict WHERE relation = 'footway';
SELECT 'what came, went and is due is told', (SELECT count = 2 FROM told WHERE what = 'footways, new or changed') AND (SELECT count = 2 FROM told WHERE what LIKE 'vanished%' AND source_refs = '{3,7}') AND (SELECT count > 0 FROM told WHERE what = 'generate is due');
SELECT 'what the source deleted is gone, and a street that became a footway is one', array_agg(source_ref ORDER BY source_ref) = '{1,2,4}' AND (SELECT array_agg(source_ref ORDER BY source_ref) = '{10,11,8,9}' FROM source.axis) FROM source.footway;
UPDATE source.axis_class SET use = 'roadway' WHERE class = 'steps'; UPDATE source.axis_class SET use = 'none' WHERE class = 'footway';
TRUNCATE told; INSERT INTO told SELECT * FROM streetgen.import_osm('source');
SELECT 'a class is a street where its use says so', (SELECT array_agg(source_ref ORDER BY source_ref) = '{10,11,4,8,9}' FROM source.axis);
SELECT 'and nothing is made of one of no use, which is told', (SELECT count = 2 FROM told WHERE what = 'no roadway, and nothing is made of it');
