-- see create_model
SELECT streetgen.drop_model('town');
SELECT count(*) AS models FROM streetgen.model;
