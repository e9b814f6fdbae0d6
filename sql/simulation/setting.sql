-- The settings of traffic.

CREATE OR REPLACE FUNCTION streetgen._simulation_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('virtual_car', 'moving', NULL, 'who is ahead of a car at the horizon where nobody is nearer: one that is moving '
        'at the speed limit, or one that is stationary', NULL::float8, NULL::float8, '{moving,stationary}'::text[]),
    ('merging_leader', 'none', NULL, 'who counts as a leader of those that come from another path into the same lane: '
        'none, by_place (who has less way to it) or by_time (who is there first)', NULL, NULL,
        '{none,by_place,by_time}') $$;
COMMENT ON FUNCTION streetgen._simulation_setting() IS 'The settings of traffic, with their defaults.';

CREATE OR REPLACE FUNCTION streetgen._simulation_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('virtual_car'), ('merging_leader') $$;
COMMENT ON FUNCTION streetgen._simulation_setting_beside() IS
    'The settings of traffic, on which no street depends.';
