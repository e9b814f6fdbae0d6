-- Tracks along streets after a run: they read the sections that the one statement wrote, and cut its sidewalks.

CREATE OR REPLACE FUNCTION streetgen._rail_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES (59, 'street_track', 'rail', 'street_track_id', 'edge_id, part', 'street_track'::name, 1) $$;
COMMENT ON FUNCTION streetgen._rail_computed_table() IS 'The computed table of tracks.';

CREATE OR REPLACE FUNCTION streetgen._track_strip(line geometry, width float8, goes_on_before boolean,
    goes_on_behind boolean) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    -- A round end fills the wedge to the strip that goes on from there.
    AS $$ SELECT CASE WHEN goes_on_before OR goes_on_behind THEN ST_Union(ARRAY[strip,
            CASE WHEN goes_on_before THEN ST_Buffer(ST_StartPoint(line), width / 2, 4) END,
            CASE WHEN goes_on_behind THEN ST_Buffer(ST_EndPoint(line), width / 2, 4) END]) ELSE strip END
        FROM ST_Buffer(line, width / 2, 'endcap=flat quad_segs=4') strip $$;
COMMENT ON FUNCTION streetgen._track_strip(geometry, float8, boolean, boolean) IS
    'The ground along a track (LINESTRING), so many metres wide; round at an end from which another one goes on.';

CREATE OR REPLACE FUNCTION streetgen._surfaces_of(ground geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Multi(ST_CollectionExtract(ground, 3)) $$;
COMMENT ON FUNCTION streetgen._surfaces_of(geometry) IS 'The surfaces (MULTIPOLYGON) of a geometry.';

CREATE OR REPLACE FUNCTION streetgen._track_stretches(course geometry)
    RETURNS TABLE(number integer, along boolean, stretch geometry)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
    WITH place AS (
        SELECT path[1] AS n, geom, lag(geom) OVER (ORDER BY path[1]) AS start FROM ST_DumpPoints(course)),
    step AS (
        SELECT n, start, geom, CASE WHEN abs(aside) < abs(ahead) THEN sign(ahead) ELSE 0 END AS onwards
        FROM place, LATERAL (SELECT ST_X(geom) - ST_X(start) AS ahead, ST_Y(geom) - ST_Y(start) AS aside) d
        WHERE start IS NOT NULL),
    run AS (
        SELECT min(n) AS n, onwards <> 0 AS along, ST_MakeLine((array_agg(start ORDER BY n))[1:1]
            || array_agg(geom ORDER BY n)) AS stretch
        FROM (SELECT *, n - row_number() OVER (PARTITION BY onwards ORDER BY n) AS run FROM step) s
        GROUP BY onwards, run)
    -- Axes and tracks have bends of centimetres.
    SELECT n, along, stretch FROM run WHERE ST_Length(stretch) > 0.5 $$;
COMMENT ON FUNCTION streetgen._track_stretches(geometry) IS
    'The course of a track (LINESTRING of metres along an edge and to its left), parted where it turns: back, or to '
    'lead across, which is at 45 degrees and more, or along again. Those shorter than half a metre are none.';

CREATE OR REPLACE FUNCTION streetgen._track_borders(course geometry, half float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH place AS (
        SELECT ST_X(geom) AS at, ST_Y(geom) AS beside FROM ST_DumpPoints(course)),
    slope AS (
        SELECT at, beside, (beside - lag(beside) OVER w) / (at - lag(at) OVER w) AS before,
            (lead(beside) OVER w - beside) / (lead(at) OVER w - at) AS behind
        FROM place WINDOW w AS (ORDER BY at))
    SELECT array_agg(v ORDER BY at, i) FROM slope,
        LATERAL (SELECT half * sqrt(1 + (SELECT avg(s) FROM unnest(ARRAY[before, behind]) s) ^ 2) AS half) h,
        LATERAL (VALUES (1, at), (2, beside + h.half), (3, h.half - beside)) t(i, v) $$;
COMMENT ON FUNCTION streetgen._track_borders(geometry, float8) IS
    'Both sides of a track, half as wide as said, by the course of a stretch along an edge (_track_stretches): as '
    'section.borders.';

CREATE OR REPLACE FUNCTION streetgen._make_rail_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'rail' <> ALL (subjects) THEN
        PERFORM streetgen._drop_own_functions(model, '{_renew_tracks,_sidewalks_at_tracks}');
        RETURN;
    END IF;
    PERFORM streetgen._compose_function(model, '_renew_tracks(edges bigint[])', 'TABLE(relation text, inserted bigint, '
            'updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)', streetgen._part('renew_tracks'),
            '_renew_tracks(bigint[])', 'Brings the tracks along edges (NULL: all) up to date', 'VOLATILE ROWS 1'),
        streetgen._compose_function(model, '_sidewalks_at_tracks(edges bigint[])', 'bigint[]',
            CASE WHEN 'sidewalk' = ANY (subjects) THEN streetgen._part('sidewalks_at_tracks')
            ELSE 'BEGIN RETURN ''{}''::bigint[]; END' END, '_sidewalks_at_tracks(bigint[])',
            'The sidewalks of edges (NULL: of all) whose ground tracks take, or took', 'STABLE');
END $$;
COMMENT ON FUNCTION streetgen._make_rail_functions(name) IS
    'Makes the functions of a model that bring tracks along its streets up to date, or drops them where it computes '
    'none.';

CREATE OR REPLACE FUNCTION streetgen._update_rail(model name, axes bigint[], moved streetgen.moved_row[],
    noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    edges bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NOT NULL THEN
        edges := ARRAY(SELECT e.edge_id FROM edge e WHERE e.axis_id = ANY (axes));
    END IF;
    RETURN QUERY SELECT * FROM _renew_tracks(edges);
    -- The one statement cut those that it wrote. A track that came or went cuts others.
    PERFORM _cut_sidewalks(_sidewalks_at_tracks(edges));
END $$;
COMMENT ON FUNCTION streetgen._update_rail(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the tracks along streets and the sidewalks that '
    'tracks cut up to date.';

CREATE OR REPLACE FUNCTION streetgen._rail_told_others(model name, computed text[]) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'sidewalk' = ANY (computed) $$;
COMMENT ON FUNCTION streetgen._rail_told_others(name, text[]) IS
    'Tracks cut the sidewalks of a model before they were switched off: it is computed anew.';
