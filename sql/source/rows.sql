-- Control points and turn restrictions of a source, to those of a model, as axes are merged.

CREATE OR REPLACE FUNCTION streetgen._adopt_rows(model name, relation name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    -- The words of an object are not in its row, their hash is.
    hashed constant boolean := relation = 'street_object';
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE format('CREATE TEMPORARY TABLE _import_unknown ON COMMIT DROP AS SELECT t.source_ref, t.%I AS row_id, '
        't.geom, %s AS there, %s AS hash FROM %I.%I t WHERE t.source = $2 AND t.source_ref IS NOT NULL '
        'AND NOT EXISTS (SELECT FROM %4$I.delivered d WHERE (d.relation, d.source, d.source_ref) '
        '= ($1, $2, t.source_ref))', relation || '_id', CASE WHEN hashed THEN 'NULL::jsonb' ELSE
        streetgen._values_there(model, relation) END, CASE WHEN hashed THEN 't.source_hash' ELSE 'NULL::bigint' END,
        model, relation) USING relation, source;
    INSERT INTO delivered (relation, source, source_ref, row_id, said, source_geom)
        SELECT _adopt_rows.relation, origin, t.source_ref, t.row_id,
            CASE WHEN t.hash = p.hash OR jsonb_strip_nulls(t.there) = jsonb_strip_nulls(p.said)
                THEN jsonb_strip_nulls(p.said) END,
            CASE WHEN t.hash = p.hash OR NOT hashed AND t.geom::bytea = p.source_geom::bytea THEN p.source_geom END
        FROM pg_temp._import_unknown t LEFT JOIN pg_temp._import_said p USING (source_ref);
    DROP TABLE pg_temp._import_unknown;
END $$;
COMMENT ON FUNCTION streetgen._adopt_rows(name, name, text) IS
    'Finds what a source said last of rows of a model of an older build: what it says now, where they are alike.';

CREATE OR REPLACE FUNCTION streetgen._deliver_rows(model name, relation name, source text,
    among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    columns text;
    fresh text[];
    ids bigint[];
    refs text[] COLLATE "default";
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regclass('pg_temp._import_row') IS NULL THEN
        CREATE TEMPORARY VIEW _import_row AS SELECT *, source_geom AS geom FROM pg_temp._import_part;
    END IF;
    columns := (SELECT string_agg(quote_ident(attname), ', ') FROM pg_attribute r JOIN pg_attribute t USING (attname)
        WHERE r.attrelid = 'pg_temp._import_row'::regclass AND t.attrelid = format('%I.%I', model, relation)::regclass
            AND r.attnum > 0 AND t.attnum > 0 AND attname <> 'source');
    EXECUTE 'CREATE TEMPORARY VIEW _import_said AS SELECT p.*, '
        || streetgen._row_json('pg_temp._import_part'::regclass, 'p', streetgen._delivered_columns(relation))
        || ' AS said, ' || CASE relation WHEN 'street_object' THEN 'p.source_hash' ELSE 'NULL::bigint' END
        || ' AS hash FROM pg_temp._import_part p';
    IF relation = 'street_object' THEN
        PERFORM streetgen._adopt_objects(model, source);
    END IF;
    PERFORM streetgen._adopt_rows(model, relation, source);
    -- A function that gives rows, beside others in one list, would have them called again.
    IF relation IN ('footway', 'rail_track') THEN
        RETURN QUERY SELECT * FROM streetgen._drop_vanished(model, relation, source, among);
    ELSE
        PERFORM FROM streetgen._drop_vanished(model, relation, source, among);
    END IF;
    PERFORM streetgen._drop_unchanged(model, relation, source), streetgen._bring_back(model, relation, source),
        streetgen._forget_gone(model, relation, source), streetgen._merge_delivery(model, relation, source);
    RETURN QUERY SELECT CASE relation WHEN 'footway' THEN 'footways' ELSE 'tracks' END || ', new or changed',
        NULL::text, count(*), NULL::text[] FROM pg_temp._import_part
        WHERE relation IN ('footway', 'rail_track') HAVING count(*) > 0;
    fresh := ARRAY(SELECT p.source_ref FROM pg_temp._import_part p WHERE p.source_ref IS NOT NULL AND NOT EXISTS (
        SELECT FROM delivered d WHERE (d.relation, d.source, d.source_ref)
            = (_deliver_rows.relation, origin, p.source_ref)));
    EXECUTE format('WITH written AS (INSERT INTO %1$I.%2$I (%3$s, source) SELECT %3$s, $1 FROM pg_temp._import_row '
        'WHERE source_ref = ANY ($2) ORDER BY source_ref RETURNING %4$I AS row_id, source_ref) '
        'SELECT array_agg(row_id), array_agg(source_ref) FROM written', model, relation, columns, relation || '_id')
        INTO ids, refs USING source, fresh;
    INSERT INTO delivered (relation, source, source_ref, row_id, said, source_geom)
        SELECT _deliver_rows.relation, origin, s.source_ref, w.row_id, jsonb_strip_nulls(s.said),
            s.source_geom
        FROM unnest(ids, refs) w(row_id, source_ref) JOIN pg_temp._import_said s USING (source_ref);
    RETURN QUERY SELECT t.what, relation::text, t.count, t.source_refs
        FROM streetgen._tell_by_hand(model, relation, source) t;
    DROP VIEW pg_temp._import_said;
    IF relation <> 'street_object' THEN
        DROP VIEW pg_temp._import_row;
    END IF;
    DROP TABLE pg_temp._import_part;
END $$;
COMMENT ON FUNCTION streetgen._deliver_rows(name, name, text, text[]) IS
    'Brings the control points, turn restrictions, footways, tracks or objects of a source, or those among some '
    'source_refs, up to date with the rows of the import: what is by hand stays as in axes. Reports that.';

CREATE OR REPLACE FUNCTION streetgen._deliver_if_any(model name, relation name, source text,
    among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF EXISTS (SELECT FROM pg_temp._import_part) OR EXISTS (SELECT FROM delivered d
        WHERE (d.relation, d.source) = (_deliver_if_any.relation, _deliver_if_any.source)) THEN
        RETURN QUERY SELECT * FROM streetgen._deliver_rows(model, relation, source, among);
    ELSE
        DROP TABLE pg_temp._import_part;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._deliver_if_any(name, name, text, text[]) IS
    'As streetgen._deliver_rows where the source has rows now or had some before; else there is nothing to report.';
