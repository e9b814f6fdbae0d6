\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- A statement_timeout interrupts every long call soon, with 57014, and the model stays as it was.
-- tests/battery/long measures how soon, on long lines and a town of thousands of axes.
\set vertices 10000
\set blocks 15
\set crowd 110
\ir shared/postgis_topology.sql
\ir ../cases/long.sql
CREATE TABLE before AS SELECT m AS model, test.rows(m) AS rows FROM unnest(ARRAY['town', 'alone', 'dual', 'crossed', 'imported', 'star', 'band', 'bundle']) m;
-- The second run counts: the first one fills caches.
SELECT count(pg_temp.run(statement)) FROM long_call \g /dev/null
CREATE TABLE whole AS SELECT c.*, r.* FROM long_call c, pg_temp.run(statement) r;
CREATE TABLE tried (name text, timeout float8, ms float8, state text, said text, kept boolean);
-- Each within a quarter of the least that it took. One that ended before was measured at a bad moment, and is tried again.
CREATE VIEW attempt AS
  SELECT format('SET statement_timeout = %s', timeout) AS before,
         -- The time may be over before the call begins: then nothing was tried.
         format('DO %L', format('BEGIN INSERT INTO tried SELECT %L, %s, r.* FROM pg_temp.run(%L) r; EXCEPTION WHEN query_canceled THEN NULL; END', name, timeout, statement)) AS call,
         'RESET statement_timeout' AS after,
         'UPDATE tried SET kept = NOT EXISTS (SELECT FROM before WHERE rows <> test.rows(model)) WHERE kept IS NULL' AS compare
    FROM whole w LEFT JOIN (SELECT name, min(ms) AS ms, count(state) AS interrupted FROM tried GROUP BY name) t USING (name),
         LATERAL (SELECT greatest(1, round(least(w.ms, t.ms) / 4)) AS timeout) o
    WHERE w.ms > 10 AND coalesce(t.interrupted, 0) = 0;
TABLE attempt \gexec
TABLE attempt \gexec
TABLE attempt \gexec
SELECT format('%s gives a result: %s', name, said), state IS NULL FROM whole;
SELECT format('%s is interrupted, if it takes longer than 10 ms', name), coalesce(bool_or(t.state = '57014' AND t.ms - t.timeout < 2000), true)
  FROM whole LEFT JOIN tried t USING (name) GROUP BY name ORDER BY name COLLATE "C";
SELECT name || ' interrupted changes no row', coalesce(bool_and(kept), true) FROM whole LEFT JOIN tried USING (name) GROUP BY name ORDER BY name COLLATE "C";
SELECT 'enough calls are long enough to be interrupted', count(DISTINCT name) > 10 FROM tried;
