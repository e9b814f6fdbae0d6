-- Bridges and tunnels are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._street_ground(model name, edges bigint[], nodes bigint[])
    RETURNS TABLE(edge_id bigint, node_id bigint, level integer, surface geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT edge_id, NULL::bigint, level, surface::geometry FROM section WHERE edge_id = ANY (edges)
        UNION ALL SELECT NULL, node_id, level, surface FROM intersection WHERE node_id = ANY (nodes);
    IF 'kerb' = ANY (subjects) THEN
        RETURN QUERY SELECT CASE WHEN node_id IS NULL THEN edge_id END, node_id, level, surface::geometry FROM kerb
            WHERE CASE WHEN node_id IS NULL THEN edge_id = ANY (edges) ELSE node_id = ANY (nodes) END
                AND method <> 'level_change';
    END IF;
    IF 'sidewalk' = ANY (subjects) THEN
        RETURN QUERY SELECT CASE WHEN k.node_id IS NULL THEN edge_id END, k.node_id, k.level,
                coalesce(w.strip, w.surface)
            FROM sidewalk w JOIN kerb k USING (edge_id, side, part)
            WHERE CASE WHEN k.node_id IS NULL THEN edge_id = ANY (edges) ELSE k.node_id = ANY (nodes) END;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._street_ground(name, bigint[], bigint[]) IS
    'The ground of streets from wall to wall, of edges and at nodes: roadway, kerb stones and sidewalks, as far as the '
    'model computes them.';

CREATE OR REPLACE FUNCTION streetgen._decks(model name, box geometry)
    RETURNS TABLE(kind text, method text, level integer, id bigint, ground geometry, approach geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT EXISTS (SELECT FROM bridge b WHERE b.surface && box UNION ALL SELECT FROM tunnel t WHERE t.surface && box)
    THEN
        RETURN;
    END IF;
    RETURN QUERY WITH stretch AS MATERIALIZED (
        SELECT kind, s.id, s.method, e.level, edge_id, e.from_node, e.to_node, s.surface FROM (
            SELECT 'bridge' AS kind, bridge_id AS id, b.method, b.edge_id, b.surface::geometry FROM bridge b
                WHERE b.surface && box
            UNION ALL SELECT 'tunnel', tunnel_id, t.method, t.edge_id, t.surface FROM tunnel t WHERE t.surface && box)
            s(kind, id, method, edge_id, surface) JOIN edge e USING (edge_id)),
    end_node AS MATERIALIZED (
        SELECT DISTINCT kind, s.level, CASE s.method WHEN 'overpass' THEN s.id END AS id, node_id
        FROM stretch s, unnest(ARRAY[s.from_node, s.to_node]) node_id),
    neighbour AS MATERIALIZED (
        SELECT n.kind, n.level, n.id, e.edge_id FROM end_node n JOIN edge e ON e.from_node = n.node_id
        UNION SELECT n.kind, n.level, n.id, e.edge_id FROM end_node n JOIN edge e ON e.to_node = n.node_id),
    ground AS MATERIALIZED (
        SELECT g.* FROM streetgen._street_ground(model, ARRAY(SELECT edge_id FROM neighbour),
            ARRAY(SELECT node_id FROM end_node)) g),
    -- Stretches that go on from each other are one deck, also over the nodes between them.
    deck AS (
        SELECT u.kind, 'stated' AS method, u.level, u.id, d.geom AS ground FROM (
            SELECT p.kind, p.level, min(p.id) AS id, ST_Union(p.surface) AS surface FROM (
                SELECT s.kind, s.level, s.id, s.surface FROM stretch s WHERE s.method <> 'overpass'
                UNION ALL SELECT s.kind, s.level, s.id, g.surface FROM stretch s JOIN ground g
                    ON g.edge_id = s.edge_id AND g.level = s.level WHERE s.method <> 'overpass'
                UNION ALL SELECT n.kind, n.level, NULL, g.surface FROM end_node n JOIN ground g
                    ON g.node_id = n.node_id AND g.level = n.level WHERE n.id IS NULL) p
            GROUP BY p.kind, p.level) u, ST_Dump(u.surface) d
        UNION ALL SELECT s.kind, s.method, s.level, s.id, s.surface FROM stretch s WHERE s.method = 'overpass'),
    around AS (
        SELECT n.kind, n.level, n.id, g.level AS ground_level, g.surface FROM end_node n JOIN ground g USING (node_id)
        UNION ALL SELECT n.kind, n.level, n.id, g.level, g.surface FROM neighbour n JOIN ground g USING (edge_id))
    SELECT d.kind, d.method, d.level, d.id, d.ground, CASE d.method
        WHEN 'overpass' THEN (SELECT ST_Difference(ST_Union(a.surface), d.ground) FROM around a
            WHERE (a.kind, a.id) = (d.kind, d.id) AND a.ground_level = d.level)
        ELSE (SELECT ST_Union(a.surface) FROM around a WHERE a.id IS NULL AND (a.kind, a.level) = (d.kind, d.level)
            AND a.ground_level <> d.level AND ST_DWithin(a.surface, d.ground, 0.1)) END
    FROM deck d;
END $$;
COMMENT ON FUNCTION streetgen._decks(name, geometry) IS
    'Bridges and tunnels in a box, each in one piece from wall to wall; approach: the ground of the streets that go on '
    'from its ends, NULL where none does.';

CREATE OR REPLACE FUNCTION streetgen._bridge_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF '{bridge,bridge_shadow,parapet,tunnel,tunnel_wall}' && layers THEN
        RETURN QUERY WITH deck AS MATERIALIZED (SELECT * FROM streetgen._decks(model, box))
            SELECT 'bridge', method, level, ground, id FROM deck WHERE kind = 'bridge' AND 'bridge' = ANY (layers)
            -- The ground rises to the ends of a deck.
            UNION ALL SELECT 'bridge_shadow', method, level, coalesce(ST_Difference(ground, ST_Buffer(approach, 4, 2)),
                ground), id FROM deck WHERE kind = 'bridge' AND 'bridge_shadow' = ANY (layers)
            UNION ALL SELECT 'parapet', method, level, ST_Buffer(coalesce(ST_Difference(ST_Boundary(ground),
                ST_Buffer(approach, 0.3, 2)), ST_Boundary(ground)), 0.25, 'endcap=flat join=mitre'), id FROM deck
                WHERE kind = 'bridge' AND 'parapet' = ANY (layers)
            UNION ALL SELECT 'tunnel', '', level, ground, id FROM deck WHERE kind = 'tunnel'
                AND 'tunnel' = ANY (layers)
            -- The ground, whose blocks and buildings it lies over, may have another level than 0.
            UNION ALL SELECT 'tunnel_wall', '', greatest(level, (SELECT value::integer FROM setting
                WHERE name = 'ground_level')), ground, id FROM deck WHERE kind = 'tunnel'
                AND 'tunnel_wall' = ANY (layers);
    END IF;
    -- A deck that passes over its own level lies over what is painted there, and has its own paint.
    IF 'deck_paint' = ANY (layers) AND 'lane' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'deck_paint', '', level,
                ST_CollectionExtract(ST_Intersection(p.surface, b.surface), 3), bridge_id
            FROM bridge b JOIN edge e USING (edge_id), LATERAL (
                SELECT surface FROM lane_separator l WHERE l.edge_id = b.edge_id
                UNION ALL SELECT surface FROM marking m WHERE m.edge_id = b.edge_id) p
            WHERE b.method = 'overpass' AND b.surface && box;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._bridge_drawn(name, geometry, text[]) IS
    'What can be drawn of bridges and tunnels in a box: bridge, bridge_shadow, what casts it, and parapet, by method; '
    'deck_paint of an overpass; tunnel, its ground, and tunnel_wall.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'bridge_shadow', 5000, -0.5, '#0000004d', 2, 'metre', 'shadow'),
    ('dark', 'bridge_shadow', 5000, -0.5, '#00000099', 2, 'metre', 'shadow'),
    ('construction', 'bridge_shadow', 11000, -0.5, '#1118274d', 2, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker)
    SELECT theme, layer, 'overpass', to_scale, 4.5, fill, width, unit, marker FROM streetgen.symbol_rule
    WHERE layer = 'bridge_shadow';
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('street', 'bridge', 5000, -0.4, '#73777f'),
    ('dark', 'bridge', 5000, -0.4, '#454b54'),
    ('construction', 'bridge', 11000, -0.4, '#b4bac3');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill)
    SELECT theme, layer, 'overpass', to_scale, 5.5, fill FROM streetgen.symbol_rule WHERE layer = 'bridge';
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'parapet', 5000, 6.6, '#4f545c', '#4f545c', 0.3, 'pixel', 'bridge'),
    ('dark', 'parapet', 5000, 6.6, '#9aa0a9', '#9aa0a9', 0.3, 'pixel', 'bridge'),
    ('construction', 'parapet', 11000, 6.6, '#374151', '#374151', 0.6, 'pixel', 'bridge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('street', 'deck_paint', 1500, 6.5, '#fbfbf8'),
    ('dark', 'deck_paint', 1500, 6.5, '#dfe2e6'),
    ('construction', 'deck_paint', 2000, 6.5, '#ffffff');
-- Tunnels are pale, paint and all.
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'tunnel', 15000, 8.9, '#f1ebdfcc', '#f1ebdfcc', 0.5, 'metre'),
    ('dark', 'tunnel', 15000, 8.9, '#0f1216b3', '#0f1216b3', 0.5, 'metre'),
    ('construction', 'tunnel', 11000, 8.9, '#f3f1eab3', '#f3f1eab3', 0.5, 'metre');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, dash, meaning) VALUES
    ('street', 'tunnel_wall', 15000, 8.5, '#4f545c', 1, 'pixel', '5', 'tunnel'),
    ('dark', 'tunnel_wall', 15000, 8.5, '#9aa0a9', 1, 'pixel', '5', 'tunnel'),
    ('construction', 'tunnel_wall', 11000, 8.5, '#374151', 1, 'pixel', '5', 'tunnel');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill) VALUES
    ('print', 'bridge', '', 5000, -0.4, '#ffffff'), ('print', 'bridge', 'overpass', 5000, 5.5, '#ffffff'),
    ('print', 'tunnel', '', 15000, 8.9, '#ffffff');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'parapet', 5000, 6.6, '#000000', '#000000', 0.5, 'pixel', 'bridge'),
    ('print', 'deck_paint', 1500, 6.5, '#000000', '#000000', 0.5, 'pixel', NULL);
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, dash, meaning) VALUES
    ('print', 'tunnel_wall', 15000, 8.5, '#000000', 0.8, 'pixel', '5', 'tunnel');
