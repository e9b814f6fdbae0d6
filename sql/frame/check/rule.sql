-- Rules of checks have words here: rooms add those of theirs in their files check.sql.

CREATE TABLE streetgen.check_rule (rule text PRIMARY KEY, meaning text NOT NULL, hint text NOT NULL,
    least_is_worst boolean NOT NULL DEFAULT false);
COMMENT ON TABLE streetgen.check_rule IS
    'What each rule of streetgen.check_model means and what to do, and so of the issues of table report';
COMMENT ON COLUMN streetgen.check_rule.rule IS 'rule, or issue of a report';
COMMENT ON COLUMN streetgen.check_rule.meaning IS 'what it finds';
COMMENT ON COLUMN streetgen.check_rule.hint IS 'the way out; names of functions and columns stand between `';
COMMENT ON COLUMN streetgen.check_rule.least_is_worst IS
    'is the finding with the least measure the worst, as of narrow lanes? Else it is the one with the greatest';
GRANT SELECT ON streetgen.check_rule TO PUBLIC;
