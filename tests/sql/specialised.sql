\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Objects with tables of their own: parking bays, and those that users make.  (name, holds)
SET client_min_messages = warning;
SELECT streetgen.create_model(m, 2154, subjects => '{object}') FROM unnest('{town,once}'::name[]) m \g /dev/null
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.shape(geometry) RETURNS text LANGUAGE sql AS $$ SELECT ST_AsText(ST_SnapToGrid(ST_Translate($1, -650000, -6860000), 0.001)) $$;
INSERT INTO town.axis (geom, width) VALUES (pg_temp.line('LINESTRING(0 0, 100 0)'), 8), (pg_temp.line('LINESTRING(100 0, 100 80)'), 6), (pg_temp.line('LINESTRING(100 0, 180 0)'), 8);

-- Bays.
INSERT INTO town.parking_bay_editing (geom) VALUES (pg_temp.line('POINT(30 -4)'));
SELECT 'a bay lies along its border, on the roadway', ST_Equals(surface, pg_temp.line('POLYGON((27.5 -4, 32.5 -4, 32.5 -1.7, 27.5 -1.7, 27.5 -4))')) FROM town.parking_bay;
UPDATE town.parking_bay_editing SET axis_offset = 2.3;
SELECT 'or beside it', ST_Equals(surface, pg_temp.line('POLYGON((27.5 -6.3, 32.5 -6.3, 32.5 -4, 27.5 -4, 27.5 -6.3))')) FROM town.parking_bay;
UPDATE town.parking_bay_editing SET axis_offset = 0, angle = 90;
SELECT 'perpendicular', ST_Area(ST_SymDifference(surface, pg_temp.line('POLYGON((28.85 -4, 31.15 -4, 31.15 1, 28.85 1, 28.85 -4))'))) < 1e-6 FROM town.parking_bay;
UPDATE town.parking_bay_editing SET angle = 45;
SELECT 'oblique: as large, and who drives past on the right drives forward into it', abs(ST_Area(surface) - 5 * 2.3) < 1e-6 AND ST_XMin(surface) < 650000 + 30 - 2.3 / sind(45) / 2 - 3
  FROM town.parking_bay;
UPDATE town.axis SET width = 10 WHERE axis_id = 1;
SELECT 'it goes with the kerb', ST_YMin(surface) = 6860000 - 5 FROM town.parking_bay;
UPDATE town.axis SET roadway_offset = 2 WHERE axis_id = 1;
SELECT 'and with a roadway that lies aside', ST_YMin(surface) = 6860000 - 3 FROM town.parking_bay;
UPDATE town.axis SET roadway_offset = NULL, width = 8 WHERE axis_id = 1;
UPDATE town.parking_bay_editing SET length = 7, width = 3, angle = 0;
UPDATE town.parking_bay_editing SET length = NULL, width = NULL, angle = NULL;
SELECT 'an emptied size is the usual one', (length, width, angle) = (5, 2.3, 0) FROM town.parking_bay;
SELECT 'a length of NaN: 22023', test.state($$UPDATE town.parking_bay_editing SET length = 'NaN'$$) = '22023';
SELECT 'an angle of 10 degrees: 22023', test.state($$UPDATE town.parking_bay_editing SET angle = 10$$) = '22023';
UPDATE town.street_object SET abscissa = 1;
SELECT 'none beyond the end of the axis', surface IS NULL FROM town.parking_bay;
UPDATE town.street_object SET type = 'bench';
SELECT 'another type is no bay', NOT EXISTS (SELECT FROM town.parking_bay);
INSERT INTO town.object_type (type) VALUES ('stall');
UPDATE town.street_object SET type = 'stall', abscissa = 30;
UPDATE town.object_type SET parent = 'parking_bay' WHERE type = 'stall';
SELECT 'a type that becomes a kind of bay makes bays of its objects', count(*) = 1 AND bool_and(surface IS NOT NULL) FROM town.parking_bay;
UPDATE town.object_type SET parent = NULL WHERE type = 'stall';
SELECT 'and none when it is no kind of it any more', NOT EXISTS (SELECT FROM town.parking_bay) AND EXISTS (SELECT FROM town.street_object);
UPDATE town.street_object SET type = 'parking_bay', abscissa = 30;
DELETE FROM town.parking_bay;
SELECT 'the object goes with its bay', NOT EXISTS (SELECT FROM town.street_object);
-- Streets of 7 m have no room beside their lanes: here rules take it.
SELECT streetgen.set('town', 'bay_roadway_both', '0'), streetgen.set('town', 'lane_width_minimal', '1') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
INSERT INTO town.placement_rule (type, along, side, every, orientation, axis_offset, distance_from_limit) VALUES ('parking_bay', 'border', 'right', 6, 0, 0, 0);
INSERT INTO town.pedestrian_crossing_editing (geom) VALUES (pg_temp.line('POINT(50 0)'));
SELECT 'rules place bays beside each other', count(*) > 20 AND bool_and(ST_Area(b.surface) BETWEEN 11.4 AND 11.6) AND NOT EXISTS (SELECT FROM town.parking_bay a JOIN town.parking_bay c
  ON a.street_object_id < c.street_object_id AND ST_Area(ST_Intersection(a.surface, c.surface)) > 1e-6) FROM town.parking_bay b;
SELECT 'off intersections', NOT EXISTS (SELECT FROM town.parking_bay b JOIN town.intersection i ON ST_Area(ST_Intersection(i.surface, b.surface)) > 0.01);
SELECT 'off crossings', NOT EXISTS (SELECT FROM town.parking_bay b JOIN town.pedestrian_crossing c ON ST_Area(ST_Intersection(c.surface, b.surface)) > 0.01);
INSERT INTO town.placement_rule (type, along, side, distance_from_limit) VALUES ('crossing', 'arm', 'alternating', 1);
SELECT 'also of rules', (SELECT count(*) FROM town.pedestrian_crossing) = 4 AND NOT EXISTS (SELECT FROM town.parking_bay b JOIN town.pedestrian_crossing c ON ST_Area(ST_Intersection(c.surface, b.surface)) > 0.01);
SELECT 'a second run changes nothing', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true);
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity IN ('error', 'warning'));
DELETE FROM town.placement_rule WHERE type = 'crossing';
UPDATE town.placement_rule SET orientation = 30 WHERE type = 'parking_bay';
SELECT 'a rule that turns turns its bays', bool_and(angle = 30 AND abs(ST_Area(surface) - 11.5) < 1e-6) AND count(*) > 5 FROM town.parking_bay;
INSERT INTO town.placement_rule (type, along, side, distance_from_limit) VALUES ('crossing', 'arm', 'alternating', 1);
CREATE VIEW bays_apart AS SELECT count(*) > 5 AND NOT EXISTS (SELECT FROM town.parking_bay b JOIN town.pedestrian_crossing c ON ST_Area(ST_Intersection(c.surface, b.surface)) > 0.01)
  AND NOT EXISTS (SELECT FROM town.parking_bay a JOIN town.parking_bay b ON a.street_object_id < b.street_object_id AND ST_Area(ST_Intersection(a.surface, b.surface)) > 0.01) AS holds FROM town.parking_bay;
SELECT 'oblique ones lie off crossings too', holds FROM bays_apart;
INSERT INTO town.placement_rule (type, along, side, every, phase, axis_offset, distance_from_limit) VALUES ('parking_bay', 'border', 'right', 5, 2, 0, 0);
SELECT 'those of a later rule give way', holds FROM bays_apart;
UPDATE town.placement_rule SET side = 'left' WHERE every = 5;
SELECT 'and stand on the other side', holds AND count(DISTINCT rule_id) = 2 FROM bays_apart, town.street_object WHERE type = 'parking_bay' GROUP BY holds;
UPDATE town.parking_bay_editing SET angle = 60 WHERE street_object_id = (SELECT min(street_object_id) FROM town.parking_bay WHERE angle = 30);
SELECT sum(inserted) IS NULL FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'a bay that somebody turns is his', array_agg(o.placed_by) = '{user}' FROM town.parking_bay b JOIN town.street_object o USING (street_object_id) WHERE b.angle = 60;
SELECT 'refused: ' || what, test.state(format('UPDATE town.placement_rule SET %s WHERE every = 5', set)) = '22023' FROM (VALUES ('bays closer than they are long', 'every = 4.9'), ('at 20 degrees every 5 m', 'orientation = 20')) v(what, set);
UPDATE town.placement_rule SET type = 'bench';
SELECT 'a rule for something else leaves no bay', NOT EXISTS (SELECT FROM town.parking_bay b JOIN town.street_object o USING (street_object_id) WHERE o.type <> 'parking_bay' OR o.placed_by = 'rule')
  AND NOT EXISTS (SELECT FROM town.pedestrian_crossing JOIN town.street_object USING (street_object_id) WHERE placed_by = 'rule') AND EXISTS (SELECT FROM town.street_object WHERE type = 'bench');
SELECT 'a second run changes nothing of it', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true);
DELETE FROM town.placement_rule;
DELETE FROM town.street_object WHERE placed_by = 'user';

-- A shelter with a roof.
INSERT INTO town.object_type (type, parent) VALUES ('shelter', 'bus_stop'), ('long_shelter', 'shelter');
CREATE TABLE town.shelter (street_object_id bigint PRIMARY KEY, depth float8 NOT NULL DEFAULT 1.5, roof geometry(Polygon, 2154), geom geometry(Point, 2154));
CREATE FUNCTION town.roof(s town.shelter, o town.street_object) RETURNS town.shelter LANGUAGE sql STABLE AS $$
  SELECT (s.street_object_id, s.depth, ST_Buffer(o.geom, s.depth, 'quad_segs=2'), s.geom)::town.shelter $$;
INSERT INTO town.street_object_editing (type, geom) VALUES ('shelter', pg_temp.line('POINT(20 6)')), ('bench', pg_temp.line('POINT(22 6)'));
SELECT 'objects that are there get their rows', streetgen.specialise('town', 'shelter', 'shelter', 'town.roof(town.shelter, town.street_object)') = 1;
CREATE VIEW in_step AS SELECT (SELECT count(*) FROM town.street_object WHERE type LIKE '%shelter') = (SELECT count(*) FROM town.shelter) AND bool_and(o.type LIKE '%shelter' AND ST_Equals(s.geom, o.geom)
  AND s.roof::bytea = ST_Buffer(o.geom, s.depth, 'quad_segs=2')::bytea) IS NOT FALSE AS holds FROM town.shelter s LEFT JOIN town.street_object o USING (street_object_id);
SELECT 'in step', holds AND (SELECT count(*) FROM town.shelter) = 1 FROM in_step;
INSERT INTO town.street_object_editing (type, geom) VALUES ('long_shelter', pg_temp.line('POINT(40 6)'));
SELECT 'also those of a type below it', holds AND (SELECT count(*) FROM town.shelter) = 2 FROM in_step;
UPDATE town.axis SET width = 12 WHERE axis_id = 1;
SELECT 'a street that widens moves the roof', holds FROM in_step;
UPDATE town.shelter SET depth = 2 WHERE street_object_id = (SELECT min(street_object_id) FROM town.shelter);
SELECT 'a depth that is typed too', holds FROM in_step;
UPDATE town.shelter SET geom = pg_temp.line('POINT(60 9)') WHERE depth = 2;
SELECT 'dragged by its own table', holds AND (SELECT (axis_id, round(abscissa)) = (1, 60) FROM town.street_object JOIN town.shelter USING (street_object_id) WHERE depth = 2) FROM in_step;
INSERT INTO town.shelter (geom, depth) VALUES (pg_temp.line('POINT(120 7)'), 3);
SELECT 'a new row there makes its object', holds AND (SELECT (axis_id, type) = (3, 'shelter') FROM town.street_object JOIN town.shelter USING (street_object_id) WHERE depth = 3) FROM in_step;
DELETE FROM town.shelter WHERE depth = 3;
SELECT 'which goes with it', holds AND (SELECT count(*) FROM town.shelter) = 2 FROM in_step;
UPDATE town.street_object SET type = 'bench' WHERE type = 'long_shelter';
SELECT 'another type is none', holds AND (SELECT count(*) FROM town.shelter) = 1 FROM in_step;
DELETE FROM town.street_object WHERE type = 'shelter';
SELECT 'nor is one that is gone', holds AND (SELECT count(*) FROM town.shelter) = 0 FROM in_step;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;

-- Seeded edits on either side.
DO $$ DECLARE r float8; id bigint; BEGIN
  PERFORM setseed(0.7);
  FOR n IN 1 .. 2000 LOOP
    r := random();
    id := (SELECT street_object_id FROM town.shelter ORDER BY random() LIMIT 1);
    IF r < 0.2 THEN INSERT INTO town.shelter (geom) VALUES (pg_temp.line(format('POINT(%s %s)', 170 * random(), 30 * random() - 15)));
    ELSIF r < 0.4 THEN INSERT INTO town.street_object_editing (type, geom) VALUES ('shelter', pg_temp.line(format('POINT(%s %s)', 170 * random(), 30 * random() - 15)));
    ELSIF r < 0.5 THEN UPDATE town.shelter SET depth = 1 + random() WHERE street_object_id = id;
    ELSIF r < 0.6 THEN UPDATE town.shelter SET geom = ST_Translate(geom, random(), random()) WHERE street_object_id = id;
    ELSIF r < 0.7 THEN UPDATE town.street_object_editing SET geom = ST_Translate(geom, random(), random()) WHERE street_object_id = id;
    ELSIF r < 0.8 THEN UPDATE town.street_object SET type = 'bench' WHERE street_object_id = id;
    ELSIF r < 0.9 THEN DELETE FROM town.shelter WHERE street_object_id = id;
    ELSE DELETE FROM town.street_object WHERE street_object_id = id;
    END IF;
  END LOOP;
END $$;
SELECT 'both sides are in step after 2000 edits', holds AND (SELECT count(*) FROM town.shelter) > 10 FROM in_step;
SELECT 'no edit waits for its renewals to be compiled', bool_and('jit=off' = ANY (proconfig)) AND count(*) = 2 FROM pg_proc WHERE pronamespace = 'town'::regnamespace AND proname IN ('_renew_bays', '_renew_crossings');

INSERT INTO town.placement_rule (type, side, every) VALUES ('shelter', 'right', 30);
SELECT 'what rules place has its rows too', holds AND EXISTS (SELECT FROM town.street_object WHERE type = 'shelter' AND placed_by = 'rule') FROM in_step;
UPDATE town.axis SET width = 14 WHERE axis_id = 3;
SELECT 'and follows', holds FROM in_step;
UPDATE town.placement_rule SET type = 'bench';
SELECT 'a rule for benches leaves no shelter of its own', holds AND NOT EXISTS (SELECT FROM town.street_object WHERE type = 'shelter' AND placed_by = 'rule') FROM in_step;
DELETE FROM town.placement_rule;
SELECT 'and goes', holds FROM in_step;

-- Refused.
CREATE TABLE town.keyless (id bigint PRIMARY KEY);
CREATE TABLE town.strict (street_object_id bigint PRIMARY KEY, name text NOT NULL);
SELECT 'refused: ' || what, test.state(format('SELECT streetgen.specialise(%s)', arguments)) = state FROM (VALUES ('a table without its key', $$'town', 'kiosk', 'keyless'$$, '22023'),
  ('a column without a default', $$'town', 'kiosk', 'strict'$$, '22023'), ('no such table', $$'town', 'kiosk', 'nowhere'$$, '42P01'), ('no such type', $$'town', 'castle', 'shelter'$$, '22023'),
  ('a function of another signature', $$'town', 'kiosk', 'shelter', 'lower(text)'$$, '22023'), ('a table of the model', $$'town', 'kiosk', 'pedestrian_crossing'$$, '22023'), ('the table of objects itself', $$'town', 'kiosk', 'street_object'$$, '22023'),
  ('a table of another type', $$'town', 'kiosk', 'shelter'$$, '22023'), ('no such model', $$'nowhere', 'kiosk', 'shelter'$$, '3F000'), ('NULL', $$'town', NULL, 'shelter'$$, '22004')) v(what, arguments, state);
SELECT 'refused: a row without a place', test.state('INSERT INTO town.shelter (depth) VALUES (1)') = '22023';
SELECT 'refused: another key', test.state('UPDATE town.shelter SET street_object_id = -1') = '22023';
SELECT 'nothing was lost', holds FROM in_step;
CREATE TABLE town.cabin (street_object_id bigint PRIMARY KEY, colour text);
SELECT streetgen.specialise('town', 'shelter', 'cabin') \g /dev/null
SELECT 'another table takes a type over', (SELECT count(*) FROM town.cabin) = (SELECT count(*) FROM town.shelter);
CREATE TABLE left_behind AS SELECT * FROM town.shelter;
DELETE FROM town.street_object WHERE type = 'shelter';
SELECT 'the first one is let go, with its rows', count(*) > 10 AND count(*) = (SELECT count(*) FROM left_behind) AND NOT EXISTS (SELECT FROM town.cabin) FROM town.shelter;
UPDATE town.shelter SET depth = 5, geom = NULL;
SELECT 'and nothing follows it', bool_and(roof IS NOT NULL AND depth = 5) FROM town.shelter;
SELECT streetgen.drop_model('town') \g /dev/null
SELECT 'the model goes with it', to_regnamespace('town') IS NULL;
