-- The settings of junctions.

CREATE OR REPLACE FUNCTION streetgen._junction_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('junction_gap', '35', 'm', 'longest edge that makes one junction of the two carriageways which it links', 0, 200,
        NULL::text[]),
    ('walking_speed', '1.2', 'm/s', 'people on foot cross streets at junctions so fast', 0.3, 3, NULL),
    ('walk_shortest', '4', 's', 'people on foot who wait at signals step on within this time', 1, 60, NULL),
    ('junction_extent', '80', 'm', 'a junction by such links and slip lanes is no wider', 0, 500, NULL),
    ('classifier', 'streetgen.junction_kind', NULL,
        'the kind of a junction from its arms: streetgen.junction_kind, paper (a ramp where a highway takes part, else '
        'signals), or a function (arms streetgen.junction_arm[]) returning text, with its schema', NULL, NULL,
        ARRAY['streetgen.junction_kind', 'paper']) $$;
COMMENT ON FUNCTION streetgen._junction_setting() IS 'The settings of junctions, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._junction_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('classifier', 'streetgen.junction_arm[]', 'text', false, 'streetgen.junction_kind, paper, or a function (arms '
        'streetgen.junction_arm[]) returning text') $$;
COMMENT ON FUNCTION streetgen._junction_setting_function() IS
    'The function of the users that may tell kinds, as streetgen._setting_function has it.';
