-- argument topology: name of the new topology of level 0
-- see import_topology
CREATE EXTENSION IF NOT EXISTS postgis_topology;
SELECT name, level, nodes, edges, doubled FROM streetgen.export_topology('town', 'town_topology');
