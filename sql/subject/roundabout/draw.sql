-- Roundabouts are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._roundabout_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'ring', CASE WHEN accepted THEN '' ELSE 'refused' END, NULL::integer, ST_Collect(geom,
            ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(centre) - radius * score / 2, ST_Y(centre)),
                ST_MakePoint(ST_X(centre) + radius * score / 2, ST_Y(centre))), ST_SRID(geom))), roundabout_id
        FROM roundabout WHERE 'ring' = ANY (layers) AND geom && box;
END $$;
COMMENT ON FUNCTION streetgen._roundabout_drawn(name, geometry, text[]) IS
    'What can be drawn of roundabouts in a box: ring, with a bar at the centre as wide as the score says, the radius '
    'for 1.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'ring', 11000, 904, '#7c3aed', 2, 'pixel', 'roundabout, bar: its score');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'ring', 'refused', 11000, 904, '#4b5563', 1, 'pixel', 'ring that is none');
