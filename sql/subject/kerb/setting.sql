-- The settings of kerbs.

CREATE OR REPLACE FUNCTION streetgen._kerb_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('kerb_stone_width', '0.3', 'm', 'width of the strip of kerb stones behind a kerb', 0.01, 5, NULL::text[]) $$;
COMMENT ON FUNCTION streetgen._kerb_setting() IS 'The settings of kerbs, with their defaults and ranges.';
