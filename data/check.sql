-- data/streetgen check shows what is wrong with a model: by rule, with the ids and the place of the worst. Variables: model, and the file for the number of errors.
CREATE TEMPORARY TABLE finding AS
SELECT *, row_number() OVER (PARTITION BY severity, rule, relation ORDER BY measure DESC NULLS LAST, id) AS turn FROM streetgen.check_model(:'model');
SELECT severity, rule, relation, count(*), trim_scale(round(max(measure)::numeric, 2)) AS max,
    string_agg(id::text, ', ' ORDER BY turn) FILTER (WHERE turn <= 5) || CASE WHEN count(*) > 5 THEN ', …' ELSE '' END AS ids,
    (SELECT format('%s,%s', round(ST_X(place)), round(ST_Y(place))) FROM ST_PointOnSurface((array_agg(geom ORDER BY turn))[1]) place) AS place
FROM finding GROUP BY severity, rule, relation ORDER BY severity, rule, relation;
SELECT format('model %s: %s', :'model', coalesce(string_agg(format('%s of severity %s', count, severity), ', ' ORDER BY severity), 'nothing found'))
FROM (SELECT severity, count(*) FROM finding GROUP BY severity) s \g (tuples_only=on format=unaligned)
SELECT count(*) FROM finding WHERE severity = 'error' \g (tuples_only=on format=unaligned) :errors
