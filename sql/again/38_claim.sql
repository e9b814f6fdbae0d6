-- Which axes a change concerns, and the locks on their places.

CREATE OR REPLACE FUNCTION streetgen._cell(west float8, south float8, east float8, north float8, size float8) RETURNS SETOF integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        -- Of four times as many places as cells hardly a cell is free.
        SELECT generate_series(1, 1024) WHERE (floor(east / size) - floor(west / size) + 1) * (floor(north / size) - floor(south / size) + 1) > 4096
        UNION ALL SELECT 1 + (hashint8(x * 1000003 + y) & 1023)
            FROM generate_series(floor(west / size)::bigint, floor(east / size)::bigint) x, generate_series(floor(south / size)::bigint, floor(north / size)::bigint) y
            WHERE (floor(east / size) - floor(west / size) + 1) * (floor(north / size) - floor(south / size) + 1) <= 4096;
    END;
COMMENT ON FUNCTION streetgen._cell(float8, float8, float8, float8, float8) IS 'Cells (1 to 1024, hashed from a grid of the given size) of a box.';

CREATE OR REPLACE FUNCTION streetgen._own_function(model name, signature text, description text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format('ALTER FUNCTION %I.%s OWNER TO %s', model, signature, (SELECT nspowner::regrole FROM pg_namespace WHERE nspname = model));
    EXECUTE format('REVOKE ALL ON FUNCTION %I.%s FROM PUBLIC', model, signature);
    EXECUTE format('ALTER FUNCTION %I.%s DEPENDS ON EXTENSION streetgen', model, signature);
    EXECUTE format('COMMENT ON FUNCTION %I.%s IS %L', model, signature, description);
END $$;
COMMENT ON FUNCTION streetgen._own_function(name, text, text) IS 'Gives a function in the schema of a model to its owner, with a comment: nobody else may call it, and it goes with the extension.';

CREATE OR REPLACE FUNCTION streetgen._make_reach(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._reach(asked bigint[], OUT stale bigint[], OUT written bigint[], OUT gathered bigint[], OUT cells integer[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
    SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
    AS $body$
DECLARE
    reach float8;
    size float8;
    tolerance float8;
    -- No roadway is wider.
    widest float8;
    -- The asked axes that are there, and how wide they are.
    present bigint[];
    widths float8[];
BEGIN
    -- An arc may bend as far from its node as max_arc_distance, and so where an edge that ends there is cut.
    SELECT max(value::float8) FILTER (WHERE name IN ('reach', 'max_arc_distance')), max(value::float8) FILTER (WHERE name = 'cell_size'),
           max(value::float8) FILTER (WHERE name = 'tolerance'),
           greatest(max(value::float8) FILTER (WHERE name = 'width_default'), (SELECT max(greatest(e.width, e.width_end)) FROM %1$I.edge e), (SELECT max(a.width) FROM %1$I.axis a), (SELECT max(k.width) FROM %1$I.kerb_point_override k), (SELECT max(c.width) FROM %1$I.axis_class c))
        INTO reach, size, tolerance, widest FROM %1$I.setting WHERE name IN ('reach', 'max_arc_distance', 'cell_size', 'tolerance', 'width_default');
    SELECT array_agg(u.axis_id), array_agg(greatest(u.width, u.width_end)) INTO present, widths FROM %1$I.axis_used u WHERE u.axis_id = ANY (asked);
    -- What the asked axes can change: along the network, and by their roadway.
    written := ARRAY(
        WITH line AS MATERIALIZED (
            SELECT geom, u.width FROM unnest(present, widths) u(axis_id, width) JOIN %1$I.axis USING (axis_id)
            UNION ALL SELECT geom, greatest(width, width_end) FROM %1$I.edge WHERE axis_id = ANY (asked)
            -- Too short for an edge, it joined others.
            UNION ALL SELECT geom, 0 FROM %1$I.report WHERE axis_a = ANY (asked) AND issue = 'collapsed_axis'),
        near AS MATERIALIZED (
            SELECT e.*, distance <= 3 * tolerance AS met
            FROM line l, LATERAL (
                SELECT edge_id, axis_id, from_node, to_node, e.geom, greatest(e.width, width_end) AS width, ST_Distance(e.geom, l.geom) AS distance
                FROM %1$I.edge e WHERE e.geom && ST_Expand(l.geom, greatest(reach + (l.width + widest) / 2, 3 * tolerance)) OFFSET 0) e
            WHERE distance <= greatest(reach + (l.width + e.width) / 2, 3 * tolerance)),
        -- Where limits cross, the far end of an edge moves too, however far.
        far_end AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM near WHERE met),
        -- An intersection that they meet claims ground farther off too, where a limit lies beyond the reach.
        reaching AS MATERIALIZED (
            SELECT DISTINCT ON (edge_id) geom, width FROM near n WHERE met AND EXISTS (
                SELECT FROM %1$I.section_limit l WHERE l.edge_id = n.edge_id AND n.width / 2 + CASE which WHEN 'start' THEN l.abscissa ELSE ST_Length(n.geom) - l.abscissa END > reach))
        SELECT axis_id FROM near
        UNION SELECT axis_id FROM %1$I.edge WHERE from_node = ANY ((SELECT ids FROM far_end)::bigint[])
        UNION SELECT axis_id FROM %1$I.edge WHERE to_node = ANY ((SELECT ids FROM far_end)::bigint[])
        UNION SELECT e.axis_id FROM reaching l JOIN %1$I.edge e ON e.geom && ST_Expand(l.geom, reach + (l.width + widest) / 2)
            AND ST_DWithin(e.geom, l.geom, reach + (l.width + greatest(e.width, e.width_end)) / 2)
        -- What joined its ends may part them.
        UNION SELECT axis_a FROM %1$I.report r JOIN line l ON l.geom && ST_Expand(r.geom, measure + 3 * tolerance) WHERE issue = 'collapsed_axis'
        UNION SELECT unnest(asked));
    stale := ARRAY(SELECT axis_id FROM %1$I.axis_used u WHERE axis_id = ANY (written) AND axis_id NOT IN (SELECT unnest(asked))
        AND coalesce((SELECT bool_or(e.input_hash <> u.input_hash) FROM %1$I.edge e WHERE e.axis_id = u.axis_id), true));
    IF stale <> '{}' THEN
        RETURN;
    END IF;
    WITH own AS MATERIALIZED (
        SELECT axis_id, from_node, to_node, geom, greatest(width, width_end) AS width, box3d(geom) AS extent FROM %1$I.edge WHERE axis_id = ANY (written)),
    line AS MATERIALIZED (
        SELECT axis_id, geom, floor(ST_XMin(extent) / size) AS x, floor(ST_YMin(extent) / size) AS y, extent, reach + width / 2 AS margin, ST_Expand(geom, reach + (width + widest) / 2) AS box
        FROM (SELECT axis_id, max(width) AS width FROM (SELECT axis_id, width FROM own UNION ALL SELECT * FROM unnest(present, widths)) w(axis_id, width) GROUP BY axis_id OFFSET 0) w
            JOIN (SELECT axis_id, geom, box3d(geom) AS extent FROM %1$I.axis WHERE axis_id = ANY (written) OFFSET 0) a USING (axis_id)),
    -- What that depends on. Axes are looked up once for all lines that begin in one cell.
    around AS MATERIALIZED (
        SELECT x, y, a.axis_id, a.geom FROM (SELECT x, y, ST_Extent(box)::geometry AS box FROM line GROUP BY x, y) b JOIN %1$I.axis a ON a.geom && b.box AND a.axis_id NOT IN (SELECT unnest(written))),
    edge_around AS MATERIALIZED (
        SELECT axis_id, from_node, to_node, geom, greatest(width, width_end) AS width FROM %1$I.edge WHERE axis_id = ANY (ARRAY(SELECT axis_id FROM around))),
    beside AS MATERIALIZED (
        SELECT DISTINCT axis_id FROM around b LEFT JOIN (SELECT axis_id, max(width) AS width FROM edge_around GROUP BY axis_id) e USING (axis_id)
        WHERE EXISTS (SELECT FROM line l WHERE (l.x, l.y) = (b.x, b.y) AND b.geom && l.box AND ST_DWithin(b.geom, l.geom, l.margin + coalesce(e.width, widest) / 2))),
    -- With what meets it farther on: that bounds its edges.
    bounded AS MATERIALIZED (SELECT from_node, to_node, geom FROM own UNION ALL SELECT from_node, to_node, geom FROM edge_around WHERE axis_id IN (SELECT axis_id FROM beside)),
    met AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM bounded),
    met_axis AS MATERIALIZED (
        SELECT axis_id FROM %1$I.edge WHERE from_node = ANY ((SELECT ids FROM met)::bigint[]) UNION SELECT axis_id FROM %1$I.edge WHERE to_node = ANY ((SELECT ids FROM met)::bigint[])
        -- An axis too short for an edge has no node, but may place that of others.
        UNION SELECT axis_a FROM %1$I.report r WHERE issue = 'collapsed_axis' AND ST_Expand(geom, measure) && (SELECT ST_Expand(ST_Extent(geom)::geometry, 3 * tolerance) FROM bounded)
            AND EXISTS (SELECT FROM %1$I.axis a JOIN %1$I.node n ON ST_DWithin(n.geom, a.geom, 3 * tolerance) WHERE a.axis_id = r.axis_a AND n.node_id = ANY ((SELECT ids FROM met)::bigint[]))
        EXCEPT (SELECT axis_id FROM line UNION ALL SELECT axis_id FROM beside)),
    -- A run writes every axis near the asked ones whole, ends included. Most lie in the same few cells: the middles of their outermost.
    box AS MATERIALIZED (
        SELECT DISTINCT (floor((ST_XMin(extent) - margin) / size) + 0.5) * size AS west, (floor((ST_YMin(extent) - margin) / size) + 0.5) * size AS south,
            (floor((ST_XMax(extent) + margin) / size) + 0.5) * size AS east, (floor((ST_YMax(extent) + margin) / size) + 0.5) * size AS north
        FROM (SELECT extent, CASE WHEN axis_id IN (SELECT unnest(asked)) THEN reach + widest ELSE 10 END AS margin FROM (SELECT axis_id, extent FROM line UNION ALL SELECT axis_id, extent FROM own) l OFFSET 0) m)
    SELECT ARRAY(SELECT axis_id FROM line UNION ALL SELECT axis_id FROM beside UNION ALL SELECT axis_id FROM met_axis JOIN %1$I.axis USING (axis_id)),
           (SELECT array_agg(DISTINCT cell ORDER BY cell) FROM box, streetgen._cell(west, south, east, north, size) cell)
        INTO gathered, cells;
END $body$ $sql$, model);
    PERFORM streetgen._own_function(model, '_reach(bigint[])', 'Of asked axes: the stale ones near, all whose rows a run for them writes; where none is stale, all that these are computed with, and the cells of all that it reads or writes, ascending');
END $$;
COMMENT ON FUNCTION streetgen._make_reach(name) IS 'Makes the function of a model that tells how far a run for some axes reaches.';

CREATE OR REPLACE FUNCTION streetgen._outside(model name, axes bigint[], missed integer[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    reach float8;
    far float8;
    outside bigint[];
BEGIN
    -- No pair of roadways reaches farther.
    EXECUTE format($sql$SELECT max(value::float8), max(value::float8) + coalesce((SELECT max(greatest(width, width_end)) FROM %1$I.axis_used), 0) FROM %1$I.setting WHERE name IN ('reach', 'max_arc_distance')$sql$, model) INTO reach, far;
    EXECUTE format($sql$
WITH line AS MATERIALIZED (SELECT axis_id, geom FROM %1$I.axis UNION ALL SELECT axis_id, geom FROM %1$I.edge),
size AS (SELECT value::float8 AS size FROM %1$I.setting WHERE name = 'cell_size'),
held AS MATERIALIZED (
    SELECT geom FROM %1$I.edge WHERE axis_id IN (
        SELECT axis_id FROM line, size, streetgen._cell(ST_XMin(geom) - 10, ST_YMin(geom) - 10, ST_XMax(geom) + 10, ST_YMax(geom) + 10, size) cell WHERE cell = ANY ($2))),
-- With the edges along which an intersection claims ground beside these.
reached AS MATERIALIZED (
    SELECT geom FROM held UNION ALL SELECT e.geom FROM %1$I.edge e JOIN %1$I.section_limit l USING (edge_id)
    WHERE greatest(e.width, e.width_end) / 2 + CASE l.which WHEN 'start' THEN l.abscissa ELSE ST_Length(e.geom) - l.abscissa END > $4
        AND EXISTS (SELECT FROM held h WHERE ST_DWithin(h.geom, e.geom, $3))),
inside AS (
    SELECT axis_id FROM line, size, streetgen._cell(ST_XMin(geom) - $3, ST_YMin(geom) - $3, ST_XMax(geom) + $3, ST_YMax(geom) + $3, size) cell
    WHERE axis_id = ANY ($1) AND cell = ANY ($2)
    UNION ALL SELECT a.axis_id FROM reached r JOIN %1$I.axis a ON ST_DWithin(a.geom, r.geom, $3)
    UNION ALL SELECT e.axis_id FROM reached r JOIN %1$I.edge e ON ST_DWithin(e.geom, r.geom, $3))
SELECT coalesce(array_agg(id), '{}') FROM (SELECT unnest($1) EXCEPT SELECT axis_id FROM inside) o(id) $sql$, model) INTO outside USING axes, missed, far, reach;
    RETURN outside;
END $$;
COMMENT ON FUNCTION streetgen._outside(name, bigint[], integer[]) IS 'Those of the axes for which a run reads or writes nothing in the cells missed.';

CREATE OR REPLACE FUNCTION streetgen._reach_of(model name, axes bigint[], OUT asked bigint[], OUT written bigint[], OUT gathered bigint[], OUT cells integer[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    stale bigint[] := axes;
BEGIN
    asked := '{}';
    written := '{}';
    gathered := '{}';
    cells := '{}';
    -- An axis that changed while nobody followed changes what is around it too.
    WHILE stale <> '{}' LOOP
        asked := asked || stale;
        EXECUTE format('SELECT * FROM %I._reach($1)', model) INTO stale, written, gathered, cells USING asked;
    END LOOP;
    cells := coalesce(cells, '{}');
END $$;
COMMENT ON FUNCTION streetgen._reach_of(name, bigint[]) IS 'What a run for some axes asks, writes and gathers, and its cells: stale axes near the asked ones are asked too.';

CREATE OR REPLACE FUNCTION streetgen._make_setting_changed(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- No run mixes settings: any edge tells.
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._setting_changed() RETURNS boolean
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT
    AS $body$
BEGIN
    RETURN coalesce((SELECT setting_hash FROM %1$I.edge LIMIT 1) <> (SELECT setting_hash FROM %1$I.setting_used), false);
END $body$ $sql$, model);
    PERFORM streetgen._own_function(model, '_setting_changed()', 'Were settings changed since the streets were computed?');
END $$;
COMMENT ON FUNCTION streetgen._make_setting_changed(name) IS 'Makes the function of a model that tells whether its settings changed.';

CREATE OR REPLACE FUNCTION streetgen._setting_changed(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    changed boolean;
BEGIN
    EXECUTE format('SELECT %I._setting_changed()', model) INTO changed;
    RETURN changed;
END $$;
COMMENT ON FUNCTION streetgen._setting_changed(name) IS 'Were settings of the model changed since its streets were computed?';

CREATE OR REPLACE FUNCTION streetgen._holders(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    SELECT coalesce(string_agg(format('%s (process %s%s)', coalesce(a.usename, '?'), l.pid, ', since ' || to_char(a.xact_start, 'HH24:MI:SS')), ', ' ORDER BY l.pid), 'It has ended since.')
    FROM (SELECT DISTINCT pid FROM pg_locks LEFT JOIN pg_class c ON locktype = 'relation' AND c.oid = relation AND relnamespace = quote_ident(model)::regnamespace
          WHERE database = (SELECT oid FROM pg_database WHERE datname = current_database()) AND granted AND pid <> pg_backend_pid()
              AND (locktype = 'advisory' AND objsubid = 2 AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid OR c.oid IS NOT NULL AND mode <> 'AccessShareLock')) l
    LEFT JOIN pg_stat_activity a USING (pid) $$;
COMMENT ON FUNCTION streetgen._holders(name) IS 'The other sessions that hold places, rows or tables of a model, as text.';

CREATE OR REPLACE FUNCTION streetgen._enter(model name, wait boolean, alone boolean, keys boolean DEFAULT true) RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    model_key constant integer := hashtext('streetgen.' || model);
    missing constant boolean := keys AND streetgen._keys_are_missing(model);
    entered boolean := true;
BEGIN
    IF current_setting('transaction_isolation') <> 'read committed' THEN
        RAISE EXCEPTION 'streets of model "%" need isolation level read committed, this transaction has %', model, current_setting('transaction_isolation')
            USING ERRCODE = '0A000', HINT = 'Under a higher level they would be computed from a snapshot older than the locks.';
    END IF;
    -- What runs goes by one state of the settings, grid of the places included: who changes one waits until it has ended.
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
    RAISE EXCEPTION 'another session holds model "%"', model USING ERRCODE = '55P03', DETAIL = streetgen._holders(model), HINT = 'Repeat this when it has ended, or raise lock_timeout.';
END $$;
COMMENT ON FUNCTION streetgen._enter(name, boolean, boolean, boolean) IS 'Locks the model for this transaction, its settings first: alone, or beside others that lock its places. keys: not before those that a first run by clusters left are made, for which it is alone. Without wait: whether it was free. A lock_timeout that ends: 55P03, naming who holds it; above read committed: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._refuse_place(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'another session works at this place of model "%"', model USING ERRCODE = '55P03', DETAIL = streetgen._holders(model), HINT = 'Repeat this when it has ended, or raise lock_timeout.';
END $$;
COMMENT ON FUNCTION streetgen._refuse_place(name) IS 'Raises 55P03, naming who holds places of the model.';

CREATE OR REPLACE FUNCTION streetgen._refuse_tables(model name, way_out text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'another session holds rows or tables of model "%"', model USING ERRCODE = '55P03', DETAIL = streetgen._holders(model), HINT = way_out;
END $$;
COMMENT ON FUNCTION streetgen._refuse_tables(name, text) IS 'Raises 55P03, naming who holds rows or tables of the model.';

CREATE OR REPLACE FUNCTION streetgen._claim_all(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM pg_advisory_xact_lock(hashtext('streetgen.' || model), -1);
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_place(model);
END $$;
COMMENT ON FUNCTION streetgen._claim_all(name) IS 'Locks all places of a model by one key, for this transaction. A lock_timeout that ends: 55P03, naming who holds some.';

CREATE OR REPLACE FUNCTION streetgen._claim(model name, axes bigint[], wait boolean, OUT asked bigint[], OUT changed bigint[], OUT written bigint[], OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- More cells than this are not worth their locks.
    most_cells constant integer := 64;
    -- The first key of each lock is the model; of the second 0 is the model, -1 all its cells.
    model_key constant integer := hashtext('streetgen.' || model);
    wanted integer[];
    missed integer[] := '{}';
    -- Stale axes at places that others hold.
    inside bigint[];
    reach record;
    cell integer;
    seen pg_snapshot := pg_current_snapshot();
BEGIN
    reach := streetgen._reach_of(model, axes);
    wanted := reach.cells;
    LOOP
        -- Locks are taken in one order: where more turn out to be needed, those taken here are given back first.
        BEGIN
            IF cardinality(wanted) > most_cells THEN
                IF wait THEN
                    PERFORM pg_advisory_xact_lock(model_key, -1);
                ELSIF NOT pg_try_advisory_xact_lock(model_key, -1) THEN
                    missed := wanted;
                END IF;
            ELSIF wait THEN
                PERFORM pg_advisory_xact_lock_shared(model_key, -1);
                FOREACH cell IN ARRAY wanted LOOP
                    PERFORM pg_advisory_xact_lock(model_key, cell);
                END LOOP;
            ELSIF NOT pg_try_advisory_xact_lock_shared(model_key, -1) THEN
                missed := wanted;
            ELSE
                FOREACH cell IN ARRAY wanted LOOP
                    IF NOT pg_try_advisory_xact_lock(model_key, cell) THEN
                        missed := missed || cell;
                    END IF;
                END LOOP;
            END IF;
            -- The same snapshot: nobody has committed meanwhile.
            IF pg_current_snapshot()::text <> seen::text THEN
                reach := streetgen._reach_of(model, axes);
            END IF;
            IF NOT reach.cells <@ wanted THEN
                wanted := ARRAY(SELECT DISTINCT c FROM unnest(wanted || reach.cells) c ORDER BY c);
                missed := '{}';
                RAISE SQLSTATE 'SG001';
            END IF;
        EXCEPTION
            WHEN SQLSTATE 'SG001' THEN CONTINUE;
            WHEN lock_not_available THEN
                PERFORM streetgen._refuse_place(model);
        END;
        EXIT;
    END LOOP;
    IF missed <> '{}' THEN
        axes := streetgen._outside(model, axes, missed);
        reach := streetgen._reach_of(model, axes);
        -- Stale axes lead on from one to the next, and may lead there.
        inside := ARRAY(SELECT unnest(reach.asked) EXCEPT SELECT unnest(streetgen._outside(model, reach.asked, missed)));
        IF inside <> '{}' THEN
            axes := ARRAY(SELECT a FROM unnest(axes) a WHERE NOT (streetgen._reach_of(model, ARRAY[a])).asked && inside);
            reach := streetgen._reach_of(model, axes);
        END IF;
    END IF;
    asked := axes;
    changed := reach.asked;
    written := reach.written;
    gathered := reach.gathered;
END $$;
COMMENT ON FUNCTION streetgen._claim(name, bigint[], boolean) IS 'Locks the places of all that a run for the axes reads or writes, for this transaction, in one order; without wait those of the axes whose places are free. Gives these axes, the same with stale ones near them, and what the run writes and gathers. A lock_timeout that ends: 55P03, naming who holds places.';
