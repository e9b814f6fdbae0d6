-- Drawings of interconnections, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._interconnection_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (8, 'interconnection', $part$
    SELECT CASE WHEN plausible THEN 895 ELSE 894 END, CASE WHEN plausible THEN 'path'
        ELSE 'path implausible' END, true, geom, interconnection_id FROM %1$I.interconnection, size
        WHERE pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._interconnection_drawn() IS 'What streetgen.svg draws of interconnections.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (11, 'path', 'line', 'path from lane to lane', 'path from lane to lane'),
    (12, 'path implausible', 'line', 'path that is not plausible', 'path that is not plausible') $$;
COMMENT ON FUNCTION streetgen._interconnection_legend() IS 'What the styles of interconnections mean.';
