-- Settings of a model: what there is, in which range, and how one is read and changed.

CREATE OR REPLACE FUNCTION streetgen._default_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 100 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('setting');
END $$;
COMMENT ON FUNCTION streetgen._default_setting() IS
    'The settings of a new model, with their ranges, from functions _ROOM_setting.';

CREATE OR REPLACE FUNCTION streetgen.setting(model name)
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model);
    RETURN QUERY SELECT * FROM setting s ORDER BY s.name;
END $$;
COMMENT ON FUNCTION streetgen.setting(name) IS 'The settings of a model. An unknown model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen._believed_setting(model name, setting text, value text, holds boolean,
    expected text) RETURNS text
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT holds THEN
        RAISE EXCEPTION 'setting "%" of model "%" cannot be %', setting, model, quote_literal(value)
            USING ERRCODE = '22023', HINT = expected;
    END IF;
    RETURN value;
END $$;
COMMENT ON FUNCTION streetgen._believed_setting(name, text, text, boolean, text) IS
    'The value of a setting that holds; of one that does not: 22023, saying what is expected.';

CREATE OR REPLACE FUNCTION streetgen._is_by_importance(value text, most float8) RETURNS boolean
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN NOT EXISTS (SELECT FROM jsonb_each_text(value::jsonb) e WHERE e.key !~ '^[1-9]\d?$'
        OR NOT (coalesce(e.value, '1')::float8 BETWEEN 0 AND most));
EXCEPTION WHEN data_exception THEN
    RETURN false;
END $$;
COMMENT ON FUNCTION streetgen._is_by_importance(text, float8) IS
    'Is a value of a setting a JSON object of importance (1 to 99) to numbers from 0 to the most?';

CREATE OR REPLACE FUNCTION streetgen._check_setting(model name, setting text, value text) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known record;
    holds boolean;
    expected text;
BEGIN
    SELECT * INTO known FROM streetgen._default_setting() d WHERE d.name = setting;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no setting "%"', setting USING ERRCODE = '22023',
            HINT = format('SELECT * FROM streetgen.setting(%L) lists them.', model);
    END IF;
    IF value IS NULL THEN
        -- The description of a setting that may be NULL says what that means.
        IF known.description ~ '\mNULL\M' THEN RETURN NULL; END IF;
        RAISE EXCEPTION 'the value of setting "%" of model "%" is NULL or missing', setting, model
            USING ERRCODE = '22004',
            HINT = format('SELECT streetgen.set(%L, %L, %L) puts the default back.', model, setting, known.value);
    END IF;
    IF to_regprocedure(format('streetgen.%I(name, text)', '_checked_' || setting)) IS NOT NULL THEN
        EXECUTE format('SELECT streetgen.%I($1, $2)', '_checked_' || setting) INTO value USING model, value;
        RETURN value;
    ELSIF value = ANY (known.choice) OR value = known.value THEN
        RETURN value;
    ELSIF EXISTS (SELECT FROM streetgen._setting_function() f WHERE f.setting = _check_setting.setting) THEN
        RETURN streetgen._called_function(model, setting, value);
    ELSIF known.choice IS NOT NULL THEN
        holds := false;
        expected := 'One of ' || array_to_string(known.choice, ', ') || '.';
    ELSIF known.minimum IS NOT NULL THEN
        holds := CASE WHEN value ~ '^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,2})?\s*$'
            THEN value::float8 BETWEEN known.minimum AND known.maximum ELSE false END;
        expected := concat_ws(' ', 'Expected', known.minimum, 'to', known.maximum, known.unit) || '.';
        IF setting = 'ground_level' THEN
            holds := holds AND value ~ '^\s*[-+]?\d+\s*$';
            expected := replace(expected, 'Expected', 'Expected a whole number,');
        END IF;
    ELSIF setting IN ('taper_ratio', 'grade_usual', 'grade_maximal') THEN
        expected := format('Expected a JSON object of speed (0 to 999 km/h) to %s, such as %s.', CASE setting
            WHEN 'taper_ratio' THEN 'ratio (0 to 100)' ELSE 'grade (0.1 to 100 %)' END, known.value);
        BEGIN
            SELECT count(*) > 0 AND bool_and(e.key ~ '^\d{1,3}$' AND coalesce(e.value::float8
                BETWEEN CASE setting WHEN 'taper_ratio' THEN 0 ELSE 0.1 END AND 100, false))
                INTO holds FROM jsonb_each_text(value::jsonb) e;
        EXCEPTION WHEN data_exception THEN
            holds := false;
        END;
    ELSE
        expected := 'Expected a JSON object of importance to number, such as {"1": 8, "2": 6.25}.';
        -- Only a radius has another law to fall back on.
        holds := value = '' AND setting = 'radius_by_importance' OR streetgen._is_by_importance(value, 400);
    END IF;
    RETURN streetgen._believed_setting(model, setting, value, holds, expected);
END $$;
COMMENT ON FUNCTION streetgen._check_setting(name, text, text) IS
    'The value as the model keeps it: a function with its schema. Raises 22023 for an unknown setting or a value '
    'beyond the range, words or form of _default_setting, 22004 for NULL, saying how to put the default back; for a '
    'function as _called_function. A room checks a setting of a form of its own by a function '
    '_checked_SETTING (model, value).';

CREATE OR REPLACE FUNCTION streetgen._check_settings(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A default is within its range.
    PERFORM streetgen._check_setting(model, d.name, s.value) FROM streetgen._default_setting() d LEFT
        JOIN setting s USING (name) WHERE s.value IS DISTINCT FROM d.value;
END $$;
COMMENT ON FUNCTION streetgen._check_settings(name) IS
    'Raises as _check_setting for what was written or deleted in the setting table of a model without streetgen.set.';

CREATE OR REPLACE FUNCTION streetgen._setting_text(model name, setting text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN coalesce((SELECT s.value FROM setting s WHERE s.name = setting),
        (SELECT d.value FROM streetgen._default_setting() d WHERE d.name = setting));
END $$;
COMMENT ON FUNCTION streetgen._setting_text(name, text) IS
    'The value of a setting, also of a model that was made before the setting.';

CREATE OR REPLACE FUNCTION streetgen._setting_number(model name, setting text) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ BEGIN RETURN streetgen._setting_text(model, setting)::float8; END $$;
COMMENT ON FUNCTION streetgen._setting_number(name, text) IS 'The value of a setting as a number.';

CREATE OR REPLACE FUNCTION streetgen._tolerance(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value::float8 FROM setting WHERE name = 'tolerance' INTO tolerance;
    RETURN tolerance;
END $$;
COMMENT ON FUNCTION streetgen._tolerance(name) IS 'Setting tolerance of a model, metres.';

CREATE OR REPLACE FUNCTION streetgen._frame_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('reach', '60', 'm', 'an edit changes nothing farther away along the network, or than max_arc_distance', 10, 1000,
        NULL::text[]),
    ('cell_size', '200', 'm', 'farther off than twice the reach and this edits wait for each other only for a road '
        'or another chain that both may change, for what is off the ground, and for a transaction that holds many '
        'places', 50, 5000, NULL),
    ('lock_timeout', '5', 's', 'an edit waits so long for another session where its own lock_timeout is 0', 0.1, 3600,
        NULL),
    ('building_table', 'none', NULL, 'the buildings that pictures show: none, or a table or view with a geometry '
        'column of polygons, with its schema', NULL, NULL, ARRAY['none']),
    ('log', 'off', NULL, 'rows in edit_log of who edits what: off or on', NULL, NULL, ARRAY['off', 'on']),
    ('attribution', '', NULL, 'whose data the model shows, as a sheet says it', NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._frame_setting() IS 'The settings of every model, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._setting_beside() RETURNS TABLE(name text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('setting_beside');
END $$;
COMMENT ON FUNCTION streetgen._setting_beside() IS
    'The settings that streets do not depend on, from functions _ROOM_setting_beside.';

CREATE OR REPLACE FUNCTION streetgen._frame_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES ('building_table'), ('cell_size'), ('lock_timeout'), ('log'), ('attribution') $$;
COMMENT ON FUNCTION streetgen._frame_setting_beside() IS
    'The settings of locks, of the log, of pictures and of sheets.';
