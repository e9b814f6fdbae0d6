-- An edit or a run locks the places of all that it reads and writes.

CREATE OR REPLACE FUNCTION streetgen._holds_all(keys anyarray, wanted anyarray) RETURNS boolean
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- The operator compares each with each, and hears no cancel meanwhile.
    IF cardinality(keys)::bigint * cardinality(wanted) < 1000000 THEN
        RETURN wanted <@ keys;
    END IF;
    RETURN NOT EXISTS (SELECT unnest(wanted) EXCEPT SELECT unnest(keys));
END $$;
COMMENT ON FUNCTION streetgen._holds_all(anyarray, anyarray) IS
    'Are all wanted keys among these? Also of hundreds of thousands, as the cells of a line of a thousand kilometres.';

CREATE OR REPLACE FUNCTION streetgen._lock_places(model name, alone integer[], shared integer[], wait boolean)
    RETURNS boolean
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    model_key constant integer := hashtext('streetgen.' || model);
    free boolean := true;
BEGIN
    IF num_nulls(model, alone, shared, wait) > 0 THEN
        PERFORM streetgen._refuse('22004', 'the places to be locked are NULL', hint => 'None are an empty list.');
    ELSIF wait THEN
        PERFORM CASE WHEN is_alone THEN pg_advisory_xact_lock(model_key, key)
                     ELSE pg_advisory_xact_lock_shared(model_key, key) END
        FROM (SELECT key, true AS is_alone FROM unnest(alone) key UNION ALL SELECT key, false FROM unnest(shared) key
            ORDER BY key OFFSET 0) k;
    ELSE
        free := (SELECT bool_and(CASE WHEN is_alone THEN pg_try_advisory_xact_lock(model_key, key)
                                      ELSE pg_try_advisory_xact_lock_shared(model_key, key) END)
            FROM (SELECT key, true AS is_alone FROM unnest(alone) key
                UNION ALL SELECT key, false FROM unnest(shared) key) k);
    END IF;
    PERFORM set_config('streetgen.places',
        (streetgen._places_held() + cardinality(alone) + cardinality(shared))::text, true);
    RETURN coalesce(free, true);
END $$;
COMMENT ON FUNCTION streetgen._lock_places(name, integer[], integer[], boolean) IS
    'Locks keys of a model for this transaction, in one order, some for itself and some shared with who locks them '
    'so too, and counts them. Without wait: false, with some of them locked, where another session holds any. '
    'NULL: 22004.';

CREATE OR REPLACE FUNCTION streetgen._lock_all_places(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._lock_places(model, ARRAY[-1], ARRAY[streetgen._door()], wait => true);
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    PERFORM streetgen._refuse_place(model);
END $$;
COMMENT ON FUNCTION streetgen._lock_all_places(name) IS
    'Locks all places of a model by one key, for this transaction. A lock_timeout that ends: 55P03, naming who holds '
        'some.';

CREATE OR REPLACE FUNCTION streetgen._door_is_open(model name) RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT streetgen._lock_places(model, '{}', ARRAY[streetgen._door()], wait => false) THEN
        RETURN false;
    END IF;
    -- Its savepoint gives the lock back at once.
    RAISE SQLSTATE 'SG001';
EXCEPTION WHEN SQLSTATE 'SG001' THEN
    RETURN true;
END $$;
COMMENT ON FUNCTION streetgen._door_is_open(name) IS
    'May a session that has just taken places of a model keep them? Not while a run that does not know of them has '
        'shut the door.';

CREATE OR REPLACE FUNCTION streetgen._wait_at_door(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._lock_places(model, '{}', ARRAY[streetgen._door()], wait => true);
    RAISE SQLSTATE 'SG001';
EXCEPTION
    WHEN SQLSTATE 'SG001' THEN
        RETURN;
    WHEN lock_not_available OR deadlock_detected THEN
        PERFORM streetgen._refuse_place(model);
END $$;
COMMENT ON FUNCTION streetgen._wait_at_door(name) IS
    'Waits until the door of a model is open, and holds nothing then. A lock_timeout that ends: 55P03, naming who '
        'holds places.';

CREATE OR REPLACE FUNCTION streetgen._lock_ground(model name, ground geometry[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    size constant float8 := streetgen._setting_number(model, 'cell_size');
    -- Half of the way between what comes and an axis that comes is each one's.
    margin constant float8 := streetgen._change_reach(model) / 2;
    cells constant integer[] := ARRAY(SELECT DISTINCT key FROM unnest(ground) g, streetgen._cells(g, margin, size) key);
    districts constant integer[] := ARRAY(SELECT DISTINCT key
        FROM unnest(ground) g, streetgen._districts_of(ST_Expand(g, margin), size) key);
    places record;
    free boolean;
    since timestamptz;
BEGIN
    LOOP
        BEGIN
            places := streetgen._places_of(model, cells, districts, '{}');
            IF since IS NULL THEN
                free := streetgen._lock_places(model, places.alone, places.shared, wait => false);
            ELSE
                PERFORM streetgen._wait_for_places(model, places.alone, places.shared, since);
                free := true;
            END IF;
            IF NOT free OR NOT streetgen._door_is_open(model) THEN
                RAISE SQLSTATE 'SG001';
            END IF;
            EXIT;
        EXCEPTION
            WHEN SQLSTATE 'SG001' THEN
                IF NOT free THEN
                    since := clock_timestamp();
                ELSE
                    PERFORM streetgen._wait_at_door(model);
                END IF;
            WHEN lock_not_available OR deadlock_detected THEN
                since := coalesce(since, clock_timestamp());
                PERFORM streetgen._go_on_waiting(model, places.alone, places.shared, since);
        END;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._lock_ground(name, geometry[]) IS
    'Locks the cells about what is drawn on the ground, for this transaction: a street that another session draws '
    'there comes before or after, and the later one sees the other. A place that another session holds longer than '
    'lock_timeout, or that waits for this one: 55P03, naming who.';

CREATE OR REPLACE FUNCTION streetgen._lock_places(
    model name, axes bigint[], wait boolean, OUT requested bigint[], OUT changed bigint[], OUT written bigint[],
        OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    cells integer[];
    districts integer[];
    chains integer[];
    places record;
    -- Were all places free, and was the door open?
    free boolean;
    entered boolean;
    -- A place was not free: since when this waits.
    since timestamptz;
    reach record;
    seen pg_snapshot := pg_current_snapshot();
BEGIN
    IF num_nulls(model, axes, wait) > 0 THEN
        PERFORM streetgen._refuse('22004', 'the axes whose places are to be locked are NULL',
            hint => 'None are an empty list.');
    END IF;
    -- A NULL among the axes has no place.
    axes := array_remove(axes, NULL);
    reach := streetgen._reach_of(model, axes);
    cells := reach.cells;
    districts := reach.districts;
    chains := reach.chains;
    LOOP
        -- Locks are taken in one order: where more turn out to be needed, those taken here are given back first.
        BEGIN
            entered := false;
            places := streetgen._places_of(model, cells, districts, chains);
            IF since IS NULL THEN
                free := streetgen._lock_places(model, places.alone, places.shared, wait => false);
            ELSE
                PERFORM streetgen._wait_for_places(model, places.alone, places.shared, since);
                free := true;
            END IF;
            -- Told first, requested then: a run that shuts the door sees either this or nobody.
            entered := free AND streetgen._door_is_open(model);
            IF NOT entered THEN
                RAISE SQLSTATE 'SG001';
            END IF;
            -- The same snapshot: nobody has committed meanwhile.
            IF pg_current_snapshot()::text <> seen::text THEN
                reach := streetgen._reach_of(model, axes);
            END IF;
            IF NOT (streetgen._holds_all(cells, reach.cells) AND streetgen._holds_all(districts, reach.districts)
                AND streetgen._holds_all(chains, reach.chains)) THEN
                cells := ARRAY(SELECT DISTINCT c FROM unnest(cells || reach.cells) c);
                districts := ARRAY(SELECT DISTINCT c FROM unnest(districts || reach.districts) c);
                chains := ARRAY(SELECT DISTINCT c FROM unnest(chains || reach.chains) c);
                RAISE SQLSTATE 'SG001';
            END IF;
        EXCEPTION
            WHEN SQLSTATE 'SG001' THEN
                IF NOT entered AND NOT wait THEN
                    SELECT * INTO requested, changed, written, gathered FROM streetgen._lock_places_beside(model, axes);
                    RETURN;
                ELSIF NOT free THEN
                    since := clock_timestamp();
                ELSIF NOT entered THEN
                    -- Holding nothing that was taken here.
                    PERFORM streetgen._wait_at_door(model);
                END IF;
                CONTINUE;
            WHEN lock_not_available OR deadlock_detected THEN
                since := coalesce(since, clock_timestamp());
                PERFORM streetgen._go_on_waiting(model, places.alone, places.shared, since);
                CONTINUE;
        END;
        EXIT;
    END LOOP;
    requested := axes;
    changed := reach.requested;
    written := reach.written;
    gathered := reach.gathered;
END $$;
COMMENT ON FUNCTION streetgen._lock_places(name, bigint[], boolean) IS
    'Locks all that a run for the axes reads or writes, for this transaction, in one order: the cells about them, and '
    'the axes and chains that it may change; without wait, where a place is not free: as '
    'streetgen._lock_places_beside. Gives these axes, the same with stale ones near them, and what the run writes and '
    'gathers. A place that another session holds longer than lock_timeout, or that waits for this one: 55P03, naming '
    'who. NULL: 22004.';
