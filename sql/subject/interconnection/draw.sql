-- Paths between lanes are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._interconnection_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'path', CASE WHEN plausible THEN '' ELSE 'implausible' END, NULL::integer, geom::geometry,
        interconnection_id FROM interconnection WHERE 'path' = ANY (layers) AND geom && box;
END $$;
COMMENT ON FUNCTION streetgen._interconnection_drawn(name, geometry, text[]) IS
    'What can be drawn of paths between lanes in a box: path.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'path', 2000, 895, '#15803d', 0.7, 'pixel', 'path from lane to lane');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'path', 'implausible', 2000, 894, '#6b728080', 0.4, 'pixel', 'path that is not plausible');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'path', 980, '#b7791f', '#b7791f', 1, 'pixel', 'path from lane to lane to redraw');
