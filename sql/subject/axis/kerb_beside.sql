-- The kerbs of an estimated width give way to what is mapped beside a street.

CREATE OR REPLACE FUNCTION streetgen._kerbs_between(width float8, roadway_offset float8, beside float8[])
    RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY[least(width / 2 + middle, beside[1]), least(width / 2 - middle, beside[2])]
        FROM (SELECT streetgen.believed_roadway_offset(roadway_offset, width, width) AS middle) m $$;
COMMENT ON FUNCTION streetgen._kerbs_between(float8, float8, float8[]) IS
    'How far the kerbs on the left and the right of an axis lie from it, metres: as the width and the offset of its '
    'roadway say, and no farther than beside says of each side (NULL: nothing lies there).';

CREATE OR REPLACE FUNCTION streetgen._width_between(kerbs float8[], width float8, narrowest float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN least(width, greatest(narrowest, kerbs[1] + kerbs[2]));
COMMENT ON FUNCTION streetgen._width_between(float8[], float8, float8) IS
    'The width between two kerbs, metres from their axis: at least that of the narrowest lanes, at most that before '
    'the kerbs moved.';
