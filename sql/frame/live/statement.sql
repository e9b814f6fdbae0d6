-- Pieces of functions that follow edits, by name: streetgen._part gives each.

--{follow_axes
DECLARE
    axes bigint[];
    lines_before geometry[];
    lines_after geometry[];
BEGIN
    -- Most models have nothing that follows, and most updates change no line.
    IF {filled} THEN
        SELECT array_agg(axis_id ORDER BY axis_id), array_agg(was ORDER BY axis_id), array_agg(now ORDER BY axis_id)
            FROM ({changed}) c INTO axes, lines_before, lines_after;
        IF axes IS NOT NULL THEN
    {calls}
        END IF;
    END IF;
    RETURN NULL;
END

--{follower_call
            IF EXISTS (SELECT FROM {relation}) THEN
                PERFORM {follower}(axes, lines_before, lines_after);
            END IF;
