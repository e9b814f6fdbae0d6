-- A statement_timeout interrupts every long call soon, with 57014, and the model stays as it was.
-- tests/long measures how soon, on long lines and a town of thousands of axes.
\set vertices 10000
\set blocks 15
\ir ../cases/long.sql
CREATE TABLE before AS SELECT m AS model, test.rows(m) AS rows FROM unnest(ARRAY['town', 'alone', 'dual', 'crossed', 'imported']) m;
-- The second run counts: the first one fills caches.
SELECT count(pg_temp.run(statement)) FROM long_call \g /dev/null
CREATE TABLE whole AS SELECT c.*, r.* FROM long_call c, pg_temp.run(statement) r;
CREATE TABLE tried (name text, timeout float8, ms float8, state text, said text, kept boolean);
SELECT format('SET statement_timeout = %s', timeout),
       format('INSERT INTO tried SELECT %L, %s, r.*, NOT EXISTS (SELECT FROM before WHERE rows <> test.rows(model)) FROM pg_temp.run(%L) r', name, timeout, statement),
       'RESET statement_timeout' FROM whole, LATERAL (SELECT greatest(1, round(ms / 4)) AS timeout) t WHERE ms > 10 \gexec
SELECT format('%s gives a result: %s', name, said), state IS NULL FROM whole;
SELECT format('%s is interrupted, %s ms late: %s', name, round(ms - timeout), said), state = '57014' AND ms - timeout < 2000 FROM tried;
SELECT name || ' interrupted changes no row', kept FROM tried;
SELECT 'enough calls are long enough to be interrupted', count(*) > 10 FROM tried;
