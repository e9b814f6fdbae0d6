\set ECHO none
\ir shared/truths.sql
-- A roadway of stated lanes without a width is as wide as they are together.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 32631, subjects => '{lane}') \g /dev/null
CREATE FUNCTION pg_temp.line(n integer) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * n), ST_MakePoint(100, 100 * n)), 32631) $$;
INSERT INTO town.axis (geom, source, source_ref, name, kind, direction, lane_count, lanes_forward, lanes_backward, lanes_both, kind_forward, kind_backward, lane_width_forward, width)
SELECT pg_temp.line(row_number() OVER ()::integer), 'test', row_number() OVER (), v.* FROM (VALUES
  ('four lanes one way: 4 x 3.5', 'primary', 'direct', NULL::integer, 4, NULL::integer, NULL::integer, NULL, NULL, NULL, NULL::float8), ('against the line: 3 x 3.5', 'primary', 'reverse', NULL, NULL, 3, NULL, NULL, NULL, NULL, NULL),
  ('two and one: 3 x 3.5', 'secondary', 'both', NULL, 2, 1, NULL, NULL, NULL, NULL, NULL), ('with a middle lane: 3 x 3.5', 'secondary', 'both', 3, 1, 1, 1, NULL, NULL, NULL, NULL),
  ('a bus and a cycle lane: 2 x 3.5 + 1.5', 'primary', 'direct', NULL, NULL, NULL, NULL, 'general|bus|cycle', NULL, NULL, NULL), ('parking both ways: 2 x 3.5 + 2 x 2', 'residential', 'both', NULL, NULL, NULL, NULL, 'general|parking', 'general|parking', NULL, NULL),
  ('widths of their own: 3 + 2.75 + 1.2', 'primary', 'direct', NULL, NULL, NULL, NULL, 'general|general|cycle', NULL, '3|2.75|1.2', NULL), ('widths of driving lanes alone: 3 + 2.75 + 1.5', 'primary', 'direct', NULL, NULL, NULL, NULL, 'cycle|general|general', NULL, '3|2.75', NULL),
  ('one width left open: 3 + 3.5', 'primary', 'direct', 2, NULL, NULL, NULL, NULL, NULL, '3|', NULL), ('a list of another length says nothing: 2 x 3.5', 'primary', 'direct', 2, NULL, NULL, NULL, NULL, NULL, '3|3|3', NULL),
  ('a stated width holds: 9', 'primary', 'direct', NULL, 3, NULL, NULL, NULL, NULL, NULL, 9), ('one that is not believed does not: 2 x 3.5', 'primary', 'direct', 2, NULL, NULL, NULL, NULL, NULL, NULL, 30),
  ('a class leaves one lane 4.5', 'trunk_link', 'direct', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL), ('a runway is as its class: 40', 'runway', 'both', 1, NULL, NULL, NULL, NULL, NULL, NULL, NULL)) v;
UPDATE town.axis_class SET width = 5, speed = 100 WHERE class = 'trunk_link';
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT name, round(width::numeric, 6) = (wanted)::numeric FROM (SELECT source_ref::integer AS nth, name, u.width FROM town.axis JOIN town.axis_used u USING (axis_id)) a
  JOIN unnest('{14,10.5,10.5,10.5,8.5,11,6.95,7.25,6.5,7,9,7,4.5,40}'::float8[]) WITH ORDINALITY w(wanted, nth) USING (nth) ORDER BY nth;
SELECT 'and its lanes are as wide as they say', array_agg(round(l.width::numeric, 6) ORDER BY a.source_ref, lane_position) = '{3.5,3.5,3.5,3.5,3,2.75,1.2,1.5,3,2.75}'
  FROM town.lane l JOIN town.edge USING (edge_id) JOIN town.axis a USING (axis_id) WHERE source_ref IN ('1', '7', '8');
SELECT streetgen.set('town', 'lane_width', '3') \g /dev/null
SELECT 'the setting holds', array_agg(round(u.width::numeric, 6) ORDER BY source_ref) = '{12,9}' FROM town.axis JOIN town.axis_used u USING (axis_id) WHERE source_ref IN ('1', '2');
-- Parking of a class stands where nothing is stated, widths of lanes among that.
INSERT INTO town.axis (axis_id, geom, kind, lane_width_forward, lane_width_backward, width_end) SELECT 9000 + i, ST_Translate(geom, 0, 5000 + 50 * i), 'residential', CASE i WHEN 1 THEN '2.6' END, CASE i WHEN 1 THEN '3.4' END, CASE i WHEN 2 THEN 9 END
  FROM (SELECT geom FROM town.axis ORDER BY axis_id LIMIT 1) a, generate_series(1, 3) i;
UPDATE town.axis_class SET parking_right = 2 WHERE class = 'residential';
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT 'stated widths of lanes hold beside the parking of a class', array_agg(round(l.width::numeric, 6) ORDER BY lane_position) = '{3.4,2.6}' FROM town.lane l JOIN town.edge USING (edge_id) WHERE axis_id = 9001;
SELECT 'that stands where nothing is stated alone', array_agg(DISTINCT axis_id ORDER BY axis_id) = '{9003}' FROM town.lane l JOIN town.edge USING (edge_id) WHERE axis_id > 9000 AND l.kind = 'parking';
