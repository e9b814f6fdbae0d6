-- The pieces of the one statement that write one computed table: new_, set_, add_, count_, _ids and gone_. Each piece
-- is a text with places, which depends on the run: part, cluster, whole or empty (streetgen._upsert_places).

CREATE OR REPLACE FUNCTION streetgen._columns_of(name text, columns text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT regexp_replace(columns, '\w+', name || '.\&', 'g') $$;
COMMENT ON FUNCTION streetgen._columns_of(text, text) IS
    'A list of columns, each with the name of the row that has it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_compared(run text, named boolean) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._part('compared')
    -- No computed row of a cluster hangs on a node or an edge that this statement makes.
    || CASE run WHEN 'cluster'
        THEN ' AND n.{parent} <= (SELECT max({parent_table}_id) FROM {model}.{parent_table})' ELSE '' END
    || ' {by_key}) old ON true'
    || CASE WHEN named AND run <> 'empty' THEN ' ORDER BY number' WHEN run = 'whole' AND NOT named THEN ' OFFSET 0'
        ELSE '' END || ') r'
    -- A sort forms each row for the store; else it would be formed for the store and for its first reader.
    || CASE WHEN run = 'whole' AND NOT named THEN ' ORDER BY number' ELSE '' END || ')' $$;
COMMENT ON FUNCTION streetgen._upsert_compared(text, boolean) IS
    'new_relation: the rows of the query, each beside the row that is there: fresh (none is there) and changed.';

CREATE OR REPLACE FUNCTION streetgen._upsert_changed(run text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
set_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM new_{relation} WHERE changed$part$ || CASE run
        WHEN 'cluster' THEN ' AND NOT fresh'
        -- A run over a whole model does not look for what changed where nothing did.
        WHEN 'whole' THEN ' AND (SELECT inserted + updated > 0 FROM count_{relation})' ELSE '' END
    || CASE WHEN run IN ('whole', 'empty') THEN '' ELSE ' ORDER BY number' END
    || CASE run WHEN 'empty' THEN '' ELSE $part$
    ON CONFLICT ({id}) DO UPDATE SET ({others}) = ROW ({excluded})$part$ END || ')' $$;
COMMENT ON FUNCTION streetgen._upsert_changed(text) IS
    'set_relation: writes the rows that changed. Fresh rows of a cluster are left to add_relation.';

CREATE OR REPLACE FUNCTION streetgen._upsert_rows(places jsonb, relation text, columns text, rows text,
    named boolean DEFAULT false, there text DEFAULT NULL, read boolean DEFAULT false) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._fill_template(
        -- Rows that no other part names by number go straight into an empty model.
        CASE WHEN run = 'empty' AND NOT named THEN $part$
new_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM ({rows}
        ) n RETURNING {returned}, true AS fresh, true AS changed)$part$
        ELSE streetgen._upsert_compared(run, named) || streetgen._upsert_changed(run) END
    || $part$,
count_{relation} AS MATERIALIZED (
    SELECT count(*) FILTER (WHERE fresh) AS inserted, count(*) FILTER (WHERE changed AND NOT fresh) AS updated,
        count(*) FILTER (WHERE NOT changed) AS unchanged,
           {fallbacks} AS fallbacks FROM new_{relation})$part$
    -- Fresh rows of a cluster can meet no row that is there, and need not look for one.
    || CASE run WHEN 'cluster' THEN $part$,
add_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM new_{relation} WHERE fresh ORDER BY number)$part$ ELSE '' END
    || CASE WHEN named THEN $part$,
{relation}_ids AS MATERIALIZED (SELECT streetgen._ids(number, {id}) AS ids FROM new_{relation})$part$ ELSE '' END
    || CASE WHEN there IS NULL THEN '' ELSE streetgen._part('there') END,
        streetgen._upsert_row_places(places, relation, columns, rows, named, there, read))
    FROM (SELECT places ->> 'run' AS run) r $$;
COMMENT ON FUNCTION streetgen._upsert_rows(jsonb, text, text, text, boolean, text, boolean) IS
    'Part of the one statement: a computed table (relation) gets the rows of a query, which has their number. Its '
    'key, and the columns that tell which row there is the same, stand in streetgen._computed_table(); a new row gets '
    'a new key, {next_id} in a query that gives it, by their numbers, in whose order rows come. columns: what else is '
    'written, where it differs, all columns of the table in its order: so a row that is there is compared as it lies, '
    'and none is formed of it. named: other things computed name the rows by number: relation_ids has the id at each '
    'number, 0 where no row has it. there: a query of ids that are gone where the rows lack them; NULL: they go with '
    'others. read: another part reads all columns of the rows. new_relation has all columns of the query (of a '
    'whole model only where they changed; in an empty one none but id and method, unless named or read), id,'
    ' fresh (not there yet) and changed (fresh ones too), count_relation says '
    'how many, and of how many method is other than hypothesis (fallbacks), gone_relation has the id of each that is '
    'gone.';

CREATE OR REPLACE FUNCTION streetgen._upsert_row_places(places jsonb, relation text, columns text, rows text,
    named boolean, there text, read boolean) RETURNS jsonb
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT places || jsonb_build_object('relation', relation, 'id', id, 'written', columns,
        'rows', streetgen._fill_template(rows, places || jsonb_build_object('next_id', next_id)),
        'there', streetgen._fill_template(there, places),
        'old_columns', streetgen._columns_of('old', columns), 'new_columns', streetgen._columns_of('n', columns),
        'same_there', streetgen._columns_of('o', same), 'same_new', streetgen._columns_of('n', same),
        'parent', parent, 'parent_table', substring(parent FROM '^[a-z]+'),
        'others', others, 'excluded', streetgen._columns_of('excluded', others),
        -- The key of a row: the query gives it, or the row that is there, or a sequence.
        'id_there', CASE WHEN identity IS NULL THEN ''
            WHEN named THEN format('coalesce(old.%1$s, %2$s) AS %1$s, ', id, next_id) ELSE format('old.%s, ', id) END,
        'id_new', CASE WHEN identity IS NULL THEN id WHEN run = 'empty' AND NOT named THEN next_id
            ELSE format('coalesce(%s, %s)', id, next_id) END,
        -- A run over a whole model need not store what stays as it is.
        'stored', CASE WHEN named OR read OR run <> 'whole' THEN '*' ELSE concat_ws(', ', 'fresh, changed, number', id,
            regexp_replace(columns, '\m(?!method\M)\w+', 'CASE WHEN changed THEN \& END AS \&', 'g')) END,
        'fallbacks', CASE WHEN columns ~ '\mmethod\M' THEN 'count(*) FILTER (WHERE method <> ''hypothesis'')'
            ELSE '0::bigint' END,
        'returned', concat_ws(', ', id, CASE WHEN read THEN columns ELSE substring(columns FROM '\mmethod\M') END))
    FROM (SELECT key AS id, identity, coalesce(identity, key) AS same, places ->> 'run' AS run,
            substring(coalesce(identity, key) FROM '^\w+') AS parent,
            (SELECT string_agg(c, ', ') FROM string_to_table(columns, ', ') c
                WHERE c <> ALL (string_to_array(coalesce(identity, ''), ', '))) AS others,
            -- In an empty model from where the sequence stands, which streetgen._advance_sequences moves on.
            format(CASE places ->> 'run' WHEN 'empty' THEN '((SELECT nextval(''%s.%s_%s_seq'')) + number - 1)'
                ELSE 'nextval(''%s.%s_%s_seq'')' END, places ->> 'quoted_model', c.relation, key) AS next_id
        FROM streetgen._computed_table() c WHERE c.relation = _upsert_row_places.relation::name) t $$;
COMMENT ON FUNCTION streetgen._upsert_row_places(jsonb, text, text, text, boolean, text, boolean) IS
    'The places of one computed table, beside those of the whole statement: arguments as of streetgen._upsert_rows.';
