-- The settings of axes.

CREATE OR REPLACE FUNCTION streetgen._axis_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ VALUES
    ('axis_length_maximal', '100000', 'm', 'a longer axis is refused: its coordinates are hardly metres of the model',
        1000, 10000000, NULL::text[]),
    ('max_width_per_lane', '5.5', 'm',
        'a width of a source beyond this per stated lane is not believed, kerb lanes apart; NULL believes all',
        2, 100, NULL),
    ('two_way_width_minimal', '4.5', 'm',
        'a two-way street of unknown lanes with less beside its parking and cycle lanes has one lane that both '
        'directions use; 0: none', 0, 20, NULL),
    ('driving_side', 'auto', NULL,
        'side of the road that one drives on: right, left, or auto: right until the one-way axes of an import say '
        'otherwise', NULL, NULL, ARRAY['auto', 'right', 'left']),
    ('width_default', '6', 'm', 'width of an axis of which nothing is known', 1, 200, NULL),
    ('importance_default', '5', NULL, 'importance of an axis of which nothing is known', 1, 99, NULL),
    ('speed_by_importance', '{"1": 90, "2": 70, "3": 50, "4": 50, "5": 30}', 'km/h',
        'speed by importance; an entry holds up to the next one, the first also before itself', NULL, NULL, NULL),
    ('class_ways_minimal', '10', NULL,
        'learn_classes takes what so many axes of a class state, and more', 1, 1000000, NULL),
    ('speed_per_width', '6', 'km/h per m', 'speed of an axis of unknown importance, from its width', 0, 50, NULL) $$;
COMMENT ON FUNCTION streetgen._axis_setting() IS 'The settings of axes, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._axis_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('class_ways_minimal') $$;
COMMENT ON FUNCTION streetgen._axis_setting_beside() IS 'The settings of axes that streets do not depend on.';

CREATE OR REPLACE FUNCTION streetgen._axis_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('radius_function', 'float8, float8, integer, integer, text', 'float8', false, 'NULL, or an immutable function '
        '(width float8, speed float8, importance integer, lane_count integer, kind text) returning float8') $$;
COMMENT ON FUNCTION streetgen._axis_setting_function() IS
    'The function of the users that a radius may come from, as streetgen._setting_function has it.';
