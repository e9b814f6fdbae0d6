-- The one statement, what the network step noticed, rows without an id, equal or not; and what it answers.

CREATE OR REPLACE FUNCTION streetgen._upsert_report(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('report'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_report(jsonb) IS
    'Part of the one statement: the reports that name a requested axis.';

CREATE OR REPLACE FUNCTION streetgen._moved_rows(places jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    queries text[] := '{}';
    room text;
BEGIN
    FOREACH room IN ARRAY streetgen._rooms() LOOP
        IF streetgen._parts_of_rooms(format('_moved_%s', room), places) <> '{}' THEN
            queries := queries || format('SELECT ROW (%L, id, ground)::streetgen.moved_row FROM moved_%s', room, room);
        END IF;
    END LOOP;
    RETURN CASE queries WHEN '{}' THEN 'ARRAY[]::streetgen.moved_row[]'
        ELSE format('ARRAY(%s)', array_to_string(queries, ' UNION ALL ')) END;
END $$;
COMMENT ON FUNCTION streetgen._moved_rows(jsonb) IS
    'The array of all that rooms say to have moved: each by id and ground of moved_ROOM, a part that it gives by its '
    'function _moved_ROOM.';

CREATE OR REPLACE FUNCTION streetgen._upsert_counts(places jsonb) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT string_agg(format('SELECT %1$L, inserted, updated, (SELECT %2$s * count(*) FROM gone_%3$s), unchanged, '
        'fallbacks, %4$s FROM count_%1$s', relation, gone_each, gone_with, CASE
            WHEN place = 1 THEN streetgen._moved_rows(places) ELSE 'NULL::streetgen.moved_row[]' END),
            E' UNION ALL\n' ORDER BY place)
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
        || streetgen._moved_rows(places) $$;
COMMENT ON FUNCTION streetgen._upsert_moved(jsonb) IS
    'End of the one statement where nobody asks for counts: what moved, for groups.';

CREATE OR REPLACE FUNCTION streetgen._computed_report(streets bigint)
    RETURNS TABLE(number integer, issue text, axis_a bigint, axis_b bigint, measure float8, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_report';
COMMENT ON FUNCTION streetgen._computed_report(bigint) IS
    'What the network step noticed while it computed streets in this statement.';
