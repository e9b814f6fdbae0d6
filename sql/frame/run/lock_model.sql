-- An edit or a run locks the model, alone or beside others, once the keys that a first run left are made.

CREATE OR REPLACE FUNCTION streetgen._lock_model(model name, wait boolean, alone boolean, keys boolean DEFAULT true)
    RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    model_key constant integer := hashtext('streetgen.' || model);
    missing constant boolean := keys AND streetgen._keys_are_missing(model);
    entered boolean := true;
BEGIN
    PERFORM streetgen._use_model(model);
    IF current_setting('transaction_isolation') <> 'read committed' THEN
        PERFORM streetgen._refuse('0A000',
            format('streets of model "%s" need isolation level read committed, this transaction has %s', model,
                current_setting('transaction_isolation')),
            hint => 'Under a higher level they would be computed from a snapshot older than the locks.');
    END IF;
    -- A run goes by one state of the settings, grid of the places included: whoever changes one waits until it has
    -- ended.
    LOCK TABLE setting IN SHARE MODE;
    CASE
        WHEN wait AND (alone OR missing) THEN PERFORM pg_advisory_xact_lock(model_key, 0);
        WHEN wait THEN PERFORM pg_advisory_xact_lock_shared(model_key, 0);
        WHEN alone OR missing THEN entered := pg_try_advisory_xact_lock(model_key, 0);
        ELSE entered := pg_try_advisory_xact_lock_shared(model_key, 0);
    END CASE;
    -- Another session may have made them meanwhile.
    IF missing AND entered AND streetgen._keys_are_missing(model) THEN
        PERFORM streetgen._make_keys(model);
    END IF;
    RETURN entered;
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    PERFORM streetgen._refuse('55P03', format('another session holds model "%s"', model),
        detail => streetgen._holders(model), hint => 'Repeat this when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen._lock_model(name, boolean, boolean, boolean) IS
    'Locks the model for this transaction, its settings first: alone, or beside others that lock its places. keys: '
    'not before those that a first run by clusters left are made, for which it is alone. Without wait: whether it was '
    'free. A lock_timeout that ends: 55P03, naming who holds it; above read committed: 0A000.';
