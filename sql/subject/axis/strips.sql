-- Strips between the kerb and the sidewalk of a side, of what columns strips_left and strips_right of axis say.

CREATE OR REPLACE FUNCTION streetgen._strips_pattern() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT '^((verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?'
        '(\|(verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?){0,4})$' $$;
COMMENT ON FUNCTION streetgen._strips_pattern() IS
    'What columns strips_left and strips_right of axis may hold: of a text that does, all is the first group.';

CREATE OR REPLACE FUNCTION streetgen._side_strips(said text, settings jsonb)
    RETURNS TABLE("order" integer, kind text, near float8, far float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$
    SELECT n::integer, replace(word, 'two_way_', ''), sum(width) OVER (ORDER BY n) - width,
        sum(width) OVER (ORDER BY n)
    FROM string_to_table(said, '|') WITH ORDINALITY s(strip, n), split_part(strip, ' ', 1) word,
        LATERAL (SELECT coalesce(nullif(split_part(strip, ' ', 2), ''), settings ->> (word || '_width'))::float8
            AS width) w $$;
COMMENT ON FUNCTION streetgen._side_strips(text, jsonb) IS
    'The strips that strips_left or strips_right says, from the kerb outwards: number, kind (verge, buffer or '
    'cycle_track), and where each begins and ends, metres from the first. One without a width is as wide as settings '
    'say.';

CREATE OR REPLACE FUNCTION streetgen._strips_width(said text, settings jsonb) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT coalesce(max(far), 0) FROM streetgen._side_strips(said, settings) $$;
COMMENT ON FUNCTION streetgen._strips_width(text, jsonb) IS
    'How wide the strips are together that strips_left or strips_right says, metres.';

CREATE OR REPLACE FUNCTION streetgen._behind_strips(kerb_offset float8, parking text, said text, settings jsonb)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- A verge is where things stand beside a street.
    SELECT CASE WHEN kerb_offset <= 0 THEN kerb_offset
        ELSE bay + coalesce((SELECT (near + far) / 2 FROM streetgen._side_strips(said, settings) WHERE kind = 'verge'
                ORDER BY near LIMIT 1), kerb_offset + streetgen._strips_width(said, settings)) END
    FROM (SELECT CASE WHEN parking LIKE 'street\_side%' THEN streetgen._parking_depth(parking, settings) ELSE 0 END
        AS bay) b $$;
COMMENT ON FUNCTION streetgen._behind_strips(float8, text, text, jsonb) IS
    'Where a thing stands that a rule puts so many metres behind a kerb, with the bays (parking_left or parking_right; '
    'NULL: no bays are made) and strips of that side: in the middle of the first verge, else so far behind both.';

-- Inlined: the network on foot asks for each kerb, and few axes say strips.
CREATE OR REPLACE FUNCTION streetgen._walk_width(sidewalk float8, said text, settings jsonb) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said IS NULL OR sidewalk IS NULL THEN sidewalk
        -- The stones of the kerb alone are no way.
        WHEN sidewalk - streetgen._strips_width(said, settings) <= (settings ->> 'kerb_stone_width')::float8 + 1e-6
            THEN 0 ELSE sidewalk - streetgen._strips_width(said, settings) END;
COMMENT ON FUNCTION streetgen._walk_width(float8, text, jsonb) IS
    'What strips_left or strips_right leaves of the width of a sidewalk from the kerb for people to walk on, metres.';
