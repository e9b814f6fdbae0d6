\set ECHO none
\ir shared/truths.sql
-- Levels that pass over and meet, crossings passed over and split.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('levels', 32631) \g /dev/null
INSERT INTO levels.axis (geom, width, level) VALUES ('SRID=32631;LINESTRING(0 0,100 0)', 7, 0), ('SRID=32631;LINESTRING(50 -50,50 0,50 50)', 7, 1), ('SRID=32631;LINESTRING(50 50,50 100)', 7, 0), ('SRID=32631;LINESTRING(20 -40,20 40)', 7, 0);
DO $$ BEGIN PERFORM streetgen.generate('levels'); END $$;
SELECT 'a bridge passes over: no node', NOT EXISTS (SELECT FROM levels.node WHERE ST_DWithin(geom, 'SRID=32631;POINT(50 0)', 1));
SELECT 'levels meet at a shared end', EXISTS (SELECT FROM levels.node WHERE ST_DWithin(geom, 'SRID=32631;POINT(50 50)', 0.01));
SELECT 'a crossing without a vertex is a notice', count(*) = 1 FROM streetgen.check_model('levels') WHERE severity = 'notice' AND rule = 'crossing';
SELECT streetgen.set('levels', 'crossing', 'split') \g /dev/null
SELECT count(*) FROM streetgen.generate('levels') \g /dev/null
SELECT 'with split it becomes a node', EXISTS (SELECT FROM levels.intersection i JOIN levels.node n USING (node_id) WHERE ST_DWithin(n.geom, 'SRID=32631;POINT(20 0)', 0.01));

-- Two streets of one level that cross without a vertex.
DO $$ BEGIN
  PERFORM streetgen.create_model('crossing', 32631);
  INSERT INTO crossing.axis (geom, width) VALUES ('SRID=32631;LINESTRING(650000 6860000,650100 6860000)', 7), ('SRID=32631;LINESTRING(650050 6859950,650050 6860050)', 7);
  PERFORM streetgen.generate('crossing');
END $$;
SELECT 'a crossing without a vertex is a notice', (SELECT count(*) = 1 FROM streetgen.check_model('crossing') WHERE severity = 'notice' AND rule = 'crossing');
SELECT 'over: it makes no node', (SELECT count(*) = 4 FROM crossing.node);
SELECT 'over: it breaks nothing', NOT EXISTS (SELECT FROM streetgen.check_model('crossing') WHERE severity = 'error');
DO $$ BEGIN PERFORM streetgen.set('crossing', 'crossing', 'split'); PERFORM streetgen.generate('crossing'); END $$;
SELECT 'split: it makes a node', (SELECT count(*) = 5 FROM crossing.node) AND (SELECT count(*) = 4 FROM crossing.corner);
SELECT 'and nothing is told of it any more', NOT EXISTS (SELECT FROM crossing.report) AND NOT EXISTS (SELECT FROM streetgen.check_model('crossing') WHERE rule = 'crossing');
