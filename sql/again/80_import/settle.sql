-- Settling a conflict between what is by hand and what a source says.

CREATE OR REPLACE FUNCTION streetgen._insert_json(model name, relation name, said jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns constant text := (SELECT string_agg(quote_ident(attname), ', ') FROM pg_attribute
        WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0 AND NOT attisdropped
            AND said ? attname);
BEGIN
    EXECUTE format('INSERT INTO %1$I.%2$I (%3$s) SELECT %3$s FROM jsonb_populate_record(NULL::%1$I.%2$I, $1)', model,
        relation, columns) USING said;
END $$;
COMMENT ON FUNCTION streetgen._insert_json(name, name, jsonb) IS
    'Inserts a row, given as streetgen._row_json gives it, into a table of a model.';

CREATE OR REPLACE FUNCTION streetgen._delivered_row(model name, relation name, source text, source_ref text)
    RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    row jsonb;
BEGIN
    EXECUTE format($sql$
SELECT d.said || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text, 'source', d.source, 'source_ref',
        d.source_ref) || CASE d.relation WHEN 'axis' THEN jsonb_build_object('source_geom', d.source_geom::text)
        ELSE '{}' END
    -- Somebody may have given its key to another row.
    || CASE WHEN EXISTS (SELECT FROM %1$I.%2$I t WHERE t.%3$I = d.row_id) THEN '{}'
        ELSE jsonb_build_object(%3$L, d.row_id) END
FROM %1$I.delivered d WHERE d.relation = $1 AND d.source = $2 AND d.source_ref = $3 $sql$, model, relation,
        relation || '_id') INTO row USING relation, source, source_ref;
    RETURN row;
END $$;
COMMENT ON FUNCTION streetgen._delivered_row(name, name, text, text) IS
    'The row that a source delivered last, with the key that it had, for streetgen._insert_json.';

CREATE OR REPLACE FUNCTION streetgen._give_column(model name, relation name, row_id bigint, column_name text,
    value text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- A list is written in JSON as in jsonb, all else as its type reads it.
    said constant jsonb := jsonb_build_object(column_name, CASE column_name WHEN 'via_axes' THEN value::jsonb
        ELSE to_jsonb(value) END);
BEGIN
    EXECUTE format('UPDATE %1$I.%2$I t SET %3$I = (SELECT r.%3$I FROM jsonb_populate_record(t, $1) r)
        WHERE %4$I = $2', model, relation, column_name, relation || '_id') USING said, row_id;
END $$;
COMMENT ON FUNCTION streetgen._give_column(name, name, bigint, text, text) IS
    'Gives a column of a row of a model a value, as import_conflict shows it.';

CREATE OR REPLACE FUNCTION streetgen._give_width(model name, axis bigint, column_name text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    said jsonb;
    as_delivered boolean;
BEGIN
    EXECUTE format($sql$
SELECT d.said, CASE $2 WHEN 'width' THEN a.width_end IS NOT DISTINCT FROM (d.said ->> 'width_end')::float8
    ELSE a.width IS NOT DISTINCT FROM (d.said ->> 'width')::float8 END
FROM %1$I.axis a JOIN %1$I.open_conflict c ON (c.relation, c.row_id, c.column_name) = ('axis', a.axis_id, $2)
    JOIN %1$I.delivered d ON (d.relation, d.source, d.source_ref) = ('axis', c.source, c.source_ref)
WHERE a.axis_id = $1 $sql$, model) INTO said, as_delivered USING axis, column_name;
    IF as_delivered THEN
        -- Both are the source's again, and so is the word for it.
        EXECUTE format('UPDATE %I.axis SET width_by_hand = true WHERE axis_id = $1 AND NOT width_by_hand', model)
            USING axis;
        EXECUTE format('UPDATE %I.axis SET source_width = $2, source_width_end = $3 WHERE axis_id = $1', model)
            USING axis, (said ->> 'width')::float8, (said ->> 'width_end')::float8;
        EXECUTE format('UPDATE %I.axis SET width_by_hand = false WHERE axis_id = $1', model) USING axis;
    ELSE
        PERFORM streetgen._give_column(model, 'axis', axis, column_name, said ->> column_name);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._give_width(name, bigint, text) IS
    'Gives width or width_end of an axis the value of its source; where the other one has it too, neither is by hand '
    'any more.';

CREATE OR REPLACE FUNCTION streetgen.settle_conflict(model name, row_id bigint, column_name text, holds text,
    relation text DEFAULT 'axis') RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_variable
DECLARE
    conflict record;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('row_id', row_id::text, 'column_name',
        column_name, 'holds', holds, 'relation', relation);
    IF holds NOT IN ('hand', 'source') THEN
        RAISE EXCEPTION 'holds is "%"', holds USING ERRCODE = '22023', HINT = 'hand or source: whose value holds.';
    END IF;
    EXECUTE format('SELECT * FROM %I.open_conflict c WHERE (c.relation, c.row_id, c.column_name) = ($1, $2, $3)',
        model) INTO conflict USING relation, row_id, column_name;
    IF conflict.stands IS NULL THEN
        RAISE EXCEPTION 'there is no conflict in column "%" of % %', column_name, relation, row_id
            USING ERRCODE = '22023', HINT = format('SELECT * FROM %I.import_conflict lists them.', model);
    END IF;
    IF holds = conflict.stands THEN
        NULL;
    ELSIF column_name <> '*' AND holds = 'source' AND column_name IN ('width', 'width_end') THEN
        PERFORM streetgen._give_width(model, row_id, column_name);
    ELSIF column_name <> '*' THEN
        PERFORM streetgen._give_column(model, relation, row_id, column_name, CASE holds WHEN 'hand'
            THEN conflict.by_hand ELSE conflict.source_new END);
    ELSIF (CASE holds WHEN 'hand' THEN conflict.by_hand ELSE conflict.source_new END) IS NULL THEN
        EXECUTE format('DELETE FROM %I.%I WHERE %I = $1', model, relation, relation || '_id') USING row_id;
    ELSE
        PERFORM streetgen._insert_json(model, relation, CASE holds WHEN 'hand' THEN conflict.by_hand::jsonb
            ELSE streetgen._delivered_row(model, relation, conflict.source, conflict.source_ref) END);
    END IF;
    EXECUTE format('DELETE FROM %I.open_conflict c WHERE (c.relation, c.row_id, c.column_name) = ($1, $2, $3)', model)
        USING relation, row_id, column_name;
END $$;
COMMENT ON FUNCTION streetgen.settle_conflict(name, bigint, text, text, text) IS
    'Ends a conflict of view import_conflict. holds: hand, and the row has what was by hand, or source, and it has '
    'what the source says now. A whole row (column_name *) comes back or is deleted so. relation: the table of the row '
    '(axis, control_point or turn_restriction). Later deliveries find what then stands beside what the source said '
    'last, and tell again only what the source changes. An unknown model: 3F000; no such conflict, or another word '
    'for holds: 22023; who may not edit the model: 42501.';
