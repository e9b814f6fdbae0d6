-- City blocks are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._block_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Below the roadway of the ground.
    RETURN QUERY SELECT 'block', kind, (SELECT value::integer FROM setting WHERE name = 'ground_level'),
        surface::geometry, block_id FROM block WHERE 'block' = ANY (layers) AND surface && box;
END $$;
COMMENT ON FUNCTION streetgen._block_drawn(name, geometry, text[]) IS
    'What can be drawn of city blocks in a box: block, by kind.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'block', 5000, -1, '#f1ebdf', 'city block'),
    ('dark', 'block', 5000, -1, '#0f1216', 'city block');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning) VALUES
    ('street', 'block', 'island', 5000, -1, '#a9cb8a', 'island'),
    ('street', 'block', 'strip', 5000, -1, '#a9cb8a', 'strip between carriageways'),
    ('dark', 'block', 'island', 5000, -1, '#1a3625', 'island'),
    ('dark', 'block', 'strip', 5000, -1, '#1a3625', 'strip between carriageways');
INSERT INTO streetgen.symbol_rule (theme, layer, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'block', -1, '#f3f1ea', '#a9b79b', 0.6, 'pixel', 'city block');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, meaning) VALUES
    ('construction', 'block', 'island', -1, '#86b35a', 'island'),
    ('construction', 'block', 'strip', -1, '#86b35a', 'strip between carriageways');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker, meaning) VALUES
    ('print', 'block', '', 5000, -1, '#909090', 14, 'pixel', 'hatch', 'city block'),
    ('print', 'block', 'island', 5000, -1, '#606060', 5, 'pixel', 'dots', 'island'),
    ('print', 'block', 'strip', 5000, -1, '#606060', 5, 'pixel', 'dots', 'strip between carriageways');
