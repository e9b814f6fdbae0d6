-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_cityjson, export_option, road_mesh
SELECT ordinality, length(part) > 0 AS bytes, left(encode(part, 'escape'), 4) AS begins_with FROM streetgen.export_gltf('town') ORDER BY ordinality LIMIT 1;
