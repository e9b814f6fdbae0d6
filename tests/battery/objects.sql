-- Streets with objects, which tests/battery/objects runs, random edits of both, and where each object is to stand, in plain SQL.
SET client_min_messages = warning;
CREATE EXTENSION IF NOT EXISTS streetgen CASCADE;
SELECT streetgen.create_model('town', 2154, subjects => '{object}') \g /dev/null
-- Widths change at once, so that a border lies half of the width aside.
SELECT streetgen.set('town', 'transition_length', '0') \g /dev/null
CREATE SCHEMA furnish;
CREATE FUNCTION furnish.near(geom geometry, far float8) RETURNS geometry LANGUAGE sql VOLATILE
  RETURN ST_Translate(geom, far * (2 * random() - 1), far * (2 * random() - 1));
INSERT INTO town.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ARRAY[ST_Point(650000 + 150 * (n / 4), 6860000 + 150 * (n % 4)), ST_Point(650060 + 150 * (n / 4), 6860010 + 150 * (n % 4)), ST_Point(650110 + 150 * (n / 4), 6860000 + 150 * (n % 4))]), 2154), 8
FROM generate_series(0, 15) n;
INSERT INTO town.street_object_editing (type, geom) SELECT (ARRAY['lamp', 'tree', 'sign', 'manhole'])[1 + n % 4], furnish.near(ST_LineInterpolatePoint(geom, random()), 12) FROM town.axis, generate_series(1, 4) n;
-- Far from all streets, and beside one: neither is to move.
INSERT INTO town.street_object (type, placement, geom) SELECT 'kiosk', 'absolute', furnish.near(ST_SetSRID(ST_Point(650250, 6860250), 2154), 300) FROM generate_series(1, 20);
CREATE TABLE furnish.stood AS SELECT street_object_id, geom FROM town.street_object WHERE placement = 'absolute';

-- The distance of an object from where it is to stand.
\ir ../sql/shared/astray.sql
CREATE VIEW furnish.astray AS
  SELECT * FROM test.astray()
  UNION ALL SELECT s.street_object_id, coalesce(ST_Distance(s.geom, o.geom), 'Infinity') FROM furnish.stood s LEFT JOIN town.street_object o USING (street_object_id);

-- One random edit of a street, or of an object by its view.
CREATE FUNCTION furnish.edit() RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  a town.axis;
  standing bigint;
  cut float8 := 0.2 + 0.6 * random();
BEGIN
  SELECT * INTO a FROM town.axis ORDER BY random() LIMIT 1;
  SELECT street_object_id INTO standing FROM town.street_object WHERE placement <> 'absolute' ORDER BY random() LIMIT 1;
  CASE floor(random() * 12)
    WHEN 0, 1 THEN UPDATE town.axis SET geom = ST_SetPoint(geom, floor(random() * ST_NPoints(geom))::integer, furnish.near(ST_PointN(geom, 1 + floor(random() * ST_NPoints(geom))::integer), 5)) WHERE axis_id = a.axis_id;
      RETURN 'a vertex moved';
    WHEN 2 THEN UPDATE town.axis SET width = 4 + random() * 8 WHERE axis_id = a.axis_id;
      RETURN 'a width';
    WHEN 3 THEN UPDATE town.axis SET geom = furnish.near(geom, 3) WHERE axis_id = a.axis_id;
      RETURN 'moved';
    WHEN 4 THEN UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = a.axis_id;
      RETURN 'turned round';
    WHEN 5 THEN UPDATE town.axis SET geom = ST_AddPoint(geom, furnish.near(ST_EndPoint(geom), 15)) WHERE axis_id = a.axis_id AND ST_NPoints(geom) < 20;
      RETURN 'drawn on';
    WHEN 6 THEN UPDATE town.axis SET geom = ST_LineSubstring(geom, 0, cut) WHERE axis_id = a.axis_id;
      INSERT INTO town.axis (geom, width) VALUES (ST_LineSubstring(a.geom, cut, 1), a.width);
      RETURN 'split';
    WHEN 7 THEN DELETE FROM town.axis WHERE axis_id = a.axis_id;
      INSERT INTO town.axis (geom, width) VALUES (a.geom, a.width);
      RETURN 'drawn anew';
    WHEN 8 THEN UPDATE town.axis SET geom = ST_AddPoint(geom, ST_LineInterpolatePoint(geom, 0.37), 1) WHERE axis_id = a.axis_id AND ST_NPoints(geom) = 2;
      RETURN 'a vertex added';
    WHEN 9 THEN INSERT INTO town.street_object_editing (type, geom) SELECT 'pole', furnish.near(ST_LineInterpolatePoint(a.geom, random()), 10);
      RETURN 'an object put';
    WHEN 10 THEN UPDATE town.street_object_editing SET geom = furnish.near(geom, 4) WHERE street_object_id = standing;
      RETURN 'an object dragged';
    ELSE UPDATE town.street_object_editing o SET abscissa = random() * ST_Length(x.geom) FROM town.axis x WHERE x.axis_id = o.axis_id AND street_object_id = standing AND o.method = 'relative';
      RETURN 'an abscissa typed';
  END CASE;
EXCEPTION WHEN invalid_parameter_value THEN
  RETURN 'refused: ' || SQLERRM;
END $$;

-- A table of users' own, whose rows and objects go together.
CREATE TABLE town.shelter (street_object_id bigint PRIMARY KEY, length float8 NOT NULL DEFAULT 4, ground float8, geom geometry(Point, 2154));
INSERT INTO town.object_type (type, parent) VALUES ('shelter', 'bus_stop');
CREATE FUNCTION town.shelter_ground(s town.shelter, o town.street_object) RETURNS town.shelter LANGUAGE sql STABLE AS $$ SELECT (s.street_object_id, s.length, s.length * 1.5, s.geom)::town.shelter $$;
SELECT streetgen.specialise('town', 'shelter', 'shelter', 'town.shelter_ground(town.shelter, town.street_object)') \g /dev/null

INSERT INTO town.shelter (geom) SELECT furnish.near(ST_LineInterpolatePoint(geom, random()), 10) FROM town.axis, generate_series(1, 3);

-- One random change on either side of rows and objects, or of the street.
CREATE FUNCTION furnish.change() RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  place geometry;
  standing bigint;
BEGIN
  SELECT furnish.near(ST_LineInterpolatePoint(geom, random()), 10) INTO place FROM town.axis ORDER BY random() LIMIT 1;
  SELECT street_object_id INTO standing FROM town.shelter ORDER BY random() LIMIT 1;
  CASE floor(random() * 12)
    WHEN 0, 9, 10 THEN INSERT INTO town.shelter (geom, length) VALUES (place, 2 + 4 * random());
    WHEN 1, 11 THEN INSERT INTO town.street_object_editing (type, geom) VALUES ('shelter', place);
    WHEN 2 THEN UPDATE town.shelter SET length = 2 + 4 * random() WHERE street_object_id = standing;
    WHEN 3 THEN UPDATE town.shelter SET geom = furnish.near(geom, 5) WHERE street_object_id = standing;
    WHEN 4 THEN UPDATE town.street_object_editing SET geom = furnish.near(geom, 5) WHERE street_object_id = standing;
    WHEN 5 THEN DELETE FROM town.shelter WHERE street_object_id = standing;
    WHEN 6 THEN DELETE FROM town.street_object_editing WHERE street_object_id = standing;
    WHEN 7 THEN UPDATE town.street_object_editing SET type = CASE type WHEN 'shelter' THEN 'bus_stop' ELSE 'shelter' END WHERE street_object_id = standing;
    ELSE UPDATE town.axis SET width = 4 + 8 * random() WHERE axis_id = (SELECT axis_id FROM town.axis ORDER BY random() LIMIT 1);
  END CASE;
  RETURN 'done';
EXCEPTION WHEN invalid_parameter_value OR lock_not_available THEN
  RETURN SQLSTATE;
END $$;
CREATE VIEW furnish.out_of_step AS
  SELECT street_object_id FROM town.street_object o FULL JOIN town.shelter s USING (street_object_id)
  WHERE (o.type IS NOT DISTINCT FROM 'shelter') <> (s.street_object_id IS NOT NULL) OR s.geom::bytea IS DISTINCT FROM o.geom::bytea AND s.street_object_id IS NOT NULL OR s.ground <> s.length * 1.5;
