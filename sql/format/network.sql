-- What writers read of the network of a model: edges, places and ways, as their options take them.

CREATE OR REPLACE FUNCTION streetgen._junction_nodes(model name)
    RETURNS TABLE(node_id bigint, junction_id bigint, kind text, surface geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT n.node_id, n.junction_id, j.kind, j.surface
            FROM junction_node n JOIN junction j ON j.junction_id = n.junction_id;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._junction_nodes(name) IS
    'The nodes of junctions, with kind and surface of these; none of a model that computes no junctions.';

CREATE OR REPLACE FUNCTION streetgen._edges_inside(model name, options jsonb) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF options ->> 'junctions' = 'group' THEN
        RETURN QUERY SELECT j.edge_id FROM junction_edge j;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._edges_inside(name, jsonb) IS
    'The edges inside junctions, where options take the nodes of a junction as one.';

CREATE OR REPLACE FUNCTION streetgen._written_edges(model name, options jsonb) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    only_level constant integer := options ->> 'level';
    box constant geometry := ST_MakeEnvelope((options -> 'extent' ->> 0)::float8, (options -> 'extent' ->> 1)::float8,
        (options -> 'extent' ->> 2)::float8, (options -> 'extent' ->> 3)::float8,
        (SELECT m.srid FROM streetgen.model m WHERE m.name = model));
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT e.edge_id FROM edge e
        WHERE (only_level IS NULL OR e.level = only_level) AND (box IS NULL OR ST_Intersects(e.geom, box))
            AND e.edge_id NOT IN (SELECT streetgen._edges_inside(model, options));
END $$;
COMMENT ON FUNCTION streetgen._written_edges(name, jsonb) IS 'The edges that options of a writer take.';

CREATE OR REPLACE FUNCTION streetgen._export_origin(model name, options jsonb)
    RETURNS TABLE(x float8, y float8, z float8, digits integer, tolerance float8, srid integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    given constant jsonb := CASE jsonb_typeof(options -> 'origin') WHEN 'array' THEN options -> 'origin' END;
    share constant float8 := CASE options ->> 'origin' WHEN 'middle' THEN 0.5 ELSE 0 END;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT coalesce((given ->> 0)::float8, floor(ST_XMin(box) + share * (ST_XMax(box) - ST_XMin(box))), 0),
            coalesce((given ->> 1)::float8, floor(ST_YMin(box) + share * (ST_YMax(box) - ST_YMin(box))), 0),
            coalesce((given ->> 2)::float8, 0), (options ->> 'precision')::integer, (options ->> 'tolerance')::float8,
            (SELECT m.srid FROM streetgen.model m WHERE m.name = model)
        FROM (SELECT ST_Extent(e.geom) AS box FROM edge e
            WHERE e.edge_id IN (SELECT streetgen._written_edges(model, options))) b;
END $$;
COMMENT ON FUNCTION streetgen._export_origin(name, jsonb) IS
    'The place from which a writer counts coordinates and heights, so that they stay small, with digits, tolerance and '
    'SRID. By option origin it is the lower left corner of the edges that are written, in whole metres, or their '
    'middle, or a place that is given. Its height is 0 unless given.';

CREATE OR REPLACE FUNCTION streetgen._places(model name, options jsonb)
    RETURNS TABLE(node_id bigint, place_id bigint, junction_id bigint, kind text, surface geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    grouped constant boolean := coalesce(options ->> 'junctions' = 'group', false);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT n.node_id, CASE WHEN grouped THEN coalesce(j.junction_id, n.node_id) ELSE n.node_id END,
            j.junction_id, j.kind, CASE WHEN grouped THEN coalesce(j.surface, i.surface) ELSE i.surface END
        FROM node n LEFT JOIN intersection i ON i.node_id = n.node_id
            LEFT JOIN streetgen._junction_nodes(model) j ON j.node_id = n.node_id;
END $$;
COMMENT ON FUNCTION streetgen._places(name, jsonb) IS
    'The place that a node is, or is part of where options take the nodes of a junction as one; its junction and the '
    'kind of that, where the model knows it, and the surface of the place.';

CREATE OR REPLACE FUNCTION streetgen._connecting_ways(model name, options jsonb)
    RETURNS TABLE(way_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean, turn text,
        traffic text, geom geometry, way_kind text, interconnections bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF options ->> 'junctions' = 'group' THEN
        RETURN QUERY SELECT coalesce(m.junction_movement_id, m.interconnections[1]), m.lane_in, m.lane_out, m.along_in,
            m.along_out, m.turn, CASE m.reason WHEN 'traffic' THEN m.traffic END, m.geom,
            CASE WHEN m.junction_movement_id IS NULL THEN 'interconnection' ELSE 'movement' END, m.interconnections
            FROM movement m WHERE m.connecting;
    ELSE
        RETURN QUERY SELECT i.interconnection_id, i.lane_in, i.lane_out, i.along_in, i.along_out, i.turn,
            CASE i.reason WHEN 'traffic' THEN i.traffic END, i.geom, 'interconnection', ARRAY[i.interconnection_id]
            FROM interconnection i WHERE i.connecting;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._connecting_ways(name, jsonb) IS
    'The pairs of lanes that connect, with their turn and path, and for whom alone beside what their lanes say: across '
    'each node, or across each junction where options take its nodes as one. way_id is '
    'the key of a way_kind: interconnection, or movement.';

CREATE OR REPLACE FUNCTION streetgen._lanes_without_through(model name) RETURNS TABLE(lane_id bigint, word text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT l.lane_id, w.word FROM axis a JOIN edge USING (axis_id) JOIN lane l USING (edge_id),
            streetgen._access_of_way(a.access, l.along_axis) w(word)
        WHERE a.access IS NOT NULL AND l.kind = 'general'
            AND w.word IN ('private', 'destination', 'customers', 'delivery');
END $$;
COMMENT ON FUNCTION streetgen._lanes_without_through(name) IS
    'The general lanes of streets that nobody may drive through, and the word of axis.access for them.';
