\set ECHO none
\ir shared/truths.sql
\ir shared/city.sql
-- Virtual cities: what comes out, what a model of one holds, what is refused.  Each SELECT is one truth: (name, holds).
CREATE TABLE city AS SELECT ordinality AS nth, c.* FROM streetgen.virtual_city(2177, 6560000, 5570000, 20000, 10000, 4) WITH ORDINALITY c;
SELECT 'the paper''s extent gives its number of streets' AS name, count(*) BETWEEN 1000 AND 2000 AS holds FROM city;
SELECT 'axes are valid lines of the SRID', bool_and(ST_IsValid(geom) AND ST_SRID(geom) = 2177 AND GeometryType(geom) = 'LINESTRING' AND ST_IsSimple(geom)) FROM city;
SELECT 'the first one crosses the whole map', ST_XMin(geom) = 6560000 AND ST_XMax(geom) = 6580000 FROM city WHERE nth = 1;
SELECT 'all lie in the extent', ST_Contains(ST_MakeEnvelope(6560000, 5570000, 6580000, 5580000, 2177), ST_Collect(geom)) FROM city;
SELECT '6, 4 and 2 lanes of 3 m', array_agg(DISTINCT lane_count ORDER BY lane_count) = '{2,4,6}' AND bool_and(width = 3 * lane_count) FROM city;
SELECT 'wider roads are more important and faster',
       (SELECT bool_and(a.importance < b.importance AND a.speed >= b.speed) FROM city a JOIN city b ON a.width > b.width);
SELECT 'each street has a name of its own', count(DISTINCT name) = count(*) FROM city;
SELECT 'both directions are open', bool_and(direction = 'both') FROM city;
SELECT 'the same again', NOT EXISTS (SELECT geom::bytea, name FROM city EXCEPT SELECT geom::bytea, name FROM streetgen.virtual_city(2177, 6560000, 5570000, 20000, 10000, 4));
SELECT 'another seed is another city', NOT EXISTS (SELECT geom::bytea FROM city INTERSECT SELECT geom::bytea FROM streetgen.virtual_city(2177, 6560000, 5570000, 20000, 10000, 5));
SELECT 'another corner moves the city', max(ST_HausdorffDistance(ST_Translate(a.geom, -6500000, -5500000), b.geom)) < 1e-6
FROM (SELECT row_number() OVER () AS nth, geom FROM streetgen.virtual_city(2177, 60000, 70000, 20000, 10000, 4)) b JOIN city a USING (nth);
SELECT 'seeds may be negative', count(*) > 1 FROM streetgen.virtual_city(2177, 0, 0, 3000, 3000, -9223372036854775808);
-- Of 2 sx sx with sx 35 % of the extent; the number for a start is drawn from 0.5 to 0.75.
SELECT 'most starts lie where the density is high',
       bool_and(density >= 0.5) AND avg((density >= 0.75)::integer) > 0.5 AND bool_or(density < 0.6)
FROM (SELECT streetgen.city_density(ST_X(p), ST_Y(p), 6560000, 5570000, 20000, 10000) AS density FROM city, ST_StartPoint(geom) p WHERE nth > 1) d;
SELECT 'the density is the Gaussian of the paper',
       bool_and(abs(streetgen.city_density(6570000 + dx, 5575000 + dy, 6560000, 5570000, 20000, 10000) - exp(0 - (dx / 7000.0) ^ 2 / 2 - (dy / 3500.0) ^ 2 / 2)) < 1e-12)
FROM generate_series(-10000, 10000, 2500) dx, generate_series(-5000, 5000, 1250) dy;
SELECT 'its deviation is an option', abs(streetgen.city_density(20, 10, 0, 0, 20, 20, '{"deviation": 0.5}') - exp(-0.5)) < 1e-12;

SELECT format('axes => %s draws so many', n), abs(count(*) - n) <= 0.05 * n FROM unnest(ARRAY[1, 2, 7, 40, 2500]) n, streetgen.virtual_city(2177, 0, 0, 20, 10, 1, jsonb_build_object('axes', n)) GROUP BY n;
SELECT 'about the lower left corner, in the shape of the extent',
       ST_XMin(box) = 500 AND ST_XMax(box) > 500 AND ST_YMin(box) >= 700 AND (ST_YMax(box) - 700) < (ST_XMax(box) - 500) / 1.9
FROM (SELECT ST_Extent(geom) AS box FROM streetgen.virtual_city(2177, 500, 700, 20, 10, 1, '{"axes": 500}')) b;
SELECT 'lists by level hold on', array_agg(DISTINCT lane_count) = '{3}' AND bool_and(width = 12) AND array_agg(DISTINCT speed) = '{20,60}'
FROM streetgen.virtual_city(2177, 0, 0, 3000, 3000, 1, '{"lanes": 3, "lane_width": 4, "speed": [60, 20]}');
SELECT 'several centres draw roads that one does not reach', count(*) > 10
FROM streetgen.virtual_city(2177, 0, 0, 10000, 5000, 1, '{"centres": [[0.15, 0.5], [0.85, 0.5]], "deviation": 0.12}') c WHERE ST_XMax(geom) < 2500;
SELECT 'roundabouts are one-way rings against the clock', count(*) > 5 AND bool_and(direction = 'direct' AND ST_IsPolygonCCW(ST_MakePolygon(geom)))
FROM streetgen.virtual_city(2177, 0, 0, 4000, 3000, 1, '{"roundabouts": 0.5}') WHERE ST_IsClosed(geom);
SELECT 'the options are listed with their defaults', count(*) = 24 AND bool_and(description <> '' AND minimum < maximum AND value[1] BETWEEN minimum AND maximum) FROM streetgen.city_option();
SELECT 'and their defaults are what is taken', NOT EXISTS (
    SELECT geom::bytea FROM city EXCEPT SELECT geom::bytea FROM streetgen.virtual_city(2177, 6560000, 5570000, 20000, 10000, 4, (SELECT jsonb_object_agg(name, value) FROM streetgen.city_option())));

-- Models of ten seeds, each second one with all that goes beyond the paper.
CREATE TABLE model AS SELECT seed, format('city_%s', seed) AS name, streetgen.create_virtual_city(format('city_%s', seed), 2177, 6560000, 5570000, 3000, 2000, seed,
    CASE WHEN seed % 2 = 0 THEN '{"bend": 10, "roundabouts": 0.4, "stretch": 400, "one_way_pairs": 1}'::jsonb ELSE '{}' END) AS drawn FROM generate_series(1, 10) seed;
SELECT 'each draws a town', min(drawn) > 20 FROM model;
SELECT 'its streets are for generate', NOT EXISTS (SELECT FROM city_1.edge) AND EXISTS (SELECT FROM streetgen.check_model('city_1') WHERE rule = 'not_generated');
SELECT count(*) FROM model, streetgen.generate(name, wait => true) \g /dev/null
CREATE TABLE found AS SELECT name, drawn, f.* FROM model, test.city(name) f;
SELECT name || ': the model holds the axes', axes = drawn FROM found;
SELECT format('%s: nothing is broken%s', name, ': ' || broken), broken IS NULL FROM found;
SELECT name || ': no axis crosses another without a node', crossings = 0 FROM found;
SELECT name || ': all is one piece', pieces = 1 FROM found;
SELECT name || ': surfaces tile without overlap', abs(overlap) < 1e-6 FROM found;
SELECT name || ': and without slits', slits = 0 FROM found;
SELECT name || ': axes lie in their roads', outside < 1e-3 FROM found;
SELECT 'a second run finds nothing to do', sum(inserted + updated + deleted) = 0 FROM model, streetgen.generate(name) WHERE seed = 2;
SELECT 'the model has all that the axes say', NOT EXISTS (
    SELECT geom::bytea, width, lane_count, importance, name, direction, speed FROM streetgen.virtual_city(2177, 6560000, 5570000, 3000, 2000, 9)
    EXCEPT SELECT geom::bytea, width, lane_count, importance, name, direction, speed FROM city_9.axis);

-- Bad input: one error with a hint, and no model.
CREATE TABLE bad(what, arguments, expected, says) AS VALUES
    ('no extent', '2177, 0, 0, 0, 1000, 1', '22023', 'width of the extent is 0 m'),
    ('a negative extent', '2177, 0, 0, 1000, -5, 1', '22023', 'height of the extent is -5 m'),
    ('an extent of one road''s width', '2177, 0, 0, 1000, 18, 1', '22023', 'height of the extent is 18 m'),
    ('an extent that is no number', $$2177, 0, 0, 'NaN', 1000, 1$$, '22023', 'width'),
    ('an extent without end', $$2177, 0, 0, 'Infinity', 1000, 1$$, '22023', 'width'),
    ('an extent of half the earth', '2177, 0, 0, 2e7, 1000, 1', '22023', 'width'),
    ('a corner that is no number', $$2177, 'NaN', 0, 1000, 1000, 1$$, '22023', 'corner'),
    ('a geographic SRID', '4326, 0, 0, 1000, 1000, 1', '22023', 'not projected'),
    ('an unknown SRID', '424242, 0, 0, 1000, 1000, 1', '22023', 'unknown'),
    ('feet', '2263, 0, 0, 1000, 1000, 1', '22023', 'not in metres'),
    ('NULL as seed', '2177, 0, 0, 1000, 1000, NULL', '22004', 'NULL'),
    ('NULL as extent', '2177, 0, 0, NULL, 1000, 1', '22004', 'NULL'),
    ('options that are no object', $$2177, 0, 0, 1000, 1000, 1, '[1]'$$, '22023', 'expected an object'),
    ('NULL as options', '2177, 0, 0, 1000, 1000, 1, NULL', '22023', 'expected an object'),
    ('an unknown option', $$2177, 0, 0, 1000, 1000, 1, '{"lane": 2}'$$, '22023', 'unknown option "lane"'),
    ('an option that is no number', $$2177, 0, 0, 1000, 1000, 1, '{"bend": "much"}'$$, '22023', 'option "bend" is "much"'),
    ('an option that is null', $$2177, 0, 0, 1000, 1000, 1, '{"bend": null}'$$, '22023', 'option "bend"'),
    ('an option without numbers', $$2177, 0, 0, 1000, 1000, 1, '{"lanes": []}'$$, '22023', 'option "lanes"'),
    ('an option out of range', $$2177, 0, 0, 1000, 1000, 1, '{"right_angles": 1.5}'$$, '22023', 'option "right_angles" is 1.5'),
    ('a fraction of axes', $$2177, 0, 0, 1000, 1000, 1, '{"axes": 10.5}'$$, '22023', 'option "axes" is 10.5'),
    ('more than numbers can hold', $$2177, 0, 0, 1000, 1000, 1, '{"axes": 1e999}'$$, '22023', 'option "axes"'),
    ('two numbers for one', $$2177, 0, 0, 1000, 1000, 1, '{"start_gap": [40, 50]}'$$, '22023', 'option "start_gap" has 2 numbers'),
    ('a threshold upside down', $$2177, 0, 0, 1000, 1000, 1, '{"threshold": [0.75, 0.5]}'$$, '22023', 'threshold'),
    ('half a centre', $$2177, 0, 0, 1000, 1000, 1, '{"centres": [0.5, 0.5, 0.1]}'$$, '22023', 'centres'),
    ('axes in a thread', $$2177, 0, 0, 1e6, 1, 1, '{"axes": 1000}'$$, '22023', '1000 axes need'),
    ('a name that is NULL', NULL, '22004', 'argument model is NULL'),
    ('a place where the projection fails', '2177, 0, 0, 3000, 3000, 1', '22023', 'scale');
SELECT what || ' is refused', state = expected AND said LIKE '%' || says || '%' AND hint <> ''
FROM bad, test.refusal(CASE WHEN arguments IS NULL THEN 'SELECT streetgen.create_virtual_city(NULL, 2177, 6560000, 5570000, 1000, 1000, 1)' ELSE format('SELECT streetgen.create_virtual_city(''lost'', %s)', arguments) END);
SELECT what || ' is refused without a model', state = expected AND hint <> '' FROM bad, test.refusal(format('SELECT count(*) FROM streetgen.virtual_city(%s)', arguments)) WHERE arguments IS NOT NULL AND says <> 'scale';
SELECT 'an existing model is refused', test.state($$SELECT streetgen.create_virtual_city('city_1', 2177, 6560000, 5570000, 1000, 1000, 1)$$) = '42P06';
SELECT 'nothing of a refused model is left', to_regnamespace('lost') IS NULL AND NOT EXISTS (SELECT FROM streetgen.model WHERE name = 'lost');
CREATE FUNCTION pg_temp.ends_as(statement text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  RETURN 'none';
EXCEPTION WHEN query_canceled THEN
  RETURN '57014';
END $$;
SET statement_timeout = '300ms';
SELECT 'a long run is cancelled', pg_temp.ends_as($$SELECT streetgen.create_virtual_city('lost', 2177, 6560000, 5570000, 20000, 10000, 1, '{"axes": 1000000}')$$) = '57014';
RESET statement_timeout;
SELECT 'and leaves nothing', to_regnamespace('lost') IS NULL;
SELECT 'the density refuses bad values: ' || given, state = '22023' FROM unnest(ARRAY['0, 0, 0, 0, 0, 20', $$'NaN', 0, 0, 0, 20, 20$$, '0, 0, 0, 0, 20, -1', $$0, 0, 0, 0, 20, 20, '{"deviation": 0}'$$]) given, test.refusal(format('SELECT streetgen.city_density(%s)', given));
