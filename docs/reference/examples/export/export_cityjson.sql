-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, export_gltf, road_mesh
SELECT ordinality, left(line, 60) AS begins_with FROM streetgen.export_cityjson('town') ORDER BY ordinality LIMIT 3;
