-- Tracks are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._rail_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    about constant geometry := ST_Expand(box, 8);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'track_bed' = ANY (layers) THEN
        RETURN QUERY SELECT 'track_bed', kind, level, ground, rail_track_id
            FROM track_bed t, LATERAL (VALUES ('', t.surface::geometry), ('street', t.in_street)) v(kind, ground)
            WHERE t.geom && about AND NOT ST_IsEmpty(ground);
    END IF;
    IF 'rail' = ANY (layers) THEN
        RETURN QUERY SELECT 'rail', '', level, streetgen._rail_heads(rails), rail_track_id FROM rail t
            WHERE t.geom && about;
    END IF;
    IF 'rail_crossing' = ANY (layers) THEN
        RETURN QUERY SELECT 'rail_crossing', use, level, surface::geometry, rail_crossing_id FROM rail_crossing c
            WHERE c.surface && box;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._rail_drawn(name, geometry, text[]) IS
    'What can be drawn of tracks in a box: track_bed, on ground of its own or in a street; rail; rail_crossing, by '
    'use.';

CREATE OR REPLACE FUNCTION streetgen._rail_heads(rails geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    RETURN ST_Buffer(rails, 0.036, 'endcap=flat join=mitre');
COMMENT ON FUNCTION streetgen._rail_heads(geometry) IS 'The ground of rails (lines), 72 mm wide as their heads are.';

INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning) VALUES
    ('street', 'track_bed', '', 5000, 0.2, '#9aa583', 'track bed'),
    ('dark', 'track_bed', '', 5000, 0.2, '#4d5644', 'track bed'),
    ('print', 'track_bed', '', 5000, 0.2, '#d0d0d0', 'track bed'),
    ('construction', 'track_bed', '', 11000, 0.2, '#d3dabf', 'track bed'),
    ('street', 'track_bed', 'street', 5000, 3.2, '#00000017', NULL),
    ('dark', 'track_bed', 'street', 5000, 3.2, '#ffffff14', NULL),
    ('print', 'track_bed', 'street', 5000, 3.2, '#0000000d', NULL),
    ('construction', 'track_bed', 'street', 11000, 3.2, '#0000000d', NULL);
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'rail', 5000, 7.5, '#23272d', '#23272d', 0.5, 'pixel', 'rails'),
    ('dark', 'rail', 5000, 7.5, '#c3c9d1', '#c3c9d1', 0.5, 'pixel', 'rails'),
    ('print', 'rail', 5000, 7.5, '#000000', '#000000', 0.5, 'pixel', 'rails'),
    ('construction', 'rail', 11000, 7.5, '#1f2937', '#1f2937', 0.5, 'pixel', 'rails');
-- One walks over the bed there.
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, 'rail_crossing', to_scale, 0.3, fill, line, width, unit, 'sidewalk' FROM streetgen.symbol_rule
    WHERE layer = 'sidewalk' AND kind = '';
