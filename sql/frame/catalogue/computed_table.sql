-- The one list of computed tables, with the subject of each: what rooms give, written into one function once.

CREATE OR REPLACE FUNCTION streetgen._computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 15 SET search_path = pg_catalog
    AS $$ SELECT 0, '', '', '', '', '', 0 WHERE false $$;
COMMENT ON FUNCTION streetgen._computed_table() IS
    'The tables that generate writes, in the order in which their rows are given, from functions _ROOM_computed_table. '
    'subject: the part of a model that the table belongs to. key: its primary key. identity: the columns that tell '
    'which row of a former run is the same, which then keeps its key; NULL: the query of the rows gives the key. '
    'gone_with: the table whose deleted rows take rows of this one along, gone_each for each; the table itself where '
    'its own rows are deleted. A table without a key is written by a part of the one statement of its own.';

CREATE OR REPLACE FUNCTION streetgen._compose_computed_table() RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    composed constant regprocedure := 'streetgen._computed_table()';
    t record;
    rows text;
BEGIN
    FOR t IN EXECUTE streetgen._rows_of_rooms('computed_table') || ' ORDER BY place' LOOP
        rows := concat_ws(', ', rows, format('(%s, %L, %L, %L, %L, %L, %s)', t.place, t.relation, t.subject, t.key,
            t.identity, t.gone_with, coalesce(t.gone_each::text, 'NULL')));
    END LOOP;
    EXECUTE replace(pg_get_functiondef(composed), (SELECT prosrc FROM pg_proc WHERE oid = composed), 'VALUES ' || rows);
END $$;
COMMENT ON FUNCTION streetgen._compose_computed_table() IS
    'Writes the rows that rooms give into streetgen._computed_table(), which edits ask often.';

CREATE OR REPLACE FUNCTION streetgen._computed_tables(model name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT array_agg(relation ORDER BY place) FROM streetgen._computed_table()
    JOIN unnest(streetgen._subjects(model)) s(subject) USING (subject) $$;
COMMENT ON FUNCTION streetgen._computed_tables(name) IS
    'The tables that generate writes in a model, in the order in which their rows are given.';
