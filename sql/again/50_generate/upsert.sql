-- The one statement: streets computed, matched to the rows that are there, and upserted. Each subject has a part of
-- its own: upsert*.sql in its folder.

CREATE OR REPLACE FUNCTION streetgen._filled(template text, places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Between braces, every second piece is a name.
    SELECT string_agg(CASE n % 2 WHEN 1 THEN piece ELSE places ->> piece END, '' ORDER BY n)
    FROM string_to_table(translate(template, '}', '{'), '{') WITH ORDINALITY p(piece, n) $$;
COMMENT ON FUNCTION streetgen._filled(text, jsonb) IS 'A text with its places, {name}, filled.';

CREATE OR REPLACE FUNCTION streetgen._upsert_places(model name, whole boolean, bare boolean DEFAULT false,
    first boolean DEFAULT false) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT jsonb_build_object('subjects', streetgen._subjects(model), 'model', quote_ident(model), 'quoted_model',
        replace(quote_ident(model), '''', ''''''), 'srid', m.srid,
        'whole', whole, 'bare', bare, 'first', first, 'by_key', CASE WHEN whole THEN '' ELSE 'OFFSET 0' END,
        'geom_with_height', CASE m.dimension WHEN 2 THEN 'c.geom' ELSE
            format('streetgen._with_height(c.geom, (SELECT a.geom FROM %I.axis a WHERE a.axis_id = c.axis_id))',
                model) END)
    FROM streetgen.model m WHERE m.name = model $$;
COMMENT ON FUNCTION streetgen._upsert_places(name, boolean, boolean, boolean) IS
    'The places of the one statement, with the subjects that the model computes. {model}: the schema; {quoted_model}: '
    'the same between quotes; {srid}; {whole}: all axes are asked, {bare}: no derived row is there, {first}: none of '
    'the asked axes, and what is there was computed with them: true or false, which the planner takes out. {by_key}: '
    'where rows are few beside those of the model, keeps a lateral subquery apart, so that it is looked up row by row '
    'and not joined. {geom_with_height}: c.geom, with Z from axis c.axis_id where the model has heights.';

-- Height for a line or point computed in the plane: that of the nearest place of its axis.
CREATE OR REPLACE FUNCTION streetgen._with_height(place geometry, axis geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN count(*) = 1 THEN (array_agg(point))[1] ELSE ST_MakeLine(point ORDER BY path) END
    FROM (SELECT d.path, ST_SetSRID(ST_MakePoint(ST_X(d.geom), ST_Y(d.geom),
                   ST_Z(ST_LineInterpolatePoint(axis, ST_LineLocatePoint(ST_Force2D(axis), d.geom)))), ST_SRID(axis))
                       AS point
          FROM ST_DumpPoints(place) d) p
    $$;
COMMENT ON FUNCTION streetgen._with_height(geometry, geometry) IS
    'A POINT or LINESTRING of the plane with the heights of the nearest places of an axis.';

CREATE OR REPLACE FUNCTION streetgen._columns_of(name text, columns text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT regexp_replace(columns, '\w+', name || '.\&', 'g') $$;
COMMENT ON FUNCTION streetgen._columns_of(text, text) IS
    'A list of columns, each with the name of the row that has it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_rows(places jsonb, relation text, columns text, rows text,
    named boolean DEFAULT false, there text DEFAULT NULL) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._filled(CASE WHEN bare AND NOT named THEN $part$
new_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM ({rows}
        ) n RETURNING {returned}, true AS fresh, true AS changed)$part$ ELSE $part$
new_{relation} AS MATERIALIZED (
    SELECT {stored} FROM (
        SELECT old.{id} IS NULL AS fresh, ({old_columns}) IS DISTINCT FROM ({new_columns}) AS changed, {id_there}n.*
        FROM ({rows}
            ) n LEFT JOIN LATERAL (SELECT * FROM {model}.{relation} o WHERE NOT {bare}
                AND ({same_there}) = ({same_new}){there_before} {by_key}) old ON true{as_one}) r{by_number}),
set_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM new_{relation} WHERE changed{of_fresh}{if_any}{order}{on_conflict})$part$ END
    || $part$,
count_{relation} AS MATERIALIZED (
    SELECT count(*) FILTER (WHERE fresh) AS inserted, count(*) FILTER (WHERE changed AND NOT fresh) AS updated,
        count(*) FILTER (WHERE NOT changed) AS unchanged,
           {hard} AS hard FROM new_{relation})$part$
    || CASE WHEN (places ->> 'first')::boolean THEN $part$,
-- Those that can meet no row need not look for one.
add_{relation} AS (
    INSERT INTO {model}.{relation} ({id}, {written})
    SELECT {id_new}, {written} FROM new_{relation} WHERE fresh ORDER BY number)$part$ ELSE '' END
    || CASE WHEN named THEN $part$,
{relation}_ids AS MATERIALIZED (SELECT streetgen._ids(number, {id}) AS ids FROM new_{relation})$part$ ELSE '' END
    || CASE WHEN there IS NULL THEN '' ELSE $part$,
gone_{relation} AS (
    -- Of a whole model every row is looked at only where one is too many.
    DELETE FROM {model}.{relation} WHERE NOT {bare}
        AND (NOT {whole} OR (SELECT count(*) FROM {model}.{relation}) > (SELECT updated + unchanged
        FROM count_{relation})) AND {id} = ANY (ARRAY(
        SELECT {id} FROM ({there}) t WHERE {id} NOT IN (SELECT {id} FROM new_{relation} WHERE NOT fresh)))
            RETURNING 1)$part$ END,
        places || jsonb_build_object('relation', relation, 'id', id, 'written', columns,
            'rows', streetgen._filled(rows, places || jsonb_build_object('next_id', next_id)), 'there',
                streetgen._filled(there, places),
            'old_columns', streetgen._columns_of('old', columns), 'new_columns', streetgen._columns_of('n', columns),
            'same_there', streetgen._columns_of('o', coalesce(same, id)), 'same_new',
                streetgen._columns_of('n', coalesce(same, id)),
            'id_there', CASE WHEN same IS NULL THEN '' WHEN named THEN format('coalesce(old.%1$s, %2$s) AS %1$s, ', id,
                next_id) ELSE format('old.%s, ', id) END,
            'id_new', CASE WHEN same IS NULL THEN id WHEN bare AND NOT named THEN next_id
                ELSE format('coalesce(%s, %s)', id, next_id) END,
            -- Of what hangs on a row that this statement made none is there.
            'there_before', CASE WHEN (places ->> 'first')::boolean
                THEN format(' AND n.%s <= (SELECT max(%s_id) FROM %s.%2$s)', parent, substring(parent FROM '^[a-z]+'),
                places ->> 'model') ELSE '' END,
            -- Of a whole model what stays as it is need not be stored.
            'stored', CASE WHEN named OR NOT whole THEN '*' ELSE concat_ws(', ', 'fresh, changed, number', id,
                regexp_replace(columns, '\m(?!method\M)\w+', 'CASE WHEN changed THEN \& END AS \&', 'g')) END,
            'of_fresh', CASE WHEN (places ->> 'first')::boolean THEN ' AND NOT fresh' ELSE '' END,
            -- Of a whole model what changed is not looked for where nothing did.
            'if_any', CASE WHEN whole AND NOT bare THEN format(' AND (SELECT inserted + updated > 0 FROM count_%s)',
                relation) ELSE '' END,
            'hard', CASE WHEN columns ~ '\mmethod\M' THEN 'count(*) FILTER (WHERE method <> ''hypothesis'')'
                ELSE '0::bigint' END,
            'order', CASE WHEN whole THEN '' ELSE ' ORDER BY number' END, 'as_one', CASE WHEN named AND NOT bare
                THEN ' ORDER BY number' WHEN whole AND NOT named THEN ' OFFSET 0' ELSE '' END,
            -- A sort forms each row for the store; else it would be formed for the store and for its first reader.
            'by_number', CASE WHEN whole AND NOT named THEN ' ORDER BY number' ELSE '' END,
            'on_conflict', CASE WHEN bare THEN '' ELSE format(E'\n    ON CONFLICT (%s) DO UPDATE SET (%s) = ROW (%s)',
                id, others, streetgen._columns_of('excluded', others)) END,
            'returned', concat_ws(', ', id, substring(columns FROM '\mmethod\M'))))
    FROM (SELECT key AS id, identity AS same, (SELECT string_agg(c, ', ') FROM string_to_table(columns, ', ') c
        WHERE c <> ALL (string_to_array(coalesce(identity, ''), ', '))) AS others,
        (places ->> 'whole')::boolean AS whole, (places ->> 'bare')::boolean AS bare, substring(coalesce(identity, key)
        FROM '^\w+') AS parent,
        -- In a bare model from where the sequence stands, which streetgen._pass_ids moves on.
        format(CASE WHEN (places ->> 'bare')::boolean THEN '((SELECT nextval(''%s.%s_%s_seq'')) + number - 1)'
            ELSE 'nextval(''%s.%s_%s_seq'')' END, places ->> 'quoted_model', c.relation, key) AS next_id
        FROM streetgen._computed_table() c WHERE c.relation = _upsert_rows.relation::name) t $$;
COMMENT ON FUNCTION streetgen._upsert_rows(jsonb, text, text, text, boolean, text) IS
    'Part of the one statement: a computed table (relation) gets the rows of a query, which has their number. Its '
    'key, and the columns that tell which row there is the same, stand in streetgen._computed_table(); a new row gets '
    'a new key, {next_id} in a query that gives it, by their numbers, in whose order rows come. columns: what else is '
    'written, where it differs, all columns of the table in its order: so a row that is there is compared as it lies, '
    'and none is formed of it. named: other things computed name the rows by number: relation_ids has the id at each '
    'number, 0 where no row has it. there: a query of ids that are gone where the rows lack them; NULL: they go with '
    'others. new_relation has all columns of the query (of a whole model only where they changed; in a bare one none '
    'but id and method, unless named), id, fresh (not there yet) and changed (fresh ones too), count_relation says '
    'how many, and of how many method is other than hypothesis (hard), gone_relation has a row for each that is gone.';

CREATE OR REPLACE FUNCTION streetgen._upsert_statement(places jsonb) RETURNS text
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    parts text[] := ARRAY[streetgen._upsert_input(places)];
    subject text;
    part text;
BEGIN
    FOR subject IN SELECT jsonb_array_elements_text(places -> 'subjects') LOOP
        EXECUTE format('SELECT streetgen.%I($1)', '_upsert_' || subject) INTO part USING places;
        parts := parts || part;
    END LOOP;
    -- RECURSIVE: parts may name what comes below them. What is read once stands where it is read: for each part to be
    -- put there the planner looks through all of them.
    RETURN 'WITH RECURSIVE ' || array_to_string(parts || streetgen._upsert_report(places), ',') || E'\n'
        || streetgen._upsert_counts(places);
END $$;
COMMENT ON FUNCTION streetgen._upsert_statement(jsonb) IS
    'The statement that computes streets and upserts them, of the subjects of a model and of three arrays: $1 the axes '
    'whose rows may be written, $2 those that they are computed with, $3 those that changed; of a whole model all '
        'three '
    'are NULL; and whether a change may go on beyond what is written, $4. Gives a row per table: relation, inserted, '
    'updated, deleted, unchanged, hard.';

CREATE OR REPLACE FUNCTION streetgen._upsert_set(model name, written bigint[], gathered bigint[], changed bigint[],
    bare boolean DEFAULT false, first boolean DEFAULT false, onwards boolean DEFAULT true)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public SET jit = off
    -- Nothing is known of rows just computed, and tables just filled have no statistics: joins are on equal keys, by
    -- hash.
    SET enable_nestloop = off SET enable_mergejoin = off
    -- The core tells its progress here, in pg_stat_activity; whatever happens, the name of the session comes back.
    SET application_name = 'streetgen: reading or writing rows' SET streetgen.computes = 'on'
    AS $$
DECLARE
    work_mem_before text := current_setting('work_mem');
BEGIN
    PERFORM set_config('work_mem', '64MB', true) WHERE pg_size_bytes(work_mem_before) < pg_size_bytes('64MB');
    -- What fails within a loop's query does not show it whole, a thousand lines of CONTEXT.
    FOR relation, inserted, updated, deleted, unchanged, hard
        IN EXECUTE streetgen._upsert_statement(streetgen._upsert_places(model, whole => written IS NULL, bare => bare,
        first => first))
            USING written, gathered, changed, onwards LOOP
        RETURN NEXT;
    END LOOP;
    PERFORM set_config('work_mem', work_mem_before, true);
END $$;
COMMENT ON FUNCTION streetgen._upsert_set(name, bigint[], bigint[], bigint[], boolean, boolean, boolean) IS
    'Computes and upserts many streets, planned for the sizes of the tables: all axes of a model (NULL; leftovers of '
    'deleted ones go), or what changed axes can change of those written, with those gathered around them. bare: '
    'nothing was derived yet, so that rows are inserted, and nothing else; first: not of the changed axes, and what '
    'lies around them is right; onwards as for streetgen._upsert_part.';

CREATE OR REPLACE FUNCTION streetgen._make_upsert(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- In the model's schema, so that a session plans the statement once. Its tables are reached by their keys: no page
    -- is far; its joins stand in their order.
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._upsert(written bigint[], gathered bigint[], changed bigint[], onwards boolean)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 10 SET search_path FROM CURRENT SET jit = off
    SET enable_seqscan = off SET random_page_cost = 0.01 SET join_collapse_limit = 1
        SET plan_cache_mode = force_generic_plan
    AS $body$
#variable_conflict use_column
BEGIN
    FOR relation, inserted, updated, deleted, unchanged, hard IN %2$s LOOP
        RETURN NEXT;
    END LOOP;
END $body$ $sql$, model, streetgen._upsert_statement(streetgen._upsert_places(model, whole => false)));
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._leading_on(axes bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off SET enable_seqscan = off
        SET plan_cache_mode = force_generic_plan
    AS $body$
BEGIN
    RETURN ARRAY(SELECT axis_id FROM %1$I.edge WHERE axis_id = ANY (axes) AND input_hash = 0);
END $body$ $sql$, model);
    PERFORM streetgen._own_function(model, '_leading_on(bigint[])',
        'Of axes that a run wrote those along which the change goes on beyond them: it left them marked as stale');
    PERFORM streetgen._own_function(model, '_upsert(bigint[], bigint[], bigint[], boolean)',
        'Computes and upserts what changed axes can change of the axes written, with those gathered around them; '
        'onwards: also where the change goes on beyond these, else that is SG001; streetgen.generate and the '
        'triggers call it');
END $$;
COMMENT ON FUNCTION streetgen._make_upsert(name) IS
    'Makes the functions of a model that upsert a part of it, and tell where that was not enough.';

CREATE OR REPLACE FUNCTION streetgen._upsert_part(model name, written bigint[], gathered bigint[], changed bigint[],
    onwards boolean DEFAULT true)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    -- More axes than this are worth a plan of their own.
    most_planned constant integer := 400;
    leading_on bigint[];
    claimed record;
BEGIN
    LOOP
        IF cardinality(changed) > most_planned THEN
            RETURN QUERY SELECT * FROM streetgen._upsert_set(model, written, gathered, changed, onwards => onwards);
        ELSE
            RETURN QUERY EXECUTE format('SELECT * FROM %I._upsert($1, $2, $3, $4)', model) USING written, gathered,
                changed, onwards;
        END IF;
        EXIT WHEN NOT onwards;
        EXECUTE format('SELECT %I._leading_on($1)', model) INTO leading_on USING written;
        EXIT WHEN leading_on = '{}';
        -- Not to wait while places are held; where others hold theirs they stay stale.
        claimed := streetgen._claim(model, changed || leading_on, wait => false);
        EXIT WHEN claimed.changed <@ changed;
        SELECT claimed.written, claimed.gathered, claimed.changed INTO written, gathered, changed;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._upsert_part(name, bigint[], bigint[], bigint[], boolean) IS
    'Computes and upserts what changed axes can change, by the plan of the model for few axes or by one for many; '
    'gives a row per table. onwards: where the change goes on beyond the axes written it claims the places there as '
    'far as they are free, and begins again with the axes that lead there, which gives further rows; else that is '
    'SG001, with some of these axes as its hint.';
