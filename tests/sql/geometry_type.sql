\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
\ir shared/made_design.sql
-- Every public function that takes a geometry gets every type of geometry in each such place, the rest being fit: it answers, or it refuses by a
-- SQLSTATE of its own, never by an internal error.
SELECT test.make_design('hill') \g /dev/null
SELECT setval('hill.design_node_design_node_id_seq', 100) \g /dev/null
INSERT INTO hill.axis (geom, width) VALUES ('SRID=2154;LINESTRING Z(901000 6451000 0,901200 6451100 0)', 7);
SELECT streetgen._switch_on('hill', '{footway}') \g /dev/null
SELECT streetgen.create_traffic('hill') \g /dev/null
INSERT INTO hill.car (axis_id, abscissa, lane_position, along_axis) SELECT max(axis_id), 20, 2, true FROM hill.axis;
SELECT streetgen.keep_simulation('hill', 'left', duration => 1) \g /dev/null
CREATE TABLE odd (kind text, geom geometry);
INSERT INTO odd SELECT split_part(line, '(', 1) || CASE WHEN line LIKE '%EMPTY%' THEN '' ELSE ' of ' || length(line) END, ST_GeomFromEWKT('SRID=2154;' || line) FROM unnest(ARRAY[
  'POINT(901000 6451000)', 'LINESTRING(901000 6451000,901100 6451000,901200 6451100)', 'POLYGON((901000 6451000,901100 6451000,901100 6451100,901000 6451000))',
  'MULTIPOINT(901000 6451000,901100 6451000)', 'MULTILINESTRING((901000 6451000,901100 6451000),(901000 6451050,901100 6451050))',
  'MULTIPOLYGON(((901000 6451000,901100 6451000,901100 6451100,901000 6451000)))', 'GEOMETRYCOLLECTION(POINT(901000 6451000),LINESTRING(901000 6451000,901100 6451000))',
  'GEOMETRYCOLLECTION(GEOMETRYCOLLECTION(LINESTRING(901000 6451000,901100 6451000)))', 'CIRCULARSTRING(901000 6451000,901050 6451050,901100 6451000)',
  'COMPOUNDCURVE(CIRCULARSTRING(901000 6451000,901050 6451050,901100 6451000),(901100 6451000,901200 6451000))', 'CURVEPOLYGON(CIRCULARSTRING(901000 6451000,901040 6451000,901040 6451040,901000 6451040,901000 6451000))',
  'MULTICURVE(CIRCULARSTRING(901000 6451000,901050 6451050,901100 6451000),(901000 6451000,901100 6451000))',
  'MULTISURFACE(CURVEPOLYGON(CIRCULARSTRING(901000 6451000,901040 6451000,901040 6451040,901000 6451040,901000 6451000)),((901000 6451000,901100 6451000,901100 6451100,901000 6451000)))',
  'TRIANGLE((901000 6451000,901100 6451000,901100 6451100,901000 6451000))', 'TIN(((901000 6451000,901100 6451000,901100 6451100,901000 6451000)))',
  'POLYHEDRALSURFACE(((901000 6451000,901100 6451000,901100 6451100,901000 6451000)))',
  'POINT EMPTY', 'LINESTRING EMPTY', 'POLYGON EMPTY', 'MULTIPOINT EMPTY', 'MULTILINESTRING EMPTY', 'MULTIPOLYGON EMPTY', 'GEOMETRYCOLLECTION EMPTY', 'CIRCULARSTRING EMPTY', 'COMPOUNDCURVE EMPTY',
  'CURVEPOLYGON EMPTY', 'MULTICURVE EMPTY', 'MULTISURFACE EMPTY', 'TRIANGLE EMPTY', 'TIN EMPTY', 'POLYHEDRALSURFACE EMPTY', 'GEOMETRYCOLLECTION(LINESTRING EMPTY)', 'MULTILINESTRING(EMPTY)', 'MULTIPOLYGON(EMPTY)',
  'LINESTRING(901000 6451000,901000 6451000)', 'POLYGON((901000 6451000,901100 6451100,901100 6451000,901000 6451100,901000 6451000))']) line;
INSERT INTO odd SELECT kind || ' Z', ST_Force3DZ(geom, 5) FROM odd UNION ALL SELECT kind || ' M', ST_Force3DM(geom, 5) FROM odd UNION ALL SELECT kind || ' ZM', ST_Force4D(geom, 5, 5) FROM odd;
CREATE FUNCTION test.fit(asked text, type text, name text) RETURNS text LANGUAGE sql AS $$
  SELECT CASE WHEN type = 'geometry' THEN CASE WHEN name IN ('point', 'centre', 'place', 'a', 'b', 'start') THEN '''SRID=2154;POINT(901150 6451020)''::geometry' ELSE '''SRID=2154;LINESTRING(901000 6451000,901100 6451000,901200 6451100)''::geometry' END
    WHEN type = 'geometry[]' THEN 'ARRAY[''SRID=2154;LINESTRING(901000 6451000,901100 6451000)'', ''SRID=2154;LINESTRING(901000 6451010,901100 6451010)'']::geometry[]'
    WHEN type = 'name' THEN '''hill''' WHEN type = 'jsonb' THEN '''{}''' WHEN type = 'boolean' THEN 'true' WHEN type = 'boolean[]' THEN '''{true,true,true}'''
    WHEN type = 'double precision[]' THEN CASE WHEN name = 'widths' OR name = 'radii' AND asked = 'intersection_surface' THEN '''{8,8}''' WHEN name = 'clothoids' THEN '''{0,0,0}''' ELSE '''{8,8,8}''' END WHEN type IN ('integer', 'bigint') THEN '2' WHEN type = 'double precision' THEN CASE name WHEN 'scale' THEN '500' WHEN 'offset_right' THEN '-5' ELSE '5' END
    ELSE CASE name WHEN 'paper' THEN '''A3''' WHEN 'theme' THEN '''street''' WHEN 'network' THEN '''rural''' WHEN 'stage' THEN '''axes''' WHEN 'rule' THEN '''bezier''' ELSE '''left''' END END $$;
CREATE TABLE tried (call text, kind text, state text, said text);
CREATE FUNCTION test.try() RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  f record;
  shape record;
  place integer;
  call text;
BEGIN
  FOR f IN SELECT p.oid, p.proname, p.pronargdefaults, p.proargnames, array_agg(format_type(t, NULL) ORDER BY n) AS types FROM pg_proc p, unnest(proargtypes::oid[]) WITH ORDINALITY a(t, n)
      WHERE pronamespace = 'streetgen'::regnamespace AND proname !~ '^_' GROUP BY p.oid ORDER BY p.proname LOOP
    FOR place IN SELECT n FROM unnest(f.types) WITH ORDINALITY a(t, n) WHERE t LIKE 'geometry%' LOOP
      call := format('SELECT streetgen.%I(%s)', f.proname, (SELECT string_agg(CASE WHEN n = place AND t = 'geometry' THEN '$1' WHEN n = place THEN 'ARRAY[$1, $1]' ELSE test.fit(f.proname, t, f.proargnames[n]) END, ', ' ORDER BY n)
        FROM unnest(f.types) WITH ORDINALITY a(t, n) WHERE n <= greatest(place, cardinality(f.types) - f.pronargdefaults)));
      FOR shape IN SELECT * FROM odd LOOP
        BEGIN
          EXECUTE call USING shape.geom;
          RAISE SQLSTATE 'SG000';
        EXCEPTION WHEN OTHERS THEN
          INSERT INTO tried VALUES (call, shape.kind, SQLSTATE, SQLERRM);
        END;
      END LOOP;
    END LOOP;
  END LOOP;
END $$;
SELECT test.try() \g /dev/null
-- The same of what importers read from a table.
CREATE TABLE source (id integer, class text, geom geometry);
CREATE FUNCTION test.import(call text) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  shape record;
BEGIN
  FOR shape IN SELECT * FROM odd LOOP
    BEGIN
      INSERT INTO source VALUES (1, 'forest', shape.geom);
      EXECUTE 'SELECT ' || call;
      RAISE SQLSTATE 'SG000';
    EXCEPTION WHEN OTHERS THEN
      INSERT INTO tried VALUES (call, shape.kind, SQLSTATE, SQLERRM);
    END;
  END LOOP;
END $$;
SELECT streetgen.create_model('town', 2154, subjects => '{object}') \g /dev/null
SELECT test.import(call) FROM unnest(ARRAY[$$streetgen.import_zones('hill', 'source', '{"class": "class"}')$$, $$streetgen.import_axes('hill', 'source', '{"source_ref": "id"}')$$,
  $$streetgen.import_objects('town', 'source', '{"source_ref": "id", "type": {"value": "lamp"}}')$$]) call \g /dev/null
SELECT 'no geometry of any type ends in an internal error', count(*) > 5000 AND count(*) FILTER (WHERE state !~ '^(SG000|22023|22004)$') = 0 FROM tried;
-- Where a geometry may be of another reference it may also have no place in the model's.
SELECT 'a place that SRID ' || ST_SRID(place) || ' does not have is refused, by ' || call, (r).state = '22023' AND (r).said LIKE '%cannot be transformed%'
FROM (SELECT call, place, test.refusal(format('SELECT streetgen.%s', format(call, quote_literal(place::text)))) r FROM unnest(ARRAY['SRID=4326;POINT(200 100)', 'SRID=999999;POINT(1 1)']::geometry[]) place,
  unnest(ARRAY['terrain_height(''hill'', %s)', 'path_cost(''hill'', ST_MakeLine(%1$s::geometry, ST_Translate(%1$s, 1, 0)), ''rural'')']) call) r;
SELECT 'and each function takes some', count(*) = 0 FROM (SELECT call FROM tried GROUP BY call HAVING count(*) FILTER (WHERE state = 'SG000') = 0) never;
