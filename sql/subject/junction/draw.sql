-- Drawings of junctions, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._junction_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (40, 'junction', $part$
    SELECT 3 + i.level * 10, 'junction', false, j.surface, j.junction_id FROM %1$I.junction j
        JOIN %1$I.intersection i ON i.node_id = j.junction_id, size WHERE j.method <> 'hypothesis' AND pixel < 3$part$),
    (41, 'junction', $part$
    SELECT 4 + e.level * 10, 'paint', false, m.surface, m.marking_id FROM %1$I.rim_marking m
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    (42, 'junction', $part$
    SELECT CASE WHEN plausible THEN 895 ELSE 894 END, CASE WHEN plausible THEN 'path' ELSE 'path implausible' END,
        true, geom, interconnections[1] FROM %1$I.movement, size WHERE pixel < 0.5$part$),
    (44, 'junction', $part$
    SELECT 901, 'limit', true, l.border_line, l.section_limit_id FROM %1$I.section_limit l, size
        WHERE l.method = 'hypothesis' AND pixel < 3 AND NOT EXISTS (SELECT FROM %1$I.junction_edge j
            WHERE j.edge_id = l.edge_id)$part$),
    -- Arcs inside a junction are no kerb.
    (43, 'junction', $part$
    SELECT 902, CASE c.method WHEN 'hypothesis' THEN 'arc' ELSE 'arc fallback' END, true, d.geom, c.corner_id
        FROM size, %1$I.corner c LEFT JOIN %1$I.junction_node n USING (node_id)
            LEFT JOIN %1$I.junction j ON j.junction_id = n.junction_id AND j.method <> 'hypothesis'
            CROSS JOIN LATERAL ST_CurveToLine(c.arc, 16) whole CROSS JOIN LATERAL ST_Dump(CASE WHEN j.surface IS NULL
                THEN whole ELSE ST_Intersection(whole, ST_Buffer(ST_Boundary(j.surface), 0.05)) END) d
        WHERE c.arc IS NOT NULL AND pixel < 3 AND (j.surface IS NULL OR ST_Length(d.geom) > 0.5)$part$) $$;
COMMENT ON FUNCTION streetgen._junction_drawn() IS 'What streetgen.svg draws of junctions.';

CREATE OR REPLACE FUNCTION streetgen._junction_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (14, 'junction', 'ground', 'junction of several nodes', 'junction of several nodes') $$;
COMMENT ON FUNCTION streetgen._junction_legend() IS 'What the styles of junctions mean.';

CREATE OR REPLACE FUNCTION streetgen._junction_drawn_instead() RETURNS TABLE(place integer, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES (4, 'junction'), (6, 'junction'), (7, 'junction'), (8, 'junction'), (9, 'junction') $$;
COMMENT ON FUNCTION streetgen._junction_drawn_instead() IS
    'Drawings of others that do not stand where junctions are drawn: limits, corners and paths within them.';
