-- Tags of lanes that an import did not make lanes of, or not as they are written.

CREATE OR REPLACE FUNCTION streetgen._tell_unread_lanes(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    DELETE FROM unread_tag t WHERE t.source = origin;
    INSERT INTO unread_tag (source, source_ref, tag, value, reason)
        SELECT origin, u.source_ref, u.tag, u.value, u.reason
        FROM pg_temp._import_unread u JOIN axis a ON (a.source, a.source_ref) = (origin, u.source_ref);
    RETURN QUERY SELECT 'lanes not understood, all in table unread_tag', t.tag, count(*),
        array_agg(t.source_ref ORDER BY t.source_ref) FROM unread_tag t WHERE t.source = origin GROUP BY t.tag
        ORDER BY count(*) DESC, t.tag;
END $$;
COMMENT ON FUNCTION streetgen._tell_unread_lanes(name, text) IS
    'Writes the tags of lanes of a source that were not made lanes as they are written into table unread_tag, and '
    'reports them by tag.';
