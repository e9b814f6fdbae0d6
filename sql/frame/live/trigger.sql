-- Live: statement triggers by which the streets follow their axes.

CREATE OR REPLACE FUNCTION streetgen._live(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN coalesce(current_setting('streetgen.live', true), '') <> 'off'
        AND (SELECT tgenabled <> 'D' FROM pg_trigger WHERE tgrelid = format('%I.axis', model)::regclass
            AND tgname = 'z_follow_update');
END $$;
COMMENT ON FUNCTION streetgen._live(name) IS
    'Do the streets of a model follow its axes: is streetgen.live on, and setting streetgen.live of the transaction '
    'not off (importers)?';

CREATE OR REPLACE FUNCTION streetgen._is_followed(model name, relation name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._live(model) OR NOT streetgen._is_hashed(relation) $$;
COMMENT ON FUNCTION streetgen._is_followed(name, name) IS
    'Does something follow an edit of a table of decisions: the streets, or the mark that axes are stale?';

CREATE OR REPLACE FUNCTION streetgen._pause() RETURNS void
    LANGUAGE sql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT set_config('streetgen.live', 'off', true) $$;
COMMENT ON FUNCTION streetgen._pause() IS 'For importers: what this transaction changes is for generate to follow.';

CREATE OR REPLACE FUNCTION streetgen._first_in_statement(told text, model name) RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    variable constant text := 'streetgen.told_' || told;
    now_told constant text := statement_timestamp()::text;
    -- The statement, and the models that were told in it.
    known text[] := nullif(current_setting(variable, true), '');
BEGIN
    IF known[1] IS DISTINCT FROM now_told THEN
        known := ARRAY[now_told];
    ELSIF model = ANY (known[2:]) THEN
        RETURN false;
    END IF;
    PERFORM set_config(variable, (known || model::text)::text, true);
    RETURN true;
END $$;
COMMENT ON FUNCTION streetgen._first_in_statement(text, name) IS
    'Whether a notice is the first of its kind about a model in what the client sent: an edit view calls its trigger '
    'for each row.';

CREATE OR REPLACE FUNCTION streetgen._update_streets(model name, changed bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    locked record;
    spreads_to bigint[];
    way_out text;
BEGIN
    PERFORM streetgen._use_model(model);
    IF changed IS NULL OR changed = '{}' THEN
        RETURN;
    ELSIF _setting_changed() THEN
        IF streetgen._first_in_statement('settings', model) THEN
            RAISE NOTICE 'settings of model "%" changed: its streets follow again after SELECT * FROM '
                'streetgen.generate(%, wait => true)', model, quote_literal(model);
        END IF;
        RETURN;
    END IF;
    LOOP
        -- Where the change goes on beyond the axes written all is given back, rows and locks: who waits for more places
        -- holds none.
        BEGIN
            locked := streetgen._lock_places(model, changed, wait => true);
            PERFORM FROM streetgen._upsert_part(model, locked.written, locked.gathered, locked.changed,
                edit => true);
            EXIT;
        EXCEPTION WHEN SQLSTATE 'SG001' THEN
            GET STACKED DIAGNOSTICS spreads_to = PG_EXCEPTION_HINT;
            IF streetgen._holds_all(changed, spreads_to) THEN
                RAISE;
            END IF;
            changed := changed || spreads_to;
        WHEN lock_not_available OR deadlock_detected THEN
            GET STACKED DIAGNOSTICS way_out = PG_EXCEPTION_HINT;
            PERFORM streetgen._refuse_wait(model, CASE SQLSTATE WHEN '55P03' THEN way_out END);
            RAISE;
        END;
    END LOOP;
    PERFORM pg_notify('qgis', model);
END $$;
COMMENT ON FUNCTION streetgen._update_streets(name, bigint[]) IS
    'Brings the streets of a model up to date with axes that changed; tells QGIS.';

CREATE OR REPLACE FUNCTION streetgen._drop_results(model name, gone bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    locked record;
    drop name;
BEGIN
    PERFORM streetgen._use_model(model);
    IF gone IS NULL OR gone = '{}' THEN
        RETURN;
    END IF;
    PERFORM streetgen._lock_model(model, wait => true, alone => false);
    locked := streetgen._lock_places(model, gone, wait => true);
    FOR drop IN SELECT format('_drop_%s_rows', s) FROM unnest(streetgen._subjects(model)) s LOOP
        IF to_regprocedure(format('streetgen.%I(name, bigint[])', drop)) IS NOT NULL THEN
            EXECUTE format('SELECT streetgen.%I($1, $2)', drop) USING model, gone;
        END IF;
    END LOOP;
    WITH gone AS (DELETE FROM edge WHERE axis_id = ANY (gone) RETURNING edge_id, from_node, to_node),
         report AS (DELETE FROM report WHERE axis_a = ANY (gone) OR axis_b = ANY (gone)),
         stale AS (UPDATE edge SET input_hash = 0 WHERE axis_id = ANY (locked.written) AND axis_id <> ALL (gone))
    DELETE FROM node WHERE node_id IN (SELECT from_node FROM gone UNION SELECT to_node FROM gone)
        AND NOT EXISTS (SELECT FROM edge e WHERE e.from_node = node_id AND e.axis_id <> ALL (gone))
            AND NOT EXISTS (SELECT FROM edge e WHERE e.to_node = node_id AND e.axis_id <> ALL (gone));
END $$;
COMMENT ON FUNCTION streetgen._drop_results(name, bigint[]) IS
    'Removes the results of axes that are gone and marks what is around them as stale.';

CREATE OR REPLACE FUNCTION streetgen._mark_stale(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    -- Finding the places of more axes takes longer than all places are worth.
    most_locked constant integer := 64;
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes = '{}' THEN
        RETURN;
    END IF;
    PERFORM streetgen._lock_model(model, wait => true, alone => false);
    -- A run under way there does not see what is written here.
    IF cardinality(axes) > most_locked THEN
        PERFORM streetgen._lock_all_places(model);
    ELSE
        PERFORM FROM streetgen._lock_places(model, axes, wait => true);
    END IF;
    UPDATE edge SET input_hash = 0 WHERE axis_id = ANY (axes);
END $$;
COMMENT ON FUNCTION streetgen._mark_stale(name, bigint[]) IS
    'Marks axes as stale, for what their input_hash does not see: turn restrictions and other decisions that nobody '
    'follows. Locks their places until the transaction ends; of more than 64 axes, all places of the '
    'model.';

CREATE OR REPLACE FUNCTION streetgen._begin_edit(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF current_setting('lock_timeout') = '0' THEN
        PERFORM set_config('lock_timeout', value || 's', true) FROM setting
            WHERE name = 'lock_timeout';
    END IF;
    -- TRUNCATE takes its table before it enters: who entered must not wait for it.
    LOCK TABLE override_place IN ACCESS SHARE MODE;
    PERFORM streetgen._lock_model(model, wait => true, alone => false);
END $$;
COMMENT ON FUNCTION streetgen._begin_edit(name) IS
    'Before an edit: setting lock_timeout where the session has none, and the model locked beside other editors.';

CREATE OR REPLACE FUNCTION streetgen._make_triggers(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
    former regclass;
BEGIN
    PERFORM streetgen._use_model(model);
    -- In the model's schema and with its owner's rights: an editor writes axes and overrides, nothing else.
    CREATE OR REPLACE FUNCTION _begin_edit() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        PERFORM streetgen._require_one_build();
        -- A schema of another name, a copy or one that came back, that nobody adopted yet.
        IF TG_TABLE_SCHEMA <> current_schema() OR NOT EXISTS (SELECT FROM streetgen.model
            WHERE name = current_schema()) THEN
            PERFORM streetgen._require_model(TG_TABLE_SCHEMA);
        END IF;
        IF coalesce(current_setting('streetgen.live', true), '') <> 'off' OR
            streetgen._keys_are_missing(current_schema()) THEN
            PERFORM streetgen._begin_edit(current_schema());
        END IF;
        IF TG_OP = 'TRUNCATE' AND TG_TABLE_NAME <> 'axis' AND streetgen._is_followed(current_schema(), TG_TABLE_NAME)
            THEN
            -- Rows that go are known only before: as if deleted.
            EXECUTE format('DELETE FROM %I.%I', TG_TABLE_SCHEMA, TG_TABLE_NAME);
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE FUNCTION _follow_override() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        live constant boolean := streetgen._live(current_schema());
        remapped constant bigint[] := streetgen._remapped(current_schema());
        changed jsonb[];
        named bigint[];
    BEGIN
        IF NOT streetgen._is_followed(current_schema(), TG_TABLE_NAME) THEN
            RETURN NULL;
        ELSIF TG_OP = 'INSERT' THEN
            changed := ARRAY(SELECT to_jsonb(n) FROM new_override n);
        ELSIF TG_OP = 'DELETE' THEN
            changed := ARRAY(SELECT to_jsonb(o) FROM old_override o);
        ELSE
            changed := ARRAY(SELECT to_jsonb(o) FROM (SELECT * FROM old_override EXCEPT SELECT * FROM new_override) o
                UNION ALL SELECT to_jsonb(n) FROM (SELECT * FROM new_override EXCEPT SELECT * FROM old_override) n);
        END IF;
        named := ARRAY(SELECT DISTINCT a.axis_id FROM unnest(changed) c
            CROSS JOIN unnest(TG_ARGV) role
            JOIN axis a ON a.axis_id = (c ->> role)::bigint);
        -- A room tells which axes a decision on ground or about a ring is about.
        IF to_regprocedure(format('streetgen._axes_of_%s(name, jsonb[])', TG_TABLE_NAME)) IS NOT NULL THEN
            IF live THEN
                -- A street that comes there at the same time is seen, or sees this.
                PERFORM streetgen._lock_ground(current_schema(), ARRAY(
                    SELECT ST_SetSRID(ST_GeomFromGeoJSON(c ->> 'geom'), m.srid)
                    FROM unnest(changed) c, streetgen.model m
                    WHERE m.name = current_schema() AND c ->> 'geom' IS NOT NULL));
            END IF;
            EXECUTE format('SELECT $1 || streetgen.%I($2, $3)', '_axes_of_' || TG_TABLE_NAME) INTO named
                USING named, current_schema(), changed;
        END IF;
        IF live AND remapped IS NOT NULL THEN
            PERFORM streetgen._note_remapped(current_schema(), remapped || named);
        ELSIF live THEN
            PERFORM streetgen._update_streets(current_schema(), named);
        ELSE
            PERFORM streetgen._mark_stale(current_schema(), named);
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_begin_edit()', 'Before an edit: locks the model beside other editors'),
            streetgen._own_function(model, '_follow_override()', 'After an edit of overrides: the streets follow');
    FOREACH relation IN ARRAY streetgen._street_input(model) LOOP
        PERFORM streetgen._execute_each(ARRAY['CREATE OR REPLACE TRIGGER a_enter BEFORE INSERT OR UPDATE OR DELETE OR '
            'TRUNCATE ON %1$I.%2$I FOR EACH STATEMENT EXECUTE FUNCTION %1$I._begin_edit()',
            'COMMENT ON TRIGGER a_enter ON %1$I.%2$I IS ''Locks the model beside other editors'''], model, relation);
    END LOOP;
    PERFORM streetgen._make_statement_triggers(model, 'axis', 'z_follow', '{insert,update,delete,truncate}',
            '_follow_axis()', 'old_axis', 'new_axis', 'The streets follow'),
        streetgen._make_statement_triggers(model, d.relation, 'z_follow', '{insert,update,delete}',
            format('_follow_override(%s)', (SELECT string_agg(quote_literal(role), ', ') FROM unnest(d.axes) role)),
            'old_override', 'new_override', 'The streets follow') FROM streetgen._decisions_of(model) d;
    -- Tables of decisions of older builds have one for TRUNCATE, too.
    FOR former IN SELECT tgrelid::regclass FROM pg_trigger WHERE tgname = 'z_follow_truncate'
        AND tgfoid = '_follow_override()'::regprocedure LOOP
        EXECUTE format('DROP TRIGGER z_follow_truncate ON %s', former);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_triggers(name) IS
    'Makes the triggers by which the streets of a model follow its axes and overrides.';

CREATE OR REPLACE FUNCTION streetgen._make_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._make_setting_changed(model),
        streetgen._call_rooms('_make_%s_functions', model, streetgen._rooms()),
        streetgen._make_chain_keys(model), streetgen._make_change_reach(model), streetgen._make_reach(model),
        streetgen._make_upsert(model), streetgen._make_update_groups(model),
        streetgen._make_triggers(model), streetgen._make_refusals(model),
        streetgen._make_marks_by_hand(model), streetgen._make_own_keys(model);
END $$;
COMMENT ON FUNCTION streetgen._make_functions(name) IS 'Makes the functions and triggers of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._stale_axes(model name) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    stale bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    WITH generated AS (SELECT axis_id, bool_or(e.input_hash <> u.input_hash OR e.setting_hash <> u.setting_hash) AS
        changed
        FROM edge e JOIN axis_used u USING (axis_id) GROUP BY axis_id)
    SELECT count(*) FROM axis a LEFT JOIN generated g USING (axis_id)
    WHERE g.changed OR g.axis_id IS NULL AND NOT EXISTS (SELECT FROM report r WHERE r.axis_a = a.axis_id
        AND r.issue IN ('collapsed_axis', 'axis lies on another')) INTO stale;
    RETURN stale;
END $$;
COMMENT ON FUNCTION streetgen._stale_axes(name) IS
    'How many axes of a model changed, or came, since their streets were computed.';

CREATE OR REPLACE FUNCTION streetgen.live(model name, live boolean) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    trigger record;
    stale bigint;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('live', live::text);
    FOR trigger IN SELECT tgrelid::regclass AS relation, tgname AS name FROM pg_trigger
        JOIN pg_class c ON c.oid = tgrelid
        -- Triggers that delete the results of an axis with it, or mark axes as stale, stay on.
        WHERE relnamespace = quote_ident(model)::regnamespace AND tgname LIKE 'z\_follow\_%'
            AND NOT (relname = 'axis' AND tgname = 'z_follow_delete')
            AND (live OR streetgen._is_hashed(relname) IS NOT FALSE)
            AND (tgenabled <> 'D') <> live
    LOOP
        EXECUTE format('ALTER TABLE %s %s TRIGGER %I', trigger.relation, CASE WHEN live THEN 'ENABLE'
            ELSE 'DISABLE' END, trigger.name);
    END LOOP;
    stale := streetgen._stale_axes(model);
    IF stale > 0 AND live THEN
        RAISE NOTICE '% axes of model "%" are stale: SELECT * FROM streetgen.generate(%, wait => true)', stale, model,
            quote_literal(model);
    END IF;
    RETURN stale;
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.live(name, boolean) IS
    'Switches on or off that the streets of a model follow each edit, for bulk loads, once edits under way have '
    'ended; returns how many axes are stale, for generate to bring up to date. Off, deleting an axis still removes '
    'its results. A lock_timeout that ends: 55P03, naming who holds the model. Needs the rights of its owner (42501).';

CREATE OR REPLACE FUNCTION streetgen.activity(model name)
    RETURNS TABLE(pid integer, who name, application text, since timestamptz, holds text, waits_for integer[],
        query text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_reader(model);
    RETURN QUERY
    SELECT l.pid, a.usename, a.application_name, a.xact_start,
           CASE WHEN bool_or(l.granted AND l.objid = 0 AND l.mode = 'ExclusiveLock') THEN 'the whole model'
                WHEN bool_or(l.granted AND l.objid = 4294967295 AND l.mode = 'ExclusiveLock') THEN 'all places'
                WHEN bool_or(l.granted AND l.objid = 2147483648 AND l.mode = 'ExclusiveLock')
                    THEN 'all places that were free'
                WHEN bool_or(l.granted AND l.mode = 'ShareRowExclusiveLock') THEN 'the settings'
                -- Keys of cells, districts, axes and chains.
                ELSE format('%s places', count(*) FILTER (WHERE l.granted AND l.locktype = 'advisory'
                    AND l.mode = 'ExclusiveLock' AND l.objid <> 0)) END,
           pg_blocking_pids(l.pid), a.query
    FROM pg_locks l LEFT JOIN pg_stat_activity a ON a.pid = l.pid
    WHERE l.database = (SELECT oid FROM pg_database WHERE datname = current_database()) AND CASE l.locktype
        WHEN 'advisory' THEN l.objsubid = 2
            AND l.classid = (hashtext('streetgen.' || activity.model)::bigint & 4294967295)::oid
        WHEN 'relation' THEN l.relation = (SELECT c.oid FROM pg_class c JOIN pg_namespace n ON n.oid = relnamespace
            WHERE (nspname, relname) = (model, 'setting')) AND l.mode IN ('ShareLock', 'ShareRowExclusiveLock') END
    GROUP BY l.pid, a.usename, a.application_name, a.xact_start, a.query ORDER BY a.xact_start, l.pid;
END $$;
COMMENT ON FUNCTION streetgen.activity(name) IS
    'Who computes or edits a model or changes its settings now: a row per session with what it holds and the sessions '
    'it waits for. Of a call that takes seconds, application says how far it is: the step that computes and the share '
    'of it that is done, or that rows are read or written. What others run is shown as PostgreSQL shows it '
    '(pg_read_all_stats).';
