-- Settings are changed, each within its range.

CREATE OR REPLACE FUNCTION streetgen.set(model name, setting text, value text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    switches_log boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._check_given('setting', setting);
    value := streetgen._check_setting(model, setting, value);
    switches_log := setting = 'log' AND value IS DISTINCT FROM (SELECT s.value FROM setting s WHERE s.name = 'log');
    IF switches_log THEN
        PERFORM streetgen._hold_street_input(model);
    END IF;
    -- One at a time, since each goes on to hold out the other.
    LOCK TABLE setting IN SHARE ROW EXCLUSIVE MODE;
    INSERT INTO setting AS s SELECT d.name, set.value, d.unit, d.description, d.minimum, d.maximum, d.choice
        FROM streetgen._default_setting() d WHERE d.name = setting
        ON CONFLICT (name) DO UPDATE SET value = excluded.value WHERE s.value IS DISTINCT FROM excluded.value;
    IF switches_log THEN
        PERFORM streetgen._make_edit_log(model);
    END IF;
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.set(name, text, text) IS
    'Changes a setting of a model within its range (22023 outside, 22004 for NULL where it has no such meaning; a '
    'function that would hand on rights: 42501), also one that was deleted, once edits and runs under way have '
    'ended; rows computed before are stale until generate. A lock_timeout that ends: 55P03, naming who holds the '
    'settings. Setting log waits until nobody reads or writes axes or decisions.';
