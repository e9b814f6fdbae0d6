-- Bridges and tunnels are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._bridge_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'bridge', b.method, level, b.surface::geometry, bridge_id FROM bridge b
        JOIN edge USING (edge_id) WHERE 'bridge' = ANY (layers) AND b.surface && box;
    -- A deck that passes over its own level lies over what is painted there, and has its own paint.
    IF 'deck_paint' = ANY (layers) AND 'lane' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'deck_paint', '', level,
                ST_CollectionExtract(ST_Intersection(p.surface, b.surface), 3), bridge_id
            FROM bridge b JOIN edge e USING (edge_id), LATERAL (
                SELECT surface FROM lane_separator l WHERE l.edge_id = b.edge_id
                UNION ALL SELECT surface FROM marking m WHERE m.edge_id = b.edge_id) p
            WHERE b.method = 'overpass' AND b.surface && box;
    END IF;
    RETURN QUERY SELECT 'tunnel', '', 0, ST_Boundary(surface), tunnel_id FROM tunnel
        WHERE 'tunnel' = ANY (layers) AND surface && box;
END $$;
COMMENT ON FUNCTION streetgen._bridge_drawn(name, geometry, text[]) IS
    'What can be drawn of bridges and tunnels in a box: bridge, by method; deck_paint of an overpass; and tunnel.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'bridge', 5000, -0.5, '#0000004d', 2, 'metre', 'shadow'),
    ('dark', 'bridge', 5000, -0.5, '#00000099', 2, 'metre', 'shadow'),
    ('construction', 'bridge', 11000, -0.5, '#1118274d', 2, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'bridge', 5000, 0.5, '#73777f', '#4f545c', 0.5, 'metre', 'bridge'),
    ('dark', 'bridge', 5000, 0.5, '#454b54', '#9aa0a9', 0.5, 'metre', 'bridge'),
    ('construction', 'bridge', 11000, 0.5, '#b4bac3', '#374151', 1.2, 'pixel', 'bridge');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'bridge', 'overpass', 5000, 4.5, '#0000004d', 2, 'metre', 'shadow'),
    ('dark', 'bridge', 'overpass', 5000, 4.5, '#00000099', 2, 'metre', 'shadow'),
    ('construction', 'bridge', 'overpass', 11000, 4.5, '#1118274d', 2, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'bridge', 'overpass', 5000, 5.5, '#73777f', '#4f545c', 0.5, 'metre', 'bridge'),
    ('dark', 'bridge', 'overpass', 5000, 5.5, '#454b54', '#9aa0a9', 0.5, 'metre', 'bridge'),
    ('construction', 'bridge', 'overpass', 11000, 5.5, '#b4bac3', '#374151', 1.2, 'pixel', 'bridge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('street', 'deck_paint', 1500, 6.5, '#fbfbf8'),
    ('dark', 'deck_paint', 1500, 6.5, '#dfe2e6'),
    ('construction', 'deck_paint', 2000, 6.5, '#ffffff');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, dash, meaning) VALUES
    ('street', 'tunnel', 5000, 8.5, '#4f545c', 1, 'pixel', '5', 'tunnel'),
    ('dark', 'tunnel', 5000, 8.5, '#9aa0a9', 1, 'pixel', '5', 'tunnel'),
    ('construction', 'tunnel', 11000, 8.5, '#374151', 1, 'pixel', '5', 'tunnel');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'bridge', 5000, 0.5, '#ffffff', '#000000', 2, 'pixel', 'bridge');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'bridge', 'overpass', 5000, 5.5, '#ffffff', '#000000', 2, 'pixel', 'bridge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit) VALUES
    ('print', 'deck_paint', 1500, 6.5, '#000000', '#000000', 0.5, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, dash, meaning) VALUES
    ('print', 'tunnel', 5000, 8.5, '#000000', 0.8, 'pixel', '5', 'tunnel');
