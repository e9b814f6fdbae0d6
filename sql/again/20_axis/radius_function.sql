-- A predictor of the user's for the radius that an axis wants: setting radius_function names it.

CREATE OR REPLACE FUNCTION streetgen._named_predictor(predictor text) RETURNS regprocedure
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN (SELECT oid FROM pg_proc WHERE oid = to_regprocedure(predictor || '(float8, float8, integer, integer, text)')
            AND prorettype = 'float8'::regtype AND NOT proretset AND prokind = 'f');
EXCEPTION WHEN syntax_error_or_access_rule_violation OR data_exception OR feature_not_supported THEN -- no name at all
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._named_predictor(text) IS
    'The function of that name, with its schema unless in public, of the signature of a predictor of radii: (width '
    'float8, speed float8, importance integer, lane_count integer, kind text) returning float8; NULL where there is '
    'none.';

CREATE OR REPLACE FUNCTION streetgen._radius_function(model name, predictor text) RETURNS regprocedure
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    owner constant regrole := (SELECT nspowner FROM pg_namespace WHERE nspname = model);
    named record;
    detail text;
    hint text;
    state text := '42501';
BEGIN
    SELECT p.oid::regprocedure AS signature, p.proowner::regrole AS owner, p.provolatile, p.pronamespace INTO named
        FROM pg_proc p WHERE p.oid = streetgen._named_predictor(predictor);
    IF NOT FOUND THEN
        state := '22023';
        detail := 'There is no such function.';
        hint := 'Expected the name of a function (width float8, speed float8, importance integer, lane_count integer, '
             || 'kind text) returning float8, with its schema; NULL: none.';
    ELSIF named.provolatile <> 'i' THEN
        state := '22023';
        detail := 'It may give another radius each time: it is not IMMUTABLE.';
        hint := format('If its result hangs on its arguments alone: ALTER FUNCTION %s IMMUTABLE.', named.signature);
    -- An edit by anybody calls it with the rights of the model's owner.
    ELSIF pg_has_role(named.owner, owner, 'MEMBER') IS NOT TRUE THEN
        detail := format('It belongs to role %s, who would get the rights of %s, the owner of the model.', named.owner,
            owner);
        hint := format('ALTER FUNCTION %s OWNER TO %s, or make a copy of your own.', named.signature, owner);
    ELSIF (has_schema_privilege(owner, named.pronamespace, 'USAGE')
               AND has_function_privilege(owner, named.signature, 'EXECUTE')) IS NOT TRUE THEN
        detail := format('Role %s, the owner of the model, may not call it.', owner);
        hint := format('GRANT EXECUTE ON FUNCTION %s TO %s, and USAGE on its schema.', named.signature, owner);
    ELSE
        RETURN named.signature;
    END IF;
    RAISE EXCEPTION 'setting "radius_function" of model "%" cannot be %', model, quote_literal(predictor)
        USING ERRCODE = state, DETAIL = detail, HINT = hint;
END $$;
COMMENT ON FUNCTION streetgen._radius_function(name, text) IS
    'The predictor that setting radius_function of a model names. No such function, or one that is not immutable: '
    '22023. One that the owner of the model may not call, or that belongs to a role without his rights: 42501.';

CREATE OR REPLACE FUNCTION streetgen._qualified(named regprocedure) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('%I.%I', nspname, proname) FROM pg_proc p JOIN pg_namespace n ON n.oid = pronamespace
        WHERE p.oid = named $$;
COMMENT ON FUNCTION streetgen._qualified(regprocedure) IS 'The name of a function with its schema.';

CREATE OR REPLACE FUNCTION streetgen._predictor_definition(predictor text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT pg_get_functiondef(streetgen._named_predictor(predictor)) $$;
COMMENT ON FUNCTION streetgen._predictor_definition(text) IS
    'How a predictor is defined: radii computed by another definition are stale. NULL for one that is gone.';

CREATE OR REPLACE FUNCTION streetgen._predicted_radius(
        predictor regprocedure, axis bigint, width float8, speed float8, importance integer, lane_count integer,
            kind text)
    RETURNS float8
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE COST 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    name constant text := streetgen._qualified(predictor);
    radius float8;
    mend constant text := 'Mend the function, or set radius_function to NULL.';
BEGIN
    BEGIN
        EXECUTE format('SELECT %s($1, $2, $3, $4, $5)', name) INTO radius USING width, speed, importance, lane_count,
            kind;
    EXCEPTION WHEN OTHERS THEN
        RAISE EXCEPTION 'radius function % failed for axis %: %', name, axis, SQLERRM USING ERRCODE = SQLSTATE,
            HINT = mend;
    END;
    IF NOT radius BETWEEN 0 AND 200 THEN
        RAISE EXCEPTION 'radius function % gave % for axis %', name, radius, axis USING ERRCODE = '22023',
            DETAIL = 'Expected 0 to 200 m, or NULL for the model''s own rule.', HINT = mend;
    END IF;
    RETURN radius;
END $$;
COMMENT ON FUNCTION streetgen._predicted_radius(regprocedure, bigint, float8, float8, integer, integer, text) IS
    'The radius in metres that a predictor gives an axis of these values, NULL where it knows none. Another number '
    'than 0 to 200: 22023; an error of the predictor keeps its SQLSTATE. Both name the axis.';
