-- Drawings of bridges and tunnels, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._bridge_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    -- A deck lies over what is painted on its level, and has its own paint.
    (50, 'bridge', $part$
    SELECT CASE method WHEN 'overpass' THEN 5.5 ELSE 0.5 END + e.level * 10, 'bridge', false, b.surface, b.bridge_id
        FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 3$part$),
    (51, 'bridge,lane', $part$
    SELECT 6.5 + e.level * 10, 'paint', false, ST_CollectionExtract(ST_Intersection(p.surface, b.surface), 3),
        b.bridge_id FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), LATERAL (
            SELECT surface FROM %1$I.lane_separator l WHERE l.edge_id = b.edge_id
            UNION ALL SELECT surface FROM %1$I.marking m WHERE m.edge_id = b.edge_id) p, size
        WHERE b.method = 'overpass' AND pixel < 0.5 AND b.surface && size.box$part$),
    -- The sun stands in the north-west.
    (52, 'bridge', $part$
    SELECT CASE method WHEN 'overpass' THEN 4.5 ELSE -0.5 END + e.level * 10, 'shadow', false,
        ST_Translate(b.surface, 2, -2), b.bridge_id
        FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 3$part$),
    (53, 'bridge', $part$
    SELECT 8.5, 'tunnel', true, ST_Boundary(surface), tunnel_id FROM %1$I.tunnel, size WHERE pixel < 3$part$) $$;
COMMENT ON FUNCTION streetgen._bridge_drawn() IS 'What streetgen.svg draws of bridges and tunnels.';

CREATE OR REPLACE FUNCTION streetgen._bridge_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (23, 'bridge', 'ground', 'bridge', 'bridge'),
    (24, 'tunnel', 'line', 'tunnel', 'tunnel') $$;
COMMENT ON FUNCTION streetgen._bridge_legend() IS 'What the styles of bridges and tunnels mean.';
