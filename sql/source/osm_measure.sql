-- Widths and speeds of OSM ways: which of their tags says them.

CREATE OR REPLACE FUNCTION streetgen._osm_width(tags jsonb, OUT metres float8, OUT unread boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT (array_agg(m ORDER BY place) FILTER (WHERE m IS NOT NULL))[1], coalesce(bool_or(m IS NULL), false)
    FROM unnest('{width:carriageway,width,est_width}'::text[]) WITH ORDINALITY t(tag, place),
        streetgen._within(streetgen._metres(tags ->> tag), 0, 200) m
    WHERE tags ? tag $$;
COMMENT ON FUNCTION streetgen._osm_width(jsonb) IS
    'The width kerb to kerb that the tags of a way say, metres: width:carriageway before width, est_width last; and '
    'whether one of them means nothing.';

CREATE OR REPLACE FUNCTION streetgen._osm_speed(tags jsonb, OUT kmh float8, OUT unread boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    WITH said AS (
        SELECT place, k AS kmh,
            -- A limit that nobody can name says nothing, as a sign that is no zone in the tags about its reason.
            k IS NULL AND CASE WHEN place < 5 THEN text !~ '^((none|signals|variable)?[;|]?)*$'
                ELSE text ~ '^[A-Z]{2}(-[A-Z]+)?:' END AS unread
        FROM (VALUES ('maxspeed', 1), ('maxspeed:forward', 2), ('maxspeed:backward', 2), ('maxspeed:lanes', 3),
                ('maxspeed:lanes:forward', 3), ('maxspeed:lanes:backward', 3), ('zone:maxspeed', 4),
                ('source:maxspeed', 5), ('maxspeed:type', 5)) t(tag, place),
            LATERAL (SELECT tags ->> tag AS text) s,
            LATERAL streetgen._within(CASE WHEN place < 5 OR text LIKE '%:%' THEN streetgen._kmh(text) END, 0, 400) k
        WHERE tags ? tag),
    best AS (SELECT min(place) FILTER (WHERE s.kmh IS NOT NULL) AS place FROM said s)
    SELECT max(s.kmh) FILTER (WHERE s.place = best.place),
        coalesce(bool_or(s.unread AND (s.place <= best.place) IS NOT FALSE), false)
    FROM said s, best $$;
COMMENT ON FUNCTION streetgen._osm_speed(jsonb) IS
    'The speed that the tags of a way say, km/h, and whether one that goes before means nothing: maxspeed, else the '
    'highest of its directions, else of its lanes, else its zone, else the zone that is the reason of a limit.';

CREATE OR REPLACE FUNCTION streetgen._osm_height_limit(said text, OUT metres float8, OUT unread boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    -- Without a sign whatever is usual in the country passes.
    AS $$
    SELECT m, coalesce(m IS NULL AND said NOT IN ('none', 'default', 'below_default', 'no_sign', 'no_indications',
        'unsigned'), false)
    FROM streetgen._within(streetgen._metres(said), 1, 30) m $$;
COMMENT ON FUNCTION streetgen._osm_height_limit(text) IS
    'The height of vehicles, metres, that tag maxheight lets pass, NULL: no sign; and whether the tag means nothing.';
