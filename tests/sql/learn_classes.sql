\set ECHO none
\ir shared/truths.sql
-- What streets that state their widths, lanes and parking say of their class.  (name, holds)
SELECT streetgen.create_model('town', 2154, subjects => '{}', driving_side => 'right') \g /dev/null
-- A wild one stands among them, and one that is not believed.
INSERT INTO town.axis (geom, kind, width, lane_count, direction, source) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 100 * n, 6860000), ST_MakePoint(650000 + 100 * n, 6860050)), 2154), kind, width, lanes, direction, 'survey'
  FROM (SELECT row_number() OVER () AS n, * FROM (SELECT 'residential' AS kind, 7.2 + 0.1 * (i % 3) AS width, 2 AS lanes, 'both' AS direction FROM generate_series(1, 12) i UNION ALL VALUES ('residential', 60, 12, 'both'), ('residential', 90, 2, 'both') UNION ALL
    SELECT 'residential', NULL, NULL, 'both' FROM generate_series(1, 3) UNION ALL SELECT 'tertiary', 9.5, 2, 'both' FROM generate_series(1, 9) UNION ALL SELECT 'secondary', 11, 2, 'both' FROM generate_series(1, 11) UNION ALL SELECT 'secondary', 11, 2, 'direct' FROM generate_series(1, 11) UNION ALL
    SELECT 'motorway', 16, 3, 'direct' FROM generate_series(1, 20)) a) s;
CREATE FUNCTION pg_temp.proposed(asked text) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(concat_ws(' ', column_name, coalesce(now::text, '-'), proposed, ways, round(spread::numeric, 2)), ', ' ORDER BY column_name) FROM streetgen.learn_classes('town') WHERE class = asked $$;
SELECT 'the median of what is stated, whatever one says', pg_temp.proposed('residential') = 'lanes_each_way - 1 14 0.00, width 6 7.3 13 0.10';
SELECT 'few ways say nothing of a class', pg_temp.proposed('tertiary') IS NULL;
SELECT 'room beside the lanes is parking, and widths are without it', pg_temp.proposed('secondary') = 'lanes_each_way - 1 11 0.00, parking_left 0 2 22 0.00, parking_right 0 2 22 0.00, width 8 7 11 0.00, width_one_way - 7 11 0.00';
SELECT 'nobody parks on a highway', pg_temp.proposed('motorway') = 'lanes_one_way 2 4 20 0.00, width_one_way 7.5 16 20 0.00';
SELECT streetgen.set('town', 'class_ways_minimal', '9') \g /dev/null
SELECT 'a setting says how few', pg_temp.proposed('tertiary') LIKE '%width 7 %9%';
SELECT streetgen.set('town', 'class_ways_minimal', '10') \g /dev/null
SELECT 'a proposal changes nothing', width = 6 FROM town.axis_class WHERE class = 'residential';
CREATE TABLE taken AS SELECT * FROM streetgen.learn_classes('town', accept => true);
SELECT 'what is accepted is written', (r.width, r.lanes_each_way, s.width, s.width_one_way, s.parking_left, s.parking_right, s.lanes_one_way) = (7.3, 1, 7, 7, 2, 2, 2) FROM town.axis_class r, town.axis_class s WHERE r.class = 'residential' AND s.class = 'secondary';
SELECT 'silent streets have it', bool_and(u.width = 7.3 AND u.lane_count = 2) AND count(*) = 3 FROM town.axis_used u JOIN town.axis a USING (axis_id) WHERE a.kind = 'residential' AND a.width IS NULL;
INSERT INTO town.axis (geom, kind) VALUES ('SRID=2154;LINESTRING(650000 6870000, 650100 6870000)', 'secondary');
SELECT 'with parking at both kerbs', u.width = 11 AND u.lane_count = 2 FROM town.axis_used u JOIN town.axis a USING (axis_id) WHERE a.kind = 'secondary' AND a.width IS NULL;
SELECT 'nothing more is proposed', count(*) = 0 FROM streetgen.learn_classes('town');
-- Parking that is stated, on the left of a street and of a one-way street against its line.
INSERT INTO town.axis (geom, kind, width, direction, kind_forward, kind_backward, parking_left, source) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 100 * n, 6880000), ST_MakePoint(650000 + 100 * n, 6880050)), 2154), 'unclassified', 8, way, forward, backward, said, 'survey'
  FROM generate_series(1, 7) WITH ORDINALITY i(i, n), (VALUES ('both', 'general', 'general|parking', NULL), ('reverse', NULL, 'general|parking', NULL), ('both', 'general', 'general', 'on_kerb|parallel')) v(way, forward, backward, said);
SELECT 'a side is seen along the line', pg_temp.proposed('unclassified') LIKE '%parking_left 0 2 21 0.00%' AND pg_temp.proposed('unclassified') NOT LIKE '%parking_right%';
-- Rights and bad input.
CREATE ROLE learn_reader ROLE CURRENT_USER;
SELECT streetgen.grant('town', 'learn_reader', 'reader') \g /dev/null
SET ROLE learn_reader;
SELECT 'a reader may ask', count(*) > 0 FROM streetgen.learn_classes('town');
SELECT 'and may not accept', test.state($$SELECT streetgen.learn_classes('town', true)$$) = '42501';
RESET ROLE;
SELECT 'no such model', test.state($$SELECT streetgen.learn_classes('nowhere')$$) = '3F000';
SELECT 'accept is NULL', test.state($$SELECT streetgen.learn_classes('town', NULL)$$) = '22004';
DELETE FROM town.axis;
SELECT 'no axes teach nothing', count(*) = 0 FROM streetgen.learn_classes('town');
DO $$ BEGIN PERFORM streetgen.drop_model('town'); END $$;
DROP OWNED BY learn_reader;
DROP ROLE learn_reader;
