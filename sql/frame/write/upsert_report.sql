-- The one statement, what the network step noticed, rows without an id, equal or not; and what it answers.

CREATE OR REPLACE FUNCTION streetgen._upsert_report(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$
new_report AS MATERIALIZED (
    SELECT DISTINCT issue, axis_a, axis_b, measure, geom FROM streetgen._computed_report((SELECT streets FROM computed))
    WHERE {whole} OR axis_a IN (SELECT axis_id FROM written_axis) OR axis_b IN (SELECT axis_id FROM written_axis)),
old_report AS MATERIALIZED (
    SELECT issue, axis_a, axis_b, measure, geom, ctid AS place FROM {model}.report
    WHERE {whole} OR axis_a = ANY (ARRAY(SELECT axis_id FROM written_axis))
        OR axis_b = ANY (ARRAY(SELECT axis_id FROM written_axis))),
set_report AS (
    INSERT INTO {model}.report (issue, axis_a, axis_b, measure, geom)
    SELECT issue, axis_a, axis_b, measure, geom FROM new_report
        EXCEPT SELECT issue, axis_a, axis_b, measure, geom FROM old_report RETURNING 1),
gone_report AS (
    DELETE FROM {model}.report WHERE ctid = ANY (ARRAY(
        SELECT place FROM old_report o WHERE NOT EXISTS (
            SELECT FROM new_report n WHERE (n.issue, n.axis_a, n.axis_b, n.measure, n.geom) = (o.issue, o.axis_a,
                o.axis_b, o.measure, o.geom))))
    RETURNING 1)$part$, places) $$;
COMMENT ON FUNCTION streetgen._upsert_report(jsonb) IS
    'Part of the one statement: the reports that name a requested axis.';

CREATE OR REPLACE FUNCTION streetgen._upsert_counts(places jsonb) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT string_agg(format('SELECT %1$L, inserted, updated, (SELECT %2$s * count(*) FROM gone_%3$s), unchanged, '
        'fallbacks, %4$s FROM count_%1$s', relation, gone_each, gone_with, CASE
            WHEN place = 1 AND streetgen._parts_of_rooms('_moved_%s', places) <> '{}' THEN 'ARRAY(SELECT id FROM moved)'
            ELSE 'NULL::bigint[]' END), E' UNION ALL\n' ORDER BY place)
        || $part$ UNION ALL
SELECT 'report', (SELECT count(*) FROM set_report), 0::bigint, (SELECT count(*) FROM gone_report),
    (SELECT count(*) FROM new_report) - (SELECT count(*) FROM set_report), 0::bigint, NULL$part$
    FROM streetgen._computed_table() LEFT JOIN unnest(streetgen._later_subjects()) later ON later = subject
    WHERE key IS NOT NULL AND places -> 'subjects' ? subject AND later IS NULL $$;
COMMENT ON FUNCTION streetgen._upsert_counts(jsonb) IS
    'End of the one statement: of each table how many rows came, changed, went and stayed, and how many of those '
    'computed have a method other than hypothesis; in the first row what moved, for later subjects.';

CREATE OR REPLACE FUNCTION streetgen._computed_report(streets bigint)
    RETURNS TABLE(number integer, issue text, axis_a bigint, axis_b bigint, measure float8, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_report';
COMMENT ON FUNCTION streetgen._computed_report(bigint) IS
    'What the network step noticed while it computed streets in this statement.';
