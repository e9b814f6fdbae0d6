-- see record_check, summary
UPDATE town.axis SET kind = 'boreen' WHERE name = 'mill lane';
SELECT severity, rule, relation, id FROM streetgen.check_model('town');
