\set ECHO none
\ir shared/truths.sql
-- The side that one drives on, as one-way rings and pairs tell it.
CREATE FUNCTION pg_temp.ring(x float8, radius float8, pieces integer) RETURNS TABLE (piece integer, line geometry) LANGUAGE sql AS $$
  SELECT i, ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(x + round((radius * cos(a))::numeric, 3), 6860000 + round((radius * sin(a))::numeric, 3))
    FROM (SELECT 2 * pi() * (i + k / 12.0) / pieces AS a FROM generate_series(0, 12) k) v)), 2154) FROM generate_series(0, pieces - 1) i $$;
-- Counter-clockwise rings, of one axis and of three, and what is no ring: a square block, an open arc, a ring of two directions.
CREATE TABLE town AS
  SELECT 'ring' || n AS name, line AS geom, 'direct' AS direction FROM generate_series(1, 2) n, pg_temp.ring(650000 + 200 * n, 15, 1)
  UNION ALL SELECT 'three', line, 'direct' FROM pg_temp.ring(650800, 20, 3)
  UNION ALL SELECT 'square', 'SRID=2154;LINESTRING(651000 6860000, 651080 6860000, 651080 6860080, 651000 6860080, 651000 6860000)', 'reverse'
  UNION ALL SELECT 'arc', line, 'reverse' FROM pg_temp.ring(651300, 15, 2) WHERE piece = 0
  UNION ALL SELECT 'quiet ring', line, 'both' FROM pg_temp.ring(651500, 15, 1);
-- Carriageways 12 m apart: who drives east has the way back to the left, on the north side. One-way streets of two names tell nothing.
CREATE TABLE pair AS
  SELECT 'avenue ' || n AS name, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6861000 + 100 * n + y), ST_MakePoint(650100, 6861000 + 100 * n + y)), 2154) AS geom,
    CASE y WHEN 0 THEN 'direct' ELSE 'reverse' END AS direction FROM generate_series(1, 2) n, unnest(ARRAY[0, 12]) y
  UNION ALL SELECT 'street ' || y, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6862000 + y), ST_MakePoint(650100, 6862000 + y)), 2154), CASE y WHEN 0 THEN 'reverse' ELSE 'direct' END
    FROM unnest(ARRAY[0, 12]) y;
CREATE FUNCTION pg_temp.mirrored(line geometry) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Affine(line, -1, 0, 0, 1, 1300000, 0) $$;
CREATE FUNCTION pg_temp.import(model name, query text, driving_side text DEFAULT 'auto') RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  said text;
BEGIN
  PERFORM streetgen.create_model(model, 2154, driving_side => driving_side);
  EXECUTE format('CREATE TABLE %I AS SELECT row_number() OVER () AS id, * FROM (%s) q', model || '_line', query);
  SELECT string_agg(what || ' ' || count, '; ' ORDER BY what) FILTER (WHERE what LIKE 'driving side%') INTO said
    FROM streetgen.import_axes(model, (model || '_line')::regclass, '{"name": "name", "direction": "direction", "source_ref": "id"}');
  RETURN said;
END $$;
CREATE FUNCTION pg_temp.side(model name) RETURNS text LANGUAGE sql AS $$ SELECT value FROM streetgen.setting(model) WHERE name = 'driving_side' $$;
SELECT 'rings that turn left are of right-hand traffic', pg_temp.import('here', 'TABLE town') = 'driving side right, by one-way rings 3' AND pg_temp.side('here') = 'right';
SELECT 'mirrored they are of left-hand traffic', pg_temp.import('there', 'SELECT name, pg_temp.mirrored(geom) AS geom, direction FROM town') = 'driving side left, by one-way rings 3'
  AND pg_temp.side('there') = 'left';
SELECT 'so are rings drawn backwards', pg_temp.import('turned', $$SELECT name, ST_Reverse(geom) AS geom, CASE direction WHEN 'direct' THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE direction END AS direction
  FROM town$$) = 'driving side right, by one-way rings 3';
SELECT 'a block, an arc and a street for both directions are no one-way ring', count_right = 3 AND count_left = 0 FROM streetgen.driving_side('here') WHERE evidence = 'one-way rings';
SELECT 'the way back lies to the left of right-hand traffic', pg_temp.import('pairs', 'TABLE pair') = 'driving side right, by one-way pairs 4' AND pg_temp.side('pairs') = 'right';
SELECT 'mirrored, to the right', pg_temp.import('pairs_left', 'SELECT name, pg_temp.mirrored(geom) AS geom, direction FROM pair') = 'driving side left, by one-way pairs 4';
SELECT 'streets of two names are no pair', count_right = 4 AND count_left = 0 FROM streetgen.driving_side('pairs') WHERE evidence = 'one-way pairs';
SELECT 'what contradicts sets nothing, and is told',
  pg_temp.import('torn', 'SELECT * FROM town UNION ALL SELECT name, pg_temp.mirrored(geom), direction FROM pair') = 'driving side left, by one-way pairs 4; driving side right, by one-way rings 3'
  AND pg_temp.side('torn') = 'auto';
SELECT 'one of each sense contradicts itself', pg_temp.import('mixed', $$SELECT * FROM town UNION ALL SELECT name, ST_Reverse(geom), direction FROM town$$) = 'driving side contradicts, by one-way rings 3'
  AND pg_temp.side('mixed') = 'auto';
SELECT 'two rings are too few', pg_temp.import('few', $$SELECT * FROM town WHERE name LIKE 'ring_'$$) IS NULL AND pg_temp.side('few') = 'auto';
SELECT 'a side by hand stays', pg_temp.import('by_hand', 'TABLE town', 'left') IS NULL AND pg_temp.side('by_hand') = 'left';
SELECT 'and check_model warns', count(*) = 1 AND bool_and(severity = 'warning' AND measure = 3) FROM streetgen.check_model('by_hand') WHERE rule = 'driving side is not that of the one-way axes';
SELECT 'where it agrees, no warning', NOT EXISTS (SELECT FROM unnest('{here,there,torn,few}'::name[]) m, streetgen.check_model(m) c WHERE c.rule LIKE 'driving side%');
-- Lanes: two on a street, of which the left one runs with the axis where one drives on the left.
SELECT streetgen.create_model(m, 2154, driving_side => m) FROM unnest('{auto,right,left}'::name[]) m \g /dev/null
DO $$ DECLARE m name; BEGIN FOREACH m IN ARRAY '{auto,right,left}'::name[] LOOP
  EXECUTE format('INSERT INTO %I.axis (geom, width) VALUES (''SRID=2154;LINESTRING(650000 6860000, 650100 6860000)'', 7)', m); END LOOP; END $$;
SELECT 'auto is right until something tells', array_agg((side, along_axis) ORDER BY lane_position) = (SELECT array_agg((side, along_axis) ORDER BY lane_position) FROM "right".lane) FROM auto.lane;
SELECT 'left is the other way round', bool_and(l.along_axis <> r.along_axis) FROM "left".lane l JOIN "right".lane r USING (lane_position);
SELECT 'another word is refused', test.state($$SELECT streetgen.create_model('no', 2154, driving_side => 'middle')$$) = '22023';
SELECT 'evidence of a model that is not there: 3F000', test.state($$SELECT streetgen.driving_side('nowhere')$$) = '3F000';

-- Where nothing tells, the country does.
SELECT 'towns of both sides, some near a border, lie in their country', bool_and(streetgen._left_hand_country(place) IS NOT DISTINCT FROM country)
FROM (VALUES ('London', -0.13, 51.5, 'Britain or Ireland'), ('Dublin', -6.26, 53.35, 'Britain or Ireland'), ('Kyoto', 135.77, 35.01, 'Japan'), ('Delhi', 77.2, 28.6, 'Pakistan or India'),
  ('Sydney', 151.2, -33.87, 'Australia'), ('Nairobi', 36.82, -1.29, 'Tanzania or Kenya'), ('Cape Town', 18.42, -33.92, 'Southern Africa'), ('Bangkok', 100.5, 13.75, 'Thailand'),
  ('Karachi', 67, 24.86, 'Pakistan'), ('Kathmandu', 85.32, 27.7, 'Nepal'), ('Brighton', -0.14, 50.83, 'Britain or Ireland'), ('Dover', 1.31, 51.13, 'Britain'), ('Sapporo', 141.35, 43.06, 'Japan'),
  ('Phuket', 98.39, 7.88, 'Thailand'), ('Kota Kinabalu', 116.07, 5.98, 'Borneo'), ('Port of Spain', -61.51, 10.66, 'Trinidad and Tobago'), ('Kampala', 32.58, 0.35, 'Uganda'),
  ('Ca Mau', 104.83, 8.75, NULL), ('Mapun', 118.5, 7, NULL), ('Paria', -61.87, 10.72, NULL), ('Boga', 30.2, 0.97, NULL), ('Theinkun', 99.15, 13.05, NULL),
  ('Paris', 2.35, 48.86, NULL), ('Dieppe', 1.08, 49.92, NULL), ('Boulogne', 1.61, 50.72, NULL), ('Shekou', 113.92, 22.48, NULL), ('Hengqin', 113.53, 22.13, NULL), ('Yuzhno-Kurilsk', 145.86, 44.03, NULL), ('Calais', 1.86, 50.95, NULL), ('Seoul', 126.98, 37.57, NULL), ('Vladivostok', 131.9, 43.1, NULL), ('Vientiane', 102.6, 17.97, NULL),
  ('Phnom Penh', 104.9, 11.56, NULL), ('Kigali', 30.06, -1.94, NULL), ('Luanda', 13.2, -8.8, NULL), ('Addis Ababa', 38.7, 9, NULL), ('Yangon', 96.2, 16.8, NULL),
  ('Manila', 121, 14.6, NULL), ('Miami', -80.2, 25.8, NULL), ('Havana', -82.4, 23.1, NULL), ('San Juan', -66.1, 18.4, NULL), ('Lhasa', 91.1, 29.65, NULL), ('Shenzhen', 114.06, 22.54, NULL),
  ('Noumea', 166.4, -22.3, NULL), ('Taipei', 121.5, 25.04, NULL), ('Kabul', 69.2, 34.5, NULL), ('Lubumbashi', 27.5, -11.7, NULL)) c(town, x, y, country), LATERAL (SELECT ST_SetSRID(ST_MakePoint(x, y), 4326) AS place) p;
CREATE FUNCTION pg_temp.import_street(model name, srid integer, x float8, y float8, driving_side text DEFAULT 'auto') RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  said text;
BEGIN
  PERFORM streetgen.create_model(model, srid, driving_side => driving_side);
  EXECUTE format('CREATE TABLE %I AS SELECT 1 AS id, ST_SetSRID(ST_MakeLine(ST_MakePoint(%s, %s), ST_MakePoint(%s, %s)), %s) AS geom', model || '_line', x, y, x + 90, y, srid);
  SELECT string_agg(what, '; ') FILTER (WHERE what LIKE 'driving side%') INTO said FROM streetgen.import_axes(model, (model || '_line')::regclass, '{"source_ref": "id"}');
  RETURN said;
END $$;
SELECT 'a street of London keeps to the left, and the import says so', pg_temp.import_street('london', 27700, 530000, 180000) LIKE 'driving side left, as in Britain or Ireland%' AND pg_temp.side('london') = 'left';
SELECT 'one of Paris does not', pg_temp.import_street('paris', 2154, 650000, 6860000) IS NULL AND pg_temp.side('paris') = 'auto';
SELECT 'a side by hand stays in London too', pg_temp.import_street('london_by_hand', 27700, 530000, 180000, 'right') IS NULL AND pg_temp.side('london_by_hand') = 'right';
SELECT 'a sketch at the origin of the reference lies in no country', pg_temp.import_street('sketch', 32630, 100, 100) IS NULL AND pg_temp.side('sketch') = 'auto';
