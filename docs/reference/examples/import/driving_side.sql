-- see create_model, import_osm, check_model
SELECT * FROM streetgen.driving_side('town');
