\set ECHO none
\ir shared/truths.sql
\ir shared/cross_section.sql
-- Verges, buffers and cycle tracks between kerbs and sidewalks, as axes and tags say.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.cut(axis bigint, metres float8) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(side || ':' || pieces, ' ' ORDER BY side) FROM (
    SELECT side, string_agg(concat_ws(' ', '', nullif(kerb, 'standing'), kind, trim_scale(round((offset_to - offset_from)::numeric, 3))), ',' ORDER BY "order") AS pieces
    FROM streetgen.cross_section('town', axis, metres) GROUP BY side) s $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane,sidewalk,object,footway}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, sidewalk_left, sidewalk_right, strips_left, strips_right, parking_right, cycle_paved_right) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 6, 4, 2, 2, NULL, 'verge 1.5|cycle_track 2', NULL, 'asphalt'),
    (2, pg_temp.line('LINESTRING(0 100,100 100)'), 6, 4, 0, NULL, 'two_way_cycle_track', 'buffer|cycle_track', NULL, NULL),
    (3, pg_temp.line('LINESTRING(0 200,100 200)'), 6, 4, 2, 2, NULL, 'cycle_track', 'street_side', NULL),
    (4, pg_temp.line('LINESTRING(0 300,60 300,100 330)'), 6, 4, 2, 2, 'verge|cycle_track', 'cycle_track', NULL, NULL);
END $$;
SELECT 'strips lie between kerb and sidewalk', pg_temp.cut(1, 50) = 'left: general 3, kerb 0.3, sidewalk 1.7, outer right: general 3, kerb 0.3, verge 1.5, cycle_track 2, sidewalk 1.7, outer';
SELECT 'the width from the kerb counts them', (SELECT (sidewalk_left, sidewalk_right) = (2, 5.5) FROM town.edge WHERE axis_id = 1);
SELECT 'without a width they have that of settings, and without a sidewalk there is only the track', pg_temp.cut(2, 50) ~ '^left: general 3, kerb 0.3, cycle_track 3, outer right: general 3, kerb 0.3, buffer 0.75, cycle_track 2, sidewalk 1.7, outer$';
SELECT 'the paving of a track is that of its column', string_agg(DISTINCT paved, ',') = 'asphalt' FROM town.cross_section WHERE axis_id = 1 AND kind = 'cycle_track';
INSERT INTO town.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
SELECT 'behind bays beside the roadway', pg_temp.cut(3, 50) ~ 'right: general 3, flush kerb 0, bay 2, kerb 0.3, cycle_track 2, sidewalk 1.7, outer$';
SELECT 'of all: ' || name, holds FROM test.cross_section('town') WHERE name !~ 'lane lies';
SELECT 'each strip is ground of its sidewalk', count(*) = 9 AND bool_and(ST_Area(ST_Difference(t.surface, w.surface)) < 1e-6 AND ST_IsValid(t.surface)) FROM town.side_strip t JOIN town.sidewalk w USING (sidewalk_id);
SELECT 'they do not lie on each other', NOT EXISTS (SELECT FROM town.side_strip a JOIN town.side_strip b ON a.side_strip_id < b.side_strip_id AND ST_Area(ST_Intersection(a.surface, b.surface)) > 0.01);
SELECT 'they are as wide as they say, on a bend too', bool_and(abs(area - wanted) < 0.02 * wanted) FROM (SELECT ST_Area(t.surface) AS area,
  CASE t.kind WHEN 'verge' THEN 1.5 ELSE 2 END * ST_Length(ST_Intersection(ST_OffsetCurve(k.geom, CASE k.side WHEN 'left' THEN 1 ELSE -1 END * (0.3 + CASE WHEN t."order" = 2 THEN 2.5 WHEN t.kind = 'verge' THEN 0.75 ELSE 1 END)), w.surface)) AS wanted
  FROM town.side_strip t JOIN town.sidewalk w USING (sidewalk_id) JOIN town.kerb k ON (k.edge_id, k.side, k.part) = (w.edge_id, w.side, w.part) JOIN town.edge e ON e.edge_id = t.edge_id WHERE axis_id = 4) s WHERE wanted > 0;
INSERT INTO town.placement_rule (rule_id, type, along, side, every, axis_offset) VALUES (3, 'tree', 'border', 'both', 20, 1);
SELECT 'trees by rule stand on the verge, else behind the track', (SELECT bool_and(CASE side WHEN 'right' THEN axis_offset = 0.75 ELSE axis_offset = 1 END) AND count(*) > 4 FROM town.street_object WHERE type = 'tree' AND axis_id = 1)
  AND (SELECT bool_and(axis_offset = CASE side WHEN 'left' THEN 4 ELSE 3.75 END) FROM town.street_object WHERE type = 'tree' AND axis_id = 2);
CREATE FUNCTION pg_temp.there() RETURNS text LANGUAGE sql AS $$ SELECT md5(string_agg(concat_ws(' ', street_object_id, axis_id, abscissa, axis_offset, ST_AsEWKB(geom)), ',' ORDER BY street_object_id))
  || (SELECT md5(string_agg(concat_ws(' ', edge_id, side, part, width, ST_AsEWKB(surface)), ',' ORDER BY edge_id, side, part)) FROM town.sidewalk) FROM town.street_object $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE before text := pg_temp.there(); BEGIN
  PERFORM streetgen.generate('town', wait => true); RETURN before = pg_temp.there() AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error'); END $$;
SELECT 'people walk behind the strips', (SELECT walk_link.width FROM town.walk_link JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND walk_link.side = 'right' AND kind = 'sidewalk' ORDER BY metres DESC LIMIT 1) = 2
  AND NOT EXISTS (SELECT FROM town.walk_link w JOIN town.side_strip s ON s.kind = 'cycle_track' AND ST_Length(ST_Intersection(w.geom, s.surface)) > 3 WHERE w.kind = 'sidewalk')
  AND NOT EXISTS (SELECT FROM town.walk_link JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND walk_link.side = 'left');
SELECT 'no tree stands in a bay or on a track', NOT EXISTS (SELECT FROM town.street_object o JOIN town.parking_bay b ON ST_Intersects(o.geom, b.surface) WHERE type = 'tree') AND NOT EXISTS (SELECT FROM town.street_object o JOIN town.side_strip s
  ON s.kind = 'cycle_track' AND ST_Intersects(o.geom, s.surface) WHERE type = 'tree');
SELECT 'a run from scratch makes the same', pg_temp.still();
UPDATE town.axis SET strips_left = 'cycle_track 1.8', strips_right = NULL WHERE axis_id = 1;
SELECT 'live', pg_temp.cut(1, 50) = 'left: general 3, kerb 0.3, cycle_track 1.8, sidewalk 1.7, outer right: general 3, kerb 0.3, sidewalk 1.7, outer' AND pg_temp.still();
SELECT streetgen.set('town', 'cycle_track_width', '2.3') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'a setting says how wide they are', pg_temp.cut(3, 50) ~ 'right:.*cycle_track 2.3, sidewalk 1.7' AND pg_temp.cut(1, 50) ~ 'cycle_track 1.8' AND pg_temp.still();
SELECT streetgen.set('town', 'cycle_track_width', '2') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
UPDATE town.axis SET strips_right = 'verge 1.5|cycle_track 2', sidewalk_left = NULL, sidewalk_right = NULL WHERE axis_id = 1;
-- A sidewalk that is mapped lies behind the strips: its line is its middle.
INSERT INTO town.footway (footway_id, geom, role) VALUES (1, pg_temp.line('LINESTRING(0 -7.8,100 -7.8)'), 'sidewalk');
SELECT 'a mapped sidewalk lies behind them', pg_temp.cut(1, 50) ~ 'right: general 3, kerb 0.3, verge 1.5, cycle_track 2, sidewalk 2.3, outer$';
UPDATE town.axis SET sidewalk_apart = 'left' WHERE axis_id = 1;
SELECT 'where none is mapped the strips stay', pg_temp.cut(1, 50) ~ '^left: general 3, kerb 0.3, cycle_track 1.8, outer';
-- Wrong words.
SELECT 'refused with a way out: ' || word, test.state(format('UPDATE town.axis SET strips_left = %L', word)) = '23514' FROM unnest('{grass,verge 0,verge -1,verge 25,verge|,"cycle_track 2|",track 2}'::text[]) word;
-- Pictures, sections and files.
SELECT 'pictures have them', array_agg(DISTINCT kind ORDER BY kind) = '{buffer,cycle_track,verge}' FROM streetgen._sidewalk_drawn('town', (SELECT ST_Expand(ST_Extent(geom)::geometry, 50) FROM town.axis), '{side_strip}');
SELECT 'so has a cut', streetgen.cross_section_svg('town', 1, 50) ~ '>cycle track<' AND streetgen.cross_section_svg('town', 1, 50) ~ '>verge<';
-- Tags of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line SELECT n, 'residential', 'street ' || n, NULL, tags::jsonb, 2, pg_temp.line(format('LINESTRING(0 %s,100 %1$s)', 1000 + 100 * n)) FROM (VALUES
  (1, '{"cycleway": "track"}'), (2, '{"cycleway": "track", "oneway": "yes"}'), (3, '{"cycleway:left": "track", "cycleway:left:oneway": "no", "cycleway:left:width": "2.5", "verge": "left", "verge:width": "3"}'),
  (4, '{"cycleway:right": "track", "cycleway:right:separation": "grass_verge", "cycleway:right:buffer": "0.5"}'), (5, '{"lanes": "2", "cycleway:right": "track", "cycleway:right:separation:left": "flex_post"}'),
  (6, '{"lanes": "2", "cycleway:both": "track", "cycleway:both:separation": "parking_lane", "parking:both": "lane"}'), (7, '{"verge": "both"}'), (8, '{"verge:right": "no", "cycleway:right:buffer": "1"}'),
  (9, '{"oneway": "-1", "cycleway": "track"}'), (10, '{"oneway": "yes", "cycleway": "opposite_track"}'), (11, '{"cycleway:right": "track", "cycleway:right:width": "wide", "verge:left:width": "2"}'), (12, '{"cycleway:right": "track;lane"}'),
  (13, '{"cycleway:right": "track", "cycleway:right:separation:left": "kerb", "cycleway:right:separation:right": "bollard"}'), (14, '{"cycleway:right": "track", "cycleway:right:separation:right": "grass_verge", "cycleway:right:buffer:left": "1"}'),
  (15, '{"lanes": "2", "cycleway:right": "track", "cycleway:right:separation:left": "bollard", "cycleway:right:separation:right": "grass_verge"}'), (16, '{"cycleway:left": "track", "cycleway:left:separation:both": "hedge", "verge:right": "separate"}')) v(n, tags);
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('town');
SELECT 'tags are strips: ' || source_ref, said IS NOT DISTINCT FROM expected FROM (VALUES (1, 'cycle_track / cycle_track'), (2, '/ cycle_track'), (3, 'verge 3|two_way_cycle_track 2.5 /'), (4, '/ verge|buffer 0.5|cycle_track'), (5, '/'),
  (6, '/'), (7, 'verge / verge'), (8, '/'), (9, 'cycle_track /'), (10, 'cycle_track /'), (11, '/ cycle_track'), (12, '/'), (13, '/ cycle_track'), (14, '/ buffer 1|cycle_track|verge'), (15, '/'), (16, 'verge|cycle_track|verge /')) v(n, expected) JOIN LATERAL (SELECT source_ref, btrim(concat_ws(' ', strips_left, '/', strips_right)) AS said FROM town.axis WHERE source_ref = n::text) a ON true;
SELECT 'posts stand on the roadway: the track is a lane', kind_forward = 'general|cycle' AND kind_backward IS NULL FROM town.axis WHERE source_ref = '5';
SELECT 'behind parked cars too', (kind_forward, kind_backward) = ('general|parking|cycle', 'general|parking|cycle') FROM town.axis WHERE source_ref = '6';
SELECT 'what has no place is named', array_agg(t.tag || ' ' || x.source_ref ORDER BY t.tag) = '{"cycleway:right:buffer 8","cycleway:right:width 11","verge:left:width 11","verge:right 16"}' FROM town.unread_tag t JOIN town.axis x ON x.source_ref = t.source_ref WHERE t.tag ~ 'buffer|separation|verge|width';
CREATE TABLE own AS SELECT 'x' || n AS id, pg_temp.line(format('LINESTRING(1000 %s,1100 %1$s)', 100 * n)) AS geom, CASE n WHEN 1 THEN ' verge 2|cycle_track' WHEN 2 THEN 'hedge' END AS strips FROM generate_series(1, 3) n;
CREATE TABLE mapped AS SELECT * FROM streetgen.import_axes('town', 'own', '{"source_ref": "id", "strips_right": "strips"}');
SELECT 'a mapping names the column', array_agg(strips_right ORDER BY source_ref) = '{verge 2|cycle_track,NULL,NULL}' AND EXISTS (SELECT FROM mapped WHERE what ~ 'strips_right' AND source_refs = '{x2}') FROM town.axis WHERE source_ref LIKE 'x%';
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT count(*) FROM streetgen.switch_subject('town', 'object', false) \g /dev/null
SELECT 'without objects and footways the strips stay', pg_temp.cut(3, 50) ~ 'right: general 3, kerb 0.3, cycle_track 2, sidewalk 1.7, outer$' AND (SELECT count(*) >= 9 FROM town.side_strip);
SELECT count(*) FROM streetgen.switch_subject('town', 'sidewalk', false) \g /dev/null
SELECT 'without sidewalks there are none', to_regclass('town.side_strip') IS NULL AND pg_temp.cut(1, 50) ~ 'kerb 0.3, outer';
