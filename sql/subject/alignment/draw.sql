-- Drawings of roads, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._alignment_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (11, 'alignment', $part$
    SELECT 904, 'road', true, geom, road_id FROM %1$I.road, size WHERE pixel < 3$part$),
    -- As figure 6b of Wilkie, Sewall and Lin: from the ends of an arc to its centre.
    (12, 'alignment', $part$
    SELECT 905, 'road radius', true, ST_MakeLine(ARRAY[ST_StartPoint(arc), centre, ST_EndPoint(arc)]), road_arc_id
        FROM %1$I.road_arc, size WHERE pixel < 0.5 AND radius < 100$part$) $$;
COMMENT ON FUNCTION streetgen._alignment_drawn() IS 'What streetgen.svg draws of roads.';

CREATE OR REPLACE FUNCTION streetgen._alignment_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (15, 'road', 'line', 'road', 'road'),
    (16, 'road radius', 'line', 'radius of a bend', 'radius of a bend') $$;
COMMENT ON FUNCTION streetgen._alignment_legend() IS 'What the styles of roads mean.';
