-- A run that does not wait goes beside the sessions that hold places: what it leaves out.

CREATE OR REPLACE FUNCTION streetgen._held_by_others(model name, OUT axes bigint[], OUT places integer[],
    OUT chains integer[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- The key of a lock, as it was before pg_locks shows it without a sign. Who holds a part shares what it lies in.
    SELECT coalesce(array_agg(key) FILTER (WHERE key < 0 OR key >= 1073741824), '{}'),
        coalesce(array_agg(key) FILTER (WHERE key BETWEEN 4095 AND 1073741823), '{}')
        INTO places, chains
    FROM (SELECT DISTINCT (CASE WHEN objid::bigint > 2147483647 THEN objid::bigint - 4294967296 ELSE objid::bigint
                END)::integer AS key
            FROM pg_locks WHERE locktype = 'advisory' AND objsubid = 2 AND granted AND pid <> pg_backend_pid()
                AND database = (SELECT oid FROM pg_database WHERE datname = current_database())
                AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid
                AND mode = 'ExclusiveLock') k;
    SELECT ARRAY(SELECT axis_id FROM axis WHERE streetgen._axis_key(axis_id) = ANY (chains)
        UNION SELECT axis_id FROM edge WHERE streetgen._axis_key(axis_id) = ANY (chains)) INTO axes;
    -- A session that holds a district, or all places, holds the axes there.
    IF EXISTS (SELECT FROM unnest(places) key WHERE key < 0) THEN
        SELECT ARRAY(SELECT unnest(axes) UNION SELECT axis_id
            FROM (SELECT axis_id, geom FROM axis UNION ALL SELECT axis_id, geom FROM edge) l,
                (SELECT value::float8 AS size FROM setting WHERE name = 'cell_size') s
            WHERE -1 = ANY (places) OR EXISTS (SELECT FROM streetgen._districts_of(geom, size) key
                WHERE key = ANY (places))) INTO axes;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._held_by_others(name) IS
    'The axes of which other sessions write rows, as far as this session sees these axes, and the keys of cells and '
    'districts, and of axes and chains, that others hold.';

CREATE OR REPLACE FUNCTION streetgen._stale_beside(model name, axes bigint[], places integer[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    size float8;
    -- How far a change reaches from the middle of the widest axis.
    far float8;
    beside bigint[];
    reach record;
BEGIN
    PERFORM streetgen._use_model(model);
    IF places = '{}' THEN
        RETURN '{}';
    END IF;
    -- This session does not see what others write: a changed axis may lie beside one that is new there.
    SELECT value::float8 FROM setting WHERE name = 'cell_size' INTO size;
    SELECT streetgen._change_reach(model) + coalesce(max(greatest(width, width_end) + 2 * abs(roadway_offset)), 0)
        FROM axis_used INTO far;
    WITH stale AS MATERIALIZED (
        SELECT axis_id, geom FROM axis_used u
        WHERE coalesce((SELECT bool_or(e.input_hash <> u.input_hash) FROM edge e WHERE e.axis_id = u.axis_id), true)
        UNION ALL SELECT axis_id, geom FROM edge e WHERE NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = e.axis_id)),
    line AS MATERIALIZED (
        SELECT geom FROM axis WHERE axis_id = ANY (axes) UNION ALL SELECT geom FROM edge WHERE axis_id = ANY (axes))
    SELECT coalesce(array_agg(DISTINCT axis_id), '{}') FROM stale s
    WHERE axis_id <> ALL (axes) AND (EXISTS (SELECT FROM line l WHERE ST_DWithin(l.geom, s.geom, far))
        OR -1 = ANY (places)
        OR EXISTS (SELECT FROM streetgen._cells(s.geom, far / 2, size) key WHERE key = ANY (places))
        OR EXISTS (SELECT FROM streetgen._districts_of(s.geom, size) key WHERE key = ANY (places))) INTO beside;
    -- Changed axes lead on from one to the next.
    LOOP
        SELECT * FROM _reach(axes || beside) INTO reach;
        EXIT WHEN reach.stale = '{}';
        beside := beside || reach.stale;
    END LOOP;
    RETURN beside;
END $$;
COMMENT ON FUNCTION streetgen._stale_beside(name, bigint[], integer[]) IS
    'Axes that changed, or came, since their streets were computed, and lie beside the axes, or at the cells and '
    'districts, that others hold.';

CREATE OR REPLACE FUNCTION streetgen._lock_places_beside(
    model name, axes bigint[], OUT requested bigint[], OUT changed bigint[], OUT written bigint[],
    OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- A session that takes places holds the door for a moment.
    SET lock_timeout = '100ms' SET jit = off
    AS $$
DECLARE
    others record;
    held bigint[];
    reach record;
BEGIN
    PERFORM streetgen._use_model(model);
    requested := '{}';
    changed := '{}';
    written := '{}';
    gathered := '{}';
    PERFORM streetgen._lock_places(model, ARRAY[streetgen._door()], '{}', wait => true);
    others := streetgen._held_by_others(model);
    IF axes IS NULL THEN
        SELECT ARRAY(SELECT axis_id FROM axis UNION SELECT axis_id FROM edge) INTO requested;
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
    held := held || streetgen._stale_beside(model, held, others.places);
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

