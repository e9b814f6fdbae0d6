-- Tools by which rooms make their tables.

CREATE OR REPLACE FUNCTION streetgen._execute_each(statements text[], VARIADIC places text[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    statement text;
BEGIN
    FOREACH statement IN ARRAY statements LOOP
        EXECUTE format(statement, VARIADIC places);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._execute_each(text[], text[]) IS
    'Runs statements in which %1$I is a model, and %2$s and so on further places.';

CREATE OR REPLACE FUNCTION streetgen._lacks_column(model name, relation name, attribute name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT to_regclass(format('%I.%I', model, relation)) IS NOT NULL AND NOT EXISTS (SELECT FROM pg_attribute
        WHERE attrelid = to_regclass(format('%I.%I', model, relation)) AND attname = attribute) $$;
COMMENT ON FUNCTION streetgen._lacks_column(name, name, name) IS
    'Does a model have a table without a column of that name?';

CREATE OR REPLACE FUNCTION streetgen._relations(model name) RETURNS oid[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY(SELECT oid FROM pg_class WHERE relnamespace = quote_ident(model)::regnamespace
        AND relkind IN ('r', 'v')) $$;
COMMENT ON FUNCTION streetgen._relations(name) IS 'The tables and views in the schema of a model.';

CREATE OR REPLACE FUNCTION streetgen._street_input(model name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(relname ORDER BY relname) FROM pg_class
        WHERE relnamespace = quote_ident(model)::regnamespace AND relkind = 'r'
            -- A table of the user's may have a name of that kind.
            AND relname IN (SELECT 'axis' UNION ALL SELECT relation FROM streetgen._decision()) $$;
COMMENT ON FUNCTION streetgen._street_input(name) IS
    'The tables of a model that streets follow: axes, and what is decided by hand.';

CREATE OR REPLACE FUNCTION streetgen._edited() RETURNS TABLE(relation name)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 10 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('edited');
END $$;
COMMENT ON FUNCTION streetgen._edited() IS
    'The tables beside those that streets follow that an editor may write, from functions _ROOM_edited.';

CREATE OR REPLACE FUNCTION streetgen._edited_tables(model name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._street_input(model) || array_agg(relname ORDER BY relname) FROM pg_class
        WHERE relnamespace = quote_ident(model)::regnamespace AND relkind = 'r'
            AND relname IN (SELECT relation FROM streetgen._edited()) $$;
COMMENT ON FUNCTION streetgen._edited_tables(name) IS
    'The tables of input that an editor of a model may write; no value there names a function or becomes SQL.';

CREATE OR REPLACE FUNCTION streetgen._written() RETURNS TABLE(relation name, privilege text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('written');
END $$;
COMMENT ON FUNCTION streetgen._written() IS
    'The rights on tables beside input that an editor has, since functions write there with his rights, from functions '
    '_ROOM_written.';
