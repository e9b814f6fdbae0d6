-- The settings of rails.

CREATE OR REPLACE FUNCTION streetgen._rail_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('track_width', '2.65', 'm', 'width of the ground that a track takes', 1.5::float8, 4::float8, NULL::text[]),
    ('track_gauge', '1435', 'mm', 'from rail to rail, of a track that states none', 300, 3000, NULL) $$;
COMMENT ON FUNCTION streetgen._rail_setting() IS 'The settings of rails, with their defaults and ranges.';
