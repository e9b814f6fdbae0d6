-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._lacks_column(model name, relation name, attribute name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT to_regclass(format('%I.%I', model, relation)) IS NOT NULL AND NOT EXISTS (SELECT FROM pg_attribute
        WHERE attrelid = to_regclass(format('%I.%I', model, relation)) AND attname = attribute) $$;
COMMENT ON FUNCTION streetgen._lacks_column(name, name, name) IS
    'Does a model have a table without a column of that name?';
