-- Rows of a source that share a source_ref.

CREATE OR REPLACE FUNCTION streetgen._refuse_twin(source_ref text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'source_ref % stands in more than one source row', source_ref USING ERRCODE = '22023',
        HINT = 'Map a column that is unique, or leave source_ref out.';
END $$;
COMMENT ON FUNCTION streetgen._refuse_twin(text) IS 'Raises 22023 for a source_ref that two rows of a source have.';

CREATE OR REPLACE FUNCTION streetgen._refuse_twins() RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._refuse_twin(t.source_ref) FROM (SELECT p.source_ref FROM pg_temp._import_part p
        WHERE p.source_ref IS NOT NULL GROUP BY p.source_ref HAVING count(*) > 1 LIMIT 1) t;
END $$;
COMMENT ON FUNCTION streetgen._refuse_twins() IS 'Raises 22023 where two parts of the import have one source_ref.';

CREATE OR REPLACE FUNCTION streetgen._number_twins(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    shared text[];
BEGIN
    PERFORM streetgen._use_model(model);
    shared := ARRAY(SELECT source_ref FROM pg_temp._import_part WHERE source_ref IS NOT NULL GROUP BY source_ref
            HAVING count(*) > 1
        UNION SELECT regexp_replace(d.source_ref, '#\d{1,6}$', '') FROM delivered d
        WHERE d.relation = 'axis' AND d.source = origin AND d.source_ref LIKE '%#%');
    IF shared = '{}' THEN
        RETURN;
    END IF;
    RETURN QUERY WITH once_more AS (
        DELETE FROM pg_temp._import_part p USING (
            SELECT ctid AS id, row_number() OVER (PARTITION BY source_ref, source_geom::bytea ORDER BY ctid) AS nth
            FROM pg_temp._import_part WHERE source_ref = ANY (shared)) t
        WHERE p.ctid = t.id AND t.nth > 1 RETURNING p.source_ref)
    SELECT 'row with the source_ref and the line of another, left out', NULL::text, count(*),
        array_agg(source_ref ORDER BY source_ref) FROM once_more HAVING count(*) > 0;
    -- What is by hand stays with the line that it was decided for, in whatever order the rows come.
    RETURN QUERY WITH twin AS MATERIALIZED (
        SELECT p.ctid AS id, p.source_ref, p.source_geom::bytea AS line FROM pg_temp._import_part p
        WHERE p.source_ref = ANY (shared)),
    former AS (
        SELECT regexp_replace(d.source_ref, '#\d{1,6}$', '') AS source_ref, d.source_geom::bytea AS line,
            coalesce(substring(d.source_ref FROM '#(\d{1,6})$')::integer, 1) AS number
        FROM delivered d WHERE d.relation = 'axis' AND d.source = origin),
    known AS (
        SELECT DISTINCT ON (t.id) t.id, t.source_ref, f.number FROM twin t JOIN former f USING (source_ref, line)
        ORDER BY t.id, f.number),
    new AS (
        SELECT id, source_ref, row_number() OVER (PARTITION BY source_ref ORDER BY id) AS place FROM twin
        WHERE id NOT IN (SELECT id FROM known)),
    free AS (
        SELECT source_ref, number, row_number() OVER (PARTITION BY source_ref ORDER BY number) AS place FROM (
            SELECT source_ref, generate_series(1, count(*)::integer) AS number FROM twin GROUP BY source_ref
            EXCEPT SELECT source_ref, number FROM known) f),
    named AS (
        UPDATE pg_temp._import_part p SET source_ref = n.source_ref || '#' || n.number FROM (
            SELECT id, source_ref, number FROM known
            UNION ALL SELECT id, source_ref, number FROM new JOIN free USING (source_ref, place)) n
        WHERE p.ctid = n.id AND n.number > 1 RETURNING p.source_ref)
    SELECT 'row with a source_ref of several, told apart by a number', NULL::text, count(*),
        array_agg(source_ref ORDER BY source_ref) FROM named HAVING count(*) > 0;
    PERFORM streetgen._refuse_twins();
END $$;
COMMENT ON FUNCTION streetgen._number_twins(name, text) IS
    'Tells parts of the import apart that share a source_ref: the second one of 12 becomes 12#2. A part keeps the '
    'number under which its line was delivered before; of parts that share the line too one stays. Reports both.';
