-- Figures of roads designed on terrain, for tests/measure/terrain.
\set QUIET on
-- CPU of this backend, seconds: user and system time in hundredths.
CREATE FUNCTION pg_temp.cpu() RETURNS float8 LANGUAGE sql VOLATILE AS $$
    SELECT (s[14]::float8 + s[15]::float8) / 100 FROM (SELECT string_to_array(pg_read_file('/proc/self/stat'), ' ') AS s) p $$;
CREATE FUNCTION pg_temp.made(model name, srid integer, source text) RETURNS void LANGUAGE sql AS $$
    SELECT FROM streetgen.create_model(model, srid, 3); SELECT FROM streetgen.create_design(model); SELECT FROM streetgen.import_terrain(model, source::regclass) $$;
CREATE FUNCTION pg_temp.road(model name, network text, a geometry, b geometry) RETURNS bigint LANGUAGE plpgsql AS $$
DECLARE
    link bigint;
BEGIN
    EXECUTE format('DELETE FROM %1$I.design_node; INSERT INTO %1$I.design_node (kind, geom, by_hand) VALUES (''village'', %2$L, true), (''village'', %3$L, true)', model, a, b);
    EXECUTE format('INSERT INTO %1$I.design_link (node_a, node_b, network, by_hand) SELECT min(design_node_id), max(design_node_id), %2$L, true FROM %1$I.design_node RETURNING design_link_id', model, network) INTO link;
    PERFORM FROM streetgen.design(model, links => ARRAY[link]);
    RETURN link;
END $$;

SELECT pg_temp.made('pb', 3763, 'streetgen_source.porto_braga'), pg_temp.made('isere', 2154, 'streetgen_source.isere') \g /dev/null
CREATE TABLE town AS SELECT ST_Transform('SRID=4326;POINT(-8.6107 41.1496)'::geometry, 3763) AS porto, ST_Transform('SRID=4326;POINT(-8.4265 41.5503)'::geometry, 3763) AS braga;

-- The whole chain by length, axes included.
CREATE FUNCTION pg_temp.chain(km float8) RETURNS TABLE(figure text, value numeric) LANGUAGE plpgsql AS $$
DECLARE
    began float8;
BEGIN
    began := pg_temp.cpu();
    PERFORM pg_temp.road('pb', 'rural', braga, ST_LineInterpolatePoint(ST_MakeLine(braga, porto), km * 1000 / ST_Distance(braga, porto))) FROM town;
    RETURN QUERY SELECT format('whole chain, rural, %s km straight, CPU s', km), round((pg_temp.cpu() - began)::numeric, 2);
END $$;
SELECT * FROM pg_temp.chain(1);
SELECT * FROM pg_temp.chain(10);
SELECT * FROM pg_temp.chain(47);

-- Beside r.walk and r.path of GRASS, under our cost; heights of both are chosen alike.
CREATE TABLE own AS SELECT pg_temp.cpu() AS began, NULL::float8 AS cpu, NULL::geometry AS geom;
SELECT pg_temp.road('pb', 'rural', porto, braga) FROM town \g /dev/null
UPDATE own SET cpu = pg_temp.cpu() - began, geom = (SELECT ST_Force2D(l.geom) FROM pb.design_link l);
SELECT 'rural road Porto - Braga beside r.walk and r.path: cost, CPU', concat_ws(', ', round(((SELECT sum(cost) FROM streetgen.path_cost('pb', own.geom, 'rural'))
    / (SELECT sum(cost) FROM streetgen.path_cost('pb', (SELECT ST_LineMerge(ST_Collect(geom)) FROM walk), 'rural')))::numeric, 2), round((cpu / :walk_cpu)::numeric, 1)) FROM own;

-- Spectrum against OSM Porto: half the sum of differences of shares.
CREATE FUNCTION pg_temp.spectrum(network text, radius text, shares float8[]) RETURNS numeric LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.set('pb', 'curve_radius', radius);
    PERFORM pg_temp.road('pb', network, porto, braga) FROM town;
    RETURN (SELECT round((sum(abs(share - wanted)) / 2)::numeric, 3) FROM pb.design_link, LATERAL (SELECT share, row_number() OVER (ORDER BY cycles_from) AS nth FROM streetgen.curvature_spectrum(ST_Force2D(geom))) s
        JOIN unnest(shares) WITH ORDINALITY w(wanted, nth) USING (nth));
END $$;
SELECT 'spectrum, rural to secondary, curve_radius least', pg_temp.spectrum('rural', 'least', '{.074,.159,.299,.369,.099}');
SELECT 'spectrum, highway to motorway, curve_radius ' || radius, pg_temp.spectrum('highway', radius, '{.485,.237,.073,.099,.107}') FROM unnest('{least,normal,largest}'::text[]) radius;

-- Six real roads under one cost, heights of both chosen alike.
UPDATE isere.design_standard SET grade = CASE speed WHEN 30 THEN 0.1 WHEN 40 THEN 0.085 ELSE grade END;
CREATE FUNCTION pg_temp.real_road(road text) RETURNS TABLE(figure text, value text) LANGUAGE plpgsql AS $$
DECLARE
    c record;
    link bigint;
    ours geometry;
BEGIN
    SELECT * INTO c FROM chain WHERE name = road;
    UPDATE isere.design_class SET speed = c.speed, width = c.width WHERE network = 'rural';
    link := pg_temp.road('isere', 'rural', ST_StartPoint(c.geom), ST_EndPoint(c.geom));
    ours := (SELECT ST_Force2D(geom) FROM isere.design_link WHERE design_link_id = link);
    RETURN QUERY SELECT 'real road ' || road || ': cost, length, mean distance m', concat_ws(', ',
        round(((SELECT sum(cost) FROM streetgen.path_cost('isere', ours, 'rural')) / (SELECT sum(cost) FROM streetgen.path_cost('isere', c.geom, 'rural')))::numeric, 2), round((ST_Length(ours) / ST_Length(c.geom))::numeric, 2),
        (SELECT round(avg(ST_Distance(ST_LineInterpolatePoint(ours, k / 500.0), c.geom))) FROM generate_series(0, 500) k));
END $$;
SELECT r.* FROM (SELECT name FROM chain ORDER BY name) c, pg_temp.real_road(c.name) r;

-- A bend that is dragged on ten kilometres, streets included.
SELECT streetgen.set('pb', 'curve_radius', 'least') \g /dev/null
SELECT * FROM pg_temp.chain(10) \g /dev/null
SELECT FROM streetgen.generate('pb') \g /dev/null
CREATE FUNCTION pg_temp.drag(turn integer) RETURNS float8 LANGUAGE plpgsql AS $$
DECLARE
    began constant float8 := pg_temp.cpu();
BEGIN
    UPDATE pb.design_vertex_editing SET geom = ST_Translate(geom, 15 * sin(turn), 15 * cos(turn)) WHERE design_vertex_id = (SELECT design_vertex_id FROM pb.design_vertex ORDER BY md5(turn || ordinality::text) LIMIT 1);
    RETURN pg_temp.cpu() - began;
EXCEPTION WHEN invalid_parameter_value THEN
    RETURN NULL;
END $$;
SELECT 'a bend dragged on 10 km, streets included, median CPU s', round(percentile_cont(0.5) WITHIN GROUP (ORDER BY pg_temp.drag(turn))::numeric, 2) FROM generate_series(1, 30) turn;
