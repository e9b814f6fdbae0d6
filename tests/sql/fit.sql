\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Streets fitted to observations: proposals, what they write, and what comes back.  (name, holds)
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
-- A street of two axes and a side street, 6 m wide by the class; their kerbs were surveyed.
CREATE PROCEDURE pg_temp.draw(model name, driving_side text DEFAULT 'right') LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2154, subjects => '{interconnection,kerb,sidewalk,fit}', driving_side => driving_side);
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, radius, source, source_ref) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 6, 5, 'city', '1'),
    (2, pg_temp.line('LINESTRING(120 0,240 0)'), 6, 5, 'city', '2'), (3, pg_temp.line('LINESTRING(120 0,120 100)'), 6, 5, NULL, NULL)$q$, model); END $$;
CREATE TABLE survey AS SELECT * FROM (VALUES (1, 'kerb', pg_temp.line('LINESTRING(20 5.2,100 5.2)')), (2, 'kerb', pg_temp.line('LINESTRING(20 -3.1,100 -3.1)')),
  (3, 'kerb', pg_temp.line('LINESTRING(130 4,230 5)')), (4, 'kerb', pg_temp.line('LINESTRING(130 -4,230 -5)')), (5, 'sidewalk_back', pg_temp.line('LINESTRING(20 7.7,100 7.7)')),
  (6, 'kerb', pg_temp.line('LINESTRING(20 60,40 60)'))) v(id, what, place);
CALL pg_temp.draw('town');
\set mapping '{"geom": "place", "kind": "what", "source_ref": "id"}'
SELECT 'observations are counted by kind', string_agg(concat_ws(' ', what, class, count), ', ' ORDER BY class) = 'observations kerb 5, observations sidewalk_back 1' FROM streetgen.observe('town', 'survey', :'mapping');
SELECT 'each side tells how far its observed kerb lies', (SELECT string_agg(concat_ws(' ', axis_id, side, round(mean::numeric, 1)), ', ' ORDER BY axis_id, side) FROM town.kerb_distance JOIN town.edge USING (edge_id)) = '1 left 2.2, 1 right 0.1, 2 left 1.5, 2 right 1.5';
SELECT 'what no street takes says why', (SELECT string_agg(concat_ws(' ', observation_id, why, points), ', ') FROM town.observation_unused) = '6 no street within fit_reach of its kerb 20';
CREATE TABLE was AS SELECT * FROM test.content('town');
CREATE TABLE axis_was AS SELECT * FROM town.axis;
CREATE TABLE told AS SELECT * FROM streetgen.fit('town');
SELECT 'a fit tells of its run', (fit_run, axes, observations) = (1, 2, 460) AND used = 440 AND mean_before > 1.2 AND mean_after < 0.01 AND median_after < 0.01 AND iterations > 0 FROM told;
SELECT 'it changes no axis', NOT EXISTS (TABLE town.axis EXCEPT TABLE axis_was);
SELECT 'it proposes widths, offsets and sidewalks', abs(width - 8.3) < 0.01 AND width_end IS NULL AND abs(roadway_offset - 1.05) < 0.01 AND abs(sidewalk_left - 2.5) < 0.02 AND sidewalk_right IS NULL FROM town.fit_proposal WHERE axis_id = 1;
SELECT 'and widths that change along a street', abs(width - 7.8) < 0.1 AND abs(width_end - 10.2) < 0.1 AND roadway_offset IS NULL FROM town.fit_proposal WHERE axis_id = 2;
SELECT 'arrows lead from each kerb to its new place', ST_NumGeometries(geom) = 6 AND abs(ST_Length(geom) - 3 * 2.3) < 0.05 AND abs(wider - 2.3) < 0.01 FROM town.fit_change WHERE axis_id = 1;
SELECT 'accepted, streets follow at once', streetgen.accept_fit('town', 1) = 2;
SELECT 'their edges are as wide', abs(width - 8.3) < 0.01 FROM town.edge WHERE axis_id = 1;
SELECT 'and stand where kerbs were observed', bool_and(mean < 0.02) FROM town.kerb_distance;
SELECT 'as an edit by hand', width_by_hand AND source_width = 6 FROM town.axis WHERE axis_id = 1;
SELECT 'a second time there is nothing to accept', streetgen.accept_fit('town', 1) = 0;
SELECT 'and nothing to propose', axes = 0 FROM streetgen.fit('town');
CREATE TABLE edited AS SELECT * FROM test.content('town');
UPDATE town.edge SET input_hash = 0; SELECT 'as from scratch', count(*) > 0 FROM streetgen.generate('town', wait => true);
SELECT 'as from scratch, row by row', NOT EXISTS ((TABLE edited EXCEPT ALL SELECT * FROM test.content('town')) UNION ALL (SELECT * FROM test.content('town') EXCEPT ALL TABLE edited));
SELECT 'undone', streetgen.undo_fit('town', 1) = 2;
SELECT 'all is exactly what it was', NOT EXISTS (TABLE town.axis EXCEPT TABLE axis_was) AND NOT EXISTS ((TABLE was EXCEPT ALL SELECT * FROM test.content('town')) UNION ALL (SELECT * FROM test.content('town') EXCEPT ALL TABLE was));
SELECT 'states are told', (SELECT string_agg(DISTINCT state, ',') FROM town.fit_proposal) = 'undone';

-- An axis that was edited since.
CREATE TABLE again AS SELECT * FROM streetgen.fit('town');
UPDATE town.axis SET width = 7 WHERE axis_id = 2;
SELECT 'it is told by check_model', (SELECT count(*) FROM streetgen.check_model('town') WHERE rule = 'proposal of a fit whose axis was edited since') = 1;
SELECT fit_run AS run FROM again \gset
SELECT 'it is refused', test.state(format('SELECT streetgen.accept_fit(''town'', %s)', :run)) = '55000';
SELECT 'the others are accepted', streetgen.accept_fit('town', :run, '{1}') = 1;
UPDATE town.axis SET name = 'Main Street' WHERE axis_id = 1;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
SELECT 'nor is it undone', test.state(format('SELECT streetgen.undo_fit(''town'', %s)', :run)) = '55000';
SELECT 'the rest is rejected', streetgen.reject_fit('town', :run) = 1;
SELECT 'and says so', state = 'rejected' FROM town.fit_proposal WHERE fit_run = :run AND axis_id = 2;

-- Distances follow observations by hand, of whoever may edit, who also fits and settles.
CREATE ROLE fit_editor ROLE CURRENT_USER;
SELECT 'granted', streetgen.grant('town', 'fit_editor', 'editor') IS NOT NULL;
SET ROLE fit_editor;
INSERT INTO town.observation (geom) VALUES (pg_temp.line('POINT(115 60)'));
SELECT 'a point by hand is told at once', (observations, mean) = (1, 2) FROM town.kerb_distance JOIN town.edge USING (edge_id) WHERE axis_id = 3 AND side = 'left';
UPDATE town.observation SET geom = ST_Translate(geom, 1, 0) WHERE weight = 100;
SELECT 'and where it goes', mean = 1 FROM town.kerb_distance JOIN town.edge USING (edge_id) WHERE axis_id = 3;
SELECT 'an editor fits', axes > 0 FROM streetgen.fit('town', '{3}');
SELECT 'accepts', streetgen.accept_fit('town', max(fit_run)) = 1 FROM town.fit_run;
SELECT 'and undoes', streetgen.undo_fit('town', max(fit_run)) = 1 FROM town.fit_run;
DELETE FROM town.observation WHERE weight = 100;
SELECT 'what is gone is told no more', count(*) = 0 FROM town.kerb_distance JOIN town.edge USING (edge_id) WHERE axis_id = 3;
RESET ROLE;
DROP OWNED BY fit_editor; DROP ROLE fit_editor;
SELECT 'while nobody follows', streetgen.live('town', false) >= 0;
INSERT INTO town.observation (geom) VALUES (pg_temp.line('POINT(115 60)'));
SELECT 'nothing is told', count(*) = 0 FROM town.kerb_distance JOIN town.edge USING (edge_id) WHERE axis_id = 3;
SELECT 'something was', count(*) > 0 FROM town.kerb_distance;
BEGIN;
TRUNCATE town.observation;
SELECT 'and still is when all go', count(*) > 0 FROM town.kerb_distance;
ROLLBACK;
SELECT 'until all is computed', streetgen.live('town', true) >= 0 AND (SELECT count(*) > 0 FROM streetgen.generate('town', wait => true));
SELECT 'then it is', mean = 2 FROM town.kerb_distance JOIN town.edge USING (edge_id) WHERE axis_id = 3;
DELETE FROM town.observation WHERE weight = 100;

-- A street wider than others takes what is far from its axis, also after an edit and where it alone is fitted.
SELECT 'made', streetgen.create_model('wide', 2154, subjects => '{fit}') IS NOT NULL;
INSERT INTO wide.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 90);
INSERT INTO wide.observation (geom, weight) VALUES (pg_temp.line('LINESTRING(20 47,100 47)'), 1);
UPDATE wide.axis SET width = 91;
SELECT 'an edit keeps its distances', (observations, mean) = (80, 1.5) FROM wide.kerb_distance;
SELECT 'and it is fitted alone', used = 80 FROM streetgen.fit('wide', '{1}');

-- Axes that move.
CALL pg_temp.draw('moved');
SELECT 'taken', count(*) > 0 FROM streetgen.observe('moved', 'survey', :'mapping');
CREATE TABLE moved_was AS SELECT * FROM moved.axis;
SELECT fit_run AS run FROM streetgen.fit('moved', NULL, '{"moves": "axis"}') \gset
SELECT 'vertices move to the middle of the kerbs', abs(ST_Y(ST_LineInterpolatePoint(geom, 0.5)) - 6860001.05) < 0.1 AND roadway_offset IS NULL FROM moved.fit_proposal WHERE axis_id = 1;
SELECT 'pieces are at most as long as the setting', bool_and(metres < 30.5) FROM (SELECT ST_Distance(d.geom, lag(d.geom) OVER (PARTITION BY axis_id ORDER BY path)) AS metres FROM moved.fit_proposal p, ST_DumpPoints(p.geom) d) m;
SELECT 'axes that share a node that moves are accepted together', test.state(format('SELECT streetgen.accept_fit(''moved'', %s, ''{1}'')', :run)) = '55000';
SELECT 'all of them are', streetgen.accept_fit('moved', :run) = 3;
SELECT 'and keep the network', (SELECT count(*) FROM moved.node) = 4 AND (SELECT count(*) FROM moved.edge) = 3 AND NOT EXISTS (SELECT FROM streetgen.check_model('moved') WHERE severity = 'error');
SELECT 'undone', streetgen.undo_fit('moved', :run) = 3;
SELECT 'axes are what they were', NOT EXISTS (TABLE moved.axis EXCEPT TABLE moved_was);
SELECT 'some alone leave the nodes of others', axes = 1 FROM streetgen.fit('moved', '{1}', '{"moves": "axis"}');
SELECT 'so they are accepted alone', streetgen.accept_fit('moved', (SELECT max(fit_run) FROM moved.fit_run)) = 1;
SELECT 'and the network stands', count(*) = 4 FROM moved.node;

-- What is left as it was stays the source's, and a delivery leaves what was accepted.
CREATE TABLE street AS SELECT * FROM (VALUES ('a', 6, pg_temp.line('LINESTRING(0 0,120 0)')), ('b', 6, pg_temp.line('LINESTRING(0 50,120 50)')), ('c', 6, pg_temp.line('LINESTRING(0 90,120 90)'))) v(id, width, geom);
\set columns '{"source_ref": "id", "width": "width"}'
SELECT 'made', streetgen.create_model('fed', 2154, subjects => '{sidewalk,fit}') IS NOT NULL;
SELECT 'delivered', count(*) > 0 FROM streetgen.import_axes('fed', 'street', :'columns');
SELECT 'computed', count(*) > 0 FROM streetgen.generate('fed', wait => true);
INSERT INTO fed.observation (kind, geom, weight) SELECT kind, pg_temp.line(line), 1 FROM (VALUES ('kerb', 'LINESTRING(20 5.2,100 5.2)'), ('kerb', 'LINESTRING(20 -3.1,100 -3.1)'), ('sidewalk_back', 'LINESTRING(20 55,100 55)'),
  ('kerb', 'LINESTRING(20 94,100 94)'), ('kerb', 'LINESTRING(20 88,100 88)')) v(kind, line);
CREATE VIEW fed_axis AS SELECT source_ref, width, round(roadway_offset::numeric, 1) AS beside, round(sidewalk_left::numeric, 1) AS sidewalk, width_by_hand FROM fed.axis ORDER BY 1;
SELECT 'fitted', axes = 3 FROM streetgen.fit('fed');
SELECT 'a proposal has what changes', (SELECT string_agg(concat_ws(' ', axis_id, round(width::numeric, 1), round(roadway_offset::numeric, 1), round(sidewalk_left::numeric, 1)), ', ' ORDER BY axis_id) FROM fed.fit_proposal) = '1 8.3 1.0, 2 2.0, 3 1.0';
SELECT 'accepted', streetgen.accept_fit('fed', 1) = 3;
SELECT 'what does not is left', (SELECT string_agg(concat_ws(' ', source_ref, round(width::numeric, 1), beside, sidewalk, width_by_hand), ', ') FROM fed_axis) = 'a 8.3 1.0 t, b 6.0 2.0 f, c 6.0 1.0 f';
UPDATE street SET width = 7;
SELECT 'delivered again', count(*) > 0 FROM streetgen.import_axes('fed', 'street', :'columns');
SELECT 'a delivery leaves what was accepted', (SELECT string_agg(concat_ws(' ', source_ref, round(width::numeric, 1), beside, sidewalk), ', ') FROM fed_axis) = 'a 8.3 1.0, b 7.0 2.0, c 7.0 1.0';

-- No node is parted: not from an axis that came since, nor from one whose proposal was rejected, nor from a tunnel.
SELECT 'undone', streetgen.undo_fit('moved', (SELECT max(fit_run) FROM moved.fit_run)) = 1;
SELECT fit_run AS run FROM streetgen.fit('moved', NULL, '{"moves": "axis"}') \gset
INSERT INTO moved.axis (axis_id, geom, width) VALUES (4, pg_temp.line('LINESTRING(0 0,-50 30)'), 6);
SELECT 'an axis that came since is not left behind', r.state = '55000' AND r.hint LIKE '%: 4.%' FROM test.refusal(format('SELECT streetgen.accept_fit(''moved'', %s)', :run)) r;
DELETE FROM moved.axis WHERE axis_id = 4;
SELECT 'one is rejected', streetgen.reject_fit('moved', :run, '{2}') = 1;
INSERT INTO moved.axis (axis_id, geom, width) VALUES (9, pg_temp.line('LINESTRING(-50 300,-50 400)'), 6);
SELECT 'nor one whose proposal was rejected', r.state = '55000' AND r.hint LIKE '%: 2.%' FROM test.refusal(format('SELECT streetgen.accept_fit(''moved'', %s)', :run)) r;
SELECT fit_run AS run FROM streetgen.fit('moved', NULL, '{"moves": "axis"}') \gset
SELECT 'those that belong together are told', r.hint LIKE '%: 1, 2, 3.%' FROM test.refusal(format('SELECT streetgen.accept_fit(''moved'', %s, ''{3}'')', :run)) r;
SELECT 'accepted', streetgen.accept_fit('moved', :run) = 3;
BEGIN;
UPDATE moved.axis SET geom = ST_MakeLine((SELECT ST_StartPoint(geom) FROM moved.axis WHERE axis_id = 1), ST_EndPoint(geom)) WHERE axis_id = 9;
SELECT 'an older axis that came there by hand loses no node', r.state = '55000' AND r.hint LIKE '%: 9.%' FROM test.refusal(format('SELECT streetgen.undo_fit(''moved'', %s)', :run)) r;
ROLLBACK;
INSERT INTO moved.axis (axis_id, geom, width) SELECT 4, ST_MakeLine(ST_StartPoint(geom), pg_temp.line('POINT(-50 30)')), 6 FROM moved.axis WHERE axis_id = 1;
SELECT 'and undone as little', r.state = '55000' AND r.hint LIKE '%: 4.%' FROM test.refusal(format('SELECT streetgen.undo_fit(''moved'', %s)', :run)) r;
DELETE FROM moved.axis WHERE axis_id IN (4, 9);
SELECT 'undone without it', streetgen.undo_fit('moved', :run) = 3;
UPDATE moved.axis SET level = -1 WHERE axis_id = 2;
SELECT 'nodes of a tunnel stay', axes = 1 FROM streetgen.fit('moved', NULL, '{"moves": "axis"}');
SELECT 'accepted', streetgen.accept_fit('moved', max(fit_run)) = 1 FROM moved.fit_run;
SELECT 'and it has them', count(*) = 4 FROM moved.node;

-- An axis that ends beside its node, within the tolerance, is still at it.
SELECT 'made', streetgen.create_model('beside', 2154, subjects => '{fit}') IS NOT NULL;
INSERT INTO beside.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 6), (2, pg_temp.line('LINESTRING(120.2 0,240 0)'), 6), (3, pg_temp.line('LINESTRING(119.9 0.1,120 100)'), 6);
INSERT INTO beside.observation (geom, weight) SELECT ST_Translate(place, 0, 0.5), 1 FROM survey WHERE id IN (1, 2);
SELECT 'three axes meet', (SELECT count(*) FROM beside.node) = 4;
SELECT 'one is fitted', axes = 1 FROM streetgen.fit('beside', '{1}', '{"moves": "axis"}');
SELECT 'and accepted', streetgen.accept_fit('beside', 1) = 1;
SELECT 'they still meet', (SELECT count(*) FROM beside.node) = 4;
SELECT 'undone', streetgen.undo_fit('beside', 1) = 1;

-- A street that accepting joined, as it was drawn since the fit, is no reason to leave what was accepted.
SELECT 'made', streetgen.create_model('joined', 2154, subjects => '{fit}') IS NOT NULL;
INSERT INTO joined.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 6);
INSERT INTO joined.observation (geom, weight) SELECT ST_Translate(place, 0, 0.9), 1 FROM survey WHERE id IN (1, 2);
SELECT 'fitted', axes > 0 FROM streetgen.fit('joined', '{1}', '{"moves": "axis"}');
INSERT INTO joined.axis (axis_id, geom, width) VALUES (2, pg_temp.line('LINESTRING(60 2,60 80)'), 6);
SELECT 'accepted', streetgen.accept_fit('joined', 1) = 1;
SELECT 'it meets another', (SELECT count(*) FROM joined.edge WHERE axis_id = 1) = 2;
SELECT 'and is undone', streetgen.undo_fit('joined', 1) = 1;
SELECT 'as it was', (SELECT count(*) FROM joined.edge WHERE axis_id = 1) = 1;

-- A street that goes leaves what it took to another, however far fit_reach reaches.
SELECT 'made', streetgen.create_model('far', 2154, subjects => '{fit}') IS NOT NULL;
SELECT 'far', streetgen.set('far', 'fit_reach', '50') IS NOT NULL;
INSERT INTO far.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 6), (2, pg_temp.line('LINESTRING(0 80,120 80)'), 6);
INSERT INTO far.observation (geom) VALUES (pg_temp.line('POINT(60 43)'));
SELECT 'one takes it', (SELECT string_agg(concat_ws(' ', axis_id, side), ', ') FROM far.kerb_distance JOIN far.edge USING (edge_id)) = '2 right';
UPDATE far.axis SET geom = ST_Translate(geom, 0, 15) WHERE axis_id = 2;
SELECT 'then the other', (SELECT string_agg(concat_ws(' ', axis_id, side), ', ') FROM far.kerb_distance JOIN far.edge USING (edge_id)) = '1 left';

-- A line between lanes says nothing of a street of one.
INSERT INTO far.observation (kind, geom) VALUES ('marking', pg_temp.line('POINT(60 1)'));
SELECT 'of two it is taken', NOT EXISTS (SELECT FROM far.observation_unused);
UPDATE far.axis SET lane_count = 1;
SELECT 'of one it is unused', why = 'no street of two lanes within fit_reach of its kerb' FROM far.observation_unused;

-- By hand, and objects.
CALL pg_temp.draw('hand', 'left');
INSERT INTO hand.observation (geom) VALUES (pg_temp.line('POINT(60 4.5)'));
SELECT 'a point by hand counts a hundred times', weight = 100 AND kind = 'kerb' FROM hand.observation;
SELECT 'and is enough', axes = 1 AND mean_after < 0.05 FROM streetgen.fit('hand');
DELETE FROM hand.observation;
SELECT 'without observations nothing is proposed', (axes, observations, used) = (0, 0, 0) AND mean_before IS NULL FROM streetgen.fit('hand');
INSERT INTO hand.observation (kind, relation, geom) VALUES ('object', 'out', pg_temp.line('POINT(60 2)'));
SELECT 'an object out of the roadway', axes = 1 FROM streetgen.fit('hand');
SELECT 'moves its kerb', bool_and(width / 2 + roadway_offset < 2) FROM hand.fit_proposal WHERE fit_run = (SELECT max(fit_run) FROM hand.fit_run);
DELETE FROM hand.observation;
INSERT INTO hand.observation (kind, geom) VALUES ('sidewalk_back', pg_temp.line('LINESTRING(20 5,100 5)')); UPDATE hand.observation SET confidence = 0;
SELECT 'what nobody is sure of counts as nothing', (axes, used) = (0, 0) FROM streetgen.fit('hand');
SELECT 'and says so', bool_and(why = 'its confidence is 0') FROM hand.observation_unused;
DELETE FROM hand.observation;
INSERT INTO hand.observation (kind, geom) VALUES ('width', pg_temp.line('MULTILINESTRING((50 -4,50 4),(60 -4,60 4))'));
SELECT 'of widths each line counts', (observations, used) = (2, 2) FROM streetgen.fit('hand');
SELECT 'as long as it is', abs(width - 8) < 0.05 FROM hand.fit_proposal WHERE fit_run = (SELECT max(fit_run) FROM hand.fit_run);
SELECT 'one without length is none', test.state($$INSERT INTO hand.observation (kind, geom) VALUES ('width', pg_temp.line('LINESTRING(50 0,50 0)'))$$) = '23514';
DELETE FROM hand.observation;
INSERT INTO hand.observation (geom) VALUES ('SRID=2154;LINESTRING(0 0,1e12 1e12)');
SELECT 'a line round the earth is no harm', (axes, used) = (0, 0) FROM streetgen.fit('hand');
DELETE FROM hand.observation;
INSERT INTO hand.observation (geom) SELECT pg_temp.line('POINT(61 3.5)') FROM generate_series(1, 20000); INSERT INTO hand.observation (kind, relation, geom) VALUES ('object', 'out', pg_temp.line('POINT(60 2)'));
SELECT 'many points on one place are no harm', used = 20001 FROM streetgen.fit('hand', '{1}');

-- Again, and what is wrong.
DELETE FROM survey WHERE id IN (5, 6); UPDATE survey SET place = ST_Translate(place, 0, 0.5) WHERE id = 1;
CREATE TABLE ids AS SELECT observation_id, source_ref FROM town.observation;
BEGIN;
CREATE TEMPORARY TABLE brought (at timestamptz) ON COMMIT DROP;
CREATE FUNCTION pg_temp.brought() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN INSERT INTO pg_temp.brought VALUES (clock_timestamp()); RETURN NULL; END $$;
CREATE TRIGGER brought AFTER DELETE ON town.kerb_distance FOR EACH STATEMENT EXECUTE FUNCTION pg_temp.brought();
INSERT INTO survey SELECT 9, what, ST_Translate(place, 0, 1) FROM survey WHERE id = 1;
DELETE FROM survey WHERE id = 6;
SELECT 'rows come, change and go', count(*) > 0 FROM streetgen.observe('town', 'survey', :'mapping');
SELECT 'and distances follow once', count(*) = 1 FROM brought;
ROLLBACK;
SELECT 'observed again', count(*) = 1 FROM streetgen.observe('town', 'survey', :'mapping');
SELECT 'what is gone goes, and the rest keeps its ids', (SELECT count(*) FROM town.observation) = 4 AND NOT EXISTS (SELECT observation_id, source_ref FROM town.observation EXCEPT TABLE ids);
CREATE VIEW bare AS SELECT place FROM survey;
SELECT 'without a source_ref', count(*) = 1 FROM streetgen.observe('town', 'bare', '{"geom": "place"}');
SELECT 'again', count(*) = 1 FROM streetgen.observe('town', 'bare', '{"geom": "place"}');
SELECT 'all are replaced', count(*) = 4 FROM town.observation WHERE source = 'bare';
CREATE TABLE wrong AS SELECT 1 AS id, 'NaN'::text AS confidence, '7'::text AS weight, 'wall'::text AS kind, pg_temp.line('POINT(0 0)') AS geom;
SELECT 'bad rows are refused', test.state($$SELECT streetgen.observe('town', 'wrong', '{"kind": "kind"}')$$) = '22023' AND test.state($$SELECT streetgen.observe('town', 'wrong', '{"confidence": "confidence", "kind": {"value": "kerb"}}')$$) = '22023'
  AND test.state($$SELECT streetgen.observe('town', 'wrong', '{"confidence": "weight", "kind": {"value": "kerb"}}')$$) = '22023' AND test.state($$SELECT streetgen.observe('town', 'wrong', '{"kind": {"value": "object"}}')$$) = '22023';
SELECT 'and leave the model', (SELECT count(*) FROM town.observation WHERE source = 'wrong') = 0;
SELECT 'unknown options, axes and runs are refused', test.state($$SELECT streetgen.fit('town', NULL, '{"move": "axis"}')$$) = '22023' AND test.state($$SELECT streetgen.fit('town', NULL, '{"moves": "all"}')$$) = '22023' AND test.state($$SELECT streetgen.fit('town', NULL, '[]')$$) = '22023'
  AND test.state($$SELECT streetgen.fit('town', '{99}')$$) = '22023' AND test.state($$SELECT streetgen.accept_fit('town', 99)$$) = '22023' AND test.state($$SELECT streetgen.accept_fit('town', 1, '{3}')$$) = '22023';
SELECT 'switched off', count(*) >= 0 FROM streetgen.switch_subject('town', 'fit', false);
SELECT 'observations and proposals stay', to_regclass('town.kerb_distance') IS NULL AND (SELECT count(*) FROM town.observation) = 8 AND (SELECT count(*) FROM town.fit_proposal) > 0;
SELECT 'a model without the subject says how to get it', test.state($$SELECT streetgen.fit('town')$$) = '55000' AND test.state($$SELECT streetgen.observe('town', 'survey', '{"geom": "place"}')$$) = '55000';

-- Street 2 ends beside street 1, whose kerbs lie so that it would move there: it stays, and no node joins them.
SELECT streetgen.create_model('touching', 2154, subjects => '{fit}', driving_side => 'right') \g /dev/null
INSERT INTO touching.axis (axis_id, geom, width) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 6),
    (2, 'SRID=2154;LINESTRING(650050 6860001.5, 650050 6860080)', 6),
    (3, 'SRID=2154;LINESTRING(650000 6860200, 650100 6860200)', 6);
INSERT INTO touching.observation (geom) VALUES ('SRID=2154;LINESTRING(650005 6860005, 650040 6860005)'),
    ('SRID=2154;LINESTRING(650060 6860005, 650095 6860005)'), ('SRID=2154;LINESTRING(650005 6859998, 650095 6859998)'),
    ('SRID=2154;LINESTRING(650005 6860204, 650095 6860204)'), ('SRID=2154;LINESTRING(650005 6860198, 650095 6860198)');
SELECT count(*) AS nodes FROM touching.node \gset
SELECT streetgen.accept_fit('touching', fit_run) FROM streetgen.fit('touching', options => '{"moves": "axis"}') \g /dev/null
SELECT 'a fit joins no streets', count(*) = :nodes FROM touching.node;
SELECT 'what would come to touch another stays, and others move', bool_and(ST_Y(ST_StartPoint(geom)) = 6860000)
    FILTER (WHERE axis_id = 1) AND bool_and(ST_Y(ST_StartPoint(geom)) > 6860200.9) FILTER (WHERE axis_id = 3)
    FROM touching.axis;
