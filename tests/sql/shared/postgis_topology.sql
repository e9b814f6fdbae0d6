-- The extension postgis_topology, which an administrator makes, and what he grants to those who write topologies.
SELECT test.as_administrator(statement) FROM unnest(ARRAY['CREATE EXTENSION postgis_topology', 'GRANT USAGE ON SCHEMA topology TO public',
  'GRANT SELECT, INSERT, UPDATE, DELETE ON topology.topology, topology.layer TO public', 'GRANT USAGE ON SEQUENCE topology.topology_id_seq TO public']) statement \g /dev/null
