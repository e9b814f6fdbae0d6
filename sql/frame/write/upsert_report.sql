-- The one statement, what the network step noticed, rows without an id, equal or not; and what it answers.

CREATE OR REPLACE FUNCTION streetgen._upsert_report(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('report'), places) $$;
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
    FROM streetgen._computed_table()
    WHERE key IS NOT NULL AND places -> 'subjects' ? subject
        AND subject <> ALL (streetgen._subjects_of_reach('group')) $$;
COMMENT ON FUNCTION streetgen._upsert_counts(jsonb) IS
    'End of the one statement: of each table how many rows came, changed, went and stayed, and how many of those '
    'computed have a method other than hypothesis; in the first row what moved, for groups.';

CREATE OR REPLACE FUNCTION streetgen._upsert_moved(places jsonb) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'SELECT NULL::text, NULL::bigint, NULL::bigint, NULL::bigint, NULL::bigint, NULL::bigint, '
        || CASE streetgen._parts_of_rooms('_moved_%s', places) WHEN '{}' THEN 'ARRAY[]::bigint[]'
            ELSE 'ARRAY(SELECT id FROM moved)' END $$;
COMMENT ON FUNCTION streetgen._upsert_moved(jsonb) IS
    'End of the one statement where nobody asks for counts: what moved, for groups.';

CREATE OR REPLACE FUNCTION streetgen._computed_report(streets bigint)
    RETURNS TABLE(number integer, issue text, axis_a bigint, axis_b bigint, measure float8, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_report';
COMMENT ON FUNCTION streetgen._computed_report(bigint) IS
    'What the network step noticed while it computed streets in this statement.';
