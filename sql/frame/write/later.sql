-- Subjects that follow the one statement: their rows may be longer than the reach.

CREATE OR REPLACE FUNCTION streetgen._later_subjects() RETURNS text[]
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY(SELECT s.subject FROM streetgen._subject() s
        WHERE to_regprocedure(format('streetgen.%I(jsonb)', '_upsert_' || s.subject)) IS NULL ORDER BY s.place) $$;
COMMENT ON FUNCTION streetgen._later_subjects() IS
    'The subjects that no part of the one statement writes: statements of their own follow it.';

CREATE OR REPLACE FUNCTION streetgen._make_update_later(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    later constant text[] := ARRAY(SELECT s FROM unnest(streetgen._later_subjects()) WITH ORDINALITY u(s, n)
        WHERE s = ANY (streetgen._subjects(model)) ORDER BY n);
BEGIN
    PERFORM streetgen._compose_function(model, '_note_later(axes bigint[])', 'bigint[]',
        format(E'\nBEGIN\n    RETURN ARRAY[]::bigint[]%s;\nEND ',
            (SELECT string_agg(format(' || streetgen.%I(current_schema(), axes)', name), '' ORDER BY n)
            FROM unnest(later) WITH ORDINALITY u(s, n), concat('_note_', s) name
            WHERE to_regprocedure(format('streetgen.%I(name, bigint[])', name)) IS NOT NULL)),
        '_note_later(bigint[])', 'Before a run for axes: the ids that later subjects note of rows as they are',
        'STABLE');
    PERFORM streetgen._compose_function(model, '_update_later(axes bigint[], moved bigint[], noted bigint[])',
        'TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)',
        format(E'\nBEGIN\n    %s\nEND ', (SELECT coalesce(string_agg(format(
                'RETURN QUERY SELECT * FROM streetgen.%I(current_schema(), axes, moved, noted);', name), E'\n    '
                ORDER BY n), 'RETURN;')
            FROM unnest(later) WITH ORDINALITY u(s, n), concat('_update_', s) name
            WHERE to_regprocedure(format('streetgen.%I(name, bigint[], bigint[], bigint[])', name)) IS NOT NULL)),
        '_update_later(bigint[], bigint[], bigint[])',
        'After the one statement wrote rows of axes (NULL: of all): brings the later subjects up to date',
        'VOLATILE ROWS 5');
END $$;
COMMENT ON FUNCTION streetgen._make_update_later(name) IS
    'Makes the functions of a model that call functions _note_SUBJECT and _update_SUBJECT of its later subjects.';

CREATE OR REPLACE FUNCTION streetgen._update_later(model name, axes bigint[], moved bigint[] DEFAULT NULL,
    noted bigint[] DEFAULT NULL)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT * FROM _update_later(axes, moved, noted);
END $$;
COMMENT ON FUNCTION streetgen._update_later(name, bigint[], bigint[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the subjects up to date that it does not write; '
    'a row per table. moved: what the statement found to have moved. noted: the ids that later subjects noted before.';
