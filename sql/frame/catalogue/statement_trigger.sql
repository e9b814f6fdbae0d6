-- Triggers that see all rows of a statement. PostgreSQL gives these rows to a trigger of one event alone.

CREATE OR REPLACE FUNCTION streetgen._make_statement_triggers(model name, relation name, trigger_name text,
    events text[], called text, before name, after name, description text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    event text;
BEGIN
    FOREACH event IN ARRAY events LOOP
        EXECUTE format('CREATE OR REPLACE TRIGGER %1$I AFTER %2$s ON %3$I.%4$I %5$s FOR EACH STATEMENT '
            'EXECUTE FUNCTION %3$I.%6$s; COMMENT ON TRIGGER %1$I ON %3$I.%4$I IS %7$L', trigger_name || '_' || event,
            event, model, relation, 'REFERENCING '
            || nullif(concat_ws(' ', CASE WHEN event IN ('update', 'delete') THEN 'OLD TABLE AS ' || before END,
                CASE WHEN event IN ('update', 'insert') THEN 'NEW TABLE AS ' || after END), ''), called, description);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_statement_triggers(name, name, text, text[], text, name, name, text) IS
    'Makes a trigger after a statement for each of some events (insert, update, delete, truncate), which calls a '
    'function of the model: its name and arguments. It sees the rows before and after the statement as tables of these '
    'names, except after TRUNCATE.';
