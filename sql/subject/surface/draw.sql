-- How the roadway are drawn.

CREATE OR REPLACE FUNCTION streetgen._surface_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'surface', $part$
    SELECT 1 + level * 10, CASE WHEN method IN ('contested', 'crowded') THEN 'section contested' ELSE 'section' END,
        false, surface, edge_id FROM %1$I.section$part$),
    (2, 'surface', $part$
    SELECT 2 + level * 10, CASE WHEN method IN ('contested', 'crowded') THEN 'intersection contested'
        WHEN method = 'transition' THEN 'intersection transition' ELSE 'intersection' END, false, surface, node_id
        FROM %1$I.intersection$part$),
    (6, 'surface', $part$
    SELECT 901, 'limit', true, border_line, section_limit_id FROM %1$I.section_limit, size
        WHERE method = 'hypothesis' AND pixel < 3$part$),
    (7, 'surface', $part$
    SELECT 902, CASE method WHEN 'hypothesis' THEN 'arc' ELSE 'arc fallback' END, true, ST_CurveToLine(arc, 16),
        corner_id FROM %1$I.corner, size WHERE arc IS NOT NULL AND pixel < 3$part$) $$;
COMMENT ON FUNCTION streetgen._surface_drawn() IS 'What streetgen.svg draws of the roadway.';
