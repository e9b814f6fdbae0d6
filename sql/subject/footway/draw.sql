-- Footways and areas are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._footway_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'area', kind, level, s.surface::geometry, street_area_id
        FROM area_surface s WHERE 'area' = ANY (layers) AND s.geom && box;
    RETURN QUERY SELECT 'footway', use, level, s.surface::geometry, footway_id
        FROM footway_surface s WHERE 'footway' = ANY (layers) AND s.geom && ST_Expand(box, 10);
END $$;
COMMENT ON FUNCTION streetgen._footway_drawn(name, geometry, text[]) IS
    'What can be drawn of footways in a box: footway, by use, and area, by kind.';

-- One walks there as on a sidewalk, and cycles there as on a lane for bicycles: in the same colours.
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'footway', to_scale, place, fill, line, width, unit, 'footway' FROM streetgen.symbol_rule
    WHERE layer = 'sidewalk' AND kind = '';
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'footway', 'cycle', to_scale, 0, fill, line, width, unit, meaning FROM streetgen.symbol_rule
    WHERE (layer, kind) = ('side_strip', 'cycle_track');

-- Areas on which one walks or cycles look as footways do.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'area', kind, to_scale, place, fill, line, width, unit,
        CASE kind WHEN '' THEN 'square or platform' ELSE meaning END
    FROM streetgen.symbol_rule WHERE layer = 'footway';
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'area', 'parking_area', 5000, 0, '#a0a8b9', '#a0a8b9', 0.7, 'pixel', 'car park'),
    ('dark', 'area', 'parking_area', 5000, 0, '#7c766a', '#7c766a', 0.7, 'pixel', 'car park'),
    ('print', 'area', 'parking_area', 5000, 0, '#c6c6c6', '#c6c6c6', 0.7, 'pixel', 'car park'),
    ('construction', 'area', 'square', 11000, 0, '#f3e7c9', '#c9b791', 0.4, 'pixel', 'square'),
    ('construction', 'area', 'parking_area', 11000, 0, '#cfd3da', '#939ca9', 0.4, 'pixel', 'car park'),
    ('construction', 'area', 'platform', 11000, 0, '#ddc9b0', '#b08d5b', 0.4, 'pixel', 'platform');
