-- Functions of the user's that a model calls: settings and specialised types name them.

CREATE OR REPLACE FUNCTION streetgen._setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('setting_function');
END $$;
COMMENT ON FUNCTION streetgen._setting_function() IS
    'The settings that may name a function of the user''s, from functions _ROOM_setting_function: what it takes, and '
    'whether it returns one or many of what.';

CREATE OR REPLACE FUNCTION streetgen._function_named(name text, arguments text, result text, many boolean)
    RETURNS regprocedure
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN (SELECT oid FROM pg_proc WHERE oid = to_regprocedure(format('%s(%s)', name, arguments))
        AND prorettype = result::regtype AND proretset = many AND prokind = 'f');
EXCEPTION WHEN syntax_error_or_access_rule_violation OR data_exception OR feature_not_supported THEN -- no name at all
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._function_named(text, text, text, boolean) IS
    'The function of that name, with its schema unless in public, that takes these arguments (types with commas '
    'between) and returns one or many of a type; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._qualified(named regprocedure) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('%I.%I', nspname, proname) FROM pg_proc p JOIN pg_namespace n ON n.oid = pronamespace
        WHERE p.oid = named $$;
COMMENT ON FUNCTION streetgen._qualified(regprocedure) IS 'The name of a function with its schema.';

CREATE OR REPLACE FUNCTION streetgen._called_function(model name, place text, name text, named regprocedure,
    expected text) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    owner constant regrole := (SELECT nspowner FROM pg_namespace WHERE nspname = model);
    known record;
    detail text;
    hint text;
    state text := '42501';
BEGIN
    SELECT proowner::regrole AS owner, pronamespace INTO known FROM pg_proc WHERE oid = named;
    IF NOT FOUND THEN
        state := '22023';
        detail := 'There is no such function.';
        hint := format('Expected %s, with its schema.', expected);
    -- An edit by anybody calls it with the rights of the model's owner.
    ELSIF pg_has_role(known.owner, owner, 'MEMBER') IS NOT TRUE THEN
        detail := format('It belongs to role %s, who would get the rights of %s, the owner of the model.', known.owner,
            owner);
        hint := format('ALTER FUNCTION %s OWNER TO %s, or make a copy of your own.', named, owner);
    ELSIF (has_schema_privilege(owner, known.pronamespace, 'USAGE')
        AND has_function_privilege(owner, named, 'EXECUTE')) IS NOT TRUE THEN
        detail := format('Role %s, the owner of the model, may not call it.', owner);
        hint := format('GRANT EXECUTE ON FUNCTION %s TO %s, and USAGE on its schema.', named, owner);
    ELSE
        RETURN streetgen._qualified(named);
    END IF;
    PERFORM streetgen._refuse(state,
        format('%s of model "%s" cannot be %s', place, model, coalesce(quote_literal(name), 'NULL')), detail => detail,
        hint => hint);
END $$;
COMMENT ON FUNCTION streetgen._called_function(name, text, text, regprocedure, text) IS
    'The name, with its schema, of a function of the user''s that place of the model names, for the owner of the '
    'model to call: whoever edits calls it with his rights. None: 22023, saying what is expected. One that the owner '
    'may not call, or that belongs to a role without his rights: 42501.';

CREATE OR REPLACE FUNCTION streetgen._called_function(model name, setting text, value text) RETURNS text
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._called_function(model, format('setting "%s"', setting), value,
            streetgen._function_named(value, f.arguments, f.result, f.many), f.expected)
        FROM streetgen._setting_function() f WHERE f.setting = _called_function.setting $$;
COMMENT ON FUNCTION streetgen._called_function(name, text, text) IS
    'The name, with its schema, of the function of the user''s that a setting of a model names; one that may not be '
    'called: 22023 or 42501.';
