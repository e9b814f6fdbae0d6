-- Keys that a first run by clusters does without: they wait in a table of the model that is there as long as one is
-- missing.

CREATE OR REPLACE FUNCTION streetgen._keys_are_missing(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- By what is committed: who waited for a lock of the model knows old names until it meets a lock of a table.
    RETURN EXISTS (SELECT FROM pg_class WHERE relname = 'deferred_key'
        AND relnamespace = to_regnamespace(quote_ident(model)));
END $$;
COMMENT ON FUNCTION streetgen._keys_are_missing(name) IS
    'Is a model computed by clusters for the first time, without foreign keys and most indexes?';

CREATE OR REPLACE FUNCTION streetgen._defer_keys(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    taken_off integer;
    writer oid;
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TABLE deferred_key (turn integer NOT NULL, relation name, statement text NOT NULL);
    COMMENT ON TABLE deferred_key IS
        'Foreign keys, indexes and statistics that the first run by clusters makes at its end, or the first edit '
        'before; the table is there as long as any is missing';
    COMMENT ON COLUMN deferred_key.turn IS 'what is made first, from 0';
    COMMENT ON COLUMN deferred_key.relation IS
        'table whose indexes and statistics they are, and whose foreign keys they validate; NULL: the foreign keys, '
        'not valid';
    COMMENT ON COLUMN deferred_key.statement IS 'makes them';
    EXECUTE format('ALTER TABLE deferred_key OWNER TO %s', (SELECT nspowner::regrole FROM pg_namespace
        WHERE nspname = model));
    -- Its statements are done with the owner's rights, whoever may write new tables by default.
    FOR writer IN SELECT DISTINCT grantee FROM pg_class, aclexplode(relacl)
        WHERE oid = format('%I.deferred_key', model)::regclass AND grantee <> relowner LOOP
        EXECUTE format('REVOKE INSERT, UPDATE, DELETE, TRUNCATE, TRIGGER ON %I.deferred_key FROM %s', model, CASE writer
            WHEN 0 THEN 'PUBLIC' ELSE writer::regrole::text END);
    END LOOP;
    INSERT INTO deferred_key SELECT * FROM streetgen._drop_keys(model, streetgen._computed_tables(model),
        by_cluster => true);
    GET DIAGNOSTICS taken_off = ROW_COUNT;
    IF taken_off = 0 THEN
        EXECUTE format('DROP TABLE %I.deferred_key', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._defer_keys(name) IS
    'Takes foreign keys and indexes that clusters do not need off the tables of an empty model, for _restore_key '
    'to make, not where somebody uses a table. Only the owner may write what waits there.';

CREATE OR REPLACE FUNCTION streetgen._restore_key(model name) RETURNS text
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    key record;
BEGIN
    -- Tables wait for the foreign keys between them.
    EXECUTE format('SELECT FROM %I.deferred_key WHERE turn = 0 FOR UPDATE', model);
    EXECUTE format('SELECT ctid AS place, relation, statement FROM %1$I.deferred_key k ORDER BY turn, '
        'pg_relation_size(to_regclass(%2$L || quote_ident(relation))) DESC LIMIT 1 FOR UPDATE SKIP LOCKED', model,
        quote_ident(model) || '.') INTO key;
    IF key.place IS NOT NULL THEN
        EXECUTE key.statement;
        EXECUTE format('DELETE FROM %I.deferred_key WHERE ctid = $1', model) USING key.place;
        RETURN coalesce('indexes and statistics of ' || key.relation, 'foreign keys');
    END IF;
    RETURN NULL;
EXCEPTION WHEN object_in_use THEN
    PERFORM streetgen._refuse('55006',
        format('keys of model "%s" are missing, and cannot be made while a statement of this session reads its tables',
            model), detail => SQLERRM,
        hint => format('Edit an axis first, or end the first run by clusters: CALL streetgen.generate_clusters(%L).',
            model));
END $$;
COMMENT ON FUNCTION streetgen._restore_key(name) IS
    'Makes the next of the keys that are missing and that no other session makes, and says what it made; NULL: none '
    'is left. A statement of this session that reads the tables, such as an edit of a view of them: 55006.';

CREATE OR REPLACE FUNCTION streetgen._make_keys(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    LOOP
        EXIT WHEN streetgen._restore_key(model) IS NULL;
    END LOOP;
    PERFORM streetgen._finish_clusters(model);
    EXECUTE format('DROP TABLE %I.deferred_key', model);
END $$;
COMMENT ON FUNCTION streetgen._make_keys(name) IS
    'Makes all keys that are missing, and the chains and groups that clusters left, for who is alone in the model.';
