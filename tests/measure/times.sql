-- Wall time of generate into an empty model with one model's axes and settings, processor time of the same (other
-- processes of the machine lengthen the first alone), and wall time of a second run: psql -v model=NAME -f tests/measure/times.sql
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SELECT streetgen.create_model('timed', srid, dimension) FROM streetgen.model WHERE name = :'model' \g /dev/null
UPDATE timed.setting t SET value = s.value FROM :"model".setting s WHERE s.name = t.name AND s.value IS DISTINCT FROM t.value;
DELETE FROM timed.axis_class;
INSERT INTO timed.axis_class SELECT * FROM :"model".axis_class;
-- An edit that is followed would leave nothing for the first run to do.
SELECT streetgen.live('timed', false) \g /dev/null
INSERT INTO timed.axis SELECT * FROM :"model".axis;
SELECT pg_backend_pid() AS pid \gset
\set hertz `getconf CLK_TCK`
\set ticks_before `cut -d' ' -f14,15 /proc/:pid/stat`
SELECT clock_timestamp() AS first \gset
SELECT count(*) FROM streetgen.generate('timed') \g /dev/null
SELECT clock_timestamp() AS second \gset
\set ticks_after `cut -d' ' -f14,15 /proc/:pid/stat`
SELECT count(*) FROM streetgen.generate('timed') \g /dev/null
SELECT clock_timestamp() AS third \gset
SELECT 'times | ' || :'model', axes, round(first::numeric, 2), round(processor::numeric, 2), round(second::numeric, 2), round((1000 * processor / axes)::numeric, 2) || ' |'
FROM (SELECT (SELECT sum(after - before) / :'hertz'::numeric FROM unnest(string_to_array(:'ticks_before', ' ')::bigint[], string_to_array(:'ticks_after', ' ')::bigint[]) ticks(before, after)) AS processor,
              extract(epoch FROM :'second'::timestamptz - :'first') AS first, extract(epoch FROM :'third'::timestamptz - :'second') AS second, (SELECT count(*) FROM timed.axis) AS axes) t;
SELECT streetgen.drop_model('timed') \g /dev/null
