-- A statement_timeout interrupts every long call soon, with 57014, and the model stays as it was.
-- tests/long measures how soon, on long lines and a town of thousands of axes.
\set vertices 10000
\set blocks 15
\ir ../cases/long.sql
CREATE TABLE before AS SELECT m AS model, test.rows(m) AS rows FROM unnest(ARRAY['town', 'alone', 'dual', 'crossed', 'imported']) m;
-- The second run: the first one fills caches.
SELECT count(pg_temp.duration(statement)) FROM long_call \g /dev/null
CREATE TABLE whole AS SELECT c.*, d.* FROM long_call c, pg_temp.duration(statement) d;
CREATE TABLE tried (name text, state text, late float8, kept boolean);
SELECT format('SET statement_timeout = %s', greatest(1, round(ms / 4))),
       format('INSERT INTO tried SELECT %L, i.*, NOT EXISTS (SELECT FROM before WHERE rows <> test.rows(model)) FROM pg_temp.interrupted(%L) i', name, statement),
       'RESET statement_timeout' FROM whole WHERE ms > 10 \gexec
SELECT format('%s gives a result: %s', name, coalesce(said, 'yes')), state = 'none' FROM whole;
SELECT format('%s is interrupted, %s ms late', name, round(late)), state = '57014' AND late < 2000 FROM tried;
SELECT name || ' interrupted changes no row', kept FROM tried;
SELECT 'enough calls are long enough to be interrupted', count(*) > 10 FROM tried;
