-- The picture of docs/figures/cost.md, as SVG: processor seconds by axes, and Paris 2014 beside what else could be done with it.
\ir taken.sql
\ir ../../../data/colours.sql
CREATE FUNCTION pg_temp.words(x float8, y float8, words text, anchor text DEFAULT 'start', colour text DEFAULT pg_temp.colour('ink')) RETURNS text LANGUAGE sql AS $$
    SELECT format('<text x="%s" y="%s" text-anchor="%s" fill="%s">%s</text>', round(x::numeric, 1), round(y::numeric, 1), anchor, colour, words)
$$;
CREATE FUNCTION pg_temp.stroke(x1 float8, y1 float8, x2 float8, y2 float8, colour text, style text DEFAULT '') RETURNS text LANGUAGE sql AS $$
    SELECT format('<line x1="%s" y1="%s" x2="%s" y2="%s" stroke="%s" %s/>', round(x1::numeric, 1), round(y1::numeric, 1), round(x2::numeric, 1), round(y2::numeric, 1), colour, style)
$$;

-- Left: both axes by powers of ten, 1,000 to 1,000,000 axes and 0.01 to 1,000 seconds.
CREATE FUNCTION pg_temp.x(axes float8) RETURNS float8 LANGUAGE sql AS $$ SELECT 70 + 420 * (log(greatest(axes, 1)) - 3) / 3.2 $$;
CREATE FUNCTION pg_temp.y(seconds float8) RETURNS float8 LANGUAGE sql AS $$ SELECT 450 - 400 * (log(greatest(seconds, 0.01)) + 2) / 5 $$;
-- Right: bars from 0.1 to 1,000 seconds.
CREATE FUNCTION pg_temp.bar(seconds float8) RETURNS float8 LANGUAGE sql AS $$ SELECT 880 + 270 * (log(greatest(seconds, 0.1)) + 1) / 4 $$;

SELECT format('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1200 500" font-family="sans-serif" font-size="13"><rect width="1200" height="500" fill="%s"/>', pg_temp.colour('paper'));
SELECT pg_temp.stroke(pg_temp.x(10 ^ i), 50, pg_temp.x(10 ^ i), 450, pg_temp.colour('section')) || pg_temp.words(pg_temp.x(10 ^ i), 468, to_char(10 ^ i, 'FM9,999,999'), 'middle') FROM generate_series(3, 6) i;
SELECT pg_temp.stroke(70, pg_temp.y(10 ^ i), 490, pg_temp.y(10 ^ i), pg_temp.colour('section')) || pg_temp.words(64, pg_temp.y(10 ^ i) + 4, (10.0 ^ i)::float8::text, 'end') FROM generate_series(-2, 3) i;
SELECT pg_temp.words(70, 30, 'generate: CPU s by axes') || pg_temp.words(280, 490, 'axes', 'middle');
-- In proportion to 10,000 axes.
SELECT pg_temp.stroke(pg_temp.x(1000), pg_temp.y(server / 10), pg_temp.x(1000000), pg_temp.y(server * 100), pg_temp.colour('section'), 'stroke-dasharray="4 4"') FROM median WHERE (input, part, phase) = ('virtual_10k', 'build', 'cold');
SELECT format('<circle cx="%s" cy="%s" r="4" fill="%s"/>', round(pg_temp.x(axes)::numeric, 1), round(pg_temp.y(server)::numeric, 1), CASE phase WHEN 'cold' THEN pg_temp.colour('arc', 'fallback') WHEN 'unchanged' THEN pg_temp.colour('arc') ELSE pg_temp.colour('path') END)
    || CASE WHEN phase = 'cold' THEN pg_temp.words(pg_temp.x(axes) + CASE WHEN axes < 2000 THEN 7 ELSE -7 END, pg_temp.y(server) - 6, input, CASE WHEN axes < 2000 THEN 'start' ELSE 'end' END) ELSE '' END
FROM median JOIN input USING (input) WHERE part = 'build' AND phase IN ('cold', 'unchanged', 'one percent') AND axes >= 1000;
SELECT pg_temp.words(80, 66, 'first run', colour => pg_temp.colour('arc', 'fallback')) || pg_temp.words(80, 84, 'nothing changed', colour => pg_temp.colour('arc')) || pg_temp.words(80, 102, '1 % changed', colour => pg_temp.colour('path'));

SELECT pg_temp.words(880, 30, 'Paris 2014: CPU s') || string_agg(pg_temp.stroke(pg_temp.bar(10 ^ i), 40, pg_temp.bar(10 ^ i), 450, pg_temp.colour('section')) || pg_temp.words(pg_temp.bar(10 ^ i), 468, (10.0 ^ i)::float8::text, 'middle'), '') FROM generate_series(-1, 3) i;
WITH cost AS (SELECT part, phase, server FROM median WHERE input = 'paris_2014'),
bar(place, words, seconds, colour) AS (
    SELECT 1, 'the paper (its machine, one core)', 600, pg_temp.colour('intersection')
    UNION ALL SELECT 2, 'axis by axis, extrapolated', c.server / c.rows * axes, pg_temp.colour('section', 'contested') FROM median c JOIN input USING (input) WHERE (input, part, phase) = ('paris_2014', 'paper', 'one by one')
    UNION ALL SELECT 3, 'netconvert, a file', server, pg_temp.colour('intersection') FROM cost WHERE part = 'netconvert'
    UNION ALL SELECT 4, 'plain PostGIS, surfaces that tile', sum(server), pg_temp.colour('intersection') FROM cost WHERE part = 'surfaces' AND phase <> 'ours'
    UNION ALL SELECT 5, 'plain PostGIS, surfaces that overlap', server, pg_temp.colour('intersection') FROM cost WHERE (part, phase) = ('surfaces', 'plain')
    UNION ALL SELECT 6, 'ours, surfaces that tile', server, pg_temp.colour('arc', 'fallback') FROM cost WHERE (part, phase) = ('surfaces', 'ours')
    UNION ALL SELECT 7, 'ours, all, under live keys', server, pg_temp.colour('arc', 'fallback') FROM cost WHERE part = 'keys'
    UNION ALL SELECT 8, 'ours, all, a first run', server, pg_temp.colour('arc', 'fallback') FROM cost WHERE (part, phase) = ('build', 'cold')
    UNION ALL SELECT 9, 'ours, nothing changed', server, pg_temp.colour('arc') FROM cost WHERE (part, phase) = ('build', 'unchanged')
    UNION ALL SELECT 10, 'ours, 1 % changed', server, pg_temp.colour('path') FROM cost WHERE (part, phase) = ('build', 'one percent')
    UNION ALL SELECT 11, 'write floor, keys in place', server, pg_temp.colour('limit') FROM cost WHERE (part, phase) = ('floor', 'keys in place')
    UNION ALL SELECT 12, 'write floor, keys afterwards', sum(server), pg_temp.colour('limit') FROM cost WHERE part = 'floor' AND phase NOT IN ('keys in place', 'statistics by default'))
SELECT format('<rect x="880" y="%s" width="%s" height="20" fill="%s"/>', 20 + 33 * place, greatest(1, round((pg_temp.bar(seconds) - 880)::numeric, 1)), colour)
    || pg_temp.words(872, 35 + 33 * place, words, 'end') || pg_temp.words(pg_temp.bar(seconds) + 5, 35 + 33 * place, pg_temp.told(seconds))
FROM (SELECT words, seconds, colour, row_number() OVER (ORDER BY place) AS place FROM bar WHERE seconds IS NOT NULL) b ORDER BY place;
SELECT '</svg>';
