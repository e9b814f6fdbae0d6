\set ECHO none
\ir shared/truths.sql
-- Exports tell of the input that they leave out.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection}'), streetgen.create_model('whole', 2154, subjects => '{interconnection,sidewalk,signal,object,height}');
  INSERT INTO town.axis (geom, width, level, sidewalk_left) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9, 0, 2), ('SRID=2154;LINESTRING(650100 6860000, 650200 6860000)', 9, 0, NULL),
    ('SRID=2154;LINESTRING(650100 6860000, 650100 6860100)', 9, 0, 0), ('SRID=2154;LINESTRING(650050 6859950, 650050 6860050)', 8, 1, NULL), ('SRID=2154;LINESTRING(651000 6860000, 651100 6860000)', 9, 0, NULL);
  INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 'signals'), ('SRID=2154;POINT(650140 6860000)', 'pedestrian_crossing'), ('SRID=2154;POINT(650160 6860000)', 'pedestrian_crossing'), ('SRID=2154;POINT(651050 6860000)', 'signals');
  INSERT INTO whole.axis SELECT * FROM town.axis;
  INSERT INTO whole.control_point SELECT * FROM town.control_point;
END $$;
-- Contents that a writer warns of, with their count.
CREATE FUNCTION pg_temp.left_out(model name, format text, options jsonb DEFAULT '{}') RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(content || ' ' || number, ', ') FROM streetgen._left_out(model, format, options) $$;
SELECT 'a network for simulators without signals, crossings and sidewalks', pg_temp.left_out('town', 'sumo') = 'pedestrian crossings 2, signals 2, streets with sidewalks ' || (SELECT count(*) FROM town.axis WHERE greatest(sidewalk_left, sidewalk_right) > 0);
SELECT 'files with heights', pg_temp.left_out('town', 'gltf') ~ '^pedestrian crossings 2, streets above or below the ground 1, streets with sidewalks';
SELECT 'what the options leave away is not counted', pg_temp.left_out('town', 'lanelet2', '{"extent": [651000, 6859900, 651100, 6860100]}') = 'signals 1';
SELECT 'a model with these subjects leaves out nothing: ' || f, pg_temp.left_out('whole', f) IS NULL FROM unnest('{sumo,opendrive,lanelet2,cityjson,gltf,tiles,wavefront}'::text[]) f;
INSERT INTO whole.street_object (type, geom) VALUES ('tree', 'SRID=2154;POINT(650020 6860008)'), ('bollard', 'SRID=2154;POINT(650040 6860008)');
SELECT 'what no subject makes a format have is counted: ' || f, pg_temp.left_out('whole', f) IS NOT DISTINCT FROM said FROM (VALUES ('wavefront', 'objects 2'), ('cityjson', 'objects 2'), ('gltf', NULL), ('sumo', NULL)) v(f, said);
