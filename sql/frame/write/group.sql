-- Groups: rows over the rows of many axes, by statements that follow the one that writes these.

CREATE OR REPLACE FUNCTION streetgen._make_update_groups(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    groups constant text[] := ARRAY(SELECT s FROM unnest(streetgen._subjects_of_reach('group'))
        WITH ORDINALITY u(s, n) WHERE s = ANY (streetgen._subjects(model)) ORDER BY n);
BEGIN
    PERFORM streetgen._compose_function(model, '_note_groups(axes bigint[])', 'bigint[]',
        format(E'\nBEGIN\n    RETURN ARRAY[]::bigint[]%s;\nEND ',
            (SELECT string_agg(format(' || streetgen.%I(current_schema(), axes)', name), '' ORDER BY n)
            FROM unnest(groups) WITH ORDINALITY u(s, n), concat('_note_', s) name
            WHERE to_regprocedure(format('streetgen.%I(name, bigint[])', name)) IS NOT NULL)),
        '_note_groups(bigint[])',
        'Before a run for axes: the ids of rows as they are that groups will be computed from', 'STABLE');
    PERFORM streetgen._compose_function(model, '_update_groups(axes bigint[], '
            'moved streetgen.moved_row[], noted bigint[])',
        'TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)',
        format(E'\nBEGIN\n    %s\n    %s\nEND ', (SELECT string_agg(format(
                'RETURN QUERY SELECT * FROM streetgen.%I(current_schema(), axes, moved, noted);', name), E'\n    '
                ORDER BY n)
            FROM unnest(groups) WITH ORDINALITY u(s, n), concat('_update_', s) name
            WHERE to_regprocedure(format('streetgen.%I(name, bigint[], streetgen.moved_row[], bigint[])',
                name)) IS NOT NULL),
            (SELECT string_agg(format('PERFORM streetgen.%I(current_schema(), axes);', name), E'\n    ' ORDER BY n)
            FROM unnest(streetgen._subjects(model)) WITH ORDINALITY u(s, n), concat('_settle_', s) name
            WHERE to_regprocedure(format('streetgen.%I(name, bigint[])', name)) IS NOT NULL)),
        '_update_groups(bigint[], streetgen.moved_row[], bigint[])',
        'After the one statement wrote rows of axes (NULL: of all): brings the groups up to date',
        'VOLATILE ROWS 5');
END $$;
COMMENT ON FUNCTION streetgen._make_update_groups(name) IS
    'Makes the functions of a model that call the functions _note_SUBJECT and _update_SUBJECT of its groups, and then '
    '_settle_SUBJECT of all its subjects, for what waits for groups.';

CREATE OR REPLACE FUNCTION streetgen._update_groups(model name, axes bigint[], moved streetgen.moved_row[] DEFAULT NULL,
    noted bigint[] DEFAULT NULL)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT * FROM _update_groups(axes, moved, noted);
END $$;
COMMENT ON FUNCTION streetgen._update_groups(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the groups up to date; '
    'a row per table. moved: what the statement found to have moved. noted: the ids that groups noted before.';
