-- A projection more than 1 % off in scale at the data is refused.  Each SELECT is one truth: (name, holds).
SET client_min_messages = warning;
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
SELECT 'degrees beside the origin of the reference are reported', count = 1 FROM streetgen.import_axes('origin', 'degrees', '{}') WHERE what = 'taken as metres, looks like degrees';
UPDATE degrees SET geom = 'SRID=32631;LINESTRING(2 48,52 48)';
SELECT 'a street there is not', bool_and(what NOT LIKE '%degrees') FROM streetgen.import_axes('origin', 'degrees', '{}');
