-- The settings of sidewalks.

CREATE OR REPLACE FUNCTION streetgen._walking_width() RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog AS $$ SELECT 1.5::float8 $$;
COMMENT ON FUNCTION streetgen._walking_width() IS
    'Metres of a sidewalk that stay free beside a furnishing strip or a bay: two people pass.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    ('sidewalk_by_importance', '{"1": 3, "2": 3, "3": 2.5, "4": 2, "5": 1.5, "6": 0}', 'm',
        'width of the sidewalks of an axis that says none, by importance; an entry holds up to the next one, the '
        'first also before itself; motorways, their links, runways and taxiways have none', NULL::float8, NULL::float8,
        NULL::text[]),
    ('sidewalk_width_minimal', '0.5', 'm', 'import_sidewalk_widths reports a narrower sidewalk and leaves it out', 0, 5,
        NULL),
    ('sidewalk_width_maximal', '8', 'm', 'import_sidewalk_widths reports a wider sidewalk and leaves it out', 1, 50,
        NULL),
    ('verge_width', '1.5', 'm', 'width of a verge between kerb and sidewalk that says none', 0.1, 20, NULL),
    ('buffer_width', '0.75', 'm', 'the same of a strip between kerb and cycle track', 0.1, 20, NULL),
    ('cycle_track_width', '2', 'm', 'the same of a cycle track for one direction', 0.5, 20, NULL),
    ('two_way_cycle_track_width', '3', 'm', 'the same of one for both directions', 0.5, 20, NULL),
    ('sidewalk_transition', '5', 'm', 'metres of kerb over which the width of sidewalks changes at a corner', 0, 100,
        NULL) $$;
COMMENT ON FUNCTION streetgen._sidewalk_setting() IS 'The settings of sidewalks, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._checked_sidewalk_by_importance(model name, value text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._believed_setting(model, 'sidewalk_by_importance', value,
        streetgen._is_by_importance(value, 50),
        'Expected a JSON object of importance to metres, 0 to 50, such as {"1": 3, "4": 1.5}.') $$;
COMMENT ON FUNCTION streetgen._checked_sidewalk_by_importance(name, text) IS
    'Setting sidewalk_by_importance as a model keeps it; 22023 for another value.';
