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
-- Counted lanes on a roadway of stated width grow to setting lane_width_maximal; the rest lies beside them.
SELECT streetgen.set('town', 'lane_width', '3.5'), streetgen.set('town', 'roundabout_tags', 'true'), streetgen.create_model('left', 32631, driving_side => 'left'), streetgen.set('left', 'roundabout_tags', 'true') \g /dev/null
CREATE TABLE counted AS SELECT row_number() OVER () + 9100 AS axis_id, ST_Translate(pg_temp.line(row_number() OVER ()::integer), 0, 20000) AS geom, v.* FROM (VALUES
  ('two lanes', 9::float8, 'primary', 'both', 2, NULL::integer, NULL, NULL, NULL, '4 4 beside 0.5'), ('one way against the line', 9, 'primary', 'reverse', 2, NULL, NULL, NULL, NULL, '4 4 beside 0.5'),
  ('a middle lane too', 13, 'primary', 'both', 3, 1, NULL, NULL, NULL, '4 4 4 beside 0.5'), ('none is wider than it has room', 7, 'primary', 'both', 2, NULL, NULL, NULL, NULL, '3.5 3.5 beside 0'),
  ('a stated width holds, and the other lane grows', 10, 'primary', 'direct', 2, NULL, NULL, '5|', NULL, '5 4 beside 0.5'), ('buses keep to it', 9, 'primary', 'direct', NULL, NULL, 'general|bus', NULL, NULL, '4 4 beside 0.5'),
  ('beside a cycle lane all is filled, which lies at the kerb', 10.5, 'primary', 'direct', NULL, NULL, 'general|general|cycle', NULL, NULL, '4.5 4.5 1.5 beside 0'),
  ('the only lane of both directions is the roadway', 5, 'residential', 'both', 1, NULL, NULL, NULL, NULL, '5 beside 0'), ('the lane of a ring is too', 7, 'primary', 'direct', 1, NULL, NULL, NULL, 'roundabout', '7 beside 0'),
  ('nobody counted these', 9, 'primary', 'both', NULL, NULL, NULL, NULL, NULL, '4.5 4.5 beside 0'), ('a runway has no lanes', 9, 'runway', 'both', 2, NULL, NULL, NULL, NULL, '4.5 4.5 beside 0'))
  v(name, width, kind, direction, lane_count, lanes_both, kind_forward, lane_width_forward, roundabout_tag, wanted);
INSERT INTO town.axis (axis_id, geom, width, kind, direction, lane_count, lanes_both, kind_forward, lane_width_forward, roundabout_tag) SELECT axis_id, geom, width, kind, direction, lane_count, lanes_both, kind_forward, lane_width_forward, roundabout_tag FROM counted;
INSERT INTO "left".axis (axis_id, geom, width, kind, direction, lane_count, lanes_both, kind_forward, lane_width_forward, roundabout_tag) SELECT axis_id, geom, width, kind, direction, lane_count, lanes_both, kind_forward, lane_width_forward, roundabout_tag FROM counted;
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT FROM streetgen.generate('left') \g /dev/null
CREATE VIEW across AS SELECT model, axis_id, string_agg(round(l.width::numeric, 6)::float8::text, ' ' ORDER BY lane_position) || ' beside ' || round(((e.width - sum(l.width)) / 2)::numeric, 6)::float8 AS made
  FROM (SELECT 'town' AS model, * FROM town.lane UNION ALL SELECT 'left', * FROM "left".lane) l
  JOIN (SELECT 'town' AS model, * FROM town.edge UNION ALL SELECT 'left', * FROM "left".edge) e USING (model, edge_id) GROUP BY model, axis_id, e.edge_id, e.width;
SELECT format('%s, where one drives on the %s', name, CASE model WHEN 'town' THEN 'right' ELSE model END), made = wanted FROM counted JOIN across USING (axis_id) ORDER BY axis_id, model DESC;
SELECT 'half of the rest lies at either kerb', array_agg(round(axis_offset::numeric, 6) ORDER BY lane_position) = '{2,-2}' FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 9101;
UPDATE town.axis SET width = 11 WHERE axis_id = 9101;
SELECT 'an edit of the width leaves the lanes', made = '4 4 beside 1.5' FROM across WHERE (model, axis_id) = ('town', 9101);
SELECT 'as a run from scratch would', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
SELECT streetgen.set('town', 'lane_width_maximal', NULL), streetgen.set('left', 'lane_width_maximal', '3.75') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT FROM streetgen.generate('left') \g /dev/null
SELECT 'without a greatest width they fill it', made = '5.5 5.5 beside 0' FROM across WHERE (model, axis_id) = ('town', 9101);
SELECT 'another holds', made = '3.75 3.75 beside 0.75' FROM across WHERE (model, axis_id) = ('left', 9101);
