-- Arcs of observed kerbs that answer corners.

CREATE OR REPLACE FUNCTION streetgen._kerb_arcs(model name, axes bigint[])
    RETURNS TABLE(arc geometry, middle geometry, centre geometry, radius float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    beside constant float8 := 40;
    radius_least constant float8 := 0.5;
    radius_greatest constant float8 := 80;
    turn_least constant float8 := 45;
    turn_greatest constant float8 := 135;
    tolerance constant float8 := streetgen._setting_number(model, 'fit_arc_tolerance');
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT a.arc, ST_PointN(a.arc, 2), a.centre, a.radius
    FROM observation o, ST_Dump(ST_Force2D(ST_CurveToLine(o.geom))) part,
        ST_Dump(CASE ST_Dimension(part.geom) WHEN 2 THEN ST_Boundary(part.geom) ELSE part.geom END) line,
        streetgen.detect_arcs(line.geom, radius_least, radius_greatest, tolerance, turn_least) a
    WHERE o.kind = 'kerb' AND ST_Dimension(line.geom) = 1
        AND (axes IS NULL OR EXISTS (SELECT FROM axis x WHERE x.axis_id = ANY (axes)
            AND ST_DWithin(x.geom, o.geom, beside)))
        -- An arc of points that lie off it takes so much of the straight lines behind its ends.
        AND ST_Length(a.arc) <= a.radius * radians(turn_greatest) + 2 * sqrt(2 * a.radius * a.deviation);
END $$;
COMMENT ON FUNCTION streetgen._kerb_arcs(name, bigint[]) IS
    'The arcs of observed kerbs that turn as corners do, 45 to 135 degrees, with a radius of 0.5 to 80 m, as '
    'streetgen.detect_arcs finds them in lines and borders of areas. Points make no arc. axes: of kerbs near these, '
    'NULL: all.';

CREATE OR REPLACE FUNCTION streetgen._answering_arcs(model name, axes bigint[])
    RETURNS TABLE(arc geometry, radius float8, corner_id bigint, axis_a bigint, axis_b bigint)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    reach constant float8 := 3;
    of_axes constant bigint[] := axes;
    model_name constant name := model;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH seen AS MATERIALIZED (
        SELECT *, row_number() OVER (ORDER BY middle, arc) AS n FROM streetgen._kerb_arcs(model_name, of_axes)),
    near AS (
        SELECT DISTINCT ON (s.n) s.n, s.arc, s.radius, c.corner_id, a.axis_id AS axis_a, b.axis_id AS axis_b,
            ST_Distance(s.middle, c.arc) AS off
        FROM seen s JOIN corner c ON ST_DWithin(s.middle, c.arc, reach)
            JOIN edge a ON a.edge_id = c.edge_a JOIN edge b ON b.edge_id = c.edge_b
        -- The nose of an island turns the other way, as do kerbs of the far side.
        WHERE c.method <> 'nose' AND a.level >= 0 AND b.level >= 0
            AND cos(ST_Angle(c.centre, ST_PointN(c.arc, 2), s.centre, s.middle)) > cos(pi() / 4)
        ORDER BY s.n, off, c.corner_id),
    nearest AS (
        SELECT DISTINCT ON (n.corner_id) n.* FROM near n
        WHERE of_axes IS NULL OR n.axis_a = ANY (of_axes) OR n.axis_b = ANY (of_axes)
        ORDER BY n.corner_id, n.off, n.n)
    SELECT s.arc, s.radius, n.corner_id, n.axis_a, n.axis_b FROM seen s LEFT JOIN nearest n USING (n);
END $$;
COMMENT ON FUNCTION streetgen._answering_arcs(name, bigint[]) IS
    'The arcs of observed kerbs (CIRCULARSTRING) with their radius (metres) and the corner that each answers, NULL: '
    'none. The middle of the arc lies within 3 m of that of the corner and both turn the same way. An arc answers the '
    'nearest corner, and the nearest arc answers a corner. axes: corners of these, NULL: all.';

CREATE OR REPLACE FUNCTION streetgen._observed_corners(model name, axes bigint[])
    RETURNS TABLE(corner_id bigint, axis_a bigint, axis_b bigint, radius float8, arc geometry)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog
    AS $$ SELECT corner_id, axis_a, axis_b, radius, arc FROM streetgen._answering_arcs(model, axes)
        WHERE corner_id IS NOT NULL ORDER BY corner_id $$;
COMMENT ON FUNCTION streetgen._observed_corners(name, bigint[]) IS
    'The corners that an arc of an observed kerb answers, as streetgen._answering_arcs has them. axes: corners of '
    'these, NULL: all.';
