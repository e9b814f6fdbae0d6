-- Overrides: what a user decides stays, changes what it says and nothing else.  Each SELECT is one truth: (name, holds).
SET client_min_messages = warning;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 32631);
  INSERT INTO town.axis (axis_id, geom, width) VALUES (1, 'SRID=32631;LINESTRING(0 0,100 0)', 8);
END $$;

-- Places are filled where they are left out.
INSERT INTO town.section_limit_override (axis_id, abscissa, which) VALUES (1, 30, 'start'), (1, 130, 'start'), (77, 1, 'end');
SELECT 'the place of a limit is that of its abscissa, none beyond the axis or without one' AS name, array_agg(ST_AsText(geom) ORDER BY section_limit_override_id) IS NOT DISTINCT FROM '{POINT(30 0),NULL,NULL}' AS holds FROM town.section_limit_override;
UPDATE town.section_limit_override SET abscissa = 40 WHERE abscissa = 130;
SELECT 'it follows the abscissa', EXISTS (SELECT FROM town.section_limit_override WHERE geom = 'SRID=32631;POINT(40 0)'::geometry);
UPDATE town.section_limit_override SET abscissa = 50, geom = 'SRID=32631;POINT(7 7)' WHERE abscissa = 40;
SELECT 'one that is given stays', EXISTS (SELECT FROM town.section_limit_override WHERE geom = 'SRID=32631;POINT(7 7)'::geometry);
INSERT INTO town.transition_override (axis_id, which, length) VALUES (1, 'start', 9), (1, 'end', 9);
SELECT 'the place of a transition is that end of the axis', array_agg(ST_AsText(geom) ORDER BY which) = '{POINT(100 0),POINT(0 0)}' FROM town.transition_override;
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (1, 100, 1, 3);
SELECT 'the place of a lane is that of its abscissa', ST_AsText(geom) = 'POINT(100 0)' FROM town.lane_override;
INSERT INTO town.kerb_point_override (axis_id, geom) VALUES (1, 'SRID=32631;POINT(25 5)'), (77, 'SRID=32631;POINT(25 5)');
SELECT 'the width of a kerb point is twice its distance from the axis', (abscissa, width) = (25, 10) FROM town.kerb_point_override WHERE axis_id = 1;
SELECT 'none without the axis', num_nulls(abscissa, width) = 2 FROM town.kerb_point_override WHERE axis_id = 77;
UPDATE town.kerb_point_override SET geom = 'SRID=32631;POINT(60 -7)' WHERE axis_id = 1;
SELECT 'it follows the point', (abscissa, width) = (60, 14) FROM town.kerb_point_override WHERE axis_id = 1;

-- What no table takes.
SELECT 'refused: ' || row, test.state('INSERT INTO town.' || row) = '23514' FROM unnest(ARRAY[
  'section_limit_override (axis_id, abscissa, which) VALUES (1, ''NaN'', ''start'')', 'section_limit_override (axis_id, abscissa, which) VALUES (1, -1, ''start'')',
  'section_limit_override (axis_id, abscissa, which) VALUES (1, 1, ''middle'')', 'section_limit_override (axis_id, abscissa, which, geom) VALUES (1, 1, ''start'', ''SRID=32631;POINT EMPTY'')',
  'section_limit_override (axis_id, abscissa, which, geom) VALUES (1, 1, ''start'', ST_SetSRID(ST_MakePoint(''Infinity'', 0), 32631))',
  'corner_override (geom, axis_a, axis_b, radius) VALUES (''SRID=32631;POINT(0 0)'', 1, 2, ''NaN'')', 'corner_override (geom, axis_a, axis_b, radius) VALUES (''SRID=32631;POINT(0 0)'', 1, 2, 201)',
  'corner_override (geom, axis_a, axis_b, radius) VALUES (''SRID=32631;POINT(0 0)'', 1, 2, -1)', 'corner_override (geom, axis_a, axis_b, radius) VALUES (''SRID=32631;POINT(NaN 1)'', 1, 2, 1)',
  'kerb_point_override (axis_id, geom) VALUES (1, ''SRID=32631;POINT(10 0)'')', 'kerb_point_override (axis_id, geom) VALUES (1, ''SRID=32631;POINT(10 101)'')',
  'kerb_point_override (axis_id, geom, width) VALUES (1, ''SRID=32631;POINT(10 5)'', ''NaN'')', 'kerb_point_override (axis_id, geom, abscissa) VALUES (1, ''SRID=32631;POINT(10 5)'', ''Infinity'')',
  'lane_override (axis_id, abscissa, ordinality, line) VALUES (1, 1, 1, ''SRID=32631;LINESTRING EMPTY'')', 'lane_override (axis_id, abscissa, ordinality, line) VALUES (1, 1, 1, ''SRID=32631;LINESTRING(0 0,NaN 5)'')',
  'lane_override (axis_id, abscissa, ordinality, line) VALUES (1, 1, 1, ''SRID=32631;LINESTRING(0 0,0 0)'')', 'lane_override (axis_id, abscissa, ordinality, line) VALUES (1, 1, 1, ''SRID=32631;LINESTRING(0 0,1e13 0)'')',
  'lane_override (axis_id, abscissa, ordinality, geom) VALUES (1, 1, 1, ''SRID=32631;POINT EMPTY'')', 'transition_override (axis_id, which, geom) VALUES (5, ''end'', ''SRID=32631;POINT EMPTY'')']) row;
SELECT 'another SRID is refused', test.state('INSERT INTO town.corner_override (geom, axis_a, axis_b, radius) VALUES (''SRID=2154;POINT(0 0)'', 1, 2, 3)') = '22023';

-- A model from before these tables gets them, with the rights of its editors.
DO $$ BEGIN
  PERFORM streetgen.create_model('older', 32631);
  CREATE ROLE streetgen_test_decider;
  PERFORM streetgen."grant"('older', 'streetgen_test_decider', 'editor');
  DROP TABLE older.section_limit_override, older.corner_override, older.kerb_point_override;
  ALTER TABLE older.lane_override DROP COLUMN line, DROP COLUMN geom;
  ALTER TABLE older.transition_override DROP COLUMN geom;
  PERFORM streetgen.adopt_model('older') FROM generate_series(1, 2);
  PERFORM streetgen.generate('older');
END $$;
SELECT 'an older model has the same columns and checks', NOT EXISTS (
  SELECT FROM (SELECT relname, attname, format_type(atttypid, atttypmod) AS type, col_description(attrelid, attnum) AS text, relnamespace FROM pg_attribute JOIN pg_class c ON c.oid = attrelid WHERE relname LIKE '%override' AND attnum > 0 AND NOT attisdropped) t
  GROUP BY relname, attname, type, text HAVING count(*) FILTER (WHERE relnamespace IN ('town'::regnamespace, 'older'::regnamespace)) <> 2)
  AND (SELECT count(*) FILTER (WHERE connamespace = 'town'::regnamespace) = count(*) FILTER (WHERE connamespace = 'older'::regnamespace) FROM pg_constraint WHERE contype = 'c');
SELECT 'its editors may decide', bool_and(has_table_privilege('streetgen_test_decider', 'older.' || relation, 'SELECT') AND has_table_privilege('streetgen_test_decider', 'older.' || relation, 'INSERT'))
  FROM unnest('{transition_override,lane_override,section_limit_override,corner_override,kerb_point_override}'::name[]) relation;
DO $$ BEGIN PERFORM streetgen.drop_model('older'); DROP ROLE streetgen_test_decider; END $$;
