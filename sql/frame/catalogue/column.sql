-- This says what each column of the tables and views of a model means.
CREATE OR REPLACE FUNCTION streetgen._model_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 390 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('column');
END $$;
COMMENT ON FUNCTION streetgen._model_column() IS
    'The columns of a model''s tables and views, and what each is, from functions _ROOM_column.';

CREATE OR REPLACE FUNCTION streetgen._comment_model(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    remark record;
BEGIN
    FOR remark IN SELECT * FROM streetgen._model_column() c
        WHERE to_regclass(format('%I.%I', model, c.relation)) IS NOT NULL
    LOOP
        EXECUTE format('COMMENT ON COLUMN %I.%I.%I IS %L', model, remark.relation, remark.attribute,
            remark.description);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._comment_model(name) IS 'Comments every column of a model''s tables and views.';
