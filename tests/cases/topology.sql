-- A real model's network to topologies and back: psql -v model=NAME, after tests/sql/shared.  Rows (name, holds).
CREATE EXTENSION postgis_topology;
SELECT streetgen.set(:'model', 'crossing', 'split') \g /dev/null
SELECT streetgen.generate(:'model') \g /dev/null
CREATE TEMPORARY TABLE made AS SELECT * FROM streetgen.export_topology(:'model', 'exported');
SELECT 'ValidateTopology finds nothing', test.topology_errors(array_agg(name)) = 0 FROM made;
SELECT 'the network comes back equal', test.comes_back(:'model', array_agg(name), array_agg(level), (SELECT coalesce(array_agg(d), '{}') FROM made, unnest(doubled) d)) FROM made;
