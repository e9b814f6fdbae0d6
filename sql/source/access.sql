-- Who may drive: words of sources as those of axis.access.

CREATE OR REPLACE FUNCTION streetgen._access_word(said text) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_access_word';
COMMENT ON FUNCTION streetgen._access_word(text) IS
    'The word of axis.access that a word of a source means; empty: all may drive; ?: it means nothing; NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._read_access(said text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN cardinality(words) > 2 OR '?' = ANY (words) THEN '?'
        WHEN words[1] = coalesce(words[2], words[1]) THEN nullif(words[1], '') ELSE words[1] || '|' || words[2] END
    FROM (SELECT ARRAY(SELECT streetgen._access_word(word) FROM regexp_split_to_table(said, '\|') WITH ORDINALITY
        w(word, i) ORDER BY i) AS words) w $$;
COMMENT ON FUNCTION streetgen._read_access(text) IS
    'What a source says of who may drive, a word or two parted by |, as axis.access has it; ? where it means nothing.';
