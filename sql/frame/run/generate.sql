-- generate: lock the places, then one set-based statement.

CREATE OR REPLACE FUNCTION streetgen.generate(model name, axes bigint[] DEFAULT NULL, wait boolean DEFAULT false)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, skipped bigint,
        fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    requested bigint[] := axes;
    whole boolean := axes IS NULL;
    locked record;
    skipped_axes bigint := 0;
    lock_timeout_before text := current_setting('lock_timeout');
BEGIN
    PERFORM streetgen._use_model(model);
    wait := coalesce(wait, false);
    IF NOT wait THEN
        -- Long enough for a table that another session makes longer, which is over at once.
        PERFORM set_config('lock_timeout', '100ms', true);
    END IF;
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._check_settings(model);
    PERFORM streetgen._check_scale(lines), streetgen._check_length(model, lines)
        FROM format('SELECT ''axis '' || axis_id AS label, geom FROM %I.axis WHERE %L::bigint[] IS NULL OR axis_id = '
            'ANY (%2$L)', model, axes) lines;
    -- TRUNCATE takes its table before it enters: who entered must not wait for it.
    LOCK TABLE override_place IN ACCESS SHARE MODE;
    IF axes IS NOT NULL THEN
        -- An id that is neither an axis nor has left rows behind is skipped.
        skipped_axes := (SELECT count(DISTINCT id) FROM unnest(requested) id);
        SELECT coalesce(array_agg(DISTINCT id), '{}') FROM unnest(requested) id
            WHERE EXISTS (SELECT FROM axis WHERE axis_id = id) OR EXISTS (SELECT FROM edge
                WHERE axis_id = id) INTO requested;
        skipped_axes := skipped_axes - cardinality(requested);
        -- All axes one by one are all axes; fewer than there are need no look at each.
        SELECT NOT EXISTS (SELECT FROM axis OFFSET cardinality(requested))
            AND NOT EXISTS (SELECT axis_id FROM axis UNION SELECT axis_id FROM edge
                EXCEPT SELECT unnest(requested)) INTO whole;
    END IF;
    IF whole AND streetgen._lock_model(model, wait, alone => true) THEN
        RETURN QUERY SELECT u.relation, u.inserted, u.updated, u.deleted, u.unchanged, CASE u.relation WHEN 'edge'
            THEN skipped_axes ELSE 0 END, u.fallbacks FROM streetgen._upsert_whole(model) u;
    ELSE
        IF requested IS NULL THEN
            SELECT ARRAY(SELECT axis_id FROM axis UNION SELECT axis_id FROM edge) INTO requested;
        END IF;
        IF streetgen._setting_changed(model) THEN
            RAISE EXCEPTION 'settings of model "%" changed since its streets were computed', model
                USING ERRCODE = '55000',
                HINT = format('SELECT * FROM streetgen.generate(%L, wait => true) computes all of it: a part would '
                    'mix old and new.', model);
        END IF;
        IF streetgen._lock_model(model, wait, alone => false) THEN
            IF whole THEN
                -- Another session edits: go on beside it.
                locked := streetgen._lock_places_beside(model, NULL);
            ELSE
                locked := streetgen._lock_places(model, requested, wait);
            END IF;
            skipped_axes := skipped_axes + cardinality(requested) - cardinality(locked.requested);
        ELSE
            skipped_axes := skipped_axes + cardinality(requested);
            SELECT '{}'::bigint[] AS changed, '{}'::bigint[] AS written, '{}'::bigint[] AS gathered INTO locked;
        END IF;
        RETURN QUERY SELECT u.relation, sum(u.inserted)::bigint, sum(u.updated)::bigint, sum(u.deleted)::bigint,
            sum(u.unchanged)::bigint,
                CASE WHEN u.relation = 'edge' THEN skipped_axes ELSE 0 END, sum(u.fallbacks)::bigint
            FROM streetgen._upsert_part(model, locked.written, locked.gathered, locked.changed) u
            GROUP BY u.relation ORDER BY array_position(streetgen._computed_tables(model), u.relation);
    END IF;
    PERFORM set_config('lock_timeout', lock_timeout_before, true);
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    PERFORM streetgen._refuse_tables(model, CASE WHEN wait THEN 'Repeat the call, or raise lock_timeout.'
        ELSE 'Repeat the call when it has ended, or call generate with wait => true.' END);
END $$;
COMMENT ON FUNCTION streetgen.generate(name, bigint[], boolean) IS
    'Computes streets and upserts them: all axes (NULL, or each of them named), or the given ones and what they '
    'change around them, with what changed near them while nobody followed. Unchanged rows are not touched. Returns a '
    'row per table; fallbacks counts rows whose method is not hypothesis, skipped the axes whose places another run '
    'holds; rows or tables that another session locked: 55P03, and the model as it was (wait => true waits for both, '
    'within lock_timeout). Needs read committed (0A000). A part after a change of settings: 55000. An axis over '
    'axis_length_maximal, or where the SRID is more than 1 % off in scale: 22023. A setting that is missing: 22004; '
    'out of its range: 22023. Of two calls in one transaction, a part and then all with wait, the second may wait for '
    'a session that waits for it: 55P03, repeat the transaction.';
