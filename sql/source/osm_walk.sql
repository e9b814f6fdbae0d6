-- The tags of OpenStreetMap that say how one walks on a way.

CREATE OR REPLACE FUNCTION streetgen._osm_incline(said text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._within(CASE WHEN said ~ '^[-+]?\d+([.,]\d+)?\s*%?$'
            THEN streetgen._number(rtrim(said, '% '))
        WHEN said ~ '^[-+]?\d+([.,]\d+)?\s*°$' AND abs(streetgen._number(rtrim(said, '° '))) < 45
            THEN 100 * tand(streetgen._number(rtrim(said, '° '))) END, -100, 100);
COMMENT ON FUNCTION streetgen._osm_incline(text) IS
    'The incline that tag incline says, percent, up positive: 5, -3.5 %, 10°; NULL: up, down, or no number.';

CREATE OR REPLACE FUNCTION streetgen._osm_climb(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said IN ('up', 'down') THEN said
        ELSE (ARRAY['down', NULL, 'up'])[2 + sign(streetgen._osm_incline(said))::integer] END;
COMMENT ON FUNCTION streetgen._osm_climb(text) IS
    'Whether a way leads up or down, by tag incline; NULL: it is flat, or nothing is said.';

CREATE OR REPLACE FUNCTION streetgen._osm_wheelchair(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE said WHEN 'designated' THEN 'yes' WHEN 'bad' THEN 'limited' WHEN 'impassable' THEN 'no'
        WHEN 'yes' THEN said WHEN 'limited' THEN said WHEN 'no' THEN said END;
COMMENT ON FUNCTION streetgen._osm_wheelchair(text) IS
    'Whether a wheelchair gets along, by tag wheelchair: yes, limited or no; NULL: another word.';

CREATE OR REPLACE FUNCTION streetgen._osm_foot(foot text, access text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE coalesce(foot, nullif(access, 'yes')) WHEN 'yes' THEN 'yes' WHEN 'designated' THEN 'designated'
        WHEN 'official' THEN 'designated' WHEN 'permissive' THEN 'permissive' WHEN 'destination' THEN 'destination'
        WHEN 'customers' THEN 'destination' WHEN 'delivery' THEN 'destination' WHEN 'private' THEN 'private'
        WHEN 'discouraged' THEN 'yes' WHEN 'permit' THEN 'private' WHEN 'residents' THEN 'private'
        WHEN 'no' THEN 'no' WHEN 'use_sidepath' THEN 'no' END;
COMMENT ON FUNCTION streetgen._osm_foot(text, text) IS
    'Who may walk on a way, by tag foot, else by tag access: yes, designated, permissive, destination, private or no; '
    'NULL: nothing is said, or another word.';
