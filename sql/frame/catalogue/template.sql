-- Templates of statements: pieces in files of their own, which name places in braces.

CREATE TABLE streetgen.statement_part (name text PRIMARY KEY, body text NOT NULL);
COMMENT ON TABLE streetgen.statement_part IS
    'Pieces of the one statement, and of the statements that follow it, from files statement.sql of rooms.';
COMMENT ON COLUMN streetgen.statement_part.name IS 'what stands behind --{ above it';
COMMENT ON COLUMN streetgen.statement_part.body IS 'its text; {model} is the schema of the model, {by_key} and others '
    'are what the run fills in';
GRANT SELECT ON streetgen.statement_part TO PUBLIC;

CREATE OR REPLACE FUNCTION streetgen._take_parts(file text) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ INSERT INTO streetgen.statement_part
        SELECT split_part(part, E'\n', 1), E'\n' || rtrim(substr(part, strpos(part, E'\n') + 1), E'\n')
        FROM regexp_split_to_table(file, '^--\{', 'n') WITH ORDINALITY p(part, place) WHERE place > 1 $$;
COMMENT ON FUNCTION streetgen._take_parts(text) IS
    'Takes the pieces of a file into streetgen.statement_part: each begins with a line --{ and its name.';

CREATE OR REPLACE FUNCTION streetgen._part(name text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    body text;
BEGIN
    SELECT p.body INTO STRICT body FROM streetgen.statement_part p WHERE p.name = _part.name;
    RETURN body;
END $$;
COMMENT ON FUNCTION streetgen._part(text) IS 'The piece of a statement of that name; none: P0002.';

CREATE OR REPLACE FUNCTION streetgen._fill_template(template text, places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Between braces, every second piece is a name.
    SELECT string_agg(CASE n % 2 WHEN 1 THEN piece ELSE places ->> piece END, '' ORDER BY n)
    FROM string_to_table(translate(template, '}', '{'), '{') WITH ORDINALITY p(piece, n) $$;
COMMENT ON FUNCTION streetgen._fill_template(text, jsonb) IS 'A text with its places, {name}, filled.';

CREATE OR REPLACE FUNCTION streetgen._part_in(part text, model name, places jsonb DEFAULT '{}') RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._fill_template(streetgen._part(part), jsonb_build_object('srid', m.srid) || places)
    FROM streetgen.model m WHERE m.name = model $$;
COMMENT ON FUNCTION streetgen._part_in(text, name, jsonb) IS
    'The piece of a statement of that name, with the SRID of a model in its place {srid}, and its other places filled.';
