CREATE TYPE streetgen.finding AS (severity text, rule text, relation text, id bigint, measure float8, geom geometry);
COMMENT ON TYPE streetgen.finding IS
    'A row of streetgen.check_model: the rule that says so, and the row of a table that it is about.';
COMMENT ON COLUMN streetgen.finding.severity IS 'error, warning or notice';
COMMENT ON COLUMN streetgen.finding.rule IS 'what is found';
COMMENT ON COLUMN streetgen.finding.relation IS 'the table';
COMMENT ON COLUMN streetgen.finding.id IS 'the key of its row';
COMMENT ON COLUMN streetgen.finding.measure IS 'how large, in the unit that the rule names';
COMMENT ON COLUMN streetgen.finding.geom IS 'where';
