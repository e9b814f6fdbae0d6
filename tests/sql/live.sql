\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Live: streets follow each statement on axes and overrides.  Each test is a row (name, holds).
SELECT streetgen.create_model('town', 2154), streetgen.create_model('once', 2154) \g /dev/null

-- A grid of 5 by 4 crossings, 90 m wide and not quite straight: farther across than any edit reaches.
CREATE VIEW grid AS
WITH place AS (SELECT x, y, ST_SetSRID(ST_Point(650000 + 90 * x + (x * 7 + y * 5) % 11, 6860000 + 90 * y + (x * 3 + y * 7) % 13), 2154) AS geom FROM generate_series(0, 4) x, generate_series(0, 3) y)
SELECT row_number() OVER (ORDER BY a.x, a.y, b.x) AS axis_id, ST_MakeLine(a.geom, b.geom) AS geom, 6 + (a.x + 2 * a.y) % 5 AS width, 2 + (a.x + a.y) % 4 AS importance
FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1));

-- Every derived row, with its writer, its place in the table, what it says and where it lies.
CREATE FUNCTION public.derived() RETURNS TABLE (relation name, id text, written xid, at tid, content text, geom geometry) LANGUAGE plpgsql AS $$
DECLARE
  r record;
BEGIN
  FOR r IN SELECT * FROM (VALUES ('node', 'node_id', 'geom'), ('edge', 'edge_id', 'geom'), ('section_limit', 'section_limit_id', 'geom'), ('section', 'edge_id', 'surface'), ('corner', 'corner_id', 'arc'),
    ('intersection', 'node_id', 'surface'), ('lane', 'lane_id', 'geom'), ('lane_separator', 'lane_separator_id', 'geom'), ('marking', 'marking_id', 'geom'), ('interconnection', 'interconnection_id', 'geom'),
    ('report', 'axis_a', 'geom')) v(name, key, place) LOOP
    RETURN QUERY EXECUTE format('SELECT %L::name, %I::text, xmin, ctid, t::text, %I FROM town.%1$I t', r.name, r.key, r.place);
  END LOOP;
END $$;
CREATE TABLE before AS SELECT * FROM derived();
CREATE FUNCTION pg_temp.remember() RETURNS void LANGUAGE sql AS $$ TRUNCATE before; INSERT INTO before SELECT * FROM derived() $$;
-- Rows that came, went or were written since.
CREATE VIEW written AS
SELECT relation, id, b.content AS was, d.content, coalesce(d.geom, b.geom) AS geom FROM before b FULL JOIN derived() d USING (relation, id) WHERE (b.written, b.at) IS DISTINCT FROM (d.written, d.at);

INSERT INTO town.axis (axis_id, geom, width, importance) SELECT * FROM grid;
SELECT 'axes that are inserted have streets', count(*) = 31 FROM town.section;
SELECT 'as one run gives them', test.followed('town', 'once');
SELECT 'generate finds nothing to do', bool_and(inserted + updated + deleted + skipped = 0) FROM streetgen.generate('town');

-- Columns, one by one, at axis 16 in the middle.
CREATE TABLE said (name text, wrote boolean, holds boolean);
DO $$
DECLARE
  change text;
BEGIN
  FOREACH change IN ARRAY ARRAY['width = 11', 'width_end = 14', 'lane_count = 3', $q$direction = 'direct'$q$, $q$direction = 'reverse'$q$, 'speed = 90', 'importance = 1', 'level = 1', $q$kind = 'primary'$q$, 'radius = 3',
      'lanes_forward = 2', 'lanes_backward = 1', 'lanes_both = 1', 'lane_count = 1', $q$kind_forward = 'general|cycle'$q$, $q$kind_backward = 'bus'$q$, $q$lane_width_forward = '3|1.5'$q$, $q$lane_width_backward = '4'$q$, $q$turn_forward = 'left|through'$q$,
      $q$turn_backward = 'right'$q$, $q$access = 'cycle|no'$q$, 'access = NULL', 'geom = ST_Reverse(geom)', 'geom = ST_SetPoint(geom, 0, ST_Translate(ST_StartPoint(geom), 20, 10))', 'width = NULL', 'level = 0'] LOOP
    PERFORM pg_temp.remember();
    EXECUTE format('UPDATE town.axis SET %s WHERE axis_id = 16', change);
    INSERT INTO said SELECT change, EXISTS (SELECT FROM written), test.followed('town', 'once');
  END LOOP;
END $$;
SELECT format('after %s the streets follow', name), wrote AND holds FROM said;

-- What is written: where the edit is, and only what is another.
SELECT pg_temp.remember() \g /dev/null
UPDATE town.axis SET width = 9 WHERE axis_id = 1;
SELECT 'an edit writes rows', count(*) > 5 FROM written;
SELECT 'it writes no row that stays the same', count(*) = 0 FROM written WHERE was = content;
SELECT 'rows beyond its reach keep xmin and ctid', max(ST_Distance(w.geom, a.geom)) < 100 AND (SELECT max(ST_Distance(d.geom, a.geom)) > 300 FROM derived() d) FROM written w, town.axis a WHERE axis_id = 1 GROUP BY a.geom;
SELECT pg_temp.remember() \g /dev/null
UPDATE town.axis SET width = width, geom = geom;
SELECT 'a statement that changes nothing writes nothing', count(*) = 0 FROM written;
UPDATE town.axis SET width = 3 WHERE axis_id = -1;
INSERT INTO town.axis SELECT * FROM town.axis WHERE false;
DELETE FROM town.axis WHERE axis_id = -1;
SELECT 'nor does one that finds no row', count(*) = 0 FROM written;
UPDATE town.axis SET name = 'rue de la Paix' WHERE axis_id = 3;
-- Of a model with roundabouts the edge notes that what tells a roundabout was read.
SELECT 'a name is nothing that streets are made of', count(*) = (to_regclass('town.roundabout') IS NOT NULL)::integer AND count(*) FILTER (WHERE relation <> 'edge') = 0 FROM written;

-- Other statements.
UPDATE town.axis SET width = width + 1 WHERE axis_id IN (2, 17, 30);
SELECT 'several axes far from each other are followed in one statement', test.followed('town', 'once');
UPDATE town.axis SET geom = ST_Translate(geom, 250, 33) WHERE axis_id = 5;
SELECT 'an axis that is moved elsewhere is right at both places', test.followed('town', 'once');
UPDATE town.axis SET geom = ST_Translate(geom, 0, 2000) WHERE axis_id = 5;
SELECT 'and far from all others', test.followed('town', 'once');
DELETE FROM town.axis WHERE axis_id IN (5, 12);
SELECT 'deleted axes leave no rows', test.followed('town', 'once') AND NOT EXISTS (SELECT FROM town.edge WHERE axis_id IN (5, 12));
UPDATE town.axis a SET geom = b.geom FROM town.axis b WHERE (a.axis_id, b.axis_id) IN ((7, 20), (20, 7));
SELECT 'two axes that swap their places are followed', test.followed('town', 'once');
BEGIN;
UPDATE town.axis SET axis_id = 1000 WHERE axis_id = 8;
UPDATE town.axis SET axis_id = 8 WHERE axis_id = 9;
SELECT 'an axis with the number of another is followed in the transaction', test.followed('town', 'once');
UPDATE town.axis SET axis_id = 9 WHERE axis_id = 1000;
COMMIT;
SELECT 'two axes that swap their numbers are followed', test.followed('town', 'once');
INSERT INTO town.axis (axis_id, geom, width) SELECT axis_id, geom, 15 FROM grid WHERE axis_id IN (8, 12) ON CONFLICT (axis_id) DO UPDATE SET width = excluded.width;
SELECT 'an upsert is followed', test.difference('town', 'once') IS NULL AND (SELECT count(DISTINCT axis_id) = 2 FROM town.edge WHERE axis_id IN (8, 12) AND width = 15);
WITH gone AS (DELETE FROM town.axis WHERE axis_id = 8 RETURNING geom), wide AS (UPDATE town.axis SET width = 12 WHERE axis_id = 10)
INSERT INTO town.axis (axis_id, geom, width) SELECT 8, ST_Reverse(geom), 5 FROM gone WHERE false UNION ALL SELECT 50, ST_Reverse(geom), 5 FROM gone;
SELECT 'three edits in one statement are followed', test.followed('town', 'once');
MERGE INTO town.axis a USING grid g ON a.axis_id = g.axis_id WHEN MATCHED AND a.axis_id = 14 THEN DELETE WHEN MATCHED AND a.axis_id = 15 THEN UPDATE SET width = 4 WHEN NOT MATCHED THEN INSERT (axis_id, geom, width) VALUES (g.axis_id, g.geom, 7);
SELECT 'MERGE is followed', test.followed('town', 'once');
COPY town.axis (axis_id, geom, width) FROM STDIN;
60	SRID=2154;LINESTRING(650045 6859960,650045 6860045)	6
61	SRID=2154;LINESTRING(650045 6859960,650120 6859950)	6
\.
SELECT 'COPY is followed', test.followed('town', 'once');
BEGIN;
UPDATE town.axis SET width = 20 WHERE axis_id = 60;
SAVEPOINT here;
DELETE FROM town.axis WHERE axis_id = 61;
ROLLBACK TO here;
SELECT 'an edit that is taken back is not followed', test.followed('town', 'once') AND EXISTS (SELECT FROM town.edge WHERE axis_id = 61);
SELECT 'who edits is shown with the places held', count(*) = 1 AND bool_and(pid = pg_backend_pid() AND holds ~ '^[1-9]\d* places$' AND waits_for = '{}') FROM streetgen.activity('town');
ROLLBACK;
SELECT 'nor a transaction that is', test.followed('town', 'once');
SELECT 'and nobody holds a place any more', count(*) = 0 FROM streetgen.activity('town');

-- Overrides and restrictions.
CREATE FUNCTION pg_temp.follows(change text) RETURNS TABLE (name text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
  PERFORM pg_temp.remember();
  EXECUTE change;
  RETURN QUERY SELECT regexp_replace(left(change, 80), '\s+', ' ', 'g') || ' is followed', EXISTS (SELECT FROM written) AND test.followed('town', 'once');
END $$;
SELECT * FROM pg_temp.follows($q$INSERT INTO town.transition_override (axis_id, which, kind, length) SELECT axis_id, which, 'left', 25 FROM generate_series(1, 31) axis_id, unnest(ARRAY['start', 'end']) which$q$);
SELECT * FROM pg_temp.follows($q$UPDATE town.transition_override SET kind = 'right', length = 2$q$);
SELECT * FROM pg_temp.follows('DELETE FROM town.transition_override');
SELECT * FROM pg_temp.follows('INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (16, 40, 1, 2.5)');
SELECT * FROM pg_temp.follows('UPDATE town.lane_override SET axis_id = 17');
SELECT * FROM pg_temp.follows('DELETE FROM town.lane_override');
SELECT * FROM pg_temp.follows($q$INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind) SELECT DISTINCT ON (n.node_id) a.axis_id, b.axis_id, n.geom, 'no' FROM town.interconnection i JOIN town.node n USING (node_id)
  JOIN town.lane l ON l.lane_id = lane_in JOIN town.edge a ON a.edge_id = l.edge_id JOIN town.lane m ON m.lane_id = lane_out JOIN town.edge b ON b.edge_id = m.edge_id WHERE connecting ORDER BY n.node_id, a.axis_id, b.axis_id LIMIT 3$q$);
SELECT * FROM pg_temp.follows($q$UPDATE town.turn_restriction SET kind = 'only'$q$);
SELECT * FROM pg_temp.follows('DELETE FROM town.turn_restriction');
SELECT * FROM pg_temp.follows($q$INSERT INTO town.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) SELECT n.geom, a.axis_id, l.ordinality, b.axis_id, m.ordinality, NOT connecting
  FROM town.interconnection i JOIN town.node n USING (node_id)
  JOIN town.lane l ON l.lane_id = lane_in JOIN town.edge a ON a.edge_id = l.edge_id JOIN town.lane m ON m.lane_id = lane_out JOIN town.edge b ON b.edge_id = m.edge_id ORDER BY interconnection_id LIMIT 1$q$);
SELECT * FROM pg_temp.follows('UPDATE town.interconnection_override SET connecting = NOT connecting');
SELECT * FROM pg_temp.follows($q$UPDATE town.interconnection_override SET connecting = NULL, control = ST_Translate(geom, 1, 2)$q$);
SELECT * FROM pg_temp.follows('DELETE FROM town.interconnection_override');
SELECT pg_temp.remember() \g /dev/null
INSERT INTO town.transition_override (axis_id, which, kind) VALUES (4711, 'start', 'left');
SELECT 'an override of an axis that is not there is kept and writes nothing', count(*) = 1 AND NOT EXISTS (SELECT FROM written) FROM town.transition_override;
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (16, 40, 1, 2.5);
UPDATE town.lane_override SET abscissa = abscissa;
DELETE FROM town.axis WHERE axis_id = 16;
SELECT 'an override outlives its axis', count(*) = 1 AND test.followed('town', 'once') FROM town.lane_override;
INSERT INTO town.axis (axis_id, geom, width, importance) SELECT * FROM grid WHERE axis_id = 16;
SELECT 'and holds again when it comes back', test.followed('town', 'once') AND EXISTS (SELECT FROM town.lane JOIN town.edge e USING (edge_id) WHERE axis_id = 16 AND method = 'by_hand');
TRUNCATE town.lane_override;
SELECT 'overrides that are truncated hold no more', test.followed('town', 'once');
DELETE FROM town.transition_override;

-- Off and on.
SELECT pg_temp.remember() \g /dev/null
SELECT 'off, no axis is stale', streetgen.live('town', false) = 0;
UPDATE town.axis SET width = 10.5 WHERE axis_id IN (2, 3);
INSERT INTO town.axis (axis_id, geom) VALUES (70, 'SRID=2154;LINESTRING(650300 6860000,650330 6860040)');
SELECT 'off, nothing follows', count(*) = 0 FROM written;
SELECT 'what is stale is counted', streetgen.live('town', false) = 3;
SELECT streetgen.live('town', true) \g /dev/null
UPDATE town.axis SET width = 8 WHERE axis_id = 31;
SELECT 'on, an edit elsewhere leaves the stale ones to generate', EXISTS (SELECT FROM town.edge WHERE axis_id = 31 AND width = 8) AND NOT EXISTS (SELECT FROM town.edge WHERE axis_id = 2 AND width = 10.5);
SELECT streetgen.live('town', false) \g /dev/null
DELETE FROM town.axis WHERE axis_id = 25;
SELECT 'off, a deleted axis takes its results with it', NOT EXISTS (SELECT FROM town.edge WHERE axis_id = 25) AND NOT EXISTS (SELECT FROM town.section s WHERE NOT EXISTS (SELECT FROM town.edge e WHERE e.edge_id = s.edge_id));
SELECT 'no node is left without an edge', NOT EXISTS (SELECT FROM town.node n WHERE NOT EXISTS (SELECT FROM town.edge WHERE node_id IN (from_node, to_node)));
SELECT 'and its neighbours are stale', (SELECT count(*) > 1 FROM streetgen.check_model('town') WHERE rule LIKE 'stale%');
SELECT 'more is stale now', streetgen.live('town', true) > 3;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
SELECT 'an edit beside stale ones takes them along', bool_and(width = 10.5) AND count(*) >= 2 FROM town.edge WHERE axis_id IN (2, 3);
SELECT streetgen.generate('town') \g /dev/null
SELECT 'generate brings all up to date', test.followed('town', 'once') AND streetgen.live('town', true) = 0;
BEGIN;
SELECT pg_temp.remember() \g /dev/null
SET LOCAL streetgen.live = 'off';
UPDATE town.axis SET width = 5 WHERE axis_id = 4;
SELECT 'a transaction may go without', count(*) = 0 FROM written;
COMMIT;
UPDATE town.axis SET width = 5.5 WHERE axis_id = 4;
SELECT 'the next one follows', test.followed('town', 'once');

-- What is said of turns while nobody follows: no hash of an axis sees it, and a run for one axis takes it along.
CREATE TABLE decided AS SELECT n.geom, i.ordinality AS lane_in, a.axis_id AS axis_in, o.ordinality AS lane_out, b.axis_id AS axis_out FROM town.interconnection c JOIN town.node n USING (node_id)
  JOIN town.lane i ON i.lane_id = c.lane_in JOIN town.edge a ON a.edge_id = i.edge_id JOIN town.lane o ON o.lane_id = c.lane_out JOIN town.edge b ON b.edge_id = o.edge_id
  WHERE connecting AND a.axis_id = 16 ORDER BY b.axis_id, lane_in, lane_out LIMIT 1;
CREATE TABLE unfollowed (name text, stale bigint, told boolean, taken boolean);
SELECT streetgen.live('town', false) \g /dev/null
DO $$
DECLARE
  change text;
BEGIN
  FOREACH change IN ARRAY ARRAY['INSERT INTO town.turn_restriction (geom, from_axis, to_axis, kind) SELECT geom, axis_in, axis_out, ''no'' FROM decided', 'UPDATE town.turn_restriction SET turn = ''u_turn''', 'DELETE FROM town.turn_restriction',
      'INSERT INTO town.turn_restriction (geom, from_axis, to_axis, kind) SELECT geom, axis_in, axis_out, ''no'' FROM decided', 'TRUNCATE town.turn_restriction',
      'INSERT INTO town.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) SELECT geom, axis_in, lane_in, axis_out, lane_out, false FROM decided', 'UPDATE town.interconnection_override SET connecting = true',
      'DELETE FROM town.interconnection_override'] LOOP
    EXECUTE change;
    INSERT INTO unfollowed SELECT change, streetgen._stale_axes('town'), (SELECT count(*) = 2 FROM streetgen.check_model('town') WHERE rule = 'stale: the axis changed since');
    PERFORM streetgen.generate('town', '{16}');
    UPDATE unfollowed SET taken = streetgen._stale_axes('town') = 0 AND test.followed('town', 'once') WHERE taken IS NULL;
  END LOOP;
END $$;
SELECT 'not followed, its axes are stale: ' || name, stale = 2 AND told FROM unfollowed;
SELECT 'and a run for one of them takes it', taken FROM unfollowed;
SELECT streetgen.live('town', true) \g /dev/null
SELECT pg_temp.remember() \g /dev/null
BEGIN;
SET LOCAL streetgen.live = 'off';
INSERT INTO town.turn_restriction (geom, from_axis, to_axis, kind) VALUES ('SRID=2154;POINT(650000 6860000)', -1, -2, 'no');
SELECT 'one of axes that are gone writes nothing', count(*) = 0 FROM written;
SELECT 'nor locks anything', NOT EXISTS (SELECT FROM pg_locks WHERE locktype = 'advisory' AND pid = pg_backend_pid());
ROLLBACK;
SELECT 'only the owner switches', (r).state = '42501' AND (r).hint <> '' FROM (SELECT test.refusal($q$CREATE ROLE streetgen_test_other ROLE CURRENT_USER; SET LOCAL ROLE streetgen_test_other; SELECT streetgen.live('town', false)$q$) AS r) t;
SELECT 'a model that is not there is refused', test.state($q$SELECT streetgen.live('no such', false)$q$) = '3F000' AND test.state($q$SELECT * FROM streetgen.activity('no such')$q$) = '3F000';

-- Settings: old and new are never mixed.
SELECT streetgen.set('town', 'dead_end', 'round') \g /dev/null
SELECT pg_temp.remember() \g /dev/null
UPDATE town.axis SET width = 13 WHERE axis_id = 4;
SELECT 'after a change of settings an edit waits for generate', count(*) = 0 FROM written;
SELECT 'and all is stale', streetgen.live('town', true) = (SELECT count(DISTINCT axis_id) FROM town.edge);
DELETE FROM town.axis WHERE axis_id = 4;
SELECT 'a deleted axis takes its results with it even so', NOT EXISTS (SELECT FROM town.edge WHERE axis_id = 4) AND (SELECT count(DISTINCT setting_hash) = 1 FROM town.edge);
SELECT streetgen.generate('town') \g /dev/null
INSERT INTO town.axis (axis_id, geom) SELECT axis_id, geom FROM grid WHERE axis_id = 4;
SELECT 'after generate edits are followed again', test.followed('town', 'once');

-- Locks.
BEGIN;
UPDATE town.axis SET width = 6 WHERE axis_id = 4;
SELECT 'where none is set an edit waits as long as the model says', current_setting('lock_timeout') = '5s';
COMMIT;
SELECT 'and only for its transaction', current_setting('lock_timeout') = '0';
SELECT streetgen.set('town', 'lock_timeout', '0.25') \g /dev/null
BEGIN;
UPDATE town.axis SET width = 7 WHERE axis_id = 4;
SELECT 'setting lock_timeout is read', current_setting('lock_timeout') = '250ms';
COMMIT;
SELECT 'it makes nothing stale', streetgen.live('town', true) = 0;
BEGIN;
SET LOCAL lock_timeout = '7s';
UPDATE town.axis SET width = 6 WHERE axis_id = 4;
SELECT 'a lock_timeout of the session stays', current_setting('lock_timeout') = '7s';
COMMIT;

-- Bad input: one error that says what to do, and the rest of the transaction goes on.
BEGIN;
SELECT pg_temp.remember() \g /dev/null
SELECT format('%s is refused', what), (r).state = wanted AND (r).said <> '' FROM (VALUES
  ('a width of NaN', $q$UPDATE town.axis SET width = 'NaN' WHERE axis_id = 4$q$, '23514'), ('a width out of range', 'UPDATE town.axis SET width = 201 WHERE axis_id = 4', '23514'),
  ('a line of no length', $q$UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650000 6860000)' WHERE axis_id = 4$q$, '23514'),
  ('another SRID', $q$UPDATE town.axis SET geom = 'SRID=32631;LINESTRING(0 0,1 1)' WHERE axis_id = 4$q$, '22023'),
  ('no line', 'UPDATE town.axis SET geom = NULL WHERE axis_id = 4', '23502'),
  ('a place where the scale is off', $q$UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 8860000,650100 8860000)' WHERE axis_id = 4$q$, '22023'),
  ('a number that is taken', 'UPDATE town.axis SET axis_id = 5 WHERE axis_id = 4', '23505')) v(what, statement, wanted), test.refusal(statement) r;
SELECT 'a place far off is refused with the scale and a way out', r.said LIKE '%axis 4%' AND r.detail LIKE '%100 m%' AND r.hint LIKE '%EPSG%'
  FROM test.refusal($q$UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650000 8860000,650100 8860000)' WHERE axis_id = 4$q$) r;
SELECT 'what is refused writes nothing', count(*) = 0 FROM written;
UPDATE town.axis SET width = 6.5 WHERE axis_id = 4;
SELECT 'and the transaction goes on', test.followed('town', 'once');
COMMIT;
BEGIN ISOLATION LEVEL REPEATABLE READ;
SELECT 'an edit above read committed is refused with a way out', r.state = '0A000' AND r.hint <> '' FROM test.refusal('UPDATE town.axis SET width = 9 WHERE axis_id = 4') r;
ROLLBACK;

-- An editor has rights on the input only.
DO $$ BEGIN
  CREATE ROLE streetgen_test_live ROLE CURRENT_USER;
  PERFORM streetgen."grant"('town', 'streetgen_test_live', 'editor');
END $$;
SELECT setval('town.axis_axis_id_seq', 1000) \g /dev/null
SET ROLE streetgen_test_live;
UPDATE town.axis SET width = 8.5 WHERE axis_id = 4;
INSERT INTO town.axis (geom) VALUES ('SRID=2154;LINESTRING(650300 6860200,650330 6860240)');
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (17, 40, 1, 2.5);
DELETE FROM town.axis WHERE axis_id = 11;
SELECT format('an editor may not %s', statement), test.state(statement) = '42501' FROM unnest(ARRAY['UPDATE town.edge SET width = 1', 'DELETE FROM town.node', 'INSERT INTO town.node (geom) SELECT geom FROM town.node',
  'SELECT town._upsert(''{1}'', ''{1}'', ''{1}'')', 'SELECT town._upsert_edited(''{1}'', ''{1}'', ''{1}'')', 'TRUNCATE town.axis', 'ALTER TABLE town.axis DISABLE TRIGGER z_follow_update', 'UPDATE town.setting SET value = value']) statement;
-- What stands in a session's temporary schema must not run with the owner's rights.
CREATE TEMPORARY TABLE ran_as (who name);
GRANT INSERT ON ran_as TO PUBLIC;
CREATE FUNCTION pg_temp.spy(value anyelement) RETURNS anyelement LANGUAGE plpgsql AS $$ BEGIN INSERT INTO pg_temp.ran_as VALUES (current_user); RETURN value; END $$;
CREATE FUNCTION pg_temp.holds(value double precision) RETURNS boolean LANGUAGE sql AS 'SELECT pg_temp.spy(true)';
CREATE DOMAIN pg_temp.float8 AS double precision CHECK (pg_temp.holds(value));
CREATE TEMPORARY VIEW pg_trigger AS SELECT oid, tgrelid, tgname, pg_temp.spy(tgenabled) AS tgenabled FROM pg_catalog.pg_trigger;
GRANT SELECT ON pg_trigger TO PUBLIC;
-- In a session that has not edited yet nothing is planned.
DISCARD PLANS;
UPDATE town.axis SET width = 8.6 WHERE axis_id = 4;
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (17, 42, 1, 2.5);
SELECT 'what an editor plants in the temporary schema does not run', count(*) = 0 FROM ran_as;
DROP VIEW pg_trigger;
DROP DOMAIN pg_temp.float8;
UPDATE town.axis SET width = 8.5 WHERE axis_id = 4;
RESET ROLE;
SELECT 'what an editor does is followed', test.difference('town', 'once') IS NULL AND EXISTS (SELECT FROM town.edge WHERE axis_id = 4 AND width = 8.5);
-- An editor of objects calls what holds their streets.
SELECT 'functions in the schema are the owner''s, and those that run with its rights are nobody else''s', count(*) >= 4 AND bool_and(proowner = nspowner AND NOT (prosecdef AND proname <> ALL ('{_begin_ruled_edit,_lock_beside,_hold_borders}') AND has_function_privilege('streetgen_test_live', p.oid, 'EXECUTE'))
    AND proconfig && '{"search_path=pg_catalog, public, pg_temp","search_path=town, public, pg_temp"}') AND bool_and(prosecdef) FILTER (WHERE prorettype = 'trigger'::regtype)
  FROM pg_proc p JOIN pg_namespace n ON n.oid = pronamespace WHERE nspname = 'town';

-- Replicas and restores.
SELECT pg_temp.remember() \g /dev/null
SELECT test.as_administrator('SET session_replication_role = replica') \g /dev/null
UPDATE town.axis SET width = 9.5 WHERE axis_id = 4;
DELETE FROM town.axis WHERE axis_id = 17;
SELECT test.as_administrator('RESET session_replication_role') \g /dev/null
SELECT 'on a replica nothing fires', count(*) = 0 FROM written;
ALTER TABLE town.axis DISABLE TRIGGER ALL;
INSERT INTO town.axis (axis_id, geom) SELECT axis_id, geom FROM grid WHERE axis_id = 17;
ALTER TABLE town.axis ENABLE TRIGGER ALL;
SELECT 'nor under --disable-triggers', count(*) = 0 FROM written;
SELECT streetgen.generate('town') \g /dev/null
SELECT 'generate follows', test.followed('town', 'once');

-- Names that need quotes, heights, an empty model.
SELECT streetgen.create_model('Ville "d''Été"', 2154) \g /dev/null
INSERT INTO "Ville ""d'Été""".axis (axis_id, geom, width, importance) SELECT * FROM grid WHERE axis_id < 6;
UPDATE "Ville ""d'Été""".axis SET width = 9 WHERE axis_id = 3;
SELECT 'any name will do for a model', test.followed('Ville "d''Été"', 'once');
BEGIN;
UPDATE "Ville ""d'Été""".axis SET width = 10 WHERE axis_id = 3;
SELECT 'of which activity tells too', count(*) = 1 FROM streetgen.activity('Ville "d''Été"');
COMMIT;
SELECT streetgen.create_model('high', 2154, 3) \g /dev/null
INSERT INTO high.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING Z(650000 6860000 10,650100 6860000 20)', 7), (2, 'SRID=2154;LINESTRING Z(650100 6860000 20,650200 6860000 40)', 7);
UPDATE high.axis SET geom = 'SRID=2154;LINESTRING Z(650100 6860000 20,650200 6860000 70)' WHERE axis_id = 2;
SELECT 'heights are followed', array_agg(ST_Z(geom)::integer ORDER BY ST_X(geom)) = '{10,20,70}' FROM high.node;
SELECT 'and nothing is left to do', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('high');

-- Ground that a neighbour of what changes gives up: a street that lies beside the corner at its far node had lost some to it.
SELECT streetgen.create_model('corner', 2154), streetgen.set('corner', 'corner_length', NULL), streetgen.set('corner', 'corner_area', NULL) \g /dev/null
INSERT INTO corner.axis (axis_id, geom, width, importance, radius) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650020 6860000,650030 6860000)', 6, 2, 20), (2, 'SRID=2154;LINESTRING(650030 6860000,650030 6860100)', 6, 2, 20),
  (3, 'SRID=2154;LINESTRING(650020 6860010.5,650020 6860040)', 14, 9, 0), (4, 'SRID=2154;LINESTRING(650000 6860000,649900 6860000)', 6, 2, 20);
CREATE TEMPORARY VIEW lost AS SELECT contested_area AS area FROM corner.section JOIN corner.edge USING (edge_id) WHERE axis_id = 3;
SELECT 'a wide corner takes ground of a street beside it', area > 1 FROM lost;
INSERT INTO corner.axis (axis_id, geom, width, importance, radius) VALUES (9, 'SRID=2154;LINESTRING(650020 6860000,650020 6859900)', 6, 2, 20);
SELECT 'which gets it back when the edge between is cut', area = 0 FROM lost;
SELECT 'as one run gives it', test.followed('corner', 'once');

-- TRUNCATE.
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (16, 41, 1, 2.5);
BEGIN;
TRUNCATE town.axis;
SELECT 'truncated axes leave nothing', count(*) = 0 FROM derived();
SELECT 'but overrides', count(*) > 0 FROM town.lane_override;
INSERT INTO town.axis (axis_id, geom, width, importance) SELECT * FROM grid;
SELECT 'a town that is drawn anew is followed', test.followed('town', 'once');
ROLLBACK;
SELECT 'and taken back with its transaction', test.followed('town', 'once');
SELECT streetgen.live('town', false) \g /dev/null
BEGIN;
TRUNCATE town.axis;
SELECT 'off, truncated axes are for generate to follow', bool_or(deleted > 0) AND NOT EXISTS (SELECT FROM derived()) FROM streetgen.generate('town');
ROLLBACK;
SELECT streetgen.live('town', true) \g /dev/null
DELETE FROM town.axis;
SELECT 'deleted to the last axis, nothing is left', count(*) = 0 FROM derived();
INSERT INTO town.axis (axis_id, geom, width, importance) SELECT * FROM grid;
SELECT 'and it goes on from nothing', test.followed('town', 'once');

-- A street is cut far from its corner, whose arc then bends nearer to the node: farther than reach, within max_arc_distance.
SELECT streetgen.create_model('bend', 2154), streetgen.set('bend', 'reach', '10'), streetgen.set('bend', 'max_arc_distance', '200'), streetgen.set('bend', 'corner_length', NULL), streetgen.set('bend', 'corner_area', NULL) \g /dev/null
INSERT INTO bend.axis (axis_id, geom, width, radius) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 6, 50), (2, 'SRID=2154;LINESTRING(650000 6860000, 650000 6860200)', 6, 50),
  (3, 'SRID=2154;LINESTRING(650007 6860030, 650007 6860100)', 10, 5);
CREATE FUNCTION pg_temp.ceded() RETURNS float8 LANGUAGE sql AS $$ SELECT contested_area FROM bend.section JOIN bend.edge USING (edge_id) WHERE axis_id = 3 $$;
SELECT pg_temp.ceded() AS ceded \gset
INSERT INTO bend.axis (axis_id, geom, width) VALUES (4, 'SRID=2154;LINESTRING(650020 6860000, 650020 6859900)', 6);
SELECT 'a street beside a far corner gets the ground that its arc gives up', pg_temp.ceded() < :ceded - 9;
SELECT 'as from scratch', test.followed('bend', 'once');
DELETE FROM bend.axis WHERE axis_id = 4;
SELECT 'and loses it when the arc is back', pg_temp.ceded() = :ceded;
SELECT 'as from scratch again', test.followed('bend', 'once');
SELECT streetgen.drop_model('bend') \g /dev/null

-- Beyond the reach of an edit lies an axis too short for an edge: the node where its neighbours meet lies in the middle of it all the same.
SELECT streetgen.create_model('short', 2154) \g /dev/null
INSERT INTO short.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650300 6860000, 650300.3 6860000.2)', 7),
  (2, 'SRID=2154;LINESTRING(650300.3 6860000.2, 650400 6860050)', 7), (3, 'SRID=2154;LINESTRING(650000 6860000, 650300 6860000)', 7),
  (4, 'SRID=2154;LINESTRING(650000 6860000, 650000 6859950)', 7);
SELECT 'it has no edge, and a node', (SELECT count(*) = 0 FROM short.edge WHERE axis_id = 1) AND (SELECT ST_Distance(ST_EndPoint(geom), 'SRID=2154;POINT(650300.15 6860000.1)') < 1e-6 FROM short.edge WHERE axis_id = 3);
UPDATE short.axis SET width = 8 WHERE axis_id = 4;
SELECT 'an edit far from it leaves its node', ST_Distance(ST_EndPoint(geom), 'SRID=2154;POINT(650300.15 6860000.1)') < 1e-6 FROM short.edge WHERE axis_id = 3;
SELECT streetgen.drop_model('short') \g /dev/null

-- The node where an edited axis ends moves, which turns the street that begins there, far away too: at its other end (155, 0) corners bend anew, and of the
-- short street there, whose limits cross, the limit at its far node (155, 25) moves. Nothing else of that node is near the edit.
SELECT streetgen.create_model('led', 2154) \g /dev/null
INSERT INTO led.axis (axis_id, geom, width, lane_count) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7, 2 FROM (VALUES
  (1, 'LINESTRING(0 -100, 0 0)'), (2, 'LINESTRING(0 0, 155 0)'), (3, 'LINESTRING(155 0, 155 25)'), (4, 'LINESTRING(155 0, 255 -40)'),
  (5, 'LINESTRING(155 25, 255 25)'), (6, 'LINESTRING(155 25, 155 125)')) a(axis_id, line);
SELECT 'the limits of a short street cross', bool_and(method = 'crossed_limits') FROM led.section JOIN led.edge USING (edge_id) WHERE axis_id = 3;
SELECT abscissa AS met FROM led.section_limit JOIN led.edge USING (edge_id) WHERE axis_id = 3 AND which = 'end' \gset
CREATE TEMPORARY TABLE left_movement AS SELECT interconnection_id, lane_in, lane_out, k.geom FROM led.interconnection k JOIN led.node n USING (node_id) WHERE ST_DWithin(n.geom, ST_SetSRID(ST_MakePoint(650155, 6860025), 2154), 1);
UPDATE led.axis SET geom = ST_SetPoint(geom, 1, ST_Translate(ST_EndPoint(geom), 0.1, 0.3)) WHERE axis_id = 1;
SELECT 'an edit turns a long street, and moves them', abs(abscissa - :met) BETWEEN 1e-4 AND 1 FROM led.section_limit JOIN led.edge USING (edge_id) WHERE axis_id = 3 AND which = 'end';
SELECT 'with the movements beyond', count(*) > 0 FROM left_movement m JOIN led.interconnection k USING (interconnection_id) WHERE NOT ST_Equals(k.geom, m.geom);
SELECT 'as from scratch', test.followed('led', 'once');
SELECT 'nothing is stale', streetgen.live('led', true) = 0;
SELECT streetgen.drop_model('led') \g /dev/null
-- Axes that cross at no vertex: of the lesser one nothing reaches the other.
SELECT streetgen.create_model('crossed', 2154) \g /dev/null
INSERT INTO crossed.axis (axis_id, geom, width, importance) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), width, importance FROM (VALUES
  (1, 'LINESTRING(0 0, 100 0)', 14, 1), (2, 'LINESTRING(50 -40, 50 40)', 5, 6)) a(axis_id, line, width, importance);
SELECT 'a crossing is reported where it lies', count(*) = 1 AND min(ST_X(geom)) = 650050 FROM crossed.report WHERE (issue, axis_a, axis_b) = ('crossing', 1, 2);
UPDATE crossed.axis SET geom = ST_Translate(geom, 10, 0) WHERE axis_id = 2;
SELECT 'the report moves with either axis', count(*) = 1 AND min(ST_X(geom)) = 650060 FROM crossed.report;
SELECT 'as from scratch, as all the rest', test.followed('crossed', 'once');
DELETE FROM crossed.axis WHERE axis_id = 2;
SELECT 'and goes with it', NOT EXISTS (SELECT FROM crossed.report);
SELECT streetgen.drop_model('crossed') \g /dev/null
-- An axis less than a metre long has an edge, until one that ends between its ends joins both to one node.
SELECT streetgen.create_model('short', 2154) \g /dev/null
INSERT INTO short.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650300 6860000, 650300.5 6859999.5)', 7);
SELECT 'it has an edge', count(*) = 1 FROM short.edge;
INSERT INTO short.axis (axis_id, geom, width) VALUES (2, 'SRID=2154;LINESTRING(650200 6859900, 650300.25 6859999.75)', 7);
SELECT 'it has none once its ends are one node', array_agg(axis_id) = '{2}' FROM short.edge;
SELECT 'and is reported', count(*) = 1 FROM short.report WHERE axis_a = 1 AND issue = 'collapsed_axis';
SELECT 'as from scratch', test.followed('short', 'once');
DELETE FROM short.axis WHERE axis_id = 2;
SELECT 'it has one again when the other is gone', array_agg(axis_id) = '{1}' FROM short.edge;
SELECT 'as from scratch', test.followed('short', 'once');
SELECT streetgen.drop_model('short') \g /dev/null

-- An edit joins the end of a street to a place beside it, which turns the whole street: where it shares ground with another beyond reach, that follows too.
SELECT streetgen.create_model('turned', 2154) \g /dev/null
INSERT INTO turned.axis (axis_id, geom, width, importance, level) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), width, importance, level FROM (VALUES
  (1, 'LINESTRING(77.4225 145.08, 120.6675 9.765)', 5.88, 2, 1), (2, 'LINESTRING(195.9975 15.345, 211.42 29.415, 222.5025 54.405)', 12.17, 5, 0),
  (3, 'LINESTRING(54.5725 56.97, 214.595 206.6175)', 10.85, 4, 1)) a(axis_id, line, width, importance, level);
CREATE TEMPORARY TABLE before_turn AS SELECT edge_id, contested_area FROM turned.section JOIN turned.edge USING (edge_id) WHERE axis_id = 3;
UPDATE turned.axis SET geom = ST_SetPoint(geom, 2, 'SRID=2154;POINT(650120.4475 6860010.545)') WHERE axis_id = 2;
SELECT 'a street beyond the reach of an edit shares other ground with one that it turns', count(*) = 1 FROM before_turn b JOIN turned.section s USING (edge_id) WHERE abs(s.contested_area - b.contested_area) BETWEEN 1e-4 AND 1;
SELECT 'as from scratch', test.followed('turned', 'once');
UPDATE turned.axis SET geom = ST_SetPoint(geom, 2, 'SRID=2154;POINT(650222.5025 6860054.405)') WHERE axis_id = 2;
SELECT 'and what it had when it is turned back', count(*) = 1 FROM before_turn b JOIN turned.section s USING (edge_id) WHERE abs(s.contested_area - b.contested_area) < 1e-6;
SELECT 'nothing is stale', streetgen.live('turned', true) = 0;
SELECT streetgen.drop_model('turned') \g /dev/null

-- Where a limit moves from behind a bend to before it, lanes have another last segment at the other end too: paths there bend anew.
SELECT streetgen.create_model('bent', 2154) \g /dev/null
INSERT INTO bent.axis (axis_id, geom, width, width_end, direction, importance, level) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), width, width_end, direction, importance, level FROM (VALUES
  (25, 'LINESTRING(108.4364 129.7476, 156.3632 166.8706, 203.71 189.2936)', 14.25, NULL, 'reverse', 1, -1), (36, 'LINESTRING(178.0112 121.5992, 216.1488 142.328, 249.4664 172.9968)', 13.04, NULL, 'direct', 4, 0),
  (38, 'LINESTRING(203.71 189.2936, 234.3382 181.3252, 249.4664 172.9968)', 15.09, 17.81, 'reverse', 1, -1), (39, 'LINESTRING(203.75 189.1136, 262.0024 265.7632)', 18.37, NULL, 'reverse', 1, 0)) a(axis_id, line, width, width_end, direction, importance, level);
UPDATE bent.axis SET width_end = 19.89 WHERE axis_id = 36;
SELECT 'a wider street at one end of a bent one: the other end follows, as from scratch', test.followed('bent', 'once');
SELECT streetgen.drop_model('bent') \g /dev/null

-- Lanes of given widths share what a widening street has at its start: where that limit moves, paths at the other end bend anew.
SELECT streetgen.create_model('shared', 2154) \g /dev/null
INSERT INTO shared.axis (axis_id, geom, width, width_end) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), width, width_end FROM (VALUES
  (1, 'LINESTRING(0 0, 100 0)', 7, 12), (2, 'LINESTRING(0 -60, 0 0)', 6, NULL), (3, 'LINESTRING(100 0, 110 60)', 8, NULL)) a(axis_id, line, width, width_end);
INSERT INTO shared.lane_override (axis_id, abscissa, ordinality, width) VALUES (1, 50, 1, 3);
UPDATE shared.axis SET width = 10 WHERE axis_id = 2;
SELECT 'a wider street at the start of a widening one: the other end follows, as from scratch', test.followed('shared', 'once');
SELECT streetgen.drop_model('shared') \g /dev/null

-- A user's trigger edits a street before the deletion of another is followed: what is gone waits for the run that asks for it.
SELECT streetgen.create_model('gone', 2154) \g /dev/null
INSERT INTO gone.axis (axis_id, geom, width) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7 FROM (VALUES
  (1, 'LINESTRING(0 0, -50 0)'), (2, 'LINESTRING(0 0, 0 50)'), (3, 'LINESTRING(50 10, 200 10)'), (4, 'LINESTRING(200 10, 200 100)')) a(axis_id, line);
CREATE FUNCTION pg_temp.widen() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  UPDATE gone.axis SET width = 8 WHERE axis_id = 2;
  RETURN NULL;
END $$;
CREATE TRIGGER a_widen AFTER DELETE ON gone.axis FOR EACH STATEMENT EXECUTE FUNCTION pg_temp.widen();
DELETE FROM gone.axis WHERE axis_id = 3;
SELECT 'the street that met the one that is deleted has a dead end', bool_and(abscissa IN (0, 90)) FROM gone.section_limit JOIN gone.edge USING (edge_id) WHERE axis_id = 4;
SELECT 'as from scratch', test.followed('gone', 'once');
SELECT streetgen.drop_model('gone') \g /dev/null

-- An axis too short for an edge joins the start of another to a place on it: the same line, but of a shorter stretch. The node stays where most arms meet.
SELECT streetgen.create_model('short', 2154) \g /dev/null
INSERT INTO short.axis (axis_id, geom, width, width_end) VALUES (1, 'SRID=2154;LINESTRING(650300 6860000, 650400 6860000)', 7, 9),
  (3, 'SRID=2154;LINESTRING(650300 6860000, 650250 6860080)', 7, NULL);
CREATE TEMPORARY TABLE before_short AS SELECT geom FROM short.edge WHERE axis_id = 1;
INSERT INTO short.axis (axis_id, geom, width) VALUES (2, 'SRID=2154;LINESTRING(650300.3 6860000, 650300.7 6860000)', 7);
SELECT 'an edge keeps its line and begins farther on along its axis', count(*) = 1 FROM short.edge JOIN before_short USING (geom) WHERE axis_id = 1 AND abs(start_abscissa - 0.7) < 1e-6;
SELECT 'as from scratch', test.followed('short', 'once');
UPDATE short.axis SET geom = ST_Translate(geom, 0, 90) WHERE axis_id = 2;
SELECT 'and at its start again when that is elsewhere', count(*) = 1 FROM short.edge WHERE axis_id = 1 AND start_abscissa = 0;
SELECT 'as from scratch', test.followed('short', 'once');
SELECT streetgen.drop_model('short') \g /dev/null

-- The same where a corner beyond a short street follows the one that turns: neither street of it comes near the edit.
SELECT streetgen.create_model('led', 2154), streetgen.set('led', 'short_axis', 'follow'), streetgen.set('led', 'corner_length', NULL), streetgen.set('led', 'corner_area', NULL), streetgen.set('led', 'follow_length', NULL), streetgen.set('led', 'follow_area', NULL) \g /dev/null
INSERT INTO led.axis (axis_id, geom, width) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7 FROM (VALUES
  (1, 'LINESTRING(0 -100, 0 0)'), (2, 'LINESTRING(0 0, 155 0)'), (3, 'LINESTRING(155 0, 163 0)'), (4, 'LINESTRING(155 0, 155 -100)'),
  (5, 'LINESTRING(163 0, 163 100)'), (6, 'LINESTRING(163 0, 263 -40)')) a(axis_id, line);
SELECT 'a corner follows', count(*) = 1 FROM led.corner c JOIN led.node n USING (node_id) WHERE c.method = 'followed' AND ST_DWithin(n.geom, ST_SetSRID(ST_MakePoint(650163, 6860000), 2154), 1);
SELECT abscissa AS met FROM led.section_limit JOIN led.edge USING (edge_id) WHERE axis_id = 5 AND which = 'start' \gset
UPDATE led.axis SET geom = ST_SetPoint(geom, 1, ST_Translate(ST_EndPoint(geom), 0.1, 0.3)) WHERE axis_id = 1;
SELECT 'and moves with it', abs(abscissa - :met) BETWEEN 1e-4 AND 1 FROM led.section_limit JOIN led.edge USING (edge_id) WHERE axis_id = 5 AND which = 'start';
SELECT 'as from scratch, too', test.followed('led', 'once');
SELECT streetgen.drop_model('led') \g /dev/null

-- A change of width that filled its section ends: the paths at the far node turn, too.
SELECT streetgen.create_model('led', 2154, driving_side => 'right') \g /dev/null
INSERT INTO led.axis (axis_id, geom, width, direction, importance) SELECT axis_id, ST_GeomFromText(line, 2154), width, direction, importance FROM (VALUES
  (3, 'LINESTRING(650011.0128 6860019.2724,650075.0247 6860053.6874)', 10.24, 'reverse', 5), (7, 'LINESTRING(650083.5443 6859984.3390999995,650075.0247 6860053.6874)', 21.43, 'direct', 5),
  (8, 'LINESTRING(650083.5142999999 6859983.9091,650123.8940000001 6860085.3492)', 14.09, 'both', 2), (9, 'LINESTRING(650075.0247 6860053.6874,650072.7845 6860099.14785,650083.2842999999 6860138.3483)', 6.36, 'direct', 2)) a(axis_id, line, width, direction, importance);
INSERT INTO led.axis (axis_id, geom, width) VALUES (10, 'SRID=2154;LINESTRING(650075.0247 6860053.6874,650123.8940000001 6860085.3492)', 13.78);
SELECT 'paths turn with lanes whose far end changed', test.followed('led', 'once');
SELECT streetgen.drop_model('led') \g /dev/null

-- Without the extension.
CREATE TABLE public.town_content AS SELECT test.content('town') AS content;
DO $$ BEGIN
  DROP OWNED BY streetgen_test_live;
  DROP ROLE streetgen_test_live;
END $$;
SELECT test.as_administrator('DROP EXTENSION streetgen CASCADE') \g /dev/null
SELECT 'without the extension no trigger is left', count(*) = 0 FROM pg_trigger t JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = 'town'::regnamespace AND NOT tgisinternal;
SELECT 'and no function', count(*) = 0 FROM pg_proc WHERE pronamespace = 'town'::regnamespace;
UPDATE town.axis SET width = 12 WHERE axis_id = 10;
SELECT 'its tables stay, and axes can be edited', NOT EXISTS (SELECT test.content('town') EXCEPT ALL SELECT content FROM town_content);
SELECT test.as_administrator('CREATE EXTENSION streetgen') \g /dev/null
SELECT streetgen.adopt_model('town'), streetgen.adopt_model('once') \g /dev/null
SELECT 'adopt_model counts what is stale', streetgen.live('town', true) = 1;
SELECT 'adopt_model puts the triggers back, under the same names', (SELECT array_agg(tgname ORDER BY tgname) FROM pg_trigger WHERE tgrelid = 'town.axis'::regclass AND NOT tgisinternal)
  @> ARRAY['a_enter', 'z_follow_delete', 'z_follow_insert', 'z_follow_truncate', 'z_follow_update']::name[];
SELECT 'on every table that is input', bool_and(3 <= (SELECT count(*) FROM pg_trigger WHERE tgrelid = c.oid AND tgname LIKE 'z\_follow\_%')) AND count(*) > 3
  FROM pg_class c WHERE relnamespace = 'town'::regnamespace AND relkind = 'r' AND (relname IN ('axis', 'turn_restriction') OR relname LIKE '%\_override');
UPDATE town.axis SET width = 11 WHERE axis_id IN (10, 30);
SELECT 'and the streets follow', test.followed('town', 'once');
