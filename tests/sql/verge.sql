\set ECHO none
\ir shared/truths.sql
-- Verges before mapped sidewalks that state their width.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION across(axis bigint, of_side text) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(format('%s %s-%s', kind, round(offset_from::numeric, 2)::float8, round(offset_to::numeric, 2)::float8), ', ' ORDER BY "order") FROM streetgen.cross_section('town', axis, 50) WHERE side = of_side AND offset_from >= 4 AND kind <> 'kerb' AND offset_to IS NOT NULL $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane,footway}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, sidewalk_right) SELECT n, pg_temp.line(format('LINESTRING(0 %1$s,100 %1$s)', 100 * n)), 8, 4, CASE n WHEN 4 THEN 3 END FROM generate_series(1, 4) n;
  INSERT INTO town.footway (footway_id, geom, role, width) VALUES (1, pg_temp.line('LINESTRING(0 108,100 108)'), 'sidewalk', 1.5), (2, pg_temp.line('LINESTRING(0 208,100 208)'), 'sidewalk', NULL), (3, pg_temp.line('LINESTRING(0 305,100 305)'), 'sidewalk', 2), (4, pg_temp.line('LINESTRING(0 392,100 392)'), 'sidewalk', 1.5);
END $$;
SELECT 'a sidewalk beyond its stated width has a verge before it, and keeps the width', across(1, 'left') = 'verge 4.3-7.25, sidewalk 7.25-8.75';
SELECT 'one that states none lies all behind the kerb', across(2, 'left') = 'furnishing 4.3-5.3, sidewalk 5.3-10' AND across(1, 'right') !~ 'verge';
SELECT 'one at the kerb has none', across(3, 'left') !~ 'verge' AND across(3, 'left') ~ 'sidewalk .*-6$';
SELECT 'what the axis says counts from the kerb', across(4, 'right') !~ 'verge' AND across(4, 'right') ~ 'sidewalk .*-7$';
UPDATE town.footway SET geom = ST_Translate(geom, 0, 1) WHERE footway_id = 1;
SELECT 'the verge follows the footway', across(1, 'left') = 'verge 4.3-8.25, sidewalk 8.25-9.75';
UPDATE town.sidewalk_editing SET width = 2 WHERE side = 'left' AND edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 1);
SELECT 'a width by hand counts from the kerb', across(1, 'left') !~ 'verge';
DELETE FROM town.sidewalk_override;
SELECT 'pictures show it', count(*) > 0 FROM streetgen.cross_section_svg('town', 1, 50) s WHERE s ~ 'verge';
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without footways there is none', across(1, 'left') !~ 'verge';
