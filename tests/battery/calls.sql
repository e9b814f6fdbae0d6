-- Random calls of every public function, which tests/battery/calls runs, and random statements on what a user may write, each undone.
CREATE SCHEMA calls;

-- The calls find a crossing, a street of three dimensions, a table of lines, a topology.
SELECT streetgen.create_model('town', 2154), streetgen.create_model('hill', 2154, 3) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) SELECT i, ST_SetSRID(ST_Translate(line::geometry, 650000, 6860000), 2154), 5 + i
FROM (VALUES (1, 'LINESTRING(0 0,50 0,100 0)'), (2, 'LINESTRING(100 0,200 0)'), (3, 'LINESTRING(100 0,100 90)'), (4, 'LINESTRING(100 0,100 -90)'), (5, 'LINESTRING(200 0,240 40)')) v(i, line);
INSERT INTO hill.axis (axis_id, geom) VALUES (1, 'SRID=2154;LINESTRING Z(650000 6860000 10,650100 6860000 20)'), (2, 'SRID=2154;LINESTRING Z(650100 6860000 20,650200 6860000 40)');
CREATE TABLE lines AS SELECT i AS id, (5 + i)::text AS breite, ST_SetSRID(ST_MakeLine(ST_Point(650000, 6860100 + 50 * i), ST_Point(650100, 6860100 + 50 * i)), 2154) AS geom FROM generate_series(1, 3) i;
CREATE TABLE odd AS SELECT 1 AS id, NULL::geometry AS geom;
SELECT FROM streetgen.export_topology('town', 'town_topology') \g /dev/null
INSERT INTO town.kerb_point_editing (geom) VALUES ('SRID=2154;POINT(650020 6860004)');
UPDATE town.corner_editing SET radius = 4 WHERE corner_id = 1;

CREATE FUNCTION calls.one_of(VARIADIC words text[]) RETURNS text LANGUAGE sql VOLATILE RETURN words[1 + floor(random() * cardinality(words))::integer];

CREATE FUNCTION calls.number() RETURNS text LANGUAGE sql VOLATILE
  RETURN calls.one_of('NULL', '''NaN''', '''Infinity''', '''-Infinity''', '-0.0', '0', '1e-300', '1e300', '1e12', '-1', '0.5', '1', '3', '7', '45', '100', '1000', (10 * random())::text, (10 * random())::text);

CREATE FUNCTION calls.whole() RETURNS text LANGUAGE sql VOLATILE
  RETURN calls.one_of('NULL', '0', '1', '1', '2', '2', '3', '4', '7', '-1', '50', '2154', '32631', '4326', '2147483647', '-2147483648');

CREATE FUNCTION calls.word() RETURNS text LANGUAGE sql VOLATILE
  RETURN calls.one_of('NULL', '''''', '''town''', '''town''', '''town''', '''hill''', '''no such''', '''public''', '''it''''s "odd" %s \ é''', 'repeat(''x'', 100000)', '''left''', '''right''', '''both''', '''direct''', '''reverse''', '''start''', '''end''',
    '''symmetric''', '''paper''', '''setra''', '''bezier''', '''arcs''', '''left_first''', '''right_first''', '''flat''', '''round''', '''reader''', '''editor''', '''no''', '''only''', '''through''', '''u_turn''', '''general|bus''', '''general''',
    '''3.5|2''', '''|''', '''kind''', '''width''', '''turn''', '''reach''', '''tolerance''', '''10''', '''NaN''', '''1e999''', '''{}''', '''{"1": 8}''', '''town_topology''', '''kept''', '''pg_catalog.pg_class''', '''town.axis''', '''on''');

-- A geometry: mostly a line of a street's size, and every oddity.
CREATE FUNCTION calls.geometry() RETURNS text LANGUAGE sql VOLATILE AS $$
  SELECT CASE WHEN random() < 0.5 THEN format('''SRID=%s;LINESTRING(%s %s,%s %s,%s %s)''::geometry', srid, x, y, x + 60, y, x + 60 + floor(60 * random()), y + floor(80 * random()))
    WHEN random() < 0.2 THEN format('''SRID=%s;POINT(%s %s)''::geometry', srid, x + floor(110 * random()), y + floor(10 * random()))
    ELSE calls.one_of('NULL::geometry', '''POINT EMPTY''::geometry', '''LINESTRING EMPTY''::geometry', '''POLYGON EMPTY''::geometry', '''GEOMETRYCOLLECTION EMPTY''::geometry', '''LINESTRING(0 0,0 0)''::geometry', '''LINESTRING(1 1,1 1,1 1)''::geometry',
      '''POLYGON((0 0,9 0,9 9,0 0))''::geometry', '''POLYGON((0 0,2 2,2 0,0 2,0 0))''::geometry', '''MULTIPOINT(0 0,1 1)''::geometry', '''MULTILINESTRING((0 0,9 0),(9 0,9 9))''::geometry', '''CIRCULARSTRING(0 0,5 5,10 0)''::geometry',
      '''CIRCULARSTRING(0 0,1 1,0 0)''::geometry', '''COMPOUNDCURVE(CIRCULARSTRING(0 0,1 1,2 0),(2 0,9 0))''::geometry', '''CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))''::geometry', '''TRIANGLE((0 0,0 9,9 0,0 0))''::geometry',
      '''TIN(((0 0 0,0 0 1,0 1 0,0 0 0)))''::geometry', '''POLYHEDRALSURFACE(((0 0 0,0 0 1,0 1 0,0 0 0)))''::geometry', '''MULTISURFACE(((0 0,9 0,9 9,0 0)))''::geometry', '''MULTICURVE((0 0,9 0),CIRCULARSTRING(0 0,5 5,10 0))''::geometry',
      '''MULTIPOLYGON(((0 0,9 0,9 9,0 0)))''::geometry', '''GEOMETRYCOLLECTION(POINT(0 0),LINESTRING(0 0,9 0))''::geometry', '''LINESTRING Z(0 0 1,50 0 2)''::geometry', '''LINESTRING M(0 0 1,50 0 2)''::geometry', '''LINESTRING ZM(0 0 1 2,50 0 2 3)''::geometry', '''LINESTRING(0 0,50 0,0 0)''::geometry',
      '''LINESTRING(0 0,50 0,50 50,0 0)''::geometry', '''LINESTRING(0 0,10 10,10 0,0 10)''::geometry', '''LINESTRING(0 0,1e-12 0)''::geometry', '''LINESTRING(-1e300 0,1e300 0)''::geometry', '''LINESTRING(0 0,1e13 1e13)''::geometry',
      'ST_MakeLine(ST_MakePoint(''NaN'', 0), ST_MakePoint(5, 5))', 'ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint(''Infinity'', 5))', 'ST_SetSRID(ST_MakePoint(''NaN'', ''NaN''), 2154)', 'ST_MakePoint(0, 0, ''NaN'')',
      '(SELECT ST_MakeLine(ST_Point(i, i % 7) ORDER BY i) FROM generate_series(1, 2000) i)', '(SELECT ST_MakeLine(ST_Point(50 * cos(i), 50 * sin(i)) ORDER BY i) FROM generate_series(1, 200) i)',
      'ST_SetSRID(ST_MakeBox2D(ST_Point(650000, 6860000), ST_Point(650100, 6860100))::geometry, 2154)', '''SRID=4326;LINESTRING(2 48,2.001 48)''::geometry', '''SRID=999999;LINESTRING(0 0,50 0)''::geometry') END
  FROM (SELECT calls.one_of('2154', '2154', '2154', '0', '32631') AS srid, 650000 + CASE WHEN random() < 0.5 THEN 100 ELSE floor(40 * random()) END AS x, 6860000 + CASE WHEN random() < 0.5 THEN 0 ELSE floor(40 * random()) END AS y) s $$;

CREATE FUNCTION calls.value_of(type text) RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  element constant text := left(type, -2);
  length constant integer := floor(5 * random());
BEGIN
  IF type LIKE '%[]' THEN
    RETURN CASE WHEN random() < 0.05 THEN 'NULL::' || type WHEN random() < 0.05 THEN format('ARRAY[ARRAY[%s],ARRAY[%s]]::%s', calls.value_of(element), calls.value_of(element), type)
      ELSE format('ARRAY[%s]::%s', (SELECT string_agg(calls.value_of(element), ',') FROM generate_series(1, length)), type) END;
  END IF;
  RETURN CASE
    WHEN type LIKE 'geometry%' THEN calls.geometry()
    WHEN type IN ('integer', 'bigint', 'smallint') THEN format('(%s)::%s', calls.whole(), type)
    WHEN type = 'double precision' THEN format('(%s)::float8', calls.number())
    WHEN type = 'boolean' THEN calls.one_of('true', 'false', 'NULL::boolean')
    WHEN type = 'regclass' THEN calls.one_of('''lines''::regclass', '''lines''::regclass', '''odd''::regclass', '''town.axis''::regclass', '''town.axis_used''::regclass', '''pg_class''::regclass', 'NULL::regclass', '0::oid::regclass')
    WHEN type = 'jsonb' THEN calls.one_of('NULL::jsonb', '''{}''::jsonb', '''[]''::jsonb', '''3''::jsonb', '''{"source_ref": "id"}''::jsonb', '''{"width": "breite", "source_ref": "id"}''::jsonb', '''{"width": {"value": "NaN"}, "source_ref": "id"}''::jsonb',
      '''{"geom": "id"}''::jsonb', '''{"1": 8, "2": null}''::jsonb', '''{"1": 1e300}''::jsonb', '''{"level": {"value": 1e9}}''::jsonb', '''{"a": [{"b": null}]}''::jsonb')
    WHEN type = 'name' AND random() < 0.6 THEN calls.one_of('''town''::name', '''town''::name', '''hill''::name')
    ELSE format('(%s)::%s', calls.word(), type) END;
END $$;

-- The statements of a user: calls, and writes. A SELECT that only counts may inline a function and never compute it.
CREATE VIEW calls.callable AS
SELECT p.oid, proname AS name, CASE prokind WHEN 'p' THEN 'CALL' ELSE 'SELECT' END AS verb, array_agg(format_type(t, NULL) ORDER BY n) AS arguments, p.pronargdefaults AS defaults
FROM pg_proc p LEFT JOIN LATERAL unnest(proargtypes::oid[]) WITH ORDINALITY a(t, n) ON true WHERE pronamespace = 'streetgen'::regnamespace AND proname !~ '^_' GROUP BY p.oid;
CREATE VIEW calls.writable AS
SELECT c.oid::regclass AS relation, array_agg(attname ORDER BY attnum) AS names, array_agg(format_type(atttypid, NULL) ORDER BY attnum) AS types FROM pg_class c JOIN pg_attribute a ON attrelid = c.oid
WHERE relnamespace IN ('town'::regnamespace, 'hill'::regnamespace) AND attnum > 0 AND NOT attisdropped
  AND (relkind = 'r' AND (relname IN ('axis', 'axis_class', 'turn_restriction', 'setting') OR relname LIKE '%\_override') OR relname LIKE '%\_editing') GROUP BY c.oid;

CREATE FUNCTION calls.call() RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  f record;
  w record;
  i integer;
  given integer;
BEGIN
  IF random() < 0.7 THEN
    SELECT * INTO f FROM calls.callable ORDER BY name, arguments OFFSET floor(random() * (SELECT count(*) FROM calls.callable)) LIMIT 1;
    given := cardinality(f.arguments) - CASE WHEN random() < 0.3 THEN f.defaults ELSE 0 END;
    RETURN format('%s streetgen.%I(%s)', f.verb, f.name, (SELECT string_agg(calls.value_of(t), ', ' ORDER BY n) FROM unnest(f.arguments) WITH ORDINALITY a(t, n) WHERE t IS NOT NULL AND n <= given));
  END IF;
  SELECT * INTO w FROM calls.writable ORDER BY relation::text OFFSET floor(random() * (SELECT count(*) FROM calls.writable)) LIMIT 1;
  i := 2 + floor(random() * (cardinality(w.names) - 1));
  RETURN CASE WHEN random() < 0.6 THEN format('UPDATE %s SET %I = %s%s', w.relation, w.names[i], calls.value_of(w.types[i]), CASE WHEN random() < 0.5 THEN format(' WHERE %I::text IN (''1'', ''2'')', w.names[1]) ELSE '' END)
    WHEN random() < 0.8 THEN format('INSERT INTO %s (%s) VALUES (%s)', w.relation, (SELECT string_agg(quote_ident(n), ', ' ORDER BY n) FROM unnest(w.names[2:]) n),
      (SELECT string_agg(CASE WHEN random() < 0.7 AND t NOT LIKE 'geometry%' AND t <> 'bigint' THEN 'DEFAULT' ELSE calls.value_of(t) END, ', ' ORDER BY n) FROM unnest(w.names[2:], w.types[2:]) v(n, t)))
    ELSE format('DELETE FROM %s%s', w.relation, calls.one_of('', format(' WHERE %I::text = ''1''', w.names[1]))) END;
END $$;

-- The outcome of each: the SQLSTATE of its refusal, or none.
CREATE TABLE calls.made (seed integer PRIMARY KEY, call text NOT NULL, state text, said text);
CREATE FUNCTION calls.make(seed integer) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  call text;
BEGIN
  PERFORM setseed(seed / 2147483648.0), random();
  call := calls.call();
  BEGIN
    EXECUTE call;
    RAISE SQLSTATE 'SG000';
  EXCEPTION
    WHEN SQLSTATE 'SG000' THEN INSERT INTO calls.made VALUES (seed, call, 'none', NULL);
    WHEN OTHERS OR query_canceled THEN INSERT INTO calls.made VALUES (seed, call, SQLSTATE, SQLERRM);
  END;
END $$;

-- Internal errors, cancelled calls, a division by zero, an array too large; and calls that are none.
CREATE VIEW calls.broken AS SELECT seed FROM calls.made WHERE state LIKE 'XX%' OR state IN ('57014', '22012', '54000', '42883', '42601');
