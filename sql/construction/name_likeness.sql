-- Likeness of two names: by their letters, without accents, or by trigrams.

CREATE OR REPLACE FUNCTION streetgen._without_accents(given text, setting text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    folded text;
BEGIN
    EXECUTE format('SELECT %I.unaccent($1)', streetgen._require_extension('unaccent', setting)) INTO folded USING given;
    RETURN folded;
END $$;
COMMENT ON FUNCTION streetgen._without_accents(text, text) IS
    'A text without accents, by the extension that a setting asks for: 0A000 where it is missing.';

CREATE OR REPLACE FUNCTION streetgen._trigrams_alike(measure name, given text, other text, setting text) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    alike float8;
BEGIN
    EXECUTE format('SELECT %I.%I($1, $2)', streetgen._require_extension('pg_trgm', setting), measure) INTO alike
        USING given, other;
    RETURN alike;
END $$;
COMMENT ON FUNCTION streetgen._trigrams_alike(name, text, text, text) IS
    'How alike two texts are, 0 to 1, by a measure of pg_trgm (similarity, word_similarity), which a setting asks for: '
    '0A000 where the extension is missing.';

CREATE OR REPLACE FUNCTION streetgen._name_likeness(given text, other text, folding text, setting text) RETURNS float8
    LANGUAGE sql STABLE PARALLEL SAFE
    RETURN CASE folding WHEN 'plain' THEN (lower(given) = lower(other))::integer
        WHEN 'unaccent' THEN (lower(streetgen._without_accents(given, setting))
            = lower(streetgen._without_accents(other, setting)))::integer
        ELSE streetgen._trigrams_alike('similarity', given, other, setting) END;
COMMENT ON FUNCTION streetgen._name_likeness(text, text, text, text) IS
    'How alike two names are, 0 to 1. folding: plain and unaccent give 1 where they are equal but for capital letters, '
    'or for accents too; fuzzy gives the similarity of pg_trgm. The setting is for messages: an extension that folding '
    'needs and that is missing: 0A000. NULL for a name that is NULL.';
