\set ECHO none
\ir shared/truths.sql
\ir shared/streets.sql
-- No call leaks, neither one that gives a result nor one that raises: the backend's own memory after many calls.
-- tests/battery/memory makes ten thousand of each.
\if :{?calls}
  \set told true
\else
  \set calls 300
  \set told false
\endif
CREATE FUNCTION pg_temp.resident() RETURNS bigint LANGUAGE sql AS $$
  SELECT 1024 * substring(pg_read_file('/proc/self/status') FROM 'RssAnon:\s+(\d+)')::bigint $$;
-- What a session holds, but for PostgreSQL's caches of catalogs and plans: they grow whenever another session changes statistics.  Of plans, how many.
CREATE FUNCTION pg_temp.held(OUT bytes bigint, OUT plans bigint) LANGUAGE sql AS $$
  WITH RECURSIVE context AS MATERIALIZED (SELECT name, parent, used_bytes FROM pg_backend_memory_contexts),
  cache AS (SELECT 'CacheMemoryContext' AS name UNION SELECT c.name FROM context c JOIN cache ON c.parent = cache.name)
  SELECT sum(used_bytes) FILTER (WHERE name NOT IN (SELECT name FROM cache)), count(*) FILTER (WHERE name = 'CachedPlanSource') FROM context $$;
CREATE FUNCTION pg_temp.repeat(expression text, times bigint) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  last text := 'none';
BEGIN
  FOR i IN 1..times LOOP
    BEGIN
      EXECUTE 'SELECT ' || expression;
    EXCEPTION WHEN OTHERS THEN
      last := SQLSTATE;
    END;
  END LOOP;
  RETURN last;
END $$;
CREATE TABLE long_line AS SELECT ST_MakeLine(ST_MakePoint(5 * i, 5 * sin(i)) ORDER BY i) AS a, ST_MakeLine(ST_MakePoint(5 * sin(i), 5 * i) ORDER BY i) AS b FROM generate_series(0, 400) i;
CREATE TABLE short_line AS SELECT ST_LineSubstring(a, 0, 0.05) AS a, ST_LineSubstring(b, 0, 0.05) AS b FROM long_line;
CREATE TABLE call AS SELECT row_number() OVER () AS nth, * FROM (VALUES
  ('arc_centre', 'none', 'streetgen.arc_centre(a, b, 7, 6, 5) FROM long_line'), ('arc_centre', '22023', 'streetgen.arc_centre(a, b, 7, -6, 5) FROM long_line'),
  ('corner_arc', 'none', 'streetgen.corner_arc(a, b, 7, 6, 5) FROM long_line'), ('corner_arc', '22023', 'streetgen.corner_arc(a, ST_Reverse(b), 7, 6, ''NaN'') FROM long_line'),
  ('max_corner_radius', 'none', 'streetgen.max_corner_radius(a, b, 7, 6) FROM short_line'), ('max_corner_radius', '22023', 'streetgen.max_corner_radius(a, ST_SetSRID(b, 2154), 7, 6) FROM long_line'),
  ('border_line', 'none', 'streetgen.border_line(a, 500, 6) FROM long_line'), ('border_line', '22023', 'streetgen.border_line(a, ''NaN'', 6) FROM long_line'),
  ('section_surface', 'none', 'streetgen.section_surface(a, 6, 10, 900) FROM long_line'), ('section_surface', '22023', 'streetgen.section_surface(a, 6, 10, ''NaN'') FROM long_line'),
  ('clean', 'none', 'streetgen.clean(a, ''{}'', 0.3, 3) FROM long_line'), ('clean', '22023', 'streetgen.clean(a, ''{true}'', 0.3, 3) FROM long_line'),
  ('intersection_surface', 'none', 'streetgen.intersection_surface(ARRAY[a, b, ST_Reverse(a)], ''{6,7,8}'', ''{3,4,5}'', true) FROM short_line'),
  ('intersection_surface', '22023', 'streetgen.intersection_surface(ARRAY[a, b], ''{6,7}'', ''{3,4,5}'') FROM long_line'),
  ('variable_buffer', 'none', 'streetgen.variable_buffer(a, array_fill(3::float8, ARRAY[ST_NPoints(a)]), ''both'', ''round'') FROM short_line'),
  ('variable_buffer', '22023', 'streetgen.variable_buffer(a, ''{1,2}'') FROM long_line'),
  ('turning_radius', 'none', 'streetgen.turning_radius(50, 7, ''setra'')'), ('turning_radius', '22023', 'streetgen.turning_radius(50, 7, ''other'')'),
  ('_streets', 'none', '(' || test.streets('{}') || ')'), ('_streets', '22023', '(' || test.streets('{"trajectory_radius": "NaN"}') || ')')) v(name, state, expression);

DO $$ BEGIN
  PERFORM streetgen.create_model('soak', 2154);
END $$;
INSERT INTO soak.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 80 * x, 6860000 + 60 * y), ST_MakePoint(650000 + 80 * (x + dx), 6860000 + 60 * (y + 1 - dx))), 2154), 7
  FROM generate_series(1, 6) x, generate_series(1, 6) y, generate_series(0, 1) dx;
-- Every surface is computed and written anew; then an axis that the border refuses.
CREATE FUNCTION pg_temp.soak(bad boolean) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  UPDATE soak.axis SET width = 6 + random() WHERE axis_id = 1;
  UPDATE soak.axis SET radius = 3 + random();
  IF bad THEN
    INSERT INTO soak.axis (geom) VALUES ('SRID=2154;LINESTRING(650001 6860001,650001 6860001)');
  END IF;
  PERFORM streetgen.generate('soak');
  RETURN 'none';
EXCEPTION WHEN OTHERS THEN
  RETURN SQLSTATE;
END $$;
ALTER TABLE soak.axis DROP CONSTRAINT geom_is_a_finite_line;

CREATE TABLE grown (nth bigint, name text, wanted text, state text, bytes bigint);
-- A first tenth fills caches.
SELECT format('DO $do$ BEGIN PERFORM pg_temp.repeat(%L, %s); END $do$', expression, :calls / 10),
       format('INSERT INTO grown SELECT %s, %L, %L, NULL, -pg_temp.resident()', nth, name, state),
       format('UPDATE grown SET state = pg_temp.repeat(%L, %s) WHERE nth = %s', expression, :calls, nth),
       format('UPDATE grown SET bytes = bytes + pg_temp.resident() WHERE nth = %s', nth) FROM call \gexec
SELECT format('%s, SQLSTATE %s, hardly grows', name, state) || CASE WHEN :told THEN format(': %s kB', bytes / 1024) ELSE '' END, bytes < least(5e6, 1e6 + 500 * :calls) AND state = wanted FROM grown ORDER BY nth;

-- Whole runs, good ones and then bad ones, after as many as fill the caches.  What a run gives back leaves holes that
-- would hide what another one keeps, so that what counts is what PostgreSQL's memory contexts hold; _streets alone is above.
-- Counts for statistics, which a session hands on once a second, are handed on first.
-- Runs that keep a plan or a kilobyte, each an open cursor, tell that the measure sees it.
CREATE FUNCTION pg_temp.keep(what text, nth bigint) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format(CASE what WHEN 'plan' THEN 'PREPARE kept_%s AS SELECT 1' ELSE 'DECLARE kept_%s CURSOR WITH HOLD FOR SELECT 1' END, nth);
  RETURN 'none';
END $$;
CREATE TABLE soaked (nth bigint GENERATED ALWAYS AS IDENTITY, run text, turn integer, late boolean, state text, bytes bigint, plans bigint);
SELECT format('DO $do$ BEGIN PERFORM pg_temp.soak(%L); END $do$', i > 10) FROM generate_series(1, 12) i \gexec
SELECT format('INSERT INTO soaked (run, turn, late, state) SELECT %L, %s, %L, %s', run, turn, half = 2, call), 'SELECT FROM pg_stat_force_next_flush()', 'UPDATE soaked SET (bytes, plans) = (SELECT bytes, plans FROM pg_temp.held()) WHERE bytes IS NULL'
  FROM generate_series(1, 3) turn, (VALUES (1, 'good', 'pg_temp.soak(false)'), (2, 'bad', 'pg_temp.soak(true)'), (3, 'plan', 'pg_temp.keep(''plan'', lastval())'), (4, 'cursor', 'pg_temp.keep(''cursor'', lastval())')) r(place, run, call),
    generate_series(1, 2) half, generate_series(1, :calls / 30) ORDER BY turn, place, half \gexec
-- What a run keeps it keeps in every turn, and the least of the second half tells; a table of the server grows in one of them.
CREATE TABLE kept AS SELECT run, min(state) AS state, max(state) AS another_state, min(bytes) AS bytes, min(plans) AS plans
FROM (SELECT run, turn, min(state) AS state, max(state) AS another_state, (min(bytes) FILTER (WHERE late) - min(bytes) FILTER (WHERE NOT late)) / (:calls / 30) AS bytes,
        (min(plans) FILTER (WHERE late) - min(plans) FILTER (WHERE NOT late))::float8 / (:calls / 30) AS plans FROM soaked GROUP BY run, turn) t GROUP BY run;
SELECT format('generate, SQLSTATE %s, keeps nothing', state) || CASE WHEN :told THEN format(': %s bytes, %s plans a run', bytes, plans) ELSE '' END, bytes < 500 AND plans < 0.5 AND (state, another_state) = (wanted, wanted)
FROM kept JOIN (VALUES ('good', 'none'), ('bad', '22023')) w(run, wanted) USING (run) ORDER BY run DESC;
SELECT format('a %s that each run keeps is seen', run), CASE run WHEN 'plan' THEN plans >= 0.9 ELSE bytes >= 500 END FROM kept WHERE run IN ('plan', 'cursor') ORDER BY run;
