-- Rows that a source does not have any more.

CREATE OR REPLACE FUNCTION streetgen._drop_vanished(model name, relation name, source text, among text[] DEFAULT NULL,
    staying text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    wanted constant text[] COLLATE "default" := among;
    kept constant text[] COLLATE "default" := staying;
    gone text[];
    wins constant text := streetgen._delivery_wins(model);
BEGIN
    PERFORM streetgen._use_model(model);
    -- EXCEPT needs no statistics of what was written a moment ago.
    SELECT array_agg(g.source_ref) INTO gone FROM (
        SELECT d.source_ref FROM delivered d WHERE d.relation = _drop_vanished.relation
            AND d.source = origin AND NOT d.gone AND (wanted IS NULL OR d.source_ref = ANY (wanted))
            AND (kept IS NULL OR d.source_ref <> ALL (kept))
        EXCEPT SELECT p.source_ref FROM pg_temp._import_part p) g;
    IF gone IS NULL THEN
        RETURN;
    END IF;
    PERFORM streetgen._find_standing(model, relation, source, gone, true);
    CREATE TEMPORARY TABLE _import_gone ON COMMIT DROP AS
        SELECT t.source_ref, d.row_id AS former, d.said, t.id, t.whole,
            t.said || jsonb_build_object('geom', CASE WHEN moved THEN t.geom::text END) AS by_hand,
            bool_or(t.id IS NOT NULL AND (d.said IS NULL OR jsonb_strip_nulls(t.said) <> d.said OR t.width_by_hand
                OR moved)) OVER (PARTITION BY t.source_ref) AS edited
        FROM pg_temp._import_there t JOIN delivered d ON (d.relation, d.source, d.source_ref)
                = (_drop_vanished.relation, origin, t.source_ref)
            CROSS JOIN LATERAL (SELECT t.geom::bytea IS DISTINCT FROM coalesce(d.cleaned, d.source_geom)::bytea
                AS moved) m;
    DROP TABLE pg_temp._import_there;
    RETURN QUERY EXECUTE format('WITH gone AS (DELETE FROM %I.%I t USING pg_temp._import_gone g WHERE t.%I = g.id '
        'AND (NOT g.edited OR $1 = ''source'') RETURNING coalesce(t.source_ref, g.source_ref) AS source_ref) '
        'SELECT ''vanished from the source, deleted; the first ten'', NULL::text, count(*), '
        '(array_agg(source_ref ORDER BY source_ref))[:10] FROM gone HAVING count(*) > 0', model, relation,
        relation || '_id') USING wins;
    DELETE FROM delivered d USING pg_temp._import_gone g WHERE (d.relation, d.source, d.source_ref)
        = (_drop_vanished.relation, origin, g.source_ref) AND NOT g.edited;
    DELETE FROM open_conflict c USING pg_temp._import_gone g WHERE c.relation = _drop_vanished.relation
        AND (c.row_id = g.id OR c.row_id = g.former) AND (g.id IS NULL OR c.column_name <> '*');
    UPDATE delivered d SET gone = true FROM pg_temp._import_gone g WHERE (d.relation, d.source, d.source_ref)
        = (_drop_vanished.relation, origin, g.source_ref) AND g.edited;
    -- What stands by hand is shown where it differs; what is gone is kept whole, to be brought back.
    INSERT INTO open_conflict (relation, row_id, column_name, source, source_ref, by_hand, source_old, stands)
        SELECT _drop_vanished.relation, g.id, '*', origin, g.source_ref,
            CASE wins WHEN 'source' THEN g.whole ELSE differing.by_hand END, differing.source_old, wins
        FROM pg_temp._import_gone g CROSS JOIN LATERAL (
            SELECT jsonb_object_agg(k.name, g.by_hand -> k.name) AS by_hand,
                jsonb_object_agg(k.name, g.said -> k.name)::text AS source_old
            FROM jsonb_object_keys(g.by_hand) k(name)
            WHERE g.by_hand ->> k.name IS DISTINCT FROM g.said ->> k.name) differing
        WHERE g.edited AND g.id IS NOT NULL
        ON CONFLICT (relation, row_id, column_name) DO UPDATE SET by_hand = excluded.by_hand, source_new = NULL,
            stands = excluded.stands;
    DROP TABLE pg_temp._import_gone;
END $$;
COMMENT ON FUNCTION streetgen._drop_vanished(name, name, text, text[], text[]) IS
    'Deletes the rows of a model that no part of the import stands for, all of a source or some source_refs, but for '
    'those that stay, and reports them. What was edited by hand is in conflict, and goes only where setting '
    'delivery_wins is source.';

CREATE OR REPLACE FUNCTION streetgen._staying_axes(model name, source text) RETURNS text[]
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (WITH there AS (SELECT source_ref FROM delivered d
                WHERE d.relation = 'axis' AND d.source = origin AND NOT d.gone)
        SELECT array_agg(source_ref ORDER BY source_ref) FROM (
            SELECT t.source_ref FROM there t JOIN pg_temp._import_shapeless s ON s.source_ref = t.source_ref
            UNION SELECT t.source_ref FROM there t
                JOIN pg_temp._import_shapeless s ON s.source_ref = substring(t.source_ref FROM '^(.*)/\d+$')) staying);
END $$;
COMMENT ON FUNCTION streetgen._staying_axes(name, text) IS
    'The source_refs of axes whose rows came without a geometry this time: they have not vanished.';

CREATE OR REPLACE FUNCTION streetgen._drop_nameless(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH nameless AS (
        SELECT axis_id, streetgen._axis_hash(a) IS NOT DISTINCT FROM a.source_hash AND (geom::bytea = source_geom::bytea
            OR ST_StartPoint(geom) = ST_StartPoint(source_geom) AND ST_EndPoint(geom) = ST_EndPoint(source_geom)
                AND ST_IsEmpty(ST_Difference(ST_Points(geom), ST_Points(source_geom)))) IS TRUE AS as_delivered
        FROM axis a WHERE source = origin AND source_ref IS NULL AND NOT EXISTS (
            SELECT FROM delivered d WHERE d.source = a.source AND d.source_geom::bytea = a.source_geom::bytea)),
    gone AS (DELETE FROM axis a USING nameless n WHERE a.axis_id = n.axis_id AND n.as_delivered)
    SELECT CASE WHEN as_delivered THEN 'of before, without a source_ref, deleted'
        ELSE 'of before, without a source_ref, by hand, kept' END, NULL::text, count(*),
        array_agg('axis ' || axis_id ORDER BY axis_id) FILTER (WHERE NOT as_delivered)
    FROM nameless GROUP BY as_delivered;
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
    AND NOT EXISTS (SELECT FROM %1$I.open_conflict c WHERE c.relation = $1 AND c.row_id = d.row_id) %3$s $sql$, model,
        relation, CASE relation WHEN 'axis' THEN format('AND NOT EXISTS (SELECT FROM %I.axis t WHERE t.source = $2 '
            'AND t.source_geom::bytea = d.source_geom::bytea AND streetgen._is_piece(t.source_ref, d.source_ref))',
            model) END) USING relation, source;
END $$;
COMMENT ON FUNCTION streetgen._forget_gone(name, name, text) IS
    'Forgets what a source said of rows that it deleted and that are gone here too, with the pieces that were cut off '
    'them.';
