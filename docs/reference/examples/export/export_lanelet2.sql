-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, export_opendrive
SELECT ordinality, left(line, 70) AS begins_with FROM streetgen.export_lanelet2('town') ORDER BY ordinality LIMIT 4;
