-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, export_sumo
SELECT ordinality, left(line, 70) AS begins_with FROM streetgen.export_symuvia('town') ORDER BY ordinality LIMIT 4;
