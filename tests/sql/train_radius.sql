\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- The radius of corners learnt from arcs of observed kerbs.  Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
-- Three main streets, 9 m wide, that cross five side streets of two kinds: corners of 8 m with the wide kind, else of 3 m.
CREATE PROCEDURE pg_temp.draw(model name) LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2154, subjects => '{interconnection,kerb,sidewalk,fit}', driving_side => 'right');
  EXECUTE format($q$INSERT INTO %I.axis (geom, width, speed, importance, lane_count, kind)
    SELECT pg_temp.line(format('LINESTRING(-50 %%1$s, 350 %%1$s)', 80 * n)), CASE n WHEN 1 THEN 11 ELSE 8 END, 50, 3, 2, CASE n WHEN 1 THEN 'secondary' ELSE 'tertiary' END FROM generate_series(0, 2) n
    UNION ALL SELECT pg_temp.line(format('LINESTRING(%%1$s -60, %%1$s 220)', 60 * n)), 6, 30, 5, 2, 'residential' FROM generate_series(0, 4) n$q$, model);
  PERFORM streetgen.set(model, 'crossing', 'split'); END $$;
CALL pg_temp.draw('town');
UPDATE town.axis SET radius = CASE kind WHEN 'tertiary' THEN 3 ELSE 8 END;
SELECT streetgen.generate('town') \g /dev/null
CREATE TABLE survey AS SELECT kerb_id, ST_Boundary(surface) AS geom FROM (SELECT min(edge_id) AS kerb_id, ST_Union(surface) AS surface FROM (SELECT edge_id, surface FROM town.section UNION ALL SELECT node_id, surface FROM town.intersection) s) s;
UPDATE town.axis SET radius = NULL;
SELECT streetgen.set('town', 'radius_by_importance', '{"1": 5}'), streetgen.set('town', 'radius_rule', 'major') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
SELECT 'without observations there is nothing to learn', (r).state = '22023' AND (r).said LIKE '%0 corners%' AND (r).hint LIKE '%observe%' FROM (SELECT test.refusal($$SELECT streetgen.train_radius('town')$$) AS r) t;
SELECT 'kerbs are observed', count(*) = 1 FROM streetgen.observe('town', 'survey', '{"source_ref": "kerb_id"}');
SELECT 'their arcs answer the corners', count(*) = 60 AND bool_and(abs(o.radius - CASE WHEN 'tertiary' IN (a.kind, b.kind) THEN 3 ELSE 8 END) < 0.05) FROM streetgen._observed_corners('town', NULL) o JOIN town.axis a ON a.axis_id = axis_a JOIN town.axis b ON b.axis_id = axis_b;
SELECT 'each one that of its corner', bool_and(ST_Distance(o.arc, c.arc) < 3 AND ST_Distance(ST_PointN(o.arc, 2), n.geom) < 15) FROM streetgen._observed_corners('town', NULL) o JOIN town.corner c USING (corner_id) JOIN town.node n USING (node_id);
CREATE TABLE was AS SELECT * FROM test.content('town');
CREATE TABLE told AS SELECT * FROM streetgen.train_radius('town');
SELECT 'it tells what it learnt, and how well', (function, corners) = ('town.trained_radius', 60) AND mean_error < 0.1 AND median_error < 0.05 AND mean_error_constant > 1 FROM told;
SELECT 'nothing else changes', NOT EXISTS ((TABLE was EXCEPT ALL SELECT * FROM test.content('town')) UNION ALL (SELECT * FROM test.content('town') EXCEPT ALL TABLE was));
SELECT 'the function is immutable, and the owner''s', provolatile = 'i' AND proowner = (SELECT nspowner FROM pg_namespace WHERE nspname = 'town') FROM pg_proc WHERE oid = 'town.trained_radius'::regproc;
SELECT 'it knows both kinds', abs(town.trained_radius(8, 50, 3, 2, 'tertiary') - 3) < 0.05 AND abs(town.trained_radius(11, 50, 3, 2, 'secondary') - 8) < 0.05;
SELECT 'a kind that it never met gets a radius', town.trained_radius(6, 30, 5, 2, 'footway') BETWEEN 2.9 AND 8.1 AND town.trained_radius(6, 30, 5, 2, NULL) BETWEEN 2.9 AND 8.1;
SELECT 'where a number lacks there is none', town.trained_radius(NULL, 30, 5, 2, 'tertiary') IS NULL;
CREATE TABLE definition AS SELECT pg_get_functiondef('town.trained_radius'::regproc) AS text;
SELECT streetgen.train_radius('town') \g /dev/null
BEGIN;
UPDATE town.axis SET kind = E'it\'s $f$ {odd} \\ "kind" $$; CREATE TABLE hostile (); --' WHERE kind = 'tertiary';
SELECT 'whatever a kind is called', test.state($$SELECT streetgen.train_radius('town')$$) = 'none' AND to_regclass('hostile') IS NULL;
SELECT 'it is known', abs(town.trained_radius(8, 50, 3, 2, kind) - 3) < 0.05 FROM town.axis WHERE kind LIKE 'it%' LIMIT 1;
ROLLBACK;
SELECT 'learnt again it is the same', text = pg_get_functiondef('town.trained_radius'::regproc) FROM definition;
SELECT streetgen.set('town', 'radius_function', 'town.trained_radius') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
SELECT 'corners want what was learnt of the major street', bool_and(abs(c.radius_wanted - CASE WHEN 'tertiary' IN (a.kind, b.kind) THEN 3 ELSE 8 END) < 0.05) AND count(*) > 50
    FROM town.corner c JOIN town.edge ea ON ea.edge_id = edge_a JOIN town.edge eb ON eb.edge_id = edge_b JOIN town.axis a ON a.axis_id = ea.axis_id JOIN town.axis b ON b.axis_id = eb.axis_id WHERE 'residential' IN (a.kind, b.kind) AND a.kind <> b.kind AND c.arc IS NOT NULL;
DELETE FROM town.observation;
SELECT streetgen.generate('town') \g /dev/null
SELECT 'it stays when observations go', abs(town.trained_radius(8, 50, 3, 2, 'tertiary') - 3) < 0.05 AND (SELECT sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town'));
SELECT streetgen.adopt_model('town') \g /dev/null
SELECT 'and when the model is renewed', text = pg_get_functiondef('town.trained_radius'::regproc) AND (SELECT value FROM streetgen.setting('town') WHERE name = 'radius_function') = 'town.trained_radius' FROM definition;
SELECT 'with nothing to do then', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');

-- Rights.
CREATE ROLE trained_editor ROLE CURRENT_USER; CREATE ROLE trained_reader ROLE CURRENT_USER;
GRANT USAGE ON SCHEMA test TO PUBLIC;
SELECT streetgen.grant('town', 'trained_editor', 'editor'), streetgen.grant('town', 'trained_reader', 'reader') \g /dev/null
SET ROLE trained_editor;
SELECT 'an editor cannot train', (r).state = '42501' AND (r).hint <> '' FROM (SELECT test.refusal($$SELECT streetgen.train_radius('town')$$) AS r) t;
SELECT 'his edits compute with the function', test.state('UPDATE town.axis SET width = 8.2 WHERE axis_id = 1') = 'none';
SET ROLE trained_reader;
SELECT 'a reader reads the radii', bool_and(radius < 8.1) FROM town.axis_used;
RESET ROLE;
SELECT streetgen.drop_model('town') \g /dev/null
SELECT 'it goes with the model', to_regproc('town.trained_radius') IS NULL;
DROP OWNED BY trained_editor, trained_reader;
DROP ROLE trained_editor, trained_reader;
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'a model without the subject says how to get it', test.state($$SELECT streetgen.train_radius('bare')$$) = '55000';
RESET streetgen_test.subjects;
SELECT 'numbers that are no forest are refused', test.state($$SELECT streetgen.forest_value('{1,1}', '{3}')$$) = '22023' AND test.state($$SELECT streetgen.forest_value('{2,1,1,-1,5,0,0}', '{3}')$$) = '22023' AND test.state($$SELECT streetgen.forest_value('{1,1,1,-1,5,0,0}', '{NaN}')$$) = '22023';
SELECT 'each sample has as many features', test.state($$SELECT streetgen._grow_forest('{1,2,3,4,5,6,7,8}', '{1,2,3}')$$) = '22023' AND test.state($$SELECT streetgen._grow_forest('{1,2,3,4,5,6}', '{1,2,3}')$$) = 'none';
SELECT 'one leaf says its value', streetgen.forest_value('{1,1,1,-1,5,0,0}', '{3}') = 5 AND streetgen.forest_value('{1,1,3,0,4,1,2,-1,5,0,0,-1,6,0,0}', '{4}') = 6;
