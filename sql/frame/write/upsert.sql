-- The one statement: streets computed, matched to the rows that are there, and upserted. Each subject has a part of
-- its own: compute.sql in its room.

CREATE OR REPLACE FUNCTION streetgen._upsert_places(model name, run text, edit boolean DEFAULT false) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Rooms fill holes in the parts of others.
    SELECT places || coalesce((SELECT jsonb_object_agg(hole.key, hole.value)
        FROM unnest(streetgen._parts_of_rooms('_%s_places', places)) r, jsonb_each(r::jsonb) hole), '{}')
    FROM (SELECT jsonb_build_object('run', run, 'edit', edit, 'model', quote_ident(model),
        -- A first run by clusters leaves chains to its end.
        'subjects', (SELECT array_agg(s ORDER BY n) FROM unnest(streetgen._subjects(model)) WITH ORDINALITY u(s, n)
            WHERE run <> 'cluster' OR s <> ALL (streetgen._subjects_of_reach('chain'))),
        'quoted_model', replace(quote_ident(model), '''', ''''''), 'model_name', replace(model, '''', ''''''),
        'srid', m.srid,
        'whole', run IN ('whole', 'empty'), 'empty', run = 'empty',
        'by_key', CASE WHEN run IN ('whole', 'empty') THEN '' ELSE 'OFFSET 0' END,
        'geom_with_height', CASE m.dimension WHEN 2 THEN 'c.geom' ELSE
            format('streetgen._with_height(c.geom, (SELECT a.geom FROM %I.axis a WHERE a.axis_id = c.axis_id))',
                model) END) AS places
        FROM streetgen.model m WHERE m.name = model) p $$;
COMMENT ON FUNCTION streetgen._upsert_places(name, text, boolean) IS
    'The places of the one statement, with the subjects that the model computes. run: part (some axes of a model), '
    'cluster (axes without computed rows, beside rows that are right), whole (all axes) or empty (all axes of a model '
    'without computed rows). {edit}: of a statement that edits, which asks for no counts, and whose change '
    'stays within what is written, else that is SG001. {model}: the schema; {quoted_model}: the same between quotes; '
    '{model_name}: its name there; {srid}. {whole}: all axes are requested, {empty}: no computed row is there: true or '
    'false, which the planner takes out. {by_key}: keeps a lateral subquery apart in a run for some axes, so that '
    'each of its few rows is looked up and not joined. '
    '{geom_with_height}: c.geom, with Z from axis c.axis_id where the model has heights.';

CREATE OR REPLACE FUNCTION streetgen._upsert_statement(places jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    parts text[] := ARRAY[streetgen._upsert_input(places)];
    groups constant text[] := streetgen._subjects_of_reach('group');
    subject text;
    part text;
BEGIN
    FOR subject IN SELECT jsonb_array_elements_text(places -> 'subjects') LOOP
        CONTINUE WHEN subject = ANY (groups);
        EXECUTE format('SELECT streetgen.%I($1)', '_upsert_' || subject) INTO part USING places;
        parts := parts || part;
    END LOOP;
    parts := parts || streetgen._parts_of_rooms('_moved_%s', places);
    -- RECURSIVE: parts may name what comes below them. What is read once stands where it is read: for each part to be
    -- put there the planner looks through all of them.
    RETURN 'WITH RECURSIVE ' || array_to_string(parts || streetgen._upsert_report(places), ',') || E'\n'
        || CASE WHEN (places -> 'edit')::boolean THEN streetgen._upsert_moved(places)
            ELSE streetgen._upsert_counts(places) END;
END $$;
COMMENT ON FUNCTION streetgen._upsert_statement(jsonb) IS
    'The statement that computes streets and upserts them, of the subjects of a model and of three arrays: $1 the axes '
    'whose rows may be written, $2 those that they are computed with, $3 those that changed; of a whole model all '
    'three are NULL. Gives a row per table: relation, inserted, updated, deleted, unchanged, fallbacks, and once what '
    'a run for some axes leaves to a group (moved); of an edit only one row, with what moved.';

CREATE OR REPLACE FUNCTION streetgen._upsert_set(model name, written bigint[], gathered bigint[], changed bigint[],
    run text, edit boolean DEFAULT false)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint,
        moved streetgen.moved_row[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public SET jit = off
    -- Nothing is known of rows just computed, and tables just filled have no statistics: joins are on equal keys, by
    -- hash.
    SET enable_nestloop = off SET enable_mergejoin = off
    -- The core tells its progress here, in pg_stat_activity. Whatever happens, the name of the session comes back.
    SET application_name = 'streetgen: reading or writing rows' SET streetgen.computes = 'on'
    AS $$
DECLARE
    work_mem_before text := current_setting('work_mem');
BEGIN
    PERFORM set_config('work_mem', '64MB', true) WHERE pg_size_bytes(work_mem_before) < pg_size_bytes('64MB');
    -- An error within a loop's query does not show it whole, a thousand lines of CONTEXT.
    FOR relation, inserted, updated, deleted, unchanged, fallbacks, moved
        IN EXECUTE streetgen._upsert_statement(streetgen._upsert_places(model, run, edit))
            USING written, gathered, changed LOOP
        RETURN NEXT;
    END LOOP;
    PERFORM set_config('work_mem', work_mem_before, true);
END $$;
COMMENT ON FUNCTION streetgen._upsert_set(name, bigint[], bigint[], bigint[], text, boolean) IS
    'Computes and upserts many streets, planned for the sizes of the tables: all axes of a model (NULL; leftovers of '
    'deleted ones go), or what changed axes can change of those written, with those gathered around them. run and edit '
    'as for streetgen._upsert_places.';

CREATE OR REPLACE FUNCTION streetgen._make_upsert(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- In the model's schema, so that a session plans the statement once. Its tables are reached by their keys: no page
    -- is far; its joins stand in their order.
    PERFORM streetgen._compose_function(model,
        format('%s(written bigint[], gathered bigint[], changed bigint[])', name),
        'TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint, '
            'moved streetgen.moved_row[])',
        format(E'\n#variable_conflict use_column\nBEGIN\n    FOR relation, inserted, updated, deleted, unchanged, '
            'fallbacks, moved IN %s LOOP\n        RETURN NEXT;\n    END LOOP;\nEND ',
            streetgen._upsert_statement(streetgen._upsert_places(model, 'part', edit))),
        format('%s(bigint[], bigint[], bigint[])', name),
        'Computes and upserts what changed axes can change of the axes written, with those gathered around them; '
            || whose,
        'VOLATILE STRICT ROWS 10 SET jit = off SET enable_seqscan = off SET random_page_cost = 0.01 '
            'SET join_collapse_limit = 1 SET plan_cache_mode = force_generic_plan')
    FROM (VALUES ('_upsert', false, 'streetgen.generate calls it, and counts rows'),
        ('_upsert_edited', true, 'the triggers call it; where the change goes on beyond these axes, it is SG001'))
        made(name, edit, whose);
    CREATE OR REPLACE FUNCTION _spreads_to(axes bigint[]) RETURNS bigint[]
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
            SET enable_seqscan = off
            SET plan_cache_mode = force_generic_plan
        AS $body$
    BEGIN
        RETURN ARRAY(SELECT axis_id FROM edge WHERE axis_id = ANY (axes) AND input_hash = 0);
    END $body$;
    PERFORM streetgen._own_function(model, '_spreads_to(bigint[])',
        'Of axes that a run wrote those along which the change goes on beyond them: it left them marked as stale');
END $$;
COMMENT ON FUNCTION streetgen._make_upsert(name) IS
    'Makes the functions of a model that upsert a part of it, and tell where that was not enough.';

CREATE OR REPLACE FUNCTION streetgen._upsert_part(model name, written bigint[], gathered bigint[], changed bigint[],
    edit boolean DEFAULT false)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    -- More axes than this are worth a plan of their own.
    most_planned constant integer := 400;
    spreads_to bigint[];
    locked record;
    moved streetgen.moved_row[];
    all_moved streetgen.moved_row[] := '{}';
    noted bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    LOOP
        noted := noted || (SELECT _note_groups(written));
        IF cardinality(changed) > most_planned THEN
            FOR relation, inserted, updated, deleted, unchanged, fallbacks, moved IN SELECT *
                FROM streetgen._upsert_set(model, written, gathered, changed, 'part', edit) LOOP
                all_moved := all_moved || moved;
                RETURN NEXT;
            END LOOP;
        ELSIF edit THEN
            SELECT u.moved FROM _upsert_edited(written, gathered, changed) u INTO all_moved;
        ELSE
            FOR relation, inserted, updated, deleted, unchanged, fallbacks, moved IN SELECT *
                FROM _upsert(written, gathered, changed) LOOP
                all_moved := all_moved || moved;
                RETURN NEXT;
            END LOOP;
        END IF;
        EXIT WHEN edit;
        SELECT _spreads_to(written) INTO spreads_to;
        EXIT WHEN spreads_to = '{}';
        -- Not to wait while places are held; where others hold theirs they stay stale.
        locked := streetgen._lock_places(model, changed || spreads_to, wait => false);
        EXIT WHEN streetgen._holds_all(changed, locked.changed);
        SELECT locked.written, locked.gathered, locked.changed INTO written, gathered, changed;
    END LOOP;
    RETURN QUERY SELECT * FROM _update_groups(written, all_moved, noted);
END $$;
COMMENT ON FUNCTION streetgen._upsert_part(name, bigint[], bigint[], bigint[], boolean) IS
    'Computes and upserts what changed axes can change, by the plan of the model for few axes or by one for many; '
    'gives a row per table. Where the change goes on beyond the axes written it locks the places there as '
    'far as they are free, and begins again with the axes that lead there, which gives further rows. Of an edit that '
    'is SG001, with some of these axes as its hint, and no table has a row.';
