-- The reach of a change along a street, by turn marks that hold to the next junction.

CREATE OR REPLACE FUNCTION streetgen._goes_straight(back geometry, onwards geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- The core asks for less than 50 degrees, of edges that may be cut elsewhere.
    RETURN abs(180 - degrees(ST_Angle(
        ST_StartPoint(back), ST_LineInterpolatePoint(back, least(1, 10 / ST_Length(back))),
        ST_StartPoint(onwards), ST_LineInterpolatePoint(onwards, least(1, 10 / ST_Length(onwards)))))) < 60;
COMMENT ON FUNCTION streetgen._goes_straight(geometry, geometry) IS
    'Does one who comes by a line go about straight on by another? Both lines begin where they meet.';

CREATE OR REPLACE FUNCTION streetgen._lane_axes_from_afar(model name, axes bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
DECLARE
    -- Axes that share a node are nearer.
    near constant float8 := 3 * streetgen._tolerance(model);
    hull geometry;
    afar bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) FROM axis WHERE axis_id = ANY (axes) INTO hull;
    -- From marks on: over ends at which two axes meet, and straight on over others, along edges as short as one within
    -- a junction. Then back from the axes that come to the hull.
    WITH RECURSIVE way(axis_id, leaves_at_end, from_axis, from_end) AS (
        SELECT axis_id, leaves_at_end, NULL::bigint, NULL::boolean FROM axis,
            unnest('{true,false}'::boolean[]) leaves_at_end WHERE coalesce(turn_forward, turn_backward) IS NOT NULL
        UNION SELECT o.axis_id, o.starts_here, w.axis_id, w.leaves_at_end FROM way w JOIN axis x USING (axis_id),
            LATERAL (SELECT CASE WHEN w.leaves_at_end THEN ST_Reverse(x.geom) ELSE x.geom END AS back) l,
            ST_StartPoint(back) place, LATERAL (
                SELECT n.*, CASE WHEN starts_here THEN n.geom ELSE ST_Reverse(n.geom) END AS onwards FROM (
                    SELECT axis_id, n.geom, coalesce(turn_forward, turn_backward) IS NOT NULL AS marked,
                        count(*) OVER () AS meeting, ST_DWithin(ST_StartPoint(n.geom), place, near) AS starts_here
                    FROM axis n WHERE ST_DWithin(n.geom, place, near) OFFSET 0) n) o
        WHERE NOT marked AND o.axis_id <> w.axis_id AND ST_DWithin(ST_StartPoint(o.onwards), place, near)
            AND (meeting = 2 OR streetgen._goes_straight(back, o.onwards) AND (ST_Length(o.onwards) < 101
                OR EXISTS (SELECT FROM axis m WHERE ST_DWithin(m.geom, ST_LineSubstring(o.onwards,
                    near / ST_Length(o.onwards), 101 / ST_Length(o.onwards)), near)
                AND m.axis_id <> o.axis_id AND NOT ST_DWithin(m.geom, place, near))))),
    back(axis_id, leaves_at_end) AS (
        SELECT axis_id, leaves_at_end FROM way JOIN axis USING (axis_id) WHERE ST_DWithin(geom, hull, near)
        UNION SELECT w.from_axis, w.from_end FROM back b JOIN way w USING (axis_id, leaves_at_end)
            WHERE w.from_axis IS NOT NULL)
    SELECT array_agg(DISTINCT axis_id) FROM back WHERE axis_id <> ALL (axes) INTO afar;
    RETURN coalesce(afar, '{}');
END $$;
COMMENT ON FUNCTION streetgen._lane_axes_from_afar(name, bigint[]) IS
    'The axes along which turn marks come to some from afar.';

CREATE OR REPLACE FUNCTION streetgen._make_lane_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model), streetgen._make_line_function(model);
    CREATE OR REPLACE FUNCTION _carrying(edges bigint[]) RETURNS SETOF bigint
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 5 SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
        AS $body$
    BEGIN
        RETURN QUERY SELECT DISTINCT l.edge_id FROM lane l
            CROSS JOIN LATERAL (SELECT CASE WHEN l.along_axis THEN a.turn_forward ELSE a.turn_backward END AS list
                FROM edge e JOIN axis a USING (axis_id) WHERE e.edge_id = l.edge_id OFFSET 0) own
        WHERE l.edge_id = ANY (edges) AND l.turn IS NOT NULL AND l.kind <> 'merging'
            -- A list that does not fit the lanes marks none of them, nor does one without a turn.
            AND (list IS NULL OR list !~ 'left|right|through|reverse' OR cardinality(string_to_array(list, '|')) <> (
                SELECT count(*) FROM lane o WHERE o.edge_id = l.edge_id AND o.along_axis = l.along_axis
                    AND NOT o.both_ways AND o.kind IN ('general', 'bus', 'carpool')));
    END $body$;
    PERFORM streetgen._own_function(model, '_carrying(bigint[])',
        'Those of some edges on whose lanes lie turn marks of other edges');
    CREATE OR REPLACE FUNCTION _marked_run(axes bigint[]) RETURNS TABLE(edge_id bigint, axis_id bigint,
            from_node bigint, to_node bigint, geom geometry)
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
        AS $body$
    #variable_conflict use_column
    BEGIN
        IF to_regclass(format('%I.lane', current_schema())) IS NULL THEN
            RETURN;
        END IF;
        RETURN QUERY
        WITH RECURSIVE own AS MATERIALIZED (SELECT from_node, to_node FROM edge WHERE axis_id = ANY (axes)),
        node AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM own),
        at_node AS MATERIALIZED (
            SELECT array_agg(edge_id) AS ids FROM (
                SELECT edge_id FROM edge WHERE from_node = ANY ((SELECT ids FROM node)::bigint[])
                UNION SELECT edge_id FROM edge WHERE to_node = ANY ((SELECT ids FROM node)::bigint[])) e),
        -- Each edge is looked up by its key. Marks of its own end the way of others.
        run(edge_id, from_node, to_node, short) AS (
            SELECT e.* FROM _carrying((SELECT ids FROM at_node)) m(edge_id),
                LATERAL (SELECT edge_id, from_node, to_node, ST_Length(geom) < 101 FROM edge e
                    WHERE e.edge_id = m.edge_id OFFSET 0) e
            -- Over an edge within a junction marks go on as over a node of two edges. The core bounds its length.
            UNION SELECT o.edge_id, o.from_node, o.to_node, ST_Length(o.geom) < 101
            FROM run r, unnest(ARRAY[r.from_node, r.to_node]) n(node_id), LATERAL (
                SELECT e.*, count(*) OVER () AS degree FROM (
                    SELECT e.* FROM edge e WHERE e.from_node = n.node_id
                    UNION ALL SELECT e.* FROM edge e WHERE e.to_node = n.node_id OFFSET 0) e) o
            WHERE (o.degree = 2 OR r.short) AND o.edge_id <> r.edge_id
                AND EXISTS (SELECT FROM _carrying(ARRAY[o.edge_id])))
        SELECT e.* FROM run r, LATERAL (SELECT edge_id, axis_id, from_node, to_node, geom FROM edge e
            WHERE e.edge_id = r.edge_id OFFSET 0) e;
    END $body$;
    PERFORM streetgen._own_function(model, '_marked_run(bigint[])',
        'The edges with turn marks of others that have to do with the edges of some axes: those that meet them, and '
        'on over nodes of two edges and short edges');
END $$;
COMMENT ON FUNCTION streetgen._make_lane_functions(name) IS
    'Makes the functions of a model that tell how far turn marks let a change reach, and lay lines before crossings.';
