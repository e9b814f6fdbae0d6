\set ECHO none
\ir shared/truths.sql
-- Cycle tracks that are mapped on the ground of sidewalks take it, and estimated sidewalks go on behind them.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane,footway,object}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, sidewalk_left, sidewalk_right) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 6, 4, NULL, NULL), (2, pg_temp.line('LINESTRING(0 100,100 100)'), 6, 4, 3, NULL),
    (3, pg_temp.line('LINESTRING(0 200,100 200)'), 6, 4, NULL, NULL), (4, pg_temp.line('LINESTRING(0 300,100 300)'), 6, 4, 20, 0);
END $$;
CREATE FUNCTION pg_temp.widths(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT concat_ws(' ', round(sidewalk_left::numeric, 2), round(sidewalk_right::numeric, 2)) FROM town.edge WHERE axis_id = axis $$;
CREATE FUNCTION pg_temp.walked(axis bigint, side text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Union(surface) FROM town.sidewalk w JOIN town.edge USING (edge_id) WHERE axis_id = axis AND w.side = $2 $$;
CREATE FUNCTION pg_temp.there() RETURNS text LANGUAGE sql AS $$ SELECT md5(string_agg(concat_ws(' ', edge_id, side, part, width, ST_AsEWKB(surface), ST_AsEWKB(strip)), ',' ORDER BY edge_id, side, part)) FROM town.sidewalk $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE before text := pg_temp.there(); BEGIN
  PERFORM streetgen.generate('town', wait => true); RETURN before = pg_temp.there() AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error'); END $$;
-- The kerb lies 3 m from the axis: the track from 3.5 to 5.5 m.
INSERT INTO town.footway (footway_id, geom, kind, width) VALUES (1, pg_temp.line('LINESTRING(0 4.5,100 4.5)'), 'cycleway', 2), (2, pg_temp.line('LINESTRING(0 104.5,100 104.5)'), 'cycleway', 2), (3, pg_temp.line('LINESTRING(50 180,50 220)'), 'cycleway', 2);
SELECT 'an estimated sidewalk goes on behind the track', pg_temp.widths(1) = '4.50 2.00';
SELECT 'a stated one keeps its width', pg_temp.widths(2) = '3.00 2.00';
SELECT 'none lies on the track', bool_and(ST_Area(ST_Intersection(w.surface, ST_Buffer(f.geom, 1, 'endcap=flat'))) < 0.2) FROM town.sidewalk w JOIN town.footway f ON ST_DWithin(w.surface, f.geom, 1);
SELECT 'before and behind it the sidewalk stays', abs(ST_Area(ST_Intersection(pg_temp.walked(1, 'left'), pg_temp.line('POLYGON((40 0,60 0,60 10,40 10,40 0))'))) - 20 * 2.5) < 0.2;
SELECT 'the track has its ground', (SELECT abs(ST_Area(surface) - 200) < 0.1 FROM town.footway_surface WHERE footway_id = 1);
SELECT 'one that leads over a street has it up to the kerbs', (SELECT abs(ST_Area(ST_Intersection(surface, pg_temp.line('POLYGON((40 190,60 190,60 210,40 210,40 190))'))) - 2 * (20 - 6)) < 0.1 FROM town.footway_surface WHERE footway_id = 3) AND pg_temp.widths(3) = '2.00 2.00';
SELECT 'a run from scratch makes the same', pg_temp.still();
-- Edits.
UPDATE town.footway SET geom = ST_Translate(geom, 0, 12) WHERE footway_id = 1;
SELECT 'behind the sidewalk it takes nothing', pg_temp.widths(1) = '2.00 2.00' AND NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND strip IS NOT NULL) AND pg_temp.still();
UPDATE town.footway SET geom = pg_temp.line('LINESTRING(0 4.5,100 4.5)'), level = 1 WHERE footway_id = 1;
SELECT 'nor above', pg_temp.widths(1) = '2.00 2.00' AND pg_temp.still();
UPDATE town.footway SET level = 0, width = 3 WHERE footway_id = 1;
SELECT 'its width counts', pg_temp.widths(1) = '5.00 2.00' AND pg_temp.still();
UPDATE town.footway SET geom = ST_Translate(geom, 0, -0.8) WHERE footway_id = 1;
SELECT 'one that reaches into the roadway counts from the kerb', pg_temp.widths(1) = '4.20 2.00' AND pg_temp.still();
UPDATE town.footway SET geom = ST_Translate(geom, 0, 0.8) WHERE footway_id = 1;
UPDATE town.footway SET kind = 'footway' WHERE footway_id = 2;
SELECT 'a walk takes nothing of a sidewalk', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND strip IS NOT NULL) AND pg_temp.still();
INSERT INTO town.footway (footway_id, geom, kind, width) VALUES (4, pg_temp.line('LINESTRING(0 320,100 320)'), 'cycleway', 2);
SELECT 'far behind a kerb too', EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 4 AND strip IS NOT NULL) AND pg_temp.still();
DELETE FROM town.footway WHERE footway_id IN (1, 4);
SELECT 'it gives its ground back', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id IN (1, 4) AND strip IS NOT NULL) AND pg_temp.widths(1) = '2.00 2.00' AND pg_temp.still();
INSERT INTO town.footway (footway_id, geom, kind, width) VALUES (1, pg_temp.line('LINESTRING(0 4.5,100 4.5)'), 'cycleway', 2);
UPDATE town.axis SET geom = ST_Translate(geom, 0, -6) WHERE axis_id = 1;
SELECT 'a street that moves away has its sidewalk', pg_temp.widths(1) = '2.00 2.00' AND pg_temp.still();
INSERT INTO town.axis (axis_id, geom, width, importance) VALUES (5, pg_temp.line('LINESTRING(50 -6,50 60)'), 6, 4);
SELECT 'one that comes there has what is left', EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 5 AND strip IS NOT NULL) AND pg_temp.still();
SELECT FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without footways sidewalks have their ground', NOT EXISTS (SELECT FROM town.sidewalk WHERE strip IS NOT NULL);
