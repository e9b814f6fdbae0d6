-- A delivery and the rows that are there, merged column by column by what the source said before.

CREATE OR REPLACE FUNCTION streetgen._drop_unchanged(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF relation = 'axis' THEN
        -- Most are known by their hash, and what they say is not even put together.
        EXECUTE format($sql$
DELETE FROM pg_temp._import_part p USING %1$I.axis a
WHERE a.source = $1 AND a.source_ref = p.source_ref AND a.source_hash = p.hash
    AND a.source_geom::bytea = p.source_geom::bytea AND NOT EXISTS (SELECT FROM %1$I.delivered d
        WHERE d.source = $1 AND d.source_ref = p.source_ref AND d.relation = 'axis' AND d.gone) $sql$, model)
            USING source;
    END IF;
    EXECUTE format($sql$
DELETE FROM pg_temp._import_part p USING pg_temp._import_said s JOIN %I.delivered d
    ON (d.relation, d.source, d.source_ref) = ($1, $2, s.source_ref)
WHERE p.source_ref = s.source_ref AND NOT d.gone AND d.source_geom::bytea = s.source_geom::bytea
    AND jsonb_strip_nulls(d.said || s.said) = d.said $sql$, model) USING relation, source;
END $$;
COMMENT ON FUNCTION streetgen._drop_unchanged(name, name, text) IS
    'Takes out of the import what the source says as before: it stays as it is, edited by hand or not.';

CREATE OR REPLACE FUNCTION streetgen._delivery_wins(model name) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wins text;
BEGIN
    EXECUTE format('SELECT value FROM %I.setting WHERE name = ''delivery_wins''', model) INTO wins;
    RETURN coalesce(wins, 'hand');
END $$;
COMMENT ON FUNCTION streetgen._delivery_wins(name) IS 'Setting delivery_wins of a model: hand or source.';

CREATE OR REPLACE FUNCTION streetgen._compare_delivery(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A row for each column that the source changed, of each row that stands for it. Of a model of an older build it
    -- is not known what the source said: then all that differs may be by hand.
    EXECUTE format($sql$
CREATE TEMPORARY TABLE _import_merge ON COMMIT DROP AS
WITH changed AS (
    SELECT d.*, %5$s AS marks, jsonb_strip_nulls(coalesce(d.said, '{}') || p.said) AS merged,
        coalesce(d.said, '{}') || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text) AS before,
        p.said || CASE WHEN d.source_geom::bytea IS DISTINCT FROM p.source_geom::bytea
            THEN jsonb_build_object('geom', coalesce(p.cleaned, p.source_geom)::text) ELSE '{}' END AS after
    FROM pg_temp._import_said p JOIN %1$I.delivered d ON d.relation = %6$L AND d.source = $1
        AND d.source_ref = p.source_ref),
there AS (
    SELECT d.*, t.%3$I AS id, (%4$s) AS by_hand, count(*) OVER (PARTITION BY d.source_ref) > 1
        OR t.source_ref IS DISTINCT FROM d.source_ref AS cut
    FROM changed d CROSS JOIN LATERAL (%2$s) t)
SELECT t.id, t.source_ref, t.by_hand, t.merged, t.marks, c.name AS column_name, t.after -> c.name AS value,
    -- Each piece would get the whole line.
    t.cut AND c.name = 'geom' AS kept,
    CASE WHEN c.known THEN t.before ->> c.name END AS source_old, t.after ->> c.name AS source_new,
    CASE WHEN t.by_hand ->> c.name IS NOT DISTINCT FROM t.after ->> c.name THEN 'alike'
        WHEN o.stands = 'hand' AND o.source_old IS NOT DISTINCT FROM t.after ->> c.name AND c.known THEN 'taken back'
        WHEN c.known AND t.by_hand ->> c.name IS NOT DISTINCT FROM t.before ->> c.name
            AND NOT (c.name IN ('width', 'width_end') AND coalesce((t.by_hand ->> 'width_by_hand')::boolean, false))
            THEN 'taken'
        ELSE 'in conflict' END AS fate
FROM there t CROSS JOIN LATERAL (
    SELECT k.name, CASE k.name WHEN 'geom' THEN t.source_geom IS NOT NULL ELSE t.said IS NOT NULL END AS known
    FROM jsonb_object_keys(t.after) k(name)) c
LEFT JOIN %1$I.open_conflict o ON (o.relation, o.row_id, o.column_name) = (%6$L, t.id, c.name)
WHERE NOT c.known OR t.before ->> c.name IS DISTINCT FROM t.after ->> c.name $sql$, model,
        streetgen._rows_delivered(model, relation), relation || '_id',
        streetgen._values_there(model, relation) || ' || jsonb_build_object(''geom'', t.geom::text'
            || CASE relation WHEN 'axis' THEN ', ''width_by_hand'', t.width_by_hand)' ELSE ')' END,
        -- An importer writes these whatever is by hand. The hash of a delivery that lacks columns is told from others.
        CASE relation WHEN 'axis'
            THEN 'jsonb_build_object(''source_geom'', p.source_geom::text, ''source_hash'', CASE '
                'WHEN d.said - ARRAY(SELECT jsonb_object_keys(p.said)) <@ ''{"level": 0, "direction": "both"}'' '
                'THEN p.hash ELSE p.hash # 1 END)'
            ELSE '''{}''::jsonb' END, relation) USING source;
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
BEGIN
    IF relation = 'street_object' THEN
        PERFORM streetgen._write_merged_objects(model, source, wins);
        RETURN;
    END IF;
    EXECUTE format($sql$
WITH merged AS MATERIALIZED (
    SELECT id, marks || coalesce(jsonb_object_agg(column_name, value) FILTER (WHERE taken), '{}') || CASE
        WHEN NOT coalesce((by_hand ->> 'width_by_hand')::boolean, false) THEN '{}'
        WHEN bool_or(taken AND column_name IN ('width', 'width_end'))
            THEN '{"width_by_hand": false, "source_width": null, "source_width_end": null}'
        ELSE jsonb_build_object('source_width', merged -> 'width', 'source_width_end', merged -> 'width_end')
        END AS patch
    FROM (SELECT *, fate = 'taken' OR fate = 'in conflict' AND $1 = 'source' AND NOT kept AS taken
        FROM pg_temp._import_merge) m
    GROUP BY id, marks, merged, by_hand)
UPDATE %1$I.%2$I t SET (%3$s) = (SELECT %4$s FROM jsonb_populate_record(t, m.patch) r) FROM merged m
WHERE t.%5$I = m.id AND m.patch <> '{}' $sql$, model, relation,
        (SELECT string_agg(quote_ident(name), ', ') FROM unnest(written) name),
        (SELECT string_agg('r.' || quote_ident(name), ', ') FROM unnest(written) name), relation || '_id') USING wins;
END $$;
COMMENT ON FUNCTION streetgen._write_merged(name, name, text, text) IS
    'Writes what the comparison found to be taken, and where the source wins also what is in conflict. A width that '
    'stays by hand gets that of the source beside it.';

CREATE OR REPLACE FUNCTION streetgen._keep_conflicts(model name, relation name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
DELETE FROM %I.open_conflict c USING pg_temp._import_merge m
WHERE (c.relation, c.row_id, c.column_name) = ($1, m.id, m.column_name) AND c.stands = 'hand'
    AND m.fate IN ('alike', 'taken back') $sql$, model) USING relation;
    -- An editor who lost to the source before still sees what it says now.
    EXECUTE format($sql$
UPDATE %I.open_conflict c SET source_new = m.source_new FROM pg_temp._import_merge m
WHERE (c.relation, c.row_id, c.column_name) = ($1, m.id, m.column_name) AND m.fate <> 'in conflict' $sql$, model)
        USING relation;
    EXECUTE format($sql$
INSERT INTO %I.open_conflict (relation, row_id, column_name, source, source_ref, by_hand, source_old, source_new,
    stands)
SELECT $1, m.id, m.column_name, $2, m.source_ref, m.by_hand ->> m.column_name, m.source_old, m.source_new,
    CASE WHEN m.kept THEN 'hand' ELSE $3 END
FROM pg_temp._import_merge m WHERE m.fate = 'in conflict'
ON CONFLICT (relation, row_id, column_name) DO UPDATE SET by_hand = excluded.by_hand,
    source_new = excluded.source_new, stands = excluded.stands $sql$, model) USING relation, source, wins;
END $$;
COMMENT ON FUNCTION streetgen._keep_conflicts(name, name, text, text) IS
    'Keeps the conflicts that the comparison found, for view import_conflict, and ends those that are none any more.';

CREATE OR REPLACE FUNCTION streetgen._keep_deleted(model name, relation name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    absent record;
BEGIN
    FOR absent IN EXECUTE format($sql$
SELECT d.source_ref, d.row_id, jsonb_object_agg(k.name, before ->> k.name)::text AS source_old,
    jsonb_object_agg(k.name, after ->> k.name)::text AS source_new, EXISTS (%3$s) AS cut
FROM (SELECT d.*, d.said || jsonb_build_object('geom', coalesce(d.cleaned, d.source_geom)::text) AS before,
        p.said || jsonb_build_object('geom', CASE WHEN d.source_geom::bytea = p.source_geom::bytea
            THEN coalesce(d.cleaned, d.source_geom) ELSE coalesce(p.cleaned, p.source_geom) END::text) AS after
    FROM pg_temp._import_said p JOIN %1$I.delivered d ON (d.relation, d.source, d.source_ref)
        = ($1, $2, p.source_ref)) d
CROSS JOIN LATERAL jsonb_object_keys(d.after) k(name)
WHERE before ->> k.name IS DISTINCT FROM after ->> k.name
    AND NOT EXISTS (SELECT FROM %1$I.%2$I t WHERE t.source = $2 AND t.source_ref = d.source_ref)
GROUP BY d.source, d.source_ref, d.source_geom, d.row_id ORDER BY d.source_ref $sql$, model, relation,
        streetgen._rows_delivered(model, relation)) USING relation, source LOOP
        EXECUTE format($sql$
INSERT INTO %I.open_conflict (relation, row_id, column_name, source, source_ref, source_old, source_new, stands)
VALUES ($1, $2, '*', $3, $4, $5, $6, $7)
ON CONFLICT (relation, row_id, column_name) DO UPDATE SET source_new = excluded.source_new $sql$, model)
            USING relation, absent.row_id, source, absent.source_ref, absent.source_old, absent.source_new,
                CASE WHEN absent.cut THEN 'hand' ELSE wins END;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._keep_deleted(name, name, text, text) IS
    'Keeps a conflict for each row that was deleted by hand and that the source changed. One of which pieces stand '
    'stays away, whoever wins.';

CREATE OR REPLACE FUNCTION streetgen._bring_back(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    absent record;
BEGIN
    -- Deleted by the source with what was by hand, and there again.
    FOR absent IN EXECUTE format($sql$
DELETE FROM %1$I.open_conflict c USING pg_temp._import_part p WHERE c.relation = $1 AND c.source = $2
    AND c.source_ref = p.source_ref AND c.column_name = '*' AND c.stands = 'source' AND c.source_new IS NULL
    AND NOT EXISTS (SELECT FROM %1$I.%2$I t WHERE t.source = $2 AND t.source_ref = p.source_ref)
RETURNING c.by_hand::jsonb AS row $sql$, model, relation) USING relation, source LOOP
        PERFORM streetgen._insert_json(model, relation, absent.row);
    END LOOP;
    EXECUTE format($sql$
DELETE FROM %1$I.open_conflict c USING pg_temp._import_part p WHERE c.relation = $1 AND c.source = $2
    AND c.source_ref = p.source_ref AND c.column_name = '*' AND c.stands = 'hand' AND c.source_new IS NULL $sql$, model)
        USING relation, source;
END $$;
COMMENT ON FUNCTION streetgen._bring_back(name, name, text) IS
    'Ends the conflicts about rows that the source had deleted and has again: what was by hand is there again, for '
    'the import to merge.';

CREATE OR REPLACE FUNCTION streetgen._merge_delivery(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wins constant text := streetgen._delivery_wins(model);
    absent text;
BEGIN
    -- Triggers of what is written find the conflicts as they are to be.
    PERFORM streetgen._compare_delivery(model, relation, source),
        streetgen._keep_deleted(model, relation, source, wins),
        streetgen._keep_conflicts(model, relation, source, wins),
        streetgen._write_merged(model, relation, source, wins);
    DROP TABLE pg_temp._import_merge;
    EXECUTE format($sql$
UPDATE %1$I.delivered d SET said = jsonb_strip_nulls(coalesce(d.said, '{}') || p.said), source_geom = p.source_geom,
    gone = false, cleaned = CASE WHEN d.source_geom::bytea = p.source_geom::bytea THEN d.cleaned ELSE p.cleaned END
FROM pg_temp._import_said p WHERE (d.relation, d.source, d.source_ref) = ($1, $2, p.source_ref) $sql$, model)
        USING relation, source;
    IF wins = 'source' THEN
        FOR absent IN EXECUTE format($sql$
SELECT d.source_ref FROM pg_temp._import_part p JOIN %1$I.delivered d ON (d.relation, d.source, d.source_ref)
    = ($1, $2, p.source_ref)
WHERE NOT EXISTS (%2$s) ORDER BY 1 $sql$, model, streetgen._rows_delivered(model, relation)) USING relation, source
        LOOP
            PERFORM streetgen._insert_delivered(model, relation, source, absent);
        END LOOP;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._merge_delivery(name, name, text) IS
    'Brings the rows of a model up to date with the parts of the import that the source changed: column by column, '
    'and where a column is by hand, by setting delivery_wins.';

CREATE OR REPLACE FUNCTION streetgen._tell_by_hand(model name, relation name, source text, among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A row once: with what is in conflict, or else with what is by hand beside what the source says.
    RETURN QUERY EXECUTE format($sql$
WITH conflict AS MATERIALIZED (SELECT DISTINCT row_id, coalesce(source_ref, $2 || ' ' || row_id) AS source_ref
    FROM %1$I.open_conflict WHERE relation = $2 AND source = $1 AND ($3 IS NULL OR source_ref = ANY ($3))),
kept AS (
    SELECT d.source_ref FROM %1$I.delivered d LEFT JOIN LATERAL (%7$s) t ON true
    WHERE d.relation = $2 AND d.source = $1 AND ($3 IS NULL OR d.source_ref = ANY ($3))
        AND d.source_ref NOT IN (SELECT source_ref FROM conflict)
        AND (t.%3$I IS NULL OR d.said IS NULL
            OR t.geom::bytea IS DISTINCT FROM coalesce(d.cleaned, d.source_geom)::bytea
            OR %6$s jsonb_strip_nulls(%4$s) <> d.said %5$s))
SELECT 'by hand, kept', NULL::text, count(*), array_agg(source_ref ORDER BY source_ref) FROM kept HAVING count(*) > 0
UNION ALL
SELECT 'in conflict', NULL, count(DISTINCT source_ref), array_agg(DISTINCT source_ref ORDER BY source_ref) FROM conflict
HAVING count(*) > 0 $sql$, model, relation, relation || '_id',
        streetgen._values_there(model, relation), CASE relation WHEN 'axis' THEN 'OR t.width_by_hand' END,
        -- The hash is sooner asked; it takes 0 of these for nothing.
        CASE relation WHEN 'axis' THEN '(' || streetgen._source_hash('t', 'axis') || ' IS DISTINCT FROM t.source_hash '
            'OR 0 IN (t.lanes_both, t.roadway_offset)) AND' END, streetgen._row_delivered(model, relation))
        USING source, relation, among;
END $$;
COMMENT ON FUNCTION streetgen._tell_by_hand(name, name, text, text[]) IS
    'Reports the rows of a source, or some source_refs of it, in which something by hand stands, deleted ones too, '
    'and those with open conflicts.';
