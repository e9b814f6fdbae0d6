-- Roads are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._alignment_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'road', '', NULL::integer, geom::geometry, road_id FROM road
        WHERE 'road' = ANY (layers) AND geom && box;
    -- As figure 6b of Wilkie, Sewall and Lin: from the ends of an arc to its centre.
    RETURN QUERY SELECT 'road_radius', '', NULL::integer,
        ST_MakeLine(ARRAY[ST_StartPoint(arc), centre, ST_EndPoint(arc)])::geometry, road_arc_id FROM road_arc
        WHERE 'road_radius' = ANY (layers) AND radius < 100 AND arc && box;
END $$;
COMMENT ON FUNCTION streetgen._alignment_drawn(name, geometry, text[]) IS
    'What can be drawn of roads in a box: road, and road_radius of bends.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'road', 11000, 904, '#a21caf', 1.2, 'pixel', 'road'),
    ('construction', 'road_radius', 2000, 905, '#a21caf', 0.4, 'pixel', 'radius of a bend');
