-- Clusters computed one by one in many sessions: what each locks, progress, and the keys at the end.

CREATE OR REPLACE FUNCTION streetgen._footprint(model name, requested bigint[], written bigint[], OUT near bigint[],
    OUT districts integer[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    -- No two roadways are wider than 200 m.
    reach constant float8 := streetgen._change_reach(model) + 200;
    size float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value::float8 FROM setting WHERE name = 'cell_size' INTO size;
    WITH line AS MATERIALIZED (SELECT geom FROM axis WHERE axis_id = ANY (requested)
        UNION ALL SELECT geom FROM edge WHERE axis_id = ANY (requested)),
    hull AS MATERIALIZED (SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) AS geom FROM line),
    beside AS MATERIALIZED (SELECT e.axis_id, e.from_node, e.to_node FROM hull h
        JOIN edge e ON ST_DWithin(e.geom, h.geom, reach)),
    node AS MATERIALIZED (SELECT from_node AS node_id FROM beside UNION SELECT to_node FROM beside),
    id AS MATERIALIZED (
        SELECT array_agg(axis_id) AS axes FROM (
            SELECT a.axis_id FROM hull h JOIN axis a ON ST_DWithin(a.geom, h.geom, reach)
                UNION SELECT axis_id FROM beside UNION SELECT unnest(written)
            -- The far end of an edge may move, however far it is.
            UNION SELECT axis_id FROM edge WHERE from_node = ANY (ARRAY(SELECT node_id FROM node))
                UNION SELECT axis_id FROM edge WHERE to_node = ANY (ARRAY(SELECT node_id FROM node))) i),
    beside_line AS MATERIALIZED (SELECT a.geom FROM id JOIN axis a ON axis_id = ANY (axes)
        UNION ALL SELECT e.geom FROM id JOIN edge e ON axis_id = ANY (axes)),
    box AS MATERIALIZED (
        SELECT DISTINCT streetgen._district_of(ST_XMin(geom) - margin, size) AS west,
            streetgen._district_of(ST_YMin(geom) - margin, size) AS south,
            streetgen._district_of(ST_XMax(geom) + margin, size) AS east,
            streetgen._district_of(ST_YMax(geom) + margin, size) AS north
        FROM (SELECT geom, reach AS margin FROM line UNION ALL SELECT geom, 10 FROM beside_line
            UNION ALL SELECT geom, 10 FROM _merging_run(requested || written)
            UNION ALL SELECT geom, 10 FROM _marked_run(requested || written)) g)
    SELECT (SELECT axes FROM id),
           (SELECT array_agg(DISTINCT key) FROM box, streetgen._districts(west, south, east, north) key)
        INTO near, districts;
    -- An axis that is gone without a trace leaves nothing to be locked.
    near := near || requested || written;
    districts := coalesce(districts, '{}');
END $$;
COMMENT ON FUNCTION streetgen._footprint(name, bigint[], bigint[]) IS
    'The keys of the districts of a model in which a run for many axes (requested) may read or write, by which it '
    'keeps edits and other clusters away. near: the axes that lie there whole, requested and written among them.';

CREATE OR REPLACE FUNCTION streetgen._axes_from_afar(model name, axes bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    afar bigint[] := '{}';
    name name;
    found bigint[];
BEGIN
    FOR name IN SELECT format('_%s_axes_from_afar', room) FROM unnest(streetgen._subjects(model)) room LOOP
        IF to_regprocedure(format('streetgen.%I(name, bigint[])', name)) IS NOT NULL THEN
            EXECUTE format('SELECT streetgen.%I($1, $2)', name) INTO found USING model, axes;
            afar := afar || found;
        END IF;
    END LOOP;
    RETURN afar;
END $$;
COMMENT ON FUNCTION streetgen._axes_from_afar(name, bigint[]) IS
    'The axes beyond the reach with which streets of these axes are computed, from functions _ROOM_axes_from_afar.';

CREATE OR REPLACE FUNCTION streetgen._surroundings(model name, axes bigint[], OUT requested bigint[],
    OUT written bigint[], OUT gathered bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    -- Nothing is known of how many lie around: what is not looked up by place is joined on equal keys. A plan for all
    -- calls would not know the reach either.
    SET enable_nestloop = off SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    reach constant float8 := streetgen._change_reach(model);
    -- Axes that share a node are nearer.
    near constant float8 := 3 * streetgen._tolerance(model);
    -- No roadway is wider.
    widest constant float8 := 200;
    afar bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- Fewer axes lie around than inside: the query begins with those around.
    WITH hull AS MATERIALIZED (SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) AS geom FROM axis
        WHERE axis_id = ANY (axes)),
    around AS MATERIALIZED (
        SELECT a.axis_id, a.geom FROM hull h, LATERAL (SELECT axis_id, geom FROM axis a
            WHERE ST_DWithin(a.geom, h.geom, near) OFFSET 0) a
        WHERE a.axis_id <> ALL (axes) AND (SELECT true FROM edge e WHERE e.axis_id = a.axis_id LIMIT 1))
    SELECT axes || ARRAY(SELECT axis_id FROM around a WHERE (
        SELECT true FROM (SELECT o.axis_id FROM axis o WHERE ST_DWithin(o.geom, a.geom, near) OFFSET 0) o
            WHERE o.axis_id = ANY (axes) LIMIT 1)) INTO written;
    afar := streetgen._axes_from_afar(model, written);
    WITH inside AS MATERIALIZED (SELECT axis_id, greatest(width, width_end) / 2 + abs(roadway_offset) AS half
        FROM axis_used
        WHERE axis_id = ANY (written)),
    around AS MATERIALIZED (
        SELECT axis_id, geom, half, most FROM (SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) AS hull,
            (SELECT max(half) FROM inside) AS most FROM axis WHERE axis_id = ANY (written)) h,
            LATERAL (SELECT axis_id, geom, greatest(width, width_end) / 2 + abs(roadway_offset) AS half
                FROM axis_used u
                WHERE ST_DWithin(u.geom, hull, reach + widest) AND u.axis_id <> ALL (written) OFFSET 0) u
        WHERE ST_DWithin(geom, hull, reach + half + most)),
    near AS MATERIALIZED (
        SELECT DISTINCT ON (p.axis_id) p.axis_id, p.geom FROM (
            SELECT u.axis_id, u.geom, u.half, o.axis_id AS other, o.geom AS line
                FROM around u, LATERAL (SELECT axis_id, geom FROM axis a
                WHERE a.geom && ST_Expand(u.geom, reach + u.half + most) OFFSET 0) o) p
        JOIN inside w ON w.axis_id = other WHERE ST_DWithin(line, p.geom, reach + p.half + w.half)),
    beside AS MATERIALIZED (
        SELECT axis_id, geom FROM near
        UNION ALL SELECT a.axis_id, a.geom FROM axis a WHERE a.axis_id = ANY (afar) AND a.axis_id <> ALL (written)
            AND a.axis_id NOT IN (SELECT axis_id FROM near)),
    -- Axes that meet these farther on bound their edges, and corners follow an axis to the next. So do those that
    -- meet them again. Axes that meet those inside lie beside them.
    met AS MATERIALIZED (
        SELECT DISTINCT ON (m.axis_id) m.axis_id, m.geom FROM beside b, LATERAL (SELECT axis_id, geom FROM axis a
            WHERE ST_DWithin(a.geom, b.geom, near) OFFSET 0) m
        WHERE m.axis_id <> ALL (written) AND m.axis_id NOT IN (SELECT axis_id FROM beside))
    SELECT array_agg(axis_id) FROM (
        SELECT unnest(written) AS axis_id UNION SELECT axis_id FROM beside UNION SELECT axis_id FROM met
        UNION SELECT m.axis_id FROM met b, LATERAL (SELECT axis_id FROM axis a
            WHERE ST_DWithin(a.geom, b.geom, near) OFFSET 0) m) g INTO gathered;
    requested := axes;
END $$;
COMMENT ON FUNCTION streetgen._surroundings(name, bigint[]) IS
    'What a run for axes without streets writes and gathers where nothing around them changes by it, since all that '
    'is computed there was computed with them: as _reach_of, but by the places of axes alone. Of others it writes '
    'those that they meet.';

CREATE OR REPLACE FUNCTION streetgen._clusters_beside(model name, cluster integer) RETURNS integer[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    beside integer[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- Axes that share a node are nearer.
    SELECT ARRAY(SELECT o.cluster_id FROM cluster k JOIN cluster o ON o.ended IS NULL
        AND o.cluster_id <> k.cluster_id AND ST_DWithin(o.hull, k.hull, reach) WHERE k.cluster_id = cluster)
    FROM (SELECT sum(CASE name WHEN 'tolerance' THEN 3 ELSE 1 END * value::float8) AS reach FROM setting
        WHERE name IN ('reach', 'tolerance')) s INTO beside;
    RETURN beside;
END $$;
COMMENT ON FUNCTION streetgen._clusters_beside(name, integer) IS
    'The clusters that have not ended and may share nodes with a cluster.';

CREATE OR REPLACE FUNCTION streetgen._lock_cluster(model name, cluster integer, axes bigint[], wait boolean,
    OUT free boolean, OUT first_run boolean, OUT changed bigint[], OUT written bigint[], OUT gathered bigint[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Keys of clusters are below those of districts.
    cluster_key constant integer := -1073741826;
    places record;
    reach record;
BEGIN
    first_run := streetgen._keys_are_missing(model);
    LOOP
        -- The locks taken here are given back first where more turns out to be needed, as _lock_places does.
        BEGIN
            IF first_run THEN
                -- No edit comes in before the keys are made.
                free := streetgen._lock_places(model, ARRAY[cluster_key - cluster], ARRAY[streetgen._door(), -1]
                    || ARRAY(SELECT cluster_key - beside
                        FROM unnest(streetgen._clusters_beside(model, cluster)) beside), wait);
            ELSE
                places := coalesce(places, streetgen._footprint(model, axes, '{}'));
                -- A cluster touches more chains than are worth their locks.
                free := streetgen._lock_places(model, places.districts || CASE WHEN streetgen._has_chains(model)
                    THEN ARRAY[streetgen._all_chains()] ELSE '{}' END, ARRAY[streetgen._door(), -1], wait);
            END IF;
            IF NOT free THEN
                RAISE SQLSTATE 'SG001';
            END IF;
            IF first_run THEN
                reach := streetgen._surroundings(model, axes);
            ELSE
                reach := streetgen._reach_of(model, axes);
                IF EXISTS (SELECT unnest(reach.requested)
                    EXCEPT SELECT unnest(axes)) OR EXISTS (SELECT unnest(reach.written)
                    EXCEPT SELECT unnest(places.near)) THEN
                    places := streetgen._footprint(model, reach.requested, reach.written);
                    axes := reach.requested;
                    RAISE SQLSTATE 'SG001';
                END IF;
            END IF;
        EXCEPTION
            WHEN SQLSTATE 'SG001' THEN
                EXIT WHEN NOT free;
                CONTINUE;
            WHEN lock_not_available OR deadlock_detected THEN
                PERFORM streetgen._refuse_place(model);
        END;
        EXIT;
    END LOOP;
    IF free THEN
        changed := reach.requested;
        written := reach.written;
        gathered := reach.gathered;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._lock_cluster(name, integer, bigint[], boolean) IS
    'Locks the places of a cluster for this transaction, or, where it is the first run of the model, the cluster and '
    'those beside it; gives what a run for it writes and gathers, and whether it is that first run. Without wait: not '
    'free where another session holds any of them, and nothing is locked.';

CREATE OR REPLACE FUNCTION streetgen.progress(model name)
    RETURNS TABLE(clusters integer, ended integer, sessions integer, axes bigint, axes_ended bigint, began timestamptz,
        axes_per_second float8, time_left interval)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model);
    RETURN QUERY
    SELECT clusters, ended, sessions, axes, axes_ended, began, rate, make_interval(secs => (axes - axes_ended) / rate)
    FROM (SELECT count(*)::integer AS clusters, count(k.ended)::integer AS ended,
        coalesce(sum(cardinality(k.axes)), 0)::bigint AS axes,
                 coalesce(sum(cardinality(k.axes)) FILTER (WHERE k.ended IS NOT NULL), 0)::bigint AS axes_ended,
                     min(k.began) AS began,
                 sum(cardinality(k.axes))
                     FILTER (WHERE k.ended IS NOT NULL) / nullif(sum(extract(epoch FROM k.ended - k.began)),
                     0)::float8 AS rate_of_one FROM cluster k) c,
         -- Keys of districts and clusters are negative, that of the door is the least; who waits does not compute.
         -- A large edit holds districts, too, but no row of a cluster.
         (SELECT count(*)::integer AS sessions FROM (SELECT
              FROM (SELECT *, database = (SELECT oid FROM pg_database WHERE datname = current_database()) AS here
                  FROM pg_locks) p
              GROUP BY pid HAVING bool_and(granted) AND bool_or(here AND locktype = 'advisory' AND objsubid = 2
                  AND classid = (hashtext('streetgen.' || model)::bigint & 4294967295)::oid
                  AND objid::bigint BETWEEN 2147483649 AND 4294967294 AND mode = 'ExclusiveLock')
              AND bool_or(here AND relation = (SELECT tableoid FROM cluster LIMIT 1) AND mode = 'RowShareLock')) l) s,
         LATERAL (SELECT rate_of_one * greatest(sessions, 1) AS rate) r;
END $$;
COMMENT ON FUNCTION streetgen.progress(name) IS
    'How far the run of a model by clusters is: clusters and those that ended, sessions that compute one now and do '
    'not wait, axes and those of ended clusters, when the first began, axes per second of so many sessions (of one '
    'where none is at work) and the time left at that rate; NULL before the first has ended. An unknown model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen.generate_cluster(model name, first integer DEFAULT NULL)
    RETURNS TABLE(cluster integer, axes integer, seconds float8, ended integer, clusters integer,
        axes_per_second float8, time_left interval)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    chosen record;
    locked record;
    free boolean := false;
    tried integer[] := '{}';
    wait boolean := false;
    started timestamptz;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._lock_model(model, wait => true, alone => false, keys => false);
    LOOP
        BEGIN
            -- What has most beside it first: those that are left at the end are apart, and no session waits for
            -- another.
            SELECT cluster_id, axes, setting_hash FROM cluster WHERE ended IS NULL AND cluster_id <> ALL (tried)
                ORDER BY cluster_id = coalesce(first, 0) DESC, cardinality(streetgen._clusters_beside(model,
                    cluster_id)) DESC, cluster_id
                LIMIT 1 FOR UPDATE SKIP LOCKED INTO chosen;
            IF chosen.cluster_id IS NULL AND tried = '{}' THEN
                -- All that is left is under way: should a session fail, its cluster is free again.
                SELECT cluster_id, axes, setting_hash FROM cluster WHERE ended IS NULL
                    ORDER BY cluster_id LIMIT 1 FOR UPDATE INTO chosen;
            END IF;
            IF chosen.cluster_id IS NOT NULL THEN
                IF chosen.setting_hash <> streetgen._setting_hash(model) THEN
                    RAISE EXCEPTION 'settings of model "%" changed since its clusters were planned', model
                        USING ERRCODE = '55000', HINT = format('SELECT streetgen.plan_clusters(%L) begins anew.',
                        model);
                END IF;
                started := clock_timestamp();
                locked := streetgen._lock_cluster(model, chosen.cluster_id, chosen.axes, wait);
                free := locked.free;
                IF NOT free THEN
                    RAISE SQLSTATE 'SG001';
                END IF;
            END IF;
        EXCEPTION WHEN SQLSTATE 'SG001' THEN
            tried := tried || chosen.cluster_id;
            CONTINUE;
        END;
        EXIT WHEN free;
        IF tried <> '{}' THEN
            -- Others work beside each cluster that is left.
            wait := true;
            tried := '{}';
        ELSE
            SELECT cluster_id FROM cluster WHERE ended IS NULL LIMIT 1 INTO chosen;
            IF chosen.cluster_id IS NULL THEN
                RETURN;
            END IF;
        END IF;
    END LOOP;
    IF locked.first_run THEN
        PERFORM FROM streetgen._upsert_set(model, locked.written, locked.gathered, locked.changed, 'cluster');
    ELSE
        PERFORM FROM streetgen._upsert_part(model, locked.written, locked.gathered, locked.changed);
    END IF;
    UPDATE cluster SET began = started, ended = clock_timestamp(), session = pg_backend_pid()
        WHERE cluster_id = chosen.cluster_id;
    RETURN QUERY SELECT chosen.cluster_id, cardinality(chosen.axes),
        extract(epoch FROM clock_timestamp() - started)::float8, p.ended, p.clusters, p.axes_per_second, p.time_left
        FROM streetgen.progress(model) p;
END $$;
COMMENT ON FUNCTION streetgen.generate_cluster(name, integer) IS
    'Computes the next cluster of a run planned by streetgen.plan_clusters that is free, the one numbered first if it '
    'is, else of those that are left the one with most beside it, and gives how far the run is then; no row where '
    'none is left. Each call is to be a transaction of its own; as many sessions as one likes repeat it until there '
    'is no row. Rows shared with clusters computed before are finished, so that after the last one the model is as '
    'streetgen.generate makes it, with other ids; a first run ends with streetgen.finish_clusters. A session that '
    'ends takes nothing along: what it had not committed is computed by the next. Sessions keep apart by places; '
    'where only places beside others are left it waits for them, and for edits. Needs read committed (0A000) and the '
    'rights of the owner (42501). Settings that changed since the plan: 55000; lock_timeout that ends: 55P03.';

CREATE OR REPLACE FUNCTION streetgen.finish_clusters(model name) RETURNS text
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    made text;
BEGIN
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._lock_model(model, wait => true, alone => false, keys => false);
    IF streetgen._keys_are_missing(model) THEN
        made := streetgen._restore_key(model);
        -- The last one leaves nothing behind.
        IF made IS NULL AND pg_try_advisory_xact_lock(hashtext('streetgen.' || model), 0) THEN
            PERFORM streetgen._make_keys(model);
        END IF;
    END IF;
    RETURN made;
END $$;
COMMENT ON FUNCTION streetgen.finish_clusters(name) IS
    'After the last cluster of a first run: makes the next of the foreign keys, indexes and statistics that it left '
    'for its end, and says what it made; NULL when none is left. Each call is to be a transaction of its own; as many '
    'sessions as one likes repeat it. Whatever else enters the model before, an edit or streetgen.generate, makes '
    'them all first. Needs the rights of the owner (42501).';

CREATE OR REPLACE PROCEDURE streetgen.generate_clusters(model name)
    LANGUAGE plpgsql
    AS $$
DECLARE
    told record;
BEGIN
    LOOP
        SELECT * INTO told FROM streetgen.generate_cluster(model);
        EXIT WHEN told.cluster IS NULL;
        COMMIT;
        RAISE INFO 'cluster %: % axes in % s; % of % done, % axes/s, % left', told.cluster, told.axes,
            pg_catalog.round(told.seconds::numeric, 1), told.ended, told.clusters,
            pg_catalog.round(told.axes_per_second), pg_catalog.date_trunc('second', told.time_left);
        -- Waiting, a session whose server was killed sees it, and ends.
        PERFORM pg_catalog.pg_sleep(0.001);
    END LOOP;
    IF streetgen._keys_are_missing(model) THEN
        RAISE INFO 'no cluster is left to begin: making indexes, foreign keys and statistics';
    END IF;
    WHILE streetgen.finish_clusters(model) IS NOT NULL LOOP
        COMMIT;
    END LOOP;
    COMMIT;
    -- The last one of sessions that end together clears up.
    PERFORM streetgen._lock_model(model, wait => true, alone => false);
END $$;
COMMENT ON PROCEDURE streetgen.generate_clusters(name) IS
    'Computes clusters of a run planned by streetgen.plan_clusters, each in a transaction of its own, until none is '
    'left, and tells of each; then what a first run left for its end, by streetgen.finish_clusters. As many sessions '
    'as one likes call it. Not within a transaction (2D000); errors as for streetgen.generate_cluster.';
