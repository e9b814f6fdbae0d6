-- The settings of cross-sections.

CREATE OR REPLACE FUNCTION streetgen._cross_section_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('gutter_width', '0.3', 'm', 'width of the gutter before a kerb, where lanes leave so much of the roadway', 0, 5,
        NULL::text[]),
    ('furnishing_width', '1', 'm', 'width of the strip behind kerb stones where trees, lamps and signs stand; a '
        'sidewalk that would keep less than ' || streetgen._walking_width() || ' m beside it has none', 0, 20, NULL)
    $$;
COMMENT ON FUNCTION streetgen._cross_section_setting() IS
    'The settings of cross-sections, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._cross_section_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('gutter_width'), ('furnishing_width') $$;
COMMENT ON FUNCTION streetgen._cross_section_setting_beside() IS
    'The settings of cross-sections, on which no street depends.';
