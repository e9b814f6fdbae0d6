-- The settings of roads.

CREATE OR REPLACE FUNCTION streetgen._alignment_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('road_friction', '0.7', NULL::text, 'friction of tyres on the road, for the speed limits of bends', 0.05, 2,
        NULL::text[]) $$;
COMMENT ON FUNCTION streetgen._alignment_setting() IS 'The settings of roads, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._alignment_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('road_friction') $$;
COMMENT ON FUNCTION streetgen._alignment_setting_beside() IS 'The settings of roads that streets do not depend on.';
