-- Prints what every long call takes, and how late it is interrupted.
CREATE TABLE whole (name text, statement text, ms float8, state text, said text);
SELECT format('INSERT INTO whole SELECT %L, %L, * FROM pg_temp.duration(%L)', name, statement, statement) FROM long_call \gexec
CREATE TABLE tried (name text, state text, late float8);
SELECT format('SET statement_timeout = %s', round(ms * tenth / 10)),
       format('INSERT INTO tried SELECT %L, * FROM pg_temp.interrupted(%L)', name, statement), 'RESET statement_timeout'
  FROM whole, generate_series(0.5, 9.5) tenth WHERE ms > 100 \gexec
SELECT name, round(ms / 1000, 2) AS seconds, coalesce(said, 'a result') AS gives, (SELECT count(*) FROM tried t WHERE t.name = w.name AND t.state = '57014') AS interrupted,
       (SELECT round(max(late)) FROM tried t WHERE t.name = w.name) AS "worst, ms late"
  FROM (SELECT name, ms::numeric, said FROM whole) w;
