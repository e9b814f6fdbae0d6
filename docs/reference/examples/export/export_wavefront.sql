-- argument part: objects or materials
-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_gltf, export_option, road_mesh
SELECT line FROM streetgen.export_wavefront('town', 'objects') ORDER BY ordinality LIMIT 4;
