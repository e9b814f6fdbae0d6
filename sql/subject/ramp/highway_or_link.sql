-- A class makes an axis a highway or a link at a ramp.

CREATE OR REPLACE FUNCTION streetgen._ramp_part(kind text, highway_role text, speed float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN kind IS NULL THEN 'unclassed'
        WHEN highway_role = 'highway' OR highway_role = 'fast_road' AND coalesce(speed, 60) >= 60 THEN 'highway'
        WHEN highway_role IN ('highway_link', 'link') THEN 'link' END;
COMMENT ON FUNCTION streetgen._ramp_part(text, text, float8) IS
    'What an axis of a class, the role of that class (axis_class.highway_role) and a speed, km/h, is at a ramp: '
    'highway (a fast_road from 60 km/h on or of unknown speed), link, unclassed (NULL); NULL: it takes no part. On a '
    'slower fast_road a link is a turning lane of a junction.';

CREATE OR REPLACE FUNCTION streetgen._may_be_highway(kind text, highway_role text) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN kind IS NULL OR highway_role IN ('highway', 'fast_road');
COMMENT ON FUNCTION streetgen._may_be_highway(text, text) IS
    'May merging lanes lie on an axis of a class with such a role, whatever its speed?';
