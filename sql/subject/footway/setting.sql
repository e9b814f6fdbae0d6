-- The settings of footways.

CREATE OR REPLACE FUNCTION streetgen._footway_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 7 SET search_path = pg_catalog
    AS $$ VALUES
    ('mapped_sidewalk_distance', '12', 'm', 'farthest that a footway lies from the kerb whose sidewalk it is',
        0::float8, 50::float8, NULL::text[]),
    ('mapped_sidewalk_minimal', '2', 'm', 'least width of a sidewalk whose footway states none', 0.5, 20, NULL),
    ('mapped_sidewalk_maximal', '6', 'm',
        'greatest width of a sidewalk whose footway states none; one farther off leads half the least width beyond it',
        1, 50, NULL),
    ('mapped_sidewalk_missing', 'none', NULL,
        'sidewalk of a side that axis.sidewalk_apart names and along which no footway runs: none, or estimated',
        NULL, NULL, '{none,estimated}'),
    ('footway_crossings', 'all', NULL,
        'footways that make pedestrian crossings where they lead over streets: all, mapped (of role crossing), or none',
        NULL, NULL, '{all,mapped,none}'),
    ('walk_join_distance', '3', 'm', 'farthest that the loose end of a footway lies from the walk that it joins', 0, 20,
        NULL),
    ('area_wins', '', NULL,
        'kinds of areas in street_area, parted by commas, that win over what comes before them: roadway moves kerbs '
        'that are not by hand; an empty text: none', NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._footway_setting() IS 'The settings of footways, with their defaults and ranges.';
