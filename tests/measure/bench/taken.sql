-- The measures, from the file :measured: medians, and the axes of each input.
CREATE TEMPORARY TABLE taken (input text, part text, phase text, turn integer, cpu float8, server float8, wall float8, rows bigint, peak bigint, bytes bigint);
\set load '\\copy taken FROM ' :'measured'
:load
CREATE TEMPORARY VIEW median AS
SELECT input, part, phase, percentile_cont(0.5) WITHIN GROUP (ORDER BY cpu) AS cpu, percentile_cont(0.5) WITHIN GROUP (ORDER BY server) AS server, percentile_cont(0.5) WITHIN GROUP (ORDER BY wall) AS wall,
       max(rows) AS rows, max(peak) / 1024.0 AS peak, max(bytes) / 1048576.0 AS bytes, count(*) AS turns
FROM taken GROUP BY input, part, phase;
CREATE TEMPORARY VIEW input AS SELECT input, rows AS axes FROM median WHERE (part, phase) = ('build', 'axes');

-- Seconds, and ratios: two digits of what is small.
CREATE FUNCTION pg_temp.told(value float8) RETURNS text LANGUAGE sql AS $$ SELECT coalesce(CASE WHEN value < 10 THEN round(value::numeric, 2) WHEN value < 100 THEN round(value::numeric, 1) ELSE round(value::numeric) END::text, '') $$;
