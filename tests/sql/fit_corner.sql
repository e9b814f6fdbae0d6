\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Radii of corners proposed where arcs of observed kerbs answer them.  Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
-- A main street that two side streets cross; where both axes go on, a pair of them makes two such corners.
CREATE PROCEDURE pg_temp.draw(model name, driving_side text DEFAULT 'right') LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2154, subjects => '{interconnection,kerb,sidewalk,fit}', driving_side => driving_side);
  PERFORM streetgen.set(model, 'crossing', 'split');
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, radius) VALUES (1, pg_temp.line('LINESTRING(-60 0,140 0)'), 8, 6), (2, pg_temp.line('LINESTRING(0 -60,0 60)'), 6, 6), (3, pg_temp.line('LINESTRING(80 -60,80 0)'), 6, 6)$q$, model); END $$;
CALL pg_temp.draw('seen');
UPDATE seen.axis SET radius = CASE axis_id WHEN 2 THEN 3.5 ELSE 6 END;
CREATE TABLE survey AS SELECT ST_Union(surface) AS geom FROM (SELECT surface FROM seen.section UNION ALL SELECT surface FROM seen.intersection) s;
CALL pg_temp.draw('town');
SELECT 'kerbs are observed', count(*) = 1 FROM streetgen.observe('town', 'survey', '{}');
CREATE TABLE was AS SELECT * FROM test.content('town');
CREATE TABLE told AS SELECT * FROM streetgen.fit('town', options => '{"moves": "corner"}');
SELECT 'a fit tells of arcs and radii', (fit_run, axes, observations, used, iterations) = (1, 4, 6, 6, 0) AND abs(mean_before - 4 * 2.5 / 6) < 0.01 AND abs(median_before - 2.5) < 0.01 AND mean_after = 0 AND median_after = 0 FROM told;
SELECT 'it proposes the radius of each arc', count(*) = 4 AND bool_and(abs(radius - 3.5) < 0.01 AND before = 6 AND state = 'proposed') FROM town.corner_proposal;
SELECT 'whose corner it answers', bool_and(ST_DWithin(ST_PointN(p.geom, 2), c.arc, 3)) FROM town.corner_proposal p JOIN town.corner c USING (corner_id);
SELECT 'and changes none', NOT EXISTS (TABLE was EXCEPT ALL SELECT * FROM test.content('town'));
SELECT 'they are accepted', streetgen.accept_fit('town', 1) = 4;
SELECT 'as radii by hand', count(*) = 4 FROM town.corner_override;
SELECT 'corners follow at once', count(*) = 4 AND bool_and(c.method = 'by_hand' AND abs(c.radius - 3.5) < 0.01 AND abs(ST_Distance(c.arc, p.geom)) < 0.01 AND e.by_hand) FROM town.corner_proposal p JOIN town.corner c USING (corner_id) JOIN town.corner_editing e USING (corner_id);
SELECT 'the others stay', bool_and(method <> 'by_hand') FROM town.corner WHERE corner_id NOT IN (SELECT corner_id FROM town.corner_proposal);
SELECT 'each row speaks of its corner', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE relation = 'corner_override');
SELECT 'a second time there is nothing to accept', streetgen.accept_fit('town', 1) = 0;
SELECT 'nor to propose', axes = 0 AND mean_after < 0.01 FROM streetgen.fit('town', options => '{"moves": "corner"}');
CREATE TABLE edited AS SELECT * FROM test.content('town');
UPDATE town.edge SET input_hash = 0;
SELECT streetgen.generate('town', wait => true) \g /dev/null
SELECT 'as from scratch', NOT EXISTS ((TABLE edited EXCEPT ALL SELECT * FROM test.content('town')) UNION ALL (SELECT * FROM test.content('town') EXCEPT ALL TABLE edited));
SELECT 'undone', streetgen.undo_fit('town', 1) = 4;
SELECT 'no row by hand is left', NOT EXISTS (SELECT FROM town.corner_override);
SELECT 'all is exactly what it was', NOT EXISTS ((TABLE was EXCEPT ALL SELECT * FROM test.content('town')) UNION ALL (SELECT * FROM test.content('town') EXCEPT ALL TABLE was));
SELECT 'states are told', (SELECT string_agg(DISTINCT state, ',') FROM town.corner_proposal) = 'undone';

-- Some of them, and what was edited since.
SELECT fit_run AS run FROM streetgen.fit('town', '{3}', '{"moves": "corner"}') \gset
SELECT 'corners of some axes alone', count(*) = 0 FROM town.corner_proposal WHERE fit_run = :run;
SELECT fit_run AS run FROM streetgen.fit('town', '{2}', '{"moves": "corner"}') \gset
SELECT 'of an axis its corners', count(*) = 4 FROM town.corner_proposal WHERE fit_run = :run;
SELECT 'others are no part of it', test.state(format('SELECT streetgen.accept_fit(''town'', %s, ''{3}'')', :run)) = '22023';
UPDATE town.corner_editing SET radius = 5 WHERE corner_id = (SELECT min(corner_id) FROM town.corner_proposal WHERE fit_run = :run);
SELECT 'a radius by hand since is told by check_model', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'proposal of a fit whose axis was edited since' AND relation = 'corner_proposal';
SELECT 'and never overwritten', (r).state = '55000' AND (r).hint LIKE '%1, 2%' FROM (SELECT test.refusal(format('SELECT streetgen.accept_fit(''town'', %s)', :run)) AS r) t;
SELECT 'nor proposed anew', axes = 3 FROM streetgen.fit('town', options => '{"moves": "corner"}');
SELECT 'all are rejected', streetgen.reject_fit('town', :run, '{1}') = 4;
SELECT max(fit_run) AS run FROM town.fit_run \gset
UPDATE town.axis SET width = 6.5 WHERE axis_id = 2;
SELECT 'an axis that was edited since is refused', test.state(format('SELECT streetgen.accept_fit(''town'', %s)', :run)) = '55000';
SELECT fit_run AS run FROM streetgen.fit('town', options => '{"moves": "corner"}') \gset
SELECT 'fitted again they are accepted', streetgen.accept_fit('town', :run) = 3;
UPDATE town.corner_editing SET radius = 4 WHERE corner_id = (SELECT min(corner_id) FROM town.corner_proposal WHERE fit_run = :run);
SELECT 'nor is undone what was edited since', test.state(format('SELECT streetgen.undo_fit(''town'', %s)', :run)) = '55000' AND (SELECT count(*) FROM town.corner_override) = 4;
UPDATE town.corner_editing c SET radius = p.radius FROM town.corner_proposal p WHERE p.corner_id = c.corner_id AND p.fit_run = :run;
SELECT 'put back it is', streetgen.undo_fit('town', :run) = 3;
SELECT 'and what was by hand before stays', count(*) = 1 FROM town.corner_override;

-- Axes that go on beyond their crossing, on the left, and for an editor.
CALL pg_temp.draw('left', 'left');
SELECT streetgen.set('left', 'fit_arc_tolerance', '0.02') \g /dev/null
SELECT streetgen.observe('left', 'survey', '{}') \g /dev/null
CREATE ROLE corner_editor ROLE CURRENT_USER; CREATE ROLE corner_reader ROLE CURRENT_USER;
GRANT USAGE ON SCHEMA test TO PUBLIC;
SELECT streetgen.grant('left', 'corner_editor', 'editor'), streetgen.grant('left', 'corner_reader', 'reader') \g /dev/null
SET ROLE corner_reader;
SELECT 'a reader proposes nothing', test.state($$SELECT streetgen.fit('left', options => '{"moves": "corner"}')$$) = '42501' AND (SELECT count(*) FROM "left".corner_proposal) = 0;
SET ROLE corner_editor;
SELECT 'an editor fits', axes = 4 FROM streetgen.fit('left', options => '{"moves": "corner"}');
SELECT 'accepts', streetgen.accept_fit('left', 1, '{1}') = 4;
SELECT 'and corners follow', count(*) = 4 AND bool_and(abs(radius - 3.5) < 0.01) FROM "left".corner WHERE method = 'by_hand';
SELECT 'and undoes', streetgen.undo_fit('left', 1) = 4;
RESET ROLE;
DROP OWNED BY corner_editor, corner_reader;
DROP ROLE corner_editor, corner_reader;

-- What is wrong, and what says nothing.
DELETE FROM town.observation;
INSERT INTO town.observation (geom) SELECT ST_Points(geom) FROM survey;
SELECT 'points make no arc', (axes, observations, used) = (0, 0, 0) AND mean_before IS NULL FROM streetgen.fit('town', options => '{"moves": "corner"}');
INSERT INTO town.observation (geom) SELECT ST_Collect(geom, ST_GeomFromText('POINT(650000 6860000)', 2154)) FROM survey;
SELECT 'a collection has the arcs of its areas', observations = 6 FROM streetgen.fit('town', options => '{"moves": "corner"}');
DELETE FROM town.observation;
INSERT INTO town.observation (geom) SELECT ST_Translate(ST_Boundary(geom), 10, 10) FROM survey;
SELECT 'arcs far away answer no corner', used = 0 FROM streetgen.fit('town', options => '{"moves": "corner"}');
