-- The settings of overpasses.

CREATE OR REPLACE FUNCTION streetgen._overpass_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('clearance', '6', 'm', 'from a roadway up to the one that passes over, its deck included', 0, 100,
        NULL::text[]) $$;
COMMENT ON FUNCTION streetgen._overpass_setting() IS 'The settings of overpasses, with their defaults and ranges.';
