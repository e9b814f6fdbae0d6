-- The settings of heights.

CREATE OR REPLACE FUNCTION streetgen._height_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    ('grade_usual', '{"0": 6, "50": 4, "70": 3.5, "90": 3, "110": 2.5, "130": 2}', '%',
        'grade of a road that is lifted or sunk, by speed in km/h; an entry holds up to the next one; ground that is '
        'steeper over 20 m keeps its grade', NULL::float8, NULL::float8, NULL::text[]),
    ('grade_maximal', '{"0": 12, "50": 8, "70": 7, "90": 6, "110": 5, "130": 4}', '%',
        'greatest grade of a road that is lifted or sunk, where roads pass over each other in turn and the usual one '
        'is too flat, by speed in km/h', NULL, NULL, NULL),
    ('bridge_rise', '0.5', 'm', 'least height of a bridge over the ground, and depth of a tunnel under it, but for its '
        'first and last 10 m; where the source states no heights', 0, 10, NULL),
    ('bridge_level_length', '30', 'm', 'a shorter bridge that crosses no street may stay level with the ground', 0,
        1000, NULL),
    ('plateau', '1', NULL, 'a road stays up between crossings nearer than so many times the way on which it comes down',
        0, 10, NULL),
    ('deck_depth', '1', 'm', 'from the roadway of a road that passes over another one to the underside of its deck: '
        'view underpass', 0, 10, NULL) $$;
COMMENT ON FUNCTION streetgen._height_setting() IS 'The settings of heights, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._height_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('deck_depth') $$;
COMMENT ON FUNCTION streetgen._height_setting_beside() IS 'The setting of heights on which no street depends.';
