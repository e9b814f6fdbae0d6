-- Points of anybody's layer by a mapping.

CREATE OR REPLACE FUNCTION streetgen._point_query(relation text, targets text[], assumed text[],
    source regclass, mapping jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target text;
    entry jsonb;
    expressions text[] := '{}';
BEGIN
    IF jsonb_typeof(mapping) <> 'object' THEN
        RAISE EXCEPTION 'the mapping is a %, expected an object', jsonb_typeof(mapping) USING ERRCODE = '22023',
            HINT = 'For example {"geom": "the_geom", "kind": "sign", "source_ref": "id"}.';
    END IF;
    FOR target IN SELECT key FROM jsonb_object_keys(mapping) key
        WHERE key <> ALL (targets) LOOP
        RAISE EXCEPTION 'the mapping names "%", which is no column of % to fill', target, relation
            USING ERRCODE = '22023', HINT = regexp_replace(array_to_string(targets, ', '), ', (\w+)$', ' or \1');
    END LOOP;
    FOREACH target IN ARRAY targets LOOP
        entry := coalesce(mapping -> target, CASE WHEN target = ANY (assumed) THEN to_jsonb(target) END);
        IF jsonb_typeof(entry) = 'string' THEN
            expressions := expressions || format('%I%s AS %I', streetgen._source_column(source, entry #>> '{}'),
                CASE target WHEN 'geom' THEN '' ELSE '::text' END, target);
        ELSIF jsonb_typeof(entry) = 'object' AND entry ? 'value' AND target <> 'geom' THEN
            expressions := expressions || format('%L::text AS %I', entry ->> 'value', target);
        ELSIF entry IS NULL OR jsonb_typeof(entry) = 'null' THEN
            expressions := expressions || format('NULL::text AS %I', target);
        ELSE
            RAISE EXCEPTION 'the mapping of "%" is %, expected a column name or {"value": …}', target, entry
                USING ERRCODE = '22023', HINT = 'SQL is never evaluated.';
        END IF;
    END LOOP;
    RETURN format('SELECT %s FROM %s', array_to_string(expressions, ', '), source);
END $$;
COMMENT ON FUNCTION streetgen._point_query(text, text[], text[], regclass, jsonb) IS
    'The points of a source by a checked mapping, as SQL: the targets, columns of a relation, of which those assumed '
    'have columns of their names where the mapping says nothing.';

CREATE OR REPLACE FUNCTION streetgen._take_points(taken name, query text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE %I ON COMMIT DROP AS SELECT *, coalesce(source_ref, ''number '' '
        '|| row_number() OVER ()) AS label FROM (%s) q', taken, query);
END $$;
COMMENT ON FUNCTION streetgen._take_points(name, text) IS
    'Makes a temporary table of the rows of a prepared query, each with a label: its source_ref or its place.';
