-- Control points and turn restrictions of a source, to those of a model, as axes are merged.

CREATE OR REPLACE FUNCTION streetgen._adopt_rows(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
INSERT INTO %1$I.delivered (relation, source, source_ref, row_id, said, source_geom)
SELECT %2$L, $1, d.source_ref, d.%3$I, CASE WHEN %4$s THEN jsonb_strip_nulls(p.said) END,
    CASE WHEN %5$s THEN p.source_geom END
FROM %1$I.%2$I d LEFT JOIN pg_temp._import_said p USING (source_ref) CROSS JOIN LATERAL (SELECT d.*) t
WHERE d.source = $1 AND d.source_ref IS NOT NULL AND NOT EXISTS (SELECT FROM %1$I.delivered k
    WHERE (k.relation, k.source, k.source_ref) = (%2$L, $1, d.source_ref)) $sql$, model, relation, relation || '_id',
        CASE relation WHEN 'street_object' THEN 'd.source_hash = p.source_hash' ELSE format(
            'jsonb_strip_nulls(%s) = jsonb_strip_nulls(p.said)', streetgen._values_there(model, relation)) END,
        CASE relation WHEN 'street_object' THEN 'd.source_hash = p.source_hash'
            ELSE 'd.geom::bytea = p.source_geom::bytea' END) USING source;
END $$;
COMMENT ON FUNCTION streetgen._adopt_rows(name, name, text) IS
    'Finds what a source said last of rows of a model of an older build: what it says now, where they are alike.';

CREATE OR REPLACE FUNCTION streetgen._deliver_rows(model name, relation name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns text;
BEGIN
    IF to_regclass('pg_temp._import_row') IS NULL THEN
        CREATE TEMPORARY VIEW _import_row AS SELECT *, source_geom AS geom FROM pg_temp._import_part;
    END IF;
    columns := (SELECT string_agg(quote_ident(attname), ', ') FROM pg_attribute r JOIN pg_attribute t USING (attname)
        WHERE r.attrelid = 'pg_temp._import_row'::regclass AND t.attrelid = format('%I.%I', model, relation)::regclass
            AND r.attnum > 0 AND t.attnum > 0 AND attname <> 'source');
    EXECUTE 'CREATE TEMPORARY VIEW _import_said AS SELECT p.*, '
        || streetgen._row_json('pg_temp._import_part'::regclass, 'p', streetgen._delivered_columns(relation))
        || ' AS said FROM pg_temp._import_part p';
    IF relation = 'street_object' THEN
        PERFORM streetgen._adopt_objects(model, source);
    END IF;
    PERFORM streetgen._adopt_rows(model, relation, source), streetgen._drop_vanished(model, relation, source),
        streetgen._drop_unchanged(model, relation, source), streetgen._bring_back(model, relation, source),
        streetgen._forget_gone(model, relation, source), streetgen._merge_delivery(model, relation, source);
    EXECUTE format($sql$
WITH written AS (
INSERT INTO %1$I.%2$I (%3$s, source) SELECT %3$s, $1 FROM pg_temp._import_row p
WHERE p.source_ref IS NOT NULL AND NOT EXISTS (SELECT FROM %1$I.delivered d
    WHERE (d.relation, d.source, d.source_ref) = (%2$L, $1, p.source_ref))
ORDER BY p.source_ref RETURNING %4$I AS row_id, source_ref)
INSERT INTO %1$I.delivered (relation, source, source_ref, row_id, said, source_geom)
SELECT %2$L, $1, s.source_ref, w.row_id, jsonb_strip_nulls(s.said), s.source_geom
FROM written w JOIN pg_temp._import_said s USING (source_ref) $sql$, model, relation, columns, relation || '_id')
        USING source;
    RETURN QUERY SELECT t.what, relation::text, t.count, t.source_refs
        FROM streetgen._tell_by_hand(model, relation, source) t;
    DROP VIEW pg_temp._import_said;
    IF relation <> 'street_object' THEN
        DROP VIEW pg_temp._import_row;
    END IF;
    DROP TABLE pg_temp._import_part;
END $$;
COMMENT ON FUNCTION streetgen._deliver_rows(name, name, text) IS
    'Brings the control points, turn restrictions or objects of a source up to date with the rows of the import: what '
    'is by hand stays as in axes. Reports that.';
