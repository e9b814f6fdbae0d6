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
