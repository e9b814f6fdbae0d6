-- The reach of a change along a highway, by merging lanes.

CREATE OR REPLACE FUNCTION streetgen._merging_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    metres float8;
BEGIN
    PERFORM streetgen._use_model(model);
    -- A lane lies so far from its ramp: its length, a taper, which the core bounds by 300 m, and what the intersection
    -- takes. Two that meet are as far apart as twice that.
    SELECT 2 * (max(value::float8) FILTER (WHERE name = 'reach') + 300
        + greatest(max(value::float8) FILTER (WHERE name = 'merging_length'),
            (SELECT max(length) FROM ramp_override)))
        FROM setting WHERE name IN ('reach', 'merging_length') INTO metres;
    RETURN metres;
END $$;
COMMENT ON FUNCTION streetgen._merging_reach(name) IS
    'How far along a highway a place may depend on a ramp, by its merging lanes and those of others that they meet, m.';

CREATE OR REPLACE FUNCTION streetgen._ramp_axes_from_afar(model name, axes bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    SET enable_nestloop = off
    AS $$
DECLARE
    merging_reach constant float8 := streetgen._merging_reach(model);
    hull geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_ConvexHull(ST_Collect(ST_Force2D(geom))) FROM axis WHERE axis_id = ANY (axes) INTO hull;
    RETURN ARRAY(SELECT a.axis_id FROM axis a LEFT JOIN axis_class c ON c.class = a.kind
        WHERE ST_DWithin(a.geom, hull, merging_reach) AND streetgen._may_be_highway(a.kind, c.highway_role));
END $$;
COMMENT ON FUNCTION streetgen._ramp_axes_from_afar(name, bigint[]) IS
    'The highways near some axes along which merging lanes may come to them from afar.';

CREATE OR REPLACE FUNCTION streetgen._make_ramp_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _merging_run(axes bigint[]) RETURNS TABLE(edge_id bigint, axis_id bigint,
            from_node bigint, to_node bigint, geom geometry)
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
        AS $body$
    #variable_conflict use_column
    DECLARE
        reach float8;
    BEGIN
        IF to_regclass(format('%I.ramp', current_schema())) IS NULL THEN
            RETURN;
        END IF;
        reach := streetgen._merging_reach(current_schema());
        RETURN QUERY
        WITH RECURSIVE run(edge_id, node_id, metres) AS (
            SELECT e.edge_id, n.node_id, 0::float8 FROM edge e,
                LATERAL (SELECT streetgen._may_be_highway(a.kind, c.highway_role) AS highway
                    FROM axis a LEFT JOIN axis_class c ON c.class = a.kind
                    WHERE a.axis_id = e.axis_id OFFSET 0) a, unnest(ARRAY[e.from_node, e.to_node]) n(node_id)
            WHERE e.axis_id = ANY (axes) AND highway
            UNION SELECT o.edge_id, CASE o.from_node WHEN r.node_id THEN o.to_node ELSE o.from_node END,
                r.metres + ST_Length(o.geom)
            FROM run r, LATERAL (SELECT e.*, count(*) OVER () AS degree FROM (
                SELECT e.* FROM edge e WHERE e.from_node = r.node_id
                UNION ALL SELECT e.* FROM edge e WHERE e.to_node = r.node_id OFFSET 0) e) o
            WHERE r.metres < reach AND o.degree = 2 AND o.edge_id <> r.edge_id
                AND (SELECT streetgen._may_be_highway(a.kind, c.highway_role)
                    FROM axis a LEFT JOIN axis_class c ON c.class = a.kind WHERE a.axis_id = o.axis_id))
        SELECT e.edge_id, e.axis_id, e.from_node, e.to_node, e.geom FROM (SELECT DISTINCT r.edge_id FROM run r) r
            JOIN edge e USING (edge_id);
    END $body$;
    PERFORM streetgen._own_function(model, '_merging_run(bigint[])',
        'The edges of highways on which merging lanes may lie that have to do with the edges of some axes: along the '
        'highway, over nodes of two edges; those of the axes that may be highways among them. None without ramps');
END $$;
COMMENT ON FUNCTION streetgen._make_ramp_functions(name) IS
    'Makes the function of a model that tells how far merging lanes let a change reach.';
