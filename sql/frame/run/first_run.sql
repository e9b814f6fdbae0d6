-- A whole model at once. Where nothing was derived yet its rows come first, then keys, indexes and statistics.

CREATE OR REPLACE FUNCTION streetgen._has_no_results(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- For fewer axes taking off costs more than it saves.
    worth_it constant integer := 1000;
    relation name;
    held boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT count(*) < worth_it FROM (SELECT FROM axis LIMIT worth_it) a INTO held;
    FOREACH relation IN ARRAY streetgen._computed_tables(model) LOOP
        EXIT WHEN held;
        EXECUTE format('SELECT EXISTS (SELECT FROM %I.%I)', model, relation) INTO held;
    END LOOP;
    -- Triggers of others may see rows as they come; ids that others step by are asked for one by one.
    RETURN NOT held AND NOT EXISTS (SELECT FROM pg_sequence JOIN pg_class c ON c.oid = seqrelid
        WHERE relnamespace = quote_ident(model)::regnamespace AND seqincrement <> 1)
        AND NOT EXISTS (SELECT FROM pg_class c LEFT JOIN pg_trigger t ON tgrelid = c.oid AND NOT tgisinternal
        AND tgname NOT IN ('by_hand', 'by_hand_truncate')
        WHERE relnamespace = quote_ident(model)::regnamespace AND relname = ANY (streetgen._computed_tables(model))
            AND (t.oid IS NOT NULL OR NOT pg_has_role(relowner, 'USAGE')));
END $$;
COMMENT ON FUNCTION streetgen._has_no_results(name) IS
    'Is a model of a thousand axes and more without a derived row, its tables the caller''s and without triggers of '
    'others, and its ids in steps of one?';

CREATE OR REPLACE FUNCTION streetgen._analyse(relation regclass) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- ANALYZE mostly sorts boxes under the default sample of 30,000 rows a table. PostGIS tells of each table whose
    -- geometries lie alike.
    SET default_statistics_target = 25 SET client_min_messages = warning
    AS $$
BEGIN
    EXECUTE format('ANALYZE %s', relation);
END $$;
COMMENT ON FUNCTION streetgen._analyse(regclass) IS
    'First statistics of a table just filled, from 7,500 rows whatever default_statistics_target is; autovacuum '
    'renews them as rows change.';

CREATE OR REPLACE FUNCTION streetgen._validate(relation regclass, name name, cure text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    validate constant text := format('ALTER TABLE %s VALIDATE CONSTRAINT %I', relation, name);
BEGIN
    EXECUTE validate;
EXCEPTION WHEN foreign_key_violation THEN
    IF cure IS NULL THEN
        RAISE;
    END IF;
    EXECUTE cure;
    EXECUTE validate;
END $$;
COMMENT ON FUNCTION streetgen._validate(regclass, name, text) IS
    'Validates a constraint of a table; where a row violates it, after a statement that lets such rows go.';

CREATE OR REPLACE FUNCTION streetgen._drop_keys(model name, relations name[], by_cluster boolean DEFAULT false)
    RETURNS TABLE(turn integer, relation name, statement text)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    SET lock_timeout = '2s'
    AS $$
DECLARE
    vacuumed regclass;
    off text[];
    turns integer[];
    tables name[];
    statements text[];
BEGIN
    -- A table that nobody but autovacuum uses is waited for: autovacuum gives way to who waits for a second.
    FOR vacuumed IN SELECT r.name FROM (SELECT format('%I.%I', model, name)::regclass AS name
            FROM unnest(relations) name) r
        WHERE (SELECT bool_and(mode = 'ShareUpdateExclusiveLock') FROM pg_locks l WHERE l.relation = r.name
            AND database = (SELECT oid FROM pg_database WHERE datname = current_database())
            AND pid <> pg_backend_pid())
    LOOP
        EXECUTE 'LOCK TABLE ' || vacuumed || ' IN ACCESS EXCLUSIVE MODE';
    END LOOP;
    EXECUTE (SELECT 'LOCK TABLE ' || string_agg(format('%I.%I', model, name), ', ')
        || ' IN ACCESS EXCLUSIVE MODE NOWAIT' FROM unnest(relations) name);
    WITH derived AS (SELECT c.oid, relname, relreplident, c.oid::regclass::text AS name FROM pg_class c
        WHERE relnamespace = quote_ident(model)::regnamespace AND relname = ANY (relations)),
    -- Foreign keys between them.
    reference AS (
        SELECT k.*, d.relname, d.name AS relation, format('ALTER TABLE %s ADD CONSTRAINT %I %s', d.name, conname,
            pg_get_constraintdef(k.oid)) AS back,
               format('COMMENT ON CONSTRAINT %I ON %s IS %L', conname, d.name, obj_description(k.oid, 'pg_constraint'))
                   AS said
        FROM pg_constraint k JOIN derived d ON d.oid = k.conrelid
        WHERE contype = 'f' AND convalidated AND confrelid IN (SELECT d.oid FROM derived d)
            AND NOT EXISTS (SELECT FROM pg_trigger WHERE tgconstraint = k.oid AND tgenabled <> 'O')),
    -- Indexes that no replication and nobody else builds on, and nothing but a comment says more of: of a constraint,
    -- or of none. Clusters find rows by keys, and by these.
    free_index AS (
        SELECT d.relname, d.name AS relation, i.indexrelid, i.indisunique, k.oid AS key, k.conname
        FROM pg_index i JOIN derived d ON d.oid = i.indrelid JOIN pg_class c ON c.oid = i.indexrelid
            LEFT JOIN pg_constraint k ON k.conindid = i.indexrelid AND k.conrelid = i.indrelid
                AND k.contype IN ('p', 'u', 'x')
        WHERE NOT i.indisexclusion AND NOT i.indisclustered AND NOT i.indisreplident AND i.indisvalid
            -- A published table says by its primary key which row goes, unless told otherwise.
            AND NOT (i.indisprimary AND d.relreplident = 'd' AND EXISTS (SELECT FROM pg_publication_tables
                WHERE schemaname = model AND tablename = d.relname)) AND c.reltablespace = 0
            AND CASE WHEN k.oid IS NULL THEN NOT i.indisunique ELSE c.reloptions IS NULL END
            AND NOT (by_cluster AND c.relam = (SELECT oid FROM pg_am WHERE amname = 'btree')
                AND (k.oid IS NOT NULL OR c.relname = ANY
                ('{edge_axis,interconnection_node,report_axis,report_other}')))
            AND NOT EXISTS (SELECT FROM pg_depend
                WHERE (refclassid, refobjid) IN (('pg_class'::regclass, i.indexrelid),
                ('pg_constraint'::regclass, k.oid))
                AND (classid, objid) <> ('pg_class'::regclass, i.indexrelid) AND (classid <> 'pg_constraint'::regclass
                    OR objid NOT IN (SELECT r.oid FROM reference r)))
            AND NOT EXISTS (SELECT FROM pg_depend WHERE (classid, objid) IN (('pg_class'::regclass, i.indexrelid),
                ('pg_constraint'::regclass, k.oid)) AND deptype NOT IN ('a', 'n', 'i'))
            AND NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = i.indexrelid AND attstattarget >= 0)),
    part AS (
        SELECT 1 AS turn, i.relname, i.indexrelid AS oid, format('DROP INDEX %s', i.indexrelid::regclass) AS off,
            regexp_replace(pg_get_indexdef(i.indexrelid), '^CREATE INDEX', 'CREATE INDEX IF NOT EXISTS') AS back,
               format('COMMENT ON INDEX %s IS %L', i.indexrelid::regclass, obj_description(i.indexrelid, 'pg_class'))
                   AS said
        FROM free_index i WHERE i.key IS NULL
        UNION ALL
        SELECT 1, i.relname, i.indexrelid, format('ALTER TABLE %s DROP CONSTRAINT %I', i.relation, i.conname),
            format('ALTER TABLE %s ADD CONSTRAINT %I %s', i.relation, i.conname, pg_get_constraintdef(i.key)),
               concat_ws('; ', format('COMMENT ON INDEX %s IS %L', i.indexrelid::regclass,
                   obj_description(i.indexrelid, 'pg_class')), format('COMMENT ON CONSTRAINT %I ON %s IS %L',
                   i.conname, i.relation, obj_description(i.key, 'pg_constraint')))
        FROM free_index i WHERE i.key IS NOT NULL
        UNION ALL
        SELECT 2, r.relname, r.oid, format('ALTER TABLE %s DROP CONSTRAINT %I', r.relation, conname),
            CASE WHEN by_cluster THEN format('SELECT streetgen._validate(%L, %L, %L)', r.relation, conname,
                   -- A cluster replaces rows of others now and then, and what belonged to them is still there.
                   CASE confdeltype WHEN 'c'
                       THEN format('DELETE FROM %s c WHERE NOT EXISTS (SELECT FROM %s p WHERE (%s) = (%s))',
                       r.relation, confrelid::regclass,
                       (SELECT string_agg(format('p.%I', attname), ', ' ORDER BY n)
                           FROM unnest(confkey) WITH ORDINALITY u(key, n) JOIN pg_attribute ON attrelid = confrelid
                           AND attnum = key),
                       (SELECT string_agg(format('c.%I', attname), ', ' ORDER BY n)
                           FROM unnest(conkey) WITH ORDINALITY u(key, n) JOIN pg_attribute ON attrelid = conrelid
                           AND attnum = key)) END) ELSE r.back END,
               CASE WHEN NOT by_cluster THEN r.said END
        FROM reference r),
    make AS (
        -- Clusters keep the keys that others refer to: tables are then made whole one beside another.
        SELECT 0 AS turn, NULL::name AS relname, string_agg(concat_ws('; ', r.back || ' NOT VALID', r.said), '; '
            ORDER BY r.oid) AS back FROM reference r WHERE by_cluster
        UNION ALL SELECT 1, d.relname,
            concat_ws('; ', (SELECT string_agg(concat_ws('; ', p.back, p.said), '; ' ORDER BY p.turn, p.oid)
            FROM part p WHERE (p.turn = 1 OR by_cluster) AND p.relname = d.relname),
            format('SELECT streetgen._analyse(%L)', d.name)) FROM derived d
        UNION ALL SELECT 2, NULL, string_agg(concat_ws('; ', p.back, p.said), '; ' ORDER BY p.oid) FROM part p
            WHERE p.turn = 2 AND NOT by_cluster)
    SELECT (SELECT array_agg(p.off ORDER BY p.turn DESC, p.oid) FROM part p), array_agg(m.turn), array_agg(m.relname),
        array_agg(m.back)
        INTO off, turns, tables, statements FROM make m WHERE m.back IS NOT NULL;
    FOR i IN 1 .. coalesce(cardinality(off), 0) LOOP
        EXECUTE off[i];
    END LOOP;
    RETURN QUERY SELECT * FROM unnest(turns, tables, statements);
EXCEPTION WHEN lock_not_available OR deadlock_detected OR object_in_use THEN
    RAISE WARNING 'tables of model "%" are in use: their keys and indexes stay on, and its first run takes longer',
        model USING DETAIL = SQLERRM;
END $$;
COMMENT ON FUNCTION streetgen._drop_keys(name, name[], boolean) IS
    'Takes foreign keys between tables of a model, and their indexes and keys of rows off them, which it locks '
    'against all others; not where something of others builds on them. Gives the statements that put them back, with '
    'their comments, and renew statistics: first (turn 1) indexes and keys of rows, a row a table, then foreign keys. '
    'by_cluster: keys stay on, and B-trees by which a cluster finds rows; foreign keys come first, not valid (turn '
    '0), so that the rows of the tables can be put in force one beside another; what a foreign key would have deleted '
    'goes. No row, nothing changed and a warning where somebody uses a table.';

CREATE OR REPLACE FUNCTION streetgen._truncate_results(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    derived regclass[] := ARRAY(SELECT format('%I.%I', model, d.relation)::regclass
        FROM unnest(streetgen._computed_tables(model)) d(relation));
BEGIN
    -- TRUNCATE refuses a table that one of others refers to.
    IF current_setting('wal_level') = 'minimal' AND NOT EXISTS (SELECT FROM pg_constraint WHERE contype = 'f'
        AND confrelid = ANY (derived)) THEN
        EXECUTE 'TRUNCATE ' || array_to_string(derived, ', ');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._truncate_results(name) IS
    'Begins the files of the derived tables of an empty model anew, after its keys were taken off: where wal_level is '
    'minimal, what a transaction writes into files that it began is synced at its end and not logged.';

CREATE OR REPLACE FUNCTION streetgen._advance_sequences(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE (SELECT 'SELECT ' || string_agg(format('setval(%L, (SELECT max(%I) FROM %s))',
        pg_get_serial_sequence(attrelid::regclass::text, attname), attname, attrelid::regclass), ', ')
        FROM unnest(streetgen._computed_tables(model)) d(relation)
            JOIN pg_attribute ON attrelid = format('%I.%I', model, d.relation)::regclass AND attidentity <> '');
END $$;
COMMENT ON FUNCTION streetgen._advance_sequences(name) IS
    'Moves the sequences of the derived tables to the last id: the rows of an empty model take as many from where each '
    'stands, which asks it once and not a row.';

CREATE OR REPLACE FUNCTION streetgen._upsert_whole(model name)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    back text[] := '{}';
BEGIN
    IF streetgen._has_no_results(model) THEN
        back := ARRAY(SELECT t.statement FROM streetgen._drop_keys(model, streetgen._computed_tables(model)) t
            ORDER BY t.turn);
        IF back <> '{}' THEN
            PERFORM streetgen._truncate_results(model);
        END IF;
    END IF;
    RETURN QUERY SELECT u.relation, u.inserted, u.updated, u.deleted, u.unchanged, u.fallbacks
        FROM streetgen._upsert_set(model, NULL, NULL, NULL, CASE back WHEN '{}' THEN 'whole' ELSE 'empty' END) u;
    FOR i IN 1 .. cardinality(back) LOOP
        EXECUTE back[i];
    END LOOP;
    IF back <> '{}' THEN
        PERFORM streetgen._advance_sequences(model);
    END IF;
    -- Groups find their rows by keys.
    RETURN QUERY SELECT * FROM streetgen._update_groups(model, NULL);
    IF back <> '{}' THEN
        PERFORM streetgen._analyse(format('%I.%I', model, t.relation)::regclass) FROM streetgen._computed_table() t
            JOIN unnest(streetgen._subjects_of_reach('group')) of_group ON of_group = t.subject
            JOIN unnest(streetgen._subjects(model)) computed ON computed = t.subject;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._upsert_whole(name) IS
    'Computes and upserts all streets of a model, for its owner and alone in it. Where it is empty, indexes and keys '
    'are made after the rows, and statistics with them; they are the same as before.';
