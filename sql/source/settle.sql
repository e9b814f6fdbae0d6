-- Settling a conflict between what is by hand and what a source says.

CREATE OR REPLACE FUNCTION streetgen._insert_json(model name, relation name, said jsonb) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    key constant name := relation || '_id';
    taken boolean;
    columns text;
    row_id bigint;
BEGIN
    EXECUTE format('SELECT EXISTS (SELECT FROM %I.%I WHERE %I = $1)', model, relation, key) INTO taken
        USING (said ->> key)::bigint;
    columns := (SELECT string_agg(quote_ident(attname), ', ') FROM pg_attribute
        WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0 AND NOT attisdropped
            AND said ? attname AND NOT (taken AND attname = key)
            -- Another object may point to the control point since.
            AND NOT (relation = 'street_object' AND attname = 'control_point_id'));
    EXECUTE format('INSERT INTO %1$I.%2$I (%3$s) SELECT %3$s FROM jsonb_populate_record(NULL::%1$I.%2$I, $1) '
        'RETURNING %4$I', model, relation, columns, key) INTO row_id USING said;
    RETURN row_id;
END $$;
COMMENT ON FUNCTION streetgen._insert_json(name, name, jsonb) IS
    'Inserts a row, given as streetgen._row_json gives it, into a table of a model, and returns its key: the one that '
    'it had, or a new one where another row has that.';

CREATE OR REPLACE FUNCTION streetgen._insert_delivered(model name, relation name, source text, source_ref text,
    off_street boolean DEFAULT false) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
    ref constant text COLLATE "default" := source_ref;
    said jsonb;
    former bigint;
    key bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT d.row_id, d.said || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text, 'source', d.source,
            'source_ref', d.source_ref, d.relation || '_id', d.row_id) || CASE d.relation WHEN 'axis'
            THEN jsonb_build_object('source_geom', d.source_geom::text) ELSE '{}' END INTO former, said
        FROM delivered d WHERE (d.relation, d.source, d.source_ref)
            = (_insert_delivered.relation, origin, ref);
    key := CASE relation WHEN 'street_object' THEN streetgen._insert_object(model, said, off_street)
        ELSE streetgen._insert_json(model, relation, said) END;
    IF key <> former THEN
        UPDATE delivered d SET row_id = key
            WHERE (d.relation, d.source, d.source_ref)
                = (_insert_delivered.relation, origin, ref);
        UPDATE open_conflict c SET row_id = key
            WHERE (c.relation, c.source, c.source_ref)
                = (_insert_delivered.relation, origin, ref)
                AND c.column_name = '*';
    END IF;
    RETURN key;
END $$;
COMMENT ON FUNCTION streetgen._insert_delivered(name, name, text, text, boolean) IS
    'Inserts the row that a source delivered last and returns its key; delivered and a conflict about the whole row '
    'get it. off_street: an object that stands at no street comes too.';

CREATE OR REPLACE FUNCTION streetgen._refuse_doubling(model name, relation name, row_id bigint, source text,
    source_ref text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    others text;
BEGIN
    EXECUTE format($sql$
SELECT string_agg(t.%2$I::text, ', ' ORDER BY t.%2$I) FROM %1$I.delivered d CROSS JOIN LATERAL (%3$s) t
WHERE (d.relation, d.source, d.source_ref) = ($1, $2, $3) AND t.%2$I <> $4 $sql$, model, relation || '_id',
        streetgen._rows_delivered(model, relation)) INTO others USING relation, source, source_ref, row_id;
    IF others IS NOT NULL THEN
        RAISE EXCEPTION 'the source has % % whole, and it was cut by hand', relation, row_id USING ERRCODE = '22023',
            DETAIL = format('Other pieces stand: %s.', others), HINT = 'Delete them, or let hold what is by hand.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._refuse_doubling(name, name, bigint, text, text) IS
    'Raises 22023 where other rows than this one stand for a row of a source: its whole line would lie on them.';

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
    PERFORM streetgen._use_model(model);
    SELECT d.said, CASE _give_width.column_name
            WHEN 'width' THEN a.width_end IS NOT DISTINCT FROM (d.said ->> 'width_end')::float8
            ELSE a.width IS NOT DISTINCT FROM (d.said ->> 'width')::float8 END INTO said, as_delivered
        FROM axis a JOIN open_conflict c ON (c.relation, c.row_id, c.column_name)
                = ('axis', a.axis_id, _give_width.column_name)
            JOIN delivered d ON (d.relation, d.source, d.source_ref) = ('axis', c.source, c.source_ref)
        WHERE a.axis_id = axis;
    IF as_delivered THEN
        -- Both are the source's again, and so is the word for it.
        UPDATE axis a SET width_by_hand = true WHERE a.axis_id = axis AND NOT a.width_by_hand;
        UPDATE axis a SET source_width = (said ->> 'width')::float8, source_width_end = (said ->> 'width_end')::float8
            WHERE a.axis_id = axis;
        UPDATE axis a SET width_by_hand = false WHERE a.axis_id = axis;
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
    table_of constant text COLLATE "default" := relation;
    column_of constant text COLLATE "default" := column_name;
    conflict record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('row_id', row_id::text, 'column_name',
        column_name, 'holds', holds, 'relation', relation);
    IF holds NOT IN ('hand', 'source') THEN
        RAISE EXCEPTION 'holds is "%"', holds USING ERRCODE = '22023', HINT = 'hand or source: whose value holds.';
    END IF;
    SELECT * INTO conflict FROM open_conflict c WHERE (c.relation, c.row_id, c.column_name)
        = (table_of, row_id, column_of);
    IF conflict.stands IS NULL THEN
        RAISE EXCEPTION 'there is no conflict in column "%" of % %', column_name, relation, row_id
            USING ERRCODE = '22023', HINT = format('SELECT * FROM %I.import_conflict lists them.', model);
    END IF;
    IF holds = 'source' AND column_name IN ('geom', '*') AND conflict.source_new IS NOT NULL THEN
        PERFORM streetgen._refuse_doubling(model, relation, row_id, conflict.source, conflict.source_ref);
    END IF;
    IF column_name <> '*' AND relation = 'street_object' THEN
        PERFORM streetgen._settle_object(model, row_id, column_name, holds, conflict);
    ELSIF holds = conflict.stands THEN
        NULL;
    ELSIF column_name <> '*' AND holds = 'source' AND column_name IN ('width', 'width_end') THEN
        PERFORM streetgen._give_width(model, row_id, column_name);
    ELSIF column_name <> '*' THEN
        PERFORM streetgen._give_column(model, relation, row_id, column_name, CASE holds WHEN 'hand'
            THEN conflict.by_hand ELSE conflict.source_new END);
    ELSIF (CASE holds WHEN 'hand' THEN conflict.by_hand ELSE conflict.source_new END) IS NULL THEN
        EXECUTE format('DELETE FROM %I.%I WHERE %I = $1', model, relation, relation || '_id') USING row_id;
    ELSIF holds = 'hand' THEN
        PERFORM streetgen._insert_json(model, relation, conflict.by_hand::jsonb);
    ELSE
        row_id := streetgen._insert_delivered(model, relation, conflict.source, conflict.source_ref);
    END IF;
    DELETE FROM open_conflict c WHERE (c.relation, c.row_id, c.column_name) = (table_of, row_id, column_of);
END $$;
COMMENT ON FUNCTION streetgen.settle_conflict(name, bigint, text, text, text) IS
    'Ends a conflict of view import_conflict. holds: hand, and the row has what was by hand, or source, and it has '
    'what the source says now. A whole row (column_name *) comes back or is deleted so. relation: the table of the row '
    '(axis, control_point, turn_restriction or street_object). Later deliveries find what then '
    'stands beside what the source said last, and tell again only what the source changes. An unknown model: 3F000; no '
    'such conflict, another word for holds, or the line of a source for one of several pieces: 22023; who may not edit '
    'the model: 42501.';

CREATE OR REPLACE FUNCTION streetgen._source_written() RETURNS TABLE(relation name, privilege text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('open_conflict'::name, 'DELETE') $$;
COMMENT ON FUNCTION streetgen._source_written() IS 'The right by which an editor settles a conflict.';
