\set ECHO none
\ir shared/truths.sql
\ir shared/topology.sql
-- The network to PostGIS topologies and back.  Each SELECT is one truth: (name, holds).
\o /dev/null
\ir ../../data/quarter.sql
\o
DO $$ BEGIN PERFORM streetgen.generate('quarter'); END $$;
SELECT 'without postgis_topology an export is 0A000' AS name, test.state($$SELECT * FROM streetgen.export_topology('quarter', 'town')$$) = '0A000' AS holds;
SELECT 'without postgis_topology an import is 0A000', test.state($$SELECT * FROM streetgen.import_topology('quarter', 'town')$$) = '0A000';
\ir shared/postgis_topology.sql
SELECT 'a topology that does not exist is 3F000', test.state($$SELECT * FROM streetgen.import_topology('quarter', 'town')$$) = '3F000';
SELECT 'a model that does not exist is 3F000', test.state($$SELECT * FROM streetgen.export_topology('no such', 'town')$$) = '3F000';

-- Levels below and above, doubled edges, loops side by side, islands and trees within a face.
DO $$ BEGIN
  PERFORM streetgen.create_model('figure', 2154, 3);
  INSERT INTO figure.axis (axis_id, geom, level)
    SELECT id, ST_Force3DZ(ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 35), level FROM (VALUES
      (1, 'LINESTRING(0 0,300 0)', 0), (2, 'LINESTRING(300 0,300 300,0 300,0 0)', 0), (3, 'LINESTRING(0 0,60 20,40 60,0 0)', 0), (4, 'LINESTRING(0 0,-60 -20,-40 -60,0 0)', 0),
      (5, 'LINESTRING(100 100,200 100,200 200,100 200,100 100)', 0), (6, 'LINESTRING(150 150,160 150)', 0), (7, 'LINESTRING(200 200,230 230)', 0), (8, 'LINESTRING(160 150,170 160)', 0),
      (9, 'LINESTRING(0 0,300 0)', 0), (10, 'LINESTRING(300 0,400 0,400 100)', -2), (11, 'LINESTRING(400 100,300 300)', -2), (12, 'LINESTRING(400 100,500 100)', 1),
      (13, 'LINESTRING(100 100,100 60)', 0), (14, 'LINESTRING(30 250,60 250,60 280,30 280,30 250)', 0), (15, 'LINESTRING(0 300,30 250)', 0)) v(id, line, level);
  -- Two that lead one way each are two edges, though one lies on the other.
  UPDATE figure.axis SET direction = CASE axis_id WHEN 1 THEN 'direct' ELSE 'reverse' END WHERE axis_id IN (1, 9);
  PERFORM streetgen.generate('figure');
END $$;
CREATE TABLE made AS SELECT 'figure'::name AS model, * FROM streetgen.export_topology('figure', 'figure town') UNION ALL SELECT 'quarter', * FROM streetgen.export_topology('quarter', 'town');

SELECT 'a topology for each level with edges, named by its level',
       (SELECT array_agg(name ORDER BY level) = ARRAY['figure town_m2', 'figure town', 'figure town_1']::name[] FROM made WHERE model = 'figure')
   AND (SELECT array_agg(name ORDER BY level) = ARRAY['town', 'town_1']::name[] FROM made WHERE model = 'quarter');
SELECT 'ValidateTopology finds nothing: ' || model, test.topology_errors(array_agg(name)) = 0 FROM made GROUP BY model;
SELECT 'a second edge on another is named and left out', doubled = (SELECT array_agg(edge_id) FROM figure.edge WHERE axis_id = 9) FROM made WHERE name = 'figure town';
SELECT 'faces of a level: the block, two loops, two islands', faces = 5 FROM made WHERE name = 'figure town';
SELECT 'a tree within a face has it on both sides',
       (SELECT count(*) = 2 AND count(DISTINCT left_face) = 1 AND bool_and(left_face = right_face AND left_face > 0) FROM "figure town".edge_data
        JOIN figure.edge USING (edge_id) WHERE axis_id IN (6, 8));
SELECT 'the world is outside the block', (SELECT bool_and((left_face = 0) <> (right_face = 0)) FROM "figure town".edge_data JOIN figure.edge USING (edge_id) WHERE axis_id IN (1, 2));
SELECT 'a node stands in each level that has an edge there',
       (SELECT count(*) = 1 FROM figure.node n JOIN "figure town".node USING (node_id) JOIN "figure town_m2".node m USING (node_id) WHERE ST_DWithin(n.geom, 'SRID=2154;POINT(650300 6860000)', 0.01))
   AND (SELECT count(*) = 1 FROM "figure town_m2".node JOIN "figure town_1".node USING (node_id));
SELECT 'ids are the model''s', NOT EXISTS (SELECT edge_id, from_node, to_node, geom::text FROM quarter.edge WHERE level = 0 EXCEPT SELECT edge_id, start_node, end_node, geom::text FROM town.edge_data);
SELECT 'heights stay', (SELECT bool_and(ST_Z(geom) = 35) FROM "figure town".node);
SELECT 'the topology can be edited further', test.state($$SELECT topology.TopoGeo_AddLineString('town', 'SRID=2154;LINESTRING(650010 6860010,650020 6860010)')$$) = 'none';
SELECT topology.DropTopology('town') \g /dev/null
SELECT streetgen.export_topology('quarter', 'street') \g /dev/null
SELECT 'the network comes back equal: ' || model, test.comes_back(model, array_agg(CASE name WHEN 'town' THEN 'street' WHEN 'town_1' THEN 'street_1' ELSE name END), array_agg(level), (SELECT coalesce(array_agg(d), '{}') FROM made o, unnest(o.doubled) d WHERE o.model = made.model))
  FROM made GROUP BY model;

SELECT 'an existing topology is 42P06', test.state($$SELECT * FROM streetgen.export_topology('figure', 'figure town')$$) = '42P06';
SELECT format('a name of %s bytes is too long: 42622', octet_length(name)), (r).state = '42622' AND (r).said LIKE '%"' || name || '%' AND to_regnamespace(quote_ident(name)) IS NULL
  FROM (VALUES (repeat('t', 62)), (repeat('t', 64))) v(name), LATERAL (SELECT test.refusal(format($$SELECT * FROM streetgen.export_topology('quarter', %L)$$, name)) AS r) s;
SELECT streetgen.create_model('crossing', 2154) \g /dev/null
SELECT 'an empty name is refused with a hint', (r).state = '22023' AND (r).hint <> '' FROM (SELECT test.refusal($$SELECT * FROM streetgen.export_topology('quarter', '')$$) AS r) s;
SELECT 'a model without edges is 55000', test.state($$SELECT * FROM streetgen.export_topology('crossing', 'x')$$) = '55000';
INSERT INTO crossing.axis (axis_id, geom) VALUES (3, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)'), (8, 'SRID=2154;LINESTRING(650050 6859950,650050 6860050)'), (9, 'SRID=2154;LINESTRING(650300 6860000,650400 6860000)');
DO $$ BEGIN PERFORM streetgen.generate('crossing'); END $$;
SELECT 'edges that cross are 55000, both axes are named, split is the way out', test.state($$SELECT * FROM streetgen.export_topology('crossing', 'x')$$) = '55000'
   AND test.said($$SELECT * FROM streetgen.export_topology('crossing', 'x')$$) ~ 'axis 3 .*axis 8 ' AND test.hint($$SELECT * FROM streetgen.export_topology('crossing', 'x')$$) ~ 'split';
SELECT 'and nothing is made', NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = 'x') AND NOT EXISTS (SELECT FROM topology.topology WHERE name = 'x');
DO $$ BEGIN PERFORM streetgen.set('crossing', 'crossing', 'split'); PERFORM streetgen.generate('crossing'); END $$;
SELECT 'split makes it a topology', test.state($$SELECT * FROM streetgen.export_topology('crossing', 'x')$$) = 'none';
UPDATE crossing.axis SET geom = 'SRID=2154;LINESTRING(650300 6860000,650400 6860000,650350 6860050,650350 6859950)' WHERE axis_id = 9;
DO $$ BEGIN PERFORM streetgen.set('crossing', 'crossing', 'over'); DELETE FROM crossing.axis WHERE axis_id = 8; PERFORM streetgen.generate('crossing'); END $$;
SELECT 'an edge that crosses itself is 55000 and named', test.said($$SELECT * FROM streetgen.export_topology('crossing', 'y')$$) ~ 'axis 9 crosses';

-- Importing follows the topology and says what generate will join.
SELECT topology.CreateTopology('given', 2154) \g /dev/null
SELECT topology.TopoGeo_AddLineString('given', l::geometry) FROM unnest(ARRAY['SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 'SRID=2154;LINESTRING(650100.3 6860000,650200 6860000)', 'SRID=2154;LINESTRING(650000 6860000,650000 6860100)']) l \g /dev/null
SELECT streetgen.create_model('taken', 2154) \g /dev/null
CREATE TABLE told AS SELECT * FROM streetgen.import_topology('taken', 'given', 2);
SELECT 'edges are axes of the level asked for', (SELECT count(*) = 3 AND bool_and(level = 2) FROM taken.axis);
SELECT 'nodes that generate will join are named', (SELECT source_refs = '{2,3}' FROM told WHERE what LIKE 'node within the tolerance%');
DO $$ BEGIN PERFORM topology.ST_RemEdgeModFace('given', 3); END $$;
SELECT streetgen.import_topology('taken', 'given', 2) \g /dev/null
SELECT 'importing again follows the topology', (SELECT array_agg(source_ref ORDER BY source_ref) = '{1,2}' FROM taken.axis);
