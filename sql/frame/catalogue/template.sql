-- Templates of statements.

CREATE OR REPLACE FUNCTION streetgen._fill_template(template text, places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Between braces, every second piece is a name.
    SELECT string_agg(CASE n % 2 WHEN 1 THEN piece ELSE places ->> piece END, '' ORDER BY n)
    FROM string_to_table(translate(template, '}', '{'), '{') WITH ORDINALITY p(piece, n) $$;
COMMENT ON FUNCTION streetgen._fill_template(text, jsonb) IS 'A text with its places, {name}, filled.';
