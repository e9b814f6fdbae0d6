-- Prints what every long call takes, and how late it is interrupted.
CREATE TABLE whole (name text, statement text, ms float8, state text, said text);
SELECT format('INSERT INTO whole SELECT %L, %L, * FROM pg_temp.run(%L)', name, statement, statement) FROM long_call \gexec
CREATE TABLE tried (name text, timeout float8, ms float8, state text, said text);
SELECT format('SET statement_timeout = %s', timeout),
       format('INSERT INTO tried SELECT %L, %s, * FROM pg_temp.run(%L)', name, timeout, statement), 'RESET statement_timeout'
  FROM whole, generate_series(0.05, 0.95, 0.1) part, LATERAL (SELECT round(ms * part) AS timeout) t WHERE ms > 100 \gexec
SELECT name, round(ms::numeric / 1000, 2) AS seconds, coalesce(state || ' ' || said, 'a result') AS gives,
       (SELECT count(*) FROM tried t WHERE t.name = w.name AND t.state = '57014') AS interrupted,
       (SELECT round(max(ms - timeout)) FROM tried t WHERE t.name = w.name AND t.state IS NOT NULL) AS "worst, ms late"
  FROM whole w;
