\set ECHO none
\ir shared/truths.sql
\ir shared/names.sql
-- Names of pictures, as tests/measure/names reads them of real extracts. Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.name(x float8, y float8, turned float8, words text) RETURNS text LANGUAGE sql AS $$
    SELECT format('<g class="name" style="fill:#000000;font:10px DejaVu Sans,sans-serif">%s</g>%s', string_agg(format('<text transform="translate(%s %s)rotate(%s)">%s</text>', x + 6 * n * cos(radians(turned)), y + 6 * n * sin(radians(turned)), turned, letter), '' ORDER BY n), E'\n')
    FROM string_to_table(words, NULL) WITH ORDINALITY l(letter, n) $$;
SELECT 'the reader finds words, size and which way up', array_agg(words ORDER BY n) = '{abc,def}' AND array_agg(upright ORDER BY n) = '{t,f}' AND bool_and(size = 10) FROM test.written(pg_temp.name(0, 0, 0, 'abc') || pg_temp.name(0, 50, 180, 'def'));
SELECT 'the reader finds a letter that turns back', NOT upright FROM test.written(regexp_replace(pg_temp.name(0, 0, 80, 'abc'), 'rotate\(80\)(?=">c<)', 'rotate(-100)'));
SELECT 'the reader finds one name over another', test.collisions(pg_temp.name(0, 0, 0, 'abc') || pg_temp.name(6, -2, 45, 'def')) = 1 AND test.collisions(pg_temp.name(0, 0, 0, 'abc') || pg_temp.name(0, 12, 0, 'def')) = 0;

\o /dev/null
\ir ../../data/quarter.sql
\o
DO $$ BEGIN PERFORM streetgen.generate('quarter'); END $$;
CREATE TEMPORARY TABLE picture AS SELECT scale, theme, streetgen.svg('quarter', scale => scale, theme => theme) AS svg FROM unnest('{500,1000,2500,5000}'::float8[]) scale, unnest('{street,dark}'::text[]) theme;
SELECT format('at 1:%s no name stands over another, in theme %s', scale, theme), count(w) > 3 AND test.collisions(min(svg)) = 0 FROM picture, test.written(svg) w GROUP BY scale, theme ORDER BY 1;
SELECT format('at 1:%s no name is upside down, in theme %s', scale, theme), count(*) > 3 AND bool_and(upright) FROM picture, test.written(svg) GROUP BY scale, theme ORDER BY 1;
SELECT 'at 1:1,000 streets of 80 m and more have their name but for one of thirty', count(*) > 30 AND count(*) FILTER (WHERE NOT written) <= 0.03 * count(*) FROM picture, test.streets_written('quarter', ST_SetSRID(streetgen._model_extent('quarter'), 2154), svg, 80) WHERE scale = 1000 AND theme = 'street';

-- Streets that end in a hairpin, with names of all lengths.
SELECT streetgen.create_model('hairpin', 2154, subjects => '{}') \g /dev/null
INSERT INTO hairpin.axis (geom, width, name) SELECT ST_SetSRID(ST_Translate('LINESTRING(0 0,60 0,57 1.5)'::geometry, 650000, 6860000 + 20 * n), 2154), 7, repeat('o', n) FROM generate_series(20, 36) n;
DO $$ BEGIN PERFORM streetgen.generate('hairpin'); END $$;
SELECT 'no name begins or ends round a hook of a letter: ' || way, streetgen._name_along(line, 14, 28) IS NULL AND streetgen._name_along(line, 15.5, 25) IS NOT NULL = (way = 'begins') AND streetgen._name_along(line, 12.5, 25) IS NOT NULL = (way = 'ends')
FROM (VALUES ('begins', 'LINESTRING(1 0.01,2 0,-25 0)'::geometry), ('ends', ST_Reverse('LINESTRING(1 0.01,2 0,-25 0)'::geometry))) v(way, line);
SELECT 'no letter turns back at a hairpin', count(*) > 8 AND bool_and(upright) FROM test.written(streetgen.svg('hairpin', scale => 1000));
