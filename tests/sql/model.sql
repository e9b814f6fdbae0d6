\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Models: made, refused, set, granted, adopted, dropped.  Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.axis_state(columns text, vals text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  RETURN test.state(format('INSERT INTO model_a.axis (geom, %s) VALUES (''SRID=2154;LINESTRING(650000 6860000,650050 6860000)'', %s)',
                              columns, vals));
END $$;
CREATE FUNCTION pg_temp.line_state(line text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  RETURN test.state(format('INSERT INTO model_a.axis (geom) VALUES (%L)', line));
END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('model_a', 2154);
  PERFORM streetgen.create_model('model Z"', 2154, 3);
END $$;

SELECT 'two models are registered' AS name,
       (SELECT count(*) FROM streetgen.model WHERE name IN ('model_a', 'model Z"')) = 2 AS holds;
SELECT 'the registry knows SRID and dimension', EXISTS (SELECT FROM streetgen.model WHERE name = 'model Z"' AND srid = 2154 AND dimension = 3);
SELECT 'axes of a model of three dimensions carry Z',
       (SELECT coord_dimension = 3 FROM geometry_columns WHERE f_table_schema = 'model Z"' AND f_table_name = 'axis' AND f_geometry_column = 'geom');
SELECT 'version is the extension''s', streetgen.version() = (SELECT extversion FROM pg_extension WHERE extname = 'streetgen');

SELECT 'an existing schema is refused', test.state($q$SELECT streetgen.create_model('model_a', 2154)$q$) = '42P06';
SELECT 'an unknown SRID is refused', test.state($q$SELECT streetgen.create_model('model_b', 999999)$q$) = '22023';
SELECT 'SRID 0 is refused', test.state($q$SELECT streetgen.create_model('model_b', 0)$q$) = '22023';
SELECT 'a NULL SRID is refused', test.state($q$SELECT streetgen.create_model('model_b', NULL)$q$) <> 'none';
SELECT 'a NULL name is refused', test.state($q$SELECT streetgen.create_model(NULL, 2154)$q$) <> 'none';
SELECT 'a geographic SRID is refused', test.state($q$SELECT streetgen.create_model('model_b', 4326)$q$) = '22023';
SELECT 'feet are refused', test.state($q$SELECT streetgen.create_model('model_b', 2263)$q$) = '22023';
SELECT 'web mercator is refused', test.state($q$SELECT streetgen.create_model('model_b', 3857)$q$) = '22023';
-- Left and right change places where axes point south and west. Each of these is defined in another way: a prime meridian, another survey.
SELECT format('a mirrored reference is refused: %s, and %s is the way out', srid, unmirrored), (r).state = '22023' AND (r).said LIKE '%mirrored%' AND (r).hint LIKE format('Use EPSG:%s,%%', unmirrored)
FROM (SELECT srid, unmirrored, test.refusal(format($q$SELECT streetgen.create_model('model_b', %s)$q$, srid)) r FROM (VALUES (2065, 5221), (5513, 5514), (8352, 8353)) v(srid, unmirrored)) t;
SELECT test.as_administrator('SET track_functions = ''pl''') \g /dev/null
BEGIN;
SELECT streetgen._unmirrored(5513) \g /dev/null
SELECT 'few references are looked at for the way out', calls BETWEEN 2 AND 20 FROM pg_stat_xact_user_functions WHERE (schemaname, funcname) = ('streetgen', '_is_mirrored');
COMMIT;
SELECT test.as_administrator('RESET track_functions') \g /dev/null
SELECT 'one whose axes point west and south is turned, not mirrored', NOT streetgen._is_mirrored(2053);
SELECT 'no zone of UTM is mirrored', bool_and(NOT streetgen._is_mirrored(srid)) AND count(*) = 120 FROM (SELECT h + n AS srid FROM generate_series(1, 60) n, (VALUES (32600), (32700)) v(h)) z;
SELECT 'nor a national reference', bool_and(NOT streetgen._is_mirrored(srid)) FROM unnest('{2154,27700,28992,31370,3812,3035,5514,2056,3067,25832,2193,3006}'::integer[]) srid;
SELECT 'the refusal names the UTM zone', test.hint($q$SELECT streetgen.create_model('model_b', 3857)$q$) ~ 'UTM';
SELECT 'dimension 4 is refused', test.state($q$SELECT streetgen.create_model('model_b', 2154, 4)$q$) = '22023';
SELECT 'a refused model leaves nothing', NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = 'model_b');
SELECT 'UTM is taken', test.state($q$SELECT streetgen.create_model('model_utm', 32631)$q$) = 'none';

-- All that a schema holds: itself, tables, views, columns, types, functions, triggers; sequences and keys belong to their columns.
CREATE FUNCTION pg_temp.uncommented(schema name) RETURNS SETOF text LANGUAGE sql AS $$
  SELECT 'schema ' || nspname FROM pg_namespace WHERE nspname = schema AND obj_description(oid, 'pg_namespace') IS NULL
  UNION ALL SELECT 'relation ' || relname FROM pg_class WHERE relnamespace = quote_ident(schema)::regnamespace AND relkind IN ('r', 'v', 'm', 'p', 'f') AND obj_description(oid, 'pg_class') IS NULL
  UNION ALL SELECT format('column %s.%s', c.relname, a.attname) FROM pg_class c JOIN pg_attribute a ON a.attrelid = c.oid
    WHERE c.relnamespace = quote_ident(schema)::regnamespace AND c.relkind IN ('r', 'v', 'm', 'p', 'f', 'c') AND a.attnum > 0 AND NOT a.attisdropped AND col_description(c.oid, a.attnum) IS NULL
  -- The types of rows and arrays come with what they are made of.
  UNION ALL SELECT 'type ' || t.typname FROM pg_type t LEFT JOIN pg_class c ON c.oid = t.typrelid
    WHERE t.typnamespace = quote_ident(schema)::regnamespace AND t.typelem = 0 AND (c.oid IS NULL OR c.relkind = 'c') AND obj_description(t.oid, 'pg_type') IS NULL
  UNION ALL SELECT 'function ' || oid::regprocedure FROM pg_proc WHERE pronamespace = quote_ident(schema)::regnamespace AND obj_description(oid, 'pg_proc') IS NULL
  UNION ALL SELECT 'trigger ' || t.tgname FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid
    WHERE c.relnamespace = quote_ident(schema)::regnamespace AND NOT t.tgisinternal AND obj_description(t.oid, 'pg_trigger') IS NULL
  UNION ALL SELECT 'operator ' || oid::regoperator FROM pg_operator WHERE oprnamespace = quote_ident(schema)::regnamespace AND obj_description(oid, 'pg_operator') IS NULL $$;
SELECT format('every object of %s has a comment%s', schema, (SELECT ': ' || string_agg(u, ', ') FROM pg_temp.uncommented(schema) u)), NOT EXISTS (SELECT FROM pg_temp.uncommented(schema))
FROM unnest('{streetgen,model_a,"model Z\""}'::name[]) schema;
SELECT 'the extension has a comment', obj_description(oid, 'pg_extension') <> '' FROM pg_extension WHERE extname = 'streetgen';
SELECT 'every geometry of a model has its SRID and an index',
       NOT EXISTS (SELECT FROM geometry_columns g JOIN pg_class c ON c.relname = g.f_table_name AND c.relkind = 'r'
                     AND c.relnamespace = 'model_a'::regnamespace
                   WHERE g.f_table_schema = 'model_a' AND g.f_geometry_column <> 'source_geom'
                     AND (g.f_table_name, g.f_geometry_column) NOT IN (('edge', 'curve'), ('section_limit', 'border_line'), ('corner', 'centre'), ('report', 'geom'), ('interconnection', 'control'), ('interconnection_override', 'control'), ('turn_restriction', 'via_geom'), ('turn_restriction', 'to_geom'), ('delivered', 'cleaned'),
                       ('kerb', 'curve'), ('kerb', 'surface'), ('pedestrian_crossing', 'stripes'), ('roundabout', 'centre'), ('roundabout', 'island'), ('marking', 'free_geom'), ('marking', 'free_surface'), ('controller_override', 'approaches'))
                     AND (g.srid <> 2154 OR NOT EXISTS (
                       SELECT FROM pg_indexes i WHERE i.schemaname = 'model_a' AND i.tablename = g.f_table_name
                         AND i.indexdef LIKE '%gist (' || g.f_geometry_column || ')%')));

SELECT 'geom is all that an axis needs', pg_temp.line_state('SRID=2154;LINESTRING(650000 6860000,650050 6860000)') = 'none';
SELECT 'a width of NaN is refused', pg_temp.axis_state('width', '''NaN''') = '23514';
SELECT 'an infinite width is refused', pg_temp.axis_state('width', '''Infinity''') = '23514';
SELECT 'a width of zero is refused', pg_temp.axis_state('width', '0') = '23514';
SELECT 'a negative width is refused', pg_temp.axis_state('width', '-1') = '23514';
SELECT 'a width over 200 m is refused', pg_temp.axis_state('width', '200.1') = '23514';
SELECT 'a width of 200 m is taken', pg_temp.axis_state('width', '200') = 'none';
SELECT 'a width_end of NaN is refused', pg_temp.axis_state('width_end', '''NaN''') = '23514';
SELECT 'a speed of NaN is refused', pg_temp.axis_state('speed', '''NaN''') = '23514';
SELECT 'a speed of zero is refused', pg_temp.axis_state('speed', '0') = '23514';
SELECT 'an infinite radius is refused', pg_temp.axis_state('radius', '''Infinity''') = '23514';
SELECT 'a radius of NaN is refused', pg_temp.axis_state('radius', '''NaN''') = '23514';
SELECT 'a negative radius is refused', pg_temp.axis_state('radius', '-0.1') = '23514';
SELECT 'a radius of zero is taken: no arc', pg_temp.axis_state('radius', '0') = 'none';
SELECT 'no lanes are refused', pg_temp.axis_state('lane_count', '0') = '23514';
SELECT 'importance zero is refused', pg_temp.axis_state('importance', '0') = '23514';
SELECT 'an unknown direction is refused', pg_temp.axis_state('direction', '''backwards''') = '23514';

SELECT 'an empty line is refused', pg_temp.line_state('SRID=2154;LINESTRING EMPTY') = '23514';
SELECT 'a line of no length is refused', pg_temp.line_state('SRID=2154;LINESTRING(650000 6860000,650000 6860000)') = '23514';
SELECT 'a NULL line is refused', test.state('INSERT INTO model_a.axis (geom) VALUES (NULL)') = '23502';
SELECT 'another SRID is refused', pg_temp.line_state('SRID=32631;LINESTRING(0 0,1 1)') = '22023';
SELECT 'a missing SRID is refused or filled in', pg_temp.line_state('LINESTRING(650000 6860000,650001 6860000)') IN ('22023', 'none');
SELECT 'a curve is refused', pg_temp.line_state('SRID=2154;CIRCULARSTRING(0 0,1 1,2 0)') = '22023';
SELECT 'a multi line is refused', pg_temp.line_state('SRID=2154;MULTILINESTRING((0 0,1 1),(2 2,3 3))') = '22023';
SELECT 'a polygon is refused', pg_temp.line_state('SRID=2154;POLYGON((0 0,1 0,1 1,0 0))') = '22023';
SELECT 'a measure is refused', pg_temp.line_state('SRID=2154;LINESTRING M(0 0 1,1 1 2)') = '22023';
-- Bytes of LINESTRING(0 0, NaN 1), LINESTRING(NaN 0, 1 1) and LINESTRING(0 0, Infinity 1) in SRID 2154.
SELECT 'a last vertex of NaN is refused',
       pg_temp.line_state('01020000206A0800000200000000000000000000000000000000000000000000000000F87F000000000000F03F') = '23514';
SELECT 'a first vertex of NaN is refused',
       pg_temp.line_state('01020000206A08000002000000000000000000F87F0000000000000000000000000000F03F000000000000F03F') = '23514';
SELECT 'an infinite vertex is refused',
       pg_temp.line_state('01020000206A0800000200000000000000000000000000000000000000000000000000F07F000000000000F03F') = '23514';

SELECT 'a setting is taken', test.state($q$SELECT streetgen.set('model_a', 'tolerance', '1')$q$) = 'none';
SELECT 'a setting is set', (SELECT value FROM streetgen.setting('model_a') WHERE name = 'tolerance') = '1';
SELECT 'models have their own settings', (SELECT value FROM streetgen.setting('model Z"') WHERE name = 'tolerance') = '0.5';
SELECT 'an unknown setting is refused', test.state($q$SELECT streetgen.set('model_a', 'no such', '1')$q$) = '22023';
SELECT 'a setting of NaN is refused', test.state($q$SELECT streetgen.set('model_a', 'tolerance', 'NaN')$q$) = '22023';
SELECT 'a setting out of range is refused', test.state($q$SELECT streetgen.set('model_a', 'tolerance', '-1')$q$) = '22023';
SELECT 'a setting that is no number is refused', test.state($q$SELECT streetgen.set('model_a', 'tolerance', 'wide')$q$) = '22023';
SELECT 'a NULL setting is refused', test.state($q$SELECT streetgen.set('model_a', 'tolerance', NULL)$q$) <> 'none';
SELECT 'max_width_per_lane may be NULL', test.state($q$SELECT streetgen.set('model_a', 'max_width_per_lane', NULL)$q$) = 'none';
SELECT 'an unknown word is refused', test.state($q$SELECT streetgen.set('model_a', 'crossing', 'under')$q$) = '22023';
SELECT 'radii by importance are read', test.state($q$SELECT streetgen.set('model_a', 'radius_by_importance', '{"1": 10, "3": null}')$q$) = 'none';
SELECT 'radii that are no numbers are refused', test.state($q$SELECT streetgen.set('model_a', 'radius_by_importance', '{"1": "wide"}')$q$) = '22023';
SELECT 'radii that are no object are refused', test.state($q$SELECT streetgen.set('model_a', 'radius_by_importance', '[1]')$q$) = '22023';
SELECT 'a radius of NaN by importance is refused', test.state($q$SELECT streetgen.set('model_a', 'radius_by_importance', '{"1": "NaN"}')$q$) = '22023';
SELECT 'a model that is not there is refused', test.state($q$SELECT streetgen.set('no such', 'tolerance', '1')$q$) = '3F000';
SELECT 'the settings of a model that is not there are refused', test.state($q$SELECT * FROM streetgen.setting('no such')$q$) <> 'none';

-- Rights.
DO $$ BEGIN
  CREATE ROLE streetgen_test_reader ROLE CURRENT_USER;
  CREATE ROLE streetgen_test_editor ROLE CURRENT_USER;
  PERFORM streetgen."grant"('model_a', 'streetgen_test_reader', 'reader');
  PERFORM streetgen."grant"('model_a', 'streetgen_test_editor', 'editor');
END $$;
SELECT 'an unknown role is refused with a hint: ' || quote_literal(role), (r).state = '42704' AND (r).hint <> '' FROM unnest('{"",no such}'::text[]) role, LATERAL (SELECT test.refusal(format($q$SELECT streetgen."grant"('model_a', %L, 'reader')$q$, role)) AS r) s;
SELECT 'an unknown kind of right is refused', test.state($q$SELECT streetgen."grant"('model_a', 'streetgen_test_reader', 'owner')$q$) = '22023';
SELECT 'a reader reads all', has_table_privilege('streetgen_test_reader', 'model_a.edge', 'SELECT')
       AND has_table_privilege('streetgen_test_reader', 'model_a.setting', 'SELECT');
SELECT 'a reader writes nothing', NOT has_table_privilege('streetgen_test_reader', 'model_a.axis', 'INSERT, UPDATE, DELETE');
SELECT 'an editor edits axes', has_table_privilege('streetgen_test_editor', 'model_a.axis', 'INSERT')
       AND has_table_privilege('streetgen_test_editor', 'model_a.axis', 'UPDATE')
       AND has_table_privilege('streetgen_test_editor', 'model_a.axis', 'DELETE');
SELECT 'an editor decides by hand', has_table_privilege('streetgen_test_editor', 'model_a.lane_override', 'INSERT')
       AND has_table_privilege('streetgen_test_editor', 'model_a.lane_override', 'DELETE');
SELECT 'an editor writes no derived table', NOT has_table_privilege('streetgen_test_editor', 'model_a.section', 'INSERT, UPDATE, DELETE');
SET ROLE streetgen_test_editor;
INSERT INTO model_a.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6860000,650050 6860000)');
SELECT 'an editor inserts an axis', count(*) > 0 FROM model_a.axis;
SELECT 'an editor sets nothing', test.state($q$SELECT streetgen.set('model_a', 'tolerance', '1')$q$) = '42501';
SELECT 'an editor does not generate', test.state($q$SELECT streetgen.generate('model_a')$q$) = '42501';
SELECT 'an editor does not drop', test.state($q$SELECT streetgen.drop_model('model_a')$q$) = '42501';
SELECT 'an editor writes no registry', test.state($q$SELECT streetgen._register_model('model_a', 4326, 3)$q$) = '42501';
SELECT 'an editor checks a model', test.state($q$SELECT streetgen.check_model('model_a')$q$) = 'none';
SELECT 'an editor writes no registry by hand', test.state($q$INSERT INTO streetgen.model VALUES ('x', 2154, 2, '0')$q$) = '42501';
-- What a caller calls pg_namespace is not what the registry asks.
CREATE TEMPORARY TABLE pg_namespace AS SELECT oid, nspname, (SELECT oid FROM pg_roles WHERE rolname = current_user) AS nspowner FROM pg_catalog.pg_namespace;
SELECT 'an editor writes no registry by a table of its own', test.state($q$SELECT streetgen._register_model('model_a', 4326, 3)$q$) = '42501';
DELETE FROM pg_temp.pg_namespace;
SELECT streetgen._forget_models() \g /dev/null
DROP TABLE pg_temp.pg_namespace;
SELECT 'nor takes models out of it', count(*) = 1 FROM streetgen.model WHERE name = 'model_a' AND srid = 2154;
SET ROLE streetgen_test_reader;
SELECT 'a reader reads an axis', test.state('SELECT count(*) FROM model_a.axis') = 'none';
SELECT 'a reader deletes none', test.state('DELETE FROM model_a.axis') = '42501';
SELECT 'who was granted nothing is told so, not what was tried: ' || call, (r).state = '42501' AND (r).said = 'role "streetgen_test_reader" may not read model "model_utm"' AND (r).hint LIKE '%grant(''model_utm'', ''streetgen_test_reader'', ''reader'')%'
  FROM unnest(ARRAY['setting(''model_utm'')', 'summary(''model_utm'')', 'check_model(''model_utm'')', 'svg(''model_utm'')', 'cluster(''model_utm'', 1)', 'progress(''model_utm'')', 'set_transition(''model_utm'', 1)']) call,
  LATERAL (SELECT test.refusal('SELECT * FROM streetgen.' || call) AS r) s;
SELECT 'who may not make schemas is told so', r.state = '42501' AND r.said LIKE 'role "streetgen_test_reader" may not make models%' AND r.hint LIKE 'GRANT CREATE ON DATABASE %' FROM test.refusal($q$SELECT streetgen.create_model('model_b', 2154)$q$) r;
RESET ROLE;
-- Rights are set, and taken back.
CREATE FUNCTION pg_temp.rights(role text) RETURNS text LANGUAGE sql AS $$
  SELECT coalesce(string_agg(DISTINCT privilege_type, ' ' ORDER BY privilege_type), 'none') FROM (
    SELECT (aclexplode(relacl)).* FROM pg_class WHERE relnamespace = 'model_a'::regnamespace
    UNION ALL SELECT (aclexplode(attacl)).* FROM pg_attribute JOIN pg_class c ON c.oid = attrelid WHERE relnamespace = 'model_a'::regnamespace
    UNION ALL SELECT (aclexplode(nspacl)).* FROM pg_namespace WHERE nspname = 'model_a') a
  WHERE grantee = CASE role WHEN 'public' THEN 0 ELSE role::regrole::oid END $$;
GRANT UPDATE (value) ON model_a.setting TO streetgen_test_editor;
GRANT CREATE ON SCHEMA model_a TO streetgen_test_editor;
SELECT streetgen.grant('model_a', 'streetgen_test_editor', 'reader') \g /dev/null
SELECT 'an editor who becomes a reader keeps no right to write: ' || pg_temp.rights('streetgen_test_editor'), pg_temp.rights('streetgen_test_editor') = 'SELECT USAGE';
SET ROLE streetgen_test_editor;
SELECT 'nor edits an axis, by its table or by its view', test.state('UPDATE model_a.axis SET width = 5') = '42501' AND test.state('UPDATE model_a.axis_editing SET width = 5') = '42501';
SELECT 'and cannot give back rights by itself', test.state($q$SELECT streetgen.grant('model_a', 'streetgen_test_editor', 'editor')$q$) = '42501'
  AND test.state($q$SELECT streetgen.revoke('model_a', 'streetgen_test_reader')$q$) = '42501';
RESET ROLE;
SELECT streetgen.grant('model_a', 'streetgen_test_editor', 'editor') \g /dev/null
SELECT 'a reader who becomes an editor edits', has_table_privilege('streetgen_test_editor', 'model_a.axis', 'UPDATE') AND has_table_privilege('streetgen_test_editor', 'model_a.axis_editing', 'UPDATE');
SELECT streetgen.revoke('model_a', 'streetgen_test_editor') \g /dev/null
SELECT 'who lost all rights holds none: ' || pg_temp.rights('streetgen_test_editor'), pg_temp.rights('streetgen_test_editor') = 'none';
SELECT 'nor has one by another way', NOT has_schema_privilege('streetgen_test_editor', 'model_a', 'USAGE') AND NOT has_table_privilege('streetgen_test_editor', 'model_a.edit_log', 'SELECT');
SELECT 'others keep theirs', pg_temp.rights('streetgen_test_reader') = 'SELECT USAGE';
SELECT streetgen.grant('model_a', 'public', 'editor') \g /dev/null
SELECT streetgen.revoke('model_a', 'public') \g /dev/null
SELECT 'what everybody had is taken back: ' || pg_temp.rights('public'), pg_temp.rights('public') = 'none';
SELECT 'the owner keeps all rights, and is told so: ' || call, r.state = '22023' AND r.said LIKE 'role %owns model "model_a"%' AND r.hint <> ''
  FROM unnest(ARRAY['streetgen.grant(''model_a'', current_user, ''reader'')', 'streetgen.revoke(''model_a'', current_user)']) call, LATERAL test.refusal('SELECT ' || call) r;
SELECT 'and still has them', has_table_privilege(current_user, 'model_a.axis', 'TRUNCATE') AND (SELECT relacl IS NULL OR relacl::text LIKE '%' || current_user || '=arwdDxt%' FROM pg_class WHERE oid = 'model_a.axis'::regclass);
SELECT 'an unknown role loses nothing, and is told so', test.state($q$SELECT streetgen.revoke('model_a', 'no such')$q$) = '42704';
SELECT 'a model that is not there is told', test.state($q$SELECT streetgen.revoke('no such', 'streetgen_test_reader')$q$) = '3F000';
SELECT 'a model that is not there is told with a way out', r.hint LIKE '%streetgen.model%create_model(''no such'',%' FROM test.refusal($q$SELECT streetgen.summary('no such')$q$) r;

-- Adopt and drop.
DO $$ BEGIN
  ALTER SCHEMA model_utm RENAME TO model_renamed;
END $$;
SELECT 'an edit of a renamed model asks for it: ' || live, r.state = '3F000' AND r.hint LIKE '%adopt_model(''model_renamed'')%'
  FROM unnest('{on,off}'::text[]) live, LATERAL test.refusal(format('SET LOCAL streetgen.live = %s; DELETE FROM model_renamed.axis', live)) r;
SELECT 'a renamed model is to be adopted', (r).state = '3F000' AND (r).hint LIKE '%adopt_model(''model_renamed'')%' FROM (SELECT test.refusal($q$SELECT streetgen.summary('model_renamed')$q$) AS r) s;
DO $$ BEGIN
  PERFORM streetgen.adopt_model('model_renamed');
END $$;
SELECT 'a renamed model is adopted', EXISTS (SELECT FROM streetgen.model WHERE name = 'model_renamed' AND srid = 32631 AND dimension = 2);
CREATE SCHEMA half;
CREATE TABLE half.axis (geom geometry);
CREATE TABLE half.setting (name text);
SELECT 'tables that are no model are 3F000 and named', test.state($q$SELECT streetgen.adopt_model('half')$q$) = '3F000' AND test.hint($q$SELECT streetgen.adopt_model('half')$q$) LIKE '%node, edge%';
SELECT 'and are not registered', NOT EXISTS (SELECT FROM streetgen.model WHERE name = 'half');
SELECT 'an unknown model is 3F000: ' || call, test.state('SELECT * FROM streetgen.' || call) = '3F000' FROM unnest(ARRAY['setting(''no such'')', 'summary(''no such'')', 'check_model(''no such'')', 'svg(''no such'')', 'adopt_model(''no such'')']) call;

-- Styles that QGIS keeps for the layers of a model go with it; a table of somebody else is not touched.
CREATE TABLE public.layer_styles (f_table_catalog name, f_table_schema name, f_table_name name, stylename text);
INSERT INTO public.layer_styles SELECT current_database(), m, 'axis', 'axis' FROM unnest('{model_a,styled}'::name[]) m;
SELECT streetgen.create_model('styled', 2154), streetgen.drop_model('styled') \g /dev/null
SELECT 'styles go with their model', array_agg(f_table_schema) = '{model_a}' FROM public.layer_styles;
INSERT INTO public.layer_styles VALUES (current_database(), 'styled', 'axis', 'axis');
SELECT test.as_administrator('ALTER TABLE public.layer_styles OWNER TO streetgen_test_reader') \g /dev/null
SELECT streetgen.create_model('styled', 2154), streetgen.drop_model('styled') \g /dev/null
SELECT 'but not from a table of somebody else', count(*) = 2 FROM public.layer_styles;
DROP TABLE public.layer_styles;
CREATE TABLE public.layer_styles (what text);
SELECT 'nor from one that is something else', test.state($q$SELECT streetgen.create_model('styled', 2154), streetgen.drop_model('styled')$q$) = 'none';
DROP TABLE public.layer_styles;

-- The extension goes and comes: tables stay, views come back with their comments and readers.
DO $$ BEGIN PERFORM streetgen.generate('model_a'); END $$;
CREATE TABLE before AS SELECT test.content('model_a') AS content;
GRANT SELECT ON "model Z""".axis TO PUBLIC;
-- Fewer triggers are made, and asked, at each edit; the count only falls. Rules of drawing, results of checks,
-- routes, lanes of classes, footways, kerbs on them and tracks have some, which no edit of a street asks.
SELECT streetgen.create_model('few', 2154) \g /dev/null
SELECT 'a model has few triggers', count(*) <= CASE WHEN 'object' = ANY (streetgen._subjects('few')) THEN 270 ELSE 169 END
  FROM pg_trigger t JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = 'few'::regnamespace AND relname NOT IN
      ('symbol_rule', 'check_result') AND relname NOT IN ('axis_route', 'footway', 'footway_kerb', 'rail_track',
      'street_area') AND (relname, tgname) <> ('axis_class', 'by_hand') AND NOT tgisinternal;
SELECT streetgen.drop_model('few') \g /dev/null
-- A role whose name is to be quoted.
CREATE ROLE "Anna of streetgen_test" ROLE CURRENT_USER;
SELECT format('GRANT CREATE ON DATABASE %I TO "Anna of streetgen_test"', current_database()) \gexec
SET ROLE "Anna of streetgen_test";
SELECT streetgen.create_model('owned', 2154), streetgen.set('owned', 'log', 'on'), streetgen.grant('owned', 'streetgen_test_editor', 'editor') \g /dev/null
CREATE TABLE owned.ran_as (who name);
CREATE FUNCTION owned.tell() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN INSERT INTO owned.ran_as VALUES (current_user); RETURN OLD; END';
CREATE TRIGGER tell BEFORE DELETE ON owned.followed FOR EACH ROW EXECUTE FUNCTION owned.tell();
INSERT INTO owned.followed VALUES ('no_table', '{}');
RESET ROLE;
SELECT 'DROP EXTENSION names the models in the way', test.state($$SELECT test.as_administrator('DROP EXTENSION streetgen')$$) = '2BP01';
SELECT test.as_administrator('DROP EXTENSION streetgen CASCADE') \g /dev/null
SELECT 'it takes no table', (SELECT count(*) > 0 FROM model_a.axis) AND to_regclass('model_a.section') IS NOT NULL AND to_regclass('model_a.axis_used') IS NULL;
SELECT test.as_administrator('CREATE EXTENSION streetgen') \g /dev/null
DO $$ BEGIN PERFORM streetgen.adopt_model(m) FROM unnest('{model_a,"model Z\"",model_renamed}'::name[]) m; END $$;
-- A superuser brings back what is another role's, tables of a newer build too.
DROP TABLE owned.edit_log, owned.cluster, owned.kerb_point_override CASCADE;
SELECT streetgen.adopt_model('owned') \g /dev/null
SELECT 'what its owner hung on a table runs with his rights', array_agg(who) = '{Anna of streetgen_test}' AND current_user <> 'Anna of streetgen_test' FROM owned.ran_as;
SELECT 'what adopt_model makes is its owner''s', bool_and(relowner = '"Anna of streetgen_test"'::regrole) FROM pg_class WHERE relnamespace = 'owned'::regnamespace;
SET ROLE streetgen_test_editor;
INSERT INTO owned.axis (geom) VALUES ('SRID=2154;LINESTRING(650000 6860000,650050 6860000)');
INSERT INTO owned.kerb_point_editing (geom) VALUES ('SRID=2154;POINT(650020 6860004)');
RESET ROLE;
SELECT 'editors edit it', (SELECT count(*) = 1 FROM owned.edge WHERE width = 8) AND (SELECT count(*) = 2 FROM owned.edit_log);
SET ROLE "Anna of streetgen_test";
SELECT 'its owner computes it', test.state($q$SELECT streetgen.generate('owned'), streetgen.plan_clusters('owned')$q$) = 'none';
SELECT 'and adopts and drops it', test.state($q$SELECT streetgen.adopt_model('owned'), streetgen.drop_model('owned')$q$) = 'none';
RESET ROLE;
DROP OWNED BY "Anna of streetgen_test";
DROP ROLE "Anna of streetgen_test";
SELECT 'adopted models have their views', test.state('SELECT * FROM model_a.axis_used, model_a.intersection_group') = 'none';
SELECT 'with comments: ' || m, NOT EXISTS (SELECT FROM pg_temp.uncommented(m)) FROM unnest('{model_a,"model Z\""}'::name[]) m;
SELECT 'and readers', has_table_privilege('streetgen_test_reader', 'model_a.axis_used', 'SELECT') AND NOT has_table_privilege('streetgen_test_reader', 'model_renamed.axis_used', 'SELECT');
SELECT 'of ' || view, has_table_privilege('streetgen_test_reader', 'model_a.' || view, 'SELECT') AND NOT has_table_privilege('public', 'model_a.' || view, 'SELECT')
       AND has_table_privilege('public', '"model Z""".' || view, 'SELECT') FROM unnest('{setting_used,axis_used,intersection_group,conflict,roadway,axis_editing,node_editing,override_place,edit_log}'::text[]) view;
SELECT 'generate finds all as it was', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('model_a');
SELECT 'the content is the same', count(*) > 0 AND NOT EXISTS ((TABLE before EXCEPT ALL SELECT test.content('model_a')) UNION ALL (SELECT test.content('model_a') EXCEPT ALL TABLE before)) FROM before;
SELECT 'an invalid surface is refused by its table', test.state($q$UPDATE model_a.section SET surface = 'SRID=2154;MULTIPOLYGON(((0 0,2 2,2 0,0 2,0 0)))'$q$) = '23514';
SELECT 'a schema that is no model is not adopted', test.state($q$SELECT streetgen.adopt_model('public')$q$) <> 'none';
-- A name that ends the quotes of a function.
SELECT streetgen.create_model('a$body$b$function$c$$', 2154, 3, (SELECT array_agg(subject) FROM streetgen._subject())), streetgen.create_design('a$body$b$function$c$$') \g /dev/null
INSERT INTO "a$body$b$function$c$$".axis (geom, width) VALUES ('SRID=2154;LINESTRING Z(650000 6860000 0, 650100 6860000 0)', 7);
CREATE TABLE named_line AS SELECT 1 AS id, 'SRID=2154;LINESTRING Z(650000 6861000 0, 650060 6861000 0)'::geometry AS geom;
SELECT count(*) FROM streetgen.follow('a$body$b$function$c$$', 'named_line', '{"source_ref": "id"}') \g /dev/null
UPDATE named_line SET geom = ST_Translate(geom, 0, 1);
SELECT 'a model may have any name', count(*) = 2 FROM "a$body$b$function$c$$".section;
SELECT streetgen.drop_model('a$body$b$function$c$$') \g /dev/null
DROP TABLE named_line;
SELECT streetgen.create_model('in_way', 2154) \g /dev/null
CREATE VIEW in_way.kerb AS SELECT 1 AS mine;
SELECT 'a view by the name of a table is told, with the way out', state = '42809' AND said = 'in_way.kerb stands where a table of the model belongs' AND hint LIKE 'Rename it%in_way.kerb RENAME TO%' FROM test.refusal($q$SELECT streetgen.adopt_model('in_way')$q$);
ALTER TABLE in_way.kerb RENAME TO my_kerb;
SELECT 'renamed it stays in the schema of the model', test.state($q$SELECT streetgen.adopt_model('in_way')$q$) = 'none' AND (SELECT mine = 1 FROM in_way.my_kerb);
SELECT streetgen.drop_model('in_way') \g /dev/null
DO $$ BEGIN
  PERFORM streetgen.drop_model('model_a');
  PERFORM streetgen.drop_model('model Z"');
  PERFORM streetgen.drop_model('model_renamed');
  DROP ROLE streetgen_test_reader;
  DROP ROLE streetgen_test_editor;
END $$;
SELECT 'dropped models are gone', NOT EXISTS (SELECT FROM pg_namespace WHERE nspname IN ('model_a', 'model Z"', 'model_renamed'))
       AND NOT EXISTS (SELECT FROM streetgen.model WHERE name IN ('model_a', 'model Z"', 'model_renamed'));
