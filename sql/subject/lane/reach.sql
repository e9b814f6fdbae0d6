-- The reach of a change along a street, by turn marks that hold to the next junction.

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
    IF NOT EXISTS (SELECT FROM axis WHERE turn_forward IS NOT NULL OR turn_backward IS NOT NULL) THEN
        RETURN '{}';
    END IF;
    SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) FROM axis WHERE axis_id = ANY (axes) INTO hull;
    -- Back over ends at which two axes meet, as far as none is marked.
    WITH RECURSIVE run(axis_id) AS (
        SELECT a.axis_id FROM axis a WHERE ST_DWithin(a.geom, hull, near) AND a.axis_id <> ALL (axes)
        UNION SELECT o.axis_id FROM run r JOIN axis a USING (axis_id),
            unnest(ARRAY[ST_StartPoint(a.geom), ST_EndPoint(a.geom)]) place,
            LATERAL (SELECT n.axis_id, count(*) OVER () AS meeting FROM axis n
                WHERE ST_DWithin(n.geom, place, near) OFFSET 0) o
        WHERE coalesce(a.turn_forward, a.turn_backward) IS NULL AND o.meeting = 2 AND o.axis_id <> ALL (axes))
    SELECT array_agg(axis_id) FROM run INTO afar;
    RETURN coalesce(afar, '{}');
END $$;
COMMENT ON FUNCTION streetgen._lane_axes_from_afar(name, bigint[]) IS
    'The axes about some along which turn marks may come to them from afar, over ends at which two axes meet.';

CREATE OR REPLACE FUNCTION streetgen._make_lane_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
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
    'Makes the function of a model that tells how far turn marks let a change reach.';
