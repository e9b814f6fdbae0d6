-- Refusals before anything is done: no such model, a role without the right, an argument left out.

CREATE OR REPLACE FUNCTION streetgen.version() RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT extversion FROM pg_extension WHERE extname = 'streetgen' $$;
COMMENT ON FUNCTION streetgen.version() IS 'Version of the installed extension.';

CREATE OR REPLACE FUNCTION streetgen._require_model(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_one_build();
    IF model IS NULL THEN
        PERFORM streetgen._refuse('22004', 'the model is NULL', hint => 'SELECT name FROM streetgen.model lists them.');
    END IF;
    IF NOT EXISTS (SELECT FROM streetgen.model m JOIN pg_namespace n ON n.nspname = m.name
        WHERE m.name = _require_model.model) THEN
        PERFORM streetgen._refuse('3F000', format('model "%s" does not exist', model),
            hint => format(CASE WHEN EXISTS (SELECT FROM pg_class WHERE relnamespace = (SELECT oid FROM pg_namespace
                WHERE nspname = model) AND relname = 'axis_class')
                THEN 'Its schema looks like one: SELECT streetgen.adopt_model(%L) registers it.'
                ELSE 'SELECT name FROM streetgen.model lists those that are there; SELECT '
                'streetgen.create_model(%L, srid => …) makes it.' END, model));
    END IF;
    PERFORM streetgen._only_own_functions(model);
END $$;
COMMENT ON FUNCTION streetgen._require_model(name) IS
    'Raises 3F000 when the model does not exist, 22004 when it is NULL, 55000 where module, SQL and model are not of '
    'one build, 42501 where it could meet functions of others.';

CREATE OR REPLACE FUNCTION streetgen._check_given(VARIADIC given text[]) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    FOR i IN 1 .. cardinality(given) BY 2 LOOP
        IF given[i + 1] IS NULL THEN
            RAISE EXCEPTION 'argument % is NULL', given[i] USING ERRCODE = '22004',
                HINT = 'NULL means nothing there: give a value, or leave the argument out where it has a default.';
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_given(text[]) IS
    'Raises 22004 for the first argument that is NULL; arguments as pairs of name and value.';

CREATE OR REPLACE FUNCTION streetgen._check_type(what text, geom geometry, expected text[], way_out text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF GeometryType(ST_Force2D(geom)) <> ALL (expected) THEN
        RAISE EXCEPTION '% is a %, expected a %', what, GeometryType(geom), array_to_string(expected, ' or ')
            USING ERRCODE = '22023', HINT = way_out;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_type(text, geometry, text[], text) IS
    'Raises 22023 for a geometry of another type than those expected, whatever its dimensions.';

CREATE OR REPLACE FUNCTION streetgen._require_reader(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_model(model);
    IF (SELECT has_schema_privilege(n.oid, 'USAGE') AND has_table_privilege(c.oid, 'SELECT')
        FROM pg_namespace n JOIN pg_class c ON relnamespace = n.oid WHERE nspname = model AND relname = 'axis') IS FALSE
    THEN
        RAISE EXCEPTION 'role "%" may not read model "%"', current_user, model USING ERRCODE = '42501',
            HINT = format('SELECT streetgen.grant(%L, %L, ''reader'') by its owner allows it.', model, current_user);
    END IF;
    PERFORM streetgen._check_tables(model);
END $$;
COMMENT ON FUNCTION streetgen._require_reader(name) IS
    'Raises 3F000 when the model does not exist, 42501 when the caller was not granted it, 42809 where a view stands '
    'for one of its tables.';

CREATE OR REPLACE FUNCTION streetgen._require_schema_owner(schema name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT pg_has_role(current_user, (SELECT nspowner FROM pg_namespace WHERE nspname = schema), 'MEMBER') THEN
        RAISE EXCEPTION 'only the owner of model "%" may do this', schema USING ERRCODE = '42501',
            HINT = 'Ask its owner, or become a member of the role that owns its schema.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_schema_owner(name) IS
    'Raises 42501 when the caller is no member of the role that owns the schema of a model.';

CREATE OR REPLACE FUNCTION streetgen._require_owner(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_model(model), streetgen._require_schema_owner(model);
END $$;
COMMENT ON FUNCTION streetgen._require_owner(name) IS
    'Raises 3F000 when the model does not exist, 42501 when the caller is no member of its owner.';

CREATE OR REPLACE FUNCTION streetgen._require_subject(model name, subject text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF subject <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" does not compute subject "%"', model, subject USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, %L, true) takes it in.', model, subject);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_subject(name, text) IS
    'Raises 55000 for a model that does not compute a subject.';

CREATE OR REPLACE FUNCTION streetgen._require_extension(extension name, setting text) RETURNS name
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    schema name := (SELECT nspname FROM pg_extension JOIN pg_namespace n ON n.oid = extnamespace
        WHERE extname = extension);
BEGIN
    IF schema IS NULL THEN
        RAISE EXCEPTION 'extension % is missing', extension USING ERRCODE = '0A000',
            HINT = format('CREATE EXTENSION %I; or set %s to plain.', extension, setting);
    END IF;
    RETURN schema;
END $$;
COMMENT ON FUNCTION streetgen._require_extension(name, text) IS
    'The schema of an extension that a setting asks for; 0A000 with the line that makes it where it is missing.';
