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
