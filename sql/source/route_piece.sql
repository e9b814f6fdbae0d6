-- Routes stay on the pieces of an axis that is cut, and leave one that is deleted.

CREATE OR REPLACE FUNCTION streetgen._lies_along(line geometry, other geometry, near float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_CoveredBy(line, ST_Buffer(other, near)) $$;
COMMENT ON FUNCTION streetgen._lies_along(geometry, geometry, float8) IS
    'Whether a line lies all along as near as this to another line.';

CREATE OR REPLACE FUNCTION streetgen._drawn_along(line geometry, other geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_LineLocatePoint(o, ST_LineInterpolatePoint(l, 0.25))
        <= ST_LineLocatePoint(o, ST_LineInterpolatePoint(l, 0.75))
    FROM (SELECT ST_Force2D(line) AS l, ST_Force2D(other) AS o) f $$;
COMMENT ON FUNCTION streetgen._drawn_along(geometry, geometry) IS
    'Whether a line runs as another one beside it, and not against it.';

CREATE OR REPLACE FUNCTION streetgen._turned_way(direction text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE direction WHEN 'direct' THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE direction END;
COMMENT ON FUNCTION streetgen._turned_way(text) IS
    'A direction along an axis, as it is of the axis drawn the other way.';

CREATE OR REPLACE FUNCTION streetgen._way_of_piece(way text, own geometry, piece geometry, uncut geometry) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    RETURN CASE WHEN streetgen._drawn_along(piece, uncut) = streetgen._drawn_along(own, uncut) THEN way
        ELSE streetgen._turned_way(way) END;
COMMENT ON FUNCTION streetgen._way_of_piece(text, geometry, geometry, geometry) IS
    'The direction of a route along a piece of a line that was cut, from that along another piece of it.';

CREATE OR REPLACE FUNCTION streetgen._count_route_pieces(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE axis_route r SET piece = n.piece FROM (
        -- A piece that was moved keeps its place, and new ones share that of the piece that they were cut off.
        SELECT p.axis_route_id, row_number() OVER (PARTITION BY p.source, p.route, p.ordinality
            ORDER BY p.piece, at * CASE WHEN leads_along THEN 1 ELSE -1 END, p.axis_id) AS piece
        FROM axis_route p JOIN axis a ON a.axis_id = p.axis_id,
            LATERAL (SELECT ST_LineLocatePoint(p.uncut, ST_LineInterpolatePoint(ST_Force2D(a.geom), 0.5)) AS at,
                coalesce((d.direction = 'direct') = streetgen._drawn_along(a.geom, p.uncut),
                -- Where the direction is unknown, the place before tells from where it leads.
                (SELECT ST_Distance(b.geom, ST_StartPoint(p.uncut)) <= ST_Distance(b.geom, ST_EndPoint(p.uncut))
                    FROM axis_route q JOIN axis b ON b.axis_id = q.axis_id WHERE q.source IS NOT DISTINCT FROM p.source
                        AND q.route = p.route AND q.ordinality < p.ordinality
                    ORDER BY q.ordinality DESC, q.piece DESC LIMIT 1), true) AS leads_along
                FROM (SELECT nullif(p.direction, 'both') AS direction) d) w
        WHERE EXISTS (SELECT FROM axis_route i WHERE i.axis_id = ANY (axes)
            AND i.source IS NOT DISTINCT FROM p.source AND (i.route, i.ordinality) = (p.route, p.ordinality))) n
        WHERE n.axis_route_id = r.axis_route_id AND n.piece <> r.piece;
END $$;
COMMENT ON FUNCTION streetgen._count_route_pieces(name, bigint[]) IS
    'Counts the pieces at the places of routes where axes stand, in the order in which the route leads along them.';

CREATE OR REPLACE FUNCTION streetgen._add_route_pieces(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    near constant float8 := streetgen._tolerance(model);
    candidates bigint[] := axes;
    added bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    LOOP
        WITH piece AS (
            INSERT INTO axis_route (route, ordinality, axis_id, direction, kind, ref, name, source, uncut, piece)
            SELECT DISTINCT ON (r.source, r.route, r.ordinality, a.axis_id) r.route, r.ordinality, a.axis_id,
                streetgen._way_of_piece(r.direction, own.geom, a.geom, r.uncut), r.kind, r.ref, r.name, r.source,
                r.uncut, r.piece
            FROM axis a JOIN axis_route r ON r.uncut && a.geom AND r.axis_id <> a.axis_id
                JOIN axis own ON own.axis_id = r.axis_id AND own.level = a.level AND ST_DWithin(a.geom, own.geom, near),
                LATERAL (SELECT ST_LineInterpolatePoint(ST_Force2D(a.geom), 0.5) AS middle) m
            WHERE a.axis_id = ANY (candidates) AND streetgen._lies_along(a.geom, r.uncut, near)
                -- A street of a class that imports leave out is another street.
                AND NOT EXISTS (SELECT FROM axis_class c WHERE c.class = a.kind AND NOT (c.taken AND c.use = 'roadway')
                    AND a.kind IS DISTINCT FROM own.kind)
                -- A line upon a piece is that piece, another street or its twin.
                AND NOT EXISTS (SELECT FROM axis_route o JOIN axis p ON p.axis_id = o.axis_id
                    WHERE o.source IS NOT DISTINCT FROM r.source AND (o.route, o.ordinality) = (r.route, r.ordinality)
                        AND ST_DWithin(middle, p.geom, near))
            -- On a ring a piece may touch two: it was cut off the one that is nearer along it.
            ORDER BY r.source, r.route, r.ordinality, a.axis_id, abs(ST_LineLocatePoint(r.uncut, middle)
                - ST_LineLocatePoint(r.uncut, ST_LineInterpolatePoint(ST_Force2D(own.geom), 0.5))), r.axis_route_id
            RETURNING axis_id)
        SELECT array_agg(DISTINCT axis_id) FROM piece INTO added;
        EXIT WHEN added IS NULL;
        PERFORM streetgen._count_route_pieces(model, added);
        -- Pieces may have been drawn before the one that leads to them.
        candidates := ARRAY(SELECT DISTINCT a.axis_id FROM axis n JOIN axis a ON ST_DWithin(a.geom, n.geom, near)
            WHERE n.axis_id = ANY (added));
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._add_route_pieces(name, bigint[]) IS
    'Gives axes the routes of an axis that was cut where they lie along what it was and lead on from a piece on its '
    'level, also those that lead on from these.';

CREATE OR REPLACE FUNCTION streetgen._source_axis_follower() RETURNS TABLE(relation name, follower name)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('axis_route'::name, '_follow_routes'::name) $$;
COMMENT ON FUNCTION streetgen._source_axis_follower() IS 'Routes stay on the pieces of their axes.';

CREATE OR REPLACE FUNCTION streetgen._source_edited() RETURNS TABLE(relation name)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('axis_route'::name) $$;
COMMENT ON FUNCTION streetgen._source_edited() IS 'The tables of imports that an editor may write: routes.';

CREATE OR REPLACE FUNCTION streetgen._make_route_follower(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _follow_routes(axes bigint[], lines_before geometry[], lines_after geometry[])
        RETURNS void LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off
        AS $body$
    DECLARE
        near constant float8 := streetgen._tolerance(current_schema());
    BEGIN
        DELETE FROM axis_route r USING unnest(axes, lines_after) c(axis, now) WHERE r.axis_id = c.axis AND now IS NULL;
        -- A line along the former one is a piece of it, another one is drawn anew.
        UPDATE axis_route r SET uncut = CASE WHEN streetgen._lies_along(now, whole, near)
                AND ST_Length2D(now) < ST_Length2D(whole) - near THEN whole END,
            direction = CASE WHEN streetgen._drawn_along(now, was) THEN r.direction
                ELSE streetgen._turned_way(r.direction) END
        FROM unnest(axes, lines_before, lines_after) c(axis, was, now),
            LATERAL (SELECT coalesce((SELECT o.uncut FROM axis_route o WHERE o.axis_id = c.axis
                AND o.uncut IS NOT NULL LIMIT 1), ST_Force2D(was)) AS whole) w
        WHERE r.axis_id = c.axis AND was IS NOT NULL AND now IS NOT NULL;
        IF EXISTS (SELECT FROM axis_route WHERE uncut && (SELECT ST_Extent(line)::geometry
            FROM unnest(lines_after) line)) THEN
            PERFORM streetgen._add_route_pieces(current_schema(), axes);
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_follow_routes(bigint[], geometry[], geometry[])',
        'Keeps routes on the pieces of changed axes, and takes them off deleted ones');
END $$;
COMMENT ON FUNCTION streetgen._make_route_follower(name) IS
    'Makes the function of a model by which routes follow its axes.';
