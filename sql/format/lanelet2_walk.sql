-- Lanelet2: crosswalks and walkways, lanelets for people on foot.

CREATE OR REPLACE FUNCTION streetgen._lanelet2_crosswalks(model name, options jsonb)
    RETURNS TABLE(file_id bigint, edge_id bigint, width float8, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT streetgen._file_id('object', street_object_id), edge_id, c.width, l.line
        FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
            JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id),
            LATERAL (SELECT ST_LineLocatePoint(e.geom, o.geom) AS share, 1 / ST_Length(e.geom) AS metre) s,
            LATERAL (SELECT ST_Azimuth(ST_LineInterpolatePoint(e.geom, greatest(share - metre, 0)),
                ST_LineInterpolatePoint(e.geom, least(share + metre, 1))) - radians(c.angle) AS across) a,
            LATERAL (SELECT ST_Length(ST_BoundingDiagonal(c.surface)) AS reach) r,
            LATERAL (SELECT ST_Intersection(ST_ConvexHull(c.surface), ST_MakeLine(
                ST_Translate(ST_Force2D(o.geom), -reach * sin(across), -reach * cos(across)),
                ST_Translate(ST_Force2D(o.geom), reach * sin(across), reach * cos(across)))) AS line) l
        WHERE edge_id IN (SELECT streetgen._edges_taken(model, options))
            AND ST_GeometryType(l.line) = 'ST_LineString';
        RETURN QUERY SELECT streetgen._file_id('edge', edge_id, 6 + at_start::integer), edge_id, along, line
        FROM streetgen._crossings_at_ends(model, options) c
        WHERE NOT EXISTS (SELECT FROM pedestrian_crossing o WHERE ST_DWithin(o.surface, c.line, 3));
    ELSE
        RETURN QUERY SELECT streetgen._file_id('edge', edge_id, 6 + at_start::integer), edge_id, along, line
        FROM streetgen._crossings_at_ends(model, options);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._lanelet2_crosswalks(name, jsonb) IS
    'The crossings of edges, also inside places, with their id in files, width along the edge and line from kerb to '
    'kerb: objects of type crossing, and control points of junctions that are none.';

CREATE OR REPLACE FUNCTION streetgen._lanelet2_walks(model name, options jsonb)
    RETURNS TABLE(file_id bigint, subtype text, edge_id bigint, line geometry, number integer, nth integer,
        x float8, y float8, z float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH point AS (
        SELECT file_id, 'crosswalk' AS subtype, edge_id, line, number, nth,
            ST_X(p) + side * width / 2 * -cos(heading) AS x, ST_Y(p) + side * width / 2 * sin(heading) AS y
        FROM streetgen._lanelet2_crosswalks(model, options),
            LATERAL (SELECT ST_Azimuth(ST_StartPoint(line), ST_EndPoint(line)) AS heading) h,
            (VALUES (1, 1), (2, -1)) s(number, side), (VALUES (1), (2)) n(nth),
            LATERAL (SELECT CASE nth WHEN 1 THEN ST_StartPoint(line) ELSE ST_EndPoint(line) END AS p) e
        UNION ALL
        SELECT streetgen._file_id('edge', edge_id, CASE side WHEN 'left' THEN 8 ELSE 9 END), 'walkway', edge_id,
            NULL::geometry, b.number, b.nth, b.x1, b.y1
        FROM streetgen._export_origin(model, options) o, streetgen._sidewalks_beside(model, options, true) w,
            LATERAL (SELECT array_agg(s ORDER BY s) AS s, array_agg(p.x ORDER BY s) AS x,
                    array_agg(p.y ORDER BY s) AS y, array_agg(heading ORDER BY s) AS heading,
                    array_agg(length ORDER BY s) AS length, array_agg(curvature ORDER BY s) AS curvature,
                    sum(length) AS total
                FROM streetgen._plan_view(ST_Force2D(w.line)::bytea, o.tolerance) p) c,
            streetgen._chain_borders(s, c.x, c.y, heading, length, curvature, curvature, ARRAY[0, total],
                ARRAY[width / 2, width / 2, -width / 2, -width / 2], '{}', '{}', '{}', o.tolerance) b
        WHERE ST_Length(w.line) > 0)
    SELECT p.*, ST_Z(ST_LineInterpolatePoint(h.geom, ST_LineLocatePoint(h.geom,
        ST_SetSRID(ST_MakePoint(p.x, p.y), ST_SRID(h.geom)))))
    FROM point p LEFT JOIN streetgen._heights_along(model) h USING (edge_id);
END $$;
COMMENT ON FUNCTION streetgen._lanelet2_walks(name, jsonb) IS
    'The points of the bounds (number 1: left, 2: right) of crosswalks, with their line, and of sidewalks along edges, '
    'with the height of the edge where it has any.';
