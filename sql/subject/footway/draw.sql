-- Footways are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._footway_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'footway', use, level, s.surface::geometry, footway_id
        FROM footway_surface s WHERE 'footway' = ANY (layers) AND s.geom && ST_Expand(box, 10);
END $$;
COMMENT ON FUNCTION streetgen._footway_drawn(name, geometry, text[]) IS
    'What can be drawn of footways in a box: footway, by use.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'footway', 5000, 0, '#cbc3b4', '#cbc3b4', 0.7, 'pixel', 'footway'),
    ('dark', 'footway', 5000, 0, '#6b727c', '#6b727c', 0.7, 'pixel', 'footway'),
    ('print', 'footway', 5000, 0, '#ececec', '#ececec', 0.7, 'pixel', 'footway'),
    ('construction', 'footway', 11000, 0, '#efe3c8', '#c9b791', 0.4, 'pixel', 'footway');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'footway', 'cycle', 5000, 0, '#b5695a', '#b5695a', 0.7, 'pixel', 'cycle track'),
    ('dark', 'footway', 'cycle', 5000, 0, '#7d4a40', '#7d4a40', 0.7, 'pixel', 'cycle track'),
    ('construction', 'footway', 'cycle', 11000, 0, '#d9a79c', '#b5695a', 0.4, 'pixel', 'cycle track');
