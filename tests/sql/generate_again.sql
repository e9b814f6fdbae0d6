-- generate: idempotent, independent of the way to get there, whole or not at all.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.state(statement text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  RETURN 'none';
EXCEPTION WHEN OTHERS THEN
  RETURN SQLSTATE;
END $$;
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
-- All that is derived, by axis and place, without surrogate keys.
CREATE FUNCTION pg_temp.content(model name) RETURNS TABLE (content text) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE replace($q$
    SELECT concat_ws(' ', 'node', geom::text) FROM @.node
    UNION ALL SELECT concat_ws(' ', 'edge', e.axis_id, e.start_abscissa, e.end_abscissa, e.level, e.width, e.width_end, e.geom::text) FROM @.edge e
    UNION ALL SELECT concat_ws(' ', 'limit', e.axis_id, e.start_abscissa, l.which, l.wanted_abscissa, l.abscissa, l.method, l.border_line::text)
      FROM @.section_limit l JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'section', e.axis_id, e.start_abscissa, s.method, s.contested_area, s.surface::text) FROM @.section s JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'corner', a.axis_id, a.start_abscissa, k.end_a, b.axis_id, b.start_abscissa, k.end_b, k.radius_wanted, k.radius, k.method, k.arc::text)
      FROM @.corner k JOIN @.edge a ON a.edge_id = k.edge_a JOIN @.edge b ON b.edge_id = k.edge_b
    UNION ALL SELECT concat_ws(' ', 'intersection', n.geom::text, i.method, i.contested_area, i.surface::text) FROM @.intersection i JOIN @.node n USING (node_id)$q$,
    '@', quote_ident(model));
END $$;
CREATE FUNCTION pg_temp.same(a name, b name) RETURNS boolean LANGUAGE sql AS $$
  SELECT NOT EXISTS ((SELECT pg_temp.content(a) EXCEPT ALL SELECT pg_temp.content(b))
                     UNION ALL (SELECT pg_temp.content(b) EXCEPT ALL SELECT pg_temp.content(a)))
$$;
-- Place and writer of every row of a model: equal as long as nothing was written.
CREATE FUNCTION pg_temp.rows(model name) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  result text := '';
  part text;
  t text;
BEGIN
  FOREACH t IN ARRAY ARRAY['node', 'edge', 'section_limit', 'section', 'corner', 'intersection', 'report'] LOOP
    EXECUTE format('SELECT md5(string_agg(concat(ctid, xmin), '','' ORDER BY ctid)) FROM %I.%I', model, t) INTO part;
    result := result || t || coalesce(part, '-');
  END LOOP;
  RETURN result;
END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154) FROM unnest(ARRAY['once', 'single', 'halves', 'edited']::name[]) m;
  PERFORM pg_temp.fill(m) FROM unnest(ARRAY['once', 'single', 'halves', 'edited']::name[]) m;
END $$;
CREATE TABLE public.run AS SELECT 1 AS run, * FROM streetgen.generate('once');

SELECT 'a run returns a row for each table' AS name, (SELECT count(*) >= 6 AND count(DISTINCT relation) = count(*) FROM run) AS holds;
SELECT 'a first run inserts', (SELECT bool_and(inserted > 0 AND updated + deleted + unchanged = 0) FROM run WHERE relation <> 'report');
SELECT 'every axis has an edge', NOT EXISTS (SELECT FROM once.axis a WHERE NOT EXISTS (SELECT FROM once.edge e WHERE e.axis_id = a.axis_id));
SELECT 'every edge has a section and two limits',
       (SELECT count(*) FROM once.edge) = (SELECT count(*) FROM once.section) AND 2 * (SELECT count(*) FROM once.edge) = (SELECT count(*) FROM once.section_limit);
SELECT 'nodes of degree three and more have an intersection',
       NOT EXISTS (SELECT FROM (SELECT from_node AS n FROM once.edge UNION ALL SELECT to_node FROM once.edge) e
                   GROUP BY n HAVING count(*) > 2 AND NOT EXISTS (SELECT FROM once.intersection i WHERE i.node_id = n AND NOT ST_IsEmpty(i.surface)));
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

CREATE TABLE public.before AS SELECT pg_temp.rows('once') AS rows;
INSERT INTO run SELECT 2, * FROM streetgen.generate('once');
SELECT 'a second run reports no change', (SELECT bool_and(inserted + updated + deleted = 0) FROM run WHERE run = 2);
SELECT 'a second run writes no row', (SELECT rows FROM before) = pg_temp.rows('once');
INSERT INTO run SELECT 3, * FROM streetgen.generate('once', (SELECT array_agg(axis_id) FROM once.axis));
SELECT 'a run of every axis by name writes no row', (SELECT rows FROM before) = pg_temp.rows('once');
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
SELECT 'axis by axis gives the same model', pg_temp.same('once', 'single');
SELECT 'by halves gives the same model', pg_temp.same('once', 'halves');

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
SELECT 'an edit is seen', NOT pg_temp.same('once', 'edited');
SELECT 'an edit keeps the ids of edges', NOT EXISTS (SELECT FROM old_id o JOIN edited.edge e USING (axis_id, start_abscissa) WHERE e.edge_id <> o.edge_id);
SELECT 'an edit leaves what is far away', NOT EXISTS (SELECT FROM far f JOIN edited.section s USING (edge_id) WHERE s.xmin::text <> f.writer);
DO $$ BEGIN
  UPDATE edited.axis SET width = 6 WHERE axis_id = 4;
  PERFORM streetgen.generate('edited', '{4}');
END $$;
SELECT 'an edit taken back gives the model as it was', pg_temp.same('once', 'edited');
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
SELECT 'an axis put back gives the model as it was', pg_temp.same('once', 'edited');
DO $$ BEGIN
  DELETE FROM edited.section WHERE edge_id = (SELECT min(edge_id) FROM edited.edge);
  UPDATE edited.intersection SET method = 'contested' WHERE node_id = (SELECT min(node_id) FROM edited.intersection);
  PERFORM streetgen.generate('edited');
END $$;
SELECT 'generate repairs rows changed by hand', pg_temp.same('once', 'edited');

-- A violation in mid-run.
CREATE TABLE public.untouched AS SELECT pg_temp.rows('edited') AS rows;
ALTER TABLE edited.intersection ADD CONSTRAINT planted CHECK (method <> method) NOT VALID;
UPDATE edited.axis SET width = width + 1;
SELECT 'a violation in mid-run is an error', pg_temp.state($q$SELECT * FROM streetgen.generate('edited')$q$) = '23514';
SELECT 'a violation in mid-run leaves every table unchanged', (SELECT rows FROM untouched) = pg_temp.rows('edited');

-- Isolation.
BEGIN ISOLATION LEVEL REPEATABLE READ;
SELECT 'an older snapshot is refused', pg_temp.state($q$SELECT * FROM streetgen.generate('once')$q$) = '0A000';
COMMIT;
BEGIN;
SELECT 'a model that is not there is refused', pg_temp.state($q$SELECT * FROM streetgen.generate('no such')$q$) = '3F000';
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
