-- argument topology: name of the topology
-- argument level: level of the axes
-- see export_topology, import_axes
CREATE EXTENSION IF NOT EXISTS postgis_topology;
SELECT topology.CreateTopology('survey', 2154) > 0 AS made;
SELECT topology.TopoGeo_AddLineString('survey', 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)') > 0 AS added;
SELECT what, count FROM streetgen.import_topology('town', 'survey');
