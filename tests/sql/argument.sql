\set ECHO none
\ir shared/truths.sql
-- NULL for an argument without a default, of every public function: refused by name, or its comment says what NULL means.
-- Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('argued', 2154) \g /dev/null
INSERT INTO argued.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7), ('SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 9);
SELECT FROM streetgen.generate('argued') \g /dev/null
CREATE TABLE survey (id integer, geom geometry(LineString, 2154));

-- Values that would do, by name of the argument; of one name in several functions, by the type too.
CREATE TABLE good (name text, type regtype, value text);
INSERT INTO good VALUES ('model', 'name', '''argued'''), ('schema', 'name', '''argued'''), ('source', 'regclass', '''survey'''), ('samples', 'regclass', '''survey'''), ('mapping', 'jsonb', '''{"source_ref": "id"}'''), ('topology', 'name', '''network'''), ('topology', 'text', '''network'''),
    ('setting', 'text', '''tolerance'''), ('type', 'text', '''lamp'''), ('relation', 'name', '''shelter'''), ('value', 'text', '''0.4'''), ('role', 'name', '''public'''), ('kind', 'text', '''general'''), ('row_id', 'bigint', '1'), ('column_name', 'text', '''name'''), ('holds', 'text', '''hand'''), ('live', 'boolean', 'true'), ('node', 'bigint', '1'), ('k', 'integer', '1'), ('srid', 'integer', '2154'),
    ('x', 'float8', '650000'), ('y', 'float8', '6860000'), ('at_x', 'float8', '650100'), ('at_y', 'float8', '6860100'), ('width', 'float8', '1000'), ('height', 'float8', '1000'), ('seed', 'bigint', '1'),
    ('axis', 'geometry', '''LINESTRING(0 0,50 0)'''), ('axis_a', 'geometry', '''LINESTRING(0 0,50 0)'''), ('axis_b', 'geometry', '''LINESTRING(0 0,0 50)'''), ('line', 'geometry', '''LINESTRING(0 0,50 0)'''),
    ('lane_in', 'geometry', '''LINESTRING(-20 0,-5 0)'''), ('lane_out', 'geometry', '''LINESTRING(0 5,0 20)'''), ('centre', 'geometry', '''POINT(0 0)'''), ('axes', 'geometry[]', 'ARRAY[''LINESTRING(0 0,50 0)'', ''LINESTRING(0 0,0 50)'']::geometry[]'),
    ('widths', 'float8[]', '''{7,7}'''), ('radii', 'float8[]', '''{5,5}'''), ('keep', 'boolean[]', '''{}'''), ('epsilon', 'float8', '0.1'), ('r_min', 'float8', '1'), ('radius', 'float8', '5'), ('width_a', 'float8', '7'), ('width_b', 'float8', '7'),
    ('abscissa', 'float8', '10'), ('start_abscissa', 'float8', '10'), ('end_abscissa', 'float8', '40'), ('axis_offset', 'float8', '1'), ('speed', 'float8', '50'), ('importance', 'integer', '3'), ('mode', 'text', '''paper'''),
    ('lane_count', 'integer', '2'), ('max_width_per_lane', 'float8', '5'), ('class_width', 'float8', '7'), ('lane_width', 'float8', '3.5'), ('width_default', 'float8', '6'), ('speed_by_importance', 'jsonb', '''{"3": 50}'''), ('speed_per_width', 'float8', '6'),
    ('radius_by_importance', 'text', '''{"3": 5}'''), ('kinds', 'text', '''general|cycle'''), ('list', 'text', '''general'''), ('cycle_lane_width', 'float8', '1.5'), ('parking_lane_width', 'float8', '2'), ('open', 'boolean', 'true'), ('listed', 'boolean', 'false'),
    ('stated', 'integer', '1'), ('against', 'integer', '1'), ('driving', 'integer', '2'), ('buses', 'text', '''|designated'''), ('bus', 'boolean', 'true'), ('driving_side', 'text', '''right'''), ('near_cycle', 'boolean', 'true'), ('far_cycle', 'boolean', 'false'),
    ('near_parking', 'boolean', 'false'), ('far_parking', 'boolean', 'false'), ('run', 'text', '''a'''), ('density', 'float8', '5'), ('car_id', 'bigint', '1'), ('from_link', 'bigint', '5'), ('to_link', 'bigint', '5'),
    ('stated_forward', 'integer', '0'), ('stated_backward', 'integer', '0'), ('narrow', 'boolean', 'true'), ('walked_along', 'boolean', 'true'), ('subject', 'text', '''lane'''), ('wanted', 'boolean', 'true'),
    ('road', 'geometry', '''LINESTRING(0 0,50 0)'''), ('metres', 'float8', '10'), ('road_id', 'bigint', '1'), ('point', 'geometry', '''POINT(10 1)'''), ('a', 'geometry', '''POINT(10 1)'''), ('b', 'geometry', '''POINT(20 1)'''),
    ('arms', 'streetgen.junction_arm[]', '''{}'''), ('lane', 'bigint', '1'), ('axis', 'bigint', '1'), ('side', 'text', '''left'''),
    ('kerb', 'geometry', '''LINESTRING(0 4,50 4)'''), ('kerb_left', 'geometry', '''LINESTRING(0 4,50 4)'''), ('kerb_right', 'geometry', '''LINESTRING(0 -4,50 -4)'''), ('width_start', 'float8', '2'), ('width_end', 'float8', '2'),
    ('lines', 'geometry[]', 'ARRAY[''LINESTRING(0 0,50 0)'', ''LINESTRING(0 4,50 4)'']::geometry[]'), ('part', 'text', '''edges'''),
    ('roadway_offset', 'float8', '1'), ('offset_left', 'float8', '3'), ('offset_right', 'float8', '-3'),
    ('on_circle', 'float8', '1'), ('compactness', 'float8', '0.9'), ('one_way', 'float8', '1'), ('against', 'float8', '0'), ('arm_nodes', 'integer', '4'), ('single_arm', 'float8', '1'), ('inside', 'integer', '0'),
    ('names', 'text[]', '''{Ring}'''), ('patterns', 'text[]', '''{ring}'''), ('shape', 'float8', '1'), ('name', 'float8', '1'), ('network', 'float8', '1'), ('weights', 'float8[]', '''{1,1,1}'''),
    ('elements', 'streetgen.alignment_element[]', '(SELECT array_agg(e) FROM streetgen.horizontal_alignment(''LINESTRING(0 0,50 0)'', ''{0,0}'', ''{0,0}'') e)'), ('clothoids', 'float8[]', '''{0,0}'''),
    ('abscissas', 'float8[]', '''{0,50}'''), ('heights', 'float8[]', '''{1,2}'''), ('start', 'geometry', '''POINT(0 0)'''), ('heading', 'float8', '0'), ('heading_from', 'float8', '0'), ('heading_to', 'float8', '1'), ('path', 'geometry', '''LINESTRING(0 0,50 0)'''), ('length', 'float8', '10'), ('curvature_start', 'float8', '0'), ('curvature_end', 'float8', '0.01'),
    ('population_a', 'float8', '5'), ('population_b', 'float8', '5'), ('alternative', 'float8', '20'), ('step', 'float8', '1'), ('extent', 'float8', '20'), ('place', 'geometry', '''POINT(0 0)'''), ('network', 'text', '''rural'''), ('link', 'bigint', '1'),
    ('axes', 'bigint[]', '''{1}'''), ('ids', 'bigint[]', '''{}'''), ('movements', 'streetgen.signal_request[]', '''{}'''), ('controller', 'bigint', '1'), ('at', 'float8', '0'),
    ('other', 'geometry', '''LINESTRING(0 2,50 2)'''), ('area', 'geometry', '''POLYGON((0 0,9 0,9 9,0 0))'''), ('count', 'integer', '3'), ('fit_run', 'bigint', '1'), ('forest', 'float8[]', '''{1,1,1,-1,5,0,0}'''), ('features', 'float8[]', '''{3}''');

CREATE TABLE given AS
SELECT p.oid, p.oid::regprocedure::text AS signature, p.proname AS function, p.prokind, p.proretset, coalesce(obj_description(p.oid, 'pg_proc'), '') AS said_of_it, i AS place, p.proargnames[i] AS name, g.value
FROM pg_proc p CROSS JOIN LATERAL generate_series(1, p.pronargs - p.pronargdefaults) i LEFT JOIN good g ON g.name = p.proargnames[i] AND g.type = p.proargtypes[i - 1]
WHERE p.pronamespace = 'streetgen'::regnamespace AND p.proname NOT LIKE '\_%' AND p.prorettype <> 'trigger'::regtype;
SELECT 'a value is known for ' || signature || ' ' || name, value IS NOT NULL FROM given ORDER BY signature COLLATE "C", place;

CREATE FUNCTION pg_temp.calling(asked oid, null_at integer) RETURNS text LANGUAGE sql AS $$
    SELECT format(CASE WHEN prokind = 'p' THEN 'CALL %s' WHEN proretset THEN 'CREATE TEMPORARY TABLE answer AS SELECT 1 FROM %s' ELSE 'CREATE TEMPORARY TABLE answer AS SELECT 1 FROM (SELECT %s AS result) a WHERE result IS NOT NULL' END,
        'streetgen.' || quote_ident(function) || '(' || string_agg(CASE place WHEN null_at THEN 'NULL' ELSE value END, ', ' ORDER BY place) || ')')
    FROM given WHERE oid = asked GROUP BY function, prokind, proretset $$;
-- What the call gives: rows that are not NULL, or the refusal. What it did is taken back.
CREATE FUNCTION pg_temp.answer(call text, OUT rows bigint, OUT state text, OUT said text) LANGUAGE plpgsql AS $$
BEGIN
    EXECUTE call;
    GET DIAGNOSTICS rows = ROW_COUNT;
    RAISE EXCEPTION USING ERRCODE = 'TAKEN';
EXCEPTION WHEN OTHERS THEN
    state := CASE SQLSTATE WHEN 'TAKEN' THEN 'none' ELSE SQLSTATE END;
    said := SQLERRM;
END $$;
CREATE TABLE answered AS SELECT g.*, a.* FROM given g, LATERAL pg_temp.answer(pg_temp.calling(oid, place)) a;
SELECT format('NULL for %s of %s: %s', name, function, concat_ws(' ', state, said)),
    CASE WHEN said_of_it ~ 'NULL for (NULL|anything)' THEN state = 'none' AND rows = 0
         WHEN said_of_it ~ 'An argument that is NULL is unknown' THEN state = 'none'
         WHEN said_of_it ~ (name || ' that are NULL are none') THEN state = 'none'
         ELSE state = '22004' AND said ~ ('\m' || name || '\M') END
FROM answered ORDER BY signature COLLATE "C", place;
SELECT 'an argument with a default that NULL does not suit is refused too', bool_and((r).state = '22004' AND (r).said = 'argument ' || name || ' is NULL' AND (r).hint <> '')
FROM (VALUES ('prefix', 'SELECT streetgen.import_osm(''argued'', NULL)'), ('schemas', 'SELECT streetgen.import_osm(''argued'', ''osm'', NULL)'), ('dimension', 'SELECT streetgen.create_model(''other'', 2154, NULL)'),
    ('wgs84', 'SELECT streetgen.export_layer(''argued'', NULL)'), ('legend', 'SELECT streetgen.svg(''argued'', legend => NULL)')) v(name, call), LATERAL (SELECT test.refusal(call) AS r) t;
-- Its values from an index are not exact to the last digit, and PostgreSQL may refuse the order.
SELECT 'no function orders by <->', NOT EXISTS (SELECT FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace AND prosrc LIKE '%<->%');
