-- argument schema: the schema that holds the tables of a model
-- see create_model
ALTER SCHEMA town RENAME TO village;
SELECT streetgen.adopt_model('village');
SELECT name, srid FROM streetgen.model;
