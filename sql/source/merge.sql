-- A delivery and the rows that are there, merged column by column by what the source said before.

CREATE OR REPLACE FUNCTION streetgen._drop_unchanged(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    IF relation = 'axis' THEN
        -- Most are known by their hash, and what they say is not even put together.
        DELETE FROM pg_temp._import_part p USING axis a
            WHERE a.source = origin AND a.source_ref = p.source_ref AND a.source_hash = p.hash
                AND a.source_geom::bytea = p.source_geom::bytea AND NOT EXISTS (SELECT FROM delivered d
                    WHERE d.source = a.source AND d.source_ref = p.source_ref AND d.relation = 'axis' AND d.gone);
    END IF;
    DELETE FROM pg_temp._import_part p USING pg_temp._import_said s JOIN delivered d
        ON (d.relation, d.source, d.source_ref) = (_drop_unchanged.relation, origin, s.source_ref)
    WHERE p.source_ref = s.source_ref AND NOT d.gone AND d.source_geom::bytea = s.source_geom::bytea
        AND jsonb_strip_nulls(d.said || s.said) = d.said;
END $$;
COMMENT ON FUNCTION streetgen._drop_unchanged(name, name, text) IS
    'Takes out of the import what the source says as before: it stays as it is, edited by hand or not.';

CREATE OR REPLACE FUNCTION streetgen._delivery_wins(model name) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN coalesce((SELECT value FROM setting WHERE name = 'delivery_wins'), 'hand');
END $$;
COMMENT ON FUNCTION streetgen._delivery_wins(name) IS 'Setting delivery_wins of a model: hand or source.';

CREATE OR REPLACE FUNCTION streetgen._find_standing(model name, relation name, source text, refs text[],
    whole boolean) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE _import_there ON COMMIT DROP AS SELECT d.source_ref, t.%I AS id, '
        't.source_ref AS own_ref, t.geom, %s AS said, CASE WHEN $4 THEN %s END AS whole, %s AS width_by_hand '
        'FROM unnest($3) ref JOIN %I.delivered d ON (d.relation, d.source, d.source_ref) = ($1, $2, ref) '
        'LEFT JOIN LATERAL (%s) t ON true', relation || '_id', streetgen._values_there(model, relation),
        streetgen._row_json(format('%I.%I', model, relation)::regclass, 't'),
        CASE relation WHEN 'axis' THEN 't.width_by_hand' ELSE 'false' END, model,
        streetgen._rows_delivered(model, relation)) USING relation, source, refs, whole;
END $$;
COMMENT ON FUNCTION streetgen._find_standing(name, name, text, text[], boolean) IS
    'Makes the table of the rows of a model that stand for some source_refs that were delivered, with what they have, '
    'and all of it where the whole is asked for. A source_ref without one has a row without an id.';

CREATE OR REPLACE FUNCTION streetgen._compare_delivery(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    -- A row for each column that the source changed, of each row that stands for it. Of a model of an older build it
    -- is not known what the source said: then all that differs may be by hand.
    CREATE TEMPORARY TABLE _import_merge ON COMMIT DROP AS
    WITH changed AS (
        SELECT d.*, jsonb_strip_nulls(coalesce(d.said, '{}') || p.said) AS merged,
            -- An importer writes these whatever is by hand. The hash of a delivery that lacks columns is told from
            -- others.
            CASE _compare_delivery.relation WHEN 'axis' THEN jsonb_build_object('source_geom', p.source_geom::text,
                'source_hash', CASE WHEN d.said - ARRAY(SELECT jsonb_object_keys(p.said))
                    <@ '{"level": 0, "direction": "both"}' THEN p.hash ELSE p.hash # 1 END) ELSE '{}' END AS marks,
            coalesce(d.said, '{}') || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text) AS before,
            p.said || CASE WHEN d.source_geom::bytea IS DISTINCT FROM p.source_geom::bytea
                THEN jsonb_build_object('geom', coalesce(p.cleaned, p.source_geom)::text) ELSE '{}' END AS after
        FROM pg_temp._import_said p JOIN delivered d ON (d.relation, d.source, d.source_ref)
            = (_compare_delivery.relation, origin, p.source_ref)),
    there AS (
        SELECT d.*, t.id, t.said || jsonb_build_object('geom', t.geom::text) AS by_hand, t.width_by_hand,
            count(*) OVER (PARTITION BY d.source_ref) > 1 OR t.own_ref IS DISTINCT FROM d.source_ref AS cut
        FROM changed d JOIN pg_temp._import_there t USING (source_ref) WHERE t.id IS NOT NULL)
    SELECT t.id, t.source_ref, t.by_hand, t.width_by_hand, t.merged, t.marks, c.name AS column_name,
        t.after -> c.name AS value,
        -- Each piece would get the whole line.
        t.cut AND c.name = 'geom' AS kept,
        CASE WHEN c.known THEN t.before ->> c.name END AS source_old, t.after ->> c.name AS source_new,
        CASE WHEN t.by_hand ->> c.name IS NOT DISTINCT FROM t.after ->> c.name THEN 'alike'
            WHEN o.stands = 'hand' AND o.source_old IS NOT DISTINCT FROM t.after ->> c.name AND c.known
                THEN 'taken back'
            WHEN c.known AND t.by_hand ->> c.name IS NOT DISTINCT FROM t.before ->> c.name
                AND NOT (c.name IN ('width', 'width_end') AND t.width_by_hand) THEN 'taken'
            ELSE 'in conflict' END AS fate
    FROM there t CROSS JOIN LATERAL (
        SELECT k.name, CASE k.name WHEN 'geom' THEN t.source_geom IS NOT NULL ELSE t.said IS NOT NULL END AS known
        FROM jsonb_object_keys(t.after) k(name)) c
    LEFT JOIN open_conflict o ON (o.relation, o.row_id, o.column_name)
        = (_compare_delivery.relation, t.id, c.name)
    WHERE NOT c.known OR t.before ->> c.name IS DISTINCT FROM t.after ->> c.name;
END $$;
COMMENT ON FUNCTION streetgen._compare_delivery(name, name, text) IS
    'Makes the table of what the import changes, column by column: alike (the row has it), taken back (the source '
    'says again what it said before a conflict), taken, or in conflict with what is by hand. The line of a row that '
    'was cut by hand is kept, whoever wins.';

CREATE OR REPLACE FUNCTION streetgen._write_merged(model name, relation name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    written constant text[] := streetgen._delivered_columns(relation) || CASE relation WHEN 'axis'
        THEN '{source_geom,source_hash,width_by_hand,source_width,source_width_end}'::text[] ELSE '{}' END;
    ids bigint[];
    patches jsonb[];
BEGIN
    IF relation = 'street_object' THEN
        PERFORM streetgen._write_merged_objects(model, source, wins);
        RETURN;
    END IF;
    SELECT array_agg(id), array_agg(patch) INTO ids, patches FROM (
        SELECT id, marks || coalesce(jsonb_object_agg(column_name, value) FILTER (WHERE taken), '{}') || CASE
            WHEN NOT width_by_hand THEN '{}' WHEN bool_or(taken AND column_name IN ('width', 'width_end'))
                THEN '{"width_by_hand": false, "source_width": null, "source_width_end": null}'
            ELSE jsonb_build_object('source_width', merged -> 'width', 'source_width_end', merged -> 'width_end')
            END AS patch
        FROM (SELECT *, fate = 'taken' OR fate = 'in conflict' AND wins = 'source' AND NOT kept AS taken
            FROM pg_temp._import_merge) m
        GROUP BY id, marks, merged, by_hand, width_by_hand) m WHERE patch <> '{}';
    EXECUTE format('UPDATE %I.%I t SET (%s) = (SELECT %s FROM jsonb_populate_record(t, m.patch) r) '
        'FROM unnest($1, $2) m(id, patch) WHERE t.%I = m.id', model, relation,
        (SELECT string_agg(quote_ident(name), ', ') FROM unnest(written) name),
        (SELECT string_agg('r.' || quote_ident(name), ', ') FROM unnest(written) name), relation || '_id')
        USING ids, patches;
END $$;
COMMENT ON FUNCTION streetgen._write_merged(name, name, text, text) IS
    'Writes what the comparison found to be taken, and where the source wins also what is in conflict. A width that '
    'stays by hand gets that of the source beside it.';

CREATE OR REPLACE FUNCTION streetgen._keep_conflicts(model name, relation name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    DELETE FROM open_conflict c USING pg_temp._import_merge m
        WHERE c.relation = _keep_conflicts.relation AND (c.row_id, c.column_name) = (m.id, m.column_name)
            AND c.stands = 'hand' AND m.fate IN ('alike', 'taken back');
    -- An editor who lost to the source before still sees what it says now.
    UPDATE open_conflict c SET source_new = m.source_new FROM pg_temp._import_merge m
        WHERE c.relation = _keep_conflicts.relation AND (c.row_id, c.column_name) = (m.id, m.column_name)
            AND m.fate <> 'in conflict';
    INSERT INTO open_conflict (relation, row_id, column_name, source, source_ref, by_hand, source_old, source_new,
            stands)
        SELECT _keep_conflicts.relation, m.id, m.column_name, origin, m.source_ref,
            m.by_hand ->> m.column_name, m.source_old, m.source_new, CASE WHEN m.kept THEN 'hand' ELSE wins END
        FROM pg_temp._import_merge m WHERE m.fate = 'in conflict'
        ON CONFLICT (relation, row_id, column_name) DO UPDATE SET by_hand = excluded.by_hand,
            source_new = excluded.source_new, stands = excluded.stands;
END $$;
COMMENT ON FUNCTION streetgen._keep_conflicts(name, name, text, text) IS
    'Keeps the conflicts that the comparison found, for view import_conflict, and ends those that are none any more.';

CREATE OR REPLACE FUNCTION streetgen._keep_deleted(model name, relation name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    INSERT INTO open_conflict (relation, row_id, column_name, source, source_ref, source_old, source_new, stands)
        SELECT d.relation, d.row_id, '*', d.source, d.source_ref, jsonb_object_agg(k.name, before ->> k.name)::text,
            jsonb_object_agg(k.name, after ->> k.name)::text, CASE WHEN d.cut THEN 'hand' ELSE wins END
        FROM (
            SELECT d.*, t.cut, d.said || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text) AS before,
                p.said || jsonb_build_object('geom', CASE WHEN d.source_geom::bytea = p.source_geom::bytea
                    THEN coalesce(d.cleaned, d.source_geom) ELSE coalesce(p.cleaned, p.source_geom) END::text) AS after
            FROM (SELECT source_ref, count(id) > 0 AS cut FROM pg_temp._import_there GROUP BY source_ref
                    HAVING count(*) FILTER (WHERE own_ref = source_ref) = 0) t
                JOIN pg_temp._import_said p USING (source_ref) JOIN delivered d ON (d.relation, d.source, d.source_ref)
                    = (_keep_deleted.relation, origin, t.source_ref)) d
        CROSS JOIN LATERAL jsonb_object_keys(d.after) k(name)
        WHERE before ->> k.name IS DISTINCT FROM after ->> k.name
        GROUP BY d.relation, d.source, d.source_ref, d.row_id, d.cut ORDER BY d.source_ref
        ON CONFLICT (relation, row_id, column_name) DO UPDATE SET source_new = excluded.source_new;
END $$;
COMMENT ON FUNCTION streetgen._keep_deleted(name, name, text, text) IS
    'Keeps a conflict for each row that was deleted by hand and that the source changed. One of which pieces stand '
    'stays away, whoever wins.';

CREATE OR REPLACE FUNCTION streetgen._bring_back(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
    absent record;
BEGIN
    PERFORM streetgen._use_model(model);
    -- Deleted by the source with what was by hand, and there again.
    FOR absent IN EXECUTE format('DELETE FROM open_conflict c USING pg_temp._import_part p WHERE c.relation = $1 '
        'AND (c.source, c.source_ref) = ($2, p.source_ref) AND c.column_name = ''*'' AND c.stands = ''source'' '
        'AND c.source_new IS NULL AND NOT EXISTS (SELECT FROM %I.%I t WHERE (t.source, t.source_ref) '
        '= ($2, p.source_ref)) RETURNING c.by_hand::jsonb AS row', model, relation) USING relation, source LOOP
        PERFORM streetgen._insert_json(model, relation, absent.row);
    END LOOP;
    DELETE FROM open_conflict c USING pg_temp._import_part p
        WHERE (c.relation, c.source, c.source_ref) = (_bring_back.relation, origin, p.source_ref)
            AND c.column_name = '*' AND c.stands = 'hand' AND c.source_new IS NULL;
END $$;
COMMENT ON FUNCTION streetgen._bring_back(name, name, text) IS
    'Ends the conflicts about rows that the source had deleted and has again: what was by hand is there again, for '
    'the import to merge.';

CREATE OR REPLACE FUNCTION streetgen._merge_delivery(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    wins constant text := streetgen._delivery_wins(model);
    absent text;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._find_standing(model, relation, source,
        ARRAY(SELECT p.source_ref FROM pg_temp._import_part p WHERE p.source_ref IS NOT NULL), false);
    -- Triggers of what is written find the conflicts as they are to be.
    PERFORM streetgen._compare_delivery(model, relation, source),
        streetgen._keep_deleted(model, relation, source, wins),
        streetgen._keep_conflicts(model, relation, source, wins),
        streetgen._write_merged(model, relation, source, wins);
    UPDATE delivered d SET said = jsonb_strip_nulls(coalesce(d.said, '{}') || p.said), source_geom = p.source_geom,
            gone = false,
            cleaned = CASE WHEN d.source_geom::bytea = p.source_geom::bytea THEN d.cleaned ELSE p.cleaned END
        FROM pg_temp._import_said p WHERE (d.relation, d.source, d.source_ref)
            = (_merge_delivery.relation, origin, p.source_ref);
    IF wins = 'source' THEN
        FOR absent IN SELECT t.source_ref FROM pg_temp._import_there t WHERE t.id IS NULL ORDER BY 1 LOOP
            PERFORM streetgen._insert_delivered(model, relation, source, absent, off_street => true);
        END LOOP;
    END IF;
    DROP TABLE pg_temp._import_merge, pg_temp._import_there;
END $$;
COMMENT ON FUNCTION streetgen._merge_delivery(name, name, text) IS
    'Brings the rows of a model up to date with the parts of the import that the source changed: column by column, '
    'and where a column is by hand, by setting delivery_wins.';

CREATE OR REPLACE FUNCTION streetgen._tell_by_hand(model name, relation name, source text, among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    kept text[] COLLATE "default";
    wanted constant text[] COLLATE "default" := among;
BEGIN
    PERFORM streetgen._use_model(model);
    -- The hash is sooner asked.
    EXECUTE format('SELECT array_agg(d.source_ref) FROM %I.delivered d LEFT JOIN LATERAL (%s) t ON true '
        'WHERE (d.relation, d.source) = ($1, $2) AND ($3 IS NULL OR d.source_ref = ANY ($3)) AND (t.%I IS NULL '
        'OR d.said IS NULL OR t.geom::bytea IS DISTINCT FROM coalesce(d.cleaned, d.source_geom)::bytea '
        'OR %s jsonb_strip_nulls(%s) <> d.said %s)', model, streetgen._row_delivered(model, relation),
        relation || '_id', CASE relation WHEN 'axis' THEN format('streetgen._source_hash(%s) '
            'IS DISTINCT FROM t.source_hash AND', (
                SELECT string_agg(CASE WHEN name IN ('width', 'width_end') THEN format('CASE WHEN t.width_by_hand '
                'THEN t.source_%1$s ELSE t.%1$s END', name) ELSE 't.' || name END, ', ') FROM streetgen._axis_input()))
            END, streetgen._values_there(model, relation),
        CASE relation WHEN 'axis' THEN 'OR t.width_by_hand' END) INTO kept USING relation, source, among;
    -- A row once: with what is in conflict, or else with what is by hand beside what the source says.
    RETURN QUERY WITH conflict AS MATERIALIZED (
        SELECT DISTINCT coalesce(source_ref, relation || ' ' || row_id) AS source_ref FROM open_conflict
        WHERE relation = _tell_by_hand.relation AND source = origin
            AND (wanted IS NULL OR source_ref = ANY (wanted)))
    SELECT 'by hand, kept', NULL::text, count(*), array_agg(source_ref ORDER BY source_ref) FROM unnest(kept) source_ref
        WHERE source_ref NOT IN (SELECT source_ref FROM conflict) HAVING count(*) > 0
    UNION ALL
    SELECT 'in conflict', NULL, count(*), array_agg(source_ref ORDER BY source_ref) FROM conflict HAVING count(*) > 0;
END $$;
COMMENT ON FUNCTION streetgen._tell_by_hand(name, name, text, text[]) IS
    'Reports the rows of a source, or some source_refs of it, in which something by hand stands, deleted ones too, '
    'and those with open conflicts.';
