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
    RETURN QUERY SELECT 'side_strip', kind, level, s.surface::geometry, side_strip_id
        FROM side_strip s WHERE 'side_strip' = ANY (layers) AND s.surface && box;
END $$;
COMMENT ON FUNCTION streetgen._sidewalk_drawn(name, geometry, text[]) IS
    'What can be drawn of sidewalks in a box: sidewalk; side_strip, the strips before it; crossover, where one '
    'goes on over a drive.';

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

-- Verges and buffers are green and stone; a track is as one that is mapped apart.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'side_strip', 'verge', 5000, 0.1, '#8fae7c', '#8fae7c', 0.7, 'pixel', 'verge'),
    ('dark', 'side_strip', 'verge', 5000, 0.1, '#4f6347', '#4f6347', 0.7, 'pixel', 'verge'),
    ('print', 'side_strip', 'verge', 5000, 0.1, '#f2f2f2', '#f2f2f2', 0.7, 'pixel', 'verge'),
    ('construction', 'side_strip', 'verge', 11000, 0.1, '#b9d3a4', '#93ad7e', 0.4, 'pixel', 'verge'),
    ('street', 'side_strip', 'buffer', 5000, 0.1, '#a29c90', '#a29c90', 0.7, 'pixel', 'buffer'),
    ('dark', 'side_strip', 'buffer', 5000, 0.1, '#6b7079', '#6b7079', 0.7, 'pixel', 'buffer'),
    ('print', 'side_strip', 'buffer', 5000, 0.1, '#cccccc', '#cccccc', 0.7, 'pixel', 'buffer'),
    ('construction', 'side_strip', 'buffer', 11000, 0.1, '#d8c498', '#b3a077', 0.4, 'pixel', 'buffer'),
    ('street', 'side_strip', 'cycle_track', 5000, 0.1, '#a94f3d', '#a94f3d', 0.7, 'pixel', 'cycle track'),
    ('dark', 'side_strip', 'cycle_track', 5000, 0.1, '#a04c38', '#a04c38', 0.7, 'pixel', 'cycle track'),
    ('print', 'side_strip', 'cycle_track', 5000, 0.1, '#a8a8a8', '#a8a8a8', 0.7, 'pixel', 'cycle track'),
    ('construction', 'side_strip', 'cycle_track', 11000, 0.1, '#a94f3d', '#a94f3d', 0.4, 'pixel', 'cycle track');
