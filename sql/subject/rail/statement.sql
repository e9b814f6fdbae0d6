-- Parts of the statements and views of tracks, by name: streetgen._part gives each.

--{track_strip
CREATE OR REPLACE VIEW track_strip WITH (security_invoker = true) AS
SELECT t.rail_track_id, t.level, t.tracks, w.width, t.geom, streetgen._track_strip(ST_Force2D(t.geom), w.width,
    EXISTS (SELECT FROM rail_track o WHERE o.rail_track_id <> t.rail_track_id AND o.level = t.level
        AND ST_DWithin(o.geom, ST_StartPoint(t.geom), 0.05)),
    EXISTS (SELECT FROM rail_track o WHERE o.rail_track_id <> t.rail_track_id AND o.level = t.level
        AND ST_DWithin(o.geom, ST_EndPoint(t.geom), 0.05))) AS surface
FROM rail_track t, LATERAL (SELECT t.tracks * value::float8 AS width FROM setting WHERE name = 'track_width') w

--{rail
CREATE OR REPLACE VIEW rail WITH (security_invoker = true) AS
SELECT t.rail_track_id, t.level, t.tracks, g.gauge, t.geom, (SELECT ST_Multi(ST_Collect(ST_OffsetCurve(
        ST_Force2D(t.geom), (number - (t.tracks + 1) / 2.0) * width + beside * g.gauge / 2000, 'quad_segs=8')
        ORDER BY number, beside))
    FROM (VALUES (1), (2), (3), (4)) n(number), (VALUES (-1), (1)) v(beside)
    WHERE number <= t.tracks)::geometry(MultiLineString, {srid}) AS rails
FROM rail_track t, LATERAL (SELECT coalesce(t.gauge, value::float8) AS gauge FROM setting
        WHERE name = 'track_gauge') g,
    LATERAL (SELECT value::float8 AS width FROM setting WHERE name = 'track_width') w

--{track_bed
CREATE OR REPLACE VIEW track_bed WITH (security_invoker = true) AS
SELECT t.rail_track_id, t.level, t.tracks, t.width, t.geom,
    streetgen._surfaces_of(CASE WHEN r.surface IS NULL THEN f.surface ELSE ST_Difference(f.surface, r.surface, 0.0001)
        END)::geometry(MultiPolygon, {srid}) AS surface,
    streetgen._surfaces_of(ST_Intersection(f.surface, r.surface, 0.0001))::geometry(MultiPolygon, {srid}) AS in_street
FROM track_strip t, LATERAL (
    -- The older one of tracks that meet has the ground.
    SELECT CASE WHEN surface IS NULL THEN t.surface ELSE ST_Difference(t.surface, surface, 0.0001) END AS surface
    FROM (SELECT ST_Union(o.surface, 0.0001) AS surface FROM track_strip o WHERE o.rail_track_id < t.rail_track_id
        AND o.level = t.level AND o.geom && ST_Expand(t.geom, 16) AND ST_Intersects(o.surface, t.surface)) o) f,
    LATERAL (SELECT ST_Union(s.surface, 0.0001) AS surface FROM roadway s
        WHERE s.surface && t.surface AND s.level = t.level) r

--{lane_track
CREATE OR REPLACE VIEW lane_track WITH (security_invoker = true) AS
SELECT l.lane_id, t.rail_track_id, t.edge_id, min(a.abscissa) AS start_abscissa, max(a.abscissa) AS end_abscissa
FROM street_track t JOIN lane l USING (edge_id) JOIN edge e USING (edge_id) CROSS JOIN LATERAL (
        SELECT streetgen._lane_borders(l.borders, l.width, l.axis_offset) AS borders,
            greatest(t.start_abscissa, l.start_abscissa - e.start_abscissa) AS low,
            least(t.end_abscissa, l.end_abscissa - e.start_abscissa) AS high) b
    CROSS JOIN LATERAL (SELECT low + (high - low) * n / steps AS abscissa
        FROM (SELECT greatest(1, ceil((high - low) / 2))::integer AS steps) s, generate_series(0, steps) n) a
WHERE t.borders IS NOT NULL AND b.low <= b.high AND 0.1 <
    least(streetgen._border_at(t.borders, a.abscissa, 'left'), streetgen._border_at(b.borders, a.abscissa, 'left'))
    + least(streetgen._border_at(t.borders, a.abscissa, 'right'), streetgen._border_at(b.borders, a.abscissa, 'right'))
GROUP BY l.lane_id, t.street_track_id, t.rail_track_id, t.edge_id

--{rail_crossing
CREATE OR REPLACE VIEW rail_crossing WITH (security_invoker = true) AS
WITH walk AS NOT MATERIALIZED ({walks}),
crossing AS (
    SELECT w.*, t.rail_track_id, streetgen._surfaces_of(ST_Intersection(t.surface, w.ground, 0.0001)) AS surface
    FROM walk w JOIN track_bed t ON t.geom && w.ground AND t.level = w.level AND ST_Intersects(t.geom, w.ground)
    -- One that runs along the track does not cross it.
    WHERE ST_Length(ST_Intersection(ST_Force2D(t.geom), w.ground)) < 5 * w.width)
SELECT row_number() OVER (ORDER BY rail_track_id, footway_id, sidewalk_id) AS rail_crossing_id, rail_track_id,
    footway_id, sidewalk_id, use, level, surface::geometry(MultiPolygon, {srid}) AS surface
FROM crossing WHERE ST_Area(surface) > 0.5

--{rail_crossing_of_nothing
SELECT NULL::bigint AS footway_id, NULL::bigint AS sidewalk_id, NULL::text AS use, NULL::integer AS level,
    NULL::float8 AS width, NULL::geometry AS ground WHERE false

--{rail_crossing_of_sidewalks
UNION ALL SELECT NULL, w.sidewalk_id, 'walk', k.level, w.width, w.strip FROM sidewalk w
        JOIN kerb k USING (edge_id, side, part)
    WHERE w.strip IS NOT NULL AND w.width > 0

--{rail_crossing_of_footways
UNION ALL SELECT f.footway_id, NULL, f.use, f.level, f.width, f.surface
    FROM ({footway_ground}) f
    WHERE EXISTS (SELECT FROM rail_track t
        WHERE t.geom && f.geom AND t.level = f.level AND ST_Intersects(t.geom, f.geom))

--{renew_tracks
#variable_conflict use_column
BEGIN
    RETURN QUERY WITH region AS MATERIALIZED (
        SELECT edge_id FROM edge WHERE edges IS NULL UNION ALL SELECT DISTINCT unnest(edges)),
    piece AS MATERIALIZED (
        SELECT e.edge_id, t.rail_track_id, t.half, p.path[1] AS number, ST_Force2D(e.geom)::bytea AS line, p.geom
        FROM region r JOIN edge e USING (edge_id) JOIN section s USING (edge_id),
            LATERAL (SELECT rail_track_id, ST_Force2D(geom) AS geom, tracks * (SELECT value::float8 FROM setting
                    WHERE name = 'track_width') / 2 AS half
                FROM rail_track t WHERE t.geom && s.surface AND t.level = e.level OFFSET 0) t,
            LATERAL ST_Dump(ST_CollectionExtract(ST_Intersection(t.geom, s.surface), 2)) p
        WHERE ST_Length(p.geom) > 0.5),
    -- Metres along the edge and to its left, by the way of the track.
    course AS MATERIALIZED (
        SELECT edge_id, rail_track_id, half, number, ST_Simplify(ST_MakeLine(ST_MakePoint(at[1], at[2])
            ORDER BY n), 0.02) AS course
        FROM piece p, LATERAL (SELECT d.path[1] AS n, streetgen._locate_on(p.line, d.geom::bytea) AS at
            FROM ST_DumpPoints(ST_Segmentize(p.geom, 2)) d) d
        GROUP BY edge_id, rail_track_id, half, number),
    numbered AS (
        SELECT edge_id, row_number() OVER (PARTITION BY edge_id ORDER BY ST_XMin(stretch), ST_YMin(stretch),
                rail_track_id, c.number, s.number)::integer AS part, rail_track_id,
            ST_XMin(stretch) AS start_abscissa, ST_XMax(stretch) AS end_abscissa,
            CASE WHEN along THEN streetgen._track_borders(stretch, half) END AS borders
        FROM course c, LATERAL streetgen._track_stretches(course) s),
    compared AS MATERIALIZED (
        SELECT n.*, o.edge_id IS NULL AS fresh, (o.rail_track_id, o.start_abscissa, o.end_abscissa, o.borders)
            IS DISTINCT FROM (n.rail_track_id, n.start_abscissa, n.end_abscissa, n.borders) AS changed
        FROM numbered n LEFT JOIN street_track o USING (edge_id, part)),
    gone AS (
        DELETE FROM street_track o USING region r WHERE o.edge_id = r.edge_id AND NOT EXISTS (
            SELECT FROM compared n WHERE (n.edge_id, n.part) = (o.edge_id, o.part)) RETURNING 1),
    put AS (
        INSERT INTO street_track (edge_id, part, rail_track_id, start_abscissa, end_abscissa, borders)
        SELECT edge_id, part, rail_track_id, start_abscissa, end_abscissa, borders FROM compared WHERE changed
        ORDER BY edge_id, part
        ON CONFLICT (edge_id, part) DO UPDATE SET (rail_track_id, start_abscissa, end_abscissa, borders)
            = ROW (excluded.rail_track_id, excluded.start_abscissa, excluded.end_abscissa, excluded.borders))
    SELECT 'street_track', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
        (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
END

--{sidewalks_at_tracks
BEGIN
    RETURN ARRAY(SELECT w.sidewalk_id FROM sidewalk w, setting s WHERE s.name = 'track_width'
        AND (edges IS NULL OR w.edge_id = ANY (edges)) AND (w.strip IS NOT NULL OR EXISTS (SELECT FROM rail_track t
            WHERE t.geom && ST_Expand(w.surface, 8)
                AND ST_DWithin(t.geom, w.surface, t.tracks * s.value::float8 / 2))));
END
