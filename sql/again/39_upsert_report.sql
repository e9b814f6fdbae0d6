-- The one statement, what the network step noticed: rows without an id, equal or not.

CREATE OR REPLACE FUNCTION streetgen._upsert_report(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._filled($part$
new_report AS MATERIALIZED (
    SELECT DISTINCT issue, axis_a, axis_b, measure, geom FROM streetgen._computed_report((SELECT streets FROM computed))
    WHERE {whole} OR axis_a IN (SELECT axis_id FROM asked_axis)),
old_report AS MATERIALIZED (
    SELECT issue, axis_a, axis_b, measure, geom, ctid AS place FROM {model}.report
    WHERE {whole} OR axis_a = ANY (ARRAY(SELECT axis_id FROM asked_axis))),
set_report AS (
    INSERT INTO {model}.report (issue, axis_a, axis_b, measure, geom)
    SELECT issue, axis_a, axis_b, measure, geom FROM new_report EXCEPT SELECT issue, axis_a, axis_b, measure, geom FROM old_report RETURNING 1),
gone_report AS (
    DELETE FROM {model}.report WHERE ctid = ANY (ARRAY(
        SELECT place FROM old_report o WHERE NOT EXISTS (
            SELECT FROM new_report n WHERE (n.issue, n.axis_a, n.axis_b, n.measure, n.geom) = (o.issue, o.axis_a, o.axis_b, o.measure, o.geom))))
    RETURNING 1),
count_report AS (
    SELECT 'report', (SELECT count(*) FROM set_report), 0::bigint, (SELECT count(*) FROM gone_report),
           (SELECT count(*) FROM new_report) - (SELECT count(*) FROM set_report), 0::bigint)$part$, places) $$;
COMMENT ON FUNCTION streetgen._upsert_report(jsonb) IS 'Part of the one statement: the reports of asked axes.';
