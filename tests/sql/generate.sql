\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- generate: idempotent, independent of the way to get there, whole or not at all.  (name, holds)
-- A quarter with a bend, a T, dead ends, a crossing of levels, a loop, a width change and an acute pair.
CREATE FUNCTION pg_temp.fill(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, importance, level)
    SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), width, importance, level FROM (VALUES
      (1, 'LINESTRING(0 0,100 0)', 7, 4, 0), (2, 'LINESTRING(100 0,200 10)', 7, 4, 0), (3, 'LINESTRING(100 0,100 100)', 5, 5, 0),
      (4, 'LINESTRING(100 100,0 100)', 6, 5, 0), (5, 'LINESTRING(0 100,0 0)', 12, 2, 0), (6, 'LINESTRING(100 100,200 110)', 6, 5, 0),
      (7, 'LINESTRING(200 10,200 110)', 4, 6, 0), (8, 'LINESTRING(50 -60,50 160)', 8, 1, 1),
      (9, 'LINESTRING(200 110,260 110,260 170,200 170,200 110)', 5, 5, 0), (10, 'LINESTRING(200 10,300 12)', 7, 4, 0),
      (11, 'LINESTRING(200 10,290 40)', 4, 6, 0), (12, 'LINESTRING(300 12,380 12)', 12, 4, 0),
      (13, 'LINESTRING(380 12,480 12)', NULL, NULL, 0), (14, 'LINESTRING(430 12.2,430 90)', 5, 5, 0)) v(id, line, width, importance, level)$q$, model);
END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154), streetgen.live(m, m = 'edited') FROM unnest(ARRAY['once', 'single', 'halves', 'edited']::name[]) m;
  PERFORM pg_temp.fill(m) FROM unnest(ARRAY['once', 'single', 'halves', 'edited']::name[]) m;
END $$;
CREATE TABLE public.run AS SELECT 1 AS run, * FROM streetgen.generate('once');

SELECT 'a run returns a row for each table' AS name, (SELECT count(*) >= 6 AND count(DISTINCT relation) = count(*) FROM run) AS holds;
SELECT 'a first run inserts', (SELECT bool_and(inserted > 0 AND updated + deleted + unchanged = 0) FROM run WHERE relation <> 'report' AND relation = ANY (SELECT unnest(tables) FROM streetgen.subject('once') WHERE subject IN ('network', 'surface', 'lane', 'interconnection')));
SELECT 'every axis has an edge', NOT EXISTS (SELECT FROM once.axis a WHERE NOT EXISTS (SELECT FROM once.edge e WHERE e.axis_id = a.axis_id));
SELECT 'every edge has a section and two limits',
       (SELECT count(*) FROM once.edge) = (SELECT count(*) FROM once.section) AND 2 * (SELECT count(*) FROM once.edge) = (SELECT count(*) FROM once.section_limit);
SELECT 'nodes of degree three and more have an intersection',
       NOT EXISTS (SELECT FROM (SELECT from_node AS n FROM once.edge UNION ALL SELECT to_node FROM once.edge) e
                   GROUP BY n HAVING count(*) > 2 AND NOT EXISTS (SELECT FROM once.intersection i WHERE i.node_id = n AND NOT ST_IsEmpty(i.surface)));
SELECT 'the ends of a border line are vertices, to the last bit, of the surfaces on either side',
       count(*) > 40 AND bool_and(ST_AsEWKB(border.geom) = ANY (vertices))
FROM once.section_limit JOIN once.edge USING (edge_id), ST_DumpPoints(border_line) border, LATERAL (
    SELECT surface FROM once.section s WHERE s.edge_id = edge.edge_id AND contested_area = 0
    UNION ALL SELECT surface FROM once.intersection WHERE node_id = CASE which WHEN 'start' THEN from_node ELSE to_node END AND contested_area = 0) beside,
    LATERAL (SELECT array_agg(ST_AsEWKB(v.geom)) AS vertices FROM ST_DumpPoints(surface) v) of_surface
WHERE NOT ST_IsEmpty(surface);
SELECT 'edges are numbered by axis and abscissa',
       (SELECT array_agg(edge_id ORDER BY axis_id, start_abscissa) = array_agg(edge_id ORDER BY edge_id) FROM once.edge);
SELECT 'nodes are numbered by their first axis',
       (SELECT array_agg(node_id ORDER BY axis_id, abscissa) = array_agg(node_id ORDER BY node_id)
        FROM (SELECT DISTINCT ON (node_id) node_id, axis_id, abscissa
              FROM (SELECT from_node AS node_id, axis_id, start_abscissa AS abscissa FROM once.edge
                    UNION ALL SELECT to_node, axis_id, end_abscissa FROM once.edge) e ORDER BY node_id, axis_id, abscissa) f);
SELECT 'a level above makes no node', NOT EXISTS (SELECT FROM once.node WHERE ST_DWithin(geom, ST_SetSRID(ST_MakePoint(650050, 6860000), 2154), 1));
SELECT 'an end in the middle of another axis makes a node there', (SELECT count(*) = 2 FROM once.edge WHERE axis_id = 13);
SELECT 'what was estimated is said', (SELECT bool_and('width' = ANY (estimated)) FROM once.edge WHERE axis_id = 13);
SELECT 'what was given is not', (SELECT bool_and('width' <> ALL (estimated)) FROM once.edge WHERE axis_id = 1);

-- Every row with whom it was written and locked by.
CREATE FUNCTION pg_temp.marks(model name) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  marks text;
BEGIN
  EXECUTE (SELECT 'SELECT md5(string_agg(mark, '','' ORDER BY mark)) FROM (' || string_agg(format('SELECT concat_ws('' '', %1$L, ctid, xmin, xmax) FROM %2$I.%1$I', relation, model), ' UNION ALL ') || ') m(mark)'
    FROM unnest(streetgen._computed_tables(model)) relation) INTO marks;
  RETURN marks;
END $$;
CREATE TABLE public.before AS SELECT test.rows('once') AS rows, pg_temp.marks('once') AS marks;
INSERT INTO run SELECT 2, * FROM streetgen.generate('once');
SELECT 'a second run reports no change', (SELECT bool_and(inserted + updated + deleted = 0) FROM run WHERE run = 2);
SELECT 'a second run writes no row', (SELECT rows FROM before) = test.rows('once');
SELECT 'nor does it lock one', (SELECT marks FROM before) = pg_temp.marks('once');
INSERT INTO run SELECT 3, * FROM streetgen.generate('once', (SELECT array_agg(axis_id) FROM once.axis));
SELECT 'a run of every axis by name writes no row', (SELECT rows FROM before) = test.rows('once');
INSERT INTO run SELECT 4, * FROM streetgen.generate('once', '{}');
SELECT 'a run of no axis does nothing', (SELECT bool_and(inserted + updated + deleted + unchanged = 0) FROM run WHERE run = 4);
INSERT INTO run SELECT 5, * FROM streetgen.generate('once', '{999999}');
SELECT 'an unknown axis is skipped', (SELECT bool_and(inserted + updated + deleted = 0) AND sum(skipped) = 1 FROM run WHERE run = 5);

DO $$
DECLARE i bigint;
BEGIN
  FOR i IN 1..14 LOOP PERFORM streetgen.generate('single', ARRAY[i]); END LOOP;
  PERFORM streetgen.generate('halves', ARRAY[2, 4, 6, 8, 10, 12, 14]::bigint[]);
  PERFORM streetgen.generate('halves', ARRAY[13, 11, 9, 7, 5, 3, 1]::bigint[]);
END $$;
SELECT 'axis by axis gives the same model', test.same('once', 'single');
SELECT 'by halves gives the same model', test.same('once', 'halves');

-- Edits, back and forth.
DO $$ BEGIN
  PERFORM streetgen.generate('edited');
END $$;
CREATE TABLE public.old_id AS SELECT axis_id, start_abscissa, edge_id FROM edited.edge;
CREATE TABLE public.far AS SELECT edge_id, xmin::text AS writer FROM edited.section WHERE edge_id IN (SELECT edge_id FROM edited.edge WHERE axis_id IN (13, 14));
DO $$ BEGIN
  UPDATE edited.axis SET width = 9 WHERE axis_id = 4;
  PERFORM streetgen.generate('edited', '{4}');
END $$;
SELECT 'an edit is seen', NOT test.same('once', 'edited');
SELECT 'an edit keeps the ids of edges', NOT EXISTS (SELECT FROM old_id o JOIN edited.edge e USING (axis_id, start_abscissa) WHERE e.edge_id <> o.edge_id);
SELECT 'an edit leaves what is far away', NOT EXISTS (SELECT FROM far f JOIN edited.section s USING (edge_id) WHERE s.xmin::text <> f.writer);
DO $$ BEGIN
  UPDATE edited.axis SET width = 6 WHERE axis_id = 4;
  PERFORM streetgen.generate('edited', '{4}');
END $$;
SELECT 'an edit taken back gives the model as it was', test.same('once', 'edited');
CREATE TABLE public.kept AS SELECT * FROM edited.axis WHERE axis_id = 3;
DO $$ BEGIN
  DELETE FROM edited.axis WHERE axis_id = 3;
  PERFORM streetgen.generate('edited', '{3}');
END $$;
SELECT 'the leftovers of a deleted axis go', NOT EXISTS (SELECT FROM edited.edge WHERE axis_id = 3);
SELECT 'a deleted axis leaves the same model as one that never was', (SELECT count(*) FROM streetgen.generate('edited') WHERE inserted + updated + deleted > 0) = 0;
DO $$ BEGIN
  INSERT INTO edited.axis SELECT * FROM kept;
  PERFORM streetgen.generate('edited', '{3}');
END $$;
SELECT 'an axis put back gives the model as it was', test.same('once', 'edited');
DO $$ BEGIN
  DELETE FROM edited.section WHERE edge_id = (SELECT min(edge_id) FROM edited.edge);
  UPDATE edited.intersection SET method = 'contested' WHERE node_id = (SELECT min(node_id) FROM edited.intersection);
  PERFORM streetgen.generate('edited');
END $$;
SELECT 'generate repairs rows changed by hand', test.same('once', 'edited');

-- A violation in mid-run.
CREATE TABLE public.untouched AS SELECT test.rows('edited') AS rows;
ALTER TABLE edited.intersection ADD CONSTRAINT planted CHECK (method <> method) NOT VALID;
SELECT 'a violation in mid-edit is an error', test.state($q$UPDATE edited.axis SET width = width + 1$q$) = '23514';
DO $$ BEGIN PERFORM streetgen.live('edited', false); END $$;
UPDATE edited.axis SET width = width + 1;
SELECT 'a violation in mid-run is an error', test.state($q$SELECT * FROM streetgen.generate('edited')$q$) = '23514';
SELECT 'a violation in mid-run leaves every table unchanged', (SELECT rows FROM untouched) = test.rows('edited');

-- Isolation.
BEGIN ISOLATION LEVEL REPEATABLE READ;
SELECT 'an older snapshot is refused', test.state($q$SELECT * FROM streetgen.generate('once')$q$) = '0A000';
COMMIT;
BEGIN;
SELECT 'a model that is not there is refused', test.state($q$SELECT * FROM streetgen.generate('no such')$q$) = '3F000';
COMMIT;

-- Heights.
DO $$ BEGIN
  PERFORM streetgen.create_model('high', 2154, 3);
  INSERT INTO high.axis (geom, width) VALUES
    ('SRID=2154;LINESTRING Z(650000 6860000 10,650100 6860000 20)', 7), ('SRID=2154;LINESTRING Z(650100 6860000 20,650200 6860000 40)', 7),
    ('SRID=2154;LINESTRING Z(650100 6860000 20,650100 6860100 30)', 7);
  PERFORM streetgen.generate('high');
END $$;
SELECT 'nodes have the height of their axes', (SELECT array_agg(ST_Z(geom)::integer ORDER BY ST_Z(geom)) = '{10,20,30,40}' FROM high.node);
SELECT 'edges have the height of their axis', (SELECT count(*) = 3 FROM high.edge e JOIN high.axis a USING (axis_id) WHERE ST_3DLength(a.geom) BETWEEN ST_3DLength(e.geom) - 1e-6 AND ST_3DLength(e.geom) + 1e-6);
SELECT 'a second run in three dimensions writes nothing', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('high'));

-- Estimates by settings.
DO $$ BEGIN
  PERFORM streetgen.create_model('airport', 2154);
  INSERT INTO airport.axis (geom, kind) VALUES ('SRID=2154;LINESTRING(650000 6860000,651000 6860000)', 'runway'),
    ('SRID=2154;LINESTRING(650500 6860000,650500 6860300)', 'taxiway');
  PERFORM streetgen.generate('airport');
END $$;
SELECT 'a runway is 40 m wide by settings alone', (SELECT bool_and(width = 40) FROM airport.edge WHERE axis_id = 1);
SELECT 'a taxiway is 20 m wide by settings alone', (SELECT bool_and(width = 20) FROM airport.edge WHERE axis_id = 2);
SELECT 'all surfaces are valid', (SELECT bool_and(ST_IsValid(surface)) FROM (SELECT surface FROM once.section UNION ALL SELECT surface FROM once.intersection
       UNION ALL SELECT surface FROM airport.section UNION ALL SELECT surface FROM airport.intersection) s);

-- A jittered grid of streets with side streets: seeded, of awkward angles, widths and lengths.
CREATE FUNCTION pg_temp.town(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, 2154), streetgen.live(model, false);
    PERFORM setseed(0.42);
    CREATE TEMPORARY TABLE IF NOT EXISTS place AS
        SELECT x, y, 650000 + 60 * x + 14 * random() AS px, 6860000 + 60 * y + 14 * random() AS py, random() AS dice FROM generate_series(0, 7) x, generate_series(0, 7) y ORDER BY x, y;
    EXECUTE format($q$INSERT INTO %I.axis (geom, width, importance, source, source_ref)
        SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(a.px, a.py), ST_MakePoint(b.px, b.py)), 2154), 4 + round((12 * a.dice)::numeric, 1), 1 + (a.dice * 5)::integer, 'town', a.x || ',' || a.y || ',' || b.x
        FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1)) ORDER BY a.x, a.y, b.x, b.y$q$, model);
    EXECUTE format($q$UPDATE %I.axis SET kind_forward = 'general|bus|cycle', turn_forward = 'left|right', direction = CASE axis_id %% 2 WHEN 0 THEN 'direct' ELSE 'both' END WHERE axis_id %% 5 = 0$q$, model);
    EXECUTE format($q$INSERT INTO %I.lane_override (axis_id, abscissa, ordinality, along_axis, width) SELECT axis_id, ST_Length(geom) / 2, 1, axis_id %% 2 = 0, 2.5 FROM %1$I.axis WHERE axis_id %% 7 = 0$q$, model);
END $$;
DO $$ BEGIN
  PERFORM pg_temp.town(m) FROM unnest(ARRAY['town', 'town_single', 'town_halves', 'town_edited']::name[]) m;
  PERFORM streetgen.generate(m) FROM unnest(ARRAY['town', 'town_edited']::name[]) m;
  PERFORM streetgen.generate('town_single', ARRAY[axis_id]) FROM (SELECT axis_id FROM town_single.axis ORDER BY md5(axis_id::text)) a;
  PERFORM streetgen.generate('town_halves', array_agg(axis_id)) FROM town_halves.axis GROUP BY axis_id % 2;
END $$;
SELECT 'a town has lanes of each kind and lanes made by hand', count(DISTINCT kind) = 3 AND count(*) FILTER (WHERE method = 'by_hand') > 10 FROM town.lane;
SELECT 'a town has no error', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';
SELECT 'a town axis by axis in any order gives the same model', test.same('town', 'town_single');
SELECT 'a town by halves gives the same model', test.same('town', 'town_halves');
CREATE TABLE public.town_row AS SELECT test.rows('town') AS rows;
SELECT 'a second run over a town reports no change', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
SELECT 'a second run over a town writes no row', (SELECT rows FROM town_row) = test.rows('town');
UPDATE town_edited.axis SET width = 20 WHERE axis_id = 1;
-- Two of the 64 nodes have the ends of one axis.
SELECT 'an edit in a town updates less than a tenth of a table', max(updated) > 0 AND bool_and(updated < count / 10.0) FROM (SELECT 'lane' AS relation, count(*) FROM town_edited.lane UNION ALL SELECT 'edge', count(*) FROM town_edited.edge
  UNION ALL SELECT 'interconnection', count(*) FROM town_edited.interconnection) t JOIN streetgen.generate('town_edited', '{1}') USING (relation);
SELECT 'an edit by its axis equals a run over all', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town_edited');
UPDATE town_edited.axis SET width = (SELECT width FROM town.axis t WHERE t.axis_id = 1) WHERE axis_id = 1;
SELECT 'taking the edit back updates', bool_or(updated > 0) FROM streetgen.generate('town_edited', '{1}');
SELECT 'and gives the town as it was', test.same('town', 'town_edited');
DELETE FROM town_edited.axis WHERE axis_id = 5;
SELECT 'the results of a deleted axis go with it', NOT EXISTS (SELECT FROM town_edited.edge WHERE axis_id = 5);
SELECT 'a run over all goes on after a deleted axis', bool_or(updated > 0) FROM streetgen.generate('town_edited');
SELECT 'and the town is sound', count(*) = 0 FROM streetgen.check_model('town_edited') WHERE severity = 'error';
