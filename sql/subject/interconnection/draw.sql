-- How interconnections are drawn.

CREATE OR REPLACE FUNCTION streetgen._interconnection_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (8, 'interconnection', $part$
    SELECT CASE WHEN plausible THEN 895 ELSE 894 END, CASE WHEN plausible THEN 'path'
        ELSE 'path implausible' END, true, geom, interconnection_id FROM %1$I.interconnection, size
        WHERE pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._interconnection_drawn() IS 'What streetgen.svg draws of interconnections.';
