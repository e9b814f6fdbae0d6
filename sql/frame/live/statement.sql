-- Pieces of functions that follow edits, by name: streetgen._part gives each.

--{follow_axes
BEGIN
    -- Most updates change no line.
    IF EXISTS ({changed}) THEN
    {calls}
    END IF;
    RETURN NULL;
END

--{follower_call
        PERFORM {follower}(array_agg(axis_id ORDER BY axis_id), array_agg(was ORDER BY axis_id),
            array_agg(now ORDER BY axis_id)) FROM ({changed}) c
        WHERE EXISTS (SELECT FROM {relation}) HAVING count(*) > 0;
