-- Keys that somebody wrote himself: generated ones go on after them.

CREATE OR REPLACE FUNCTION streetgen._generated_key(model name, relation name) RETURNS name
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT attname FROM pg_attribute
            JOIN pg_index ON indrelid = attrelid AND indisprimary AND attnum = ANY (indkey)
        WHERE attrelid = format('%I.%I', model, relation)::regclass AND attidentity <> '' $$;
COMMENT ON FUNCTION streetgen._generated_key(name, name) IS
    'The column of a table of a model that is numbered where a row leaves it out; NULL for none.';

CREATE OR REPLACE FUNCTION streetgen._passing_key(keys text, key text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    -- Others number rows meanwhile: nextval goes on from theirs, and none takes a thousand at once.
    RETURN format('SELECT count(CASE WHEN ahead > 1000 THEN setval(%1$L, key) ELSE nextval(%1$L) END) FROM '
        '(SELECT k AS key, k - last_value + (NOT is_called)::integer AS ahead FROM %1$s, greatest(%2$s, 0) k) s, '
        'generate_series(1, CASE WHEN ahead > 1000 THEN 1 ELSE ahead END) WHERE key < $2', keys, key);
COMMENT ON FUNCTION streetgen._passing_key(text, text) IS
    'The statement by which generated keys go on after a key: the sequence, the key as SQL. $2 is _last_passed_key().';

CREATE OR REPLACE FUNCTION streetgen._pass_taken_keys(model name, relation name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    key constant name := streetgen._generated_key(model, relation);
    last constant bigint := streetgen._last_passed_key();
    taken bigint;
BEGIN
    EXECUTE format('SELECT max(%1$I) FROM %2$I.%3$I WHERE %1$I < $1', key, model, relation) INTO taken USING last;
    EXECUTE streetgen._passing_key(pg_get_serial_sequence(format('%I.%I', model, relation), key), '$1')
        USING taken, last;
END $$;
COMMENT ON FUNCTION streetgen._pass_taken_keys(name, name) IS
    'Lets new rows of a table of a model be numbered after all that are there: keys that were written while the '
    'trigger own_key was not there, or was off.';

CREATE OR REPLACE FUNCTION streetgen._last_passed_key() RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN 1::bigint << 62;
COMMENT ON FUNCTION streetgen._last_passed_key() IS
    'Generated keys do not go on after this one or a greater one: it would leave too few numbers to others.';

CREATE OR REPLACE FUNCTION streetgen._make_own_keys(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
    key name;
BEGIN
    PERFORM streetgen._use_model(model);
    -- With the rights of the model's owner, as an editor may not set the sequence.
    CREATE OR REPLACE FUNCTION _pass_own_key() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        keys constant text := pg_get_serial_sequence(TG_RELID::regclass::text, TG_ARGV[0]);
        key bigint;
    BEGIN
        EXECUTE 'SELECT ($1).' || quote_ident(TG_ARGV[0]) INTO key USING NEW;
        -- Most keys are generated, and none is to be passed.
        IF keys IS NOT NULL AND key > coalesce(pg_sequence_last_value(keys), 0) THEN
            EXECUTE streetgen._passing_key(keys, '$1') USING key, streetgen._last_passed_key();
        END IF;
        RETURN NEW;
    END $body$;
    PERFORM streetgen._own_function(model, '_pass_own_key()',
        'Before a row: where somebody wrote its key himself, generated keys go on after it');
    FOR relation, key IN SELECT r, streetgen._generated_key(model, r) FROM unnest(streetgen._edited_tables(model)) r
    LOOP
        CONTINUE WHEN key IS NULL;
        PERFORM streetgen._pass_taken_keys(model, relation);
        EXECUTE format('CREATE OR REPLACE TRIGGER own_key BEFORE INSERT OR UPDATE OF %3$I ON %1$I.%2$I FOR EACH ROW '
            'EXECUTE FUNCTION %1$I._pass_own_key(%3$L); COMMENT ON TRIGGER own_key ON %1$I.%2$I IS %4$L', model,
            relation, key, 'Generated keys go on after one that somebody wrote himself');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_own_keys(name) IS
    'Makes the triggers on the input tables of a model that let generated keys go on after keys of one''s own.';
