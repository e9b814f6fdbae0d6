\set ECHO none
\ir shared/truths.sql
-- Where a long call fails is said in a few lines: what it was doing, not the statements that it is made of.
SET streetgen.live = 'off';
CREATE FUNCTION pg_temp.context(statement text) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  context text;
BEGIN
  EXECUTE statement;
  RETURN NULL;
EXCEPTION WHEN raise_exception THEN
  GET STACKED DIAGNOSTICS context = PG_EXCEPTION_CONTEXT;
  RETURN context;
END $$;
CREATE FUNCTION public.fail() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RAISE EXCEPTION 'no'; END $$;
SELECT streetgen.create_model('town', 2154), streetgen.create_model('again', 2154), streetgen.create_model('parts', 2154), streetgen.create_model('imported', 2154), streetgen.create_model('checked', 2154) \g /dev/null
CREATE TABLE line AS SELECT 10 * x + y AS id, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 80 * x, 6860000 + 60 * y), ST_MakePoint(650000 + 80 * (x + 1), 6860000 + 60 * y)), 2154) AS geom
  FROM generate_series(1, 4) x, generate_series(1, 4) y;
CREATE FUNCTION public.fail(id integer) RETURNS float8 LANGUAGE plpgsql AS $$ BEGIN RAISE EXCEPTION 'no'; END $$;
CREATE VIEW bad_line AS SELECT id AS way_id, 'primary' AS class, NULL AS name, NULL AS lanes, NULL AS lanes_forward, NULL AS lanes_backward, NULL AS width, NULL AS oneway, NULL AS junction, NULL AS layer,
  NULL AS bridge, NULL AS tunnel, public.fail(id)::text AS maxspeed, public.fail(id) AS largeur, 'route' AS nature, geom FROM line;
INSERT INTO town.axis (geom, width) SELECT geom, 7 FROM line;
INSERT INTO again.axis (geom, width) SELECT geom, 7 FROM line;
INSERT INTO parts.axis (geom, width) SELECT geom, 7 FROM line;
INSERT INTO checked.axis (geom, width) SELECT geom, 7 FROM line;
SELECT streetgen.generate('again'), streetgen.plan_clusters('parts', 2) \g /dev/null
CREATE TRIGGER fail BEFORE INSERT OR UPDATE ON town.section FOR EACH ROW EXECUTE FUNCTION public.fail();
CREATE TRIGGER fail BEFORE INSERT OR UPDATE ON again.section FOR EACH ROW EXECUTE FUNCTION public.fail();
CREATE TRIGGER fail BEFORE INSERT OR UPDATE ON parts.section FOR EACH ROW EXECUTE FUNCTION public.fail();
CREATE TRIGGER fail BEFORE INSERT OR UPDATE ON imported.axis FOR EACH ROW EXECUTE FUNCTION public.fail();
RESET streetgen.live;
ALTER VIEW checked.axis_used RENAME TO all_used;
CREATE VIEW checked.axis_used AS SELECT *, public.fail(axis_id::integer) AS failing FROM checked.all_used;
CREATE TABLE failed AS SELECT name, pg_temp.context(statement) AS context FROM (VALUES
  ('generate', 'SELECT FROM streetgen.generate(''town'')'),
  ('generate of some axes', 'SELECT FROM streetgen.generate(''town'', ARRAY[1, 2])'),
  ('generate_cluster', 'SELECT FROM streetgen.generate_cluster(''parts'')'),
  ('an edit', 'UPDATE again.axis SET width = 9 WHERE axis_id = 1'),
  ('check_model', 'SELECT FROM streetgen.check_model(''checked'')'),
  ('import_axes', 'SELECT FROM streetgen.import_axes(''imported'', ''bad_line'', ''{"source_ref": "way_id"}'')'),
  ('import_axes, writing', 'SELECT FROM streetgen.import_axes(''imported'', ''line'', ''{"source_ref": "id"}'')'),
  ('import_osm', 'SELECT FROM streetgen.import_osm(''imported'', ''bad'')'),
  ('import_bdtopo', 'SELECT FROM streetgen.import_bdtopo(''imported'', ''bad_line'')')) c(name, statement);
SELECT format('%s says where in under 30 lines', name), cardinality(string_to_array(context, E'\n')) < 30 AND context LIKE '%fail%' FROM failed;
