-- The settings of signals.

CREATE OR REPLACE FUNCTION streetgen._signal_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('signal_program', 'phases', NULL::text,
        'the states of signals: phases (few, with turns that give way), paper (a state for each pair of roads), or a '
        'function (movements streetgen.signal_request[]) returning SETOF streetgen.signal_answer, with its schema',
        NULL::float8, NULL::float8, ARRAY['phases', 'paper']) $$;
COMMENT ON FUNCTION streetgen._signal_setting() IS 'The settings of signals, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._signal_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('signal_program', 'streetgen.signal_request[]', 'streetgen.signal_answer', true, 'phases, paper, or a function '
        '(movements streetgen.signal_request[]) returning SETOF streetgen.signal_answer') $$;
COMMENT ON FUNCTION streetgen._signal_setting_function() IS
    'The function of the users that may make programs, as streetgen._setting_function has it.';
