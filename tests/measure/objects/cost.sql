-- The cost of objects, in processor time of one session: psql -v objects=NUMBER in an empty database. A city of 25 x 16 km in a grid, each road with its share of trees beside it.
\set VERBOSITY terse
SET client_min_messages = error;
CREATE EXTENSION IF NOT EXISTS streetgen CASCADE;
CREATE FUNCTION pg_temp.cpu() RETURNS float8 LANGUAGE sql VOLATILE AS $$ SELECT (s[14]::float8 + s[15]::float8) * 10 FROM (SELECT string_to_array(pg_read_file('/proc/' || pg_backend_pid() || '/stat'), ' ') AS s) x $$;
SELECT streetgen.create_model('town', 2154, subjects => '{object}'), streetgen.live('town', false) \g /dev/null
INSERT INTO town.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(600000 + 100 * x, 6800000 + 100 * y), ST_MakePoint(600000 + 100 * (x + 1 - k), 6800000 + 100 * (y + k))), 2154), 7
  FROM generate_series(0, 250) x, generate_series(0, 160) y, generate_series(0, 1) k;
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SET streetgen.computes = 'on';
INSERT INTO town.street_object (type, geom, angle, placement, axis_id, abscissa, side, axis_offset, method)
SELECT 'tree', streetgen.place_on(geom, width, abscissa, 1, side), 0, 'border', axis_id, abscissa, side, 1, 'relative'
FROM town.axis, (SELECT count(*) AS many FROM town.axis) m, LATERAL (SELECT :objects::float8 / many / 2 AS share) s, LATERAL (VALUES ('left'), ('right')) v(side),
  LATERAL (SELECT 5 + 90 * (i + 0.5) / greatest(share, 1) AS abscissa FROM generate_series(0, greatest(share, 1)::integer - 1) i) a;
RESET streetgen.computes;
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT streetgen.live('town', true) \g /dev/null
VACUUM ANALYZE;
CREATE FUNCTION pg_temp.spent(statement text, times integer) RETURNS numeric LANGUAGE plpgsql AS $$
DECLARE before float8; BEGIN
  EXECUTE replace(statement, '{i}', '0');
  before := pg_temp.cpu();
  FOR i IN 1 .. times LOOP EXECUTE replace(statement, '{i}', i::text); END LOOP;
  RETURN round(((pg_temp.cpu() - before) / times)::numeric, 2);
END $$;
SELECT count(*) AS objects FROM town.street_object \gset
SELECT '| ' || :objects, pg_temp.spent($$SELECT count(*) FROM town.street_object WHERE geom && ST_MakeEnvelope(605000, 6805000, 605100, 6805100, 2154)$$, 2000) AS block_ms,
  pg_temp.spent($$UPDATE town.axis SET width = 7 + 0.01 * ({i}0 % 7) WHERE axis_id = 30000 + {i}0$$, 60) AS edit_ms;
-- An axis with five hundred objects against one with none, in turn.
DELETE FROM town.street_object WHERE axis_id IN (20000, 20400);
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) SELECT 'tree', 'border', 20000, 2 + 96 * (n / 2) / 250.0, CASE n % 2 WHEN 0 THEN 'left' ELSE 'right' END, 1 FROM generate_series(0, 499) n;
SELECT '| an edit of a width, ms: with 500 objects, with none', pg_temp.spent($$UPDATE town.axis SET width = 7 + 0.1 * ({i}0 % 7 + 1) WHERE axis_id = 20000$$, 40), pg_temp.spent($$UPDATE town.axis SET width = 7 + 0.1 * ({i}0 % 7 + 1) WHERE axis_id = 20400$$, 40);
SELECT '| a move, ms: with 500 objects, with none', pg_temp.spent($$UPDATE town.axis SET geom = ST_SetPoint(geom, 0, ST_Translate(ST_StartPoint(geom), 0.01, 0)) WHERE axis_id = 20000$$, 40), pg_temp.spent($$UPDATE town.axis SET geom = ST_SetPoint(geom, 0, ST_Translate(ST_StartPoint(geom), 0.01, 0)) WHERE axis_id = 20400$$, 40);
