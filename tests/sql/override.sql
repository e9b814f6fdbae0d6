\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Overrides: what a user decides stays, changes what it says and nothing else.  Each SELECT is one truth: (name, holds).
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
SELECT 'the width of a kerb point is twice its distance from the axis', abs(abscissa - 25) < 1e-9 AND abs(width - 10) < 1e-9 FROM town.kerb_point_override WHERE axis_id = 1;
SELECT 'none without the axis', num_nulls(abscissa, width) = 2 FROM town.kerb_point_override WHERE axis_id = 77;
UPDATE town.kerb_point_override SET geom = 'SRID=32631;POINT(60 -7)' WHERE axis_id = 1;
SELECT 'it follows the point', abs(abscissa - 60) < 1e-9 AND abs(width - 14) < 1e-9 FROM town.kerb_point_override WHERE axis_id = 1;

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
  CREATE ROLE streetgen_test_decider ROLE CURRENT_USER;
  PERFORM streetgen."grant"('older', 'streetgen_test_decider', 'editor');
  DROP TABLE older.section_limit_override, older.corner_override, older.kerb_point_override CASCADE;
  ALTER TABLE older.lane_override DROP COLUMN line CASCADE, DROP COLUMN geom CASCADE;
  ALTER TABLE older.transition_override DROP COLUMN geom CASCADE;
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
DO $$ BEGIN PERFORM streetgen.drop_model('town'); END $$;

-- What each changes: a crossing at (100 0), a T at (200 0), a street far away; the streets follow each statement.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 32631);
  INSERT INTO town.axis (axis_id, geom, width, lane_count, radius) VALUES (1, 'SRID=32631;LINESTRING(0 0,100 0)', 8, 2, 5), (2, 'SRID=32631;LINESTRING(100 0,200 0)', 8, 2, 5), (3, 'SRID=32631;LINESTRING(100 -80,100 0)', 8, 2, 5),
    (4, 'SRID=32631;LINESTRING(100 0,100 80)', 8, 2, 5), (5, 'SRID=32631;LINESTRING(200 -50,200 0,200 50)', 6, 2, 5), (6, 'SRID=32631;LINESTRING(1000 0,1100 0)', 6, 2, 5);
END $$;
-- The same inputs, computed whole.
CREATE FUNCTION pg_temp.is_whole(model name) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  relation name;
  equal boolean;
BEGIN
  PERFORM streetgen.create_model('whole', 32631);
  FOREACH relation IN ARRAY ARRAY['axis', 'transition_override', 'lane_override', 'section_limit_override', 'corner_override', 'kerb_point_override'] LOOP
    PERFORM streetgen._pause();
    EXECUTE format('INSERT INTO whole.%2$I SELECT * FROM %1$I.%2$I', model, relation);
  END LOOP;
  PERFORM streetgen.generate('whole');
  PERFORM set_config('streetgen.live', '', true);
  equal := test.same(model, 'whole');
  PERFORM streetgen.drop_model('whole');
  RETURN equal;
END $$;
-- An override as a row of its table, what it says, and the content it may change.
CREATE FUNCTION pg_temp.decided(title text, relation name, fields text, given text, says text, may_change text) RETURNS TABLE (name text, holds boolean) LANGUAGE plpgsql AS $$
DECLARE
  before text[] := ARRAY(SELECT content FROM test.content('town'));
  differs text[];
  -- What further subjects make of the streets, where the model computes them.
  others constant text := '^(kerb|sidewalk|block|road|junction|roundabout|ramp|overpass|profile|controller|signal|object|bridge|tunnel)';
BEGIN
  EXECUTE format('INSERT INTO town.%I (%s) VALUES (%s)', relation, fields, given);
  name := title || ': it holds';
  EXECUTE 'SELECT ' || says INTO holds;
  RETURN NEXT;
  differs := ARRAY((SELECT content FROM test.content('town') EXCEPT ALL SELECT unnest(before)) UNION ALL (SELECT unnest(before) EXCEPT ALL SELECT content FROM test.content('town')));
  RETURN QUERY SELECT title || ': nothing else changes', cardinality(differs) > 0 AND bool_and(d ~ may_change OR d ~ others) FROM unnest(differs) d;
  RETURN QUERY SELECT title || ': it equals the model computed whole', pg_temp.is_whole('town');
  RETURN QUERY SELECT title || ': it survives generate', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');
  RETURN QUERY SELECT title || ': the model is sound', count(*) = 0 FROM streetgen.check_model('town') WHERE severity <> 'notice';
  EXECUTE format('DELETE FROM town.%I', relation);
  RETURN QUERY SELECT title || ': it goes with its row', NOT EXISTS ((SELECT content FROM test.content('town') EXCEPT ALL SELECT unnest(before)) UNION ALL (SELECT unnest(before) EXCEPT ALL SELECT content FROM test.content('town')));
END $$;
CREATE FUNCTION pg_temp.at(x float8) RETURNS text LANGUAGE sql AS $$ SELECT '(intersection|interconnection) ' || ST_SetSRID(ST_MakePoint(x, 0), 32631)::text $$;
SELECT * FROM pg_temp.decided('a limit', 'section_limit_override', 'axis_id, abscissa, which', '1, 70, ''end''',
  '(l.method, l.abscissa, ST_AsText(l.geom)) = (''by_hand'', 70, ''POINT(70 0)'') AND ST_Area(s.surface) = 560 FROM town.section_limit l JOIN town.edge USING (edge_id) JOIN town.section s USING (edge_id) WHERE axis_id = 1 AND which = ''end''',
  '^((limit|section|lane|separator|marking) 1 |' || pg_temp.at(100) || ')');
SELECT * FROM pg_temp.decided('a limit beyond the other', 'section_limit_override', 'axis_id, abscissa, which', '2, 96, ''start''',
  'array_agg(l.method || l.abscissa ORDER BY which DESC) = ''{by_hand96,crossed_limits96}'' FROM town.section_limit l JOIN town.edge USING (edge_id) WHERE axis_id = 2',
  '^((limit|section|lane|separator|marking) 2 |' || pg_temp.at(100) || '|' || pg_temp.at(200) || ')');
SELECT * FROM pg_temp.decided('a radius', 'corner_override', 'geom, axis_a, axis_b, radius', '''SRID=32631;POINT(100.5 0.5)'', 2, 4, 9',
  '(c.method, c.radius, c.radius_wanted, ST_AsText(c.centre, 6)) = (''by_hand'', 9, 9, ''POINT(113 13)'') FROM town.corner c JOIN town.edge ON edge_id = edge_a JOIN town.node USING (node_id) WHERE axis_id = 2 AND ST_X(node.geom) = 100',
  '^((limit|section|lane|separator|marking) [24] |corner 2 0 start 4 |' || pg_temp.at(100) || ')');
SELECT * FROM pg_temp.decided('no radius', 'corner_override', 'geom, axis_a, axis_b, radius', '''SRID=32631;POINT(100 0)'', 2, 4, 0',
  '(c.method, c.radius) = (''by_hand'', 0) AND c.arc IS NULL FROM town.corner c JOIN town.edge ON edge_id = edge_a JOIN town.node USING (node_id) WHERE axis_id = 2 AND ST_X(node.geom) = 100',
  '^((limit|section|lane|separator|marking) [24] |corner 2 0 start 4 |' || pg_temp.at(100) || ')');
SELECT * FROM pg_temp.decided('a kerb point', 'kerb_point_override', 'axis_id, geom', '1, ''SRID=32631;POINT(50 5)''',
  '(width, width_end) = (10, 10) FROM town.edge WHERE axis_id = 1',
  '^((edge|limit|section|lane|separator|marking) 1 |(limit|section|lane|separator|marking) [34] |corner (1 0 end 3|4 0 start 1) |' || pg_temp.at(100) || ')');
SELECT * FROM pg_temp.decided('a lane', 'lane_override', 'axis_id, abscissa, ordinality, line', '1, 50, 2, ''SRID=32631;LINESTRING(10 -2,50 -3,88 -1)''',
  'count(*) = 3 AND bool_and((l.method, ST_AsText(l.geom), l.width) = (''by_hand'', ''LINESTRING(10 -2,50 -3,88 -1)'', 4) AND ST_StartPoint(c.geom) = ST_EndPoint(l.geom)) FROM town.lane l JOIN town.edge USING (edge_id) JOIN town.interconnection c ON c.lane_in = lane_id WHERE axis_id = 1 AND ordinality = 2',
  '^((lane|marking) 1 |interconnection)');
INSERT INTO town.kerb_point_override (axis_id, geom) VALUES (1, 'SRID=32631;POINT(50 5)'), (1, 'SRID=32631;POINT(20 -6)');
SELECT 'the width is the mean of the kerb points', (width, 'width' = ANY (estimated)) = (11, false) FROM town.edge WHERE axis_id = 1;
DELETE FROM town.kerb_point_override;
INSERT INTO town.section_limit_override (axis_id, abscissa, which) VALUES (1, 70, 'end'), (1, 60, 'end');
INSERT INTO town.corner_override (geom, axis_a, axis_b, radius) VALUES ('SRID=32631;POINT(100 0)', 2, 4, 9), ('SRID=32631;POINT(100 0)', 2, 4, 3);
SELECT 'of two limits the younger holds', abscissa = 60 FROM town.section_limit JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND which = 'end';
SELECT 'of two radii the younger holds', radius = 3 FROM town.corner JOIN town.edge ON edge_id = edge_a WHERE axis_id = 2 AND method = 'by_hand';
UPDATE town.corner_override SET radius = 4 WHERE radius = 3;
SELECT 'a radius is changed', radius = 4 FROM town.corner JOIN town.edge ON edge_id = edge_a WHERE axis_id = 2 AND method = 'by_hand';
DELETE FROM town.section_limit_override;
DELETE FROM town.corner_override;

-- Not followed, they make their axes stale; those that fit nowhere are listed and change nothing.
CREATE TABLE before AS SELECT content FROM test.content('town');
DO $$ BEGIN
  PERFORM streetgen.live('town', false);
  INSERT INTO town.section_limit_override (axis_id, abscissa, which) VALUES (1, 70, 'end');
  INSERT INTO town.corner_override (geom, axis_a, axis_b, radius) VALUES ('SRID=32631;POINT(100 0)', 2, 4, 9);
  INSERT INTO town.kerb_point_override (axis_id, geom) VALUES (5, 'SRID=32631;POINT(204 20)');
  INSERT INTO town.lane_override (axis_id, abscissa, ordinality, line) VALUES (6, 50, 2, 'SRID=32631;LINESTRING(1000 -2,1100 -2)');
END $$;
SELECT 'axes whose overrides changed are stale', array_agg(id ORDER BY id) = '{1,2,4,5,6}' FROM streetgen.check_model('town') WHERE rule = 'stale: the axis changed since';
DO $$ BEGIN
  DELETE FROM town.section_limit_override; DELETE FROM town.corner_override; DELETE FROM town.kerb_point_override; DELETE FROM town.lane_override;
  INSERT INTO town.section_limit_override VALUES (91, 1, 20, 'start'), (92, 1, 100, 'start'), (93, 77, 1, 'end'), (94, 1, 101, 'end');
  INSERT INTO town.corner_override VALUES (81, 'SRID=32631;POINT(100 0)', 1, 2, 3), (82, 'SRID=32631;POINT(100 3)', 2, 4, 3), (83, 'SRID=32631;POINT(200 0)', 2, 77, 3);
  INSERT INTO town.kerb_point_override VALUES (71, 77, 'SRID=32631;POINT(100 0)', NULL, NULL);
  INSERT INTO town.lane_override (lane_override_id, axis_id, abscissa, ordinality, line) VALUES (61, 1, 50, 9, 'SRID=32631;LINESTRING(0 0,1 1)'), (62, 1, 100, 1, NULL);
  PERFORM streetgen.generate('town', wait => true);
END $$;
SELECT 'overrides that fit nowhere are one row each', array_agg(id ORDER BY id) = '{61,62,71,81,82,83,91,92,93,94}' AND bool_and(severity = 'warning') FROM streetgen.check_model('town') WHERE relation LIKE '%override';
SELECT 'they change nothing', NOT EXISTS ((SELECT content FROM test.content('town') EXCEPT ALL SELECT content FROM before) UNION ALL (SELECT content FROM before EXCEPT ALL SELECT content FROM test.content('town')));

-- A crooked town, decided upon at random, statement by statement.
DO $$
DECLARE
  edge record;
BEGIN
  PERFORM streetgen.create_model('crooked', 32631), setseed(0.2);
  PERFORM streetgen._pause();
  INSERT INTO crooked.axis (geom, width, lane_count, radius)
    SELECT ST_SetSRID(ST_MakeLine(ARRAY(SELECT p[i]::geometry FROM generate_subscripts(p, 1) i)), 32631), 4 + random() * 8, 2, random() * 9
    FROM (SELECT x, y, ST_MakePoint(70 * x + 12 * sin(7 * x + 3 * y), 60 * y + 12 * cos(5 * x * y)) AS place FROM generate_series(0, 3) x, generate_series(0, 3) y) a
    JOIN LATERAL (SELECT ARRAY[a.place, ST_MakePoint(70 * u + 12 * sin(7 * u + 3 * v), 60 * v + 12 * cos(5 * u * v))] AS p FROM (VALUES (x + 1, y), (x, y + 1)) n(u, v) WHERE u <= 3 AND v <= 3) b ON true;
  PERFORM streetgen.generate('crooked');
  PERFORM set_config('streetgen.live', '', true);
  FOR edge IN SELECT e.axis_id, end_abscissa AS length, a.geom, from_node, to_node FROM crooked.edge e JOIN crooked.axis a USING (axis_id) ORDER BY axis_id LOOP
    CASE edge.axis_id % 4
      WHEN 0 THEN INSERT INTO crooked.section_limit_override (axis_id, abscissa, which) SELECT edge.axis_id, random() * edge.length, w FROM unnest('{start,end}'::text[]) w;
      WHEN 1 THEN INSERT INTO crooked.corner_override (geom, axis_a, axis_b, radius)
          SELECT n.geom, a.axis_id, b.axis_id, random() * 20 FROM crooked.corner c JOIN crooked.node n USING (node_id) JOIN crooked.edge a ON a.edge_id = edge_a JOIN crooked.edge b ON b.edge_id = edge_b WHERE edge.axis_id IN (a.axis_id, b.axis_id);
      WHEN 2 THEN INSERT INTO crooked.kerb_point_override (axis_id, geom) VALUES (edge.axis_id, ST_EndPoint(ST_OffsetCurve(edge.geom, 3 + 3 * random())));
      ELSE INSERT INTO crooked.lane_override (axis_id, abscissa, ordinality, line) VALUES (edge.axis_id, edge.length / 2, 1 + edge.axis_id % 2, ST_Force2D(ST_OffsetCurve(ST_LineSubstring(edge.geom, 0.2, 0.8), 1 + random())));
    END CASE;
  END LOOP;
  DELETE FROM crooked.corner_override WHERE corner_override_id % 3 = 0;
  UPDATE crooked.section_limit_override SET abscissa = abscissa / 2 WHERE which = 'start';
END $$;
SELECT 'decided upon at random, ' || relation, count(*) FILTER (WHERE method = 'by_hand') >= 5 FROM (SELECT 'limits' AS relation, method FROM crooked.section_limit UNION ALL SELECT 'corners', method FROM crooked.corner UNION ALL SELECT 'lanes', method FROM crooked.lane) m GROUP BY relation;
SELECT 'a town decided upon at random equals the one computed whole', pg_temp.is_whole('crooked');
SELECT 'it has no error', count(*) = 0 FROM streetgen.check_model('crooked') WHERE severity = 'error';
DO $$ BEGIN DELETE FROM crooked.section_limit_override; DELETE FROM crooked.corner_override; DELETE FROM crooked.kerb_point_override; DELETE FROM crooked.lane_override; END $$;
SELECT 'without its overrides it equals the one never decided upon', pg_temp.is_whole('crooked') AND NOT EXISTS (SELECT FROM crooked.lane WHERE method = 'by_hand');

-- A limit far from its node: what happens there and at both ends of the edge is followed.
DO $$ BEGIN
  PERFORM streetgen.create_model('far', 32631);
  INSERT INTO far.axis (axis_id, geom, width, radius) VALUES (1, 'SRID=32631;LINESTRING(0 0,500 0)', 8, 5), (2, 'SRID=32631;LINESTRING(0 -80,0 0)', 8, 5), (3, 'SRID=32631;LINESTRING(0 0,-10 80)', 8, 5),
    (4, 'SRID=32631;LINESTRING(350 30,420 6,470 30)', 6, 5), (5, 'SRID=32631;LINESTRING(500 0,560 40)', 8, 5), (6, 'SRID=32631;LINESTRING(500 0,560 -40)', 8, 5), (7, 'SRID=32631;LINESTRING(-300 0,0 0)', 8, 5);
  -- It crosses the first without a node, more important than the intersection there until the last one is.
  INSERT INTO far.axis (axis_id, geom, width, importance) VALUES (8, 'SRID=32631;LINESTRING(250 -60,250 60)', 8, 3);
  INSERT INTO far.section_limit_override (axis_id, abscissa, which) VALUES (1, 440, 'start');
END $$;
CREATE FUNCTION pg_temp.is_followed(statement text) RETURNS TABLE (name text, holds boolean) LANGUAGE plpgsql AS $$ BEGIN EXECUTE statement; RETURN QUERY SELECT 'followed: ' || statement, pg_temp.is_whole('far'); END $$;
SELECT f.* FROM unnest(ARRAY['UPDATE far.axis SET width = 12 WHERE axis_id = 4', 'UPDATE far.axis SET importance = 1 WHERE axis_id = 7', 'UPDATE far.axis SET width = 11 WHERE axis_id = 2',
  'UPDATE far.section_limit_override SET abscissa = 495', 'UPDATE far.axis SET width = 10 WHERE axis_id = 5', 'DELETE FROM far.section_limit_override']) s, pg_temp.is_followed(s) f;

-- Streets that go on beyond their crossing make two corners of one name: the edit view decides upon one of them.
DO $$ BEGIN
  PERFORM streetgen.create_model('through', 32631);
  INSERT INTO through.axis (axis_id, geom, width, radius) VALUES (1, 'SRID=32631;LINESTRING(0 0,100 0,200 0)', 8, 5), (2, 'SRID=32631;LINESTRING(100 -80,100 0,100 80)', 8, 5);
END $$;
CREATE VIEW quarter AS SELECT e.*, round(degrees(ST_Azimuth(n.geom, e.geom))) AS azimuth FROM through.corner_editing e JOIN through.node n USING (node_id);
UPDATE through.corner_editing SET radius = 9 WHERE corner_id = (SELECT corner_id FROM quarter WHERE azimuth = 45);
SELECT 'of two corners of one name one is changed', array_agg(azimuth || ' ' || radius || ' ' || by_hand ORDER BY azimuth) = '{"45 9 true","135 5 false","225 5 false","315 5 false"}' FROM quarter;
UPDATE through.corner_editing SET radius = 7 WHERE corner_id = (SELECT corner_id FROM quarter WHERE azimuth = 225);
UPDATE through.corner_editing SET radius = 8 WHERE corner_id = (SELECT corner_id FROM quarter WHERE azimuth = 225);
SELECT 'and the other', array_agg(radius ORDER BY azimuth) = '{9,5,8,5}' AND (SELECT count(*) = 2 FROM through.corner_override) FROM quarter;
UPDATE through.axis SET geom = ST_SetPoint(geom, 1, 'SRID=32631;POINT(100 6)');
SELECT 'both come along with their node', array_agg(radius ORDER BY azimuth) = '{9,5,8,5}' FROM quarter;
UPDATE through.axis SET geom = ST_SetPoint(geom, 1, 'SRID=32631;POINT(100 0)');
DELETE FROM through.corner_editing WHERE corner_id = (SELECT corner_id FROM quarter WHERE azimuth = 45);
SELECT 'one is taken back', array_agg(radius ORDER BY azimuth) = '{5,5,8,5}' FROM quarter;

-- Of three dimensions: places stay flat, results get the height of the axis.
DO $$ BEGIN
  PERFORM streetgen.create_model('high', 32631, 3);
  INSERT INTO high.axis (axis_id, geom, width) VALUES (1, 'SRID=32631;LINESTRINGZ(0 0 7,100 0 7)', 8), (2, 'SRID=32631;LINESTRINGZ(100 -80 7,100 0 7)', 8), (3, 'SRID=32631;LINESTRINGZ(100 0 7,100 80 7)', 8);
  INSERT INTO high.section_limit_override (axis_id, abscissa, which) VALUES (1, 70, 'end');
END $$;
SELECT 'a limit in three dimensions', ST_AsText(geom) = 'POINT Z (70 0 7)' FROM high.section_limit WHERE method = 'by_hand';
DROP VIEW quarter;
DO $$ BEGIN PERFORM streetgen.drop_model(m) FROM unnest('{town,crooked,high,through,far}'::name[]) m; END $$;
