-- Functions that stand in the schema of a model, such as those of its triggers.

CREATE OR REPLACE FUNCTION streetgen._own_function(model name, signature text, description text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    named constant regprocedure := format('%I.%s', model, signature);
    body text;
    begins integer;
BEGIN
    SELECT prosrc INTO body FROM pg_proc WHERE oid = named AND prosecdef;
    IF FOUND THEN
        -- Its first declaration, before anything there finds a function by search_path.
        begins := nullif(regexp_instr(body, E'\n *(DECLARE|BEGIN)\n'), 0);
        IF begins IS NULL THEN
            RAISE EXCEPTION 'function % has no line at which to look for functions of others', named
                USING ERRCODE = '22023', HINT = 'One that runs with the rights of the owner is written in PL/pgSQL.';
        END IF;
        EXECUTE regexp_replace(split_part(pg_get_functiondef(named), body, 1), '\$\w*\$\Z', '')
            || quote_literal(left(body, begins) || format(E'DECLARE\n    only_own_functions constant boolean := '
            'streetgen._only_own_functions(%L);', model) || regexp_replace(substr(body, begins), '^\n *DECLARE', ''));
        EXECUTE format('REVOKE ALL ON FUNCTION %s FROM PUBLIC', named);
    END IF;
    EXECUTE format('ALTER FUNCTION %1$s DEPENDS ON EXTENSION streetgen; COMMENT ON FUNCTION %1$s IS %2$L; '
        'ALTER FUNCTION %1$s OWNER TO %3$s', named, description,
        (SELECT nspowner::regrole FROM pg_namespace WHERE nspname = model));
END $$;
COMMENT ON FUNCTION streetgen._own_function(name, text, text) IS
    'Gives a function in the schema of a model to its owner, with a comment; it goes with the extension. One that '
    'runs with the rights of the owner first looks for functions of others, and nobody else may call it; any other '
    'one may be called by who may use the schema.';

CREATE OR REPLACE FUNCTION streetgen._compose_function(model name, declaration text, result text, body text,
    signature text, description text, traits text DEFAULT 'VOLATILE') RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE format('CREATE OR REPLACE FUNCTION %I.%s RETURNS %s LANGUAGE plpgsql %s SET search_path FROM CURRENT AS %L',
        model, declaration, result, traits, body);
    PERFORM streetgen._own_function(model, signature, description);
END $$;
COMMENT ON FUNCTION streetgen._compose_function(name, text, text, text, text, text, text) IS
    'Makes a function in the schema of a model whose statements are put together from the lists of rooms. declaration: '
    'name and arguments with their names; signature: the same without these; traits: what CREATE FUNCTION says of it.';

CREATE OR REPLACE FUNCTION streetgen._drop_own_functions(model name, names name[] DEFAULT NULL) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        -- No word of the triggers that go.
        SET client_min_messages = warning
    AS $$
DECLARE
    part text;
BEGIN
    -- Triggers go with their functions: those of a table that is followed stand on a table of somebody else.
    FOR part IN SELECT format('DROP FUNCTION %s %s', p.oid::regprocedure,
            CASE prorettype WHEN 'trigger'::regtype THEN 'CASCADE' ELSE 'RESTRICT' END)
        FROM pg_proc p JOIN pg_depend d ON d.objid = p.oid AND d.classid = 'pg_proc'::regclass
            JOIN pg_extension e ON e.oid = d.refobjid AND d.refclassid = 'pg_extension'::regclass
        WHERE p.pronamespace = quote_ident(model)::regnamespace AND d.deptype = 'x' AND e.extname = 'streetgen'
            AND (names IS NULL OR p.proname = ANY (names))
    LOOP
        EXECUTE part;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._drop_own_functions(name, name[]) IS
    'Drops the functions of a model that go with the extension, all or those of these names, and the triggers that '
    'call them, also on tables that it follows: an earlier build may have made them with other names and arguments.';
