-- Templates of tables: files that psql runs as they stand, such as sql/subject/network/table.sql.  The build puts each
-- of them into one table, and a model gets its tables, indexes and comments from there.

CREATE TABLE streetgen.template (
    room text, part text CHECK (part IN ('table', 'kept_table', 'input_table')), place integer,
    relation name NOT NULL UNIQUE, attributes name[] NOT NULL, statements text NOT NULL,
    PRIMARY KEY (room, part, place));
COMMENT ON TABLE streetgen.template IS 'The tables that models have from StreetGen, and the statements that make them.';
COMMENT ON COLUMN streetgen.template.room IS 'folder of the file';
COMMENT ON COLUMN streetgen.template.part IS
    'name of the file. table: what the room computes, and what every model has; input_table: what users and importers '
    'write, in every model; kept_table: what users write about a subject, and what stays where the subject goes';
COMMENT ON COLUMN streetgen.template.place IS 'number in the file, from 1';
COMMENT ON COLUMN streetgen.template.relation IS 'name of the table';
COMMENT ON COLUMN streetgen.template.attributes IS 'its columns; any other was added by somebody';
COMMENT ON COLUMN streetgen.template.statements IS
    'CREATE TABLE, and what stands below it: indexes, triggers, first rows, comments. Variables of psql are model, '
    'srid, z (the letter Z where geometries may have heights, or nothing) and compression (lz4 where it is there)';
GRANT SELECT ON streetgen.template TO PUBLIC;

CREATE OR REPLACE FUNCTION streetgen._take_template(room text, part text, file text) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ INSERT INTO streetgen.template
        SELECT room, part, place - 1, substring(statements, '^TABLE :"model"\.(\w+)'), ARRAY(SELECT m[1]
            FROM regexp_matches(statements, '^COMMENT ON COLUMN :"model"\.\w+\.(\w+) IS', 'gn') m),
            'CREATE ' || statements
        FROM regexp_split_to_table(file, '^CREATE (?=TABLE )', 'n') WITH ORDINALITY p(statements, place)
        WHERE place > 1 $$;
COMMENT ON FUNCTION streetgen._take_template(text, text, text) IS
    'Takes a file of a room into streetgen.template, table by table: each begins with CREATE TABLE :"model".';

CREATE OR REPLACE FUNCTION streetgen._table_values(model name) RETURNS text[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY[m.srid::text, CASE m.dimension WHEN 3 THEN 'Z' ELSE '' END,
            CASE WHEN 'lz4' = ANY (s.enumvals) THEN 'lz4' ELSE 'default' END, quote_ident(m.name)]
        FROM streetgen.model m, pg_settings s
        WHERE m.name = _table_values.model AND s.name = 'default_toast_compression' $$;
COMMENT ON FUNCTION streetgen._table_values(name) IS
    'What srid, z, compression and "model" are in templates of a model.';

CREATE OR REPLACE FUNCTION streetgen._fill_table(statements text, said text[]) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    -- The name comes last, as it may hold the name of a variable.
    AS $$ SELECT replace(replace(replace(replace(statements, ':srid', said[1]), ':z', said[2]),
        ':compression', said[3]), ':"model"', said[4]) $$;
COMMENT ON FUNCTION streetgen._fill_table(text, text[]) IS
    'Statements of a template with what streetgen._table_values says in place of the variables.';

CREATE OR REPLACE FUNCTION streetgen._check_tables(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    in_the_way regclass;
BEGIN
    SELECT c.oid INTO in_the_way FROM streetgen.template t JOIN pg_class c ON c.relname = t.relation
        WHERE c.relnamespace = quote_ident(model)::regnamespace AND c.relkind <> 'r' ORDER BY 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION '% stands where a table of the model belongs', in_the_way USING ERRCODE = '42809',
            DETAIL = 'It is no table.', HINT = format('Rename it, such as by ALTER TABLE %s RENAME TO …, which takes '
                'views too, or drop it; then repeat the call.', in_the_way);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_tables(name) IS
    'Raises 42809 for a view or another thing by the name of any table of a model: functions of a view would run with '
    'the rights of whoever reads it.';

CREATE OR REPLACE FUNCTION streetgen._make_tables(model name, parts text[], rooms text[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE
        -- PostGIS is found there. An index of a table of another subject may be there already: no word of it.
        SET search_path = pg_catalog, public SET client_min_messages = warning
    AS $$
DECLARE
    said constant text[] := streetgen._table_values(model);
    statements text;
BEGIN
    -- Whether a subject is on is told by the names of its tables, so all of them count.
    PERFORM streetgen._check_tables(model);
    FOR statements IN SELECT streetgen._fill_table(t.statements, said)
        FROM unnest(rooms) WITH ORDINALITY r(room, place), unnest(parts) WITH ORDINALITY p(part, step),
            streetgen.template t
        WHERE (t.room, t.part) = (r.room, p.part) AND to_regclass(format('%I.%I', model, t.relation)) IS NULL
        ORDER BY r.place, p.step, t.place
    LOOP
        EXECUTE statements;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_tables(name, text[], text[]) IS
    'Makes the tables of these parts of some rooms that a model lacks, with all that stands below them. A view or '
    'another thing by the name of any table: 42809.';

CREATE OR REPLACE FUNCTION streetgen._stated(model name) RETURNS TABLE(input regclass, statement text)
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 1000 SET search_path = pg_catalog
    AS $$ SELECT to_regclass(format('%I.%I', model, relation)), regexp_replace(s, '^(\s*--[^\n]*\n|\s)+', '')
        FROM streetgen.template, string_to_table(statements, E';\n') s
        WHERE to_regclass(format('%I.%I', model, relation)) IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._stated(name) IS
    'The statements of templates, one by one, with the table of a model that they are about; none of what it lacks.';

CREATE OR REPLACE FUNCTION streetgen._complete_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    said constant text[] := streetgen._table_values(model);
    missing text;
    foreign_table record;
BEGIN
    FOR missing IN
        SELECT statement FROM streetgen._stated(model) WHERE statement ~ '^ALTER TABLE \S+\s+ADD COLUMN IF NOT EXISTS'
            AND EXISTS (SELECT FROM regexp_matches(statement, 'ADD COLUMN IF NOT EXISTS (\w+)', 'g') later
                WHERE later[1] NOT IN (SELECT attname FROM pg_attribute WHERE attrelid = input AND NOT attisdropped))
    LOOP
        EXECUTE streetgen._fill_table(missing, said);
    END LOOP;
    SELECT c.oid::regclass AS name, string_agg(attribute, ', ') AS lacks INTO foreign_table
        FROM streetgen.template t JOIN pg_class c ON c.relname = t.relation
            CROSS JOIN LATERAL unnest(t.attributes) attribute
        WHERE c.relnamespace = quote_ident(model)::regnamespace
            AND attribute NOT IN (SELECT attname FROM pg_attribute WHERE attrelid = c.oid AND NOT attisdropped)
        GROUP BY c.oid ORDER BY c.relname LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION '% stands where a table of the model belongs', foreign_table.name USING ERRCODE = '42809',
            DETAIL = format('It lacks columns of that one: %s.', foreign_table.lacks),
            HINT = format('If it is your own, rename it, such as by ALTER TABLE %s RENAME TO …; then repeat the '
                'call. Of a model too old to be taken over keep the data with pg_dump -n %I, and DROP SCHEMA %2$I '
                'CASCADE.', foreign_table.name, model);
    END IF;
    FOR missing IN
        SELECT statement FROM streetgen._stated(model) WHERE CASE
            WHEN statement ~ '^CREATE (UNIQUE )?INDEX' THEN to_regclass(format('%I.%I', model,
                substring(statement, 'INDEX (?:IF NOT EXISTS )?(\w+) ON'))) IS NULL
            WHEN statement ~ '^COMMENT ON COLUMN' THEN EXISTS (SELECT FROM pg_attribute WHERE attrelid = input
                AND attname = substring(statement, '\.(\w+) IS') AND NOT attisdropped)
            WHEN statement ~ '^COMMENT ON CONSTRAINT' THEN EXISTS (SELECT FROM pg_constraint WHERE conrelid = input
                AND conname = substring(statement, 'CONSTRAINT (\w+)'))
            ELSE statement ~ '^(COMMENT|CREATE OR REPLACE TRIGGER)' END
    LOOP
        EXECUTE streetgen._fill_table(missing, said);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._complete_tables(name) IS
    'Gives the tables that a model has the later columns, indexes, triggers and comments of this build: another one '
    'may have made them, or somebody may have taken some away. A column comes by ALTER TABLE … ADD COLUMN IF NOT '
    'EXISTS. A table that lacks others is none of the model: 42809.';
