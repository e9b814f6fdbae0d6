-- Checks and counts of tracks.

CREATE OR REPLACE FUNCTION streetgen._check_rail(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'track along a street without its track', 'street_track', s.street_track_id, NULL::float8, e.geom
        FROM street_track s JOIN edge e USING (edge_id)
        WHERE NOT EXISTS (SELECT FROM rail_track t WHERE t.rail_track_id = s.rail_track_id)
    UNION ALL
    -- Tracks that meet part as slowly as their points lead.
    SELECT 'warning', 'tracks nearer than their width, m', 'rail_track', a.rail_track_id, ST_Distance(a.geom, b.geom),
            a.geom
        FROM track_strip a JOIN track_strip b ON b.rail_track_id > a.rail_track_id AND b.level = a.level
            AND b.geom && ST_Expand(a.geom, 8)
        WHERE ST_DWithin(a.geom, b.geom, (a.width + b.width) / 2 - 0.1) AND NOT ST_DWithin(a.geom, b.geom, 0.1)
            AND NOT EXISTS (SELECT FROM rail_track o WHERE o.level = a.level
                AND o.rail_track_id NOT IN (a.rail_track_id, b.rail_track_id) AND o.geom && ST_Expand(a.geom, 0.1)
                AND ST_DWithin(o.geom, a.geom, 0.1) AND ST_DWithin(o.geom, b.geom, 0.1))
    UNION ALL
    SELECT 'notice', 'footway along a track, m', 'footway', f.footway_id, metres, f.geom
        FROM footway f, LATERAL (SELECT sum(ST_Length(ST_Intersection(ST_Force2D(f.geom), t.surface))) AS metres
            FROM (SELECT surface FROM track_strip t WHERE t.geom && ST_Expand(f.geom, 8) AND t.level = f.level
                OFFSET 0) t WHERE t.surface && f.geom) w
        WHERE metres > greatest(10, ST_Length(f.geom) / 2)
    LOOP
        RETURN NEXT finding;
    END LOOP;
    IF 'object' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'notice', 'object on a track', 'street_object', o.street_object_id, NULL::float8, o.geom
            FROM street_object o LEFT JOIN axis a USING (axis_id), LATERAL (
                SELECT surface FROM track_strip t WHERE t.geom && ST_Expand(o.geom, 8)
                    AND t.level = coalesce(a.level, 0) AND ST_DWithin(t.geom, o.geom, t.width / 2) LIMIT 1) t
            -- One in the roadway is told of as such.
            WHERE o.type <> ALL (_types_on_roadway()) AND NOT EXISTS (SELECT FROM roadway r WHERE r.surface && o.geom
                AND r.level = coalesce(a.level, 0) AND ST_Intersects(r.surface, o.geom));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_rail(name) IS 'The rows of streetgen.check_model for tracks.';

CREATE OR REPLACE FUNCTION streetgen._rail_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (59, 'rail', $part$
    SELECT 'tracks', round(coalesce(sum(tracks * ST_Length(geom)) / 1000, 0)::numeric, 3), 'km' FROM %1$I.rail_track
    UNION ALL SELECT 'tracks in streets', round(coalesce(sum(tracks * (end_abscissa - start_abscissa)) / 1000,
        0)::numeric, 3), 'km' FROM %1$I.street_track JOIN %1$I.rail_track USING (rail_track_id)$part$) $$;
COMMENT ON FUNCTION streetgen._rail_summary() IS 'What streetgen.summary counts of tracks.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('track along a street without its track', 'the track is gone, and its street was not computed since',
        '`generate`'),
    ('tracks nearer than their width, m',
        'two tracks of one level that do not meet lie nearer to each other than setting track_width: trams cannot pass',
        'move a line of `rail_track`, or correct its `tracks` or `level`'),
    ('object on a track', 'a tree, a lamp or the like stands on the ground of a track beside the roadway',
        'move or delete it in `street_object_editing`: what a rule placed stays away'),
    ('footway along a track, m', 'most of a footway lies on the ground of a track, which it does not get',
        'move the line in `footway`, or delete it');
