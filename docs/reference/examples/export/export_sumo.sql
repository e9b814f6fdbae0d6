-- argument part: nodes, edges, connections or types
-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, export_symuvia
SELECT ordinality, left(line, 70) AS begins_with FROM streetgen.export_sumo('town', 'connections', '{"precision": 3}') LIMIT 4;
