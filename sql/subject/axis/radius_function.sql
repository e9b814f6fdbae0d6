-- A predictor of the user's for the radius that an axis wants: setting radius_function names it.

CREATE OR REPLACE FUNCTION streetgen._named_predictor(predictor text) RETURNS regprocedure
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._function_named(predictor, f.arguments, f.result, f.many)
        FROM streetgen._setting_function() f WHERE f.setting = 'radius_function' $$;
COMMENT ON FUNCTION streetgen._named_predictor(text) IS
    'The function of that name, of the signature of a predictor of radii; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._radius_function(model name, predictor text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    called constant text := streetgen._called_function(model, 'radius_function', predictor);
    named constant regprocedure := streetgen._named_predictor(predictor);
BEGIN
    IF (SELECT provolatile <> 'i' FROM pg_proc WHERE oid = named) THEN
        RAISE EXCEPTION 'setting "radius_function" of model "%" cannot be %', model, quote_literal(predictor)
            USING ERRCODE = '22023', DETAIL = 'It may give another radius each time: it is not IMMUTABLE.',
                HINT = format('If its result hangs on its arguments alone: ALTER FUNCTION %s IMMUTABLE.', named);
    END IF;
    RETURN called;
END $$;
COMMENT ON FUNCTION streetgen._radius_function(name, text) IS
    'The name of the predictor that setting radius_function of a model names, as _called_function has it. One that '
    'is not immutable: 22023.';

CREATE OR REPLACE FUNCTION streetgen._checked_radius_function(model name, value text) RETURNS text
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._radius_function(model, value) $$;
COMMENT ON FUNCTION streetgen._checked_radius_function(name, text) IS
    'Setting radius_function as a model keeps it, as _radius_function has it.';

CREATE OR REPLACE FUNCTION streetgen._predictor_definition(predictor text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT pg_get_functiondef(streetgen._named_predictor(predictor)) $$;
COMMENT ON FUNCTION streetgen._predictor_definition(text) IS
    'How a predictor is defined: radii computed by another definition are stale. NULL for one that is gone.';

CREATE OR REPLACE FUNCTION streetgen._predicted_radius(
        predictor text, axis bigint, width float8, speed float8, importance integer, lane_count integer,
            kind text)
    RETURNS float8
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE COST 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    radius float8;
    mend constant text := 'Mend the function, or set radius_function to NULL.';
BEGIN
    BEGIN
        EXECUTE format('SELECT %s($1, $2, $3, $4, $5)', predictor) INTO radius USING width, speed, importance,
            lane_count, kind;
    EXCEPTION WHEN OTHERS THEN
        PERFORM streetgen._refuse(SQLSTATE, format('radius function %s failed for axis %s: %s', predictor, axis,
            SQLERRM), hint => mend);
    END;
    IF NOT radius BETWEEN 0 AND 200 THEN
        PERFORM streetgen._refuse('22023', format('radius function %s gave %s for axis %s', predictor, radius, axis),
            'Expected 0 to 200 m, or NULL for the model''s own rule.', mend);
    END IF;
    RETURN radius;
END $$;
COMMENT ON FUNCTION streetgen._predicted_radius(text, bigint, float8, float8, integer, integer, text) IS
    'The radius in metres that a predictor gives an axis of these values, NULL where it knows none. Another number '
    'than 0 to 200: 22023; an error of the predictor keeps its SQLSTATE. Both name the axis.';
