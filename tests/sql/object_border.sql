\set ECHO none
\ir shared/truths.sql
-- Objects by the border stand by the kerb that is there: beside merging lanes, changes of width and roadways that lie aside.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
SELECT streetgen.create_model('road', 2154, subjects => '{ramp,kerb,object}') \g /dev/null
INSERT INTO road.axis (axis_id, geom, width, lane_count, direction, kind, speed) VALUES
  (1, pg_temp.line('LINESTRING(0 0, 600 0)'), 10.5, 3, 'direct', 'motorway', 100), (2, pg_temp.line('LINESTRING(600 0, 1400 0)'), 10.5, 3, 'direct', 'motorway', 100),
  (3, pg_temp.line('LINESTRING(1400 0, 2000 0)'), 10.5, 3, 'direct', 'motorway', 100), (4, pg_temp.line('LINESTRING(360 -64, 600 0)'), 3.5, 1, 'direct', 'motorway_link', 50),
  (5, pg_temp.line('LINESTRING(1400 0, 1640 -64)'), 3.5, 1, 'direct', 'motorway_link', 50);
SELECT 'a roadway with merging lanes says where its borders run', (SELECT borders IS NOT NULL FROM road.section JOIN road.edge USING (edge_id) WHERE axis_id = 2);
SELECT 'beside the first lane 8.75 m from the axis, past its taper 5.25 m', abs(streetgen._border_at(borders, 50, 'right') - 8.75) < 1e-6 AND abs(streetgen._border_at(borders, 400, 'right') - 5.25) < 1e-6
  AND abs(streetgen._border_at(borders, 50, 'left') - 5.25) < 1e-6 FROM streetgen._axis_borders('road', '{2}');
SELECT 'borders that rounding parts where two edges meet are one place', every(ST_AsText(streetgen._roadway_border('LINESTRING(0 0,100 0)'::geometry::bytea, ARRAY[0, 4, 4, x, 4, 4, x + 8e-15, 4, 4, 100, 4, 4], 30, 90, 'left', 0)::geometry, 9) = format('LINESTRING(30 4,%s 4,90 4)', x))
  FROM generate_series(40, 80) n, LATERAL (SELECT n::float8 AS x) p;
INSERT INTO road.placement_rule (type, side, every, axis_offset, distance_from_limit) VALUES ('lamp', 'both', 10, 1, 1);
CREATE VIEW off AS SELECT o.*, ST_Distance(o.geom, (SELECT ST_Collect(k.geom) FROM road.kerb k WHERE ST_DWithin(k.geom, o.geom, 5))) AS from_kerb, EXISTS (SELECT FROM road.roadway r WHERE ST_Intersects(r.surface, o.geom)) AS on_roadway FROM road.street_object o;
SELECT 'lamps of a rule stand a metre off the kerb, also beside merging lanes', count(*) > 300 AND bool_and(abs(from_kerb - 1) < 0.01 AND NOT on_roadway) FROM off WHERE type = 'lamp';
SELECT 'a second run changes nothing', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('road', wait => true);
INSERT INTO road.street_object (type, placement, axis_id, abscissa, abscissa_end, side, axis_offset) VALUES ('guard_rail', 'border', 2, 5, 790, 'right', 0.5);
SELECT 'a guard rail goes along with the lanes', count(*) > 700 AND bool_and(abs(away - 0.5) < 0.02) FROM off, generate_series(1, 781) m, LATERAL (SELECT ST_LineInterpolatePoint(geom, m / 782.0) AS place) p,
  LATERAL (SELECT min(ST_Distance(k.geom, place)) AS away FROM road.kerb k WHERE ST_DWithin(k.geom, place, 5)) d WHERE type = 'guard_rail';
INSERT INTO road.street_object_editing (type, geom) SELECT 'sign', streetgen._place_on(geom::bytea, 60, -9.75)::geometry FROM road.axis WHERE axis_id = 2;
SELECT 'a sign that is dropped there is measured from that kerb, and stays where it was dropped', side = 'right' AND placement = 'border' AND abs(axis_offset - 1) < 1e-6 AND abs(ST_Y(geom) + 9.75 - 6860000) < 1e-6 FROM road.street_object WHERE type = 'sign';
INSERT INTO road.street_object_editing (type, geom) SELECT 'manhole', streetgen._place_on(geom::bytea, 60, -7)::geometry FROM road.axis WHERE axis_id = 2;
SELECT 'what lies in the lane stands by the axis', placement = 'axis' AND abs(axis_offset + 7) < 1e-6 FROM road.street_object WHERE type = 'manhole';
INSERT INTO road.pedestrian_crossing_editing (axis_id, abscissa) VALUES (2, 45);
SELECT 'a crossing reaches both kerbs of the widened roadway', abs(ST_Area(surface) - 4 * 14) < 0.01 AND ST_NumGeometries(stripes) = 13 FROM road.pedestrian_crossing;
DELETE FROM road.axis WHERE axis_id = 4;
SELECT 'without the ramp all stand by the kerb that is left', bool_and(abs(from_kerb - 1) < 0.01 AND NOT on_roadway) FROM off WHERE type IN ('lamp', 'sign') AND axis_id = 2;
SELECT 'and the crossing ends there', (SELECT abs(ST_Area(surface) - 4 * 10.5) < 0.01 FROM road.pedestrian_crossing);
SELECT 'nothing is wrong', count(*) = 0 FROM streetgen.check_model('road') WHERE severity = 'error';

-- Changes of width: between two axes, at a node of three, and one kerb alone.
SELECT streetgen.create_model('town', 2154, subjects => '{kerb,object}') \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, speed) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 6, 50), (2, pg_temp.line('LINESTRING(100 0, 200 0)'), 10, 50), (3, pg_temp.line('LINESTRING(200 0, 300 0)'), 7, 50),
  (4, pg_temp.line('LINESTRING(200 0, 200 80)'), 6, 50);
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) SELECT 'tree', 'border', axis_id, x, side, 1.5 FROM (VALUES (1), (2), (3)) a(axis_id), generate_series(2, 98, 4) x, unnest('{left,right}'::text[]) side;
CREATE VIEW standing AS SELECT o.*, ST_Distance(o.geom, (SELECT ST_Collect(k.geom) FROM town.kerb k WHERE ST_DWithin(k.geom, o.geom, 12))) AS from_kerb FROM town.street_object o
  -- But about the corners of axis 4.
  WHERE NOT (side = 'left' AND abs(ST_X(geom) - 650200) < 15);
SELECT 'trees stand off the kerb through changes of width', count(*) > 120 AND bool_and(abs(from_kerb - 1.5) < 0.02) FROM standing;
UPDATE town.axis SET width = 14 WHERE axis_id = 2;
SELECT 'those of the neighbours follow a street that widens', bool_and(abs(from_kerb - 1.5) < 0.04) FROM standing;
INSERT INTO town.transition_override (axis_id, which, kind) VALUES (1, 'end', 'left');
UPDATE town.axis SET width = 6.5 WHERE axis_id = 1;
SELECT 'also where one kerb changes and the other one steps', count(*) FILTER (WHERE abs(from_kerb - 1.5) > 0.04) = 0 FROM standing WHERE abs(ST_X(geom) - 650100) > 1;
UPDATE town.axis SET width = 14, roadway_offset = 2 WHERE axis_id = 1;
SELECT 'and where a roadway lies aside', bool_and(abs(from_kerb - 1.5) < 0.04) FROM standing;
CREATE TABLE before AS SELECT edge_id, borders FROM town.section;
CREATE TABLE stood AS SELECT street_object_id, geom::bytea AS geom FROM town.street_object;
SELECT 'a run writes no row', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true);
TRUNCATE town.node CASCADE;
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'from scratch it is the same', NOT EXISTS (SELECT FROM stood JOIN town.street_object o USING (street_object_id) WHERE stood.geom <> o.geom::bytea);
SELECT 'nothing is wrong there', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';

-- Two axes become one, as clients merge them: a stretch along the border goes over to that one, whose border runs away there.
SELECT streetgen.create_model('heir', 2154, subjects => '{kerb,object}', driving_side => 'right') \g /dev/null
INSERT INTO heir.axis (axis_id, geom, width, importance, lane_count) VALUES (18, 'SRID=2154;LINESTRING(650580 6859994,650660 6859988)', 14, 2, 4), (19, 'SRID=2154;LINESTRING(650660 6859988,650740 6859985)', 14, 2, 4),
  (20, 'SRID=2154;LINESTRING(650660 6859988,650664 6859910)', 6, 5, 2), (21, 'SRID=2154;LINESTRING(650740 6859985,650800 6859984)', 8, 3, 2);
INSERT INTO heir.street_object (type, placement, axis_id, abscissa, abscissa_end, side, axis_offset) VALUES ('guard_rail', 'border', 19, 7.2, 67.2, 'right', -1);
UPDATE heir.axis SET geom = 'SRID=2154;LINESTRING(650580 6859994,650660 6859988,650740 6859985)' WHERE axis_id = 18;
DELETE FROM heir.axis WHERE axis_id = 19;
CREATE TABLE taken_over AS SELECT axis_id, geom FROM heir.street_object;
SELECT count(*) FROM streetgen.generate('heir', wait => true) \g /dev/null
SELECT 'an object that another axis takes over lies along the border of that one', axis_id = 18 AND t.geom = o.geom AND ST_NPoints(o.geom) > 2 FROM heir.street_object o JOIN taken_over t USING (axis_id);
