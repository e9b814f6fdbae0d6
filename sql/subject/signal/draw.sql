-- Signals are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._signal_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'signal_head', '', NULL::integer, ST_Buffer(geom, 0.6, 4), lane_id FROM signal_head
        WHERE 'signal_head' = ANY (layers) AND geom && box;
END $$;
COMMENT ON FUNCTION streetgen._signal_drawn(name, geometry, text[]) IS
    'What can be drawn of signals in a box: signal_head.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'signal_head', 1500, 905, '#c92a2a', '#ffffff', 0.12, 'metre', 'signal');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('dark', 'signal_head', 1500, 905, '#ff5a4a', 'signal'),
    ('construction', 'signal_head', 2000, 905, '#c92a2a', 'signal');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill) VALUES
    ('construction', 'signal_plan', 'red', 0, '#b42318'),
    ('construction', 'signal_plan', 'amber', 1, '#f59e0b'),
    ('construction', 'signal_plan', 'protected', 1, '#2f9e44'),
    ('construction', 'signal_plan', 'permitted', 1, '#86d19a'),
    ('construction', 'signal_plan', 'walk', 1, '#74a9e8'),
    ('construction', 'signal_plan', 'clear', 1, '#cfe0f6'),
    ('construction', 'signal_plan', 'same', 1, '#c9ccd1');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit) VALUES
    ('construction', 'signal_plan', 'grid', 1, NULL, '#c9ccd1', 1, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'signal_head', 1500, 905, '#ffffff', '#000000', 1.2, 'pixel', 'signal');
