-- A rule of placement of one's own: the function that setting placement_function names.

CREATE OR REPLACE FUNCTION streetgen._placement_function(value text) RETURNS regprocedure
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN (SELECT oid::regprocedure FROM pg_proc WHERE oid = to_regprocedure(value || '(name, bigint[])')
        AND prorettype = 'streetgen.placement'::regtype AND proretset);
-- The value is no name at all.
EXCEPTION WHEN syntax_error_or_access_rule_violation OR data_exception OR feature_not_supported THEN
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._placement_function(text) IS
    'The function that setting placement_function names, (model name, edges bigint[]) returning SETOF '
    'streetgen.placement; NULL: there is none.';

CREATE OR REPLACE FUNCTION streetgen._own_placements(model name, edges bigint[]) RETURNS SETOF streetgen.placement
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    value text;
    called regprocedure;
    placed streetgen.placement;
    known boolean;
    length float8;
BEGIN
    EXECUTE format('SELECT value FROM %I.setting WHERE name = ''placement_function''', model) INTO value;
    IF coalesce(value, 'none') = 'none' THEN
        RETURN;
    END IF;
    called := streetgen._placement_function(value);
    IF called IS NULL THEN
        RAISE EXCEPTION 'setting placement_function names "%", and there is no such function', value
            USING ERRCODE = '22023', HINT = 'A function (model name, edges bigint[]) returning SETOF '
                'streetgen.placement, with its schema; none is the default.';
    END IF;
    FOR placed IN EXECUTE format('SELECT * FROM %s($1, $2)', called::regproc) USING model, edges LOOP
        EXECUTE format('SELECT EXISTS (SELECT FROM %1$I.object_type WHERE type = $1), (SELECT ST_Length2D(geom)
            FROM %1$I.axis WHERE axis_id = $2)', model) INTO known, length USING placed.type, placed.axis_id;
        IF NOT known OR length IS NULL OR placed.side NOT IN ('left', 'right')
            OR (placed.abscissa BETWEEN 0 AND length) IS NOT TRUE
            OR (placed.axis_offset BETWEEN -200 AND 200) IS NOT TRUE
            OR coalesce(placed.orientation, 0) NOT BETWEEN -360 AND 360 THEN
            RAISE EXCEPTION 'function % places % where nothing can stand', called::regproc, placed
                USING ERRCODE = '22023', HINT = 'Type and axis are those of the model, the abscissa lies on the axis, '
                    'side is left, right or NULL, and the offset goes up to 200 m.';
        END IF;
        RETURN NEXT placed;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._own_placements(name, bigint[]) IS
    'What the function that setting placement_function names places along edges. One that is not there, or that gives '
    'a place where nothing can stand: 22023.';
