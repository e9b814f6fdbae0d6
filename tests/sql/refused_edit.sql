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
-- Of each column a value that it can hardly have, of each table a row that is there twice.
CREATE TABLE public.tried AS SELECT relation, statement, NULL::text AS state, NULL::text AS said, NULL::text AS hint, NULL::text AS context FROM (
  SELECT relation, format('UPDATE %s SET %I = %s WHERE %4$I = (SELECT min(%4$I) FROM %1$s)', relation, attname, value, key) AS statement FROM public.written JOIN public.odd USING (type) WHERE updates AND (type <> 'text' OR relation LIKE '%editing')
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
SELECT 'none is refused by an error of the server or of SQL', NOT EXISTS (SELECT FROM public.tried WHERE state ~ '^(XX|42)');
REVOKE ALL ON public.tried FROM refused_editor;
DO $$ BEGIN PERFORM streetgen.revoke('town', 'refused_editor'), streetgen.revoke('plan', 'refused_editor'); END $$;
DROP ROLE refused_editor;
