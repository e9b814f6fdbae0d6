\set ECHO none
\ir shared/truths.sql
-- Tables that contradict themselves, and an odd number of lanes of which nothing says the direction.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane}'), streetgen.create_model('left_town', 2154, subjects => '{lane}', driving_side => 'left');
END $$;
CREATE FUNCTION pg_temp.street(n integer, back boolean) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(CASE WHEN back THEN ST_Reverse(g) ELSE g END, 2154) FROM ST_MakeLine(ST_MakePoint(650000, 6860000 + 50 * n), ST_MakePoint(650100, 6860000 + 50 * n)) g $$;
-- Odd numbers: drawn forward and backward, driven on either side.
CREATE TABLE odd AS SELECT n || CASE WHEN back THEN 'b' ELSE 'f' END AS id, lane_count, width, both_ways, pg_temp.street(2 * n + back::integer, back) AS geom
  FROM (VALUES (1, 3, NULL::float8, NULL::integer), (2, 3, 9, NULL), (3, 5, 17, NULL), (4, 7, NULL, NULL), (5, 4, NULL, 1), (6, 3, NULL, 1), (7, 2, NULL, 1)) v(n, lane_count, width, both_ways), unnest('{f,t}'::boolean[]) back;
CREATE TABLE told AS SELECT * FROM streetgen.import_axes('town', 'odd', '{"source_ref": "id", "lane_count": "lane_count", "width": "width", "lanes_both": "both_ways"}');
SELECT FROM streetgen.import_axes('left_town', 'odd', '{"source_ref": "id", "lane_count": "lane_count", "width": "width", "lanes_both": "both_ways"}') \g /dev/null
CREATE FUNCTION pg_temp.lanes(model name) RETURNS text LANGUAGE plpgsql AS $$ BEGIN
  PERFORM set_config('search_path', quote_ident(model) || ', pg_temp, public', true);
  RETURN (SELECT string_agg(source_ref || ' ' || concat_ws('+', u.lanes_forward, u.lanes_both, u.lanes_backward), ', ' ORDER BY source_ref) FROM axis JOIN axis_used u USING (axis_id) WHERE source = 'odd'); END $$;
SELECT 'an odd lane is in the middle, however the street is drawn', pg_temp.lanes('town') = '1b 1+1+1, 1f 1+1+1, 2b 1+1+1, 2f 1+1+1, 3b 2+1+2, 3f 2+1+2, 4b 3+1+3, 4f 3+1+3, 5b 1+2+1, 5f 1+2+1, 6b 1+1+1, 6f 1+1+1, 7b 0+2+0, 7f 0+2+0';
SELECT 'on the left too', pg_temp.lanes('left_town') = pg_temp.lanes('town');
SELECT 'and is told, where nobody said so', source_refs = '{1b,1f,2b,2f,3b,3f,4b,4f}' FROM told WHERE what LIKE 'odd number of lanes%';
INSERT INTO town.axis (geom, name, lane_count, lanes_forward, turn_forward, turn_backward, lane_width_backward, direction) SELECT pg_temp.street(100 + n, false), 'said ' || n, 3, forward, turns, turns_back, widths_back, way
  FROM (VALUES (1, 2, NULL, NULL, NULL, 'both'), (2, 1, NULL, NULL, NULL, 'both'), (3, NULL, 'left|through', NULL, NULL, 'both'), (4, NULL, NULL, 'left|through', NULL, 'both'), (5, NULL, NULL, NULL, '3|3', 'both'), (6, NULL, NULL, NULL, NULL, 'direct')) v(n, forward, turns, turns_back, widths_back, way);
SELECT 'what is said of a direction holds, by a number or a list', string_agg(concat_ws('+', u.lanes_forward, u.lanes_both, u.lanes_backward), ' ' ORDER BY a.name) = '2+0+1 1+0+2 2+0+1 1+0+2 1+0+2 3+0+0' FROM town.axis a JOIN town.axis_used u USING (axis_id) WHERE a.name LIKE 'said%';
-- Rows whose columns contradict each other, or cannot be.
CREATE TABLE odd_words (id text, lc text, lf text, lb text, lbo text, dir text, w text, kf text, tf text, cf text, wf text, wb text, sp text, lv text, geom geometry);
INSERT INTO odd_words SELECT v.*, pg_temp.street(200 + row_number() OVER ()::integer, false) FROM (VALUES
  ('sum', '2', '3', '3', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL), ('kinds', '2', NULL, NULL, NULL, NULL, NULL, 'general|general|bus', NULL, NULL, NULL, NULL, NULL, NULL),
  ('list', NULL, '2', NULL, NULL, NULL, NULL, 'general|general|general', NULL, NULL, NULL, NULL, NULL, NULL), ('against', NULL, '1', '1', NULL, 'direct', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  ('turns', '2', NULL, NULL, NULL, NULL, NULL, NULL, 'left|through|right', NULL, NULL, NULL, NULL, NULL), ('changes', '2', NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'no|no', NULL, NULL, NULL, NULL),
  ('widths', '2', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, '3|3|3', NULL, NULL, NULL), ('wider', '2', NULL, NULL, NULL, NULL, '5', NULL, NULL, NULL, '3.5', '3.5', NULL, NULL),
  ('narrow', '6', NULL, NULL, NULL, NULL, '3', NULL, NULL, NULL, NULL, NULL, NULL, NULL), ('fast', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, '400', NULL),
  ('still', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, '0', NULL), ('ring', '2', NULL, NULL, '2', 'direct', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  ('square', NULL, NULL, NULL, NULL, NULL, '80', NULL, NULL, NULL, NULL, NULL, NULL, NULL), ('up', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'bridge'), ('fits', '3', '2', '1', NULL, 'both', '10.5', 'general|general|cycle', 'left|through', 'no|no', '3|3', '3', '50', '1')) v;
DROP TABLE told;
CREATE TABLE told AS SELECT * FROM streetgen.import_axes('town', 'odd_words', '{"source_ref": "id", "lane_count": "lc", "lanes_forward": "lf", "lanes_backward": "lb", "lanes_both": "lbo", "direction": "dir", "width": "w", "kind_forward": "kf", "turn_forward": "tf", "change_forward": "cf", "lane_width_forward": "wf", "lane_width_backward": "wb", "speed": "sp", "level": "lv"}');
SELECT ref || ' is told: ' || about, EXISTS (SELECT FROM told WHERE what LIKE about AND ref = ANY (source_refs)) FROM (VALUES ('sum', 'lane_count is not that of the directions%'), ('kinds', 'lane_count is not that%'), ('list', 'number of lanes is not that of their kinds%'),
  ('against', 'lanes against a one-way street%'), ('turns', 'turns are not those%'), ('changes', 'changes are not those%'), ('widths', 'widths are not those%'), ('wider', 'lanes wider than their street%'), ('narrow', 'width too small: 3 m%'), ('fast', 'speed that no street has%'),
  ('square', 'width that no street has%'), ('still', 'speed of zero%'), ('ring', 'lanes for both directions of a one-way street%'), ('up', 'level not understood%')) v(ref, about);
SELECT 'a row that agrees with itself is not', NOT EXISTS (SELECT FROM told WHERE 'fits' = ANY (source_refs));
SELECT 'check_model names them too', bool_and(EXISTS (SELECT FROM streetgen.check_model('town') f JOIN town.axis a ON a.axis_id = f.id WHERE f.rule = what AND a.source_ref = source_refs[1])) FROM told WHERE what ~ '^(lane|number|turns|changes|widths|(speed|width) that)';
-- A report is about its own source.
CREATE TABLE next_words AS SELECT 'n' AS id, pg_temp.street(300, false) AS geom;
SELECT 'an import names rows of its own source alone', NOT EXISTS (SELECT FROM streetgen.import_axes('town', 'next_words', '{"source_ref": "id"}') WHERE what ~ '^(lane|odd|width|number|turns|changes|speed|crosses)');
