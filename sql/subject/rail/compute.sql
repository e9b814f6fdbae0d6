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

CREATE OR REPLACE FUNCTION streetgen._track_borders(course geometry, half float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH place AS (
        SELECT ST_X(geom) AS at, ST_Y(geom) AS beside, row_number() OVER (ORDER BY path[1] * onwards) AS n
        FROM ST_DumpPoints(course), sign(ST_X(ST_EndPoint(course)) - ST_X(ST_StartPoint(course))) onwards),
    slope AS (
        SELECT at, beside, n, at - lag(at) OVER w AS ahead, (beside - lag(beside) OVER w) / nullif(at - lag(at)
            OVER w, 0) AS before, (lead(beside) OVER w - beside) / nullif(lead(at) OVER w - at, 0) AS behind
        FROM place WINDOW w AS (ORDER BY n))
    SELECT array_agg(v ORDER BY n, i) FROM slope,
        LATERAL (SELECT half * sqrt(1 + (SELECT avg(s) FROM unnest(ARRAY[before, behind]) s) ^ 2) AS half) h,
        LATERAL (VALUES (1, at), (2, beside + h.half), (3, h.half - beside)) t(i, v)
    HAVING bool_and(ahead > 0) IS NOT FALSE AND bool_and(abs(before) < 1) $$;
COMMENT ON FUNCTION streetgen._track_borders(geometry, float8) IS
    'Both sides of a track, half as wide as said, by its course (LINESTRING of metres along an edge and to its left): '
    'as section.borders. NULL: it turns back, or leads across at 45 degrees and more.';

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
