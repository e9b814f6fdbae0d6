-- The settings of heights.

CREATE OR REPLACE FUNCTION streetgen._height_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('grade_maximal', '{"0": 12, "50": 8, "70": 7, "90": 6, "110": 5, "130": 4}', '%',
        'greatest grade of a road that is lifted or sunk, by speed in km/h; an entry holds up to the next one; ground '
        'that is steeper over 20 m keeps its grade', NULL::float8, NULL::float8, NULL::text[]) $$;
COMMENT ON FUNCTION streetgen._height_setting() IS 'The settings of heights, with their defaults and ranges.';
