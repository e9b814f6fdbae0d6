-- The layers of tracks in files for a GIS.

CREATE OR REPLACE FUNCTION streetgen._rail_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (37, 'track_beds', 'MULTIPOLYGON', false, 'rail_track_id AS id, level, tracks, width', 'surface', 'track_bed'),
    (37, 'rails', 'MULTILINESTRING', false, 'rail_track_id AS id, level, gauge, tracks', 'rails', 'rail'),
    (37, 'rail_crossings', 'MULTIPOLYGON', false, 'rail_crossing_id AS id, rail_track_id, footway_id, sidewalk_id, '
        'use, level', 'surface', 'rail_crossing') $$;
COMMENT ON FUNCTION streetgen._rail_layer() IS 'The layers of tracks in files.';
