\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
\ir shared/switch.sql
-- Overpasses: where two edges cross without a node, and who is above.
DO $$ BEGIN
  PERFORM streetgen.create_model('over', srid => 2154, subjects => '{interconnection,overpass}'),
    streetgen.create_model('fresh', srid => 2154, subjects => '{interconnection,overpass}'), streetgen.create_model('random', srid => 2154, subjects => '{overpass}'), setseed(0.4);
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('plain', srid => 2154);
END $$;
SELECT 'a model has overpasses on demand alone', to_regclass('plain.overpass') IS NULL AND to_regclass('over.overpass') IS NOT NULL;
-- A street of level 0 from west to east, bridges and a tunnel across it, and a street of its level.
INSERT INTO over.axis (axis_id, geom, width, level, importance) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650400 6860000)', 7, 0, 4),
    (2, 'SRID=2154;LINESTRING(650100 6859900, 650100 6860100)', 7, 1, 4),
    (3, 'SRID=2154;LINESTRING(650200 6859900, 650200 6860100)', 7, -1, 4),
    (4, 'SRID=2154;LINESTRING(650300 6859900, 650300 6860100)', 7, 0, 2),
    (5, 'SRID=2154;LINESTRING(650350 6859900, 650350 6860000, 650350 6860100)', 7, 0, 4);
CREATE VIEW who AS SELECT a.axis_id AS above, b.axis_id AS below, o.* FROM over.overpass o
    JOIN over.edge a ON a.edge_id = o.edge_above JOIN over.edge b ON b.edge_id = o.edge_below;
SELECT 'every crossing without a node is an overpass, one at a vertex once', array_agg((above, below, method)::text ORDER BY ST_X(geom))
    = '{"(2,1,level)","(1,3,level)","(4,1,importance)","(1,5,order)"}' FROM who;
SELECT 'it lies where the edges cross', bool_and(ST_Distance(o.geom, e.geom) < 1e-6 AND abs(ST_Length(e.geom) * ST_LineLocatePoint(e.geom, o.geom) - at) < 1e-6)
    FROM over.overpass o, LATERAL (VALUES (edge_above, abscissa_above), (edge_below, abscissa_below)) v(edge_id, at) JOIN over.edge e USING (edge_id);
SELECT 'the clearance is that of the setting', bool_and(clearance = 6) FROM over.overpass;

-- By hand.
BEGIN;
UPDATE over.overpass_editing SET axis_above = axis_below, axis_below = axis_above, clearance = NULL WHERE (axis_above, axis_below) = (4, 1);
SELECT 'a swap that says both axes, and no clearance, is one', count(*) = 1 FROM over.overpass_override WHERE (axis_above, axis_below) = (1, 4) AND clearance IS NULL;
ROLLBACK;
UPDATE over.overpass_editing SET axis_above = 1 WHERE (axis_above, axis_below) = (4, 1);
SELECT 'the other axis typed swaps them', (above, below, method) = (1, 4, 'by_hand') FROM who WHERE 4 IN (above, below);
UPDATE over.overpass_editing SET clearance = 5.5 WHERE (axis_above, axis_below) = (1, 4);
SELECT 'a clearance by hand holds there alone', array_agg(clearance ORDER BY ST_X(geom)) = '{6,6,5.5,6}' FROM over.overpass;
UPDATE over.axis SET geom = ST_Translate(geom, 3, 0) WHERE axis_id = 4;
SELECT 'it stays as the axis is moved a little', (above, below, method, clearance) = (1, 4, 'by_hand', 5.5) FROM who WHERE 4 IN (above, below);
SELECT 'a second run changes no row', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('over');
DELETE FROM over.overpass_editing WHERE axis_below = 4;
SELECT 'deleted in the view it is computed again', (above, below, method, clearance) = (4, 1, 'importance', 6) FROM who WHERE 4 IN (above, below);
SELECT 'its override is gone', count(*) = 0 FROM over.overpass_override;
SELECT 'refused: ' || name, test.state(statement) = state FROM (VALUES
    ('an axis that does not cross there', 'UPDATE over.overpass_editing SET axis_above = 3 WHERE axis_above = 4', '22023'),
    ('no axis', 'UPDATE over.overpass_editing SET axis_above = NULL WHERE axis_above = 4', '22023'),
    ('a clearance that is no number', $$UPDATE over.overpass_editing SET clearance = 'NaN' WHERE axis_above = 4$$, '22023'),
    ('a clearance beyond its range', 'UPDATE over.overpass_editing SET clearance = 101 WHERE axis_above = 4', '22023'),
    ('an overpass drawn', 'INSERT INTO over.overpass_editing (axis_above) VALUES (1)', '0A000'),
    ('a clearance in the table that is no number', $$INSERT INTO over.overpass_override (geom, axis_above, axis_below, clearance) SELECT geom, 4, 1, 'NaN' FROM over.overpass LIMIT 1$$, '23514')) r(name, statement, state);
INSERT INTO over.overpass_override (geom, axis_above, axis_below) VALUES ('SRID=2154;POINT(650100 6860000)', 3, 2);
SELECT 'an override without its crossing is a row of check_model', count(*) = 1 FROM streetgen.check_model('over') WHERE rule = 'overpass override without its crossing';
DELETE FROM over.overpass_override;

-- Live: by any path the same.
INSERT INTO over.axis (axis_id, geom, width, level) VALUES (6, 'SRID=2154;LINESTRING(650050 6860050, 650380 6860050)', 6, 2);
UPDATE over.axis SET geom = ST_SetPoint(geom, 1, ST_EndPoint(ST_Translate(geom, 0, -60))) WHERE axis_id = 3;
UPDATE over.axis SET level = 3 WHERE axis_id = 1;
DELETE FROM over.axis WHERE axis_id = 2;
ALTER TABLE fresh.axis DISABLE TRIGGER USER;
INSERT INTO fresh.axis SELECT * FROM over.axis;
ALTER TABLE fresh.axis ENABLE TRIGGER USER;
SELECT 'a first run gives each overpass', sum(inserted) FILTER (WHERE relation = 'overpass') = (SELECT count(*) FROM over.overpass) FROM streetgen.generate('fresh');
SELECT 'edits and scratch agree', test.same('over', 'fresh');
SELECT 'an axis that is gone takes its overpasses along', count(*) = 0 FROM who WHERE 2 IN (above, below);

-- Random lines of random levels, beside crossings counted by PostGIS.
INSERT INTO random.axis (geom, width, level)
SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 900 * random(), 6860000 + 900 * random()), ST_MakePoint(650000 + 900 * random(), 6860000 + 900 * random())), 2154), 6, (random() * 3)::integer
FROM generate_series(1, 60);
SELECT 'as many overpasses as PostGIS counts crossings of edges without a node', (SELECT count(*) FROM random.overpass) = (SELECT count(*) FROM random.edge a JOIN random.edge b ON a.edge_id < b.edge_id AND ST_Intersects(a.geom, b.geom)
    WHERE NOT ARRAY[a.from_node, a.to_node] && ARRAY[b.from_node, b.to_node]) AND (SELECT count(*) > 100 FROM random.overpass);
SELECT 'the higher level is above', bool_and(a.level > b.level) FROM random.overpass o JOIN random.edge a ON a.edge_id = o.edge_above JOIN random.edge b ON b.edge_id = o.edge_below WHERE a.level <> b.level;
SELECT 'no edge passes over itself by a way round', NOT EXISTS (
    WITH RECURSIVE up(low, high) AS (SELECT edge_below, edge_above FROM random.overpass UNION SELECT low, edge_above FROM up JOIN random.overpass ON edge_below = high)
    SELECT FROM up WHERE low = high);
DROP VIEW who;
SELECT test.switch_off('over', 'overpass') \g /dev/null
SELECT 'switched off, the table is gone', to_regclass('over.overpass') IS NULL AND to_regclass('over.overpass_editing') IS NULL;
