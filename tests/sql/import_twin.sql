\set ECHO none
\ir shared/truths.sql
-- Rows of a source that share a source_ref.  Each SELECT is one truth: (name, holds).
DO $$ BEGIN PERFORM streetgen.create_model('town', 32631); END $$;
CREATE TABLE segment (road text, name text, width float8, geom geometry);
CREATE FUNCTION street(n integer, metres float8 DEFAULT 100) RETURNS geometry LANGUAGE sql AS
  $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(500000 + 100 * n, 5400000), ST_MakePoint(500000 + 100 * n + metres, 5400000)), 32631) $$;
CREATE FUNCTION import_segments() RETURNS TABLE(what text, class text, count bigint, source_refs text[]) LANGUAGE sql AS
  $$ SELECT * FROM streetgen.import_axes('town', 'segment', '{"source_ref": "road", "name": "name", "width": "width"}') $$;
CREATE FUNCTION named(report text) RETURNS text[] LANGUAGE sql AS $$ SELECT source_refs FROM import_segments() WHERE what LIKE report $$;
-- Where axes lie, in streets from the first.
CREATE FUNCTION lying() RETURNS text LANGUAGE sql AS
  $$ SELECT string_agg(concat_ws(' ', source_ref, 'at', (ST_XMin(geom) - 500000) / 100, name), ', ' ORDER BY source_ref) FROM town.axis $$;
INSERT INTO segment VALUES ('D7', NULL, 6, street(0)), ('D7', NULL, 6, street(1)), ('D8', NULL, 6, street(2)), ('D7', NULL, 6, street(3)), ('D8', NULL, 7, street(2)),
  ('D9', NULL, 6, ST_Collect(street(5), street(7))), ('D9', NULL, 6, ST_Collect(street(9), street(11)));
CREATE TABLE report AS SELECT * FROM import_segments();
SELECT 'rows that share a source_ref are told apart, and all are loaded' AS name, lying() = 'D7 at 0, D7#2 at 1, D7#3 at 3, D8 at 2, D9/1 at 5, D9/1#2 at 9, D9/2 at 7, D9/2#2 at 11' AS holds;
SELECT 'they are named', source_refs = '{D7#2,D7#3,D9/1#2,D9/2#2}' AND count = 4 FROM report WHERE what = 'row with a source_ref of several, told apart by a number';
SELECT 'one that shares the line too is left out, and named', source_refs = '{D8}' AND count = 1 FROM report WHERE what = 'row with the source_ref and the line of another, left out';
SELECT 'which is not the first', width = 6 FROM town.axis WHERE source_ref = 'D8';
CREATE TABLE was AS SELECT axis_id, source_ref, geom FROM town.axis;
SELECT 'the same again changes nothing', count = 0 FROM import_segments() WHERE what = 'new or changed';
-- What is by hand stays with its line, whatever the order of the rows.
UPDATE town.axis SET name = 'by hand' WHERE source_ref = 'D7#2';
CREATE TABLE turned AS SELECT * FROM segment ORDER BY ST_XMin(geom) DESC;
TRUNCATE segment;
INSERT INTO segment SELECT road, NULL, CASE WHEN road = 'D8' THEN 6 ELSE width END, geom FROM turned;
SELECT 'in another order the same rows change nothing', count = 0 FROM import_segments() WHERE what = 'new or changed';
SELECT 'axes keep their ids', count(*) = 8 FROM was JOIN town.axis a USING (axis_id, source_ref) WHERE a.geom::bytea = was.geom::bytea;
UPDATE segment SET geom = street(3, 90) WHERE geom = street(3);
INSERT INTO segment VALUES ('D7', NULL, 6, street(20));
SELECT 'a row that comes and one whose line changes leave the others', named('new or changed') IS NULL AND lying() LIKE 'D7 at 0, D7#2 at 1 by hand, D7#3 at 3, D7#4 at 20,%';
SELECT 'and the changed one keeps its id', a.axis_id = was.axis_id AND round(ST_Length(a.geom)) = 90 FROM town.axis a JOIN was USING (source_ref) WHERE source_ref = 'D7#3';
DELETE FROM segment WHERE road = 'D7' AND NOT ST_Equals(geom, street(1));
SELECT 'the last one of several keeps its number', named('vanished%') = '{D7,D7#3,D7#4}' AND lying() LIKE 'D7#2 at 1 by hand, D8 at 2,%';
-- Refs that look like numbered ones.
TRUNCATE segment;
INSERT INTO segment VALUES ('a#2', NULL, 6, street(30)), ('a', NULL, 6, street(31)), ('#3', NULL, 6, street(32)), ('b#99999999999', NULL, 6, street(33)), (NULL, NULL, 6, street(34)), (NULL, NULL, 6, street(34));
SELECT FROM import_segments() \g /dev/null
SELECT 'a source_ref of the source that looks like a number of ours stays', array_agg(source_ref ORDER BY source_ref) = '{#3,a,a#2,b#99999999999}' FROM town.axis WHERE source_ref NOT LIKE 'D7%';
SELECT 'again too', count = 2 FROM import_segments() WHERE what = 'new or changed';
INSERT INTO segment VALUES ('a', NULL, 6, street(35));
SELECT 'where it is that number, the import is refused, and the ref named', state = '22023' AND said = 'source_ref a#2 stands in more than one source row' FROM test.refusal('SELECT import_segments()');
