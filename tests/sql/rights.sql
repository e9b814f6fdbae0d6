\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Who may what: an owner, an editor, a reader and a role without rights, at every table, view and function of a model with all subjects and a design.  (name, holds)
CREATE ROLE rights_owner ROLE CURRENT_USER; CREATE ROLE rights_editor ROLE CURRENT_USER; CREATE ROLE rights_reader ROLE CURRENT_USER; CREATE ROLE rights_nobody ROLE CURRENT_USER;
DO $$ BEGIN EXECUTE format('GRANT CREATE ON DATABASE %I TO rights_owner', current_database()); END $$;
SET ROLE rights_owner;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, 3, subjects => '{all}', driving_side => 'right'), streetgen.create_design('town'), streetgen.create_traffic('town'); END $$;
INSERT INTO town.axis (axis_id, geom, width, lane_count, importance, kind) SELECT n, ST_Force3D(ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000)), 7, 2, 2, 'residential' FROM (VALUES (1, 'LINESTRING(-80 0,0 0)'), (2, 'LINESTRING(0 0,80 0)'),
  (3, 'LINESTRING(0 -80,0 0)'), (4, 'LINESTRING(0 0,0 80)'), (6, 'LINESTRING(80 0,95 15)'), (7, 'LINESTRING(95 15,110 0)'), (8, 'LINESTRING(110 0,95 -15)'), (9, 'LINESTRING(95 -15,80 0)')) v(n, line);
INSERT INTO town.control_point (kind, geom) VALUES ('signals', 'SRID=2154;POINT(650000 6860000)');
INSERT INTO town.street_object (type, axis_id, abscissa, axis_offset) VALUES ('bench', 1, 20, 5);
INSERT INTO town.car (axis_id, abscissa, lane_position, along_axis) VALUES (1, 20, 2, true);
INSERT INTO town.placement_rule (type, every) VALUES ('lamp', 20), ('parking_bay', 30);
INSERT INTO town.turn_restriction (from_axis, to_axis, kind, geom) VALUES (1, 4, 'no', 'SRID=2154;POINT(650000 6860000)');
INSERT INTO town.design_node (name, kind, importance, geom, by_hand) VALUES ('A', 'city', 2000, 'SRID=2154;POINT(660500 6861000)', true);
DO $$ BEGIN PERFORM streetgen.generate('town', wait => true), streetgen.grant('town', 'rights_editor', 'editor'), streetgen.grant('town', 'rights_reader', 'reader'); END $$;
SELECT 'a plain owner has every subject', count(*) > 10 AND bool_and(to_regclass('town.' || relation) IS NOT NULL) FROM streetgen._computed_table();

-- Tables and views.
CREATE VIEW town.relation AS SELECT oid, relname, relkind, relname = ANY (streetgen._edited_tables('town')) OR relname LIKE '%\_editing' AS edited FROM pg_class WHERE relnamespace = 'town'::regnamespace AND relkind IN ('r', 'v') AND relname <> 'relation';
SELECT 'an editor reads all, and writes input alone', count(*) > 60 AND bool_and(has_table_privilege('rights_editor', oid, 'SELECT') AND has_table_privilege('rights_editor', oid, 'INSERT') = (edited OR relname = 'check_result')
  AND has_table_privilege('rights_editor', oid, 'UPDATE') = edited AND has_table_privilege('rights_editor', oid, 'DELETE') = (edited OR relname IN ('open_conflict', 'check_result')) AND NOT has_table_privilege('rights_editor', oid, 'TRUNCATE, REFERENCES, TRIGGER')) FROM town.relation;
SELECT 'a reader reads all, and writes nothing', bool_and(has_table_privilege('rights_reader', oid, 'SELECT') AND NOT has_table_privilege('rights_reader', oid, 'INSERT, UPDATE, DELETE, TRUNCATE, REFERENCES, TRIGGER')) FROM town.relation;
SELECT 'others do neither', bool_and(NOT has_table_privilege('rights_nobody', oid, 'SELECT, INSERT, UPDATE, DELETE, TRUNCATE, REFERENCES, TRIGGER')) AND NOT has_schema_privilege('rights_nobody', 'town', 'USAGE, CREATE')
  AND NOT has_schema_privilege('rights_editor', 'town', 'CREATE') AND NOT has_schema_privilege('rights_reader', 'town', 'CREATE') FROM town.relation;
SELECT 'who reads a view reads it with his own rights', bool_and('security_invoker=true' = ANY (reloptions)) FROM pg_class WHERE oid IN (SELECT oid FROM town.relation WHERE relkind = 'v');
CREATE FUNCTION pg_temp.told(OUT said text) LANGUAGE plpgsql AS $$ DECLARE r record; BEGIN
  FOR r IN SELECT oid::regclass AS name FROM town.relation LOOP
    said := concat_ws('; ', said, nullif(test.said(format('SELECT count(t::text) FROM %s t', r.name)), ''));
  END LOOP;
  said := nullif(said, '');
END $$;
GRANT SELECT ON town.relation TO rights_editor, rights_reader;
SELECT 'the owner reads each', pg_temp.told() IS NULL;
SET ROLE rights_reader;
SELECT 'a reader reads each', pg_temp.told() IS NULL;
SET ROLE rights_editor;
SELECT 'an editor reads each', pg_temp.told() IS NULL;

-- Functions.  What runs with the rights of the owner, and how anything finds another function.
RESET ROLE;
CREATE VIEW public.routine AS SELECT p.oid, p.oid::regprocedure::text AS name, prosecdef, prosrc, prosqlbody, lanname, prokind, proacl, pronamespace::regnamespace::text AS home,
  (SELECT substr(c, 13) FROM unnest(proconfig) c WHERE c LIKE 'search_path=%') AS path FROM pg_proc p JOIN pg_language l ON l.oid = prolang WHERE pronamespace IN ('streetgen'::regnamespace, 'town'::regnamespace);
SELECT 'functions find others in the system, in their model and beside PostGIS alone, temporary ones last', string_agg(name, ', ' ORDER BY name) = 'streetgen._use_model(name), streetgen.generate_clusters(name)' FROM public.routine WHERE lanname NOT IN ('c', 'internal') AND prosqlbody IS NULL
  AND coalesce(path, '') <> 'pg_catalog, pg_temp' AND coalesce(path, '') NOT IN (SELECT format(own, nspname) FROM unnest(CASE home WHEN 'streetgen' THEN '{"pg_catalog, %I, pg_temp"}' ELSE '{"pg_catalog, %I, pg_temp","town, %I, pg_temp"}'::text[] END) own, pg_extension JOIN pg_namespace n ON n.oid = extnamespace WHERE extname = 'postgis');
SELECT 'with the rights of a superuser run two, which see the system alone', array_agg(name ORDER BY name) = '{streetgen._forget_models(),"streetgen._register_model(name,integer,integer)"}' AND bool_and(path = 'pg_catalog, pg_temp') FROM public.routine WHERE home = 'streetgen' AND prosecdef;
SELECT 'with those of the owner none but looks for functions of others first', count(*) > 20 AND bool_and(prosrc ~ E'^\\s*(#variable_conflict use_column\\s*)?DECLARE\\s+only_own_functions constant boolean := streetgen._only_own_functions\\(''town''\\);') FROM public.routine WHERE home = 'town' AND prosecdef;
SELECT 'nobody else may call these but for the locks of objects: ' || role, coalesce(string_agg(split_part(name, '(', 1), ' ' ORDER BY name), '') = may FROM (VALUES ('rights_reader', ''), ('rights_nobody', ''), ('rights_editor', 'town._begin_ruled_edit town._hold_borders town._lock_beside')) v(role, may)
  LEFT JOIN public.routine ON home = 'town' AND prosecdef AND has_function_privilege(role, oid, 'EXECUTE') GROUP BY role, may;
SELECT 'temporary tables are named as such', coalesce(string_agg(DISTINCT name, ', '), '') = '' FROM public.routine, regexp_matches(prosrc, 'CREATE TEMPORARY (?:TABLE|VIEW) (_\w+)', 'g') made
  WHERE prosrc ~ format('(FROM|JOIN|INTO|UPDATE|ON|USING|DROP TABLE|ANALYZE|,)\s+%s\M', made[1]);
-- Casts of format(…) take names of tables and functions of models; what stands in a row, or comes as an argument, becomes a name of the catalogue here alone.
SELECT 'text becomes the name of a function, table or type in known places alone', string_agg(DISTINCT split_part(name, '(', 1), ' ' ORDER BY split_part(name, '(', 1)) = 'streetgen._adopt_source streetgen._function_named streetgen._relation_named' FROM public.routine, regexp_matches(prosrc, '(\w+)::reg(?:class|proc|type|oper)|to_reg(?:class|proc|type|oper)\w*\((\w[\w.]*) *[,)|]', 'g') m
  WHERE home = 'streetgen' AND coalesce(m[1], m[2]) !~* 'oid$|relid$';

-- Each public function of a model, called by each role: no more happens than that.
CREATE TABLE public.call AS SELECT p.oid::regprocedure::text AS name, proname, format('SELECT streetgen.%I(''town''%s)', proname, (SELECT string_agg(format(', NULL::%s', format_type(t, NULL)), '' ORDER BY n)
    FROM unnest(proargtypes) WITH ORDINALITY a(t, n) WHERE n > 1 AND n <= pronargs - pronargdefaults)) AS statement FROM pg_proc p
  WHERE pronamespace = 'streetgen'::regnamespace AND proname !~ '^_' AND prokind = 'f' AND proargtypes[0] = 'name'::regtype AND (proargnames[1] = 'model' OR proname = 'adopt_model')
  -- Nothing for NULL.
  AND NOT (proisstrict AND pronargs - pronargdefaults > 1);
GRANT SELECT ON public.call TO PUBLIC;
CREATE TABLE public.before AS SELECT * FROM test.content('town');
CREATE FUNCTION pg_temp.states() RETURNS TABLE (name text, state text) LANGUAGE sql AS $$ SELECT proname::text, test.state(statement) FROM public.call $$;
SET ROLE rights_nobody;
SELECT 'who was granted nothing gets nothing by any function of a model', count(*) > 40 AND bool_and(state IN ('42501', '22004')) FROM pg_temp.states();
SELECT 'and is told by each how to come by it', count(*) > 30 AND bool_and(r.hint <> '') FROM public.call, test.refusal(statement) r WHERE r.state = '42501';
RESET ROLE;
GRANT USAGE ON SCHEMA town TO rights_nobody;
SET ROLE rights_nobody;
SELECT 'who sees the schema alone is told the same, and not that it holds no model', count(*) > 30 AND bool_and(r.state = '42501' AND r.hint <> '') FROM public.call, test.refusal(statement) r WHERE r.state <> '22004';
RESET ROLE;
REVOKE USAGE ON SCHEMA town FROM rights_nobody;
SET ROLE rights_reader;
CREATE TEMPORARY TABLE by_reader AS SELECT * FROM pg_temp.states();
SELECT 'a reader calls what reads', string_agg(name, ' ' ORDER BY name) = 'activity cells check_model driving_side export_cityjson export_dxf export_gltf export_lanelet2 export_layer export_opendrive export_opensidewalks export_symuvia export_tiles fired_events hill_shade leaders learn_classes link_conflicts progress road_mesh roundabout_candidates setting sheet simulate subject summary svg walk_links' FROM by_reader WHERE state = 'none';
SELECT 'what computes or changes settings is for the owner', '{create_design,design,drop_design,drop_model,finish_clusters,generate,generate_cluster,import_osm,plan_clusters,set,switch_subject}' <@ array_agg(name) FROM by_reader WHERE state = '42501';
GRANT SELECT ON by_reader TO rights_editor;
SET ROLE rights_editor;
CREATE TEMPORARY TABLE by_editor AS SELECT * FROM pg_temp.states();
SELECT 'an editor calls the same, fits streets, cuts axes, makes roundabouts, and records checks', (SELECT array_agg(name ORDER BY name) = '{accept_mend,cut_at_junctions,fit,make_roundabout,record_check}' FROM (TABLE by_editor EXCEPT TABLE by_reader) e) AND (SELECT array_agg(name ORDER BY name) = '{accept_mend,cut_at_junctions,fit,make_roundabout,record_check}' FROM (TABLE by_reader EXCEPT TABLE by_editor) r);
RESET ROLE;
SELECT 'none of them changed anything', NOT EXISTS ((SELECT * FROM test.content('town') EXCEPT TABLE public.before) UNION ALL (TABLE public.before EXCEPT SELECT * FROM test.content('town')));

-- Hostile rows: an editor writes them wherever text goes, then everybody does what he does.  Who runs them is seen.
CREATE TABLE public.gained (who name);
GRANT INSERT ON public.gained TO PUBLIC;
CREATE FUNCTION public.gain() RETURNS text LANGUAGE sql AS $$ INSERT INTO public.gained SELECT current_user WHERE current_user NOT LIKE 'rights_editor' RETURNING 'gained' $$;
CREATE TABLE public.hostile AS SELECT * FROM unnest(ARRAY['public.gain()', $$'||public.gain()||'$$, $$"'); SELECT public.gain(); --%s%I%1$s{model}$1 $body$ $$]) value;
CREATE TABLE public.writable AS SELECT r.oid::regclass AS relation, attname AS attribute, atttypid::regtype::text AS type,
  (SELECT attname FROM pg_attribute WHERE attrelid = r.oid AND attnum = 1) AS key FROM town.relation r JOIN pg_attribute ON attrelid = r.oid AND attnum > 0 AND NOT attisdropped
  WHERE edited AND atttypid IN ('text'::regtype, 'text[]'::regtype, 'name'::regtype, 'jsonb'::regtype, 'xml'::regtype, 'character varying'::regtype);
GRANT SELECT ON public.hostile, public.writable TO PUBLIC;
SET ROLE rights_editor;
CREATE FUNCTION pg_temp.gain() RETURNS text LANGUAGE sql AS 'SELECT public.gain()';
-- Each in a row of a column in turn; the last one stays, another one in each column.
CREATE FUNCTION pg_temp.write_hostile(OUT written bigint, OUT refused bigint, OUT states text) LANGUAGE plpgsql AS $$ DECLARE w record; state text; all_states text[]; BEGIN
  PERFORM set_config('streetgen.live', 'off', true);
  written := 0; refused := 0;
  FOR w IN SELECT * FROM public.writable, public.hostile ORDER BY relation, attribute, md5(attribute || value) LOOP
    state := test.state(format('UPDATE %1$s SET %2$I = %3$L::%4$s WHERE %5$I = (SELECT max(%5$I) FROM %1$s)', w.relation, w.attribute, CASE w.type WHEN 'text[]' THEN ARRAY[w.value]::text WHEN 'jsonb' THEN to_jsonb(w.value)::text ELSE w.value END, w.type, w.key));
    IF state = 'none' THEN written := written + 1; ELSE refused := refused + 1; all_states := all_states || state; END IF;
  END LOOP;
  states := (SELECT string_agg(DISTINCT s, ' ' ORDER BY s) FROM unnest(all_states) s);
END $$;
SELECT 'hostile rows are written, or refused for what they are', written > 50 AND refused > 50 AND states !~ '42601|42703|42704|42883|XX' FROM pg_temp.write_hostile();
CREATE FUNCTION pg_temp.edit_all(OUT states text) LANGUAGE plpgsql AS $$ BEGIN
  states := (SELECT string_agg(DISTINCT state, ' ') FROM (SELECT test.state(statement) AS state FROM (SELECT oid::regclass AS relation, (SELECT attname FROM pg_attribute WHERE attrelid = oid AND attnum = 1) AS key FROM town.relation WHERE edited) r,
    LATERAL (VALUES (format('UPDATE %1$s SET %2$I = %2$I WHERE %2$I = (SELECT max(%2$I) FROM %1$s)', relation, key)), (format('INSERT INTO %1$s SELECT (jsonb_populate_record(t, %2$L::jsonb)).* FROM %1$s t LIMIT 1', relation, json_build_object(key, -1))),
      (format('DELETE FROM %1$s WHERE %2$I = %3$L', relation, key, '-1'))) v(statement)) s);
END $$;
SELECT 'edits beside them are done, or refused for what they are', states LIKE '%none%' AND states !~ '42601|42703|42704|42883|XX' FROM pg_temp.edit_all();
SET ROLE rights_owner;
SELECT 'so is what the owner does', bool_and(state IN ('none', '22023')) AND 'none' = ANY (array_agg(state)) FROM (SELECT DISTINCT test.state(s) AS state FROM unnest(ARRAY['SELECT streetgen.generate(''town'', wait => true)', 'SELECT streetgen.adopt_model(''town'')', 'UPDATE town.axis SET width = width + 0.1']
  || ARRAY(SELECT statement FROM public.call WHERE proname IN ('check_model', 'summary', 'svg', 'export_cityjson', 'export_dxf', 'export_gltf', 'export_lanelet2', 'export_layer', 'export_opendrive', 'export_symuvia', 'export_tiles', 'road_mesh', 'roundabout_candidates', 'design'))) s) t;
SET ROLE rights_reader;
SELECT 'and what a reader reads', bool_and(state = 'none') FROM (SELECT DISTINCT state FROM pg_temp.states() WHERE name IN (SELECT name FROM by_reader WHERE state = 'none')) t;
RESET ROLE;
SELECT 'nobody ran what they say', count(*) = 0 FROM public.gained;

-- Functions of others beside PostGIS, by names of the system, whose arguments fit better than those of the system do.
CREATE FUNCTION pg_temp.edit() RETURNS text LANGUAGE sql AS $$ SELECT test.state(format('UPDATE town.axis SET width = %s WHERE axis_id = 1', 6 + random())) $$;
CREATE FUNCTION pg_temp.place() RETURNS text LANGUAGE sql AS $$ SELECT test.state('INSERT INTO town.street_object_editing (type, geom) SELECT ''bench'', ST_Translate(ST_StartPoint(ST_Force2D(geom)), 30 * random(), 5) FROM town.axis WHERE axis_id = 1') $$;
GRANT USAGE, CREATE ON SCHEMA town TO rights_nobody;
SET ROLE rights_editor;
SELECT 'an editor lends no rights of the owner to who may make functions in the model', (r).state = '42501' AND (r).said = 'schema "town" is open to functions of rights_nobody' AND (r).hint LIKE 'REVOKE CREATE ON SCHEMA town FROM rights_nobody%'
  FROM (SELECT test.refusal('UPDATE town.axis SET width = 6 WHERE axis_id = 1') AS r) t;
-- By a name of the system, of a function of the model and of a type of PostGIS.
SET ROLE rights_nobody;
CREATE FUNCTION town.concat_ws(text, name) RETURNS text LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN $2; END $$;
CREATE FUNCTION town._reach(integer[]) RETURNS bigint LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN 1; END $$;
CREATE DOMAIN town.geometry AS public.geometry CHECK (public.gain() IS NULL);
RESET ROLE;
REVOKE USAGE, CREATE ON SCHEMA town FROM rights_nobody;
SET ROLE rights_owner;
SELECT 'and nobody edits where functions or types of others stand in the model', (r).state = '42501'
    AND (r).said LIKE '% in schema "town": town._reach(integer[]) of role rights_nobody, town.concat_ws(text,name) of role rights_nobody, type town.geometry of role rights_nobody'
  FROM (SELECT test.refusal('UPDATE town.axis SET width = 6 WHERE axis_id = 1') AS r) t;
RESET ROLE;
DROP FUNCTION town.concat_ws(text, name), town._reach(integer[]);
DROP DOMAIN town.geometry;
GRANT CREATE ON SCHEMA public TO rights_nobody;
SET ROLE rights_owner;
SELECT 'where others may make some, the owner edits', pg_temp.edit() = 'none' AND pg_temp.place() = 'none';
SET ROLE rights_reader;
SELECT 'and a reader reads', test.state($$SELECT streetgen.svg('town')$$) = 'none';
SET ROLE rights_editor;
SELECT 'but an editor would lend them the rights of the owner', (r).state = '42501' AND (r).said = 'schema "public" is open to functions of rights_nobody' AND (r).hint LIKE 'REVOKE CREATE ON SCHEMA public FROM rights_nobody%'
  FROM (SELECT test.refusal('UPDATE town.axis SET width = 6 WHERE axis_id = 1') AS r) t;
SELECT 'so no function with these rights goes on: ' || name, test.state(statement) = '42501' FROM (VALUES ('objects', 'DELETE FROM town.street_object'), ('rules', 'UPDATE town.placement_rule SET every = 30'), ('types', 'UPDATE town.object_type SET distance_least = 1'),
  ('free places', 'DELETE FROM town.free_place'), ('overrides', 'INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) VALUES (1, 4, 3, ''SRID=2154;POINT(650000 6860000)'')'), ('controls', 'DELETE FROM town.control_point'),
  ('a design', 'DELETE FROM town.design_node_editing'), ('locks', 'SELECT town._begin_ruled_edit()'), ('places', 'SELECT town._lock_beside(NULL, false)'), ('borders', 'SELECT town._hold_borders(NULL, false)')) v(name, statement);
SET ROLE rights_nobody;
CREATE FUNCTION public.less(float8, integer) RETURNS boolean LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN float8lt($1, $2::float8); END $$;
CREATE OPERATOR public.< (FUNCTION = public.less, LEFTARG = float8, RIGHTARG = integer);
CREATE FUNCTION public.st_lineinterpolatepoint(geometry, numeric) RETURNS geometry LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN ST_LineInterpolatePoint($1, $2::float8); END $$;
CREATE FUNCTION public.concat_ws(text, name) RETURNS text LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN $2; END $$;
RESET ROLE;
REVOKE CREATE ON SCHEMA public FROM rights_nobody;
CREATE FUNCTION pg_temp.refused() RETURNS boolean LANGUAGE sql AS $$ SELECT pg_temp.edit() = '42501' AND pg_temp.place() = '42501' AND bool_and(r.state = '42501' AND r.said LIKE '%operator %<(double precision,integer) of role rights_nobody%' AND r.said LIKE '%st_lineinterpolatepoint%' AND r.said LIKE '%concat_ws%')
  FROM unnest(ARRAY['UPDATE town.axis SET width = 6 WHERE axis_id = 1', 'SELECT streetgen.generate(''town'')', 'SELECT streetgen.svg(''town'')', 'SELECT streetgen.check_model(''town'')']) s, test.refusal(s) r $$;
SET ROLE rights_owner;
SELECT 'where some are the owner is told', pg_temp.refused();
SELECT 'also before he makes a model', test.state($$SELECT streetgen.create_model('other', 2154)$$) = '42501';
SET ROLE rights_editor;
SELECT 'so is an editor', pg_temp.refused();
RESET ROLE;
SELECT test.as_administrator('ALTER FUNCTION public.less(float8, integer) OWNER TO rights_owner') \g /dev/null
SELECT test.as_administrator('ALTER FUNCTION public.st_lineinterpolatepoint(geometry, numeric) OWNER TO rights_owner') \g /dev/null
DROP OPERATOR public.< (float8, integer);
DROP FUNCTION public.concat_ws(text, name);
SET ROLE rights_editor;
SELECT 'those of the owner are his own', pg_temp.edit() = 'none';
RESET ROLE;
DROP FUNCTION public.less(float8, integer), public.st_lineinterpolatepoint(geometry, numeric);

-- Temporary objects by names of the system, of the model and of its own temporary tables.
SET ROLE rights_editor;
CREATE FUNCTION pg_temp.less(float8, integer) RETURNS boolean LANGUAGE plpgsql AS $$ BEGIN PERFORM public.gain(); RETURN float8lt($1, $2::float8); END $$;
CREATE OPERATOR pg_temp.< (FUNCTION = pg_temp.less, LEFTARG = float8, RIGHTARG = integer);
CREATE FUNCTION pg_temp.st_lineinterpolatepoint(geometry, numeric) RETURNS geometry LANGUAGE sql AS 'SELECT public.gain()::geometry';
CREATE DOMAIN pg_temp.geometry AS text CHECK (public.gain() IS NULL);
CREATE TEMPORARY VIEW axis AS SELECT public.gain();
CREATE TEMPORARY VIEW pg_class AS SELECT public.gain() AS relname, 1::oid AS oid;
CREATE TEMPORARY VIEW spatial_ref_sys AS SELECT public.gain();
CREATE TEMPORARY VIEW _crossing AS SELECT public.gain();
SELECT 'temporary ones change nothing', pg_temp.edit() = 'none' AND pg_temp.place() = 'none' AND test.state('UPDATE town.design_node_editing SET importance = 2001') = 'none';
DROP VIEW axis, pg_class, spatial_ref_sys, _crossing;

-- What the owner hangs on his model, and who runs it: whoever reads, draws or checks.
RESET ROLE;
CREATE TABLE public.ran (who name);
GRANT INSERT ON public.ran TO PUBLIC;
SET ROLE rights_owner;
CREATE SCHEMA rights_place;
CREATE FUNCTION rights_place.tell() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN INSERT INTO public.ran VALUES (current_user); RETURN NULL; END $$;
CREATE TRIGGER tell AFTER INSERT OR DELETE ON town.check_result EXECUTE FUNCTION rights_place.tell();
RESET ROLE;
SELECT streetgen.record_check('town') AS recorded \gset
SELECT 'who has the rights of the owner records a check with these alone', :recorded > 0 AND :recorded = (SELECT count(*) FROM town.check_result) AND (SELECT array_agg(DISTINCT who) = '{rights_owner}' FROM public.ran);
SET ROLE rights_owner;
CREATE CONSTRAINT TRIGGER later AFTER INSERT ON town.check_result DEFERRABLE INITIALLY DEFERRED FOR EACH ROW EXECUTE FUNCTION rights_place.tell();
RESET ROLE;
SELECT 'and nothing is left for the end of the transaction', state = '42501' AND said LIKE '%deferred trigger%' FROM test.refusal($$SELECT streetgen.record_check('town')$$);
SET ROLE rights_owner;
DROP TRIGGER tell ON town.check_result;
DROP TRIGGER later ON town.check_result;
CREATE FUNCTION rights_place.holds(integer) RETURNS boolean LANGUAGE plpgsql IMMUTABLE AS $$ BEGIN IF current_user <> 'rights_owner' THEN RAISE EXCEPTION 'ran as %', current_user USING ERRCODE = 'P0099'; END IF; RETURN true; END $$;
GRANT USAGE ON SCHEMA rights_place TO rights_reader;
ALTER TABLE town.symbol_rule RENAME TO kept_rule;
CREATE VIEW town.symbol_rule AS SELECT * FROM town.kept_rule WHERE rights_place.holds(1) OR num_nonnulls(theme) > 0;
INSERT INTO town.kept_rule (theme, layer, place, fill) VALUES ('street', 'section', 2, '#ff0000');
GRANT SELECT ON town.symbol_rule TO rights_reader;
RESET ROLE;
CREATE FUNCTION pg_temp.told_of_view() RETURNS boolean LANGUAGE sql AS $$ SELECT count(*) > 5 AND bool_and(r.state = '42809' AND r.said = 'town.symbol_rule stands where a table of the model belongs' AND r.hint <> '')
  FROM public.call c, test.refusal(statement) r WHERE proname IN ('svg', 'sheet', 'setting', 'summary', 'check_model', 'export_layer', 'export_gltf', 'export_cityjson') $$;
SELECT 'no function reads a view that stands for a table', pg_temp.told_of_view();
SET ROLE rights_reader;
SELECT 'nor does it for a reader', pg_temp.told_of_view();
SET ROLE rights_owner;
DROP VIEW town.symbol_rule;
ALTER TABLE town.kept_rule RENAME TO symbol_rule;
DELETE FROM town.symbol_rule;
CREATE TABLE rights_place.house (geom public.geometry(Polygon, 2154));
INSERT INTO rights_place.house VALUES (ST_MakeEnvelope(650020, 6859970, 650040, 6859980, 2154));
CREATE INDEX house_there ON rights_place.house (geom) WHERE rights_place.holds(1);
GRANT SELECT ON rights_place.house TO rights_reader;
DO $$ BEGIN PERFORM streetgen.set('town', 'building_table', 'rights_place.house'); END $$;
SELECT 'the owner sees his buildings', streetgen.svg('town', scale => 1000) LIKE '%class="building"%';
CREATE FUNCTION pg_temp.sees() RETURNS boolean LANGUAGE sql AS $$ SELECT streetgen.svg('town', scale => 1000) LIKE '%class="building"%' $$;
RESET ROLE;
SELECT 'a function of an index runs for nobody else', NOT pg_temp.sees();
SET ROLE rights_reader;
SELECT 'nor for a reader', NOT pg_temp.sees();
SET ROLE rights_owner;
DROP INDEX rights_place.house_there;
SET ROLE rights_reader;
SELECT 'a plain table is read by readers', pg_temp.sees();
RESET ROLE;
SELECT 'and by a superuser after SET ROLE alone', pg_temp.sees() <> rolsuper FROM pg_roles WHERE rolname = current_user;
SET ROLE rights_owner;
DO $$ BEGIN PERFORM streetgen.set('town', 'building_table', 'none'); END $$;
DROP SCHEMA rights_place CASCADE;
RESET ROLE;
DROP TABLE public.ran;

-- At the end.
RESET ROLE;
SELECT 'nobody ran anything with the rights of the owner, nor with more', count(*) = 0 FROM public.gained;
SELECT 'nobody is a superuser, and nobody is a member of another role', bool_and(NOT (rolsuper OR rolcreaterole OR rolcreatedb OR rolbypassrls OR rolreplication)) AND NOT bool_or(EXISTS (SELECT FROM pg_auth_members m WHERE m.member = r.oid)) FROM pg_roles r WHERE rolname LIKE 'rights\_%';
SELECT 'all is the owner''s', bool_and(relowner = 'rights_owner'::regrole) FROM pg_class WHERE relnamespace = 'town'::regnamespace;
SELECT 'and the functions of the model', bool_and(proowner = 'rights_owner'::regrole) FROM pg_proc WHERE pronamespace = 'town'::regnamespace;
SELECT 'rights are what they were', bool_and(has_table_privilege('rights_editor', oid, 'UPDATE') = edited AND NOT has_table_privilege('rights_reader', oid, 'UPDATE')) FROM town.relation;
DROP TABLE public.call, public.before, public.gained, public.hostile, public.writable;
DROP VIEW public.routine;
DROP FUNCTION public.gain() CASCADE;
DO $$ BEGIN PERFORM streetgen.drop_model('town'); END $$;
DROP OWNED BY rights_owner, rights_editor, rights_reader, rights_nobody;
DROP ROLE rights_owner, rights_editor, rights_reader, rights_nobody;
