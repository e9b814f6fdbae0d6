-- The settings of objects.

CREATE OR REPLACE FUNCTION streetgen._object_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 10 SET search_path = pg_catalog
    AS $$ VALUES
    ('placement_function', 'none', NULL::text,
        'a rule of one''s own that places objects: none, or a function (model name, edges bigint[]) returning SETOF '
        'streetgen.placement, with its schema', NULL::float8, NULL::float8, ARRAY['none']),
    ('object_names', 'plain', NULL,
        'how import_objects compares names of streets: plain (alike but for capital letters), unaccent (but for '
        'accents too) or fuzzy (by the similarity of pg_trgm)', NULL, NULL, ARRAY['plain', 'unaccent', 'fuzzy']),
    ('line_sight', '5', 'm', 'rules place no object along a border or a corner so near to a stop or yield line', 0, 30,
        NULL),
    ('bay_roadway_one_way', '3', 'm', 'so much roadway for driving parking bays of rules leave in a one-way street', 0,
        30, NULL),
    ('bay_roadway_both', '5.5', 'm', 'the same in a street of both directions', 0, 30, NULL),
    ('median_tree_width', '3', 'm', 'rules place trees on medians from this width on', 0, 30, NULL),
    ('crossing_marking', 'zebra', NULL, 'how a crossing is painted of which nothing more is known', NULL, NULL,
        ARRAY['zebra', 'ladder', 'lines', 'dashes', 'dots', 'surface', 'no']),
    ('crossing_marking_at_signals', 'zebra', NULL,
        'the same where signals stand at the crossing: such as dashes in Germany, dots in Great Britain, lines in the '
        'United States', NULL, NULL, ARRAY['zebra', 'ladder', 'lines', 'dashes', 'dots', 'surface', 'no']),
    ('refuge_width', '2', 'm', 'so wide is the refuge in the middle of a crossing that has one', 1, 20, NULL),
    ('bus_stop_length', '15', 'm', 'so long is the ground that a bus takes at its stop', 5, 100, NULL),
    ('object_snap', '20', 'm', 'an object that is dropped so near to an axis is placed by it', 0, 200, NULL) $$;
COMMENT ON FUNCTION streetgen._object_setting() IS 'The settings of objects, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._object_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES ('bus_stop_length'), ('object_names'), ('object_snap') $$;
COMMENT ON FUNCTION streetgen._object_setting_beside() IS 'The settings of objects that streets do not depend on.';

CREATE OR REPLACE FUNCTION streetgen._object_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('placement_function', 'name, bigint[]', 'streetgen.placement', true, 'none, or a function (model name, edges '
        'bigint[]) returning SETOF streetgen.placement') $$;
COMMENT ON FUNCTION streetgen._object_setting_function() IS
    'The function of the users that may place objects, as streetgen._setting_function has it.';
