-- The cross-sections of a real model, which has every subject here. Variable: model. Each row is a truth: its name, and t where it holds.
SELECT count(*) FROM unnest('{sidewalk,object}'::text[]) subject, streetgen.switch_subject(:'model', subject, true) \g /dev/null
SELECT name, holds FROM test.cross_section(:'model');
