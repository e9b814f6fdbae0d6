\set ECHO none
\ir shared/truths.sql
-- The view roadway: the polygons of the roads, each once, named, tiled; axes lie on them.  (name, holds)
SELECT streetgen.create_model('town', 32631) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, width_end, importance, name, kind) VALUES
  (1, 'SRID=32631;LINESTRING(0 0,100 0)', 12, 8, 2, 'high street', 'primary'), (2, 'SRID=32631;LINESTRING(100 0,200 0)', 8, NULL, 2, 'high street', 'primary'),
  (3, 'SRID=32631;LINESTRING(100 0,100 80)', 6, NULL, 4, 'mill lane', 'residential'), (4, 'SRID=32631;LINESTRING(200 0,200 5,203 8)', 7, NULL, 4, NULL, NULL),
  (5, 'SRID=32631;LINESTRING(203 8,280 8)', 7, NULL, 4, 'quay', NULL), (6, 'SRID=32631;LINESTRING(203 8,203 90)', 7, NULL, 4, 'quay', NULL);
INSERT INTO town.axis (axis_id, geom, width, level) VALUES (7, 'SRID=32631;LINESTRING(50 -60,50 60)', 8, 1);
SELECT streetgen.generate('town') \g /dev/null
SELECT 'every surface is a row' AS name, count(*) = (SELECT count(*) FROM (SELECT surface FROM town.section UNION ALL SELECT surface FROM town.intersection) s WHERE NOT ST_IsEmpty(surface))
       AND sum(ST_Area(surface)) = (SELECT sum(ST_Area(surface)) FROM (SELECT surface FROM town.section UNION ALL SELECT surface FROM town.intersection) s) AS holds FROM town.roadway;
SELECT 'of a unique id', count(*) = count(DISTINCT roadway_id) AND bool_and(roadway_id IS NOT NULL) FROM town.roadway;
SELECT 'by which its edge or node is found', bool_and(CASE part WHEN 'section' THEN roadway_id = 2 * edge_id AND node_id IS NULL ELSE roadway_id = 2 * node_id + 1 AND edge_id IS NULL END) FROM town.roadway;
SELECT 'a section has the values of its edge', (name, kind, importance, level, width) = ('mill lane', 'residential', 4, 0, 6) FROM town.roadway WHERE part = 'section' AND axis_id = 3;
SELECT 'an intersection those of its most important edge there', (axis_id, name, kind, importance, level, width) = (1, 'high street', 'primary', 2, 0, 8)
       FROM town.roadway WHERE part = 'intersection' AND node_id = (SELECT node_id FROM town.node WHERE ST_DWithin(geom, 'SRID=32631;POINT(100 0)', 0.01));
SELECT 'of equals the smallest axis names it', (axis_id, name) IS NOT DISTINCT FROM (4::bigint, NULL::text)
       FROM town.roadway WHERE part = 'intersection' AND node_id = (SELECT node_id FROM town.node WHERE ST_DWithin(geom, 'SRID=32631;POINT(203 8)', 0.01));
SELECT 'a bridge has its level', level = 1 FROM town.roadway WHERE axis_id = 7;
SELECT 'clients see polygons in the SRID of the model', (type, srid, coord_dimension) = ('MULTIPOLYGON', 32631, 2) FROM geometry_columns WHERE (f_table_schema, f_table_name) = ('town', 'roadway');
SELECT 'a border 1e-6 m wide is all that two of one level share', coalesce(max(ST_Area(ST_Intersection(a.surface, b.surface)) - 1e-6 * least(ST_Perimeter(a.surface), ST_Perimeter(b.surface))), 0) <= 0
       FROM town.roadway a JOIN town.roadway b ON a.surface && b.surface AND a.level = b.level AND a.roadway_id < b.roadway_id;
SELECT 'there are edges without a section', count(*) > 0 FROM town.section WHERE ST_IsEmpty(surface);
SELECT 'their ground is that of intersections', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';

-- An edge off the roadway is an error: beside its own section, in a hole, at the end; under a bridge too.
CREATE FUNCTION pg_temp.off(change text, OUT length float8) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE change;
  SELECT sum(measure) INTO length FROM streetgen.check_model('town') WHERE (severity, rule) = ('error', 'edge outside the roadway, m');
  RAISE EXCEPTION USING ERRCODE = 'ZZZZZ';
EXCEPTION WHEN SQLSTATE 'ZZZZZ' THEN
END $$;
SELECT 'a section moved away', abs(length - ST_Length(ST_Intersection(geom, surface))) < 1e-6 FROM town.edge JOIN town.section USING (edge_id),
       pg_temp.off($$UPDATE town.section SET surface = ST_Translate(surface, 20, 0) WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 3)$$) WHERE axis_id = 3;
SELECT 'a hole of 2 mm on the axis', abs(length - 0.002) < 1e-6
       FROM pg_temp.off($$UPDATE town.section SET surface = ST_Multi(ST_Difference(surface, ST_Expand('SRID=32631;POINT(100 50)'::geometry, 0.001))) WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 3)$$);
SELECT 'an end 1 mm short', abs(length - 0.001) < 1e-6
       FROM pg_temp.off($$UPDATE town.section SET surface = ST_Multi(ST_Difference(surface, ST_MakeEnvelope(90, 79.999, 110, 81, 32631))) WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 3)$$);
SELECT 'a hole over another road', abs(length - 2) < 1e-6
       FROM pg_temp.off($$UPDATE town.section SET surface = ST_Multi(ST_Difference(surface, ST_Expand('SRID=32631;POINT(50 0)'::geometry, 1))) WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 7)$$);
SELECT 'a border that runs along the axis is none', length IS NULL
       FROM pg_temp.off($$UPDATE town.section SET surface = ST_Multi(ST_Difference(surface, ST_MakeEnvelope(100, 40, 110, 50, 32631))) WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 3)$$);
