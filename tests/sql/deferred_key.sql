\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- The first run of a model by clusters: without foreign keys and GiST indexes, which come at its end or before the first edit.  Each SELECT is one truth: (name, holds).
CREATE PROCEDURE public.town(model name, subjects text[] DEFAULT NULL) LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, 2154, subjects => subjects, driving_side => 'right');
    -- Kerbs that taper within sections lie a step of their coordinates aside after an edit.
    PERFORM streetgen.set(model, 'transition_length', '0');
    PERFORM set_config('streetgen.live', 'off', true);
    -- Crossed every 90 m, with short axes at each crossing, by which corners follow one axis to the next.
    EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, importance)
        SELECT 1 + i, ST_SetSRID(ST_MakeLine(ST_Point(650000 + 90 * (i / 3 %% 20) + 4 * (i %% 3 / 2), 6860000 + 70 * (i / 60) + 2 * (i %% 3 / 2)),
            CASE i %% 3 WHEN 0 THEN ST_Point(650000 + 90 * (i / 3 %% 20 + 1), 6860000 + 70 * (i / 60)) WHEN 1 THEN ST_Point(650000 + 90 * (i / 3 %% 20) + 4, 6860000 + 70 * (i / 60) + 2)
                ELSE ST_Point(650000 + 90 * (i / 3 %% 20), 6860000 + 70 * (i / 60 + 1)) END), 2154), 4 + i %% 7, 1 + i %% 4 FROM generate_series(0, 1079) i', model);
    PERFORM set_config('streetgen.live', '', true);
END $$;
CREATE FUNCTION public.made_of(model name) RETURNS TABLE(what text) LANGUAGE sql AS $$
    SELECT replace(pg_get_indexdef(indexrelid), model || '.', '') || coalesce(obj_description(indexrelid, 'pg_class'), '') FROM pg_index JOIN pg_class c ON c.oid = indrelid WHERE relnamespace = model::text::regnamespace
    UNION ALL SELECT replace(conrelid::regclass || conname || pg_get_constraintdef(k.oid), model || '.', '') || coalesce(obj_description(k.oid, 'pg_constraint'), '') FROM pg_constraint k WHERE connamespace = model::text::regnamespace
    UNION ALL SELECT relname FROM pg_class WHERE relnamespace = model::text::regnamespace $$;
CREATE FUNCTION public.alike(a name, b name) RETURNS boolean LANGUAGE sql AS $$
    SELECT NOT EXISTS ((SELECT what FROM made_of(a) EXCEPT ALL SELECT what FROM made_of(b)) UNION ALL (SELECT what FROM made_of(b) EXCEPT ALL SELECT what FROM made_of(a))) $$;
CREATE FUNCTION public.foreign_keys(model name) RETURNS bigint LANGUAGE sql AS $$ SELECT count(*) FROM pg_constraint WHERE connamespace = model::text::regnamespace AND contype = 'f' $$;
CREATE PROCEDURE public.compute(model name, many integer) LANGUAGE plpgsql AS $$
BEGIN
    FOR i IN 1 .. many LOOP
        PERFORM streetgen.generate_cluster(model);
        COMMIT;
    END LOOP;
END $$;
CALL town('whole');
CALL town('parts');
CALL town('edited');
CALL town('again');
SELECT format('COMMENT ON INDEX %I.lane_geom IS %L', name, 'lanes by place') FROM streetgen.model \gexec
SELECT streetgen.generate('whole') \g /dev/null

CALL town('busy', '{junction,signal,bridge,block,sidewalk,roundabout,object}');
INSERT INTO busy.control_point (geom, kind) SELECT ST_StartPoint(geom), 'signals' FROM busy.axis WHERE axis_id % 40 = 1;
SELECT streetgen.generate('busy') \g /dev/null
SELECT 'a first run computes what follows the one statement', (SELECT count(*) > 100 FROM busy.junction) AND (SELECT count(*) > 10 FROM busy.controller) AND (SELECT count(*) > 100 FROM busy.block);
SELECT 'without an error', NOT EXISTS (SELECT FROM streetgen.check_model('busy') WHERE severity = 'error');
SELECT 'and a second one changes none of it', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('busy', wait => true);
SELECT streetgen.drop_model('busy') \g /dev/null

CALL town('row');
UPDATE row.axis SET geom = ST_SetSRID(ST_MakeLine(ST_Point(650000 + 30 * axis_id, 6860000), ST_Point(650030 + 30 * axis_id, 6860000)), 2154);
SELECT streetgen.plan_clusters('row', 6) \g /dev/null
SELECT 'what has most beside it that is left comes first', array_agg(cluster) = '{2,4,5,1,3,6}' FROM (SELECT (streetgen.generate_cluster('row')).cluster FROM generate_series(1, 6)) c;
SELECT 'a run of an empty model is planned', streetgen.plan_clusters('parts', 6) = 6;
SELECT 'foreign keys and indexes that clusters do not look at are taken off', foreign_keys('parts') = 0 AND to_regclass('parts.lane_geom') IS NULL AND to_regclass('parts.interconnection_lane_out') IS NULL
    AND to_regclass('parts.edge_axis') IS NOT NULL AND to_regclass('parts.interconnection_node') IS NOT NULL AND to_regclass('parts.lane_pkey') IS NOT NULL;
CALL compute('parts', 2);
SELECT 'while clusters are left, clusters only', foreign_keys('parts') = 0 AND streetgen.plan_clusters('parts') = 4;
CALL compute('parts', 5);
SELECT 'a run that lacks nothing but keys goes on with them', streetgen.plan_clusters('parts', 3) = 0 AND foreign_keys('parts') = 0 AND ended = 6 AND clusters = 6 FROM streetgen.progress('parts');
SELECT 'foreign keys first, for what comes', streetgen.finish_clusters('parts') = 'foreign keys' AND foreign_keys('parts') = foreign_keys('whole') AND NOT EXISTS (SELECT FROM pg_constraint WHERE connamespace = 'parts'::regnamespace AND contype = 'f' AND convalidated);
SELECT 'each call makes some of them', streetgen.finish_clusters('parts') = 'indexes and statistics of interconnection' AND to_regclass('parts.interconnection_geom') IS NOT NULL AND to_regclass('parts.lane_geom') IS NULL;
SELECT 'and puts the foreign keys of its table in force', bool_and(convalidated = (conrelid = 'parts.interconnection'::regclass)) FROM pg_constraint WHERE connamespace = 'parts'::regnamespace AND contype = 'f';
SELECT 'one call a table', count(made) = 10 FROM (SELECT streetgen.finish_clusters('parts') AS made FROM generate_series(1, 10)) m;
SELECT 'then none is left', streetgen.finish_clusters('parts') IS NULL;
SELECT 'all foreign keys are in force', bool_and(convalidated) FROM pg_constraint WHERE connamespace = 'parts'::regnamespace;
SELECT 'all is as one run leaves it', alike('parts', 'whole') AND test.same('parts', 'whole');
SELECT 'with statistics', bool_and(reltuples > 0) FROM pg_class WHERE relnamespace = 'parts'::regnamespace AND relname IN ('node', 'edge', 'lane', 'interconnection');
SELECT 'a model with streets keeps its keys', streetgen.plan_clusters('parts', 3) = 3 AND alike('parts', 'whole');
SELECT 'nothing is left to make there', streetgen.finish_clusters('parts') IS NULL;
SELECT 'nor of a model that is none: 3F000', test.state($$SELECT streetgen.finish_clusters('nowhere')$$) = '3F000';

-- An edit in the middle: the streets follow, and the clusters that are left see it.
SELECT streetgen.plan_clusters('edited', 6) \g /dev/null
CALL compute('edited', 3);
UPDATE edited.axis SET width = 9.5 WHERE axis_id IN (SELECT axes[1] FROM edited.cluster);
SELECT 'an edit makes them first', foreign_keys('edited') = foreign_keys('whole') AND to_regclass('edited.deferred_key') IS NULL;
CALL compute('edited', 4);
SET streetgen.live = off;
UPDATE whole.axis a SET width = e.width FROM edited.axis e WHERE e.axis_id = a.axis_id AND e.width <> a.width;
RESET streetgen.live;
SELECT streetgen.generate('whole') \g /dev/null
SELECT 'and all is as one run makes it', alike('edited', 'whole') AND test.same('edited', 'whole');

-- What nobody follows may change what is there: importers make them too.
SELECT streetgen.plan_clusters('again', 6) \g /dev/null
CALL compute('again', 3);
SET streetgen.live = off;
UPDATE again.axis a SET width = w.width FROM whole.axis w WHERE w.axis_id = a.axis_id AND w.width <> a.width;
RESET streetgen.live;
SELECT 'a change that nobody follows makes them', foreign_keys('again') = foreign_keys('whole');
CALL compute('again', 4);
SELECT streetgen.generate('again') \g /dev/null
SELECT 'and one run more makes all alike', alike('again', 'whole') AND test.same('again', 'whole');

-- What is left without what it belongs to goes with the keys.
TRUNCATE again.node, again.edge, again.section_limit, again.section, again.corner, again.intersection, again.lane, again.lane_separator, again.marking, again.interconnection, again.report, again.cluster;
SELECT streetgen.plan_clusters('again', 6) \g /dev/null
CALL compute('again', 6);
CREATE TABLE there AS SELECT (SELECT count(*) FROM again.lane) AS lanes, (SELECT count(*) FROM again.interconnection) AS interconnections;
INSERT INTO again.lane (edge_id, ordinality, lane_position, side, along_axis, kind, width, axis_offset, geom, surface, method)
    SELECT -1, ordinality, lane_position, side, along_axis, kind, width, axis_offset, geom, surface, method FROM again.lane LIMIT 1;
INSERT INTO again.interconnection (node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, connecting, control, geom, method)
    SELECT node_id, max(lane_id) OVER (), lane_out, along_in, along_out, turn, angle, plausible, reason, connecting, control, geom, method FROM (SELECT i.*, l.lane_id FROM again.interconnection i, again.lane l WHERE l.edge_id = -1 LIMIT 1) i;
SELECT streetgen.generate('again') \g /dev/null
SELECT 'a run over all makes them first, and lets go what hangs on nothing', alike('again', 'whole') AND test.same('again', 'whole') AND NOT EXISTS (SELECT FROM again.lane WHERE edge_id = -1);
SELECT 'a plan for other settings begins with all of them', streetgen.plan_clusters('again', 2) = 2 AND alike('again', 'whole');

-- A session that does it all.
CALL town('called');
SELECT format('COMMENT ON INDEX called.lane_geom IS %L', 'lanes by place') \gexec
SELECT streetgen.plan_clusters('called', 5) \g /dev/null
SELECT 'not within a transaction: 2D000', test.state($$CALL streetgen.generate_clusters('called')$$) = '2D000' AND ended = 0 FROM streetgen.progress('called');
-- How far the call is comes as INFO, which every client gets.
\setenv PGDATABASE :DBNAME
\! psql -qX -c "CALL streetgen.generate_clusters('called')" 2>&1 | grep -v '^INFO:'
SELECT 'a call for all clusters makes all', ended = 5 AND alike('called', 'whole') FROM streetgen.progress('called');
UPDATE called.axis a SET width = w.width FROM whole.axis w WHERE w.axis_id = a.axis_id AND w.width <> a.width;
SELECT 'as one run does', test.same('called', 'whole');
\! psql -qX -c "CALL streetgen.generate_clusters('called')" 2>&1 | grep -v '^INFO:'
SELECT 'once more it finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('called');

-- Planned by somebody else than its owner, and edited by one who may only do that.
CREATE ROLE streetgen_key_owner ROLE CURRENT_USER;
CREATE ROLE streetgen_key_editor ROLE CURRENT_USER;
SELECT format('GRANT CREATE ON DATABASE %I TO streetgen_key_owner', current_database()) \gexec
SET ROLE streetgen_key_owner;
CALL town('owned');
SELECT streetgen.grant('owned', 'streetgen_key_editor', 'editor') \g /dev/null
RESET ROLE;
ALTER DEFAULT PRIVILEGES IN SCHEMA owned GRANT ALL ON TABLES TO streetgen_key_editor;
ALTER DEFAULT PRIVILEGES IN SCHEMA owned GRANT INSERT ON TABLES TO PUBLIC;
SELECT streetgen.plan_clusters('owned', 6) \g /dev/null
SELECT 'what is done with the rights of the owner only he may write', NOT has_table_privilege('streetgen_key_editor', 'owned.deferred_key', 'INSERT, UPDATE, DELETE, TRUNCATE, TRIGGER')
    AND has_table_privilege('streetgen_key_editor', 'owned.deferred_key', 'SELECT') AND has_table_privilege('streetgen_key_owner', 'owned.deferred_key', 'UPDATE');
CALL compute('owned', 2);
SET ROLE streetgen_key_editor;
SELECT 'an edit by a view of tables without keys is refused with a way out', state = '55006' AND hint LIKE 'Edit an axis first, %' FROM test.refusal('UPDATE owned.node_editing SET geom = ST_Translate(geom, 1, 0) WHERE node_id = 1');
UPDATE owned.axis SET width = 12 WHERE axis_id = 5;
SELECT 'which it is', test.state('UPDATE owned.node_editing SET geom = ST_Translate(geom, 1, 0) WHERE node_id = 1') = 'none';
RESET ROLE;
SELECT 'an editor''s edit makes them for the owner', foreign_keys('owned') = foreign_keys('whole') AND to_regclass('owned.deferred_key') IS NULL;
DROP OWNED BY streetgen_key_editor, streetgen_key_owner;
DROP ROLE streetgen_key_editor, streetgen_key_owner;
