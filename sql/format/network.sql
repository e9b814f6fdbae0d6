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

CREATE OR REPLACE FUNCTION streetgen._joined_places(model name, options jsonb) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    joined jsonb;
    inside jsonb;
BEGIN
    PERFORM streetgen._use_model(model);
    IF options ->> 'junctions' = 'group' THEN
        joined := (SELECT jsonb_object_agg(j.node_id, j.junction_id) FROM junction_node j
            WHERE j.node_id <> j.junction_id);
        inside := (SELECT jsonb_agg(j.edge_id) FROM junction_edge j);
    ELSE
        WITH place AS MATERIALIZED (SELECT g.node_id, g.group_id FROM intersection_group g)
        SELECT (SELECT jsonb_object_agg(p.node_id, p.group_id) FROM place p WHERE p.node_id <> p.group_id),
            (SELECT jsonb_agg(e.edge_id) FROM edge e JOIN place f ON f.node_id = e.from_node
                JOIN place t ON (t.node_id, t.group_id) = (e.to_node, f.group_id)
            WHERE EXISTS (SELECT FROM section s WHERE s.edge_id = e.edge_id AND s.method = 'crossed_limits')
                OR e.from_node <> e.to_node
                    AND ST_Length(e.geom) <= (SELECT value::float8 FROM setting WHERE name = 'junction_extent'))
            INTO joined, inside;
    END IF;
    RETURN jsonb_build_object('joined', coalesce(joined, '{}'), 'inside', coalesce(inside, '[]'));
END $$;
COMMENT ON FUNCTION streetgen._joined_places(name, jsonb) IS
    'What streetgen._begin_export adds to options about places, which are nodes: joined has the place of nodes that '
    'are part of another one, since limits of the edges between them cross, or since options take the nodes of a '
    'junction as one. inside lists the edges inside places: those of crossed limits, others between two nodes of one '
    'place no longer than setting junction_extent, or those inside junctions.';

CREATE OR REPLACE FUNCTION streetgen._edges_inside(options jsonb) RETURNS SETOF bigint
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 100 SET search_path = pg_catalog
    AS $$ SELECT edge_id::bigint FROM jsonb_array_elements_text(options -> 'inside') edge_id $$;
COMMENT ON FUNCTION streetgen._edges_inside(jsonb) IS 'The edges inside places, as streetgen._joined_places has them.';

CREATE OR REPLACE FUNCTION streetgen._edges_taken(model name, options jsonb) RETURNS SETOF bigint
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
        WHERE (only_level IS NULL OR e.level = only_level) AND (box IS NULL OR ST_Intersects(e.geom, box));
END $$;
COMMENT ON FUNCTION streetgen._edges_taken(name, jsonb) IS
    'The edges that options level and extent of a writer take, also those inside places.';

CREATE OR REPLACE FUNCTION streetgen._written_edges(model name, options jsonb) RETURNS SETOF bigint
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
    SELECT * FROM streetgen._edges_taken(model, options) edge_id
    WHERE edge_id NOT IN (SELECT streetgen._edges_inside(options)) $$;
COMMENT ON FUNCTION streetgen._written_edges(name, jsonb) IS
    'The edges that options of a writer take, but those inside places.';

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
#variable_conflict use_column
DECLARE
    grouped constant boolean := coalesce(options ->> 'junctions' = 'group', false);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH joined AS MATERIALIZED (
        SELECT key::bigint AS node_id, value::bigint AS place_id FROM jsonb_each_text(options -> 'joined'))
    SELECT n.node_id, p.place_id, j.junction_id, j.kind, CASE WHEN grouped THEN coalesce(j.surface, i.surface)
        ELSE i.surface END
    FROM node n LEFT JOIN intersection i USING (node_id) LEFT JOIN joined o USING (node_id)
        CROSS JOIN LATERAL (SELECT coalesce(o.place_id, n.node_id) AS place_id) p
        LEFT JOIN streetgen._junction_nodes(model) j ON j.node_id = p.place_id;
END $$;
COMMENT ON FUNCTION streetgen._places(name, jsonb) IS
    'The place that a node is part of in files for simulators, by the smallest of its nodes, as '
    'streetgen._joined_places has them. With the junction of the place and its kind, where the model knows it, and the '
    'surface of the node, or of that junction where options take its nodes as one.';

CREATE OR REPLACE FUNCTION streetgen._turn_of(angle float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN CASE WHEN cos(radians(angle)) >= 0.85 THEN 'through' WHEN cos(radians(angle)) <= -0.85 THEN 'u_turn'
        WHEN sin(radians(angle)) > 0 THEN 'left' ELSE 'right' END;
COMMENT ON FUNCTION streetgen._turn_of(float8) IS
    'The turn of an angle in degrees, positive to the left, as the core tells it of two lanes (parallel_cosine).';

CREATE OR REPLACE FUNCTION streetgen._connecting_ways(model name, options jsonb)
    RETURNS TABLE(way_kind text, way_id bigint, part integer, lane_in bigint, lane_out bigint, along_in boolean,
        along_out boolean, turn text, traffic text, geom geometry, interconnections bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    -- Merging sorts all ways out of inner lanes for each step.
    SET enable_mergejoin = off
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF options ->> 'junctions' = 'group' THEN
        RETURN QUERY SELECT CASE WHEN m.junction_movement_id IS NULL THEN 'interconnection' ELSE 'movement' END,
            coalesce(m.junction_movement_id, m.interconnections[1]), 0, m.lane_in, m.lane_out, m.along_in,
            m.along_out, m.turn, CASE m.reason WHEN 'traffic' THEN m.traffic END, m.geom, m.interconnections
            FROM movement m WHERE m.connecting;
        RETURN;
    END IF;
    RETURN QUERY WITH RECURSIVE inner_lane AS MATERIALIZED (
        SELECT lane_id, geom, ST_Length(geom) AS length
        FROM lane JOIN streetgen._edges_inside(options) i(edge_id) USING (edge_id)),
    leaving AS MATERIALIZED (
        SELECT interconnection_id, lane_in, lane_out, along_in, along_out, angle, string_to_array(traffic, '|')
            AS traffic, i.length + ST_Length(w.geom) AS length
        FROM inner_lane i JOIN interconnection w ON w.lane_in = i.lane_id WHERE connecting),
    -- Ways over inner lanes, each lane once, of as many lanes the shortest. Who may take each step may take the way.
    longer AS (
        SELECT lane_in, lane_out, along_in, along_out, angle, string_to_array(traffic, '|') AS traffic,
            ST_Length(w.geom) AS length, ARRAY[interconnection_id] AS interconnections, '{}'::bigint[] AS over
        FROM inner_lane i JOIN interconnection w ON w.lane_out = i.lane_id
        WHERE connecting AND lane_in NOT IN (SELECT lane_id FROM inner_lane)
        UNION ALL
        SELECT lane_in, lane_out, along_in, along_out, angle, traffic, length, interconnections, over
        FROM (SELECT r.lane_in, w.lane_out, r.along_in, w.along_out, r.angle + w.angle AS angle, shared.traffic,
                r.length + w.length AS length, r.interconnections || w.interconnection_id AS interconnections,
                over || w.lane_in AS over, row_number() OVER (PARTITION BY r.lane_in, r.along_in, w.lane_out,
                    w.along_out, shared.traffic ORDER BY r.length + w.length, r.interconnections) AS turn
            FROM longer r JOIN leaving w ON (w.lane_in, w.along_in) = (r.lane_out, r.along_out),
                LATERAL (SELECT CASE WHEN w.traffic IS NULL THEN r.traffic ELSE ARRAY(SELECT kind
                    FROM unnest(w.traffic) kind WHERE kind = ANY (r.traffic) IS NOT FALSE) END AS traffic) shared
            WHERE w.lane_in <> ALL (over) AND shared.traffic IS DISTINCT FROM '{}') w
        WHERE turn = 1),
    -- The shortest one from lane to lane, of those for most traffic, where none leads straight to it. A way back to its
    -- lane ends where it began, and no file can draw it.
    joined AS (
        SELECT DISTINCT ON (lane_in, along_in, lane_out, along_out) *
        FROM longer l
        WHERE lane_out NOT IN (SELECT lane_id FROM inner_lane) AND lane_out <> lane_in
            AND NOT EXISTS (SELECT FROM interconnection w WHERE connecting AND (w.lane_in, w.lane_out, w.along_in,
                w.along_out) = (l.lane_in, l.lane_out, l.along_in, l.along_out))
        ORDER BY lane_in, along_in, lane_out, along_out, cardinality(traffic) DESC NULLS FIRST, length,
            interconnections)
    SELECT 'interconnection', interconnection_id, 0, lane_in, lane_out, along_in, along_out, turn,
        CASE reason WHEN 'traffic' THEN traffic END, geom, ARRAY[interconnection_id]
    FROM interconnection WHERE connecting AND lane_in NOT IN (SELECT lane_id FROM inner_lane)
        AND lane_out NOT IN (SELECT lane_id FROM inner_lane)
    UNION ALL
    SELECT 'interconnection', way_id, (row_number() OVER (PARTITION BY way_id ORDER BY interconnections) - 1)::integer,
        lane_in, lane_out, along_in, along_out, streetgen._turn_of(angle), array_to_string(traffic, '|'), geom,
        interconnections
    FROM (SELECT j.lane_in, j.lane_out, j.along_in, j.along_out, j.angle, j.traffic, interconnections,
            interconnections[1] AS way_id, ST_MakeLine(line ORDER BY n) AS geom
        FROM joined j CROSS JOIN LATERAL unnest(interconnections) WITH ORDINALITY u(id, n)
            JOIN interconnection w ON w.interconnection_id = id LEFT JOIN inner_lane i ON i.lane_id = w.lane_in,
            LATERAL (SELECT coalesce(ST_MakeLine(CASE WHEN w.along_in THEN i.geom ELSE ST_Reverse(i.geom) END, w.geom),
                w.geom) AS line) l
        GROUP BY j.lane_in, j.lane_out, j.along_in, j.along_out, j.angle, j.traffic, interconnections) p;
END $$;
COMMENT ON FUNCTION streetgen._connecting_ways(name, jsonb) IS
    'The pairs of lanes that connect, with their turn and path, and for whom alone beside what their lanes say: across '
    'each place of streetgen._places, over the lanes inside. way_id is the key of a way_kind: interconnection, or '
    'movement. One over lanes inside a place has the first of its interconnections, which others may share: '
    'part counts these from 0.';

CREATE OR REPLACE FUNCTION streetgen._heights_of(model name, edges bigint[])
    RETURNS TABLE(edge_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'height' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT p.edge_id, p.geom FROM profile p WHERE p.edge_id = ANY (edges);
    ELSIF (SELECT m.dimension = 3 FROM streetgen.model m WHERE m.name = model) THEN
        RETURN QUERY SELECT e.edge_id, e.geom FROM edge e WHERE e.edge_id = ANY (edges);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._heights_of(name, bigint[]) IS
    'The heights of some edges: of profiles where the model computes them, else of axes that have any.';

CREATE OR REPLACE FUNCTION streetgen._heights_along(model name)
    RETURNS TABLE(edge_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT h.* FROM streetgen._heights_of(model, ARRAY(SELECT e.edge_id FROM edge e)) h;
END $$;
COMMENT ON FUNCTION streetgen._heights_along(name) IS 'The heights of all edges, as streetgen._heights_of has them.';

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
