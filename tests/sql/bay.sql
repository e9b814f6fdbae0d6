\set ECHO none
\ir shared/truths.sql
-- Parking bays of rules: on parking lanes, and on roadway that lanes leave.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.mirrored(geometry) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Affine($1, 1, 0, 0, -1, 0, 2 * 6860000) $$;
CREATE FUNCTION pg_temp.turned(text) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(word, '|' ORDER BY n DESC) FROM string_to_table($1, '|') WITH ORDINALITY w(word, n) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154, subjects => '{lane,object}', driving_side => CASE m WHEN 'mirror' THEN 'left' ELSE 'right' END) FROM unnest('{town,against,mirror}'::name[]) m;
  INSERT INTO town.axis (axis_id, geom, width, direction, lanes_forward, lanes_backward, kind_forward, kind_backward, lane_width_forward, lane_width_backward) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 7, 'direct', 1, NULL, 'general|parking', NULL, NULL, NULL), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 7, 'both', 1, 1, NULL, NULL, NULL, NULL),
    (3, pg_temp.line('LINESTRING(0 200,100 200)'), 12, 'both', 1, 1, 'general|cycle', NULL, NULL, NULL), (4, pg_temp.line('LINESTRING(0 300,100 300)'), 9, 'direct', 2, NULL, 'general|bus', NULL, NULL, NULL),
    (5, pg_temp.line('LINESTRING(0 400,100 400)'), 5, 'direct', 1, NULL, NULL, NULL, NULL, NULL), (6, pg_temp.line('LINESTRING(0 500,100 500)'), 8, 'direct', 1, NULL, NULL, NULL, NULL, NULL),
    (7, pg_temp.line('LINESTRING(0 600,100 600)'), 7.5, 'direct', 1, NULL, NULL, NULL, NULL, NULL), (8, pg_temp.line('LINESTRING(0 700,100 700)'), 12, 'both', 1, 1, NULL, 'general|parking', NULL, '|5'),
    (9, pg_temp.line('LINESTRING(0 800,60 800,100 812)'), 9, 'direct', 1, NULL, 'general|parking', NULL, '|4.5', NULL),
    (10, pg_temp.line('LINESTRING(0 900,100 900)'), 14, 'both', 1, 1, 'general|parking|cycle', 'general|parking|cycle', NULL, NULL),
    (11, pg_temp.line('LINESTRING(0 1000,100 1000)'), 4.5, 'direct', 1, NULL, 'general|parking', NULL, NULL, NULL), (12, pg_temp.line('LINESTRING(0 1100,100 1100)'), 12, 'both', 1, 1, NULL, 'general|parking', NULL, '|4.5');
  INSERT INTO against.axis (axis_id, geom, width, direction, lanes_forward, lanes_backward, kind_forward, kind_backward, lane_width_forward, lane_width_backward)
    SELECT axis_id, ST_Reverse(geom), width, CASE direction WHEN 'direct' THEN 'reverse' ELSE direction END, lanes_backward, lanes_forward, kind_backward, kind_forward, lane_width_backward, lane_width_forward FROM town.axis;
  INSERT INTO mirror.axis (axis_id, geom, width, direction, lanes_forward, lanes_backward, kind_forward, kind_backward, lane_width_forward, lane_width_backward)
    SELECT axis_id, pg_temp.mirrored(geom), width, direction, lanes_forward, lanes_backward, pg_temp.turned(kind_forward), pg_temp.turned(kind_backward), pg_temp.turned(lane_width_forward),
      pg_temp.turned(lane_width_backward) FROM town.axis;
END $$;
CREATE FUNCTION pg_temp.bays(model name, axis bigint) RETURNS text LANGUAGE plpgsql AS $$ DECLARE said text; BEGIN
  EXECUTE format('SELECT string_agg(concat_ws('' '', n, side, length, width, round(angle)), '', '' ORDER BY side) FROM (SELECT count(*) AS n, side, length, width, p.angle FROM %1$I.parking_bay p
    JOIN %1$I.street_object USING (street_object_id) WHERE axis_id = $1 AND surface IS NOT NULL GROUP BY 2, 3, 4, 5) b', model) INTO said USING axis;
  RETURN said; END $$;
CREATE FUNCTION pg_temp.told(said text) RETURNS bigint[] LANGUAGE sql AS $$ SELECT array_agg(DISTINCT o.axis_id ORDER BY o.axis_id) FROM streetgen.check_model('town') c JOIN town.street_object o ON o.street_object_id = c.id WHERE c.rule = $1 $$;
-- What an edit leaves is what a run from scratch makes.
CREATE FUNCTION pg_temp.there() RETURNS text LANGUAGE sql AS $$ SELECT md5(string_agg(concat_ws(' ', street_object_id, o.axis_id, o.abscissa, o.axis_offset, length, width, b.angle, ST_AsEWKB(surface)), ',' ORDER BY street_object_id))
  FROM town.parking_bay b JOIN town.street_object o USING (street_object_id) $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE before text := pg_temp.there(); BEGIN
  PERFORM streetgen.generate('town', wait => true); RETURN before = pg_temp.there() AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error'); END $$;

-- Beside what lanes leave: 2.3 m deep, every 10 m, five metres from the ends.
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset) VALUES (1, 'parking_bay', 'both', 10, 0);
SELECT 'two lanes that fill their roadway leave none', pg_temp.bays('town', 2) IS NULL;
SELECT 'none on a cycle lane, some on the other side', pg_temp.bays('town', 3) = '9 left 5 2.3 0';
SELECT 'none on a bus lane, some on the other side', pg_temp.bays('town', 4) = '9 left 5 2.3 0';
SELECT 'none in a narrow street', pg_temp.bays('town', 5) IS NULL;
SELECT '8 m leave 3.4 m between bays', pg_temp.bays('town', 6) = '9 left 5 2.3 0, 9 right 5 2.3 0';
SELECT '7.5 m would leave 2.9 m, and bays stay on the side that one drives on', pg_temp.bays('town', 7) = '9 right 5 2.3 0';
SELECT 'nothing to tell', count(*) = 0 FROM streetgen.check_model('town') WHERE rule ~ 'bay';
SELECT streetgen.set('town', 'bay_roadway_one_way', '3.5') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'a setting says how much has to stay', pg_temp.bays('town', 6) = '9 right 5 2.3 0';
SELECT streetgen.set('town', 'bay_roadway_one_way', '3') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
INSERT INTO town.parking_bay_editing (axis_id, abscissa, side, axis_offset) VALUES (7, 50, 'left', 0), (3, 50, 'right', 0), (2, 50, 'right', 0);
SELECT 'a bay by hand comes first', pg_temp.bays('town', 7) = '1 left 5 2.3 0, 8 right 5 2.3 0' AND pg_temp.still();
SELECT 'told: a bay on a cycle lane', pg_temp.told('parking bay on a lane for others') = '{3}';
SELECT 'told: a bay that narrows its lane', pg_temp.told('parking bay that narrows a lane, m') = '{2}';
SELECT 'told: a bay that leaves 4.7 m', pg_temp.told('parking bay that leaves a narrow roadway, m') = '{2}';
DELETE FROM town.street_object WHERE placed_by = 'user';
DELETE FROM town.placement_rule;

-- On parking lanes: side by side, as deep as the lane is wide.
INSERT INTO town.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
SELECT 'along the kerb on its side', pg_temp.bays('town', 1) = '18 right 5 2 0';
SELECT 'across on a lane of 5 m', pg_temp.bays('town', 8) = '39 left 5 2.3 90';
SELECT 'askew on a lane of 4.5 m', pg_temp.bays('town', 9) ~ '^\d+ right 5 2.3 64$';
SELECT 'and so that cars drive into them', pg_temp.bays('town', 12) ~ '^\d+ left 5 2.3 64$';
SELECT 'between traffic and cycle lanes', pg_temp.bays('town', 10) = '18 left 5 2 0, 18 right 5 2 0';
SELECT 'no other street has any', count(*) = 0 FROM town.street_object WHERE axis_id IN (2, 3, 4, 5, 6, 7);
SELECT 'bays lie on their lane', count(*) > 100 AND bool_and(ST_Area(ST_Intersection(b.surface, l.surface)) > 0.97 * ST_Area(b.surface)) FROM town.parking_bay b JOIN town.object_edge USING (street_object_id)
  JOIN town.lane l USING (edge_id) WHERE l.kind = 'parking' AND ST_DWithin(ST_Centroid(b.surface), l.geom, 1);
SELECT 'and on no other bay', count(*) = 0 FROM town.parking_bay a JOIN town.parking_bay b ON a.street_object_id < b.street_object_id AND ST_Area(ST_Intersection(a.surface, b.surface)) > 0.01;
SELECT 'told: what a narrow street keeps beside its parking lane', pg_temp.told('parking bay that leaves a narrow roadway, m') = '{11}' AND pg_temp.still();
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) VALUES ('bus_stop', 'border', 1, 50, 'right', 1), ('bus_stop', 'border', 10, 50, 'left', 1);
SELECT 'buses reach their stop', pg_temp.bays('town', 1) = '12 right 5 2 0' AND pg_temp.bays('town', 10) = '12 left 5 2 0, 18 right 5 2 0' AND pg_temp.still();
DELETE FROM town.street_object WHERE type = 'bus_stop';
INSERT INTO town.pedestrian_crossing_editing (axis_id, abscissa) VALUES (1, 50);
SELECT 'a crossing parts them', pg_temp.bays('town', 1) = '16 right 5 2 0' AND pg_temp.still();
DELETE FROM town.street_object WHERE type = 'crossing';
INSERT INTO town.axis (axis_id, geom, width, kind) VALUES (20, pg_temp.line('LINESTRING(50 0,50 -40)'), 4, 'service');
SELECT 'and so does a driveway', (SELECT min(abs(abscissa - 50)) > 7.4 FROM town.street_object WHERE axis_id = 1) AND pg_temp.still();
DELETE FROM town.axis WHERE axis_id = 20;
UPDATE town.axis SET kind_forward = 'general|cycle' WHERE axis_id = 1;
SELECT 'a lane that cars leave has none', pg_temp.bays('town', 1) IS NULL AND pg_temp.still();
UPDATE town.axis SET kind_forward = 'general|parking', lane_width_forward = '|5', width = 9 WHERE axis_id = 1;
SELECT 'a lane that widens turns its cars', pg_temp.bays('town', 1) = '39 right 5 2.3 90' AND pg_temp.still();
UPDATE town.axis SET lane_width_forward = NULL, width = 7 WHERE axis_id = 1;
SELECT 'and back', pg_temp.bays('town', 1) = '18 right 5 2 0' AND pg_temp.still();
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) SELECT axis_id, 50, ordinality, 2.5 FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND kind = 'parking';
SELECT 'also by hand', pg_temp.bays('town', 1) = '18 right 5 2.5 0' AND pg_temp.still();
DELETE FROM town.lane_override;
INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward, lane_width_forward) VALUES (21, pg_temp.line('LINESTRING(0 1200,100 1200)'), 4.5, 'direct', 'general|parking', '3|1.5');
SELECT 'no car stands on 1.5 m, and check_model says so', pg_temp.bays('town', 21) IS NULL AND EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'parking lane too narrow for bays, m');
DELETE FROM town.axis WHERE axis_id = 21;
UPDATE town.placement_rule SET side = 'left';
SELECT 'a rule of one side', (SELECT bool_and(side = 'left') FROM town.street_object) AND pg_temp.still();
UPDATE town.placement_rule SET side = 'both';
SELECT name, test.state(sql) = '22023' FROM (VALUES ('on lanes lie bays alone', $$INSERT INTO town.placement_rule (type, along) VALUES ('lamp', 'lane')$$)) c(name, sql);

-- The other way round, and in its mirror.
INSERT INTO against.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
INSERT INTO mirror.placement_rule (rule_id, type, along, side, every, axis_offset) VALUES (2, 'parking_bay', 'lane', 'both', 25, 0), (3, 'parking_bay', 'border', 'both', 10, 0);
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset) VALUES (3, 'parking_bay', 'both', 10, 0);
CREATE FUNCTION pg_temp.same(a geometry, b geometry) RETURNS boolean LANGUAGE sql AS $$ SELECT a && b AND ST_Area(ST_SymDifference(a, b)) < 0.01 $$;
SELECT 'drawn backward the bays are the same', count(*) > 100 AND count(*) = count(b.street_object_id) FROM against.parking_bay b RIGHT JOIN (SELECT surface FROM town.parking_bay JOIN town.street_object USING (street_object_id)
  WHERE rule_id = 2) t ON pg_temp.same(b.surface, t.surface);
SELECT 'driven on the left they are the image', count(*) > 100 AND count(*) = count(b.street_object_id) AND count(*) = (SELECT count(*) FROM mirror.parking_bay) FROM mirror.parking_bay b
  RIGHT JOIN (SELECT pg_temp.mirrored(surface) AS surface FROM town.parking_bay) t ON pg_temp.same(b.surface, t.surface);

-- Where no lanes are known the roadway alone counts.
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('bare', 2154, subjects => '{object}') \g /dev/null
INSERT INTO bare.axis (axis_id, geom, width, direction) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 7, 'direct'), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 7, 'both'), (3, pg_temp.line('LINESTRING(0 200,100 200)'), 8, 'both');
INSERT INTO bare.placement_rule (type, along, side, every, axis_offset) VALUES ('parking_bay', 'border', 'right', 10, 0), ('parking_bay', 'lane', 'both', 25, 0);
SELECT 'the roadway says where bays lie', pg_temp.bays('bare', 1) = '9 right 5 2.3 0' AND pg_temp.bays('bare', 2) IS NULL AND pg_temp.bays('bare', 3) = '9 right 5 2.3 0';
SELECT 'a rule along lanes places none, and check_model says so', (SELECT count(*) = 0 FROM bare.street_object WHERE rule_id = 2) AND EXISTS (SELECT FROM streetgen.check_model('bare')
  WHERE rule = 'placement rule along lanes, which the model does not compute');
