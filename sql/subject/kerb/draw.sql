-- Kerbs are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._kerb_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'kerb', '', level, surface::geometry, kerb_id FROM kerb
        -- No stone lies across a roadway that goes on from a bridge.
        WHERE 'kerb' = ANY (layers) AND method <> 'level_change' AND surface && box;
END $$;
COMMENT ON FUNCTION streetgen._kerb_drawn(name, geometry, text[]) IS
    'What can be drawn of kerbs in a box: kerb, the stones.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'kerb', 1500, 0.4, '#00000059', 0.12, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'kerb', 2500, 0.5, '#efe9dd', 'kerb stones'),
    ('dark', 'kerb', 2500, 0.5, '#a9afb8', 'kerb stones'),
    ('construction', 'kerb', 2000, 0.5, '#4b5563', 'kerb stones');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'kerb', 2500, 0.5, '#606060', '#606060', 0.5, 'pixel', 'kerb stones');
