-- Waiting for places, and what a session is told of who holds them: an edit that could never end is refused.

CREATE OR REPLACE FUNCTION streetgen._told(sessions integer[]) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT coalesce(string_agg(format('%s (process %s%s)', coalesce(a.usename, '?'), pid,
        ', since ' || to_char(a.xact_start, 'HH24:MI:SS')), ', ' ORDER BY pid), 'It has ended since.')
    FROM unnest(sessions) pid LEFT JOIN pg_stat_activity a USING (pid) $$;
COMMENT ON FUNCTION streetgen._told(integer[]) IS 'Sessions, given by their processes, as text.';

CREATE OR REPLACE FUNCTION streetgen._holders(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._told(ARRAY(SELECT DISTINCT pid FROM pg_locks
        LEFT JOIN pg_class c ON locktype = 'relation' AND c.oid = relation
            AND relnamespace = quote_ident(model)::regnamespace
        WHERE database = (SELECT oid FROM pg_database WHERE datname = current_database()) AND granted
            AND pid <> pg_backend_pid()
            AND (locktype = 'advisory' AND objsubid = 2
                AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid OR c.oid IS NOT NULL
                AND mode <> 'AccessShareLock'))) $$;
COMMENT ON FUNCTION streetgen._holders(name) IS
    'The other sessions that hold places, rows or tables of a model, as text.';

CREATE OR REPLACE FUNCTION streetgen._place_holders(model name, alone integer[], shared integer[]) RETURNS integer[]
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT ARRAY(SELECT DISTINCT pid FROM pg_locks
        WHERE locktype = 'advisory' AND objsubid = 2 AND granted AND pid <> pg_backend_pid()
            AND database = (SELECT oid FROM pg_database WHERE datname = current_database())
            AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid
            AND (objid = ANY (ARRAY(SELECT (key::bigint & 4294967295)::oid FROM unnest(alone) key))
                OR mode = 'ExclusiveLock'
                AND objid = ANY (ARRAY(SELECT (key::bigint & 4294967295)::oid FROM unnest(shared) key)))) $$;
COMMENT ON FUNCTION streetgen._place_holders(name, integer[], integer[]) IS
    'The other sessions, as processes, for which this one would wait where it locks keys alone, or shared.';

CREATE OR REPLACE FUNCTION streetgen._wait_for_this(session integer) RETURNS boolean
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    WITH RECURSIVE ahead AS (
        SELECT session AS pid
        UNION SELECT unnest(pg_blocking_pids(pid)) FROM ahead WHERE pid <> pg_backend_pid())
    SELECT EXISTS (SELECT FROM ahead WHERE pid = pg_backend_pid()) $$;
COMMENT ON FUNCTION streetgen._wait_for_this(integer) IS
    'Does a session wait for what this one holds, or for who waits so?';

CREATE OR REPLACE FUNCTION streetgen._stuck(model name, holders integer[], alone integer[], shared integer[])
    RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    waiting constant integer[] := ARRAY(SELECT pid FROM unnest(holders) pid WHERE streetgen._wait_for_this(pid));
BEGIN
    -- A session may have given its places back since they were looked at, and wait with its next edit at the entrance
    -- of the model, behind a run that waits for this one. A session that waits takes none.
    RETURN waiting <> '{}' AND waiting && streetgen._place_holders(model, alone, shared);
END $$;
COMMENT ON FUNCTION streetgen._stuck(name, integer[], integer[], integer[]) IS
    'Of sessions that held places of a model a moment ago: does one wait for this one, and still hold some? Then '
    'neither can go on.';

CREATE OR REPLACE FUNCTION streetgen._refuse_place(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('55P03', format('another session works at this place of model "%s"', model),
        detail => streetgen._holders(model), hint => 'Repeat this when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen._refuse_place(name) IS 'Raises 55P03, naming who holds places of the model.';

CREATE OR REPLACE FUNCTION streetgen._refuse_tables(model name, way_out text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('55P03', format('another session holds rows or tables of model "%s"', model),
        detail => streetgen._holders(model), hint => way_out);
END $$;
COMMENT ON FUNCTION streetgen._refuse_tables(name, text) IS
    'Raises 55P03, naming who holds rows or tables of the model.';

CREATE OR REPLACE FUNCTION streetgen._refuse_wait(model name, way_out text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- PostgreSQL's own refusal of a wait for a row has no hint, and a deadlock one of its own, which is not given here;
    -- another refusal says already who holds the place.
    IF coalesce(way_out, '') = '' THEN
        PERFORM streetgen._refuse_tables(model, 'Repeat the edit when it has ended, or raise lock_timeout.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._refuse_wait(name, text) IS
    'Raises 55P03, naming who holds rows of the model, where the hint of a 55P03 that was caught is empty, or it was a '
    'deadlock (NULL).';

CREATE OR REPLACE FUNCTION streetgen._time_to_wait(since timestamptz) RETURNS interval
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE current_setting('lock_timeout') WHEN '0' THEN interval '1 day'
        ELSE since + current_setting('lock_timeout')::interval - clock_timestamp() END $$;
COMMENT ON FUNCTION streetgen._time_to_wait(timestamptz) IS
    'How long a session that has waited since then may go on, by its lock_timeout; without one a day.';

CREATE OR REPLACE FUNCTION streetgen._wait_for_places(model name, alone integer[], shared integer[], since timestamptz)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    lock_timeout_before constant text := current_setting('lock_timeout');
    -- Shorter than the time after which PostgreSQL looks for a deadlock, and unlike that of others.
    turn constant interval := least(interval '200 ms', (0.5 + 0.4 * random())
        * current_setting('deadlock_timeout')::interval, streetgen._time_to_wait(since));
BEGIN
    IF since IS NULL THEN
        RAISE EXCEPTION 'since when this waits is NULL' USING ERRCODE = '22004', HINT = 'Give a time.';
    END IF;
    PERFORM set_config('lock_timeout', greatest(1, round(1000 * extract(epoch FROM turn)))::text, true);
    PERFORM streetgen._lock_places(model, alone, shared, wait => true);
    PERFORM set_config('lock_timeout', lock_timeout_before, true);
END $$;
COMMENT ON FUNCTION streetgen._wait_for_places(name, integer[], integer[], timestamptz) IS
    'Waits for places for a moment, since a session that waits cannot see who waits for it; then 55P03. NULL: 22004.';

CREATE OR REPLACE FUNCTION streetgen._go_on_waiting(model name, alone integer[], shared integer[], since timestamptz)
    RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    holders constant integer[] := streetgen._place_holders(model, alone, shared);
BEGIN
    IF streetgen._stuck(model, holders, alone, shared) THEN
        PERFORM streetgen._refuse('55P03',
            format('another session works at this place of model "%s", and waits for this one', model),
            detail => streetgen._told(holders),
            hint => 'Roll this transaction back and repeat it: neither could go on.');
    ELSIF streetgen._time_to_wait(since) <= interval '0' THEN
        PERFORM streetgen._refuse('55P03', format('another session works at this place of model "%s"', model),
            detail => streetgen._told(holders), hint => 'Repeat this when it has ended, or raise lock_timeout.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._go_on_waiting(name, integer[], integer[], timestamptz) IS
    'Between two moments of waiting for places: raises 55P03, naming who holds them, where that one waits for what '
    'this session holds already, so that neither could go on, and where lock_timeout has ended.';
