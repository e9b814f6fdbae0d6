-- What an edit or a run locks: the model, cells and chains, and the axes that it names at the door.

CREATE OR REPLACE FUNCTION streetgen._holders(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT coalesce(string_agg(format('%s (process %s%s)', coalesce(a.usename, '?'), l.pid,
        ', since ' || to_char(a.xact_start, 'HH24:MI:SS')), ', ' ORDER BY l.pid), 'It has ended since.')
    FROM (SELECT DISTINCT pid FROM pg_locks LEFT JOIN pg_class c ON locktype = 'relation' AND c.oid = relation
        AND relnamespace = quote_ident(model)::regnamespace
          WHERE database = (SELECT oid FROM pg_database WHERE datname = current_database()) AND granted
              AND pid <> pg_backend_pid()
              AND (locktype = 'advisory' AND objsubid = 2
                  AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid OR c.oid IS NOT NULL
                  AND mode <> 'AccessShareLock')) l
    LEFT JOIN pg_stat_activity a USING (pid) $$;
COMMENT ON FUNCTION streetgen._holders(name) IS
    'The other sessions that hold places, rows or tables of a model, as text.';

CREATE OR REPLACE FUNCTION streetgen._lock_model(model name, wait boolean, alone boolean, keys boolean DEFAULT true)
    RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    model_key constant integer := hashtext('streetgen.' || model);
    missing constant boolean := keys AND streetgen._keys_are_missing(model);
    entered boolean := true;
BEGIN
    IF current_setting('transaction_isolation') <> 'read committed' THEN
        RAISE EXCEPTION 'streets of model "%" need isolation level read committed, this transaction has %', model,
            current_setting('transaction_isolation')
            USING ERRCODE = '0A000',
                HINT = 'Under a higher level they would be computed from a snapshot older than the locks.';
    END IF;
    -- What runs goes by one state of the settings, grid of the places included: who changes one waits until it has
    -- ended.
    EXECUTE format('LOCK TABLE %I.setting IN SHARE MODE', model);
    CASE
        WHEN wait AND (alone OR missing) THEN PERFORM pg_advisory_xact_lock(model_key, 0);
        WHEN wait THEN PERFORM pg_advisory_xact_lock_shared(model_key, 0);
        WHEN alone OR missing THEN entered := pg_try_advisory_xact_lock(model_key, 0);
        ELSE entered := pg_try_advisory_xact_lock_shared(model_key, 0);
    END CASE;
    -- Who waited for another may find them made.
    IF missing AND entered AND streetgen._keys_are_missing(model) THEN
        PERFORM streetgen._make_keys(model);
    END IF;
    RETURN entered;
EXCEPTION WHEN lock_not_available THEN
    RAISE EXCEPTION 'another session holds model "%"', model USING ERRCODE = '55P03',
        DETAIL = streetgen._holders(model), HINT = 'Repeat this when it has ended, or raise lock_timeout.';
END $$;
COMMENT ON FUNCTION streetgen._lock_model(name, boolean, boolean, boolean) IS
    'Locks the model for this transaction, its settings first: alone, or beside others that lock its places. keys: '
    'not before those that a first run by clusters left are made, for which it is alone. Without wait: whether it was '
    'free. A lock_timeout that ends: 55P03, naming who holds it; above read committed: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._refuse_place(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'another session works at this place of model "%"', model USING ERRCODE = '55P03',
        DETAIL = streetgen._holders(model), HINT = 'Repeat this when it has ended, or raise lock_timeout.';
END $$;
COMMENT ON FUNCTION streetgen._refuse_place(name) IS 'Raises 55P03, naming who holds places of the model.';

CREATE OR REPLACE FUNCTION streetgen._refuse_tables(model name, way_out text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'another session holds rows or tables of model "%"', model USING ERRCODE = '55P03',
        DETAIL = streetgen._holders(model), HINT = way_out;
END $$;
COMMENT ON FUNCTION streetgen._refuse_tables(name, text) IS
    'Raises 55P03, naming who holds rows or tables of the model.';

CREATE OR REPLACE FUNCTION streetgen._refuse_wait(model name, way_out text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- PostgreSQL's own refusal of a wait for a row has no hint; another one says already who holds the place.
    IF coalesce(way_out, '') = '' THEN
        PERFORM streetgen._refuse_tables(model, 'Repeat the edit when it has ended, or raise lock_timeout.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._refuse_wait(name, text) IS
    'Raises 55P03, naming who holds rows of the model, where the hint of a 55P03 that was caught is empty.';

-- Keys of axes stand above those of cells; that of the door comes before all others.
CREATE OR REPLACE FUNCTION streetgen._axis_key(axis_id bigint) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    BEGIN ATOMIC SELECT 1025 + (axis_id & 1023)::integer; END;
COMMENT ON FUNCTION streetgen._axis_key(bigint) IS
    'The key (1025 to 2048) by which a session that holds places tells others that it writes rows of an axis.';

CREATE OR REPLACE FUNCTION streetgen._door() RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT '-2147483648'::integer; END;
COMMENT ON FUNCTION streetgen._door() IS
    'The key of the door of a model. A run beside others shuts it, so that nobody takes places that it does not know '
        'of.';

CREATE OR REPLACE FUNCTION streetgen._lock_places(model name, alone integer[], shared integer[], wait boolean)
    RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    model_key constant integer := hashtext('streetgen.' || model);
    place record;
    free boolean := true;
BEGIN
    FOR place IN SELECT key, true AS alone FROM unnest(_lock_places.alone) key
        UNION ALL SELECT key, false FROM unnest(_lock_places.shared) key ORDER BY key
    LOOP
        CASE
            WHEN wait AND place.alone THEN PERFORM pg_advisory_xact_lock(model_key, place.key);
            WHEN wait THEN PERFORM pg_advisory_xact_lock_shared(model_key, place.key);
            WHEN place.alone THEN free := pg_try_advisory_xact_lock(model_key, place.key);
            ELSE free := pg_try_advisory_xact_lock_shared(model_key, place.key);
        END CASE;
        EXIT WHEN NOT free;
    END LOOP;
    RETURN free;
END $$;
COMMENT ON FUNCTION streetgen._lock_places(name, integer[], integer[], boolean) IS
    'Locks keys of a model for this transaction, in one order, some for itself and some shared with who locks them '
        'so too. '
    'Without wait: false, with some of them locked, where another session holds any.';

CREATE OR REPLACE FUNCTION streetgen._lock_all_places(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._lock_places(model, ARRAY[-1], ARRAY[streetgen._door()], wait => true);
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_place(model);
END $$;
COMMENT ON FUNCTION streetgen._lock_all_places(name) IS
    'Locks all places of a model by one key, for this transaction. A lock_timeout that ends: 55P03, naming who holds '
        'some.';

CREATE OR REPLACE FUNCTION streetgen._door_is_open(model name) RETURNS boolean
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    -- A lock of the session, unlike one of the transaction, can be given back at once.
    SELECT CASE WHEN pg_try_advisory_lock_shared(key, door) THEN pg_advisory_unlock_shared(key, door) ELSE false END
    FROM (SELECT hashtext('streetgen.' || model) AS key, streetgen._door() AS door) k $$;
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
    WHEN lock_not_available THEN
        PERFORM streetgen._refuse_place(model);
END $$;
COMMENT ON FUNCTION streetgen._wait_at_door(name) IS
    'Waits until the door of a model is open, and holds nothing then. A lock_timeout that ends: 55P03, naming who '
        'holds places.';

CREATE OR REPLACE FUNCTION streetgen._held_by_others(model name, OUT axes bigint[], OUT cells bigint[],
    OUT chains integer[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    keys bigint[];
    all_cells constant bigint := 4294967295;
    all_chains constant integer := streetgen._all_chains();
BEGIN
    keys := ARRAY(SELECT DISTINCT objid::bigint FROM pg_locks
        WHERE locktype = 'advisory' AND objsubid = 2 AND granted AND pid <> pg_backend_pid()
            AND database = (SELECT oid FROM pg_database WHERE datname = current_database())
            AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid
            -- All who hold single cells or chains share the key of all.
            AND (objid::bigint NOT IN (all_cells, all_chains) OR mode = 'ExclusiveLock'));
    cells := CASE WHEN all_cells = ANY (keys) THEN ARRAY(SELECT generate_series(1, 1024))
                  ELSE ARRAY(SELECT key FROM unnest(keys) key WHERE key BETWEEN 1 AND 1024) END;
    chains := ARRAY(SELECT key FROM unnest(keys) key WHERE key BETWEEN 4096 AND 1073745919 OR key = all_chains);
    -- Axes far from each other share keys: of those that have edges only the ones at places that are held.
    EXECUTE format($sql$
WITH size AS (SELECT value::float8 AS size FROM %1$I.setting WHERE name = 'cell_size'),
line AS MATERIALIZED (
    SELECT axis_id, geom, false AS computed FROM %1$I.axis WHERE streetgen._axis_key(axis_id) = ANY ($1)
    UNION ALL SELECT axis_id, geom, true FROM %1$I.edge WHERE streetgen._axis_key(axis_id) = ANY ($1))
SELECT coalesce(array_agg(axis_id), '{}') FROM (
    SELECT axis_id FROM line GROUP BY axis_id HAVING NOT bool_or(computed)
    UNION SELECT axis_id FROM line, size, streetgen._cell(
            ST_XMin(geom) - 10, ST_YMin(geom) - 10, ST_XMax(geom) + 10, ST_YMax(geom) + 10, size) cell
        WHERE cell = ANY ($2)) h
$sql$, model) INTO axes USING keys, cells;
END $$;
COMMENT ON FUNCTION streetgen._held_by_others(name) IS
    'The axes of which other sessions write rows, as far as this session sees these axes, and the cells and the keys '
    'of chains that others hold.';

CREATE OR REPLACE FUNCTION streetgen._stale_beside(model name, axes bigint[], cells bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    beside bigint[];
    reach record;
BEGIN
    IF cells = '{}' THEN
        RETURN '{}';
    END IF;
    -- What others write is not seen: what changed may lie beside an axis that is new there.
    EXECUTE format($sql$
WITH size AS (SELECT value::float8 AS size FROM %1$I.setting WHERE name = 'cell_size'),
far AS (
    SELECT max(value::float8) + coalesce((SELECT max(greatest(width, width_end) + 2 * abs(roadway_offset))
        FROM %1$I.axis_used), 0) AS far
    FROM %1$I.setting WHERE name IN ('reach', 'max_arc_distance')),
stale AS MATERIALIZED (
    SELECT axis_id, geom FROM %1$I.axis_used u
    WHERE coalesce((SELECT bool_or(e.input_hash <> u.input_hash) FROM %1$I.edge e WHERE e.axis_id = u.axis_id), true)
    UNION ALL SELECT axis_id, geom FROM %1$I.edge e WHERE NOT EXISTS (SELECT FROM %1$I.axis a
        WHERE a.axis_id = e.axis_id)),
line AS MATERIALIZED (
    SELECT geom FROM %1$I.axis WHERE axis_id = ANY ($1) UNION ALL SELECT geom FROM %1$I.edge WHERE axis_id = ANY ($1))
SELECT coalesce(array_agg(DISTINCT axis_id), '{}') FROM stale s
WHERE axis_id <> ALL ($1) AND (EXISTS (SELECT FROM far, line l WHERE ST_DWithin(l.geom, s.geom, far))
    OR EXISTS (SELECT FROM size, streetgen._cell(
            ST_XMin(geom) - 10, ST_YMin(geom) - 10, ST_XMax(geom) + 10, ST_YMax(geom) + 10, size) cell
                WHERE cell = ANY ($2)))
$sql$, model) INTO beside USING axes, cells;
    -- What changed leads on from one to the next.
    LOOP
        EXECUTE format('SELECT * FROM %I._reach($1)', model) INTO reach USING axes || beside;
        EXIT WHEN reach.stale = '{}';
        beside := beside || reach.stale;
    END LOOP;
    RETURN beside;
END $$;
COMMENT ON FUNCTION streetgen._stale_beside(name, bigint[], bigint[]) IS
    'Axes that changed, or came, since their streets were computed, and lie beside the axes, or at the cells, that '
        'others hold.';

CREATE OR REPLACE FUNCTION streetgen._lock_places_beside(
    model name, axes bigint[], OUT requested bigint[], OUT changed bigint[], OUT written bigint[],
    OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Who takes places holds the door for a moment.
    SET lock_timeout = '100ms' SET jit = off
    AS $$
DECLARE
    others record;
    held bigint[];
    reach record;
BEGIN
    requested := '{}';
    changed := '{}';
    written := '{}';
    gathered := '{}';
    PERFORM streetgen._lock_places(model, ARRAY[streetgen._door()], '{}', wait => true);
    others := streetgen._held_by_others(model);
    IF axes IS NULL THEN
        EXECUTE format('SELECT ARRAY(SELECT axis_id FROM %1$I.axis UNION SELECT axis_id FROM %1$I.edge)', model)
            INTO requested;
        changed := requested;
        written := requested;
        gathered := requested;
    ELSE
        reach := streetgen._reach_of(model, axes);
        requested := axes;
        changed := reach.requested;
        written := reach.written;
        gathered := reach.gathered;
    END IF;
    held := others.axes || streetgen._axes_at_chains(model, written, others.chains);
    held := held || streetgen._stale_beside(model, held, others.cells);
    requested := ARRAY(SELECT unnest(requested) EXCEPT SELECT unnest(held));
    changed := ARRAY(SELECT unnest(changed) EXCEPT SELECT unnest(held));
    written := ARRAY(SELECT unnest(written) EXCEPT SELECT unnest(held));
EXCEPTION WHEN lock_not_available THEN
    RETURN;
END $$;
COMMENT ON FUNCTION streetgen._lock_places_beside(name, bigint[]) IS
    'Of the axes (NULL: all of a model) those of which no other session writes rows, for who does not wait: it shuts '
        'the door '
    'for this transaction. What changed while nobody followed waits where it lies beside what others write. Gives what '
    'streetgen._lock_places gives; nothing where others compute clusters, mark many axes as stale, or have shut '
    'the door.';

CREATE OR REPLACE FUNCTION streetgen._lock_places(
    model name, axes bigint[], wait boolean, OUT requested bigint[], OUT changed bigint[], OUT written bigint[],
        OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- The first key of each lock is the model; of the second 0 is the model, -1 all its cells.
    model_key constant integer := hashtext('streetgen.' || model);
    cells integer[];
    chains integer[];
    places record;
    named bigint[];
    -- Were all places free, and was the door open?
    free boolean;
    entered boolean;
    reach record;
    seen pg_snapshot := pg_current_snapshot();
BEGIN
    -- A NULL among the axes has no place.
    axes := array_remove(axes, NULL);
    reach := streetgen._reach_of(model, axes);
    cells := reach.cells;
    chains := reach.chains;
    named := reach.written;
    LOOP
        -- Locks are taken in one order: where more turn out to be needed, those taken here are given back first.
        BEGIN
            entered := false;
            places := streetgen._places_of(cells, chains);
            free := streetgen._lock_places(model, places.alone, places.shared, wait);
            IF free THEN
                -- Told first, requested then: a run that shuts the door sees either this or nobody.
                PERFORM pg_advisory_xact_lock_shared(model_key, key)
                    FROM (SELECT DISTINCT streetgen._axis_key(id) AS key FROM unnest(named) id) k;
                entered := streetgen._door_is_open(model);
            END IF;
            IF NOT entered THEN
                RAISE SQLSTATE 'SG001';
            END IF;
            -- The same snapshot: nobody has committed meanwhile.
            IF pg_current_snapshot()::text <> seen::text THEN
                reach := streetgen._reach_of(model, axes);
            END IF;
            IF NOT (reach.cells <@ cells AND reach.chains <@ chains AND reach.written <@ named) THEN
                cells := ARRAY(SELECT DISTINCT c FROM unnest(cells || reach.cells) c);
                chains := ARRAY(SELECT DISTINCT c FROM unnest(chains || reach.chains) c);
                named := named || reach.written;
                RAISE SQLSTATE 'SG001';
            END IF;
        EXCEPTION
            WHEN SQLSTATE 'SG001' THEN
                IF NOT entered AND NOT wait THEN
                    SELECT * INTO requested, changed, written, gathered FROM streetgen._lock_places_beside(model, axes);
                    RETURN;
                ELSIF NOT entered THEN
                    -- Holding nothing that was taken here.
                    PERFORM streetgen._wait_at_door(model);
                END IF;
                CONTINUE;
            WHEN lock_not_available THEN
                PERFORM streetgen._refuse_place(model);
        END;
        EXIT;
    END LOOP;
    requested := axes;
    changed := reach.requested;
    written := reach.written;
    gathered := reach.gathered;
END $$;
COMMENT ON FUNCTION streetgen._lock_places(name, bigint[], boolean) IS
    'Locks the cells and the chains of all that a run for the axes reads or writes, for this transaction, in one '
    'order, and tells of which axes it writes rows; without wait, where a place is not free: as '
    'streetgen._lock_places_beside. Gives these axes, the same with stale ones near them, and what the run writes and '
    'gathers. A lock_timeout that ends: 55P03, naming who holds places.';
