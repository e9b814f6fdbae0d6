-- Lengths and speeds of texts as people write them: one reader for all importers.

CREATE OR REPLACE FUNCTION streetgen._metres(said text, unit text DEFAULT 'm') RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_metres';
COMMENT ON FUNCTION streetgen._metres(text, text) IS
    'A length in metres: 7, 3,5 m, 23 ft, 12''6", ~6; 5-6 is the middle; without a unit of its own in this one (m, cm, '
    'ft, us-ft, yd, in). NULL where the text or the unit is no length.';

CREATE OR REPLACE FUNCTION streetgen._kmh(said text, unit text DEFAULT 'km/h') RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_kmh';
COMMENT ON FUNCTION streetgen._kmh(text, text) IS
    'A speed in km/h: 50, 30 mph, 20 knots, walk, FR:urban, DE:zone30; of a list the highest; without a unit of its '
    'own in this one (km/h, mph, kn, m/s). NULL where the text or the unit is no speed.';

CREATE OR REPLACE FUNCTION streetgen._number(said text) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN CASE WHEN said ~* '^\s*[-+]?(\d{1,15}([.,]\d*)?|[.,]\d+)(e[-+]?\d{1,2})?\s*$'
        THEN replace(said, ',', '.')::float8 END;
COMMENT ON FUNCTION streetgen._number(text) IS 'A text as the number that it says; NULL where it says none.';

CREATE OR REPLACE FUNCTION streetgen._within(number float8, low float8, high float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN number BETWEEN low AND high THEN number END;
COMMENT ON FUNCTION streetgen._within(float8, float8, float8) IS 'A number within its bounds, NULL beyond them.';

CREATE OR REPLACE FUNCTION streetgen._metres_by_lane(list text, unit text DEFAULT 'm') RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN bool_and(said ~ '^\s*$' OR coalesce(metres BETWEEN 0 AND 99, false)) AND count(*) <= 40
        THEN string_agg(coalesce(trim_scale(round(metres::numeric, 3))::text, ''), '|' ORDER BY place) END
    FROM regexp_split_to_table(list, '\|') WITH ORDINALITY e(said, place), streetgen._metres(said, unit) metres $$;
COMMENT ON FUNCTION streetgen._metres_by_lane(text, text) IS
    'Widths of lanes, parted by |, in metres: 3,2 m|3.5| is 3.2|3.5|. NULL where one of them is no width up to 99 m.';
