\set ECHO none
\ir shared/truths.sql
-- check_model has a row for each radius by hand that the street does not follow, and none for one that it does.
CREATE FUNCTION pg_temp.line(wkt text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_Translate(wkt::geometry, 650000, 6860000), 2154) $$;
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 7), (2, pg_temp.line('LINESTRING(100 0, 200 0)'), 7), (3, pg_temp.line('LINESTRING(100 0, 100 30)'), 7),
  -- Where the width changes: at two ends, and at a taper of three.
  (4, pg_temp.line('LINESTRING(200 0, 300 0)'), 12), (5, pg_temp.line('LINESTRING(0 0, -60 0)'), 9), (6, pg_temp.line('LINESTRING(0 0, 0 80)'), 7),
  -- An acute angle, and a stub with no room.
  (7, pg_temp.line('LINESTRING(300 0, 400 10)'), 7), (8, pg_temp.line('LINESTRING(300 0, 400 -3)'), 7), (9, pg_temp.line('LINESTRING(100 30, 101 30)'), 7), (10, pg_temp.line('LINESTRING(100 30, 60 60)'), 7),
  (11, pg_temp.line('LINESTRING(0 300, 400 300)'), 7), (12, pg_temp.line('LINESTRING(0 300, 400 320)'), 7);
CREATE FUNCTION pg_temp.decide(a bigint, b bigint, radius float8) RETURNS void LANGUAGE sql AS $$
  INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) SELECT $1, $2, $3, n.geom FROM town.node n JOIN town.corner c USING (node_id) JOIN town.edge x ON x.edge_id = c.edge_a JOIN town.edge y ON y.edge_id = c.edge_b WHERE (x.axis_id, y.axis_id) = ($1, $2) $$;
CREATE FUNCTION pg_temp.told(expected text) RETURNS TABLE (name text, holds boolean) LANGUAGE sql AS $$
  SELECT coalesce(expected, 'nothing') || CASE WHEN t IS NOT DISTINCT FROM expected THEN '' ELSE ': ' || coalesce(t, 'nothing') END, t IS NOT DISTINCT FROM expected
  FROM (SELECT string_agg(replace(rule, 'corner override ', '') || ' ' || round(measure::numeric, 1), '; ' ORDER BY id) AS t FROM streetgen.check_model('town') WHERE relation = 'corner_override') t $$;
SELECT pg_temp.decide(2, 3, 9), pg_temp.decide(5, 1, 5), pg_temp.decide(1, 6, 0), pg_temp.decide(4, 2, 0) \g /dev/null
SELECT * FROM pg_temp.told(NULL);
SELECT 'one at a taper is followed', (method, radius) = ('by_hand', 5) FROM town.corner JOIN town.edge ON edge_id = edge_a WHERE axis_id = 5;
DELETE FROM town.corner_override;
SELECT pg_temp.decide(3, 1, 120), pg_temp.decide(2, 4, 5), pg_temp.decide(3, 9, 8), pg_temp.decide(11, 12, 60), pg_temp.decide(10, 3, 4), pg_temp.decide(10, 3, 3) \g /dev/null
SELECT * FROM pg_temp.told('greater than the radius that fits, m 26.5; where the width changes, not followed 0.0; for which no arc fits 0.0; with its centre beyond max_arc_distance, m 0.2; with a younger one of its corner, m 3.0');
UPDATE town.corner_override SET radius = 20 WHERE (axis_a, axis_b) = (3, 1);
DELETE FROM town.corner_override WHERE (axis_a, axis_b) <> (3, 1);
SELECT * FROM pg_temp.told(NULL);
BEGIN;
SET LOCAL streetgen.live = off;
UPDATE town.corner_override SET radius = 18;
SELECT * FROM pg_temp.told('not computed yet, m 20.0');
COMMIT;
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(100 50, 100 90)') WHERE axis_id = 3;
SELECT * FROM pg_temp.told('without its corner 18.0');
SELECT streetgen.drop_model('town') \g /dev/null

-- Where an axis goes on beyond its node it makes two corners with another: a radius may be of one or of both.
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0, 200 0)'), 7), (2, pg_temp.line('LINESTRING(100 60, 100 0, 105 -60)'), 7);
INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) VALUES (1, 2, 5, pg_temp.line('POINT(100 0)'));
SELECT * FROM pg_temp.told(NULL);
INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) VALUES (1, 2, 6, pg_temp.line('POINT(101 1)'));
SELECT * FROM pg_temp.told(NULL);
INSERT INTO town.corner_override (axis_a, axis_b, radius, geom) VALUES (1, 2, 7, pg_temp.line('POINT(99 -1)'));
SELECT * FROM pg_temp.told('with a younger one of its corner, m 7.0');

-- Every corner of the quarter by hand, small and great.
\o /dev/null
\ir ../../data/quarter.sql
INSERT INTO quarter.corner_override (axis_a, axis_b, radius, geom)
  SELECT a.axis_id, b.axis_id, (ARRAY[0, 2, 25, 90])[1 + row_number() OVER (ORDER BY a.axis_id, b.axis_id, n.geom) % 4], n.geom FROM quarter.corner c JOIN quarter.node n USING (node_id) JOIN quarter.edge a ON a.edge_id = c.edge_a JOIN quarter.edge b ON b.edge_id = c.edge_b;
\o
CREATE TABLE public.outcome AS SELECT o.corner_override_id AS id, o.radius AS wanted, max(o.corner_override_id) OVER (PARTITION BY o.axis_a, o.axis_b, c.node_id) = o.corner_override_id AS youngest, count(c.corner_id) OVER (PARTITION BY o.corner_override_id) AS meant, c.radius, c.method, t.rule, t.measure
  FROM quarter.corner_override o LEFT JOIN (quarter.corner c JOIN quarter.node n USING (node_id) JOIN quarter.edge a ON a.edge_id = c.edge_a JOIN quarter.edge b ON b.edge_id = c.edge_b) ON (a.axis_id, b.axis_id) = (o.axis_a, o.axis_b) AND ST_DWithin(n.geom, o.geom, 1e-6)
    LEFT JOIN streetgen.check_model('quarter') t ON (t.relation, t.id) = ('corner_override', o.corner_override_id);
SELECT 'each that is not followed has one row, and no other has any', bool_and((rule IS NULL) = (wanted = radius)) AND count(*) = count(DISTINCT id) AND count(*) > 50 FROM public.outcome WHERE youngest AND meant = 1;
SELECT 'with the radius that its corner has', bool_and(abs(measure - radius) < 1e-9) FROM public.outcome WHERE rule IS NOT NULL AND youngest AND meant = 1;
SELECT 'and why: ' || why, bool_and(method = word) AND count(*) > 0 FROM (VALUES ('where the width changes, not followed', 'transition'), ('for which no arc fits', 'no_arc'), ('greater than the radius that fits, m', 'radius_reduced')) v(why, word) JOIN public.outcome ON rule = 'corner override ' || why AND youngest AND meant = 1 GROUP BY why ORDER BY why;
