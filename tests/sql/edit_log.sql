\set ECHO none
\ir shared/truths.sql
-- Switching the log beside an open edit: it waits with nothing in its hands, so that no other edit waits for it.
CREATE EXTENSION dblink;
SELECT format('dbname=%s host=%s port=%s user=%s', current_database(), :'HOST', :'PORT', :'USER') AS connection \gset
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7
  FROM (VALUES (1, 'LINESTRING(0 0,100 0)'), (2, 'LINESTRING(0 5000,100 5000)')) v(id, line);
SELECT streetgen.set('town', 'log', 'on') \g /dev/null
SELECT dblink_connect(name, :'connection') FROM unnest('{editor,owner}'::text[]) name \g /dev/null
SELECT dblink_exec('editor', 'BEGIN'), dblink_exec('editor', 'UPDATE town.axis_editing SET width = 8 WHERE axis_id = 1') \g /dev/null
SELECT dblink_send_query('owner', $$SELECT streetgen.set('town', 'log', 'off')$$) \g /dev/null
-- Until it waits.
DO $$
BEGIN
  FOR attempt IN 1..1000 LOOP
    PERFORM pg_stat_clear_snapshot();
    EXIT WHEN EXISTS (SELECT FROM pg_stat_activity WHERE query LIKE '%''off'')' AND state = 'active' AND wait_event IS NOT NULL AND pid <> pg_backend_pid());
    PERFORM pg_sleep(0.02);
  END LOOP;
END $$;
SELECT 'the switch waits for an open edit', dblink_is_busy('owner') = 1;
SET lock_timeout = '2s';
SELECT 'another edit does not wait for the switch', test.state('UPDATE town.axis SET width = 9 WHERE axis_id = 2') = 'none';
RESET lock_timeout;
SELECT dblink_exec('editor', 'COMMIT') \g /dev/null
SELECT FROM dblink_get_result('owner') r(done text) \g /dev/null
SELECT 'the switch goes on after the edit', value = 'off' FROM town.setting WHERE name = 'log';
SELECT 'both edits are in the log', count(*) = 2 FROM town.edit_log;
UPDATE town.axis SET width = 10 WHERE axis_id = 2;
SELECT 'and none that came after', count(*) = 2 FROM town.edit_log;
-- A transaction is one row of activity, with the box about all that it edited.
SELECT streetgen.set('town', 'log', 'on') \g /dev/null
BEGIN;
UPDATE town.axis SET width = 6 WHERE axis_id = 1;
UPDATE town.axis SET width = 6 WHERE axis_id = 2;
INSERT INTO town.turn_restriction (geom, from_axis, to_axis, kind) VALUES ('SRID=2154;POINT(651000 6860000)', 1, 2, 'no');
COMMIT;
UPDATE town.axis SET width = 7 WHERE axis_id = 1;
SELECT 'activity has a row a transaction', array_agg(statements ORDER BY began DESC) = '{1,3,1,1}' FROM town.activity;
SELECT 'with the tables and the box of what it edited', relations = 'axis, turn_restriction' AND ST_Equals(extent, ST_MakeEnvelope(649999, 6859999, 651001, 6865001, 2154)) AND ended > began AND who = current_user FROM town.activity WHERE statements = 3;
SELECT 'a GIS knows its type and reference', (type, srid) = ('POLYGON', 2154) FROM geometry_columns WHERE (f_table_schema, f_table_name) = ('town', 'activity');
UPDATE town.edit_log SET began = NULL;
SELECT 'of rows of an older build each statement is one', count(*) = 6 AND bool_and(statements = 1) FROM town.activity;
DELETE FROM town.edit_log WHERE edit_log_id > 2;
UPDATE town.setting SET value = 'off' WHERE name = 'log';
UPDATE town.axis SET width = 11 WHERE axis_id = 2;
SELECT 'who writes the setting himself is not logged either', count(*) = 2 FROM town.edit_log;
SELECT dblink_disconnect(name) FROM unnest('{editor,owner}'::text[]) name \g /dev/null
