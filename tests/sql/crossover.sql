\set ECHO none
\ir shared/truths.sql
-- Sidewalks that go on where drives come to streets.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{sidewalk,lane}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, radius, importance, kind, sidewalk_left, sidewalk_right) VALUES (1, pg_temp.line('LINESTRING(0 0,40 0)'), 8, 3, 4, 'residential', 2, 3), (2, pg_temp.line('LINESTRING(100 0,40 0)'), 8, 3, 4, 'residential', 3, 2), (3, pg_temp.line('LINESTRING(40 0,40 50)'), 4, 3, 6, 'service', 0, 0),
    (4, pg_temp.line('LINESTRING(70 -40,100 0)'), 5, 3, 5, 'residential', 2, 2), (5, pg_temp.line('LINESTRING(100 0,160 0)'), 8, 3, 4, 'residential', 0, 3), (6, pg_temp.line('LINESTRING(160 0,220 0)'), 8, 3, 4, 'residential', 2, 3), (7, pg_temp.line('LINESTRING(160 0,160 40)'), 4, 3, 6, 'service', 0, 0),
    (8, pg_temp.line('LINESTRING(40 30,80 30)'), 4, 3, 6, 'service', 0, 0), (9, pg_temp.line('LINESTRING(190 -50,220 0)'), 4, 3, 6, 'service', 0, 0), (10, pg_temp.line('LINESTRING(220 0,280 0)'), 8, 3, 4, 'residential', 2, 3);
END $$;
SELECT 'a drive at a street with sidewalks on both sides of its mouth', array_agg(axis_id ORDER BY axis_id) = '{3,9}' FROM town.crossover JOIN town.edge USING (edge_id);
-- The mouth is 4 m wide where the arcs end, 3 m behind the kerb, and 10 m at the kerb.
SELECT 'its kerb goes on along that of the street, lowered', kerb = 'lowered' AND ST_HausdorffDistance(kerb_line, pg_temp.line('LINESTRING(35 4,45 4)')) < 1e-6 AND c.width = 2 FROM town.crossover c JOIN town.edge USING (edge_id) WHERE axis_id = 3;
SELECT 'its ground is as deep as the sidewalk', abs(ST_YMin(c.surface) - 6860004) < 1e-6 AND abs(ST_YMax(c.surface) - 6860006) < 1e-6 AND ST_Area(c.surface) BETWEEN 9 AND 16 FROM town.crossover c JOIN town.edge USING (edge_id) WHERE axis_id = 3;
SELECT 'and touches the sidewalks beside it', count(DISTINCT w.sidewalk_id) >= 2 FROM town.crossover c JOIN town.edge e USING (edge_id) JOIN town.sidewalk w ON ST_DWithin(w.surface, c.surface, 0.31) WHERE e.axis_id = 3;
SELECT 'it lies on roadway, and not on the street', abs(ST_Area(ST_Intersection(c.surface, r.surface)) - ST_Area(c.surface)) < 1e-6 FROM town.crossover c JOIN town.edge e USING (edge_id), LATERAL (SELECT ST_Union(surface) AS surface FROM (SELECT surface FROM town.section UNION ALL SELECT surface FROM town.intersection) s) r WHERE e.axis_id = 3;
SELECT 'askew too', ST_IsValid(c.surface) AND ST_Area(c.surface) BETWEEN 10 AND 50 AND c.width = 3 FROM town.crossover c JOIN town.edge USING (edge_id) WHERE axis_id = 9;
UPDATE town.axis SET kind = 'residential' WHERE axis_id = 3;
SELECT 'a street is no drive', NOT EXISTS (SELECT FROM town.crossover JOIN town.edge USING (edge_id) WHERE axis_id = 3);
UPDATE town.axis SET kind = 'service' WHERE axis_id = 3;
UPDATE town.axis SET sidewalk_left = 0 WHERE axis_id = 1;
SELECT 'no sidewalk goes on where none is', NOT EXISTS (SELECT FROM town.crossover JOIN town.edge USING (edge_id) WHERE axis_id = 3);
UPDATE town.axis SET sidewalk_left = 4 WHERE axis_id = 1;
SELECT 'from one width to the other', c.width = 2 AND abs(ST_YMax(c.surface) - 6860008) < 2 FROM town.crossover c JOIN town.edge USING (edge_id) WHERE axis_id = 3;
INSERT INTO town.axis (axis_id, geom, width, radius, importance, kind, sidewalk_left, sidewalk_right) VALUES (11, pg_temp.line('LINESTRING(40 0,40 -50)'), 4, 3, 6, 'service', 0, 0);
SELECT 'two drives across from each other have one each', count(*) = 2 FROM town.crossover JOIN town.edge USING (edge_id) WHERE axis_id IN (3, 11);
UPDATE town.axis SET kind = 'residential' WHERE axis_id = 11;
SELECT 'a junction of streets has none', NOT EXISTS (SELECT FROM town.crossover JOIN town.edge USING (edge_id) WHERE axis_id IN (3, 11));
DELETE FROM town.axis WHERE axis_id = 11;
SELECT 'pictures and files have them', (SELECT count(*) = 2 FROM streetgen._sidewalk_drawn('town', ST_Expand(pg_temp.line('LINESTRING(0 0,300 0)'), 50), '{crossover}')) AND EXISTS (SELECT FROM streetgen._sidewalk_layer() WHERE layer = 'crossovers');
SELECT streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT streetgen.switch_subject('town', 'sidewalk', false) \g /dev/null
SELECT 'without sidewalks there are none', to_regclass('town.crossover') IS NULL;
