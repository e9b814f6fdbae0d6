-- Lanes and their paint are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._lane_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'lane', kind, level, l.surface::geometry, lane_id FROM lane l JOIN edge USING (edge_id)
        WHERE 'lane' = ANY (layers) AND kind IN ('bus', 'carpool', 'cycle') AND l.surface && box;
    RETURN QUERY SELECT 'lane_separator', kind, level, p.surface::geometry, lane_separator_id FROM lane_separator p
        JOIN edge USING (edge_id) WHERE 'lane_separator' = ANY (layers) AND p.surface && box;
    RETURN QUERY SELECT 'marking', kind, level, m.surface::geometry, marking_id FROM marking m
        JOIN edge USING (edge_id) WHERE 'marking' = ANY (layers) AND m.surface && box;
END $$;
COMMENT ON FUNCTION streetgen._lane_drawn(name, geometry, text[]) IS
    'What can be drawn of lanes in a box: lane, of buses, carpools and bicycles; lane_separator and marking, by kind.';

INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning) VALUES
    ('street', 'lane', 'cycle', 5000, 3, '#a94f3d', 'lane for bicycles'),
    ('street', 'lane', 'bus', 5000, 3, '#c9a05e', 'lane for buses'),
    ('street', 'lane', 'carpool', 5000, 3, '#54457f', 'lane for carpools'),
    ('dark', 'lane', 'cycle', 5000, 3, '#a04c38', 'lane for bicycles'),
    ('dark', 'lane', 'bus', 5000, 3, '#ab8d4a', 'lane for buses'),
    ('dark', 'lane', 'carpool', 5000, 3, '#7a5aa8', 'lane for carpools');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'lane_separator', 1500, 4, '#fbfbf8', 'paint'),
    ('dark', 'lane_separator', 1500, 4, '#dfe2e6', 'paint'),
    ('construction', 'lane_separator', 2000, 4, '#ffffff', 'paint');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('street', 'marking', 1500, 4, '#fbfbf8'),
    ('dark', 'marking', 1500, 4, '#dfe2e6'),
    ('construction', 'marking', 2000, 4, '#ffffff');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'lane', 980, '#6d28d9', '#6d28d9', 1, 'pixel', 'lane to redraw'),
    ('construction', 'handle', 'allowed', 980, '#15803d', '#15803d', 1, 'pixel', 'allowed lane change'),
    ('construction', 'handle', 'forbidden', 980, '#dc2626', '#dc2626', 1, 'pixel', 'forbidden lane change or turn'),
    ('construction', 'handle', 'opposite', 980, '#9ca3af', '#9ca3af', 1, 'pixel', 'lane of the other direction');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker, meaning) VALUES
    ('print', 'lane', 'cycle', 5000, 3, '#a8a8a8', NULL, NULL, NULL, 'lane for bicycles'),
    ('print', 'lane', 'bus', 5000, 3, '#000000', 6, 'pixel', 'hatch', 'lane for buses'),
    ('print', 'lane', 'carpool', 5000, 3, '#000000', 5, 'pixel', 'dots', 'lane for carpools');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'lane_separator', 1500, 4, '#000000', '#000000', 0.5, 'pixel', 'paint'),
    ('print', 'marking', 1500, 4, '#000000', '#000000', 0.5, 'pixel', NULL);
