-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_gltf, export_option
SELECT DISTINCT path FROM streetgen.export_tiles('town') ORDER BY path;
