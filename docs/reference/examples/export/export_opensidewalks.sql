-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, walk_links
SELECT ordinality, left(line, 100) AS begins_with FROM streetgen.export_opensidewalks('walked') ORDER BY ordinality LIMIT 3;
