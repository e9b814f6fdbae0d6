-- Rules of checks have words here: rooms add those of theirs in their files check.sql.

CREATE TABLE streetgen.check_rule (rule text PRIMARY KEY, meaning text NOT NULL, hint text NOT NULL);
COMMENT ON TABLE streetgen.check_rule IS
    'What each rule of streetgen.check_model means and what to do, and so of the issues of table report';
COMMENT ON COLUMN streetgen.check_rule.rule IS 'rule, or issue of a report';
COMMENT ON COLUMN streetgen.check_rule.meaning IS 'what it finds';
COMMENT ON COLUMN streetgen.check_rule.hint IS 'the way out; names of functions and columns stand between `';
GRANT SELECT ON streetgen.check_rule TO PUBLIC;
