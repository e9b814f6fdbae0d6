-- see check_model
UPDATE town.axis SET kind = 'boreen' WHERE name = 'mill lane';
SELECT streetgen.record_check('town');
SELECT rule, severity, relation, id, hint, ST_AsText(place, 1) AS place FROM town.check_result;
