-- Drawings of the roadway, and what their styles mean.

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

CREATE OR REPLACE FUNCTION streetgen._surface_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'section', 'ground', 'section of a street', 'roadway'),
    (2, 'intersection', 'ground', 'intersection', NULL),
    (3, 'intersection transition', 'ground', 'change of width', NULL),
    (4, 'section contested', 'ground', 'contested section', NULL),
    (5, 'intersection contested', 'ground', 'contested intersection', NULL),
    (8, 'limit', 'line', 'limit of a section', 'limit of a section'),
    (9, 'arc', 'line', 'corner of the wanted radius', 'corner of the wanted radius'),
    (10, 'arc fallback', 'line', 'corner of another radius', 'corner of another radius') $$;
COMMENT ON FUNCTION streetgen._surface_legend() IS 'What the styles of the roadway mean.';
