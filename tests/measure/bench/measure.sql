-- Runs the file :statement, which sets variable rows, and writes a line to the file :taken: input, part, phase, turn, processor seconds
-- of the backend, the same with the server's own processes, wall seconds, rows, peak private memory (kB), bytes of schema :schema.
\set rows 0
SELECT pg_backend_pid() AS pid, string_agg(format('/proc/%s/stat', pid), ' ') AS files FROM pg_stat_activity
WHERE pid = pg_backend_pid() OR backend_type IN ('checkpointer', 'background writer', 'walwriter') \gset
\setenv PID :pid
\setenv FILES :files
\! echo 0 >"$WORK/peak"; "$BENCH/watch" "$PID" "$WORK/peak" 2>/dev/null >/dev/null &
-- A short part may end before a busy machine looks for the first time.
\! for i in $(seq 500); do [ "$(cat "$WORK/peak")" = 0 ] || break; sleep 0.01; done
\set ticks_before `cat /proc/$PID/stat $FILES | awk '{ t = $14 + $15; if (NR == 1) own = t; else all += t } END { print own, all }'`
SELECT clock_timestamp() AS began \gset
\i :statement
SELECT clock_timestamp() AS ended \gset
\set ticks `cat /proc/$PID/stat $FILES | awk '{ t = $14 + $15; if (NR == 1) own = t; else all += t } END { print own, all }'`
\set peak `cat "$WORK/peak"`
\set hertz `getconf CLK_TCK`
\pset fieldsep '\t'
\o | cat >>"$TAKEN"
SELECT :'input', :'part', :'phase', :'turn',
       round((split_part(:'ticks', ' ', 1)::bigint - split_part(:'ticks_before', ' ', 1)::bigint) * 1.0 / :hertz, 3),
       round((split_part(:'ticks', ' ', 2)::bigint - split_part(:'ticks_before', ' ', 2)::bigint) * 1.0 / :hertz, 3),
       round(extract(epoch FROM :'ended'::timestamptz - :'began'::timestamptz), 3), :'rows', :'peak',
       (SELECT coalesce(sum(pg_total_relation_size(oid)), 0) FROM pg_class WHERE relnamespace = to_regnamespace(:'schema') AND relkind = 'r');
\o
