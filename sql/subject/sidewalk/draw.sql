-- Sidewalks are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'crossover', '', level, c.surface::geometry, crossover_id FROM crossover c
        WHERE 'crossover' = ANY (layers) AND c.place && ST_Expand(box, 30) AND c.surface && box;
    RETURN QUERY SELECT 'sidewalk', streetgen._paving_kind(CASE side WHEN 'left' THEN sidewalk_left
            WHEN 'right' THEN sidewalk_right ELSE CASE sidewalk_left WHEN sidewalk_right THEN sidewalk_left END END),
            level, w.surface::geometry, sidewalk_id
        FROM sidewalk w JOIN kerb USING (edge_id, side, part) JOIN paving USING (edge_id)
        WHERE 'sidewalk' = ANY (layers) AND w.surface && box;
END $$;
COMMENT ON FUNCTION streetgen._sidewalk_drawn(name, geometry, text[]) IS
    'What can be drawn of sidewalks in a box: sidewalk; crossover, where one goes on over a drive.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'sidewalk', 5000, 0, '#bbb5aa', '#bbb5aa', 0.7, 'pixel', 'sidewalk'),
    ('dark', 'sidewalk', 5000, 0, '#7d848e', '#7d848e', 0.7, 'pixel', 'sidewalk'),
    ('print', 'sidewalk', 5000, 0, '#e0e0e0', '#e0e0e0', 0.7, 'pixel', 'sidewalk'),
    ('construction', 'sidewalk', 11000, 0, '#e9d6ac', '#c9b791', 0.4, 'pixel', 'sidewalk');

INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'sidewalk', 'unpaved', 5000, 0, colour, colour, 0.7, 'pixel', 'unpaved sidewalk'
    FROM (VALUES ('street', '#c2ad88'), ('dark', '#8a7c63'), ('print', '#d4d4d4')) v(theme, colour);

-- One walks on there, above lines at the end of the drive, which nobody paints on a sidewalk.
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'crossover', to_scale, 4.2, fill, line, width, unit, 'sidewalk' FROM streetgen.symbol_rule
    WHERE layer = 'sidewalk' AND kind = '';
