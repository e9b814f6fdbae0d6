-- Routes of buses, trams, bicycles and trucks of OpenStreetMap, to the axes that they lead along.

CREATE OR REPLACE FUNCTION streetgen._routed_pieces(model name, lines text, routes text)
    RETURNS TABLE(route text, way_id text, axes bigint[], line geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    ways constant text COLLATE "default" := lines;
    origin constant text COLLATE "default" := routes;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH way AS (
        SELECT DISTINCT ON (r.route, a.source_ref) r.route, r.ordinality, a.source_ref AS way_id, a.axis_id
        FROM axis_route r JOIN axis a ON a.axis_id = r.axis_id
            JOIN delivered d ON (d.relation, d.source, d.source_ref) = ('axis', a.source, a.source_ref)
        -- One that is as the source has it is whole, or whole again.
        WHERE r.source = origin AND a.source = ways
            AND a.geom::bytea <> coalesce(d.cleaned, d.source_geom)::bytea
        ORDER BY r.route, a.source_ref, r.ordinality),
    piece AS (
        SELECT w.route, w.way_id, r.piece, a.axis_id, ST_Force2D(a.geom) AS geom, lead(a.geom) OVER o AS next,
            lag(a.geom) OVER o AS last, count(*) OVER (PARTITION BY w.route, w.way_id) AS pieces
        FROM way w JOIN axis_route r ON r.source = origin AND (r.route, r.ordinality) = (w.route, w.ordinality)
            JOIN axis a ON a.axis_id = r.axis_id
        WHERE a.axis_id = w.axis_id OR a.source_ref IS NULL
        WINDOW o AS (PARTITION BY w.route, w.way_id ORDER BY r.piece))
    SELECT route, way_id, array_agg(axis_id ORDER BY piece), ST_MakeLine(CASE WHEN coalesce(
            ST_Distance(ST_EndPoint(geom), next) <= ST_Distance(ST_StartPoint(geom), next),
            ST_Distance(ST_StartPoint(geom), last) <= ST_Distance(ST_EndPoint(geom), last))
            THEN geom ELSE ST_Reverse(geom) END ORDER BY piece)
    FROM piece WHERE pieces > 1 GROUP BY route, way_id;
END $$;
COMMENT ON FUNCTION streetgen._routed_pieces(name, text, text) IS
    'The ways of routes whose axes were cut by hand: their pieces in order, and one line along all of them.';

CREATE OR REPLACE FUNCTION streetgen._routed_axes(model name, lines text)
    RETURNS TABLE(route text, ordinality integer, axis_id bigint, direction text, kind text, ref text, name text,
        uncut geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    ways constant text COLLATE "default" := lines;
    near constant float8 := 3 * streetgen._tolerance(model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH member AS (
        SELECT r.*, a.axis_id, streetgen._drawn_along(a.geom, coalesce(w.uncut, a.geom)) AS as_drawn, w.uncut,
            ST_StartPoint(coalesce(w.uncut, ST_Force2D(a.geom), o.uncut)) AS starts,
            ST_EndPoint(coalesce(w.uncut, ST_Force2D(a.geom), o.uncut)) AS ends
        FROM pg_temp._import_route r LEFT JOIN axis a ON (a.source, a.source_ref) = (ways, r.way_id)
            LEFT JOIN delivered d ON (d.relation, d.source, d.source_ref) = ('axis', ways, r.way_id)
            LEFT JOIN pg_temp._import_piece k ON (k.route, k.way_id) = (r.route, r.way_id)
            LEFT JOIN (SELECT DISTINCT ON (route, ordinality) route, ordinality, uncut FROM pg_temp._import_orphan) o
                ON (o.route, o.ordinality) = (r.route, r.ordinality),
            -- The line before it was cut by hand; where pieces were moved since, theirs, as the way is drawn.
            LATERAL (SELECT CASE WHEN a.geom::bytea <> said::bytea AND ST_Length2D(a.geom) < ST_Length2D(said) - near
                AND streetgen._lies_along(coalesce(k.line, a.geom), said, near) THEN ST_Force2D(said)
                WHEN NOT streetgen._drawn_along(k.line, said) THEN ST_Reverse(k.line) ELSE k.line END AS uncut
                FROM (SELECT coalesce(d.cleaned, d.source_geom) AS said) s) w),
    neighbour AS (
        SELECT *, lead(starts) OVER w AS next_start, lead(ends) OVER w AS next_end, lag(starts) OVER w AS last_start,
            lag(ends) OVER w AS last_end
        FROM member WINDOW w AS (PARTITION BY route ORDER BY ordinality)),
    met AS (
        SELECT *, ST_DWithin(ends, next_start, near) OR ST_DWithin(ends, next_end, near) AS leads_on,
            ST_DWithin(starts, next_start, near) OR ST_DWithin(starts, next_end, near) AS leads_back,
            ST_DWithin(starts, last_start, near) OR ST_DWithin(starts, last_end, near) AS comes_on,
            ST_DWithin(ends, last_start, near) OR ST_DWithin(ends, last_end, near) AS comes_back
        FROM neighbour WHERE axis_id IS NOT NULL)
    SELECT route, ordinality, axis_id, CASE WHEN as_drawn THEN way ELSE streetgen._turned_way(way) END, kind, ref, name,
        uncut
    FROM met, LATERAL (SELECT CASE WHEN role = 'forward' THEN 'direct' WHEN role = 'backward' THEN 'reverse'
            -- Whoever cycles rides either way but where the role says one.
            WHEN kind = 'bicycle' THEN 'both'
            -- A ring begins where it ends: its neighbours do not tell.
            WHEN leads_on AND leads_back IS NOT TRUE OR comes_on AND comes_back IS NOT TRUE
                THEN CASE WHEN leads_back AND leads_on IS NOT TRUE OR comes_back AND comes_on IS NOT TRUE THEN NULL
                    ELSE 'direct' END
            WHEN leads_back AND leads_on IS NOT TRUE OR comes_back AND comes_on IS NOT TRUE THEN 'reverse' END
            AS way) w;
END $$;
COMMENT ON FUNCTION streetgen._routed_axes(name, text) IS
    'The axes of the routes of an import, whose lines are those of a source: their order and the way that each is '
    'driven, by its role or else by the members before and after it.';

CREATE OR REPLACE FUNCTION streetgen._orphaned_pieces(model name, lines text, routes text)
    RETURNS TABLE(route text, ordinality integer, axis_id bigint, direction text, kind text, ref text, name text,
        uncut geometry, piece integer)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    ways constant text COLLATE "default" := lines;
    origin constant text COLLATE "default" := routes;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH place AS (
        SELECT r.route, r.ordinality, r.kind, r.ref, r.name, coalesce(d.cleaned, d.source_geom) AS said
        FROM pg_temp._import_route r JOIN delivered d ON (d.relation, d.source, d.source_ref)
                = ('axis', ways, r.way_id)
        WHERE NOT EXISTS (SELECT FROM axis a WHERE (a.source, a.source_ref) = (ways, r.way_id))),
    orphan AS (
        SELECT s.* FROM axis_route s WHERE s.source = origin AND s.uncut IS NOT NULL
            AND NOT EXISTS (SELECT FROM axis_route o JOIN axis a ON a.axis_id = o.axis_id WHERE o.source = origin
                AND (o.route, o.ordinality) = (s.route, s.ordinality) AND a.source = ways
                AND a.source_ref IN (SELECT i.way_id FROM pg_temp._import_route i))),
    -- Pieces may have been moved, and a route may lead along a way twice.
    found AS (
        SELECT DISTINCT ON (s.axis_route_id) p.route, p.ordinality, s.axis_id, s.direction, p.kind, p.ref, p.name,
            s.uncut, s.piece
        FROM orphan s JOIN place p ON p.route = s.route AND p.said && s.uncut
        ORDER BY s.axis_route_id, ST_HausdorffDistance(p.said, s.uncut), abs(p.ordinality - s.ordinality))
    SELECT DISTINCT ON (f.route, f.ordinality, f.axis_id) f.* FROM found f
        ORDER BY f.route, f.ordinality, f.axis_id, f.piece;
END $$;
COMMENT ON FUNCTION streetgen._orphaned_pieces(name, text, text) IS
    'The pieces on routes of ways that were cut by hand, of which the piece that had the id of the way was deleted: '
    'where they stand in the routes of an import.';

CREATE OR REPLACE FUNCTION streetgen._import_routes(model name, line regclass, route regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := route::text;
BEGIN
    PERFORM streetgen._use_model(model);
    IF route IS NULL THEN
        RETURN QUERY SELECT 'no table of routes, those of the model stay', NULL::text, 0::bigint, NULL::text[];
        RETURN;
    END IF;
    -- A relation of several kinds is a route of each.
    PERFORM streetgen._take_points('_import_route', format('SELECT concat_ws(''/'', relation_id, CASE WHEN min(kind) '
        'OVER r <> max(kind) OVER r THEN kind END) AS route, ordinality, way_id::text AS way_id, role, kind, ref, '
        'name, relation_id::text AS source_ref FROM %s WINDOW r AS (PARTITION BY relation_id)', route));
    CREATE TEMPORARY TABLE _import_piece ON COMMIT DROP AS
        SELECT * FROM streetgen._routed_pieces(model, line::text, origin);
    CREATE TEMPORARY TABLE _import_orphan ON COMMIT DROP AS
        SELECT * FROM streetgen._orphaned_pieces(model, line::text, origin);
    DELETE FROM axis_route WHERE source = origin;
    INSERT INTO axis_route (route, ordinality, axis_id, direction, kind, ref, name, uncut, piece, source)
        SELECT o.*, origin FROM pg_temp._import_orphan o;
    INSERT INTO axis_route (route, ordinality, axis_id, direction, kind, ref, name, uncut, source)
        SELECT r.*, origin FROM streetgen._routed_axes(model, line::text) r ORDER BY route, ordinality;
    INSERT INTO axis_route (route, ordinality, axis_id, direction, kind, ref, name, uncut, source)
        SELECT r.route, r.ordinality, a.axis_id, streetgen._way_of_piece(r.direction, own.geom, a.geom, r.uncut),
            r.kind, r.ref, r.name, r.uncut, r.source
        FROM axis_route r JOIN axis own ON own.axis_id = r.axis_id
            JOIN pg_temp._import_piece k ON (k.route, k.way_id) = (r.route, own.source_ref)
            JOIN axis a ON a.axis_id = ANY (k.axes) AND a.axis_id <> own.axis_id
        WHERE r.source = origin;
    PERFORM streetgen._count_route_pieces(model, ARRAY(SELECT unnest(k.axes) FROM pg_temp._import_piece k
        UNION SELECT o.axis_id FROM pg_temp._import_orphan o));
    PERFORM streetgen._add_route_pieces(model, ARRAY(SELECT a.axis_id FROM axis a
        WHERE a.source_ref IS NULL AND EXISTS (SELECT FROM axis_route r WHERE r.uncut && a.geom)));
    RETURN QUERY SELECT 'routes', r.kind, count(DISTINCT r.route), NULL::text[] FROM axis_route r
        WHERE r.source = origin GROUP BY r.kind ORDER BY r.kind;
    DROP TABLE pg_temp._import_route, pg_temp._import_piece, pg_temp._import_orphan;
END $$;
COMMENT ON FUNCTION streetgen._import_routes(name, regclass, regclass) IS
    'Takes the routes of an OSM table whose ways are axes in place of those that it had; a NULL table leaves all as it '
    'was.';
