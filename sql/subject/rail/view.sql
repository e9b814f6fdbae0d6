-- The ground and the rails of tracks, the lanes that share it, and where people walk over it.

CREATE OR REPLACE FUNCTION streetgen._make_rail_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'rail' <> ALL (subjects) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._part_in('track_strip', model);
    COMMENT ON VIEW track_strip IS 'The ground along each track, whatever lies there';
    COMMENT ON COLUMN track_strip.rail_track_id IS 'the track';
    COMMENT ON COLUMN track_strip.level IS 'its level';
    COMMENT ON COLUMN track_strip.tracks IS 'how many tracks side by side the line stands for';
    COMMENT ON COLUMN track_strip.width IS 'setting track_width for each of them, metres';
    COMMENT ON COLUMN track_strip.geom IS 'its middle';
    COMMENT ON COLUMN track_strip.surface IS 'its ground';
    EXECUTE streetgen._part_in('rail', model);
    COMMENT ON VIEW rail IS 'The rails of each track, at its gauge';
    COMMENT ON COLUMN rail.rail_track_id IS 'the track';
    COMMENT ON COLUMN rail.level IS 'its level';
    COMMENT ON COLUMN rail.tracks IS 'how many tracks side by side the line stands for, two rails each';
    COMMENT ON COLUMN rail.gauge IS 'from rail to rail, millimetres, as is stated, or setting track_gauge';
    COMMENT ON COLUMN rail.geom IS 'the middle of the track';
    COMMENT ON COLUMN rail.rails IS 'its rails';
    EXECUTE streetgen._part_in('track_bed', model);
    COMMENT ON VIEW track_bed IS
        'The ground of each track, parted by what it lies on: the roadway, which is as it is without rails, and ground '
        'of its own, which sidewalks, footways and areas have not. Of tracks that lie on each other the older one has '
        'the ground';
    COMMENT ON COLUMN track_bed.rail_track_id IS 'the track';
    COMMENT ON COLUMN track_bed.level IS 'its level';
    COMMENT ON COLUMN track_bed.tracks IS 'how many tracks side by side the line stands for';
    COMMENT ON COLUMN track_bed.width IS 'setting track_width for each of them, metres';
    COMMENT ON COLUMN track_bed.geom IS 'its middle';
    COMMENT ON COLUMN track_bed.surface IS 'ground of its own; empty: all of it lies in streets';
    COMMENT ON COLUMN track_bed.in_street IS 'ground that it shares with the roadway; NULL or empty: none';
    IF 'lane' = ANY (subjects) THEN
        EXECUTE streetgen._part_in('lane_track', model);
        COMMENT ON VIEW lane_track IS 'The lanes that share their ground with a track along the street, a row for each';
        COMMENT ON COLUMN lane_track.lane_id IS 'the lane';
        COMMENT ON COLUMN lane_track.rail_track_id IS 'the track';
        COMMENT ON COLUMN lane_track.edge_id IS 'the edge of the lane';
        COMMENT ON COLUMN lane_track.start_abscissa IS 'from where along the edge, metres, to 2 m';
        COMMENT ON COLUMN lane_track.end_abscissa IS 'to where along the edge, metres, to 2 m';
    END IF;
    EXECUTE streetgen._part_in('rail_crossing', model, jsonb_build_object('walks', concat(
        streetgen._part('rail_crossing_of_nothing'),
        CASE WHEN 'sidewalk' = ANY (subjects) THEN streetgen._part('rail_crossing_of_sidewalks') END,
        CASE WHEN 'footway' = ANY (subjects) THEN streetgen._fill_template(
            streetgen._part('rail_crossing_of_footways'), jsonb_build_object('footway_ground',
                streetgen._part('footway_ground'))) END)));
    COMMENT ON VIEW rail_crossing IS
        'Where sidewalks and footways lead over a track that lies beside the roadway: crossings without signals';
    COMMENT ON COLUMN rail_crossing.rail_crossing_id IS 'number in this list';
    COMMENT ON COLUMN rail_crossing.rail_track_id IS 'the track';
    COMMENT ON COLUMN rail_crossing.footway_id IS 'the footway; NULL: a sidewalk';
    COMMENT ON COLUMN rail_crossing.sidewalk_id IS 'the sidewalk; NULL: a footway';
    COMMENT ON COLUMN rail_crossing.use IS 'walk, cycle or steps, as axis_class.use';
    COMMENT ON COLUMN rail_crossing.level IS 'level of both';
    COMMENT ON COLUMN rail_crossing.surface IS 'its ground, on that of the track';
END $$;
COMMENT ON FUNCTION streetgen._make_rail_views(name) IS 'Makes the views of a model that computes rails.';

CREATE OR REPLACE FUNCTION streetgen._rail_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 10 SET search_path = pg_catalog
    AS $$ VALUES ('footway_surface'::name, 'rail'), ('area_surface', 'rail'), ('rail_crossing', 'rail'),
        ('rail_crossing', 'sidewalk'), ('rail_crossing', 'footway'), ('lane_track', 'rail'), ('lane_track', 'lane'),
        ('track_bed', 'rail'), ('rail', 'rail'), ('track_strip', 'rail') $$;
COMMENT ON FUNCTION streetgen._rail_view() IS 'The views of rails, and the subjects whose tables they read.';
