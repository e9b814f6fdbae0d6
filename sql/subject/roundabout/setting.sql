-- The settings of roundabouts.

CREATE OR REPLACE FUNCTION streetgen._roundabout_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$ VALUES
    ('roundabout_radius_least', '3', 'm', 'a ring of a smaller radius is no roundabout, unless a source says so',
        0.5, 100, NULL::text[]),
    ('roundabout_radius_greatest', '60', 'm',
        'nor is a ring with a larger smallest circle about it; an edit looks as far as twice this', 1, 200, NULL),
    ('roundabout_shape_least', '0.5', NULL,
        'nor is one with a smaller share of the area of the circle of its length, unless a source says so', 0, 1, NULL),
    ('roundabout_weight_shape', '0.5', NULL, 'weight of the shape in the score of a ring', 0, 100, NULL),
    ('roundabout_weight_name', '0.1', NULL, 'weight of the names in the score of a ring', 0, 100, NULL),
    ('roundabout_weight_network', '0.4', NULL, 'weight of the network in the score of a ring', 0, 100, NULL),
    ('roundabout_accept', '0.66', NULL, 'a ring with this score and more is a roundabout', 0, 1, NULL),
    ('roundabout_score', 'streetgen.roundabout_score', NULL,
        'score of a ring: a function (shape float8, name float8, network float8, weights float8[]) returning float8, '
        'with its schema', NULL, NULL, NULL),
    ('roundabout_names', 'plain', NULL,
        'how names are compared with roundabout_pattern: plain, unaccent (without accents) or fuzzy (words nearly '
        'alike too)', NULL, NULL, ARRAY['plain', 'unaccent', 'fuzzy']),
    ('roundabout_tags', 'true', NULL,
        'does the word of a source count that an axis is part of a roundabout, with the direction that it implies: '
        'true or false', NULL, NULL, ARRAY['true', 'false']),
    ('roundabout_widening', '2.5', 'm', 'how much wider than its lanes a ring is that make_roundabout makes', 0, 20,
        NULL),
    ('roundabout_untagged', 'auto', NULL,
        'what becomes of a ring that no source names, where roundabout_tags is true: scored (its score decides), '
        'offered (it is a roundabout only where somebody confirms it), or auto: scored, until an import names rings '
        'and sets offered', NULL, NULL, ARRAY['auto', 'scored', 'offered']) $$;
COMMENT ON FUNCTION streetgen._roundabout_setting() IS 'The settings of roundabouts, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_setting_function()
    RETURNS TABLE(setting text, arguments text, result text, many boolean, expected text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('roundabout_score', 'float8, float8, float8, float8[]', 'float8', false, 'streetgen.roundabout_score, or a '
        'function (shape float8, name float8, network float8, weights float8[]) returning float8') $$;
COMMENT ON FUNCTION streetgen._roundabout_setting_function() IS
    'The function of the users that a score may come from, as streetgen._setting_function has it.';
