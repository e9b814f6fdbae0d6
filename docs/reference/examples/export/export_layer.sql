-- argument wgs84: geometry in WGS 84 (EPSG 4326) instead of the reference of the model
-- see svg
SELECT layer, geometry_type FROM streetgen.export_layer('town');
