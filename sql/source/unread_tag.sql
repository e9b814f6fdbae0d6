-- Tags of lanes that an import did not make lanes of, or not as they are written, and misspelt tags.

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

CREATE OR REPLACE FUNCTION streetgen._tell_misspelt(model name, misspelt regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := misspelt::text;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._take_points('_import_misspelt', format('SELECT coalesce(''node '' '
        '|| node_id, ''way '' || way_id, ''relation '' || relation_id) AS source_ref, tag, value, meant FROM %s',
        misspelt));
    DELETE FROM unread_tag t WHERE t.source = origin;
    INSERT INTO unread_tag (source, source_ref, tag, value, reason)
        SELECT origin, m.source_ref, m.tag, m.value, format('it is not known; %s is', m.meant)
        FROM pg_temp._import_misspelt m WHERE m.source_ref IS NOT NULL ON CONFLICT DO NOTHING;
    DROP TABLE pg_temp._import_misspelt;
    RETURN QUERY SELECT 'tag misspelt, all in table unread_tag', format('%s=%s', t.tag, t.value), count(*),
        array_agg(t.source_ref ORDER BY t.source_ref) FROM unread_tag t WHERE t.source = origin GROUP BY t.tag, t.value
        ORDER BY count(*) DESC, t.tag, t.value;
END $$;
COMMENT ON FUNCTION streetgen._tell_misspelt(name, regclass) IS
    'Writes the misspelt tags of an OSM table of such tags into table unread_tag, and reports them. A NULL table, as '
    'older flex files leave, has none.';
