-- The settings of signals.

CREATE OR REPLACE FUNCTION streetgen._signal_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('signal_program', 'phases', NULL::text,
        'the states of signals: phases (few, with turns that give way), paper (a state for each pair of roads), or a '
        'function (movements streetgen.signal_request[]) returning SETOF streetgen.signal_answer, with its schema',
        NULL::float8, NULL::float8, ARRAY['phases', 'paper']),
    ('signal_cycle', '120', 's', 'longest cycle of signals: where it is too short, walks that leave no room for '
        'others go, then phases of turns, then the least important streets share one and give way', 30, 600, NULL),
    ('signal_all_red', '6', 's', 'longest time in which all have red at signals: where traffic needs more to leave, '
        'who begins lets it out, and check_model says so', 0, 60, NULL),
    ('signal_step', '1', 's', 'each state of signals lasts a number of these', 0.1, 10, NULL),
    ('signal_importance', '5', NULL, 'streets of lower importance (a greater number) have no phase of their own at '
        'signals: they give way to others', 1, 99, NULL) $$;
COMMENT ON FUNCTION streetgen._signal_setting() IS 'The settings of signals, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._signal_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('signal_program', 'streetgen.signal_request[]', 'streetgen.signal_answer', true, 'phases, paper, or a function '
        '(movements streetgen.signal_request[]) returning SETOF streetgen.signal_answer') $$;
COMMENT ON FUNCTION streetgen._signal_setting_function() IS
    'The function of the users that may make programs, as streetgen._setting_function has it.';
