-- The tables of docs/figures/cost.md.
\ir taken.sql
CREATE FUNCTION pg_temp.line(VARIADIC cells text[]) RETURNS text LANGUAGE sql AS $$ SELECT '| ' || array_to_string(cells, ' | ', '') || ' |' $$;
CREATE FUNCTION pg_temp.header(VARIADIC cells text[]) RETURNS SETOF text LANGUAGE sql AS $$ SELECT '| ' || array_to_string(cells, ' | ') || ' |' UNION ALL SELECT '|' || repeat('---|', cardinality(cells)) $$;

\echo
\echo '### Bars'
SELECT pg_temp.header('figure', 'measured', 'bar');
-- While netconvert runs the server does nothing for it.
WITH cost AS (SELECT input, part, phase, CASE phase WHEN 'netconvert' THEN cpu ELSE server END AS server FROM median),
floor AS (
    SELECT input, sum(server) FILTER (WHERE phase <> 'statistics by default') AS server, sum(server) FILTER (WHERE phase <> 'statistics') AS by_default
    FROM cost WHERE part = 'floor' AND phase <> 'keys in place' GROUP BY input),
ours AS (SELECT input, sum(server) AS server FROM cost WHERE part = 'netconvert' AND phase <> 'netconvert' GROUP BY input),
an_axis AS (SELECT input, axes, server / axes AS server FROM cost JOIN input USING (input) WHERE (part, phase) = ('build', 'cold')),
figure(place, figure, measured, bar) AS (
    SELECT 1, 'Paris 2014, a first run, CPU s', server, '<= 8' FROM cost WHERE (input, part, phase) = ('paris_2014', 'build', 'cold')
    UNION ALL SELECT 2, 'the same, in write floors: ' || input, c.server / f.server, CASE input WHEN 'paris_2014' THEN '<= 1.5' END FROM cost c JOIN floor f USING (input) WHERE (part, phase) = ('build', 'cold')
    UNION ALL SELECT 2, 'the same, in write floors with ANALYZE by default: ' || input, c.server / f.by_default, NULL FROM cost c JOIN floor f USING (input) WHERE (part, phase) = ('build', 'cold')
    UNION ALL SELECT 3, 'plain SQL and PostGIS that tiles, against ours, surfaces only: ' || input, (SELECT sum(server) FROM cost p WHERE p.input = o.input AND p.part = 'surfaces' AND p.phase <> 'ours') / o.server, '>= 4' FROM cost o WHERE (part, phase) = ('surfaces', 'ours')
    UNION ALL SELECT 4, 'plain SQL and PostGIS whose surfaces overlap, against ours: ' || input, p.server / o.server, NULL FROM cost o JOIN cost p USING (input, part) WHERE (o.part, o.phase, p.phase) = ('surfaces', 'ours', 'plain')
    UNION ALL SELECT 5, 'from the file on, against netconvert: ' || input, ours.server / n.server, '<= 0.5' FROM ours JOIN cost n USING (input) WHERE (n.part, n.phase) = ('netconvert', 'netconvert') AND input <> 'paris_2014'
    UNION ALL SELECT 6, 'a first run against netconvert: ' || input, c.server / n.server, NULL FROM cost c JOIN cost n USING (input) WHERE (c.part, c.phase) = ('build', 'cold') AND (n.part, n.phase) = ('netconvert', 'netconvert') AND input = 'paris_2014'
    UNION ALL SELECT 7, 'nothing changed against a first run under live keys: ' || input, u.server / k.server, '<= 0.25' FROM cost u JOIN cost k USING (input) WHERE (u.part, u.phase) = ('build', 'unchanged') AND (k.part, k.phase) = ('keys', 'cold')
    UNION ALL SELECT 8, 'nothing changed against a first run: ' || input, u.server / c.server, CASE input WHEN 'paris_2014' THEN '<= 0.7' END FROM cost u JOIN cost c USING (input, part) WHERE part = 'build' AND u.phase = 'unchanged' AND c.phase = 'cold'
    UNION ALL SELECT 9, format('CPU an axis of %s axes against 10,000', l.axes), l.server / s.server, '<= 1.15' FROM an_axis l JOIN an_axis s ON l.input LIKE 'virtual%' AND s.input = 'virtual_10k' AND l.axes > s.axes
    UNION ALL SELECT 10, format('by clusters, CPU an axis of %s axes against %s', l.rows, s.rows), l.server / l.rows / (s.server / s.rows), '<= 1.15' FROM median l JOIN median s USING (part) WHERE part = 'clusters' AND l.input IN ('virtual_100k', 'virtual_1m') AND s.input = 'virtual_10k'
    UNION ALL SELECT 11, 'private memory of the largest session at a million axes, MB', peak, '<= 512' FROM median WHERE (input, part) = ('virtual_1m', 'clusters')
    UNION ALL SELECT 12, 'two sessions against one, both by 8 clusters, in wall time: ' || input, o.wall / t.wall, CASE input WHEN 'paris_2014' THEN '>= 1.7' END FROM median o JOIN median t USING (input, part) WHERE (part, o.phase, t.phase) = ('clusters', '8 clusters, sessions: 1', '8 clusters, sessions: 2')
    UNION ALL SELECT 13, 'two sessions by 8 clusters against a first run, in wall time: ' || input, c.wall / t.wall, CASE input WHEN 'paris_2014' THEN '>= 1.1' END FROM median c JOIN median t USING (input) WHERE (c.part, c.phase, t.part, t.phase) = ('build', 'cold', 'clusters', '8 clusters, sessions: 2')
    UNION ALL SELECT 14, 'the same, in CPU: ' || input, c.server / t.server, NULL FROM median c JOIN median t USING (input) WHERE (c.part, c.phase, t.part, t.phase) = ('build', 'cold', 'clusters', '8 clusters, sessions: 2')
    UNION ALL SELECT 15, 'an arc''s centre: two buffers against arc_centre', b.server / nullif(a.server, 0), NULL FROM cost a JOIN cost b USING (input, part) WHERE (input, part, a.phase, b.phase) = ('paris_2014', 'corner', 'arc_centre', 'buffers'))
SELECT pg_temp.line(figure, pg_temp.told(measured), bar) FROM figure ORDER BY place, figure;

\echo
\echo '### Runs of generate'
SELECT pg_temp.header('input', 'axes', 'rows', 'first run, CPU s', 'CPU ms an axis', 'wall s', 'nothing changed, CPU s', '1 % changed, CPU s', 'one edit, CPU ms', 'private memory MB', 'disk MB');
SELECT pg_temp.line(input, axes::text, c.rows::text, pg_temp.told(c.server), pg_temp.told(1000 * c.server / axes), pg_temp.told(c.wall), pg_temp.told(u.server), pg_temp.told(p.server), pg_temp.told(1000 * e.server / e.rows), pg_temp.told(c.peak), pg_temp.told(c.bytes))
FROM input JOIN median c USING (input) LEFT JOIN median u USING (input, part) LEFT JOIN median p USING (input, part) LEFT JOIN median e USING (input, part)
WHERE part = 'build' AND c.phase = 'cold' AND u.phase = 'unchanged' AND p.phase = 'one percent' AND e.phase = 'hundred edits' ORDER BY axes;

\echo
\echo '### Beside it'
SELECT pg_temp.header('input', 'part', 'phase', 'times', 'rows', 'CPU s', 'with the server''s own', 'wall s', 'private memory MB', 'disk MB');
SELECT pg_temp.line(input, part, phase, turns::text, CASE WHEN rows > 0 THEN rows::text END, pg_temp.told(cpu), pg_temp.told(server), pg_temp.told(wall), pg_temp.told(peak), CASE WHEN part <> 'netconvert' THEN pg_temp.told(bytes) END)
FROM median LEFT JOIN input USING (input) WHERE part IN ('keys', 'floor', 'surfaces', 'netconvert', 'corner') ORDER BY axes, input, array_position(ARRAY['keys', 'floor', 'surfaces', 'netconvert', 'corner'], part), phase;

\echo
\echo '### Clusters'
SELECT pg_temp.header('input', 'axes', 'clusters', 'sessions', 'CPU s of all', 'CPU ms an axis', 'wall s', 'private memory of the largest session, MB');
SELECT pg_temp.line(input, rows::text, split_part(phase, ' ', 1), split_part(phase, ': ', 2), pg_temp.told(server), pg_temp.told(1000 * server / rows), pg_temp.told(wall), pg_temp.told(peak))
FROM median WHERE part = 'clusters' ORDER BY rows, split_part(phase, ' ', 1)::integer, phase;

\echo
\echo '### The papers'' experiments'
SELECT pg_temp.header('input', 'experiment', 'axes', 'CPU s', 'CPU ms an axis', 'all axes in this way, CPU s');
SELECT pg_temp.line(input, phase, rows::text, pg_temp.told(server), pg_temp.told(1000 * server / rows), CASE phase WHEN 'one by one' THEN pg_temp.told(server / rows * axes) || ', extrapolated' WHEN 'whole' THEN pg_temp.told(server) END)
FROM median JOIN input USING (input) WHERE part = 'paper' ORDER BY axes, phase IN ('one by one', 'a street again'), rows;

\echo
\echo '### Kerbs, blocks and sidewalks'
SELECT pg_temp.header('input', 'subjects', 'rows', 'first run, CPU s', 'in runs of the surfaces', 'private memory MB', 'against the surfaces', 'nothing changed, CPU s', 'rows written then');
SELECT pg_temp.line(c.input, c.phase, c.rows::text, pg_temp.told(c.cpu), pg_temp.told(c.cpu / s.cpu), pg_temp.told(c.peak), pg_temp.told(c.peak / s.peak), pg_temp.told(u.cpu), u.rows::text)
FROM median c JOIN median u ON (u.input, u.part, u.phase) = (c.input, c.part, c.phase || ' unchanged') JOIN median s ON (s.input, s.part, s.phase) = (c.input, c.part, 'surface')
WHERE c.part = 'subjects' ORDER BY c.input, c.rows;
