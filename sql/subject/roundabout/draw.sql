-- Drawings of roundabouts, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._roundabout_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (45, 'roundabout', $part$
    SELECT 904, CASE WHEN accepted THEN 'ring' ELSE 'ring refused' END, true, ST_Collect(geom, ST_SetSRID(ST_MakeLine(
        ST_MakePoint(ST_X(centre) - radius * score / 2, ST_Y(centre)),
        ST_MakePoint(ST_X(centre) + radius * score / 2, ST_Y(centre))), ST_SRID(geom))), roundabout_id
        FROM %1$I.roundabout, size WHERE pixel < 3$part$) $$;
COMMENT ON FUNCTION streetgen._roundabout_drawn() IS 'What streetgen.svg draws of roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (21, 'ring', 'line', 'roundabout, bar: its score', 'roundabout, bar: its score'),
    (22, 'ring refused', 'line', 'ring that is none', 'ring that is none') $$;
COMMENT ON FUNCTION streetgen._roundabout_legend() IS 'What the styles of roundabouts mean.';
