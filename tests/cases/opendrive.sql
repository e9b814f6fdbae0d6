-- A file of OpenDRIVE of model :model shall hold so much: how many lanes and how many movements, parted by a space. Edges inside a place are no roads.
SELECT (SELECT count(*) FROM :"model".lane WHERE edge_id NOT IN (SELECT streetgen._edges_inside(options))) || ' ' || (SELECT count(*) FROM streetgen._connecting_ways(:'model', options))
FROM streetgen._begin_export(:'model', 'opendrive', 'interconnection', '{}') options;
