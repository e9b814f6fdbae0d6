-- Cars that stand on a side of an axis, of what columns parking_left and parking_right say.

CREATE OR REPLACE FUNCTION streetgen._parking_pattern() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT '^(no|(lane|street_side|half_on_kerb|on_kerb)'
        '(\|(parallel|diagonal|perpendicular)?(\|([1-9](\.\d{1,6})?)?(\|\d{0,4})?)?)?)$' $$;
COMMENT ON FUNCTION streetgen._parking_pattern() IS
    'What columns parking_left and parking_right of axis may hold: of a text that does, all is the first group.';

CREATE OR REPLACE FUNCTION streetgen._parking_depth(said text, settings jsonb) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(nullif(split_part(said, '|', 3), ''), settings ->> ('parking_depth_' || coalesce(nullif(
        split_part(said, '|', 2), ''), 'parallel')))::float8;
COMMENT ON FUNCTION streetgen._parking_depth(text, jsonb) IS
    'How deep the bays are that parking_left or parking_right says, metres; else as settings say of cars that stand '
    'so, along the street where it says nothing.';

-- Not inlined: few axes say that, and each edit plans what the view of axes names.
CREATE OR REPLACE FUNCTION streetgen._with_strips(sidewalk float8, parking text, strips text, settings jsonb)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT behind + CASE WHEN parking LIKE 'street\_side%' AND behind > 0
        THEN streetgen._parking_depth(parking, settings) ELSE 0 END
    FROM (SELECT sidewalk + CASE WHEN strips IS NULL THEN 0 ELSE streetgen._strips_width(strips, settings)
        -- The width of a sidewalk counts the stones of the kerb.
        + CASE sidewalk WHEN 0 THEN (settings ->> 'kerb_stone_width')::float8 ELSE 0 END END AS behind) b $$;
COMMENT ON FUNCTION streetgen._with_strips(float8, text, text, jsonb) IS
    'Width of a sidewalk with the strips and the bays between it and the roadway, metres.';

CREATE OR REPLACE FUNCTION streetgen._bays_stand(subjects text[], of_model text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN 'object' = ANY (subjects)
        THEN format('EXISTS (SELECT FROM %splacement_rule WHERE active AND along = ''lane'')', of_model)
        ELSE 'false' END $$;
COMMENT ON FUNCTION streetgen._bays_stand(text[], text) IS
    'SQL that tells whether a model of these subjects makes bays of what axes say of cars that stand. of_model stands '
    'before the names of tables, with its point.';

CREATE OR REPLACE FUNCTION streetgen._parking_capacity(said text) RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN nullif(split_part(said, '|', 4), '')::bigint;
COMMENT ON FUNCTION streetgen._parking_capacity(text) IS
    'How many cars stand on a side, of what parking_left or parking_right says; NULL: that is not said.';

CREATE OR REPLACE FUNCTION streetgen._parking_beside(on_left text, on_right text, settings jsonb)
    RETURNS TABLE(side text, depth float8, behind float8, orientation text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$
    SELECT side, deep, deep / CASE split_part(said, '|', 1) WHEN 'half_on_kerb' THEN 2 ELSE 1 END,
        coalesce(nullif(split_part(said, '|', 2), ''), CASE WHEN split_part(said, '|', 3) = '' THEN 'parallel' END)
    FROM (VALUES ('left', on_left), ('right', on_right)) v(side, said),
        LATERAL (SELECT streetgen._parking_depth(said, settings) AS deep) d
    WHERE said ~ '^(street_side|half_on_kerb|on_kerb)' $$;
COMMENT ON FUNCTION streetgen._parking_beside(text, text, jsonb) IS
    'The sides of an axis on which cars stand beside the roadway, by its parking_left and parking_right: how deep (m), '
    'how far behind the border of the roadway, and how they lie (NULL: by the depth).';
