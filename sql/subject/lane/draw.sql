-- Drawings of lanes, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._lane_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    -- Paint and paths only where a pixel can show them; the roadway alone where it is wider than a lane.
    (3, 'lane', $part$
    SELECT 4 + e.level * 10, 'paint', false, p.surface, p.lane_separator_id FROM %1$I.lane_separator p
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    (4, 'lane', $part$
    SELECT 4 + e.level * 10, 'paint', false, m.surface, m.marking_id FROM %1$I.marking m
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    -- Lanes between crossed limits join paths.
    (9, 'lane', $part$
    SELECT 895, 'path', true, geom, lane_id FROM %1$I.lane, size WHERE method = 'crossed_limits'
        AND pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._lane_drawn() IS 'What streetgen.svg draws of lanes.';

CREATE OR REPLACE FUNCTION streetgen._lane_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (6, 'paint', 'paint', 'paint', 'paint') $$;
COMMENT ON FUNCTION streetgen._lane_legend() IS 'What the styles of lanes mean.';
