-- The subjects that a model computes are listed here, and switched on and off.

CREATE OR REPLACE FUNCTION streetgen.subject(model name)
    RETURNS TABLE(subject text, wanted boolean, needs text[], needed_by text[], tables name[], cost text,
        description text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$
DECLARE
    computed text[];
BEGIN
    PERFORM streetgen._require_reader(model);
    computed := streetgen._subjects(model);
    RETURN QUERY SELECT s.subject, s.subject = ANY (computed), s.needs,
        ARRAY(SELECT n.subject FROM streetgen._subject() n WHERE s.subject = ANY (n.needs) ORDER BY n.place),
        ARRAY(SELECT t.relation FROM streetgen._computed_table() t WHERE t.subject = s.subject ORDER BY t.place),
        s.cost, s.description
    FROM streetgen._subject() s ORDER BY s.place;
END $$;
COMMENT ON FUNCTION streetgen.subject(name) IS
    'The subjects that a model can compute, a row each: is it computed now (wanted), which subjects it needs and which '
    'need it, its tables, what it costs and what it holds. A model that does not exist: 3F000; NULL: 22004; a '
    'caller who may not read the model: 42501.';

CREATE OR REPLACE FUNCTION streetgen._make_dependents(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place text;
    in_the_way text;
BEGIN
    PERFORM streetgen._make_views(model), streetgen._make_functions(model), streetgen._make_remap(model);
    PERFORM streetgen._make_edit_views(model),
        streetgen._call_rooms('_make_%s_edit_views', model, '{axis}'::text[] || streetgen._rooms_of(model)),
        streetgen._make_edit_log(model);
EXCEPTION WHEN wrong_object_type OR invalid_table_definition THEN
    GET STACKED DIAGNOSTICS place = PG_EXCEPTION_CONTEXT;
    in_the_way := substring(place, 'CREATE OR REPLACE VIEW (?:\S+\.)?(\w+) WITH');
    IF in_the_way IS NULL THEN
        RAISE;
    END IF;
    in_the_way := format('%I.%I', model, in_the_way);
    RAISE EXCEPTION '% stands where a view of the model belongs', in_the_way USING ERRCODE = '42809',
        DETAIL = format('It is another: %s.', SQLERRM), HINT = format('If it is your own, rename it, such as by ALTER '
            'TABLE %s RENAME TO …, which takes views too; else drop it. Then repeat the call.', in_the_way);
END $$;
COMMENT ON FUNCTION streetgen._make_dependents(name) IS
    'Makes the views, functions and triggers of a model for the subjects that it computes, again and again. A table or '
    'another view by the name of a view: 42809.';

CREATE OR REPLACE FUNCTION streetgen._grant_like_axes(model name, relations oid[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    held record;
BEGIN
    FOR held IN
        SELECT DISTINCT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END AS role, privilege_type,
            made.relname AS relation
        FROM pg_class axis, aclexplode(axis.relacl), pg_class made
        WHERE axis.oid = to_regclass(format('%I.axis', model)) AND grantee <> axis.relowner
            AND made.oid = ANY (relations)
            AND (privilege_type = 'SELECT'
                OR (made.relname, privilege_type) IN (SELECT w.relation, w.privilege FROM streetgen._written() w)
                OR made.relname = ANY (streetgen._edited_tables(model))
                    AND privilege_type IN ('INSERT', 'UPDATE', 'DELETE'))
    LOOP
        EXECUTE format('GRANT %s ON %I.%I TO %s', held.privilege_type, model, held.relation, held.role);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._grant_like_axes(name, oid[]) IS
    'Who may read the axes of a model may read these tables and views of it. Who may write the axes may write the '
    'tables of overrides and objects among these, settle conflicts and record checks.';

CREATE OR REPLACE FUNCTION streetgen._switch_on(model name, subjects text[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    before constant oid[] := streetgen._relations(model);
BEGIN
    PERFORM streetgen._make_tables(model, '{kept_table,table}', streetgen._with_needs(subjects));
    PERFORM streetgen._make_dependents(model);
    PERFORM streetgen._give_to_owner(model, before);
    PERFORM streetgen._grant_like_axes(model, ARRAY(
        SELECT oid FROM unnest(streetgen._relations(model)) oid WHERE oid <> ALL (before)));
    PERFORM streetgen._grant_edit_views(model);
END $$;
COMMENT ON FUNCTION streetgen._switch_on(name, text[]) IS
    'Makes the tables and views of subjects and of those that they need, for a run to fill; those of others stay.';

CREATE OR REPLACE FUNCTION streetgen.switch_subject(model name, subject text, wanted boolean)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, skipped bigint,
        fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    computed text[];
    needing text;
    has_streets boolean;
    told boolean;
    before oid[];
BEGIN
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._check_given('subject', subject, 'wanted', wanted::text);
    PERFORM streetgen._require_words(ARRAY[subject]);
    PERFORM streetgen._lock_model(model, wait => true, alone => true);
    computed := streetgen._subjects(model);
    IF wanted = (subject = ANY (computed)) THEN
        RETURN;
    END IF;
    before := streetgen._relations(model);
    IF wanted THEN
        PERFORM streetgen._switch_on(model, ARRAY[subject]);
        EXECUTE format('SELECT EXISTS (SELECT FROM %I.edge)', model) INTO has_streets;
        IF has_streets THEN
            RETURN QUERY SELECT * FROM streetgen.generate(model, wait => true);
            -- A session that edits plans once, by the statistics that are there.
            PERFORM streetgen._analyse(made) FROM streetgen._computed_table() t,
                to_regclass(format('%I.%I', model, t.relation)) made WHERE made::oid <> ALL (before);
        END IF;
        RETURN;
    END IF;
    IF (SELECT s.always FROM streetgen._subject() s WHERE s.subject = switch_subject.subject) THEN
        RAISE EXCEPTION 'subject "%" is part of every model', subject USING ERRCODE = '0A000',
            HINT = 'A model can do without the others.';
    END IF;
    SELECT string_agg(s.subject, ', ' ORDER BY s.place) INTO needing FROM streetgen._subject() s
        WHERE switch_subject.subject = ANY (s.needs) AND s.subject = ANY (computed);
    IF needing IS NOT NULL THEN
        RAISE EXCEPTION 'subject "%" is needed by %', subject, needing USING ERRCODE = '2BP01',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, %L, false) first.', model,
                split_part(needing, ', ', 1));
    END IF;
    -- The views of the model that read these tables go with them; anything of others stands in the way.
    EXECUTE (SELECT coalesce('DROP VIEW ' || string_agg(format('%I.%I', model, v.name), ', '), 'SELECT')
        FROM (SELECT e.name FROM streetgen._edit_view(model, 0) e WHERE e.subject = switch_subject.subject
            UNION SELECT w.name FROM streetgen._subject_view() w WHERE w.subject = switch_subject.subject) v
        WHERE to_regclass(format('%I.%I', model, v.name)) IS NOT NULL);
    EXECUTE (SELECT 'DROP TABLE ' || string_agg(format('%I.%I', model, t.relation), ', ')
        FROM streetgen._computed_table() t WHERE t.subject = switch_subject.subject);
    PERFORM streetgen._make_dependents(model);
    PERFORM streetgen._give_to_owner(model, before);
    PERFORM streetgen._grant_like_axes(model, ARRAY(
        SELECT oid FROM unnest(streetgen._relations(model)) oid WHERE oid <> ALL (before)));
    -- Rows of others may have been computed from what went.
    EXECUTE (SELECT coalesce(max(query), 'SELECT false') FROM streetgen._queries_of_rooms(ARRAY[subject],
        '_%s_told_others', 'name, text[]') query) INTO told USING model, computed;
    IF told THEN
        RETURN QUERY SELECT * FROM streetgen.generate(model, wait => true);
    END IF;
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.switch_subject(name, text, boolean) IS
    'Says whether a model computes a subject. On: its tables and views are made, with those of the subjects that it '
    'needs, and filled where streets are there, which gives the rows of streetgen.generate. Off: they are dropped; '
    'what was decided by hand stays in the tables of overrides. A model that does not exist: 3F000; NULL: 22004; '
    'another word: 22023; a subject of every model: 0A000; one that another subject needs, or whose tables something '
    'of others builds on: 2BP01; not the owner of the model: 42501.';
