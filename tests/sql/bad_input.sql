\set ECHO none
\ir shared/truths.sql
-- Bad input gets a result or one clear error that names the argument or row; the model is as it was.
-- Each test is a row (name, holds).

-- Primitives: every bad geometry and number at every place of every call.
CREATE TABLE primitive AS SELECT * FROM (VALUES
    ('SELECT streetgen.arc_centre({axis_a}, {axis_b}, {width_a}, {width_b}, {radius})'),
    ('SELECT streetgen.corner_arc({axis_a}, {axis_b}, {width_a}, {width_b}, {radius})'),
    ('SELECT streetgen.max_corner_radius({axis_a}, {axis_b}, {width_a}, {width_b})'),
    ('SELECT streetgen.border_line({axis}, {abscissa}, {width})'),
    ('SELECT streetgen.section_surface({axis}, {width}, {start_abscissa}, {end_abscissa})'),
    ('SELECT streetgen.intersection_surface(ARRAY[{axis 1}, {axis 2}], ARRAY[{width}, 6]::float8[], ARRAY[{radius}, 3]::float8[], {curved})'),
    ('SELECT streetgen.variable_buffer({line}, ARRAY[{radius}, 3]::float8[], {side}, {ends})'),
    ('SELECT streetgen.clean({line}, ''{}''::boolean[], {epsilon}, {r_min})'),
    ('SELECT streetgen.turning_radius({speed}, {width}, {mode})')) p(call);
CREATE TABLE argument(name, kind, good) AS VALUES
    ('axis_a', 'line', '''LINESTRING(0 0,50 0)''::geometry'), ('axis_b', 'line', '''LINESTRING(0 0,0 50)''::geometry'), ('axis', 'line', '''LINESTRING(0 0,50 0)''::geometry'),
    ('axis 1', 'line', '''LINESTRING(0 0,50 0)''::geometry'), ('axis 2', 'line', '''LINESTRING(0 0,0 50)''::geometry'), ('line', 'line', '''LINESTRING(0 0,50 0)''::geometry'),
    ('width_a', 'width', '7'), ('width_b', 'width', '6'), ('width', 'width', '7'), ('radius', 'radius', '4'), ('epsilon', 'radius', '0.3'), ('r_min', 'radius', '3'), ('speed', 'radius', '30'),
    ('abscissa', 'abscissa', '10'), ('start_abscissa', 'abscissa', '10'), ('end_abscissa', 'abscissa', '40'),
    ('side', 'word', '''both'''), ('ends', 'word', '''flat'''), ('mode', 'word', '''paper'''), ('curved', 'truth', 'false');
CREATE TABLE bad(kind, value, state) AS
    SELECT 'line', g, '22023' FROM unnest(ARRAY['''POINT(1 1)''::geometry', '''POLYGON((0 0,1 0,1 1,0 0))''::geometry', '''MULTIPOINT(0 0,1 1)''::geometry',
        '''MULTILINESTRING((0 0,1 0),(2 0,3 0))''::geometry', '''GEOMETRYCOLLECTION(LINESTRING(0 0,1 0))''::geometry', '''CIRCULARSTRING(0 0,1 1,2 0)''::geometry',
        '''COMPOUNDCURVE((0 0,1 0))''::geometry', '''LINESTRING EMPTY''::geometry', '''LINESTRING(5 5,5 5)''::geometry', '''LINESTRING M(0 0 1,1 0 1)''::geometry',
        '''LINESTRING ZM(0 0 1 1,1 0 1 1)''::geometry', '''TIN(((0 0,1 0,1 1,0 0)))''::geometry', '''LINESTRING(0 0,1e13 0)''::geometry', '''LINESTRING Z(0 0 0,1 0 -1e13)''::geometry',
        'ST_MakeLine(ARRAY[ST_MakePoint(0, 0), ST_MakePoint(''NaN'', 0), ST_MakePoint(5, 5)])', 'ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint(0, ''-Infinity''))',
        'ST_MakeLine(ST_MakePoint(0, 0, ''NaN''), ST_MakePoint(5, 5, 0))']) g
    UNION ALL SELECT 'width', v, '22023' FROM unnest(ARRAY['''NaN''', '''Infinity''', '''-Infinity''', '0', '''-0''', '-1', '200.1', '1e308', '5e-324']) v
    UNION ALL SELECT 'radius', v, '22023' FROM unnest(ARRAY['''NaN''', '''Infinity''', '''-Infinity''', '-1', '1001', '1e308']) v
    UNION ALL SELECT 'abscissa', v, '22023' FROM unnest(ARRAY['''NaN''', '''Infinity''', '''-Infinity''']) v
    UNION ALL SELECT 'word', v, '22023' FROM unnest(ARRAY['''''', '''Both''', '''; DROP TABLE bad''']) v;
CREATE FUNCTION pg_temp.filled(call text, name text, value text) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    a record;
BEGIN
    call := replace(call, '{' || name || '}', value);
    FOR a IN SELECT * FROM argument LOOP
        call := replace(call, '{' || a.name || '}', a.good);
    END LOOP;
    RETURN call;
END $$;
CREATE TABLE tried AS SELECT p.call, a.name, b.value, b.state AS wanted, r.*
    FROM primitive p JOIN argument a ON strpos(p.call, '{' || a.name || '}') > 0 JOIN bad b USING (kind), LATERAL test.refusal(pg_temp.filled(p.call, a.name, b.value)) r;
SELECT 'good arguments give a result: ' || call, state = 'none' FROM primitive, LATERAL test.refusal(pg_temp.filled(call, 'none', '')) r;
SELECT format('%s refuses every bad %s, naming it: %s', substring(call FROM 'streetgen\.\w+'), name, coalesce(string_agg(concat_ws(' ', value, state, said), '; ') FILTER (WHERE NOT holds), 'all')), bool_and(holds)
    FROM (SELECT *, state = wanted AND said LIKE '%' || name || '%' AS holds FROM tried) t GROUP BY call, name;
SELECT 'a NULL argument gives NULL: ' || substring(call FROM 'streetgen\.\w+') || ' ' || name, (r).state = 'none' OR kind <> 'word' AND call ~ 'ARRAY' AND (r).state = '22004'
    FROM (SELECT call, name, kind, test.refusal(pg_temp.filled(call, name, 'NULL')) AS r FROM primitive JOIN argument ON strpos(call, '{' || name || '}') > 0) t;
SELECT 'numbers at the rim give a result: ' || call, state = 'none' FROM (VALUES
    ('SELECT streetgen.border_line(''LINESTRING(0 0,50 0)'', -1e308, 0.001)'), ('SELECT streetgen.border_line(''LINESTRING(0 0,50 0)'', 1e308, 200)'),
    ('SELECT streetgen.section_surface(''LINESTRING(0 0,50 0)'', 200, -1e308, 1e308)'), ('SELECT streetgen.section_surface(''LINESTRING(0 0,50 0)'', 7, 40, 10)'),
    ('SELECT streetgen.section_surface(''LINESTRING(0 0,1e-300 0)'', 7, 0, 10)'), ('SELECT streetgen.section_surface(''LINESTRING(0 0,0 0,20 0,20 0,0 0,0 0)'', 7, 0, 40)'),
    ('SELECT streetgen.corner_arc(''LINESTRING(0 0,50 0)'', ''LINESTRING(0 0,50 0)'', 7, 7, 5)'), ('SELECT streetgen.corner_arc(''LINESTRING(0 0,50 0)'', ''LINESTRING(9 9,50 0)'', 7, 7, 1000)'),
    ('SELECT streetgen.max_corner_radius(''LINESTRING(0 0,1e9 0)'', ''LINESTRING(0 0,-1e9 0)'', 200, 200)'), ('SELECT streetgen.variable_buffer(''LINESTRING(0 0,50 0)'', ''{0,0}'')'),
    ('SELECT streetgen.variable_buffer(''LINESTRING(0 0,50 0)'', ''{1000,0}'', ''left'', ''round'')'), ('SELECT streetgen.clean(''LINESTRING(0 0,9 9,0 0)'', ''{}'', 1000, 1000)'),
    ('SELECT streetgen.intersection_surface(ARRAY[''LINESTRING(0 0,5 0)'', ''LINESTRING(0 0,5 0)'', ''LINESTRING(0 0,5 0)'']::geometry[], ''{7,7,7}'', ''{5,5,5}'')'),
    ('SELECT streetgen.section_surface(''MULTILINESTRING((0 0,50 0))'', 7, 0, 10)')) v(call), LATERAL test.refusal(call) r;
SELECT 'a list of radii without elements is 22023', (test.refusal('SELECT streetgen.variable_buffer(''LINESTRING(0 0,50 0)'', ''{}'')')).state = '22023';
SELECT 'no axes make an empty intersection', ST_IsEmpty(streetgen.intersection_surface('{}'::geometry[], '{}', '{}'));

-- Axes, written directly.
SELECT streetgen.create_model('town', 2154), streetgen.live('town', false) \g /dev/null
SELECT streetgen.create_model('hill', 2154, 3) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, source, source_ref) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 'by hand', 'a'), (2, 'SRID=2154;LINESTRING(650100 6860000,650100 6860090)', 6, 'by hand', 'b');
INSERT INTO hill.axis (axis_id, geom) VALUES (1, 'SRID=2154;LINESTRING Z(650000 6860000 35,650100 6860000 36)');
SELECT streetgen.generate('town') \g /dev/null
CREATE FUNCTION pg_temp.content() RETURNS text LANGUAGE sql AS $$
    SELECT md5(concat((SELECT string_agg(concat(a.xmin, a.*), ',' ORDER BY axis_id) FROM town.axis a), (SELECT string_agg(concat(a.xmin, a.*), ',' ORDER BY axis_id) FROM hill.axis a),
        (SELECT string_agg(concat(e.xmin, e.*), ',' ORDER BY edge_id) FROM town.edge e), (SELECT string_agg(concat(s.xmin, s.*), ',' ORDER BY edge_id) FROM town.section s),
        (SELECT string_agg(concat(n.xmin, n.*), ',' ORDER BY node_id) FROM town.node n))) $$;
CREATE TABLE before AS SELECT pg_temp.content() AS content;
SELECT 'an axis refuses ' || statement, state = wanted FROM (VALUES
    ('UPDATE town.axis SET width = ''NaN'' WHERE axis_id = 1', '23514'), ('UPDATE town.axis SET width = 1e308', '23514'), ('UPDATE town.axis SET width = ''wide''', '22P02'),
    ('UPDATE town.axis SET width_end = -1', '23514'), ('UPDATE town.axis SET width_end = ''Infinity''', '23514'), ('UPDATE town.axis SET speed = -5', '23514'),
    ('UPDATE town.axis SET speed = ''Infinity''', '23514'), ('UPDATE town.axis SET speed = 401', '23514'), ('UPDATE town.axis SET radius = 201', '23514'), ('UPDATE town.axis SET radius = ''NaN''', '23514'),
    ('UPDATE town.axis SET lane_count = 31', '23514'), ('UPDATE town.axis SET importance = 100', '23514'), ('UPDATE town.axis SET level = 51', '23514'), ('UPDATE town.axis SET level = -51', '23514'),
    ('UPDATE town.axis SET level = NULL', '23502'), ('UPDATE town.axis SET direction = NULL', '23502'), ('UPDATE town.axis SET direction = ''''', '23514'), ('UPDATE town.axis SET axis_id = 2 WHERE axis_id = 1', '23505'),
    ('UPDATE town.axis SET source_ref = ''a''', '23505'), ('UPDATE town.axis SET geom = NULL', '23502'), ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING EMPTY''', '23514'),
    ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING(1 1,1 1,1 1)''', '23514'), ('UPDATE town.axis SET geom = ''SRID=3857;LINESTRING(1 1,2 2)''', '22023'), ('UPDATE town.axis SET geom = ''SRID=4326;LINESTRING(1 1,2 2)''', '22023'),
    ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING(0 0,1e13 0)''', '23514'), ('UPDATE town.axis SET geom = ''SRID=2154;LINESTRING Z(0 0 0,1 1 1)''', '22023'),
    ('UPDATE town.axis SET geom = ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(0, 0), ST_MakePoint(0, ''NaN''), ST_MakePoint(5, 5)]), 2154)', '23514'),
    ('UPDATE town.axis SET geom = ''LINESTRING garbage''', 'XX000'),
    ('UPDATE hill.axis SET geom = ''SRID=2154;LINESTRING(0 0,1 1)''', '22023'), ('UPDATE hill.axis SET geom = ''SRID=2154;LINESTRING Z(0 0 0,1 1 1e13)''', '23514'),
    ('UPDATE hill.axis SET geom = ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(0, 0, 0), ST_MakePoint(3, 3, ''NaN''), ST_MakePoint(5, 5, 0)]), 2154)', '23514'),
    ('UPDATE hill.axis SET geom = ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 0, ''Infinity''), ST_MakePoint(5, 5, 0)), 2154)', '23514')) v(statement, wanted), LATERAL test.refusal(statement) r;

-- generate: what it is asked, and what it finds.
SELECT 'generate: ' || call, state = wanted FROM (VALUES
    ('SELECT streetgen.generate(NULL)', '22004'), ('SELECT streetgen.generate(''no such'')', '3F000'), ('SELECT streetgen.generate(''town"; DROP TABLE before; --'')', '3F000'), ('SELECT streetgen.generate(''public'')', '3F000'),
    ('SELECT streetgen.generate(''town'', ''{}'')', 'none'), ('SELECT streetgen.generate(''town'', ''{NULL,-1,9223372036854775807}'')', 'none'), ('SELECT streetgen.generate(''town'', ''{1,1,1}'')', 'none')) v(call, wanted),
    LATERAL test.refusal(call) r;
SELECT 'what was refused changed no row', content = pg_temp.content() FROM before;
-- A column that lost its constraints: the border names the row.
ALTER TABLE town.axis DROP CONSTRAINT geom_is_a_finite_line;
CREATE TABLE found (what text, state text, said text);
DO $$
DECLARE
    w record;
BEGIN
    FOR w IN SELECT * FROM (VALUES ('line is empty', 'LINESTRING EMPTY'::geometry), ('line has no length', 'LINESTRING(1 1,1 1)'),
        ('vertex is NaN', ST_MakeLine(ARRAY[ST_MakePoint(0, 0), ST_MakePoint('NaN', 0), ST_MakePoint(5, 5)]))) v(what, line)
    LOOP
        INSERT INTO town.axis (axis_id, geom, width) VALUES (3, ST_SetSRID(w.line, 2154), 7);
        INSERT INTO found SELECT w.what, r.state, r.said FROM test.refusal('SELECT streetgen.generate(''town'')') r;
        DELETE FROM town.axis WHERE axis_id = 3;
    END LOOP;
END $$;
SELECT 'generate names the axis whose ' || what, state = '22023' AND said LIKE '%axis 3%' FROM found;
SELECT 'what generate refused changed no row', content = pg_temp.content() FROM before;
ALTER TABLE town.axis ADD CONSTRAINT geom_is_a_finite_line CHECK (ST_Length(geom) > 0);

-- Awkward lines that an axis may be: a result, or a row of report; each alone and all in one model.
CREATE TABLE awkward(axis_id, line) AS VALUES
    (11, 'LINESTRING(0 0,0 0,40 0,40 0,40 0)'), (12, 'LINESTRING(1000 0,1040 0,1000 0)'), (13, 'LINESTRING(2000 0,2040 0,2010 0,2060 0)'), (14, 'LINESTRING(3000 0,3000 1e-9)'),
    (15, 'LINESTRING(4000 0,4040 40,4040 0,4000 40)'), (16, 'LINESTRING(5000 0,5001 0,5001 1,5000 1,5000 0)'),
    (19, 'LINESTRING(6000 0,6020 0,6000 0.01,6020 0.02)'), (20, 'LINESTRING(7000 0,7040 0)'), (21, 'LINESTRING(7000 0,7040 0)'), (22, 'LINESTRING(7040 0,7000 0)'), (23, 'LINESTRING(8000 0,8010 0,8020 0,8010 0,8010 30)');
CREATE TABLE alone (axis_id integer, state text, said text, edges bigint, reports bigint, errors bigint);
DO $$
DECLARE
    a record;
    r record;
BEGIN
    DELETE FROM town.axis;
    FOR a IN SELECT * FROM awkward LOOP
        INSERT INTO town.axis (axis_id, geom, width) VALUES (a.axis_id, ST_Translate(ST_GeomFromText(a.line, 2154), 650000, 6860000), 7);
        r := test.refusal('SELECT streetgen.generate(''town'')');
        INSERT INTO alone SELECT a.axis_id, r.state, r.said, (SELECT count(*) FROM town.edge), (SELECT count(*) FROM town.report), (SELECT count(*) FROM streetgen.check_model('town') WHERE severity = 'error');
        DELETE FROM town.axis;
    END LOOP;
    INSERT INTO town.axis (axis_id, geom, width) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 7 FROM awkward;
END $$;
SELECT format('%s alone: %s %s', line, state, said), state = 'none' AND edges + reports > 0 AND errors = 0 FROM alone JOIN awkward USING (axis_id);
SELECT 'all together are generated', (test.refusal('SELECT streetgen.generate(''town'')')).state = 'none';
SELECT 'every axis has edges or a report', NOT EXISTS (SELECT FROM town.axis a WHERE NOT EXISTS (SELECT FROM town.edge e WHERE e.axis_id = a.axis_id) AND NOT EXISTS (SELECT FROM town.report r WHERE r.axis_a = a.axis_id));
SELECT 'all together are sound', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';

-- import_axes: what tests/sql/import_axes.sql leaves open.
CREATE TABLE source (id integer, width float8, speed float8, radius float8, level integer, label text, geom geometry);
CREATE FUNCTION pg_temp.import_of(line text, number text, value text) RETURNS text LANGUAGE sql AS $$
    SELECT format('SELECT streetgen.import_axes(''town'', pg_temp.source_of(%L, %L, %L), ''{"source_ref": "id", "width": "width", "speed": "speed", "radius": "radius", "level": "level"}'')', line, number, value) $$;
CREATE FUNCTION pg_temp.source_of(line text, number text, value text) RETURNS regclass LANGUAGE plpgsql AS $$
BEGIN
    TRUNCATE source;
    INSERT INTO source (id, geom) VALUES (5, 'SRID=2154;LINESTRING(650900 6860900,650950 6860950)'), (77, line::geometry);
    EXECUTE format('UPDATE source SET %I = %L WHERE id = 77', number, value);
    RETURN 'source';
END $$;
CREATE TABLE imported AS SELECT axis_id, xmin AS written FROM town.axis;
CREATE FUNCTION pg_temp.unread(number text, value text, mapping text) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    told text;
BEGIN
    BEGIN
        SELECT what || ' ' || array_to_string(source_refs, ',') INTO told
            FROM streetgen.import_axes('town', pg_temp.source_of('SRID=2154;LINESTRING(650900 6860800,650950 6860800)', number, value), mapping::jsonb) WHERE what LIKE '%not understood%';
        RAISE EXCEPTION USING ERRCODE = 'P0099';
    EXCEPTION WHEN SQLSTATE 'P0099' THEN
        RETURN told;
    END;
END $$;
SELECT format('import_axes names the row with %s = %s', number, value), pg_temp.unread(number, value, '{"source_ref": "id", "width": "width", "speed": "speed", "radius": "radius", "level": "level"}')
        = number || ' not understood, taken as unknown 77' FROM (VALUES
    ('width', 'NaN'), ('width', 'Infinity'), ('width', '-1'), ('width', '200.1'), ('speed', 'NaN'), ('speed', '-30'), ('speed', '401'), ('radius', '-Infinity'), ('radius', '1e308'), ('level', '51')) v(number, value);
SELECT 'without a source_ref by its place: ' || number, pg_temp.unread(number, value, mapping) LIKE '% not understood, taken as unknown number 2' FROM (VALUES
    ('width', '-1', '{"width": "width"}'), ('level', '51', '{"level": "level"}'), ('label', 'wide', '{"lane_count": "label"}')) v(number, value, mapping);
SELECT 'import_axes names the row with ' || line, state = '22023' AND said LIKE '%77%' FROM (VALUES
    ('SRID=4326;LINESTRING(200 100,300 400)'), ('SRID=54321;LINESTRING(0 0,1 1)')) v(line),
    LATERAL test.refusal(pg_temp.import_of(line, 'id', '77')) r;
SELECT 'without a source_ref it names the row by its place: ' || line, state = '22023' AND said ~ 'row number 2\M' FROM (VALUES
    ('SRID=4326;LINESTRING(200 100,300 400)', 'id', '77'), ('LINESTRING(0 0,1 1)', 'id', '77'), ('SRID=2154;LINESTRING(0 0,NaN 1)', 'id', '77')) v(line, number, value),
    LATERAL test.refusal(replace(pg_temp.import_of(line, number, value), '{"source_ref": "id", ', '{')) r;
SELECT 'what import_axes refused changed no axis', count(*) = (SELECT count(*) FROM imported) AND bool_and(a.xmin = i.written) FROM town.axis a LEFT JOIN imported i USING (axis_id);
