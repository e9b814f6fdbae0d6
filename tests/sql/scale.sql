\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- A projection more than 1 % off in scale at the data is refused.  Each SELECT is one truth: (name, holds).
-- UTM zone 31 at its own place, and asked to hold others.
DO $$ BEGIN
  PERFORM streetgen.create_model('paris', 32631);
  INSERT INTO paris.axis (axis_id, geom) VALUES (1, 'SRID=32631;LINESTRING(452000 5411000,452090 5411000)'), (2, 'SRID=32631;LINESTRING(452090 5411000,452090 5411080)');
  PERFORM streetgen.generate('paris');
END $$;
CREATE TABLE before AS SELECT test.rows('paris') AS rows;
CREATE TABLE place(name, zone, lon, lat) AS VALUES ('Seattle', 32610, -122.33, 47.61), ('Sydney', 32756, 151.21, -33.87), ('Singapore', 32648, 103.85, 1.29), ('Moscow', 32637, 37.62, 55.75);
SELECT format('%s is refused in zone 31: the axis, the scale, the zone', name),
       state = '22023' AND said LIKE 'the scale of SRID 32631 is more than 1 \% off at axis 7, POINT(%)' AND detail LIKE '100 m of map are % m east %' AND hint LIKE '%EPSG:' || zone || '.'
FROM place, LATERAL (SELECT ST_Transform(ST_SetSRID(ST_MakePoint(lon, lat), 4326), 32631) AS point) p,
    LATERAL test.refusal(format($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, %L); SELECT streetgen.generate('paris')$$, ST_MakeLine(point, ST_Translate(point, 50, 0)))) r;
SELECT 'so it is when asked for by its id', state = '22023' AND said LIKE '%axis 7,%'
FROM test.refusal($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(3e6 5411000,3000050 5411000)'); SELECT streetgen.generate('paris', '{7}')$$);
SELECT 'one far end is enough', state = '22023' AND said LIKE '%axis 7, POINT(3000000 5411000)'
FROM test.refusal($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(452000 5411000,3e6 5411000)'); SELECT streetgen.generate('paris')$$);
SELECT 'a place beyond the projection is refused: ' || line, state = '22023' AND said LIKE '%axis 7,%' AND hint <> '' FROM unnest(ARRAY['LINESTRING(1e9 1e9,1000000040 1e9)', 'LINESTRING(-1e9 5e8,-999999960 5e8)', 'LINESTRING(1e12 0,-1e12 0)']) line,
    LATERAL test.refusal(format($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, %L); SELECT streetgen.generate('paris')$$, 'SRID=32631;' || line)) r;
SELECT 'what was refused changed no row', rows = test.rows('paris') AND (SELECT count(*) = 2 FROM paris.axis) FROM before;
-- Ground metres for a metre of map, by the law of the transverse Mercator: 1 / (0.9996 (1 + (x / R)^2 / 2)).
SELECT format('%s m from the meridian the scale is %s %% off: %s', distance, round(100 * off::numeric, 2), CASE WHEN off < 0.01 THEN 'taken' ELSE 'refused' END),
       state = CASE WHEN off < 0.01 THEN '22012' ELSE '22023' END
FROM (SELECT distance, abs(1 - 1 / (0.9996 * (1 + (distance / 6378137.0) ^ 2 / 2))) AS off FROM unnest(ARRAY[0, 300e3, 850e3, 950e3, 1500e3]) distance) d,
    LATERAL test.refusal(format($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(%s 10,%s 10)'); SELECT streetgen.generate('paris'); SELECT 1 / 0$$, 500000 + distance - 10, 500000 + distance)) r;
SELECT 'an import is refused by its source row', state = '22023' AND said LIKE '%off at source row w9, POINT(%' AND hint LIKE '%EPSG:32610.'
FROM test.refusal($$CREATE TABLE source AS SELECT 'w9' AS id, 'SRID=4326;LINESTRING(-122.33 47.61,-122.34 47.61)'::geometry AS geom; SELECT * FROM streetgen.import_axes('paris', 'source', '{"source_ref": "id"}')$$);
DO $$ BEGIN PERFORM streetgen.create_model('lille', 2154); END $$;
SELECT 'degrees taken for metres are told as such: ' || statement, state = '22023' AND hint LIKE '%ST_Transform(ST_SetSRID(geom, 4326), 2154)%'
FROM unnest(ARRAY[$$INSERT INTO lille.axis (geom) VALUES ('SRID=2154;LINESTRING(3.06 50.63,3.07 50.64)')$$,
    $$CREATE TABLE source AS SELECT 'SRID=2154;LINESTRING(3.06 50.63,3.07 50.64)'::geometry AS geom; SELECT * FROM streetgen.import_axes('lille', 'source', '{}')$$]) statement, LATERAL test.refusal(statement) r;
SELECT 'and leaves the axes', count(*) = 2 FROM paris.axis;
CREATE TABLE degrees AS SELECT 'SRID=32631;LINESTRING(2.35 48.85,2.36 48.86)'::geometry AS geom;
DO $$ BEGIN PERFORM streetgen.create_model('origin', 32631); END $$;
SELECT 'degrees beside the origin of the reference are refused', state = '22023' AND said LIKE '%source row number 1%' AND hint LIKE '%ST_Transform(ST_SetSRID(geom, 4326), 32631)%' AND (SELECT count(*) = 0 FROM origin.axis)
FROM test.refusal($$SELECT streetgen.import_axes('origin', 'degrees', '{}')$$);
UPDATE degrees SET geom = 'SRID=32631;LINESTRING(2 48,52 48)';
SELECT 'a street there is not', count(*) = 1 FROM streetgen.import_axes('origin', 'degrees', '{}') WHERE what = 'new or changed';

-- Outside the area of use: zone 31 is made for 0 to 6 degrees east. On the equator, 9 degrees of longitude are 1,002 km.
SELECT 'the area of use of a UTM zone', (west, east) = (0, 6) AND south <= 0 AND north BETWEEN 82 AND 84 FROM streetgen._area_of_use(32631);
SELECT 'of one in the south', (west, east, north) = (150, 156, 0) FROM streetgen._area_of_use(32756);
SELECT 'of France', abs(west + 9.86) < 0.01 AND abs(north - 51.56) < 0.01 FROM streetgen._area_of_use(2154);
SELECT format('%s degrees east lie %s km outside of zone 31', lon, km), abs(streetgen._outside(ST_Transform(ST_SetSRID(ST_MakePoint(lon, 0), 4326), 32631)) / 1000 - km) < 0.5
FROM (VALUES (3, 0), (0, 0), (6, 0), (7, 111.3), (-1, 111.3), (8, 222.6)) v(lon, km);
CREATE TABLE far AS SELECT 'SRID=4326;LINESTRING(8 48, 8.001 48)'::geometry AS geom;
SELECT 'an importer refuses over 100 km outside', state = '22023' AND said LIKE 'source row number 1, POINT(%), lies 149 km outside the area that SRID 32631 is made for' AND hint LIKE '%EPSG:32632.'
FROM test.refusal($$SELECT streetgen.import_axes('origin', 'far', '{}')$$);
UPDATE far SET geom = 'SRID=4326;LINESTRING(7 48, 7.001 48)';
SELECT 'and takes what lies nearer', count(*) = 1 FROM streetgen.import_axes('origin', 'far', '{}') WHERE what = 'new or changed';
DELETE FROM origin.axis WHERE source = 'far';
SELECT 'a sketch at the origin is no matter of check_model', count(*) = 0 FROM streetgen.check_model('origin') WHERE severity = 'warning';
INSERT INTO origin.axis (axis_id, geom) SELECT 8, ST_Transform(geom, 32631) FROM (SELECT 'SRID=4326;LINESTRING(8 48, 8.001 48)'::geometry AS geom) g;
SELECT 'who types gets a row of check_model', (id, round(measure / 1000)) = (8, 149) AND severity = 'warning' FROM streetgen.check_model('origin') WHERE rule LIKE 'outside the area of use%';
SELECT streetgen.create_model('degree', 32631) \g /dev/null
INSERT INTO degree.axis (axis_id, geom) VALUES (5, 'SRID=32631;LINESTRING(2 48, 2.001 48.001)');
SELECT 'also for degrees', id = 5 AND severity = 'warning' FROM streetgen.check_model('degree') WHERE rule = 'looks like degrees';
\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=warning'
\! test "$(psql -qXAt -c "INSERT INTO degree.axis (geom) VALUES ('SRID=32631;LINESTRING(3 48, 3.001 48.001)'), ('SRID=32631;LINESTRING(2 48, 2.001 48.001)')" 2>&1 | grep -c 'WARNING.*shorter than a metre')" = 1 && holds=t || holds=f; printf 'one warning a statement for who types degrees\t%s\n' $holds
\! test "$(psql -qXAt -c "UPDATE origin.axis SET width = 7" -c "INSERT INTO origin.axis (geom) SELECT ST_Translate(geom, 0, 20000) FROM origin.axis WHERE axis_id = 8" 2>&1 | grep -c 'WARNING.* km outside the area')" = 1 && holds=t || holds=f; printf 'and for who types elsewhere, once a place\t%s\n' $holds
\! test -z "$(psql -qXAt -c "INSERT INTO origin.axis (geom) VALUES ('SRID=32631;LINESTRING(90 90, 180 90)'), ('SRID=32631;LINESTRING(50000 90, 50100 90)')" 2>&1)" && holds=t || holds=f; printf 'none for a sketch\t%s\n' $holds

-- A line beyond axis_length_maximal: along its meridian the scale holds from the equator to the pole.
SELECT 'a line of 9,000 km is refused: ' || statement, state = '22023' AND said LIKE '%9000.0 km long, over setting axis_length_maximal' AND hint LIKE '%streetgen.set(''paris'', ''axis_length_maximal'', ''9000000'')%'
FROM unnest(ARRAY[$$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(500000 10,500000 9000010)')$$,
    $$CREATE TABLE source AS SELECT 'SRID=32631;LINESTRING(500000 10,500000 9000010)'::geometry AS geom; SELECT streetgen.import_axes('paris', 'source', '{}')$$,
    $$SELECT streetgen.live('paris', false); INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(500000 10,500000 9000010)'); SELECT streetgen.generate('paris')$$]) statement, LATERAL test.refusal(statement) r;
SELECT 'up to the setting it is taken', test.state($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(500000 5000000,500000 5100000)'); SELECT 1 / 0$$) = '22012';
SELECT streetgen.set('paris', 'axis_length_maximal', '99999') \g /dev/null
SELECT streetgen.generate('paris') \g /dev/null
SELECT 'which can be changed', test.state($$INSERT INTO paris.axis (axis_id, geom) VALUES (7, 'SRID=32631;LINESTRING(500000 5000000,500000 5100000)'); SELECT 1 / 0$$) = '22023';
