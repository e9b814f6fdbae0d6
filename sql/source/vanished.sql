-- Rows that a source does not have any more.

CREATE OR REPLACE FUNCTION streetgen._drop_vanished(model name, relation name, source text, among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    table_of constant regclass := format('%I.%I', model, relation)::regclass;
    key constant name := relation || '_id';
    wins constant text := streetgen._delivery_wins(model);
BEGIN
    EXECUTE format($sql$
CREATE TEMPORARY TABLE _import_gone ON COMMIT DROP AS
-- EXCEPT needs no statistics of what was written a moment ago.
WITH gone AS MATERIALIZED (
    SELECT source_ref FROM %1$I.delivered d WHERE d.relation = $1 AND d.source = $2 AND NOT d.gone
        AND ($3 IS NULL OR d.source_ref = ANY ($3))
    EXCEPT SELECT source_ref FROM pg_temp._import_part)
SELECT d.source_ref, d.row_id AS former, d.said, t.%3$I AS id, %6$s AS whole,
    (%4$s) || jsonb_build_object('geom', CASE WHEN t.geom::bytea IS DISTINCT FROM coalesce(d.cleaned,
        d.source_geom)::bytea THEN t.geom::text END) AS by_hand,
    bool_or(t.%3$I IS NOT NULL AND (d.said IS NULL OR jsonb_strip_nulls(%4$s) <> d.said %5$s
        OR t.geom::bytea IS DISTINCT FROM coalesce(d.cleaned, d.source_geom)::bytea))
        OVER (PARTITION BY d.source_ref) AS edited
FROM gone g JOIN %1$I.delivered d ON (d.relation, d.source, d.source_ref) = ($1, $2, g.source_ref)
    LEFT JOIN LATERAL (%2$s) t ON true $sql$, model,
        streetgen._rows_delivered(model, relation), key,
        streetgen._values_there(model, relation),
        CASE relation WHEN 'axis' THEN 'OR t.width_by_hand' END, streetgen._row_json(table_of, 't'))
        USING relation, source, among;
    IF NOT EXISTS (SELECT FROM pg_temp._import_gone) THEN
        DROP TABLE pg_temp._import_gone;
        RETURN;
    END IF;
    RETURN QUERY EXECUTE format($sql$
WITH gone AS (DELETE FROM %1$I.%2$I t USING pg_temp._import_gone g WHERE t.%3$I = g.id
    AND (NOT g.edited OR $1 = 'source') RETURNING coalesce(t.source_ref, g.source_ref) AS source_ref)
SELECT 'vanished from the source, deleted; the first ten', NULL::text, count(*),
    (array_agg(source_ref ORDER BY source_ref))[:10] FROM gone HAVING count(*) > 0 $sql$, model, relation, key)
        USING wins;
    EXECUTE format($sql$
DELETE FROM %1$I.delivered d USING pg_temp._import_gone g WHERE (d.relation, d.source, d.source_ref)
    = ($1, $2, g.source_ref) AND NOT g.edited $sql$, model) USING relation, source;
    EXECUTE format($sql$
DELETE FROM %1$I.open_conflict c USING pg_temp._import_gone g WHERE c.relation = $1 AND (c.row_id = g.id
    OR c.row_id = g.former) AND (g.id IS NULL OR c.column_name <> '*') $sql$, model) USING relation;
    EXECUTE format($sql$
UPDATE %1$I.delivered d SET gone = true FROM pg_temp._import_gone g WHERE (d.relation, d.source, d.source_ref)
    = ($1, $2, g.source_ref) AND g.edited $sql$, model) USING relation, source;
    -- What stands by hand is shown where it differs; what is gone is kept whole, to be brought back.
    EXECUTE format($sql$
INSERT INTO %1$I.open_conflict (relation, row_id, column_name, source, source_ref, by_hand, source_old, stands)
SELECT $1, g.id, '*', $2, g.source_ref, CASE $3 WHEN 'source' THEN g.whole ELSE differing.by_hand END,
    differing.source_old, $3
FROM pg_temp._import_gone g CROSS JOIN LATERAL (
    SELECT jsonb_object_agg(k.name, g.by_hand -> k.name) AS by_hand,
        jsonb_object_agg(k.name, g.said -> k.name)::text AS source_old
    FROM jsonb_object_keys(g.by_hand) k(name) WHERE g.by_hand ->> k.name IS DISTINCT FROM g.said ->> k.name) differing
WHERE g.edited AND g.id IS NOT NULL
ON CONFLICT (relation, row_id, column_name) DO UPDATE SET by_hand = excluded.by_hand, source_new = NULL,
    stands = excluded.stands $sql$, model) USING relation, source, wins;
    DROP TABLE pg_temp._import_gone;
END $$;
COMMENT ON FUNCTION streetgen._drop_vanished(name, name, text, text[]) IS
    'Deletes the rows of a model that no part of the import stands for, all of a source or some source_refs, and '
    'reports them. What was edited by hand is in conflict, and goes only where setting delivery_wins is source.';

CREATE OR REPLACE FUNCTION streetgen._drop_nameless(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN QUERY EXECUTE format($sql$
WITH nameless AS (
    SELECT axis_id, %2$s IS NOT DISTINCT FROM a.source_hash AND (geom::bytea = source_geom::bytea
        OR ST_StartPoint(geom) = ST_StartPoint(source_geom) AND ST_EndPoint(geom) = ST_EndPoint(source_geom)
            AND ST_IsEmpty(ST_Difference(ST_Points(geom), ST_Points(source_geom)))) IS TRUE AS as_delivered
    FROM %1$I.axis a WHERE source = $1 AND source_ref IS NULL AND NOT EXISTS (
        SELECT FROM %1$I.delivered d WHERE d.source = $1 AND d.source_geom::bytea = a.source_geom::bytea)),
gone AS (DELETE FROM %1$I.axis a USING nameless n WHERE a.axis_id = n.axis_id AND n.as_delivered)
SELECT CASE WHEN as_delivered THEN 'of before, without a source_ref, deleted'
    ELSE 'of before, without a source_ref, by hand, kept' END, NULL::text, count(*),
    array_agg('axis ' || axis_id ORDER BY axis_id) FILTER (WHERE NOT as_delivered)
FROM nameless GROUP BY as_delivered $sql$, model, streetgen._source_hash('a', 'axis')) USING source;
END $$;
COMMENT ON FUNCTION streetgen._drop_nameless(name, text) IS
    'Deletes the axes that a source delivered while no source_ref was mapped, but for those edited by hand; reports '
    'both.';

CREATE OR REPLACE FUNCTION streetgen._forget_gone(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
DELETE FROM %1$I.delivered d WHERE d.relation = $1 AND d.source = $2 AND d.gone
    AND NOT EXISTS (SELECT FROM %1$I.%2$I t WHERE t.source = $2 AND t.source_ref = d.source_ref)
    AND NOT EXISTS (SELECT FROM %1$I.open_conflict c WHERE c.relation = $1 AND c.row_id = d.row_id) $sql$, model,
        relation) USING relation, source;
END $$;
COMMENT ON FUNCTION streetgen._forget_gone(name, name, text) IS
    'Forgets what a source said of rows that it deleted and that are gone here too.';
