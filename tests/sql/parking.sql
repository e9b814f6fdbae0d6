\set ECHO none
\ir shared/truths.sql
\ir shared/cross_section.sql
-- Bays beside the roadway and on the kerb, as axes say that cars stand there.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.mirrored(geometry) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Affine($1, 1, 0, 0, -1, 0, 2 * 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154, subjects => '{lane,sidewalk,object}', driving_side => CASE m WHEN 'mirror' THEN 'left' ELSE 'right' END) FROM unnest('{town,against,mirror}'::name[]) m;
  INSERT INTO town.axis (axis_id, geom, width, direction, name, lanes_forward, lanes_backward, sidewalk_left, sidewalk_right, parking_left, parking_right, importance) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 6, 'both', 'one', 1, 1, 3, 3, NULL, 'street_side', 4),
    (2, pg_temp.line('LINESTRING(0 100,100 100)'), 6, 'both', 'two', 1, 1, 3, 4, 'no', 'on_kerb|parallel|2.2|8', 4),
    (3, pg_temp.line('LINESTRING(0 200,100 200)'), 7, 'both', 'three', 1, 1, 3, 3, 'half_on_kerb', 'half_on_kerb', 4),
    (4, pg_temp.line('LINESTRING(0 300,100 300)'), 6, 'both', 'four', 1, 1, 2, 2, 'street_side|perpendicular', 'street_side|diagonal', 4),
    (5, pg_temp.line('LINESTRING(0 400,100 400)'), 4, 'reverse', 'five', NULL, 1, 3, 3, 'street_side|diagonal', 'on_kerb||4', 4),
    (6, pg_temp.line('LINESTRING(0 500,100 500)'), 7, 'direct', 'six', 2, NULL, 0, 2, 'on_kerb', NULL, 4), (7, pg_temp.line('LINESTRING(0 508,100 508)'), 7, 'reverse', 'six', NULL, 2, 2, 0, NULL, NULL, 4),
    (8, pg_temp.line('LINESTRING(0 600,100 600)'), 6, 'both', 'eight', 1, 1, 0, 2.5, 'street_side|||99', 'on_kerb', 4),
    (9, pg_temp.line('LINESTRING(0 700,60 700,100 712)'), 8, 'both', 'nine', 1, 1, 3, 3, 'no', 'street_side|parallel|2.5', 4),
    (10, pg_temp.line('LINESTRING(0 800,100 800)'), 9, 'direct', 'ten', 1, NULL, 2, 2, NULL, NULL, 4);
  INSERT INTO against.axis (axis_id, geom, width, direction, name, lanes_forward, lanes_backward, sidewalk_left, sidewalk_right, parking_left, parking_right, importance)
    SELECT axis_id, ST_Reverse(geom), width, CASE direction WHEN 'direct' THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE direction END, name, lanes_backward, lanes_forward, sidewalk_right, sidewalk_left, parking_right, parking_left,
      importance FROM town.axis;
  INSERT INTO mirror.axis (axis_id, geom, width, direction, name, lanes_forward, lanes_backward, sidewalk_left, sidewalk_right, parking_left, parking_right, importance)
    SELECT axis_id, pg_temp.mirrored(geom), width, direction, name, lanes_forward, lanes_backward, sidewalk_right, sidewalk_left, parking_right, parking_left, importance FROM town.axis;

  INSERT INTO town.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
  INSERT INTO against.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
  INSERT INTO mirror.placement_rule (rule_id, type, along) VALUES (2, 'parking_bay', 'lane');
END $$;
CREATE FUNCTION pg_temp.bays(model name, axis bigint) RETURNS text LANGUAGE plpgsql AS $$ DECLARE said text; BEGIN
  EXECUTE format('SELECT string_agg(concat_ws('' '', n, side, length, width, round(angle), axis_offset), '', '' ORDER BY side) FROM (SELECT count(*) AS n, side, length, width, p.angle, axis_offset FROM %1$I.parking_bay p
    JOIN %1$I.street_object USING (street_object_id) WHERE axis_id = $1 AND surface IS NOT NULL GROUP BY 2, 3, 4, 5, 6) b', model) INTO said USING axis;
  RETURN said; END $$;
CREATE FUNCTION pg_temp.told(said text) RETURNS bigint[] LANGUAGE sql AS $$ SELECT array_agg(DISTINCT coalesce(o.axis_id, c.id) ORDER BY coalesce(o.axis_id, c.id)) FROM streetgen.check_model('town') c
  LEFT JOIN town.street_object o ON o.street_object_id = c.id AND c.relation::text = 'parking_bay' WHERE c.rule = $1 $$;
CREATE FUNCTION pg_temp.cut(axis bigint, metres float8) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(side || ':' || pieces, ' ' ORDER BY side) FROM (
    SELECT side, string_agg(concat_ws(' ', '', nullif(kerb, 'standing'), kind, trim_scale(round((offset_to - offset_from)::numeric, 3))), ',' ORDER BY "order") AS pieces
    FROM streetgen.cross_section('town', axis, metres) GROUP BY side) s $$;
-- What an edit leaves is what a run from scratch makes.
CREATE FUNCTION pg_temp.there() RETURNS text LANGUAGE sql AS $$ SELECT md5(coalesce(string_agg(concat_ws(' ', street_object_id, o.axis_id, o.abscissa, o.axis_offset, length, width, b.angle, ST_AsEWKB(surface)), ',' ORDER BY street_object_id), 'none'))
  || (SELECT md5(string_agg(concat_ws(' ', edge_id, side, part, width, ST_AsEWKB(surface), ST_AsEWKB(strip)), ',' ORDER BY edge_id, side, part)) FROM town.sidewalk)
  FROM town.parking_bay b JOIN town.street_object o USING (street_object_id) $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE before text := pg_temp.there(); BEGIN
  PERFORM streetgen.generate('town', wait => true); RETURN before = pg_temp.there() AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error'); END $$;

-- Side by side between five metres from both limits.
SELECT 'between roadway and sidewalk', pg_temp.bays('town', 1) = '18 right 5 2 0 2';
SELECT 'so many as the source counts', pg_temp.bays('town', 2) = '8 right 5 2.2 0 2.2';
SELECT 'along all of the side', min(a) = 12.5 AND max(b) = 87.5 AND max(gap) <= 15 FROM (SELECT abscissa - lag(abscissa) OVER (ORDER BY abscissa) AS gap, min(abscissa) OVER () AS a, max(abscissa) OVER () AS b
  FROM town.street_object WHERE axis_id = 2) g;
SELECT 'half on the kerb', pg_temp.bays('town', 3) = '18 left 5 2 0 1, 18 right 5 2 0 1';
SELECT 'across the street and askew', pg_temp.bays('town', 4) = '39 left 5 2.3 90 5, 35 right 5 2.3 64 4.5';
SELECT 'one drives into those askew, whichever way the street runs', pg_temp.bays('town', 5) ~ '^\d+ left 5 2.3 64 4.5, \d+ right 5 2.3 127 4$';
SELECT 'an unknown way to stand is told by the depth', pg_temp.bays('town', 5) ~ 'right 5 2.3 127 4';
SELECT 'no bay lies on the roadway of another street', pg_temp.bays('town', 6) IS NULL;
SELECT 'none without a word', pg_temp.bays('town', 7) IS NULL;
SELECT 'on a bend', pg_temp.bays('town', 9) ~ '^\d+ right 5 2.5 0 2.5$';
SELECT 'beside the roadway and on no other bay', bool_and(ST_Area(ST_Intersection(b.surface, s.surface)) < 0.02 * ST_Area(b.surface) + CASE o.axis_id WHEN 3 THEN 0.5 * ST_Area(b.surface) ELSE 0 END)
  FROM town.parking_bay b JOIN town.street_object o USING (street_object_id) JOIN town.section s ON s.surface && b.surface WHERE o.axis_id <> 9;
SELECT 'and on no other bay', count(*) = 0 FROM town.parking_bay a JOIN town.parking_bay b ON a.street_object_id < b.street_object_id AND ST_Area(ST_Intersection(a.surface, b.surface)) > 0.01;

-- Sidewalks: behind a bay beside the roadway, narrower by one on the kerb.
SELECT 'the sidewalk lies behind its bays', pg_temp.cut(1, 50) = 'left: general 3, kerb 0.3, furnishing 1, sidewalk 1.7, outer right: general 3, flush kerb 0, bay 2, kerb 0.3, furnishing 1, sidewalk 1.7, outer';
SELECT 'beside them the kerb comes forward', pg_temp.cut(1, 4) ~ 'right: general 3, kerb 0.3, furnishing 1.7, sidewalk 3, outer$';
SELECT 'a bay on the kerb takes from it', pg_temp.cut(2, (SELECT min(abscissa) FROM town.street_object WHERE axis_id = 2)) ~ 'right: general 3, flush kerb 0, bay 2.2, sidewalk 1.8, outer$';
SELECT 'half on the kerb it takes from both', pg_temp.cut(3, 50) = 'left: general 2.5, bay 1, flush kerb 0, bay 1, sidewalk 2, outer right: general 2.5, bay 1, flush kerb 0, bay 1, sidewalk 2, outer';
SELECT 'no sidewalk comes of a bay', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 8 AND side = 'left') AND pg_temp.bays('town', 8) ~ '^18 left';
SELECT 'widths of edges are those from the kerb', (SELECT (sidewalk_left, sidewalk_right) = (3, 5) FROM town.edge WHERE axis_id = 1);
SELECT 'surfaces part the ground', bool_and(NOT ST_Intersects(a.surface, b.surface) OR ST_Area(ST_Intersection(a.surface, b.surface)) < 0.01) FROM (SELECT surface FROM town.sidewalk) a, (SELECT surface FROM town.section
  UNION ALL SELECT surface FROM town.intersection) b;

SELECT 'nor do bays share it with sidewalks', bool_and(ST_Area(ST_Intersection(b.surface, w.surface)) < 0.01) FROM town.parking_bay b JOIN town.sidewalk w ON w.surface && b.surface;
SELECT 'what these take is all that a sidewalk lacks', bool_and(abs(ST_Area(strip) - ST_Area(w.surface) - taken) < 0.1 + 0.001 * taken) AND count(*) >= 10 FROM (SELECT w.*, (SELECT ST_Area(ST_Intersection(w.strip, ST_Union(b.surface)))
  FROM town.parking_bay b WHERE b.surface && w.strip) AS taken FROM town.sidewalk w WHERE strip IS NOT NULL) w;
SELECT 'behind bays it lies in one piece, as wide as the axis says', (SELECT array_agg(ST_NumGeometries(surface) || ' ' || round(ST_Area(ST_Intersection(surface, ST_Expand(ST_SetSRID(ST_MakePoint(650050, 6859996), 2154), 5, 5)))::numeric, 1)) = '{"1 30.0"}'
  FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND side = 'right');

SELECT 'with bays beside it: ' || name, holds FROM test.cross_section('town') WHERE name !~ 'lane lies';

-- Told by check_model.
SELECT 'told: what leaves 5 m to both directions', pg_temp.told('parking bay that leaves a narrow roadway, m') = '{3}';
SELECT 'told: what leaves half a metre of sidewalk', pg_temp.told('parking bay that leaves a narrow sidewalk, m') = '{5,8}';
SELECT 'told: cars without a bay', pg_temp.told('fewer parking bays than the source says') = '{6,8}' AND (SELECT measure FROM streetgen.check_model('town') WHERE rule = 'fewer parking bays than the source says' AND id = 8) = 81;

-- Edits.
SELECT 'a run from scratch makes the same', pg_temp.still();
UPDATE town.axis SET parking_right = 'no' WHERE axis_id = 1;
SELECT 'none where none may stand', pg_temp.bays('town', 1) IS NULL AND pg_temp.cut(1, 50) ~ 'right: general 3, kerb 0.3, furnishing 1, sidewalk 1.7, outer$' AND pg_temp.still();
UPDATE town.axis SET parking_right = 'street_side' WHERE axis_id = 1;
SELECT 'and back', pg_temp.bays('town', 1) = '18 right 5 2 0 2' AND pg_temp.still();
INSERT INTO town.pedestrian_crossing_editing (axis_id, abscissa) VALUES (1, 50);
SELECT 'a crossing parts them', pg_temp.bays('town', 1) = '16 right 5 2 0 2' AND pg_temp.still();
DELETE FROM town.street_object WHERE type = 'crossing';
INSERT INTO town.axis (axis_id, geom, width, kind) VALUES (20, pg_temp.line('LINESTRING(50 0,50 -40)'), 4, 'service');
SELECT 'and so does a driveway', (SELECT min(abs(abscissa - 50)) > 7.4 FROM town.street_object WHERE axis_id = 1) AND pg_temp.still();
DELETE FROM town.axis WHERE axis_id = 20;
SELECT streetgen.set('town', 'parking_depth_parallel', '2.4') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'a setting says how deep they are', pg_temp.bays('town', 1) = '18 right 5 2.4 0 2.4' AND pg_temp.bays('town', 2) = '8 right 5 2.2 0 2.2' AND pg_temp.cut(1, 50) ~ 'bay 2.4, kerb 0.3, furnishing 1, sidewalk 1.7, outer$';
SELECT streetgen.set('town', 'parking_depth_parallel', '2') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
-- Without the rule no strip is kept for bays.
UPDATE town.placement_rule SET active = false WHERE rule_id = 2;
SELECT 'without their rule streets have no bays', NOT EXISTS (SELECT FROM town.parking_bay) AND NOT EXISTS (SELECT FROM town.sidewalk WHERE strip IS NOT NULL);
SELECT 'nor a strip for these', pg_temp.cut(1, 50) ~ 'right: general 3, kerb 0.3, furnishing 1, sidewalk 1.7, outer$' AND (SELECT (sidewalk_left, sidewalk_right) = (3, 3) FROM town.edge WHERE axis_id = 1) AND pg_temp.still();
UPDATE town.placement_rule SET active = true WHERE rule_id = 2;
SELECT 'with it they have both', pg_temp.bays('town', 1) = '18 right 5 2 0 2' AND pg_temp.cut(1, 50) ~ 'bay 2, kerb 0.3, furnishing 1, sidewalk 1.7, outer$' AND pg_temp.still();
SET streetgen.computes = 'on';
UPDATE town.sidewalk s SET surface = strip FROM town.edge e WHERE e.edge_id = s.edge_id AND (e.axis_id, s.side) = (1, 'right');
RESET streetgen.computes;
SELECT 'check_model knows a sidewalk that goes on under bays', count(*) = 1 AND min(measure) > 100 FROM streetgen.check_model('town') WHERE rule = 'sidewalk under a parking bay, m2';
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'and generate cuts it again', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'sidewalk under a parking bay, m2') AND pg_temp.still();
-- By hand: bays that are dragged on to a sidewalk, and taken from it.
INSERT INTO town.parking_bay_editing (geom) VALUES (pg_temp.line('POINT(50 804.5)'));
UPDATE town.parking_bay_editing SET axis_offset = 2 WHERE axis_id = 10;
SELECT 'a bay that is dragged takes the ground of a sidewalk', (SELECT round(ST_Area(ST_Intersection(strip, b.surface))::numeric, 1) = 10 AND NOT ST_Overlaps(ST_Buffer(b.surface, -0.01), s.surface) FROM town.sidewalk s JOIN town.edge USING (edge_id), town.parking_bay b JOIN town.street_object o USING (street_object_id)
  WHERE (s.side, edge.axis_id, o.axis_id) = ('left', 10, 10)) AND pg_temp.still();
UPDATE town.parking_bay_editing SET axis_offset = 0 WHERE axis_id = 10;
SELECT 'and gives it back', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 10 AND strip IS NOT NULL) AND pg_temp.still();
UPDATE town.parking_bay_editing SET axis_offset = 2 WHERE axis_id = 10;
DELETE FROM town.street_object WHERE axis_id = 10;
SELECT 'also where it goes', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 10 AND strip IS NOT NULL) AND pg_temp.still();
-- Rules along borders.
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset) VALUES (3, 'parking_bay', 'both', 10, 0);
SELECT 'where a source says how cars stand, or that none may, rules place no others', (SELECT array_agg(DISTINCT axis_id || side ORDER BY axis_id || side) = '{10left,10right}' FROM town.street_object WHERE rule_id = 3) AND pg_temp.still();
DELETE FROM town.placement_rule WHERE rule_id = 3;
SELECT name, test.state(sql) = '23514' FROM (VALUES ('a place that is none is refused', $$UPDATE town.axis SET parking_left = 'onkerb' WHERE axis_id = 1$$), ('and a depth', $$UPDATE town.axis SET parking_left = 'on_kerb||wide' WHERE axis_id = 1$$),
  ('and a depth of none', $$UPDATE town.axis SET parking_left = 'no|parallel' WHERE axis_id = 1$$)) c(name, sql);

-- The other way round, and in its mirror.
CREATE FUNCTION pg_temp.same(a geometry, b geometry) RETURNS boolean LANGUAGE sql AS $$ SELECT a && b AND ST_Area(ST_SymDifference(a, b)) < 0.01 $$;
SELECT 'drawn backward the bays are the same', count(*) > 100 AND count(*) = count(b.street_object_id) FROM against.parking_bay b RIGHT JOIN (SELECT surface FROM town.parking_bay JOIN town.street_object USING (street_object_id)
) t ON pg_temp.same(b.surface, t.surface);
SELECT 'driven on the left they are the image', count(*) > 100 AND count(*) = count(b.street_object_id) AND count(*) = (SELECT count(*) FROM mirror.parking_bay) FROM mirror.parking_bay b
  RIGHT JOIN (SELECT pg_temp.mirrored(surface) AS surface FROM town.parking_bay) t ON pg_temp.same(b.surface, t.surface);

-- A model of an older build lacks the column.
ALTER TABLE mirror.sidewalk DROP strip CASCADE;
SELECT streetgen._mend_sidewalk_tables('mirror') \g /dev/null
SELECT 'an older model gets the column', format_type(atttypid, atttypmod) = 'geometry(MultiPolygon,2154)' FROM pg_attribute WHERE attrelid = 'mirror.sidewalk'::regclass AND attname = 'strip';

-- From tags of OpenStreetMap, in both schemes.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, geom geometry(LineString, 2154));
INSERT INTO osm_line (way_id, class, tags, geom) SELECT n, 'residential', tags::jsonb, pg_temp.line(format('LINESTRING(0 %1$s,100 %1$s)', 100 * n)) FROM (VALUES
  (1, '{"width": "6", "parking:right": "street_side", "parking:right:orientation": "perpendicular", "parking:right:capacity": "20", "parking:left": "no"}'),
  (2, '{"parking:both": "half_on_kerb", "parking:both:width": "2.5 m"}'), (3, '{"parking:lane:left": "diagonal", "parking:lane:left:diagonal": "on_kerb", "parking:lane:right": "no_stopping"}'),
  (4, '{"oneway": "yes", "parking:right": "lane", "parking:right:capacity": "7", "parking:left": "separate"}'), (5, '{"parking:lane:both": "parallel"}'), (6, '{"parking:right": "street_side", "parking:right:capacity": "some"}')) w(n, tags);
SELECT streetgen.create_model('read', 2154, subjects => '{lane,sidewalk,object}') \g /dev/null
CREATE TABLE report AS SELECT * FROM streetgen.import_osm('read', 'osm');
SELECT 'tags become columns: way ' || source_ref, concat_ws(' / ', coalesce(parking_left, '-'), coalesce(parking_right, '-')) = said FROM read.axis JOIN (VALUES (1, 'no / street_side|perpendicular||20'),
  (2, 'half_on_kerb||2.5 / half_on_kerb||2.5'), (3, 'on_kerb|diagonal / no'), (4, '- / lane|||7'), (5, '- / -'), (6, '- / street_side')) v(way, said) ON way = source_ref::integer ORDER BY 1;
SELECT 'a capacity that is none is named, and cars that are drawn apart', array_agg(source_ref || ' ' || tag ORDER BY source_ref) = '{"4 parking:left","6 parking:right:capacity"}' FROM read.unread_tag;
SELECT 'told', array_agg(class || ' ' || count ORDER BY class) = '{"half_on_kerb 2","no 2","on_kerb 1","street_side 2"}' FROM report WHERE what LIKE 'sides of streets%';
SELECT 'a rule makes bays of them', (SELECT array_agg(along || ' ' || type) = '{"lane parking_bay"}' FROM read.placement_rule) AND (SELECT count = 6 FROM report WHERE what LIKE 'rule % makes parking bays%');
SELECT FROM streetgen.generate('read', wait => true) \g /dev/null
SELECT 'beside the roadway and on lanes', array_agg(source_ref || ' ' || n ORDER BY source_ref) = '{"1 20","2 36","3 35","4 7","5 36","6 18"}' FROM (SELECT a.source_ref, count(*) AS n FROM read.parking_bay JOIN read.street_object o USING (street_object_id)
  JOIN read.axis a USING (axis_id) GROUP BY 1) s;
DELETE FROM read.placement_rule;
SELECT 'a rule that was deleted stays away', NOT EXISTS (SELECT FROM streetgen.import_osm('read', 'osm') WHERE what LIKE 'rule %') AND NOT EXISTS (SELECT FROM read.placement_rule);
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('streets', 2154, subjects => '{lane}') \g /dev/null
SELECT 'a model without objects gets no rule', NOT EXISTS (SELECT FROM streetgen.import_osm('streets', 'osm') WHERE what LIKE 'rule %');
SELECT FROM streetgen.switch_subject('town', 'object', false) \g /dev/null
SELECT 'sidewalks have their ground again when objects are switched off', NOT EXISTS (SELECT FROM town.sidewalk WHERE strip IS NOT NULL) AND (SELECT (sidewalk_left, sidewalk_right) = (3, 3) FROM town.edge WHERE axis_id = 1);
