\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- The bounds of turning_radius, and a predictor of the user's.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, speed, importance, lane_count, kind) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 50, NULL, 2, NULL),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 6, 30, 3, 2, 'residential'),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 50, NULL, 2, NULL);
UPDATE town.axis SET radius = 4 WHERE axis_id = 3;
CREATE FUNCTION pg_temp.radius(axis bigint) RETURNS float8 LANGUAGE sql AS $$ SELECT radius FROM town.axis_used WHERE axis_id = axis $$;

-- Equation 1 of the paper: sqrt(346 V / (10 w + 65 - V)), w the half width.
SELECT 'by default turning_radius stays between 0.15 and 15 m', streetgen.turning_radius(0, 7) = 0.15 AND streetgen.turning_radius(130, 7) = 15 AND pg_temp.radius(1) = 15;
SELECT 'at 50 km/h the law itself gives more', abs(streetgen.turning_radius(50, 7, 'paper', 0, 200) - sqrt(346.0 * 50 / (100 - 50))) < 1e-9;
SELECT streetgen.set('town', 'turning_radius_maximal', '18'), streetgen.set('town', 'turning_radius_minimal', '1') \g /dev/null
SELECT 'the bounds are settings', pg_temp.radius(1) = 18;
SELECT streetgen.set('town', 'turning_radius_maximal', '200') \g /dev/null
SELECT 'far enough apart they leave the law alone', abs(pg_temp.radius(1) - sqrt(346.0)) < 1e-9;
UPDATE town.axis SET speed = 0.001 WHERE axis_id = 1;
SELECT 'nor does it give less than the least', pg_temp.radius(1) = 1;
UPDATE town.axis SET speed = 50 WHERE axis_id = 1;
SELECT format('turning_radius refuses the bounds %s to %s', low, high), test.state(format('SELECT streetgen.turning_radius(30, 7, ''paper'', %L, %L)', low, high)) = '22023'
    FROM (VALUES (-1::float8, 15::float8), (16, 15), ('NaN', 15), (0, 'NaN'), (0, 'Infinity')) v(low, high);
SELECT 'the least cannot pass the most', test.state($$SELECT streetgen.set('town', 'turning_radius_minimal', '3.1')$$) = '22023' AND test.state($$SELECT streetgen.set('town', 'turning_radius_maximal', '2.9')$$) = '22023';
SELECT streetgen.set('town', 'turning_radius_maximal', '15'), streetgen.set('town', 'turning_radius_minimal', '0.15') FROM streetgen.generate('town') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null

-- A predictor that tells which arguments came.
CREATE FUNCTION public.told(width float8, speed float8, importance integer, lane_count integer, kind text) RETURNS float8 LANGUAGE sql IMMUTABLE
    AS $$ SELECT CASE WHEN kind = 'residential' THEN width + speed / 100 + importance / 1000.0 + lane_count / 10000.0 END $$;
SELECT streetgen.set('town', 'radius_function', 'told') \g /dev/null
SELECT 'the setting keeps its name with the schema', value = 'public.told' FROM town.setting WHERE name = 'radius_function';
SELECT 'the predictor gets width, speed, importance, lanes and kind', abs(pg_temp.radius(2) - (6 + 0.30 + 0.003 + 0.0002)) < 1e-12;
SELECT 'where it says NULL the rule of the model holds', pg_temp.radius(1) = 15;
SELECT 'what the axis says comes first', pg_temp.radius(3) = 4;
SELECT 'streets computed before are stale', (test.refusal($$SELECT streetgen.generate('town', '{1}')$$)).state = '55000';
SELECT streetgen.generate('town') \g /dev/null
SELECT 'the corner wants it', bool_and(radius_wanted = least(pg_temp.radius(a.axis_id), pg_temp.radius(b.axis_id))) AND count(*) = 3
    FROM town.corner JOIN town.edge a ON a.edge_id = edge_a JOIN town.edge b ON b.edge_id = edge_b;
CREATE TABLE before AS SELECT corner_id, radius_wanted FROM town.corner;
CREATE OR REPLACE FUNCTION public.told(width float8, speed float8, importance integer, lane_count integer, kind text) RETURNS float8 LANGUAGE sql IMMUTABLE AS 'SELECT 2.0::float8';
SELECT 'another definition makes the streets stale', count(*) = 1 FROM streetgen.check_model('town') WHERE rule LIKE 'stale: settings changed since%';
UPDATE town.axis SET width = 6.5 WHERE axis_id = 2;
SELECT 'and an edit does not mix old and new', bool_and(radius_wanted = b.radius_wanted) FROM town.corner c JOIN before b USING (corner_id, radius_wanted);
SELECT streetgen.generate('town') \g /dev/null
SELECT 'until generate', bool_and(radius_wanted = 2) FROM town.corner;
SELECT 'and finds then nothing to do', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');

-- What it gives is proven, and the axis named.
CREATE TABLE wrong(said, body, state) AS VALUES ('NaN', '''NaN''::float8', '22023'), ('Infinity', '''Infinity''::float8', '22023'), ('-1', '-1::float8', '22023'), ('201', '201::float8', '22023'),
    ('division by zero', '1 / (lane_count - lane_count)::float8', '22012');
SELECT format('a predictor that gives %s is refused, and names the axis', wrong.said), r.state = wrong.state AND r.said ~ 'radius function public.told .*axis [12]' AND r.said LIKE '%' || wrong.said || '%' AND r.hint <> ''
    FROM wrong, LATERAL test.refusal(format($q$
    CREATE OR REPLACE FUNCTION public.told(width float8, speed float8, importance integer, lane_count integer, kind text) RETURNS float8 LANGUAGE sql IMMUTABLE AS %L;
    SELECT streetgen.generate('town')$q$, 'SELECT ' || body)) r;
CREATE FUNCTION public.silent(width float8, speed float8, importance integer, lane_count integer, kind text) RETURNS float8 LANGUAGE sql IMMUTABLE AS 'SELECT NULL::float8';
SELECT streetgen.set('town', 'radius_function', 'public.silent') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
SELECT streetgen.create_model('plain', 2154) \g /dev/null
INSERT INTO plain.axis (axis_id, geom, width, speed, importance, lane_count, kind, radius) SELECT axis_id, geom, width, speed, importance, lane_count, kind, radius FROM town.axis;
SELECT 'one that knows nothing changes nothing', test.same('town', 'plain');

-- Which functions it may be.
CREATE FUNCTION public.moody(float8, float8, integer, integer, text) RETURNS float8 LANGUAGE sql AS 'SELECT random()';
CREATE FUNCTION public.integral(float8, float8, integer, integer, text) RETURNS integer LANGUAGE sql IMMUTABLE AS 'SELECT 1';
CREATE FUNCTION public.several(float8, float8, integer, integer, text) RETURNS SETOF float8 LANGUAGE sql IMMUTABLE AS 'SELECT 1.0::float8';
SELECT format('radius_function cannot be %s', quote_literal(name)), (r).state = '22023' AND (r).said LIKE '%radius_function%' AND (r).hint <> '' AND (r).detail <> ''
    FROM unnest(ARRAY['public.moody', 'public.integral', 'public.several', 'nowhere', '', ' ', 'a.b.c.d', 'told(', 'random(); SELECT 1 --']) name,
    LATERAL (SELECT test.refusal(format('SELECT streetgen.set(''town'', ''radius_function'', %L)', name)) AS r) t;
SELECT streetgen.set('town', 'radius_function', NULL) \g /dev/null
SELECT 'NULL takes it back', value IS NULL FROM town.setting WHERE name = 'radius_function';
SELECT streetgen.set('town', 'radius_function', 'public.silent') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
DROP FUNCTION public.silent(float8, float8, integer, integer, text);
SELECT 'generate refuses one that is gone', (r).state = '22023' AND (r).said LIKE '%radius_function%public.silent%' FROM (SELECT test.refusal('SELECT streetgen.generate(''town'')') AS r) t;
SELECT 'check_model still tells', count(*) = 1 FROM streetgen.check_model('town') WHERE rule LIKE 'stale: settings changed since%';
SELECT 'and edits are stored', test.state('UPDATE town.axis SET width = 6.6 WHERE axis_id = 2') = 'none';

-- The rule by which a corner takes the radii of its two axes.
SELECT streetgen.create_model('ruled', 2154) \g /dev/null
INSERT INTO ruled.axis (axis_id, geom, width, importance, radius) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 9, 4, 8), (2, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 6, 3, 4);
CREATE FUNCTION pg_temp.by_rule(rule text) RETURNS float8[] LANGUAGE plpgsql AS $$ BEGIN PERFORM streetgen.set('ruled', 'radius_rule', rule), streetgen.generate('ruled'); RETURN (SELECT array_agg(DISTINCT radius_wanted) FROM ruled.corner); END $$;
SELECT format('radius_rule %s wants %s', rule, wanted), pg_temp.by_rule(rule) = ARRAY[wanted] FROM (VALUES ('max', 8::float8), ('mean', 6), ('min', 4), ('major', 4)) v(rule, wanted);
UPDATE ruled.axis SET importance = 4;
SELECT 'of two equally important streets the wider one is the major one', (SELECT array_agg(DISTINCT radius_wanted) FROM ruled.corner) = '{8}' AND pg_temp.by_rule('major') = '{8}';
UPDATE ruled.axis SET width = 6;
SELECT 'of two alike the lesser radius counts', (SELECT array_agg(DISTINCT radius_wanted) FROM ruled.corner) = '{4}';

-- Nobody gains a right: an edit by an editor computes with the rights of the owner of the model.
CREATE ROLE owner_of_town ROLE CURRENT_USER; CREATE ROLE editor_of_town ROLE CURRENT_USER; CREATE ROLE stranger ROLE CURRENT_USER;
DO $$ BEGIN EXECUTE format('GRANT CREATE ON DATABASE %I TO owner_of_town', current_database()); END $$;
GRANT CREATE ON SCHEMA public TO owner_of_town;
-- An editor would not lend the rights of the owner where a stranger may make functions beside PostGIS.
CREATE SCHEMA aside;
GRANT CREATE, USAGE ON SCHEMA aside TO owner_of_town, stranger;
GRANT USAGE ON SCHEMA aside TO editor_of_town;
GRANT USAGE ON SCHEMA test TO PUBLIC;
SET ROLE stranger;
CREATE FUNCTION aside.theirs(float8, float8, integer, integer, text) RETURNS float8 LANGUAGE sql IMMUTABLE AS 'SELECT 3.0::float8';
SET ROLE owner_of_town;
SELECT streetgen.create_model('owned', 2154), streetgen.grant('owned', 'editor_of_town', 'editor') \g /dev/null
CREATE FUNCTION aside.ours(float8, float8, integer, integer, text) RETURNS float8 LANGUAGE plpgsql IMMUTABLE
    AS $$ BEGIN RETURN CASE current_user WHEN 'owner_of_town' THEN 5 END; END $$;
INSERT INTO owned.axis (axis_id, geom, width) SELECT axis_id, ST_Force2D(geom), 6 FROM (VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)'::geometry), (2, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)')) v(axis_id, geom);
SELECT 'a function of somebody else is refused', (r).state = '42501' AND (r).detail LIKE '%stranger%' AND (r).hint LIKE '%OWNER TO owner_of_town%'
    FROM (SELECT test.refusal($$SELECT streetgen.set('owned', 'radius_function', 'aside.theirs')$$) AS r) t;
SELECT 'so it is where the setting was written by hand', (r).state = '42501'
    FROM (SELECT test.refusal($$UPDATE owned.setting SET value = 'aside.theirs' WHERE name = 'radius_function'; SELECT streetgen.generate('owned')$$) AS r) t;
SELECT 'one of the owner is taken', test.state($$SELECT streetgen.set('owned', 'radius_function', 'aside.ours')$$) = 'none';
SELECT streetgen.generate('owned') \g /dev/null
SET ROLE editor_of_town;
SELECT 'an editor''s edit computes with it', test.state('UPDATE owned.axis SET width = 7 WHERE axis_id = 1') = 'none' AND (SELECT bool_and(radius_wanted = 5) FROM owned.corner);
SELECT 'an editor cannot set it', test.state($$SELECT streetgen.set('owned', 'radius_function', NULL)$$) = '42501' AND test.state($$UPDATE owned.setting SET value = 'aside.theirs'$$) = '42501';
RESET ROLE;
REVOKE EXECUTE ON FUNCTION aside.ours(float8, float8, integer, integer, text) FROM PUBLIC, owner_of_town;
SELECT 'nor is one that the owner may not call', (r).state = '42501' AND (r).detail LIKE '%may not call it%' FROM (SELECT test.refusal($$SELECT streetgen.generate('owned')$$) AS r) t;
GRANT EXECUTE ON FUNCTION aside.ours(float8, float8, integer, integer, text) TO owner_of_town;
ALTER FUNCTION aside.ours(float8, float8, integer, integer, text) OWNER TO stranger;
SELECT 'nor one that was given away since', (r).state = '42501' FROM (SELECT test.refusal($$SELECT streetgen.generate('owned')$$) AS r) t;
SELECT streetgen.drop_model('owned') \g /dev/null
DROP OWNED BY owner_of_town, editor_of_town, stranger;
DROP ROLE owner_of_town, editor_of_town, stranger;
