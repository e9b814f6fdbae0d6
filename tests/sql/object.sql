\set ECHO none
\ir shared/truths.sql
-- What stands at streets: places beside axes, and objects that follow them.
SELECT 'by the axis', ST_AsText(streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 30, 2.5, NULL)) = 'POINT(30 2.5)';
SELECT 'by the left border', ST_AsText(streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 30, 1, 'left')) = 'POINT(30 5)';
SELECT 'by the right border of a roadway that lies to the left', ST_AsText(streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 30, 1, 'right', 2)) = 'POINT(30 -3)';
SELECT 'on the roadway', ST_AsText(streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 30, -1, 'left')) = 'POINT(30 3)';
SELECT 'located', (l.abscissa, l.side, l.axis_offset, l.border_offset) = (30, 'right', -7, 3) FROM streetgen.locate_on('LINESTRING(0 0, 100 0)', 8, 'POINT(30 -7)') l;
SELECT 'an abscissa beyond the axis: 22023', test.state($$SELECT streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 101, 0, NULL)$$) = '22023';
SELECT 'a side of another word: 22023', test.state($$SELECT streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 1, 0, 'middle')$$) = '22023';
SELECT 'an offset of NaN: 22023', test.state($$SELECT streetgen.place_on('LINESTRING(0 0, 100 0)', 8, 1, 'NaN', NULL)$$) = '22023';

SELECT streetgen.create_model('town', 2154, subjects => '{object}') \g /dev/null
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.shape(geometry) RETURNS text LANGUAGE sql AS $$ SELECT ST_AsText(ST_SnapToGrid(ST_Translate($1, -650000, -6860000), 0.001)) $$;
CREATE FUNCTION pg_temp.stands(bigint) RETURNS text LANGUAGE sql AS $$ SELECT concat_ws(' ', pg_temp.shape(geom), round(angle), axis_id, round(abscissa::numeric, 3), side, round(axis_offset::numeric, 3), method) FROM town.street_object WHERE street_object_id = $1 $$;
INSERT INTO town.axis (geom, width) VALUES (pg_temp.line('LINESTRING(0 0, 100 0)'), 8), (pg_temp.line('LINESTRING(100 0, 100 80)'), 6);
SELECT 'a model begins with types', count(*) = 28 FROM town.object_type;

-- Dropped and dragged.
INSERT INTO town.street_object_editing (type, geom) VALUES ('lamp', pg_temp.line('POINT(30 5)')), ('manhole', pg_temp.line('POINT(30 1)')), ('tree', pg_temp.line('POINT(30 40)')), ('sign', pg_temp.line('POINT(70 -4.5)'));
SELECT 'beside the roadway by the border', pg_temp.stands(1) = 'POINT(30 5) 90 1 30.000 left 1.000 relative';
SELECT 'on it by the axis', pg_temp.stands(2) = 'POINT(30 1) 90 1 30.000 1.000 relative';
SELECT 'far away it stands alone', pg_temp.stands(3) = 'POINT(30 40) 0 absolute';
SELECT 'the edge at which each stands', array_agg((street_object_id, axis_id) ORDER BY 1) = ARRAY[(1::bigint, 1::bigint), (2::bigint, 1::bigint), (4::bigint, 1::bigint)]
  FROM town.object_edge JOIN town.edge USING (edge_id);
UPDATE town.axis SET width = 12 WHERE axis_id = 1;
SELECT 'a wider street moves what stands at its border', pg_temp.stands(1) LIKE 'POINT(30 7)%' AND pg_temp.stands(4) LIKE 'POINT(70 -6.5)%' AND pg_temp.stands(2) LIKE 'POINT(30 1)%';
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
UPDATE town.axis SET geom = ST_Translate(geom, 0, 10) WHERE axis_id = 1;
SELECT 'all goes with its axis but what stands alone', pg_temp.stands(1) LIKE 'POINT(30 15)%' AND pg_temp.stands(2) LIKE 'POINT(30 11)%' AND pg_temp.stands(3) LIKE 'POINT(30 40)%';
UPDATE town.axis SET geom = ST_Translate(geom, 0, -10) WHERE axis_id = 1;
UPDATE town.street_object_editing SET geom = pg_temp.line('POINT(107 40)') WHERE street_object_id = 1;
SELECT 'dragged to another street', pg_temp.stands(1) = 'POINT(107 40) 0 2 40.000 right 4.000 relative';
UPDATE town.street_object_editing SET abscissa = 50, axis_offset = 1 WHERE street_object_id = 1;
SELECT 'typed', pg_temp.stands(1) = 'POINT(104 50) 0 2 50.000 right 1.000 relative';
UPDATE town.street_object_editing SET orientation = -90 WHERE street_object_id = 1;
SELECT 'turned against its axis', round(angle) = 270 FROM town.street_object WHERE street_object_id = 1;
UPDATE town.street_object_editing SET placement = 'axis' WHERE street_object_id = 1;
SELECT 'measured from the axis it stays', pg_temp.stands(1) = 'POINT(104 50) 270 2 50.000 -4.000 relative';
UPDATE town.street_object_editing SET geom = pg_temp.line('POINT(300 300)') WHERE street_object_id = 4;
SELECT 'dragged off all streets', pg_temp.stands(4) LIKE 'POINT(300 300) %' AND placement = 'absolute' FROM town.street_object WHERE street_object_id = 4;

-- A stretch along a border that widens.
UPDATE town.axis SET width_end = 10 WHERE axis_id = 2;
INSERT INTO town.street_object (type, placement, axis_id, abscissa, abscissa_end, side, axis_offset) VALUES ('guard_rail', 'border', 2, 0, 80, 'right', 0.5);
SELECT 'a guard rail keeps its distance from the border', pg_temp.shape(geom) = 'LINESTRING(103.5 0,105.5 80)' FROM town.street_object WHERE type = 'guard_rail';

-- Split, merge, turn round, delete: nothing moves, nothing vanishes.
DELETE FROM town.street_object WHERE type = 'guard_rail' OR street_object_id = 4;
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) SELECT 'tree', 'border', 1, n * 9, CASE n % 2 WHEN 0 THEN 'left' ELSE 'right' END, 1.2 FROM generate_series(1, 10) n;
CREATE TABLE stood AS SELECT street_object_id, geom, angle FROM town.street_object;
CREATE FUNCTION pg_temp.moved() RETURNS bigint LANGUAGE sql AS $$ SELECT count(*) FROM stood s LEFT JOIN town.street_object o USING (street_object_id) WHERE NOT coalesce(ST_DWithin(s.geom, o.geom, 1e-6), false) $$;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'an axis turned round', pg_temp.moved() = 0 AND (SELECT side = 'left' AND abs(abscissa - 91) < 1e-6 FROM town.street_object WHERE type = 'tree' AND axis_id = 1 ORDER BY street_object_id LIMIT 1);
SELECT 'what faced along the street still does', abs(o.angle - s.angle) < 1e-6 FROM stood s JOIN town.street_object o USING (street_object_id) WHERE street_object_id = 2;
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(0 0, 50 0)') WHERE axis_id = 1;
SELECT 'cut back, what stood beyond is an orphan', count(*) > 0 AND pg_temp.moved() = 0 FROM town.street_object WHERE method = 'orphaned';
SELECT 'check_model tells of each', (SELECT count(*) FROM streetgen.check_model('town') WHERE rule = 'object whose axis is gone') = count(*) FROM town.street_object WHERE method = 'orphaned';
INSERT INTO town.axis (geom, width) VALUES (pg_temp.line('LINESTRING(50 0, 100 0)'), 8);
SELECT 'the other half takes them', count(*) = 0 AND pg_temp.moved() = 0 FROM town.street_object WHERE method = 'orphaned';
SELECT 'each on its half', bool_and(axis_id = CASE WHEN ST_X(geom) < 650050 THEN 1 ELSE 3 END) FROM town.street_object WHERE type = 'tree' AND method = 'relative';
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(0 0, 50 0, 100 0)') WHERE axis_id = 1;
DELETE FROM town.axis WHERE axis_id = 3;
SELECT 'merged, all are on the one axis', pg_temp.moved() = 0 AND bool_and(axis_id = 1) FROM town.street_object WHERE type = 'tree' AND method = 'relative';
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'of a deleted axis all stay', pg_temp.moved() = 0 AND count(*) FILTER (WHERE method = 'orphaned') = 11 FROM town.street_object;
SELECT 'and stand at no edge', count(*) = 1 FROM town.object_edge;
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 8);
SELECT 'drawn again, it has them again', pg_temp.moved() = 0 AND count(*) FILTER (WHERE method = 'orphaned') = 0 FROM town.street_object;

-- The place that arc length and normal give; tests/battery/objects asks after random edits.
\ir shared/astray.sql
UPDATE town.axis SET width_end = NULL;
UPDATE town.axis SET geom = ST_AddPoint(geom, ST_Translate(ST_EndPoint(geom), 12, -7)), width = 7.5;
SELECT 'each stands where arc length and normal put it', count(*) FILTER (WHERE NOT metres <= 0.001) = 0 AND count(*) > 10 FROM test.astray();
SELECT 'no error of check_model', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';
SELECT 'what stands alone did not move', pg_temp.stands(3) = 'POINT(30 40) 0 absolute';
CREATE TABLE before AS SELECT street_object_id, xmin::text AS written FROM town.street_object;
SELECT 'a second run writes nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town', wait => true);
SELECT 'nor an object', bool_and(o.xmin::text = b.written) FROM before b JOIN town.street_object o USING (street_object_id);

-- Edits that nobody follows.
SELECT streetgen.live('town', false) \g /dev/null
UPDATE town.axis SET geom = ST_Translate(geom, 5, 5), width = 9;
SELECT 'objects go with their axes also where streets do not follow', count(*) FILTER (WHERE NOT metres <= 0.001) = 0 AND count(*) > 10 FROM test.astray();
SELECT streetgen.live('town', true) \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null

-- Switched off and on.
CREATE TABLE kept AS SELECT street_object_id, geom FROM town.street_object;
CREATE FUNCTION town.free_places(text) RETURNS text LANGUAGE sql AS 'SELECT $1';
CREATE VIEW town.theirs AS SELECT town.free_places('theirs') AS said;
SELECT count(*) FROM streetgen.switch_subject('town', 'object', false) \g /dev/null
SELECT 'a function of others by a name of ours stays, with what stands on it', said = 'theirs' FROM town.theirs;
DROP FUNCTION town.free_places(text) CASCADE;
SELECT 'switched off, objects stay', (SELECT count(*) FROM town.street_object) = count(*) AND to_regclass('town.object_edge') IS NULL AND to_regclass('town.street_object_editing') IS NULL FROM kept;
SELECT count(*) FROM streetgen.switch_subject('town', 'object', true) \g /dev/null
SELECT 'switched on again, they stand where they did', bool_and(ST_DWithin(k.geom, o.geom, 1e-6)) FROM kept k JOIN town.street_object o USING (street_object_id);
SELECT 'and have their edges', count(*) = (SELECT count(*) FROM town.street_object WHERE method = 'relative') FROM town.object_edge;

-- Bad input.
CREATE FUNCTION pg_temp.said(statement text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  RETURN 'nothing';
EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE || ' ' || SQLERRM; END $$;
SELECT 'an abscissa beyond its axis', pg_temp.said('UPDATE town.street_object_editing SET abscissa = 5000 WHERE street_object_id = 2') = '22023 the abscissa of object 2 cannot be 5000';
SELECT 'a stretch without length', pg_temp.said('UPDATE town.street_object SET abscissa_end = abscissa + 1e-6 WHERE street_object_id = 2') = '22023 the end of object 2 lies at its start';
SELECT 'an offset of a kilometre', pg_temp.said('UPDATE town.street_object_editing SET axis_offset = 1000 WHERE street_object_id = 2') = '22023 the offset of object 2 cannot be 1000';
SELECT 'no placement', pg_temp.said('UPDATE town.street_object_editing SET placement = NULL WHERE street_object_id = 2') = '22004 the placement of object 2 cannot be NULL';
SELECT 'an orientation of NaN', pg_temp.said($$UPDATE town.street_object_editing SET orientation = 'NaN' WHERE street_object_id = 2$$) LIKE '22023 the orientation of object 2 cannot be NaN';
SELECT 'no place at all', pg_temp.said($$INSERT INTO town.street_object (type) VALUES ('lamp')$$) = '22023 the new object has no place';
SELECT 'a coordinate that is none', pg_temp.said($$INSERT INTO town.street_object_editing (type, geom) VALUES ('lamp', '01010000206A080000000000000000F87F000000000000F03F')$$) LIKE '22023 the new object has a coordinate that is no place';
SELECT 'an unknown type', pg_temp.said($$INSERT INTO town.street_object_editing (type, geom) VALUES ('rocket', pg_temp.line('POINT(30 5)'))$$) = '22023 there is no object type "rocket"';
SELECT 'no type', pg_temp.said($$INSERT INTO town.street_object_editing (geom) VALUES (pg_temp.line('POINT(30 5)'))$$) = '22023 the new object has no type';
SELECT 'a type that is taken away', pg_temp.said('UPDATE town.street_object SET type = NULL WHERE street_object_id = 2') = '22023 object 2 has no type';
SELECT 'another side', pg_temp.said($$UPDATE town.street_object SET placement = 'border', side = 'middle' WHERE street_object_id = 2$$) = '22023 the side of object 2 cannot be "middle"';
SELECT 'an axis that is not there', pg_temp.said($$INSERT INTO town.street_object (type, axis_id, abscissa) VALUES ('lamp', 99, 5)$$) = '22023 the axis of the new object is gone';
SELECT 'a type below itself', pg_temp.said($$UPDATE town.object_type SET parent = 'lamp' WHERE type = 'pole'$$) = '22023 object type "pole" cannot stand below "lamp"';

-- Rules.
SELECT streetgen.create_model('ruled', 2154, subjects => '{object}') \g /dev/null
INSERT INTO ruled.axis (geom, width, importance, kind) VALUES (pg_temp.line('LINESTRING(0 0, 200 0)'), 8, 2, 'primary'), (pg_temp.line('LINESTRING(200 0, 200 150)'), 6, 4, 'residential'), (pg_temp.line('LINESTRING(200 0, 350 0)'), 8, 2, 'primary');
INSERT INTO ruled.placement_rule (type, side, every, phase, axis_offset, distance_from_limit) VALUES ('lamp', 'alternating', 25, 12, 0.8, 2);
SELECT 'lamps stand every 25 m on alternating sides', bool_and((abs(o.abscissa - 12) / 25)::numeric % 1 = 0 AND o.side = CASE ((o.abscissa - 12) / 25)::integer % 2 WHEN 0 THEN 'left' ELSE 'right' END
    AND abs(ST_Distance(o.geom, a.geom) - a.width / 2 - 0.8) < 1e-6) AND count(*) > 12 FROM ruled.street_object o JOIN ruled.axis a USING (axis_id);
SELECT 'none within the limits', count(*) = 0 FROM ruled.street_object o JOIN ruled.object_edge USING (street_object_id) JOIN ruled.edge e USING (edge_id) JOIN ruled.section_limit l USING (edge_id)
  WHERE CASE l.which WHEN 'start' THEN o.abscissa - e.start_abscissa < l.abscissa + 2 - 1e-6 ELSE o.abscissa - e.start_abscissa > l.abscissa - 2 + 1e-6 END;
INSERT INTO ruled.placement_rule (type, along, side, distance_from_limit) VALUES ('crossing', 'arm', 'alternating', 2.5);
SELECT 'a crossing on each arm of the node of three', count(*) = 3 FROM ruled.pedestrian_crossing WHERE surface IS NOT NULL AND stripes IS NOT NULL;
SELECT 'as wide as the street across, and on its roadway', bool_and(abs(ST_Area(c.surface) - c.width * a.width) < 1e-6 AND ST_Area(ST_Intersection(c.surface, s.surface)) > 0.999 * ST_Area(c.surface) AND ST_Covers(ST_Buffer(c.surface, 1e-6), c.stripes))
  FROM ruled.pedestrian_crossing c JOIN ruled.street_object o USING (street_object_id) JOIN ruled.axis a USING (axis_id) JOIN ruled.object_edge USING (street_object_id) JOIN ruled.section s USING (edge_id);
UPDATE ruled.pedestrian_crossing_editing SET angle = 60, width = 3 WHERE axis_id = 2;
SELECT 'an oblique one is as long as width by sine', abs(ST_Area(surface) - 3 * 6 / sin(radians(60))) < 1e-6 FROM ruled.pedestrian_crossing JOIN ruled.street_object USING (street_object_id) WHERE axis_id = 2;
UPDATE ruled.object_type SET distance_least = 3 WHERE type = 'tree';
INSERT INTO ruled.placement_rule (type, side, every, axis_offset, distance_from_limit, importance_from, density) VALUES ('tree', 'both', 8, 1.5, 10, 3, 1);
SELECT 'trees on the less important street alone, 3 m from lamps', count(*) > 10 AND bool_and(o.axis_id = 2) AND bool_and(NOT EXISTS (SELECT FROM ruled.street_object l WHERE l.type = 'lamp' AND l.side = o.side AND l.axis_id = o.axis_id AND abs(l.abscissa - o.abscissa) < 3)) FROM ruled.street_object o WHERE type = 'tree';
CREATE TABLE ruled_before AS SELECT street_object_id, xmin::text AS written, geom FROM ruled.street_object;
SELECT count(*) FROM streetgen.generate('ruled', wait => true) \g /dev/null
SELECT 'a second run keeps every row', bool_and(b.written = o.xmin::text) AND count(*) = (SELECT count(*) FROM ruled_before) FROM ruled_before b JOIN ruled.street_object o USING (street_object_id);
-- One is moved by hand: its place stays free.
CREATE TABLE one AS SELECT street_object_id, rule_place FROM ruled.street_object WHERE type = 'lamp' AND axis_id = 1 ORDER BY abscissa LIMIT 1;
UPDATE ruled.street_object_editing SET abscissa = abscissa + 3 WHERE street_object_id = (SELECT street_object_id FROM one);
SELECT count(*) FROM streetgen.generate('ruled', wait => true) \g /dev/null
SELECT 'a lamp that was dragged is the user''s, and its place stays free', (SELECT placed_by = 'user' AND abscissa = 15 FROM ruled.street_object JOIN one USING (street_object_id)) AND count(*) = 1 FROM ruled.street_object WHERE type = 'lamp' AND axis_id = 1 AND abscissa < 30;
INSERT INTO ruled.street_object_editing (type, geom) SELECT 'kiosk', geom FROM ruled.street_object WHERE type = 'tree' ORDER BY street_object_id LIMIT 1;
SELECT 'a tree gives way to what somebody puts there', count(*) = 0 FROM ruled.street_object t JOIN ruled.street_object k ON k.type = 'kiosk' AND ST_DWithin(t.geom, k.geom, 3) WHERE t.type = 'tree';
DELETE FROM ruled.street_object WHERE type = 'kiosk';
SELECT 'and comes back', (SELECT count(*) FROM ruled.street_object WHERE type = 'tree') = (SELECT count(*) FROM ruled_before b WHERE NOT EXISTS (SELECT FROM ruled.street_object o WHERE o.type <> 'tree' AND o.street_object_id = b.street_object_id));
-- Edits against a run from scratch.
UPDATE ruled.axis SET geom = pg_temp.line('LINESTRING(0 0, 100 20, 200 0)'), width = 10 WHERE axis_id = 1;
INSERT INTO ruled.axis (geom, width, importance) VALUES (pg_temp.line('LINESTRING(270 -50, 270 60)'), 7, 4);
CREATE FUNCTION pg_temp.standing() RETURNS text LANGUAGE sql AS $$ SELECT md5(string_agg(concat_ws(' ', type, rule_id, axis_id, rule_place, ST_AsText(ST_SnapToGrid(geom, 1e-6))), ',' ORDER BY type, rule_id, axis_id, rule_place)) FROM ruled.street_object $$;
CREATE TABLE edited AS SELECT pg_temp.standing() AS standing, (SELECT max(free_place_id) FROM ruled.free_place) AS last_free;
DELETE FROM ruled.street_object WHERE placed_by = 'rule';
DELETE FROM ruled.free_place WHERE free_place_id > (SELECT last_free FROM edited);
SELECT count(*) FROM streetgen.generate('ruled', wait => true) \g /dev/null
SELECT 'edits leave what a run from scratch gives', standing = pg_temp.standing() FROM edited;
UPDATE ruled.placement_rule SET active = false WHERE type = 'tree';
SELECT 'a rule switched off takes its objects away', count(*) = 0 FROM ruled.street_object WHERE type = 'tree';
DELETE FROM ruled.pedestrian_crossing;
SELECT 'an object goes with its crossing', count(*) = 0 FROM ruled.street_object WHERE type = 'crossing' AND placed_by <> 'rule';
SELECT 'a rule every 0 m', pg_temp.said($$INSERT INTO ruled.placement_rule (type, every) VALUES ('lamp', 0)$$) = '22023 the new rule cannot place an object every 0 m';
SELECT 'a rule of a million a metre', pg_temp.said($$INSERT INTO ruled.placement_rule (type, every) VALUES ('lamp', 0.000001)$$) = '22023 the new rule cannot place an object every 1e-06 m';
SELECT 'a crossing wider than its street is long', pg_temp.said($$INSERT INTO ruled.pedestrian_crossing_editing (geom, width) VALUES (pg_temp.line('POINT(20 0)'), 500)$$) = '22023 the width of the new crossing cannot be 500';
-- What only a street can place is refused where there is none, with the nearest axis and the way out.
CREATE TEMP VIEW afar(name, statement) AS VALUES
  ('a crossing dropped', $$INSERT INTO ruled.pedestrian_crossing_editing (geom) VALUES (pg_temp.line('POINT(0 5000)'))$$), ('a bay dropped', $$INSERT INTO ruled.parking_bay_editing (geom) VALUES (pg_temp.line('POINT(0 5000)'))$$),
  ('an object by a border dropped', $$INSERT INTO ruled.street_object_editing (type, placement, geom) VALUES ('bench', 'border', pg_temp.line('POINT(0 5000)'))$$),
  ('a crossing dragged', $$UPDATE ruled.pedestrian_crossing_editing SET geom = pg_temp.line('POINT(0 5000)')$$), ('a bay dragged', $$UPDATE ruled.parking_bay_editing SET geom = pg_temp.line('POINT(0 5000)')$$),
  ('a crossing with an abscissa', $$INSERT INTO ruled.pedestrian_crossing_editing (geom, abscissa) VALUES (pg_temp.line('POINT(0 5000)'), 5)$$), ('a bay with an abscissa', $$INSERT INTO ruled.parking_bay_editing (geom, abscissa) VALUES (pg_temp.line('POINT(0 5000)'), 5)$$),
  ('a crossing in the layer of all objects', $$INSERT INTO ruled.street_object_editing (type, geom) VALUES ('crossing', pg_temp.line('POINT(0 5000)'))$$), ('a bay in the layer of all objects, absolute', $$INSERT INTO ruled.street_object_editing (type, placement, geom) VALUES ('parking_bay', 'absolute', pg_temp.line('POINT(0 5000)'))$$),
  ('a crossing dragged in the layer of all objects', $$UPDATE ruled.street_object_editing SET geom = pg_temp.line('POINT(0 5000)') WHERE type = 'crossing'$$),
  ('an object without a type', $$INSERT INTO ruled.street_object_editing (placement, geom) VALUES ('axis', pg_temp.line('POINT(0 5000)'))$$),
  ('a crossing without its axis', $$UPDATE ruled.pedestrian_crossing_editing SET axis_id = NULL$$), ('a bay without its axis', $$UPDATE ruled.parking_bay_editing SET axis_id = NULL$$);
BEGIN;
INSERT INTO ruled.pedestrian_crossing_editing (geom) VALUES (pg_temp.line('POINT(50 0)'));
INSERT INTO ruled.parking_bay_editing (geom) VALUES (pg_temp.line('POINT(30 4)'));
SELECT name || ' far from all streets is refused in words', state = '22023' AND said ~ '^(the new (crossing|parking bay|bay|bench|object)|crossing \d+|parking bay \d+|object \d+) stands at no street$' AND detail ~ 'nearest axis, \d+, is 4\d{3}.* m away: setting object_snap is 20 m' = (name !~ 'axis$') AND hint ~ 'axis_id' FROM afar, test.refusal(statement);
SELECT 'none of them is stored', count(*) = 0 FROM ruled.street_object WHERE method = 'absolute';
INSERT INTO ruled.street_object (type, geom) VALUES ('crossing', pg_temp.line('POINT(0 5000)')), ('parking_bay', pg_temp.line('POINT(9 5000)'));
SELECT 'what an import leaves without a street is found', array_agg(rule ORDER BY rule) = '{"parking bay without its ground","pedestrian crossing without its roadway"}' FROM streetgen.check_model('ruled') WHERE rule ~ '^(parking bay|pedestrian crossing) without';
ROLLBACK;
-- An arm whose way is cut in two before its section begins, and one that ends there.
SELECT streetgen.create_model('cut', 2154, subjects => '{object}') \g /dev/null
INSERT INTO cut.axis (geom, width) VALUES (pg_temp.line('LINESTRING(0 0, 100 0)'), 8), (pg_temp.line('LINESTRING(100 0, 200 0)'), 8), (pg_temp.line('LINESTRING(100 0, 100 6)'), 6), (pg_temp.line('LINESTRING(100 6, 100 80)'), 6);
INSERT INTO cut.placement_rule (type, along, distance_from_limit) VALUES ('crossing', 'arm', 1);
SELECT 'an arm that is cut in two has its crossing too', array_agg(axis_id ORDER BY axis_id) = '{1,2,3}' AND every(ST_Area(surface) > 20) FROM cut.street_object JOIN cut.pedestrian_crossing USING (street_object_id);
DELETE FROM cut.axis WHERE axis_id = 4;
SELECT 'one that ends there has none', array_agg(axis_id ORDER BY axis_id) = '{1,2}' FROM cut.street_object;
INSERT INTO cut.axis (geom, width) VALUES (pg_temp.line('LINESTRING(100 6, 100 80)'), 6);
SELECT 'until it goes on', array_agg(axis_id ORDER BY axis_id) = '{1,2,3}' FROM cut.street_object;
-- An arm that has a crossing of others gets none, within 20 m on its street.
CREATE FUNCTION pg_temp.crossed(OUT of_rule bigint[], OUT by_hand bigint[]) LANGUAGE sql AS $$ SELECT array_agg(axis_id ORDER BY axis_id) FILTER (WHERE placed_by = 'rule'), array_agg(axis_id ORDER BY axis_id) FILTER (WHERE placed_by <> 'rule') FROM cut.street_object WHERE type = 'crossing' $$;
INSERT INTO cut.pedestrian_crossing_editing (geom) VALUES (pg_temp.line('POINT(80 0)'));
SELECT 'where one walks over a street by hand, no rule places a second crossing of the arm', of_rule = '{2,3}' AND by_hand = '{1}' FROM pg_temp.crossed();
SELECT 'a run leaves it so', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('cut', wait => true);
UPDATE cut.pedestrian_crossing_editing SET abscissa = 60 WHERE axis_id = 1;
SELECT 'one farther off is none of the arm', of_rule = '{1,2,3}' AND by_hand = '{1}' FROM pg_temp.crossed();
UPDATE cut.pedestrian_crossing_editing SET abscissa = 85 WHERE axis_id = 1 AND abscissa = 60;
SELECT 'it is when it comes nearer', of_rule = '{2,3}' FROM pg_temp.crossed();
DELETE FROM cut.pedestrian_crossing_editing WHERE axis_id = 1;
SELECT 'that of the rule comes back', of_rule = '{1,2,3}' AND by_hand IS NULL FROM pg_temp.crossed();
-- Streets of 30 to 69 m between two junctions, whose limits lie 18.5 m from a node: from 38 m on there is a section.
SELECT streetgen.create_model('short', 2154, subjects => '{object}') \g /dev/null
INSERT INTO short.axis (axis_id, geom, width) SELECT 10 * k + n, pg_temp.line(format(line, 400 * k, 30 + k)), 7 FROM generate_series(0, 39) k,
  (VALUES (1, 'LINESTRING(0 %1$s, %2$s %1$s)'), (2, 'LINESTRING(-80 %1$s, 0 %1$s)'), (3, 'LINESTRING(%2$s %1$s, 200 %1$s)')) v(n, line);
INSERT INTO short.axis (axis_id, geom, width) SELECT 10 * k + n, pg_temp.line(format(line, 400 * k, 30 + k, 400 * k + side)), 7 FROM generate_series(0, 39) k,
  (VALUES (4, 'LINESTRING(0 %1$s, 0 %3$s)', 80), (5, 'LINESTRING(%2$s %1$s, %2$s %3$s)', -80)) v(n, line, side);
INSERT INTO short.placement_rule (type, along, distance_from_limit) VALUES ('crossing', 'arm', 2.5);
CREATE TEMP VIEW short_crossing AS SELECT axis_id, street_object_id, surface FROM short.street_object JOIN short.pedestrian_crossing USING (street_object_id) WHERE axis_id % 10 = 1;
SELECT 'a street without room for two crossings has one, and with room two', array_agg(DISTINCT n) = '{1,2}' AND bool_and(n >= before) AND count(*) = 32
  FROM (SELECT n, lag(n, 1, 1) OVER (ORDER BY axis_id) AS before FROM (SELECT axis_id, count(*) AS n FROM short_crossing GROUP BY axis_id) c) c;
SELECT 'two crossings of a street leave the length of one between them', min(ST_Distance(a.surface, b.surface)) BETWEEN 3.99 AND 5
  FROM short_crossing a JOIN short_crossing b USING (axis_id) WHERE a.street_object_id < b.street_object_id;
-- A side without a placement means the border there.
INSERT INTO short.street_object_editing (type, axis_id, abscissa, side, axis_offset) VALUES ('tree', 1, 10, 'left', 1)
  RETURNING 'an object with a side stands by its border', (placement, side, axis_offset) = ('border', 'left', 1) AND ST_DWithin(geom, pg_temp.line('POINT(10 4.5)'), 1e-6);
SELECT 'and is refused by the axis', pg_temp.said($$INSERT INTO short.street_object (type, placement, axis_id, abscissa, side) VALUES ('tree', 'axis', 1, 10, 'left')$$) LIKE '22023 % stands on no side';
SELECT 'a run over all places the same', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('cut', wait => true);
-- A first run takes keys off and puts them back.
SELECT streetgen.create_model('first', 2154, subjects => '{object}') \g /dev/null
SELECT streetgen.live('first', false) \g /dev/null
INSERT INTO first.axis (geom, width) SELECT pg_temp.line(format('LINESTRING(%s %s, %s %s)', 100 * x, 100 * y, 100 * x + CASE k WHEN 0 THEN 100 ELSE 0 END, 100 * y + CASE k WHEN 0 THEN 0 ELSE 100 END)), 7 FROM generate_series(0, 22) x, generate_series(0, 22) y, generate_series(0, 1) k;
INSERT INTO first.placement_rule (type, side, every) VALUES ('lamp', 'alternating', 25);
SELECT streetgen.live('first', true) \g /dev/null
CREATE FUNCTION pg_temp.made_of() RETURNS text[] LANGUAGE sql AS $$
    SELECT array_agg(what ORDER BY what) FROM (SELECT pg_get_indexdef(indexrelid) AS what FROM pg_index WHERE indrelid = ANY ('{first.object_type,first.street_object,first.object_edge}'::regclass[])
        UNION ALL SELECT conrelid::regclass || conname || pg_get_constraintdef(oid) FROM pg_constraint WHERE connamespace = 'first'::regnamespace) m $$;
CREATE TEMP TABLE first_keys AS SELECT pg_temp.made_of() AS made, 'first.street_object_geom'::regclass::oid AS geom;
SELECT count(*) FROM streetgen.generate('first', wait => true) \g /dev/null
SELECT 'a first run makes the indexes of objects after their rows, and they are as before', made = pg_temp.made_of() AND geom <> 'first.street_object_geom'::regclass FROM first_keys;
UPDATE first_keys SET geom = 'first.street_object_geom'::regclass;
SELECT 'a first run places objects and joins them to edges', (SELECT count(*) FROM first.street_object) = count(*) AND count(*) > 3000 FROM first.object_edge;
SELECT 'a second one changes nothing', sum(inserted + updated + deleted) = 0 AND min(geom) = 'first.street_object_geom'::regclass FROM streetgen.generate('first', wait => true), first_keys;

-- An editor, who owns nothing of the model.
CREATE ROLE streetgen_test_planter ROLE CURRENT_USER;
SELECT streetgen."grant"('town', 'streetgen_test_planter', 'editor'), streetgen."grant"('ruled', 'streetgen_test_planter', 'editor') \g /dev/null
SET ROLE streetgen_test_planter;
INSERT INTO town.street_object_editing (type, geom) VALUES ('kiosk', pg_temp.line('POINT(50 9)'));
UPDATE town.street_object_editing SET orientation = 45 WHERE type = 'kiosk';
SELECT 'an editor puts an object and turns it', count(*) > 0 AND bool_and(orientation = 45) FROM town.street_object WHERE type = 'kiosk';
DELETE FROM ruled.street_object_editing WHERE street_object_id = (SELECT min(street_object_id) FROM ruled.street_object);
SELECT 'and takes one away where rules place them', count(*) > 0 FROM ruled.free_place;
RESET ROLE;
SELECT 'the locks of such edits are not for everybody', count(*) = 3 AND NOT bool_or(EXISTS (SELECT FROM aclexplode(proacl) WHERE grantee = 0))
  AND bool_and(has_function_privilege('streetgen_test_planter', oid, 'EXECUTE')) FROM pg_proc WHERE pronamespace = 'ruled'::regnamespace AND proname IN ('_begin_ruled_edit', '_lock_beside', '_hold_borders');
SELECT count(*) FROM streetgen.switch_subject('ruled', 'kerb', true) \g /dev/null
SELECT 'an editor may take them after a subject was switched on', bool_and(has_function_privilege('streetgen_test_planter', oid, 'EXECUTE')) FROM pg_proc WHERE pronamespace = 'ruled'::regnamespace AND proname = '_lock_beside';
SELECT streetgen."grant"('ruled', 'streetgen_test_planter', 'reader') \g /dev/null
SELECT 'who becomes a reader may not', NOT bool_or(has_function_privilege('streetgen_test_planter', oid, 'EXECUTE')) FROM pg_proc WHERE pronamespace = 'ruled'::regnamespace AND proname IN ('_begin_ruled_edit', '_lock_beside', '_hold_borders');
DROP OWNED BY streetgen_test_planter;
DROP ROLE streetgen_test_planter;
-- Names that need quotes, in the texts of functions too.
SELECT streetgen.create_model('Ville "d''Été"', 2154, subjects => '{all}') \g /dev/null
INSERT INTO "Ville ""d'Été""".axis (geom) VALUES (pg_temp.line('LINESTRING(0 0, 100 0)')), (pg_temp.line('LINESTRING(100 0, 100 80)')), (pg_temp.line('LINESTRING(100 0, 200 0)'));
SELECT 'any name will do for a model of all subjects', count(*) > 25 AND sum(skipped) = 0 FROM streetgen.generate('Ville "d''Été"');
