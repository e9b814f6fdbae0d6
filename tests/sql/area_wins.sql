\set ECHO none
\ir shared/truths.sql
-- Areas that win: those of roadway move kerbs, others take ground from what comes before them; live, and told.
-- (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.shape(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154),
  650000, 6860000) $$;
CREATE FUNCTION pg_temp.box(west float8, south float8, east float8, north float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_Multi(ST_MakeEnvelope(650000 + west, 6860000 + south, 650000 + east, 6860000 + north, 2154)) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{kerb,sidewalk,lane,footway}');
  INSERT INTO town.axis (axis_id, geom, width, importance, source, source_ref, sidewalk_left, sidewalk_right) VALUES
    (1, pg_temp.shape('LINESTRING(0 0,100 0)'), NULL, 4, 'roads', '1', 2, 2),
    (2, pg_temp.shape('LINESTRING(100 0,200 0)'), 7, 4, 'roads', '2', 2, 2),
    (3, pg_temp.shape('LINESTRING(100 0,100 100)'), 5, 4, NULL, NULL, 0, 0);
  INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (1, pg_temp.box(-5, -3, 210, 5), 'roadway'),
    (2, pg_temp.box(96, 5, 104, 100), 'roadway');
END $$;
CREATE FUNCTION roadway(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT format('%s %s', round(width::numeric, 3), round(roadway_offset::numeric, 3)) FROM town.axis_used
  WHERE axis_id = axis $$;
-- Kerbs from the south to the north, metres, 50 m along axis 1.
CREATE FUNCTION kerbs() RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(round((ST_Y(ST_Centroid(ST_Intersection(geom, pg_temp.shape('LINESTRING(50 -30,50 30)'))))
  - 6860000)::numeric, 2)::float8::text, ' ' ORDER BY ST_Y(ST_Centroid(ST_Intersection(geom,
  pg_temp.shape('LINESTRING(50 -30,50 30)'))))) FROM town.kerb WHERE ST_Intersects(geom,
  pg_temp.shape('LINESTRING(50 -30,50 30)')) $$;
-- Does an edit leave what generate computes?
CREATE FUNCTION as_generated() RETURNS boolean LANGUAGE sql AS $$
  SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town') $$;
CREATE TABLE plain AS SELECT edge_id, surface FROM town.section;
SELECT 'unless a setting says so no area moves a kerb', bool_and(NOT by_area) AND roadway(1) = '6.000 0.000'
  AND roadway(2) = '7.000 0.000' FROM town.axis_used;
SELECT streetgen.set('town', 'area_wins', ' roadway, square') \g /dev/null
SELECT 'the setting lists kinds', value = 'roadway,square' FROM streetgen.setting('town') WHERE name = 'area_wins';
SELECT 'of areas alone', test.state($$SELECT streetgen.set('town', 'area_wins', 'roadway,garden')$$) = '22023'
  AND test.state($$SELECT streetgen.set('town', 'area_wins', NULL)$$) = '22004';
SELECT 'and is a setting of streets', (SELECT bool_and(e.setting_hash <> u.setting_hash) FROM town.edge e
  JOIN town.axis_used u USING (axis_id));
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT 'estimated and stated kerbs of a source follow the area, on both sides', roadway(1) = '8.000 1.000'
  AND roadway(2) = '8.000 1.000' AND kerbs() = '-3 5';
SELECT 'sections, lanes and sidewalks with them', (SELECT round(ST_YMax(surface)::numeric - 6860000, 2) = 5
  FROM town.section JOIN town.edge USING (edge_id) WHERE axis_id = 1) AND (SELECT round(max(ST_YMax(l.surface))::numeric
  - 6860000, 2) = 5 FROM town.lane l JOIN town.edge USING (edge_id) WHERE axis_id = 1)
  AND (SELECT round(max(ST_YMax(s.surface))::numeric - 6860000, 2) = 7 FROM town.sidewalk s
  JOIN town.edge USING (edge_id) WHERE axis_id = 1);
SELECT 'a width by hand stays', roadway(3) = '5.000 0.000' AND NOT by_area FROM town.axis_used WHERE axis_id = 3;
UPDATE town.street_area SET geom = pg_temp.box(-5, -3, 210, 6) WHERE street_area_id = 1;
SELECT 'an edit of an area is followed', kerbs() = '-3 6' AND as_generated();
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (3, pg_temp.box(-5, -5, 90, -3), 'roadway');
SELECT 'areas that touch are one roadway', kerbs() = '-5 6' AND as_generated();
UPDATE town.street_area SET kind = 'parking_area' WHERE street_area_id = 3;
SELECT 'until one is of another kind', kerbs() = '-3 6' AND as_generated();
UPDATE town.street_area SET level = 1 WHERE street_area_id = 1;
SELECT 'or level', kerbs() = '-3 3' AND NOT EXISTS (SELECT FROM town.axis_used WHERE by_area) AND as_generated();
UPDATE town.street_area SET level = 0 WHERE street_area_id = 1;
UPDATE town.axis SET width = NULL WHERE axis_id = 3;
SELECT 'an axis that is drawn without a width follows, too', roadway(3) = '8.000 0.000' AND as_generated();
INSERT INTO town.kerb_point_editing (geom) VALUES (pg_temp.shape('POINT(50 4)'));
SELECT 'a kerb point by hand holds', roadway(1) = '8.000 0.000' AND as_generated();
DELETE FROM town.kerb_point_editing;
SELECT 'and gone leaves the area again', kerbs() = '-3 6' AND as_generated();
UPDATE town.axis SET geom = pg_temp.shape('LINESTRING(0 1.5,100 0)') WHERE axis_id = 1;
SELECT 'an axis that moves keeps the kerbs', abs(u.width - 9) < 0.01 AND as_generated() FROM town.axis_used u
  WHERE axis_id = 1;
UPDATE town.axis SET geom = pg_temp.shape('LINESTRING(0 0,100 0)') WHERE axis_id = 1;

-- Surfaces end where the area does, bays and narrow places included.
CREATE FUNCTION beside_area() RETURNS float8 LANGUAGE sql AS $$ SELECT round(ST_Area(ST_SymDifference(r.ground,
  a.ground))::numeric, 4)::float8 FROM (SELECT ST_Intersection(ST_Union(surface), pg_temp.box(0, -50, 90, 50)) AS ground
  FROM town.roadway) r, (SELECT ST_Intersection(ST_Union(geom), pg_temp.box(0, -50, 90, 50)) AS ground
  FROM town.street_area WHERE kind = 'roadway') a $$;
CREATE FUNCTION overlap() RETURNS float8 LANGUAGE sql AS $$ SELECT coalesce(sum(ST_Area(ST_Intersection(a.surface,
  b.surface))), 0) FROM town.roadway a JOIN town.roadway b ON a.surface && b.surface
  AND a.surface::bytea < b.surface::bytea $$;
SELECT 'the roadway is the area', beside_area() = 0;
UPDATE town.street_area SET geom = ST_Multi(ST_Union(geom, pg_temp.box(40, 6, 60, 9))) WHERE street_area_id = 1;
SELECT 'with a bay', kerbs() = '-3 9' AND roadway(1) = '9.000 1.500' AND beside_area() = 0 AND as_generated();
UPDATE town.street_area SET geom = ST_Multi(ST_Difference(pg_temp.box(-5, -3, 210, 6), pg_temp.box(40, 4, 60, 9)))
  WHERE street_area_id = 1;
SELECT 'or a narrow place', kerbs() = '-3 4' AND roadway(1) = '9.000 1.500' AND beside_area() = 0 AND as_generated();
UPDATE town.street_area SET geom = ST_Multi(ST_Difference(pg_temp.box(-5, -3, 210, 6), pg_temp.box(40, 2, 60, 4)))
  WHERE street_area_id = 1;
SELECT 'or an island, whose kerb is one', kerbs() = '-3 3 6' AND beside_area() = 0 AND as_generated();
UPDATE town.street_area SET geom = ST_Multi(ST_Union(pg_temp.box(-5, -3, 210, 6), pg_temp.box(40, 6, 60, 40)))
  WHERE street_area_id = 1;
SELECT 'and 6 m of ground that leads away', kerbs() = '-3 12' AND as_generated();
UPDATE town.street_area SET geom = pg_temp.box(-5000, -3, 5210, 6) WHERE street_area_id = 1;
SELECT 'a street takes no more of an area that leads far away', kerbs() = '-3 6' AND beside_area() = 0
  AND as_generated() AND (SELECT bool_and(ST_Within(u.area, ST_Expand(a.geom, 32.01)))
  FROM town.axis_used u JOIN town.axis a USING (axis_id));
UPDATE town.street_area SET geom = pg_temp.box(30, -3, 210, 6) WHERE street_area_id = 1;
SELECT 'where the area ends the street goes on', (SELECT ST_Contains(ST_Buffer(surface, 0.001), pg_temp.box(0, -3, 90,
  6)) AND NOT ST_Intersects(surface, pg_temp.box(0, 6.1, 90, 9)) FROM town.section JOIN town.edge USING (edge_id)
  WHERE axis_id = 1) AND as_generated();
UPDATE town.axis SET width = 4 WHERE axis_id = 3;
SELECT 'a street with a width by hand keeps its ground in the junction', (SELECT bool_and(ST_Contains(r.ground, place))
  FROM (SELECT ST_Buffer(ST_Union(surface), 0.001) AS ground FROM town.roadway) r,
  ST_DumpPoints(pg_temp.shape('MULTIPOINT(98 6,102 6,98 7,102 7,98 12,102 12)')) p(path, place)) AND as_generated();
UPDATE town.axis SET width = NULL WHERE axis_id = 3;
UPDATE town.street_area SET geom = pg_temp.box(-5, -3, 210, 6) WHERE street_area_id = 1;
UPDATE town.street_area SET geom = pg_temp.box(96, 9, 104, 100) WHERE street_area_id = 2;
SELECT 'and one whose area begins behind a walk goes on over it', (SELECT bool_and(ST_Contains(r.ground, place))
  FROM (SELECT ST_Buffer(ST_Union(surface), 0.001) AS ground FROM town.roadway) r,
  ST_DumpPoints(pg_temp.shape('MULTIPOINT(96 6,104 6,96 7,104 7,96 12,104 12)')) p(path, place)) AND as_generated();
UPDATE town.street_area SET geom = pg_temp.box(96, 5, 104, 100) WHERE street_area_id = 2;
SELECT 'nothing overlaps', overlap() = 0 AND (SELECT bool_and(ST_IsValid(surface)) FROM town.roadway);

-- What is amiss is told.
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (4, pg_temp.box(0, 50, 20, 60), 'roadway');
SELECT 'check_model tells stated widths that give way to areas, and areas along no street',
  string_agg(concat_ws(' ', relation, id, rule, round(measure)), '; ' ORDER BY relation, id) =
  'axis 2 stated width that is not that of areas, m 2; street_area 4 area of roadway along no street, m2 200'
  FROM streetgen.check_model('town') WHERE rule ~ 'that of areas|along no street';
SELECT 'summary counts streets', amount = 3 FROM streetgen.summary('town')
  WHERE subject = 'streets with the kerbs of areas';
CREATE TABLE plan AS SELECT street_area_id AS id, geom, kind FROM town.street_area WHERE kind = 'roadway';
DELETE FROM town.street_area;
UPDATE town.axis SET width = 5 WHERE axis_id = 3;
SELECT 'without areas all is as it was', bool_and(ST_Equals(s.surface, p.surface)) AND as_generated()
  FROM town.section s JOIN plain p USING (edge_id);
SELECT 'an import tells how many streets have the kerbs of areas', array_agg(concat_ws(' ', what, class, count)
  ORDER BY what, class) = '{"areas roadway 3","streets with the kerbs of areas 2"}'
  FROM streetgen.import_areas('town', 'plan', '{"kind": "kind", "source_ref": "id"}');
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT 'as generate makes them', kerbs() = '-3 6' AND as_generated();
SELECT streetgen.live('town', false) \g /dev/null
DELETE FROM town.street_area WHERE source_ref = '1';
SELECT 'while edits are not followed, streets wait for generate', (SELECT count(*) > 0 FROM town.edge e
  JOIN town.axis_used u USING (axis_id) WHERE e.input_hash <> u.input_hash);
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT 'which brings them up to date', kerbs() = '-3 3';
SELECT streetgen.live('town', true) \g /dev/null

-- Kinds other than roadway take ground from what comes before them.
DELETE FROM town.street_area;
INSERT INTO town.footway (footway_id, geom, kind, width) VALUES (1, pg_temp.shape('LINESTRING(10 30,60 30)'),
  'cycleway', 2);
INSERT INTO town.street_area (street_area_id, geom, kind) VALUES (21, pg_temp.box(0, -20, 40, 40), 'square'),
  (22, pg_temp.box(30, 20, 60, 50), 'walk');
CREATE FUNCTION ground() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(round(of::numeric)::text, ' ' ORDER BY id)
  FROM (SELECT street_area_id AS id, ST_Area(surface) AS of FROM town.area_surface UNION ALL SELECT 30,
  ST_Area(surface) FROM town.footway_surface) g $$;
SELECT 'a square that wins comes before tracks and walks, but not before streets', ground() = '2000 660 40';
SELECT streetgen.set('town', 'area_wins', '') \g /dev/null
SELECT 'else after them', ground() = '1760 840 100';
SELECT streetgen.set('town', 'area_wins', 'square,walk') \g /dev/null
SELECT 'of two that win the kind that comes first does', ground() = '1800 900';
