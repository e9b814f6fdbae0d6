-- The network as PostGIS topologies, one a level: all primitives of a level are written by one statement.

CREATE OR REPLACE FUNCTION streetgen._check_planar(model name, level integer) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    SELECT e.edge_id, e.axis_id INTO bad FROM pg_temp._topology_edge e WHERE NOT ST_IsSimple(e.geom)
        ORDER BY e.edge_id LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'edge % of axis % crosses or touches itself on level %', bad.edge_id, bad.axis_id, level
            USING ERRCODE = '55000',
            HINT = 'A topology has a node there: cut the axis at that place, then generate.';
    END IF;
    -- Ends are boundary also of a closed edge: rule 2.
    SELECT a.edge_id AS edge_a, a.axis_id AS axis_a, b.edge_id AS edge_b, b.axis_id AS axis_b,
        r.matrix LIKE '1%' AS overlap INTO bad
        FROM pg_temp._topology_edge a JOIN pg_temp._topology_edge b ON a.edge_id < b.edge_id AND a.geom && b.geom,
            ST_Relate(a.geom, b.geom, 2) r(matrix)
        WHERE NOT ST_RelateMatch(r.matrix, 'FF*F*****') ORDER BY 1, 3 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'edge % of axis % and edge % of axis % % on level %', bad.edge_a, bad.axis_a, bad.edge_b,
            bad.axis_b,
            CASE WHEN bad.overlap THEN 'run along each other' ELSE 'meet without a node' END, level
                USING ERRCODE = '55000',
            HINT = CASE WHEN bad.overlap THEN 'Delete one of the axes or cut away what they share, then generate.'
                   ELSE format('SELECT streetgen.set(%L, ''crossing'', ''split''), then generate: it makes the node.',
                       model) END;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_planar(name, integer) IS
    'Raises 55000, naming the first, where edges about to be exported meet elsewhere than at their nodes.';

CREATE OR REPLACE FUNCTION streetgen._topology_edges()
    RETURNS TABLE(edge_id bigint, start_node bigint, end_node bigint, next_left_edge bigint, next_right_edge bigint,
        left_face bigint, right_face bigint, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    -- Nothing is known of rows just computed: joins are on equal keys, or by an index.
    SET enable_nestloop = off
    AS $$
#variable_conflict use_column
BEGIN
    -- Each edge from both its ends; a half edge walks with its face on the left.
    RETURN QUERY WITH half AS MATERIALIZED (
        SELECT edge_id AS half_id, edge_id, from_node AS node_id, ST_StartPoint(geom) AS p, ST_PointN(geom, 2) AS q
            FROM pg_temp._topology_edge
        UNION ALL SELECT -edge_id, edge_id, to_node, ST_EndPoint(geom), ST_PointN(geom, -2)
            FROM pg_temp._topology_edge),
    -- Who arrives turns left as far as can be: the half edge that leaves next clockwise from the one reversed.
    turn AS (
        SELECT half_id, coalesce(lead(half_id) OVER around, first_value(half_id) OVER around) AS clockwise
        FROM half WINDOW around AS (PARTITION BY node_id ORDER BY ST_Azimuth(p, q))),
    -- Shells counter-clockwise, holes clockwise: every segment has its face on the left.
    face_segment AS (SELECT face_id, ST_StartPoint(s.geom) AS p, ST_EndPoint(s.geom) AS q FROM pg_temp._topology_face f,
        ST_DumpSegments(f.geom) s),
    bounding AS MATERIALIZED (
        SELECT half_id, edge_id, face_id FROM half JOIN face_segment s
            ON (ST_X(half.p), ST_Y(half.p), ST_X(half.q), ST_Y(half.q)) = (ST_X(s.p), ST_Y(s.p), ST_X(s.q), ST_Y(s.q))),
    -- An edge that bounds no face lies inside one, or outside all.
    inside AS (
        SELECT edge_id, face_id FROM (SELECT edge_id, p, q FROM half WHERE half_id > 0
            AND edge_id NOT IN (SELECT edge_id
            FROM bounding)) e
        JOIN pg_temp._topology_face f ON ST_Contains(f.geom, ST_LineInterpolatePoint(ST_MakeLine(p, q), 0.5))),
    left_of AS (
        SELECT half_id, coalesce(bounding.face_id, inside.face_id, 0) AS face_id
        FROM half LEFT JOIN bounding USING (half_id) LEFT JOIN inside ON inside.edge_id = half.edge_id)
    SELECT edge_id, from_node, to_node, at_end.clockwise, at_start.clockwise, on_left.face_id, on_right.face_id, geom
    FROM pg_temp._topology_edge JOIN turn at_start ON at_start.half_id = edge_id
        JOIN turn at_end ON at_end.half_id = -edge_id
        JOIN left_of on_left ON on_left.half_id = edge_id JOIN left_of on_right ON on_right.half_id = -edge_id
    ORDER BY edge_id;
END $$;
COMMENT ON FUNCTION streetgen._topology_edges() IS
    'The edges about to be exported, as PostGIS topology has them: with the next edges and the faces at both sides.';

CREATE OR REPLACE FUNCTION streetgen.export_topology(model name, topology text)
    RETURNS TABLE(name name, level integer, nodes bigint, edges bigint, faces bigint, doubled bigint[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Nothing is known of rows just computed: joins are on equal keys, or by an index.
    SET enable_nestloop = off
    AS $$
DECLARE
    target record;
    wanted text;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('topology', topology), streetgen._check_topology();
    SELECT m.srid, m.dimension = 3 AS has_z INTO target FROM streetgen.model m WHERE m.name = model;
    FOR level IN SELECT DISTINCT e.level FROM edge e ORDER BY e.level LOOP
        wanted := topology || CASE WHEN level > 0 THEN '_' || level WHEN level < 0 THEN '_m' || -level ELSE '' END;
        IF octet_length(wanted) > 63 THEN
            RAISE EXCEPTION 'the name "%" of the topology of level % is longer than 63 bytes', wanted, level
                USING ERRCODE = '42622', HINT = 'Choose a shorter name.';
        ELSIF topology = '' THEN
            RAISE EXCEPTION 'the topology needs a name' USING ERRCODE = '22023',
                HINT = 'It names a schema; levels above and below the ground add _1 and _m1 to it.';
        END IF;
        name := wanted;
        CREATE TEMPORARY TABLE _topology_edge ON COMMIT DROP AS
            SELECT DISTINCT ON (l.line) e.edge_id, e.axis_id, e.from_node, e.to_node, e.geom
            FROM edge e, ST_Force2D(e.geom) flat,
                LATERAL (SELECT least(flat::bytea, ST_Reverse(flat)::bytea) AS line) l
            WHERE e.level = export_topology.level ORDER BY l.line, e.edge_id;
        CREATE INDEX ON pg_temp._topology_edge USING gist (geom);
        ANALYZE pg_temp._topology_edge;
        PERFORM streetgen._check_planar(model, level);
        CREATE TEMPORARY TABLE _topology_face ON COMMIT DROP AS
            SELECT row_number() OVER () AS face_id, ST_ForcePolygonCCW(d.geom) AS geom
            FROM (SELECT ST_Polygonize(ST_Force2D(e.geom) ORDER BY e.edge_id) AS geom FROM pg_temp._topology_edge e) f,
                ST_Dump(f.geom) d;
        CREATE INDEX ON pg_temp._topology_face USING gist (geom);
        doubled := (SELECT array_agg(e.edge_id ORDER BY e.edge_id) FROM edge e WHERE e.level = export_topology.level
            AND NOT EXISTS (SELECT FROM pg_temp._topology_edge t WHERE t.edge_id = e.edge_id));
        PERFORM topology.CreateTopology(name::varchar, target.srid, 0, target.has_z);
        EXECUTE format('INSERT INTO %I.face (face_id, mbr) SELECT face_id, ST_Envelope(geom) '
            'FROM pg_temp._topology_face', name);
        GET DIAGNOSTICS faces = ROW_COUNT;
        EXECUTE format('INSERT INTO %I.node (node_id, geom) SELECT node_id, geom FROM node WHERE node_id IN (SELECT '
            'unnest(ARRAY[from_node, to_node]) FROM pg_temp._topology_edge) ORDER BY node_id', name);
        GET DIAGNOSTICS nodes = ROW_COUNT;
        EXECUTE format('INSERT INTO %I.edge_data (edge_id, start_node, end_node, next_left_edge, abs_next_left_edge, '
            'next_right_edge, abs_next_right_edge, left_face, right_face, geom) SELECT edge_id, start_node, end_node, '
            'next_left_edge, abs(next_left_edge), next_right_edge, abs(next_right_edge), left_face, right_face, geom '
            'FROM streetgen._topology_edges()', name);
        GET DIAGNOSTICS edges = ROW_COUNT;
        PERFORM setval(format('%I.node_node_id_seq', name)::regclass, (SELECT max(greatest(e.from_node, e.to_node))
                FROM pg_temp._topology_edge e)),
            setval(format('%I.edge_data_edge_id_seq', name)::regclass, (SELECT max(e.edge_id)
                FROM pg_temp._topology_edge e)),
            setval(format('%I.face_face_id_seq', name)::regclass, (SELECT max(f.face_id)
                FROM pg_temp._topology_face f));
        DROP TABLE pg_temp._topology_edge, pg_temp._topology_face;
        RETURN NEXT;
    END LOOP;
    IF name IS NULL THEN
        RAISE EXCEPTION 'model "%" has no edges', model USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.generate(%L) makes them.', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen.export_topology(name, text) IS
    'Writes the network into new PostGIS topologies, one a level, with the ids of edge and node: level 0 into '
    'topology, level 1 into topology_1, level -1 into topology_m1. Returns a row for each; doubled lists the edges '
    'left out because another lies on them. Edges that meet without a node: 55000, naming the first; an existing '
    'schema: 42P06; a name longer than 63 bytes: 42622; no postgis_topology: 0A000.';
