-- data/streetgen check shows what is wrong with a model: by rule, with the ids and the place of the worst. Variables: model, and the file for the number of errors.
-- Triggers and indexes of the owner run with his rights alone.
SELECT format('SET ROLE %s', nspowner::regrole) FROM pg_namespace WHERE nspname = :'model' \gexec
SELECT streetgen.record_check(:'model') \g /dev/null
SELECT severity, rule, relation, count(*), trim_scale(round((array_agg(measure ORDER BY turn))[1]::numeric, 2)) AS worst,
    string_agg(id::text, ', ' ORDER BY turn) FILTER (WHERE turn <= 5) || CASE WHEN count(*) > 5 THEN ', …' ELSE '' END AS ids,
    (SELECT format('%s,%s', round(ST_X(worst)), round(ST_Y(worst))) FROM (SELECT (array_agg(place ORDER BY turn))[1] AS worst) w) AS place
FROM (SELECT *, row_number() OVER (PARTITION BY severity, rule, relation ORDER BY CASE WHEN least_is_worst THEN -measure ELSE measure END DESC NULLS LAST, id) AS turn
    FROM :"model".check_result LEFT JOIN streetgen.check_rule USING (rule)) finding
GROUP BY severity, rule, relation ORDER BY severity, rule, relation;
SELECT format('model %s: %s', :'model', coalesce(string_agg(format('%s of severity %s', count, severity), ', ' ORDER BY severity), 'nothing found'))
FROM (SELECT severity, count(*) FROM :"model".check_result GROUP BY severity) s \g (tuples_only=on format=unaligned)
SELECT count(*) FROM :"model".check_result WHERE severity = 'error' \g (tuples_only=on format=unaligned) :errors
