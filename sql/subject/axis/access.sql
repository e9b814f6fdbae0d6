-- Who may drive along an axis.

CREATE OR REPLACE FUNCTION streetgen._access_of_way(access text, along boolean) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN CASE WHEN strpos(access, '|') = 0 THEN access
        ELSE nullif(split_part(access, '|', CASE WHEN along THEN 1 ELSE 2 END), '') END;
COMMENT ON FUNCTION streetgen._access_of_way(text, boolean) IS
    'Who may drive along an axis, or against it, of what axis.access says of both; NULL: all.';
