\set ECHO none
\ir shared/truths.sql
-- A GIS shows all that the server says of an edit that it refuses: of every edit view, and every table that an editor may write, this is at most one line of CONTEXT.
SELECT streetgen.create_model('town', 2154, subjects => '{all}'), streetgen.create_model('plan', 2154, dimension => 3) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, lane_count, kind, level, direction, sidewalk_left) SELECT i, ST_SetSRID(ST_Translate(line::geometry, 650000, 6860000), 2154), 7, lanes, kind, level, direction, 2
FROM (VALUES (1, 'LINESTRING(0 0,100 0)', 2, 'primary', 0, 'both'), (2, 'LINESTRING(100 0,200 0)', 2, 'primary', 0, 'both'), (3, 'LINESTRING(100 0,130 50,100 90)', 2, 'primary', 0, 'both'), (4, 'LINESTRING(150 -50,150 60)', 2, 'primary', 1, 'both'),
  (5, 'LINESTRING(200 0,200 -80)', 2, 'primary', 0, 'both'), (6, 'LINESTRING(200 -80,100 -80,100 0)', 2, 'primary', 0, 'both'),
  (11, 'LINESTRING(400 0,700 0)', 2, 'motorway', 0, 'direct'), (12, 'LINESTRING(700 0,1000 0)', 2, 'motorway', 0, 'direct'), (13, 'LINESTRING(500 -60,650 -8,700 0)', 1, 'motorway_link', 0, 'direct')) v(i, line, lanes, kind, level, direction);
INSERT INTO town.axis (axis_id, geom, width, lane_count, direction) SELECT 20 + i, ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_Point(650500 + 20 * cos(radians(90 * i + 15 * j)), 6860300 + 20 * sin(radians(90 * i + 15 * j))) FROM generate_series(0, 6) j)), 2154), 7, 1, 'direct'
  FROM generate_series(0, 3) i;
INSERT INTO town.axis (axis_id, geom, width) SELECT 30 + i, ST_SetSRID(ST_MakeLine(ST_StartPoint(geom), ST_Translate(ST_Scale(ST_Translate(ST_StartPoint(geom), -650500, -6860300), 5, 5), 650500, 6860300)), 2154), 7 FROM generate_series(0, 3) i JOIN town.axis ON axis_id = 20 + i;
INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 'signals');
INSERT INTO town.turn_restriction (geom, from_axis, to_axis, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 1, 3, 'no');
INSERT INTO town.kerb_point_editing (geom) VALUES ('SRID=2154;POINT(650020 6860004)');
INSERT INTO town.street_object_editing (type, geom) VALUES ('bench', 'SRID=2154;POINT(650050 6860005)');
INSERT INTO town.pedestrian_crossing_editing (geom) VALUES ('SRID=2154;POINT(650060 6860000)');
INSERT INTO town.parking_bay_editing (geom) VALUES ('SRID=2154;POINT(650030 6860004)');
INSERT INTO town.height_editing (geom, height) VALUES ('SRID=2154;POINT(650020 6860000)', 3);
INSERT INTO town.placement_rule (type, along, every) VALUES ('tree', 'border', 80);
DELETE FROM town.street_object WHERE street_object_id = (SELECT max(street_object_id) FROM town.street_object);
DO $$ BEGIN PERFORM test.as_administrator('CREATE EXTENSION IF NOT EXISTS postgis_raster'), streetgen.create_design('plan'); END $$;
CREATE ROLE refused_editor ROLE CURRENT_USER;
DO $$ BEGIN PERFORM streetgen.grant('town', 'refused_editor', 'editor'), streetgen.grant('plan', 'refused_editor', 'editor'); END $$;

-- What a client sees that sends the statement itself.
CREATE FUNCTION public.shown(statement text, OUT state text, OUT said text, OUT hint text, OUT context text) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  RAISE SQLSTATE 'SG000';
EXCEPTION WHEN SQLSTATE 'SG000' THEN state := 'none';
WHEN OTHERS THEN
  GET STACKED DIAGNOSTICS state = RETURNED_SQLSTATE, said = MESSAGE_TEXT, hint = PG_EXCEPTION_HINT, context = PG_EXCEPTION_CONTEXT;
  context := btrim(split_part(context, format('SQL statement "%s"', statement), 1), E'\n');
END $$;
-- Of the model with a design what the other one has not.
CREATE TABLE public.written AS SELECT c.oid::regclass::text AS relation, attname, first_value(attname) OVER (PARTITION BY c.oid ORDER BY attnum) AS key, atttypid::regtype::text AS type, has_table_privilege('refused_editor', c.oid, 'INSERT') AS inserts, has_column_privilege('refused_editor', c.oid, attnum, 'UPDATE') AS updates
  FROM pg_class c JOIN pg_attribute a ON attrelid = c.oid
  WHERE (relnamespace = 'town'::regnamespace OR relnamespace = 'plan'::regnamespace AND relname NOT IN (SELECT relname FROM pg_class WHERE relnamespace = 'town'::regnamespace)) AND relkind IN ('r', 'v') AND attnum > 0 AND NOT attisdropped;
DELETE FROM public.written WHERE NOT inserts AND NOT updates;
CREATE TABLE public.odd (type text, value text);
INSERT INTO public.odd VALUES ('bigint', '-5'), ('integer', '-70'), ('double precision', '''NaN'''), ('text', '''no such'''), ('geometry', '''SRID=2154;POINT(NaN 1)'''), ('geometry', '''SRID=2154;LINESTRING(0 0,NaN 1)''');
-- Of each column a value that it can hardly have and NULL, of each table a row that is there twice.
CREATE TABLE public.tried AS SELECT relation, statement, NULL::text AS state, NULL::text AS said, NULL::text AS hint, NULL::text AS context FROM (
  SELECT relation, format('UPDATE %s SET %I = %s WHERE %4$I = (SELECT min(%4$I) FROM %1$s)', relation, attname, value, key) AS statement FROM public.written JOIN public.odd USING (type) WHERE updates
  UNION SELECT relation, format('UPDATE %s SET %I = NULL WHERE %3$I = (SELECT min(%3$I) FROM %1$s)', relation, attname, key) FROM public.written WHERE updates
  UNION SELECT relation, format('INSERT INTO %s (%I) VALUES (NULL)', relation, attname) FROM public.written WHERE inserts
  UNION SELECT relation, format('INSERT INTO %s (%I) VALUES (%s)', relation, attname, value) FROM public.written JOIN public.odd USING (type) WHERE inserts
  UNION SELECT relation, format('INSERT INTO %s SELECT * FROM %1$s LIMIT 1', relation) FROM public.written WHERE inserts) s;
GRANT SELECT, UPDATE ON public.tried TO refused_editor;
SET ROLE refused_editor;
SET client_min_messages = error;
SELECT format('UPDATE public.tried SET (state, said, hint, context) = (SELECT s.state, s.said, s.hint, s.context FROM public.shown(statement) s) WHERE statement = %L', statement) FROM public.tried \gexec
RESET client_min_messages;
RESET ROLE;
SELECT format('an edit of %s is refused', relation), count(*) FILTER (WHERE state <> 'none') > 0 FROM public.tried GROUP BY relation ORDER BY relation;
SELECT format('an edit of %s is refused in at most a line of CONTEXT', relation), bool_and(context NOT LIKE E'%\n%') FROM public.tried WHERE state <> 'none' GROUP BY relation ORDER BY relation;
-- But what the type of a column refuses before a trigger sees it, and a key of a table that is there twice or not at all.
SELECT format('an edit of %s that is refused names a way out', relation), bool_and(hint <> '') FROM public.tried WHERE state NOT IN ('none', '23503', '23505') AND said !~ '^(Geometry type|Column has Z)' GROUP BY relation ORDER BY relation;
SELECT 'NULL is told as NULL', NOT EXISTS (SELECT FROM public.tried WHERE statement ~ 'NULL' AND said ~ 'NaN');
SELECT 'none is refused by an error of the server or of SQL', NOT EXISTS (SELECT FROM public.tried WHERE state ~ '^(XX|42)');
-- A word that a column does not know is refused, and the words that it takes are told.
SELECT format('%s.%s takes none but its words', relation, attribute), state = '23514' AND detail ~ words
  FROM (VALUES ('object_type', 'symbol', 'circle, .* or triangle'), ('object_type', 'geometry', 'point or line'), ('placement_rule', 'along', 'border, axis, arm, corner or lane'), ('placement_rule', 'side', 'left, right, both or alternating'), ('placement_rule', 'turn', 'left'), ('street_object', 'placed_by', 'user, import or rule')) v(relation, attribute, words),
  test.refusal(format('UPDATE town.%I SET %I = ''donut''', relation, attribute));
SELECT 'a rule takes no type that is none', state = '22023' AND hint ~ 'object_type' FROM test.refusal($$UPDATE town.placement_rule SET type = 'donut'$$);
SELECT 'a rule for all kinds is no finding', count(*) = 0 FROM streetgen.check_model('town') WHERE rule ~ 'kind that no street';
UPDATE town.placement_rule SET kind = '{primary,donut}';
UPDATE town.axis SET roundabout_tag = 'donut' WHERE axis_id = (SELECT min(axis_id) FROM town.axis);
SELECT 'a tag of a roundabout that is not known is found', count(*) = 1 FROM streetgen.check_model('town') WHERE rule ~ 'roundabout tag';
UPDATE town.axis SET roundabout_tag = NULL;
SELECT 'a rule for a kind that no street has is found', count(*) = 1 FROM streetgen.check_model('town') WHERE rule ~ 'kind that no street';
UPDATE town.placement_rule SET kind = NULL;
SELECT 'the angle of a bay says both ranges', detail = 'Expected 0, or 20 to 160 degrees.' FROM test.refusal('UPDATE town.parking_bay_editing SET angle = 10');
REVOKE ALL ON public.tried FROM refused_editor;

-- What is typed into a column that an editor may write is stored, or refused.
CREATE FUNCTION public.shown_after(relation text, key name, attribute name, value text, OUT state text, OUT before text, OUT typed text, OUT after text) LANGUAGE plpgsql AS $$
DECLARE
  id text;
BEGIN
  EXECUTE format('SELECT %1$I::text, %2$I::text, (%3$s)::text FROM %4$s ORDER BY %1$I LIMIT 1', key, attribute, value, relation) INTO id, before, typed;
  EXECUTE format('UPDATE %s SET %I = %s WHERE %I = %L', relation, attribute, value, key, id);
  EXECUTE format('SELECT max(%I::text) FROM %s WHERE %I = %L', attribute, relation, key, id) INTO after;
  RAISE SQLSTATE 'SG000';
EXCEPTION WHEN SQLSTATE 'SG000' THEN state := 'none';
WHEN OTHERS THEN state := SQLSTATE;
END $$;
CREATE TABLE public.fitting (type text, value text);
INSERT INTO public.fitting VALUES ('bigint', '%1$I + 1'), ('integer', '%1$I + 1'), ('integer', '%1$I - 1'), ('double precision', '%1$I + 0.5'), ('double precision', '%1$I * 0.9'), ('double precision[]', 'ARRAY(SELECT d + 1 FROM unnest(%1$I) d)'), ('boolean', 'NOT %1$I'),
  ('geometry', 'ST_Translate(%1$I, 0.2, 0.1)'), ('text', '''x'''), ('text', '''left'''), ('text', '''end'''), ('text', '''stop'''), ('text', '''mini'''), ('text', '''island'''), ('text', '''allowed'''), ('text', '''border'''), ('text', '''absolute'''), ('text', '''direct'''), ('text', '''paper''');
CREATE TABLE public.typed AS SELECT relation, key, attname, format(value, attname) AS value, NULL::text AS state, NULL::text AS before, NULL::text AS typed, NULL::text AS after FROM public.written JOIN public.fitting USING (type) WHERE updates AND relation LIKE '%editing';
GRANT SELECT, UPDATE ON public.typed TO refused_editor;
GRANT SELECT ON public.written TO refused_editor;
SET ROLE refused_editor;
SET client_min_messages = warning;
UPDATE public.typed t SET (state, before, typed, after) = (SELECT s.state, s.before, s.typed, s.after FROM public.shown_after(relation, key, attname, value) s);
RESET client_min_messages;
SELECT format('what is typed into %s is stored or refused', relation), bool_and(state <> 'none' OR typed IS NOT DISTINCT FROM before OR after IS DISTINCT FROM before) FROM public.typed GROUP BY relation HAVING count(before) > 0 ORDER BY relation;
SELECT format('a row of %s may be sent back as it is', relation), test.state(format('UPDATE %1$s SET %2$s WHERE %3$I = (SELECT min(%3$I) FROM %1$s)', relation, string_agg(format('%1$I = %1$I', attname), ', '), min(key))) = 'none' FROM public.written WHERE updates AND relation LIKE '%editing' GROUP BY relation ORDER BY relation;
RESET ROLE;
-- NULL takes back what was decided by hand, in each edit view that shows it.
CREATE FUNCTION public.taken_back(relation text, attribute name, value text, place text, OUT decided boolean, OUT by_hand boolean, OUT before text, OUT after text) LANGUAGE plpgsql AS $$
DECLARE
  key name := (SELECT attname FROM pg_attribute WHERE attrelid = relation::regclass AND attnum = 1);
  id text;
BEGIN
  EXECUTE format('SELECT %1$I::text, %2$I::text FROM %3$s v WHERE NOT by_hand AND %4$s ORDER BY 1 LIMIT 1', key, attribute, relation, place) INTO id, before;
  EXECUTE format('UPDATE %1$s SET %2$I = %3$s WHERE %4$I = %5$L', relation, attribute, value, key, id);
  EXECUTE format('SELECT by_hand AND %1$I::text <> %2$L FROM %3$s WHERE %4$I = %5$L', attribute, before, relation, key, id) INTO decided;
  EXECUTE format('UPDATE %1$s SET %2$I = NULL WHERE %4$I = %5$L', relation, attribute, value, key, id);
  EXECUTE format('SELECT by_hand, %1$I::text FROM %3$s WHERE %4$I = %5$L', attribute, before, relation, key, id) INTO by_hand, after;
  EXECUTE format('UPDATE %1$s SET %2$I = NULL WHERE %4$I = %5$L', relation, attribute, value, key, id);
END $$;
CREATE FUNCTION public.lane_after(OUT after text, VARIADIC edits text[]) LANGUAGE plpgsql AS $$
DECLARE
  lane bigint := (SELECT min(lane_id) FROM town.lane_editing v WHERE NOT by_hand AND NOT along_axis AND NOT both_ways AND (SELECT kind FROM town.lane WHERE lane_id = v.lane_id) = 'general');
  edit text;
BEGIN
  FOREACH edit IN ARRAY edits LOOP
    EXECUTE format('UPDATE town.lane_editing SET %s WHERE lane_id = %s', edit, lane);
  END LOOP;
  SELECT concat_ws(' ', along_axis, both_ways, by_hand) FROM town.lane_editing WHERE lane_id = lane INTO after;
  DELETE FROM town.lane_editing WHERE lane_id = lane;
END $$;
SET ROLE refused_editor;
SELECT format('%s.%s: NULL takes it back', name, attribute), b.decided AND NOT b.by_hand AND b.before = b.after
  FROM (VALUES ('section_limit', 'abscissa', 'abscissa + 3', 'which = ''start'' AND abscissa > 5'), ('corner', 'radius', 'radius + 1', 'radius BETWEEN 2 AND 20'), ('road_arc', 'radius', 'radius / 2', 'radius > 1'), ('lane', 'width', 'width - 1', '(SELECT kind FROM town.lane WHERE lane_id = v.lane_id) = ''general'''),
    ('lane', 'along_axis', 'NOT along_axis', '(SELECT kind FROM town.lane WHERE lane_id = v.lane_id) = ''general'''), ('lane', 'both_ways', 'NOT both_ways', '(SELECT kind FROM town.lane WHERE lane_id = v.lane_id) = ''general'''), ('sidewalk', 'width', 'width + 1', 'true'), ('lane_adjacency', 'change', '''forbidden''', 'change = ''allowed'''), ('junction', 'kind', '''stop''', 'kind NOT IN (''end'', ''continuation'', ''stop'')'),
    ('junction_edge', 'inside', 'true', 'NOT inside AND ST_Length(geom) < 110'), ('controller', 'program', 'CASE program WHEN ''paper'' THEN ''phases'' ELSE ''paper'' END', 'true'), ('controller', 'cycle', 'cycle + 10', 'true'), ('controller', 'start_offset', 'start_offset + 5', 'true'), ('controller', 'durations', 'ARRAY(SELECT d + 1 FROM unnest(durations) d)', 'true'),
    ('ramp', 'tangent', 'tangent + 10', 'true'), ('ramp', 'length', 'length + 10', 'true'), ('overpass', 'clearance', 'clearance + 1', 'true'), ('interconnection', 'connecting', 'NOT connecting', 'true'), ('block', 'kind', 'CASE kind WHEN ''block'' THEN ''island'' ELSE ''block'' END', 'NOT ST_IsEmpty(geom)')) v(name, attribute, value, place),
  LATERAL public.taken_back(format('town.%s_editing', name), attribute, value, place) b;
-- What is emptied takes nothing else back, and what is typed beside it stays.
SELECT 'the direction of a lane, ' || name, after = wanted FROM (
  SELECT 'emptied where both use it', public.lane_after('both_ways = true', 'along_axis = NULL'), 't t t' UNION ALL SELECT 'emptied beside both ways typed', public.lane_after('along_axis = NULL, both_ways = true'), 't t t'
  UNION ALL SELECT 'typed, and both ways emptied later', public.lane_after('along_axis = true', 'both_ways = NULL'), 't f t' UNION ALL SELECT 'typed beside both ways emptied', public.lane_after('both_ways = true', 'along_axis = false, both_ways = NULL'), 'f f t'
  UNION ALL SELECT 'emptied where one does', public.lane_after('along_axis = true', 'along_axis = NULL'), 'f f f' UNION ALL SELECT 'and both ways emptied', public.lane_after('both_ways = true', 'along_axis = NULL, both_ways = NULL'), 'f f f') v(name, after, wanted);
SELECT 'by_hand typed alone decides what is there, or is refused: ' || name, test.state(format('UPDATE town.%1$s_editing SET by_hand = true WHERE %1$s_id = (SELECT min(%1$s_id) FROM town.%1$s_editing WHERE NOT by_hand AND %2$s)', name, place)) = state
  FROM (VALUES ('lane', 'lane_id IN (SELECT lane_id FROM town.lane WHERE kind = ''general'')', '22023'), ('interconnection', 'true', '22023'), ('ramp', 'true', '22023'), ('controller', 'true', '22023'), ('corner', 'true', 'none'), ('sidewalk', 'true', 'none'), ('block', 'NOT ST_IsEmpty(geom)', 'none')) v(name, place, state);
SELECT 'a word that is none is told of the row of the view: ' || name, test.said(format('UPDATE town.%1$s_editing SET %2$s = ''odd'' WHERE %1$s_id = (SELECT min(%1$s_id) FROM town.%1$s_editing WHERE %3$s)', name, attribute, place)) ~ format('the %s of %s \d+.* cannot be "odd"', attribute, replace(name, '_', ' '))
  FROM (VALUES ('junction', 'kind', 'true'), ('lane_adjacency', 'change', 'change <> ''opposite'''), ('block', 'kind', 'NOT ST_IsEmpty(geom)')) v(name, attribute, place);
RESET ROLE;
-- The comment of a constraint is for people: what is taken, its condition says.
COMMENT ON CONSTRAINT block_override_kind_check ON town.block_override IS 'a word of the list in our office. Ask Anna.';
SELECT 'a word is taken whatever the comment of the constraint says', state = 'none' FROM test.refusal('UPDATE town.block_editing SET kind = CASE kind WHEN ''block'' THEN ''island'' ELSE ''block'' END WHERE block_id = (SELECT min(block_id) FROM town.block_editing WHERE NOT ST_IsEmpty(geom))');
SELECT 'and the refusal of another one says it', state = '23514' AND detail = 'Expected a word of the list in our office.' FROM test.refusal('UPDATE town.block_editing SET kind = ''odd'' WHERE block_id = (SELECT min(block_id) FROM town.block_editing WHERE NOT ST_IsEmpty(geom))');
REVOKE ALL ON public.typed, public.written FROM refused_editor;
DO $$ BEGIN PERFORM streetgen.revoke('town', 'refused_editor'), streetgen.revoke('plan', 'refused_editor'); END $$;
DROP ROLE refused_editor;
