-- The log of edits, on request: a row per statement says who edited what, when and where.

CREATE OR REPLACE FUNCTION streetgen._make_edit_log(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
    logger text;
BEGIN
    PERFORM streetgen._use_model(model);
    -- With its owner's rights: an editor cannot write the log by hand.
    CREATE OR REPLACE FUNCTION _log_edit() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        edited bigint := 1;
        box box2d;
    BEGIN
        -- Somebody may have written the setting himself.
        IF (SELECT value FROM setting WHERE name = 'log') IS DISTINCT FROM 'on' THEN
            RETURN NULL;
        ELSIF TG_OP = 'INSERT' THEN
            SELECT count(*), ST_Extent(geom) INTO edited, box FROM after;
        ELSIF TG_OP = 'DELETE' THEN
            SELECT count(*), ST_Extent(geom) INTO edited, box FROM before;
        ELSIF TG_OP = 'UPDATE' THEN
            SELECT count(*), ST_Extent(geom) INTO edited, box FROM (SELECT geom FROM before
                UNION ALL SELECT geom FROM after) e;
        END IF;
        IF edited > 0 THEN
            INSERT INTO edit_log (began, at, who, relation, action, extent)
                VALUES (transaction_timestamp(), clock_timestamp(),
                    coalesce(nullif(current_setting('role'), 'none'), session_user),
                    TG_TABLE_NAME, lower(TG_OP), ST_SetSRID(ST_Expand(box::geometry, 1),
                    (SELECT m.srid FROM streetgen.model m WHERE m.name = current_schema())));
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_log_edit()', 'After an edit: writes the log');
    IF (SELECT value FROM setting WHERE name = 'log') IS DISTINCT FROM 'on' THEN
        FOR logger IN SELECT format('%I ON %s', tgname, tgrelid::regclass) FROM pg_trigger
            WHERE tgfoid = '_log_edit()'::regprocedure LOOP
            EXECUTE 'DROP TRIGGER ' || logger;
        END LOOP;
        RETURN;
    END IF;
    FOREACH relation IN ARRAY streetgen._street_input(model) LOOP
        PERFORM streetgen._make_statement_triggers(model, relation, 'log', '{insert,update,delete,truncate}',
            '_log_edit()', 'before', 'after', 'Writes the log');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_edit_log(name) IS
    'Makes the triggers that write edit_log where setting log is on; where it is off, tables have none.';

CREATE OR REPLACE FUNCTION streetgen._make_frame_views(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE streetgen._fill_template(streetgen._part('activity'), jsonb_build_object('srid', srid));
    COMMENT ON VIEW activity IS 'What each transaction edited, from edit_log, which setting log fills';
    COMMENT ON COLUMN activity.activity_id IS 'key: the first of its rows in edit_log';
    COMMENT ON COLUMN activity.began IS 'when the transaction began';
    COMMENT ON COLUMN activity.ended IS 'when its last statement was done';
    COMMENT ON COLUMN activity.who IS 'the role that edited';
    COMMENT ON COLUMN activity.statements IS 'number of its statements';
    COMMENT ON COLUMN activity.relations IS 'tables that were edited';
    COMMENT ON COLUMN activity.extent IS 'box around what was edited; NULL: nothing known of the place';
END $$;
COMMENT ON FUNCTION streetgen._make_frame_views(name, integer) IS 'Makes view activity of a model.';

CREATE OR REPLACE FUNCTION streetgen._hold_street_input(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tables constant text := (SELECT string_agg(format('%I.%I', model, relation), ', ')
        FROM unnest('setting'::name || streetgen._street_input(model)) relation);
    patience constant interval := (SELECT setting || ' ms' FROM pg_settings WHERE name = 'lock_timeout');
    since constant timestamptz := clock_timestamp();
BEGIN
    LOOP
        -- All at once or none: who waited for one with others in hand would stop edits, and some for ever.
        BEGIN
            EXECUTE 'LOCK TABLE ' || tables || ' IN ACCESS EXCLUSIVE MODE NOWAIT';
            RETURN;
        EXCEPTION WHEN lock_not_available THEN
            IF patience > interval '0' AND clock_timestamp() - since > patience THEN
                RAISE;
            END IF;
        END;
        PERFORM pg_sleep(0.1);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._hold_street_input(name) IS
    'Takes the settings, axes and decisions of a model for itself until the transaction ends, once nobody reads or '
    'writes any of them. It stops nobody meanwhile. A lock_timeout that ends: 55P03.';
