\set ECHO none
\ir shared/truths.sql
-- Ids of nodes and edges: what keeps them through moves, merges and splits.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 32631) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, 'SRID=32631;LINESTRING(0 0,100 0)', 6), (2, 'SRID=32631;LINESTRING(100 0,200 0)', 6), (3, 'SRID=32631;LINESTRING(100 0,100 80)', 6), (4, 'SRID=32631;LINESTRING(110 0,110 -80)', 6);
CREATE FUNCTION pg_temp.node_at(x float8, y float8) RETURNS bigint LANGUAGE sql AS $$ SELECT node_id FROM town.node WHERE ST_DWithin(geom, ST_SetSRID(ST_MakePoint(x, y), 32631), 0.01) $$;
CREATE FUNCTION pg_temp.moved(statement text, axes bigint[]) RETURNS void LANGUAGE plpgsql AS $$ BEGIN EXECUTE statement; PERFORM streetgen.generate('town', axes); END $$;
SELECT streetgen.generate('town') \g /dev/null
CREATE TABLE old_node AS SELECT pg_temp.node_at(0, 0) AS west, pg_temp.node_at(100, 0) AS middle, pg_temp.node_at(200, 0) AS east, pg_temp.node_at(100, 80) AS north, pg_temp.node_at(110, 0) AS side;
CREATE TABLE old_edge AS SELECT axis_id, from_node, edge_id FROM town.edge;
SELECT 'the side street cuts the second axis' AS name, count(*) = 2 AND (SELECT side IS NOT NULL FROM old_node) AS holds FROM town.edge WHERE axis_id = 2;

SELECT pg_temp.moved($$UPDATE town.axis SET geom = ST_SetPoint(geom, CASE axis_id WHEN 1 THEN 1 ELSE 0 END, 'SRID=32631;POINT(100 4)') WHERE axis_id IN (1, 2, 3)$$, '{1,2,3}') \g /dev/null
SELECT 'a node that all its axes move keeps its id', pg_temp.node_at(100, 4) = middle FROM old_node;
SELECT 'edges keep theirs', NOT EXISTS (SELECT FROM old_edge o JOIN town.edge e USING (axis_id, from_node) WHERE o.edge_id <> e.edge_id) AND (SELECT count(*) FROM old_edge JOIN town.edge USING (axis_id, from_node)) >= 4;
SELECT pg_temp.moved($$UPDATE town.axis SET geom = ST_SetPoint(geom, CASE axis_id WHEN 1 THEN 1 ELSE 0 END, 'SRID=32631;POINT(100 0)') WHERE axis_id IN (1, 2, 3)$$, '{1,2,3}') \g /dev/null

-- Axis 3 leaves: two nodes; the one of the smallest axis is the old one.
SELECT pg_temp.moved($$UPDATE town.axis SET geom = 'SRID=32631;LINESTRING(60 30,100 80)' WHERE axis_id = 3$$, '{3}') \g /dev/null
SELECT 'a split: the smallest axis takes the id along', pg_temp.node_at(100, 0) = middle AND pg_temp.node_at(60, 30) NOT IN (west, middle, east, north, side) FROM old_node;
CREATE TABLE split AS SELECT pg_temp.node_at(60, 30) AS node_id;
SELECT pg_temp.moved($$UPDATE town.axis SET geom = 'SRID=32631;LINESTRING(100 0,100 80)' WHERE axis_id = 3$$, '{3}') \g /dev/null
SELECT 'a merge: the smaller id stays', pg_temp.node_at(100, 0) = middle AND middle < split.node_id AND NOT EXISTS (SELECT FROM town.node n WHERE n.node_id = split.node_id) FROM old_node, split;
SELECT 'all is as it was', (west, middle, east, north, side) = (pg_temp.node_at(0, 0), pg_temp.node_at(100, 0), pg_temp.node_at(200, 0), pg_temp.node_at(100, 80), pg_temp.node_at(110, 0)) FROM old_node;
CREATE TABLE edge_before AS SELECT axis_id, from_node, edge_id FROM town.edge;
SELECT pg_temp.moved($$UPDATE town.axis SET width = 9, importance = 2, name = 'x'$$, NULL) \g /dev/null
SELECT 'other attributes change no id', NOT EXISTS (TABLE edge_before EXCEPT SELECT axis_id, from_node, edge_id FROM town.edge);
SELECT 'the model is sound', count(*) = 0 FROM streetgen.check_model('town') WHERE severity = 'error';

-- Intersections over crossed limits are one group, from end to end of a chain; others are groups of their own.
SELECT streetgen.create_model('chain', 32631) \g /dev/null
INSERT INTO chain.axis (axis_id, geom, width) SELECT 1 + i, ST_SetSRID(ST_MakeLine(ST_MakePoint(6 * i, 0), ST_MakePoint(6 * (i + 1), 0)), 32631), 8 FROM generate_series(0, 3) i;
INSERT INTO chain.axis (axis_id, geom, width) SELECT 11 + i, ST_SetSRID(ST_MakeLine(ST_MakePoint(6 * i, 0), ST_MakePoint(6 * i, 60 * (-1) ^ i)), 32631), 5 FROM generate_series(0, 4) i;
INSERT INTO chain.axis (axis_id, geom, width) VALUES (20, 'SRID=32631;LINESTRING(0 0,-100 0)', 8), (21, 'SRID=32631;LINESTRING(-100 0,-100 60)', 8), (22, 'SRID=32631;LINESTRING(-100 0,-160 0)', 8);
SELECT streetgen.generate('chain') \g /dev/null
SELECT 'the chain has crossed limits', count(*) = 4 FROM chain.section WHERE method = 'crossed_limits';
SELECT 'the chain is one group, named by its smallest node', count(*) = 5 AND count(DISTINCT group_id) = 1 AND min(group_id) = min(node_id) FROM chain.intersection_group JOIN chain.node USING (node_id) WHERE ST_Y(geom) = 0 AND ST_X(geom) >= 0;
SELECT 'what a section parts is another', count(*) = 1 AND bool_and(group_id = node_id) FROM chain.intersection_group JOIN chain.node USING (node_id) WHERE ST_X(geom) = -100 AND ST_Y(geom) = 0;
SELECT 'each intersection has one row', (SELECT count(*) FROM chain.intersection_group) = (SELECT count(*) FROM chain.intersection);

SELECT 'ids are listed by the numbers of their rows, 0 where there is none', streetgen._ids(number, id) = '{70,0,30,50}' FROM (VALUES (4, 50::bigint), (1, 70), (3, 30)) v(number, id);
SELECT 'of no rows there is no list', streetgen._ids(number, number) IS NULL FROM generate_series(1, 0) number;
SELECT 'a long list is whole', streetgen._ids(number, 2 * number) = array_agg(2::bigint * number ORDER BY number) FROM generate_series(1, 1000) number;
SELECT 'a number below 1 is refused', test.state('SELECT streetgen._ids(0, 1)') = '22023';
