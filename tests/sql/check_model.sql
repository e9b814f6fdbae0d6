\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- check_model and summary: silent on a sound model, and a row for each thing that was broken.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('checked', 2154), streetgen.live('checked', false);
  INSERT INTO checked.axis (geom, width, importance)
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 80 * i, 6860000 + 80 * j), ST_MakePoint(650000 + 80 * (i + di), 6860000 + 80 * (j + dj))), 2154), 5 + (i + j) % 5, 4
    FROM generate_series(0, 3) i, generate_series(0, 3) j, (VALUES (1, 0), (0, 1)) d(di, dj);
  PERFORM streetgen.generate('checked');
END $$;
SELECT 'a sound model has no error' AS name, NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE severity = 'error') AS holds;
SELECT 'a sound model is not stale', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%' OR rule = 'not_generated');
INSERT INTO checked.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6861000,650100 6861000)');
SELECT 'a new axis is not generated', (SELECT count(*) = 1 FROM streetgen.check_model('checked') WHERE rule = 'not_generated' AND severity = 'notice');
UPDATE checked.axis SET width = 11 WHERE axis_id = 1;
SELECT 'a changed axis is stale', (SELECT array_agg(id) = '{1}' FROM streetgen.check_model('checked') WHERE rule LIKE 'stale: the axis changed%');
DO $$ BEGIN PERFORM streetgen.generate('checked'); END $$;
SELECT 'generate makes it fresh', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%' OR rule = 'not_generated');
DO $$ BEGIN UPDATE checked.axis SET lane_count = 4, width = NULL WHERE axis_id = 1; PERFORM streetgen.generate('checked'); UPDATE checked.axis SET lane_count = NULL, width = 4 WHERE axis_id = 1; END $$;
SELECT 'an axis whose number stands in another column is stale', (SELECT array_agg(id) = '{1}' FROM streetgen.check_model('checked') WHERE rule LIKE 'stale: the axis changed%');
DO $$ BEGIN UPDATE checked.axis SET width = 7 + 1e-15 WHERE axis_id = 1; PERFORM streetgen.generate('checked'); END $$;
SET extra_float_digits = 0;
SELECT 'none is stale where a session shows numbers otherwise', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%');
RESET extra_float_digits;
DELETE FROM checked.axis WHERE axis_id = 2;
SELECT 'a deleted axis is stale', EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%');
DO $$ BEGIN PERFORM streetgen.generate('checked'); PERFORM streetgen.set('checked', 'radius_minimal', '0.2'); END $$;
SELECT 'a changed setting is told', EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale: settings%');
DO $$ BEGIN PERFORM streetgen.generate('checked'); END $$;
SELECT 'generate takes the setting', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%');
UPDATE checked.section SET surface = ST_Multi(ST_Buffer(surface, 3)) WHERE edge_id = (SELECT min(edge_id) FROM checked.section);
SELECT 'an overlap is an error', EXISTS (SELECT FROM streetgen.check_model('checked') WHERE severity = 'error' AND rule LIKE 'overlap%' AND measure > 1);
DELETE FROM checked.section WHERE edge_id = (SELECT max(edge_id) FROM checked.section);
SELECT 'an edge without section is an error', EXISTS (SELECT FROM streetgen.check_model('checked') WHERE severity = 'error' AND rule LIKE 'edge without a section%');
DO $$ BEGIN PERFORM streetgen.generate('checked'); END $$;
SELECT 'generate repairs', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE severity = 'error');
SELECT 'nor is any row marked as changed by hand', NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%');
-- What an owner changes or deletes among what was computed is told, table by table, and repaired.
CREATE FUNCTION pg_temp.told_by_hand(statement text) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  told boolean;
BEGIN
  EXECUTE statement;
  SELECT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE '%changed by hand%' AND geom IS NOT NULL) INTO told;
  PERFORM streetgen.generate('checked');
  RETURN told AND NOT EXISTS (SELECT FROM streetgen.check_model('checked') WHERE rule LIKE 'stale%' OR severity = 'error');
END $$;
UPDATE checked.axis SET turn_forward = 'through', turn_backward = 'through';
DO $$ BEGIN PERFORM streetgen.generate('checked'); END $$;
CREATE TABLE whole AS SELECT content FROM test.content('checked');
SELECT 'a change by hand is told and repaired: ' || statement, pg_temp.told_by_hand(statement) FROM (VALUES
  ('UPDATE checked.section SET surface = ST_Multi(ST_Buffer(surface, -0.1)) WHERE edge_id = (SELECT min(edge_id) FROM checked.section)'),
  ('UPDATE checked.intersection SET method = ''contested'' WHERE node_id = (SELECT min(node_id) FROM checked.intersection)'),
  ('UPDATE checked.corner SET radius = 1 WHERE corner_id = (SELECT min(corner_id) FROM checked.corner)'),
  ('UPDATE checked.node SET geom = ST_Translate(geom, 0.01, 0) WHERE node_id = (SELECT min(node_id) FROM checked.node)'),
  ('UPDATE checked.edge SET width = 3 WHERE edge_id = (SELECT min(edge_id) FROM checked.edge)'),
  ('UPDATE checked.section_limit SET abscissa = abscissa + 0.01 WHERE edge_id = (SELECT min(edge_id) FROM checked.edge)'),
  ('UPDATE checked.lane SET kind = ''bus'' WHERE lane_id = (SELECT max(lane_id) FROM checked.lane)'),
  ('DELETE FROM checked.lane WHERE lane_id = (SELECT max(lane_id) FROM checked.lane)'),
  ('DELETE FROM checked.corner WHERE corner_id = (SELECT max(corner_id) FROM checked.corner)'),
  ('DELETE FROM checked.interconnection WHERE interconnection_id = (SELECT max(interconnection_id) FROM checked.interconnection)'),
  ('DELETE FROM checked.marking WHERE marking_id = (SELECT max(marking_id) FROM checked.marking)'),
  ('DELETE FROM checked.lane_separator WHERE lane_separator_id = (SELECT max(lane_separator_id) FROM checked.lane_separator)'),
  ('DELETE FROM checked.section_limit WHERE edge_id = (SELECT max(edge_id) FROM checked.edge)'),
  ('TRUNCATE checked.marking')) s(statement);
SELECT 'nothing of it is left', NOT EXISTS ((SELECT content FROM whole EXCEPT ALL SELECT content FROM test.content('checked')) UNION ALL (SELECT content FROM test.content('checked') EXCEPT ALL SELECT content FROM whole));
-- So of each table of each subject: the edges that its rows belong to are said in columns that it has.
SELECT streetgen.create_model('every', 2154, subjects => '{all}') \g /dev/null
INSERT INTO every.axis (geom, width, level) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 0), ('SRID=2154;LINESTRING(650050 6859950, 650050 6860050)', 7, 1);
CREATE FUNCTION pg_temp.belongs(marked name, edges text) RETURNS boolean LANGUAGE plpgsql SET search_path = every, public, pg_catalog AS $$
DECLARE
  counted bigint;
BEGIN
  EXECUTE format('SELECT count(*) FROM edge e, (SELECT NULL::%I) r(old) WHERE %s', marked, replace(edges, '$1', 'old')) INTO counted;
  RETURN counted IN (0, 2);
END $$;
SELECT 'rows of every table belong to edges', count(*) = 38 AND bool_and(pg_temp.belongs(relname,
    encode(substring(tgargs FOR octet_length(tgargs) - 1), 'escape')))
  FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = 'every'::regnamespace AND tgname = 'by_hand' AND relname NOT IN ('axis', 'axis_class');
UPDATE every.overpass SET clearance = 1;
SELECT 'an overpass changed by hand is told at both its edges', count(*) = 2 FROM every.edge WHERE input_hash = streetgen._changed_by_hand();
SELECT streetgen.drop_model('every') \g /dev/null
UPDATE checked.axis SET kind = CASE axis_id WHEN 3 THEN 'primary' WHEN 4 THEN 'primay' END WHERE axis_id IN (3, 4);
SELECT 'a kind that is no class is told', array_agg(id) = '{4}' FROM streetgen.check_model('checked') WHERE rule LIKE 'kind that is no class%';
SELECT 'the summary counts the axes', EXISTS (SELECT FROM streetgen.summary('checked') WHERE subject = 'axes' AND amount = (SELECT count(*) FROM checked.axis));
SELECT 'the summary sums the roadway', EXISTS (SELECT FROM streetgen.summary('checked') WHERE subject = 'roadway' AND amount > 1000);
SELECT streetgen.create_model('empty', 2154) \g /dev/null
SELECT 'of an empty model each sum is 0', count(*) > 5 AND bool_and(amount IS NOT DISTINCT FROM 0) FROM streetgen.summary('empty');
SELECT streetgen.drop_model('empty') \g /dev/null

-- Of two streets that cross the more important one has the ground; it is not made yet.
SELECT streetgen.create_model('part', 2154), streetgen.live('part', false) \g /dev/null
INSERT INTO part.axis (axis_id, geom, width, importance) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 6, 5), (2, 'SRID=2154;LINESTRING(650050 6859950,650050 6860050)', 8, 3);
SELECT streetgen.generate('part', '{1}') \g /dev/null
SELECT 'ground left to a street that is not made yet is no error', contested_area > 1 AND NOT EXISTS (SELECT FROM streetgen.check_model('part') WHERE severity = 'error') FROM part.section;
UPDATE part.section SET surface = ST_Multi(ST_Difference(surface, ST_MakeEnvelope(650010, 6859990, 650012, 6860010, 2154)));
SELECT 'a gap beside it is one', array_agg(round(measure)) = '{2}' FROM streetgen.check_model('part') WHERE rule LIKE 'edge outside%';

-- What was found stays in the model, for a GIS.
SELECT streetgen.record_check('part') AS recorded \gset
SELECT 'a check is recorded row by row', :recorded = count(*) AND count(*) = (SELECT count(*) FROM streetgen.check_model('part') f JOIN part.check_result r ON (r.rule, r.severity, r.relation, r.measure) = (f.rule, f.severity, f.relation, f.measure) AND r.id IS NOT DISTINCT FROM f.id) AND count(*) FILTER (WHERE severity = 'error') = 1 FROM part.check_result;
SELECT 'with the way out and a point on what was found', hint = 'look at the widths around the edge' AND ST_Intersects(place, ST_MakeEnvelope(650010, 6859990, 650012, 6860010, 2154)) AND ST_SRID(place) = 2154 FROM part.check_result WHERE rule LIKE 'edge outside%';
-- The command shows the worst first: the narrowest lane, where it is the widest of other rules.
SELECT streetgen.create_model('narrow', 2154, subjects => '{lane}') \g /dev/null
INSERT INTO narrow.axis (geom, width, lane_count) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000 + 50 * i), ST_MakePoint(650100, 6860000 + 50 * i)), 2154), 4.6 - 0.2 * i, 2 FROM generate_series(1, 8) i;
\setenv PGDATABASE :DBNAME
\! psql -qXAt -v model=narrow -v errors=/dev/null -f ../../data/check.sql | grep -qE '^notice[|]narrow lane, m[|]lane[|]10[|]1.5[|]15, 16, 13, 14, 11, …[|]' && holds=t || holds=f; printf 'the worst of many findings stands first\t%s\n' $holds
SELECT streetgen.drop_model('narrow') \g /dev/null
SELECT 'each rule and issue has a way out', count(*) > 100 AND bool_and(hint <> '' AND meaning <> '') FROM streetgen.check_rule;
SELECT streetgen.generate('part', wait => true), streetgen.record_check('part') \g /dev/null
SELECT 'the next check takes the place of the one before', NOT EXISTS (SELECT FROM part.check_result WHERE severity = 'error') AND count(*) = (SELECT count(*) FROM streetgen.check_model('part')) FROM part.check_result;
SELECT 'a flag of what has no place stands nowhere', streetgen._flag_place('POLYGON EMPTY') IS NULL AND streetgen._flag_place(NULL) IS NULL;
SELECT 'of a curve it stands on it', ST_AsText(streetgen._flag_place('CIRCULARSTRING(0 0, 1 1, 2 0)'), 3) LIKE 'POINT(%' AND ST_AsText(streetgen._flag_place('POINT Z (1 2 3)')) = 'POINT(1 2)';
