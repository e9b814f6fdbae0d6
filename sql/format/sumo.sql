-- Plain XML of SUMO: what netconvert makes a network of.

CREATE OR REPLACE FUNCTION streetgen._sumo_lane_class()
    RETURNS TABLE(kind text, allow text, disallow text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 10 SET search_path = pg_catalog
    AS $$ VALUES
    ('general', NULL, 'pedestrian tram rail_urban rail rail_electric rail_fast ship'),
    ('merging', NULL, 'pedestrian tram rail_urban rail rail_electric rail_fast ship'),
    ('bus', 'bus coach taxi emergency', NULL),
    ('carpool', 'hov bus coach taxi motorcycle emergency', NULL),
    ('cycle', 'bicycle', NULL),
    ('private', 'private emergency authority delivery bicycle', NULL),
    ('destination', 'private emergency authority delivery taxi bicycle', NULL),
    ('customers', 'private emergency authority delivery taxi bicycle', NULL),
    ('delivery', 'delivery emergency authority bicycle', NULL),
    ('closed', NULL, 'all'),
    ('parking', NULL, 'all'),
    ('sidewalk', 'pedestrian', NULL) $$;
COMMENT ON FUNCTION streetgen._sumo_lane_class() IS
    'The vehicle classes of SUMO that kinds of lanes, general ones by who may drive, and sidewalks allow, or else '
    'those that they do not. SUMO knows no street that one may drive to and not through: who has business there is of '
    'class private. Cars park on a parking lane, but none drives there.';

CREATE OR REPLACE FUNCTION streetgen._sumo_type(kind text, importance integer) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN kind IN ('motorway', 'motorway_link', 'trunk', 'trunk_link', 'primary', 'primary_link',
            'secondary', 'secondary_link', 'tertiary', 'tertiary_link', 'unclassified', 'residential', 'road',
            'living_street', 'service', 'track', 'pedestrian', 'cycleway', 'footway', 'path', 'steps', 'busway')
            THEN 'highway.' || kind
        WHEN kind IN ('runway', 'taxiway') THEN 'aeroway.' || kind
        ELSE 'highway.' || (ARRAY['trunk', 'primary', 'secondary', 'tertiary', 'residential', 'service'])
            [least(greatest(importance, 1), 6)] END;
COMMENT ON FUNCTION streetgen._sumo_type(text, integer) IS
    'The type of an edge of SUMO: that of OpenStreetMap where the street is of such a kind, else by its importance.';

CREATE OR REPLACE FUNCTION streetgen._sumo_nodes(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    written_edge AS MATERIALIZED (
        SELECT edge_id, from_node, to_node FROM edge WHERE edge_id IN (SELECT streetgen._written_edges(model,
            options))),
    -- Who is on a mini-roundabout comes from the left, and goes first; netconvert mirrors networks of left-hand
    -- traffic.
    mini AS (
        SELECT DISTINCT n.node_id FROM control_point p JOIN edge e USING (axis_id)
            JOIN node n ON n.node_id IN (e.from_node, e.to_node) AND ST_DWithin(p.geom, n.geom,
                (SELECT value::float8 FROM setting WHERE name = 'control_distance'))
        WHERE p.kind = 'mini_roundabout'),
    place AS MATERIALIZED (SELECT * FROM streetgen._places(model, options)),
    sumo_node AS (
        SELECT 2 AS turn, place_id AS id, place_id::text AS name, ST_Centroid(ST_Collect(n.geom)) AS geom,
            CASE count(*) WHEN 1 THEN (array_agg(surface))[1]
                ELSE streetgen._united_ground(array_agg(surface), 0, 0) END AS surface,
            CASE WHEN kind = 'signals' THEN 'traffic_light' WHEN kind = 'right_before_left' THEN kind
                WHEN kind = 'roundabout' AND bool_or(m.node_id IS NOT NULL) THEN 'left_before_right'
                WHEN bool_or(stops) THEN 'priority_stop' ELSE 'priority' END AS type,
            CASE WHEN kind = 'signals' THEN junction_id END AS controller
        FROM node n JOIN place USING (node_id)
        LEFT JOIN (SELECT node_id, bool_or(kind = 'stop') AS stops FROM marking
            WHERE edge_id IN (SELECT edge_id FROM written_edge) GROUP BY node_id) s USING (node_id)
        LEFT JOIN mini m USING (node_id)
        WHERE place_id IN (SELECT place_id FROM place
            WHERE node_id IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge))
        GROUP BY place_id, kind, junction_id),
    every_node AS (
        SELECT * FROM sumo_node
        UNION ALL SELECT 3, lane_group_id, comes_from, ST_LineInterpolatePoint(geom, since), NULL, 'priority', NULL
        FROM streetgen._sumo_edges(model, options, true, true) WHERE since > 0)
    SELECT 1, 0::bigint, xmlelement(name location, xmlattributes(
        round(-x::numeric, 2) || ',' || round(-y::numeric, 2) AS "netOffset", '0,0,0,0' AS "convBoundary",
        '0,0,0,0' AS "origBoundary", coalesce(nullif(trim(proj4text), ''), '!') AS "projParameter"))::text
    FROM origin JOIN spatial_ref_sys USING (srid)
    UNION ALL
    -- Our names and numbers need no escape. As text they cost half as much as XML elements.
    SELECT turn, id, concat('<node id="', name, '" x="', east, '" y="', north, '" type="', type,
        '" tl="' || controller,
        CASE WHEN type NOT IN ('right_before_left', 'left_before_right') THEN '" rightOfWay="edgePriority' END,
        '" shape="', east - far, ',', north - far, ' ', east + far, ',', north - far, ' ', east + far, ',',
        north + far, ' ', east - far, ',', north + far, '"',
        coalesce('><param key="surface" value="' || CASE WHEN surface IS NOT NULL AND NOT ST_IsEmpty(surface) THEN
            streetgen._coordinates(ST_ExteriorRing(CASE ST_NumGeometries(surface)
                WHEN 1 THEN ST_GeometryN(surface, 1)
                ELSE (SELECT geom FROM ST_Dump(surface) ORDER BY ST_Area(geom) DESC LIMIT 1) END), x, y, digits, 0)
            END || '"/></node>', '/>'))
    -- No lane reaches the border of so wide a shape, about the node: where it does, netconvert cuts lanes.
    FROM origin, every_node n, (SELECT 100000 AS far) f, LATERAL (SELECT round((ST_X(n.geom) - x)::numeric, digits)
        AS east, round((ST_Y(n.geom) - y)::numeric, digits) AS north) p;
END $$;
COMMENT ON FUNCTION streetgen._sumo_nodes(name, jsonb) IS 'The elements of a plain file of SUMO: the nodes.';

CREATE OR REPLACE FUNCTION streetgen._sumo_streets(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    sumo_edge AS MATERIALIZED (
        SELECT e.*, CASE WHEN until - since < 1 THEN ST_LineSubstring(geom, since, until) ELSE geom END AS line
        FROM streetgen._sumo_edges(model, options, true, false) e),
    -- Who waits leaves the crossing free.
    held_back AS (
        SELECT s.name, max(least(ST_Length(s.line) * (1 - ST_LineLocatePoint(s.line, ST_Centroid(c.line))) + along / 2
            + 0.5, ST_Length(s.line) / 2)) AS back
        FROM streetgen._sumo_crossings(model, options) c CROSS JOIN LATERAL unnest(c.names) n(name)
            JOIN sumo_edge s ON s.name = n.name
        WHERE marked AND s.until = 1 AND s.goes_to = c.place_id::text AND ST_Intersects(s.line, c.line)
        GROUP BY s.name),
    lane_line AS MATERIALIZED (
        SELECT name, index, c.allow, c.disallow, l.width,
            CASE WHEN until - since < 1 AND NOT within THEN ST_LineSubstring(driven, since, until) ELSE driven END
                AS line
        FROM (SELECT name, i - 1 + walk AS index, since, until, width,
                start_abscissa IS NOT NULL OR end_abscissa IS NOT NULL AS within,
                CASE WHEN e.along_axis THEN l.geom ELSE ST_Reverse(l.geom) END AS driven,
                -- Nobody changes to a lane that is closed to him: one between lanes of cars is open, to be crossed.
                CASE WHEN l.kind IN ('bus', 'carpool') AND (SELECT bool_or(j < i) AND bool_or(j > i)
                    FROM unnest(e.lanes) WITH ORDINALITY o(lane_id, j) JOIN lane USING (lane_id)
                    WHERE lane.kind = 'general') THEN 'general'
                    ELSE coalesce(t.word, l.kind) END AS kind
            FROM sumo_edge e CROSS JOIN LATERAL streetgen._few(e.lanes) WITH ORDINALITY m(lane_id, i)
                JOIN lane l USING (lane_id) LEFT JOIN streetgen._lanes_without_through(model) t USING (lane_id)
            UNION ALL SELECT name, 0, since, until, walk_width, false, walk_line, 'sidewalk'
            FROM sumo_edge WHERE walk = 1) l
        JOIN streetgen._sumo_lane_class() c USING (kind)),
    -- Words of users are escaped: of <a name="…"/> what stands between the name and the end.
    street AS MATERIALIZED (
        SELECT e.edge_id, 100 - e.importance AS priority, e.speed, streetgen._sumo_type(a.kind, e.importance) AS type,
            left(substr(xmlelement(name a, xmlattributes(streetgen._xml_text(a.name) AS name))::text, 3), -2) AS named,
            xmlelement(name param, xmlattributes('origId' AS key, streetgen._xml_text(
                coalesce(a.source_ref, a.axis_id::text)) AS value))::text AS origin_id
        FROM edge e LEFT JOIN axis a USING (axis_id)),
    lane_element AS (
        SELECT l.name, string_agg('<lane index="' || index || coalesce('" allow="' || allow, '')
            || coalesce('" disallow="' || disallow, '') || '" width="' || round(l.width::numeric, digits)
            || coalesce('" shape="' || streetgen._coordinates(streetgen._at_least_long(l.line, 0.16), x, y, digits,
                tolerance), '') || '">' || origin_id || '</lane>', '' ORDER BY index) AS elements,
            -- netconvert counts a length that is not said whenever it reads, by lanes that it leads on to corners.
            greatest(avg(ST_Length(l.line)), 0.16) AS metres
        FROM origin, lane_line l JOIN sumo_edge USING (name) JOIN street USING (edge_id) GROUP BY l.name)
    SELECT 1, lane_group_id, concat('<edge id="', s.name, '" from="', comes_from, '" to="', goes_to, '" type="', type,
        '" priority="', priority, '" numLanes="', s.lane_count + walk, '" speed="',
        round(e.speed::numeric / 3.6, 2), '"', named, ' length="', round(metres::numeric, 2), '" spreadType="center',
        '" shape="' || streetgen._coordinates(streetgen._at_least_long(line, 0.16), x, y, digits, 0.01), '">', elements,
        '<stopOffset value="' || round(back::numeric, digits) || '"/>',
        CASE WHEN s.until = 1 AND (s.edge_id, s.along_axis) IN (SELECT edge_id, along_axis FROM marking
            WHERE kind = 'stop') THEN '<param key="waits" value="stop"/>' END, '</edge>')
    FROM origin, sumo_edge s JOIN lane_element USING (name) LEFT JOIN held_back USING (name)
        JOIN street e USING (edge_id)
    UNION ALL
    SELECT 2, roundabout_id, xmlelement(name roundabout, xmlattributes(
        string_agg(comes_from, ' ' ORDER BY ordinality) AS nodes,
        string_agg(s.name, ' ' ORDER BY ordinality) AS edges))::text
    FROM streetgen._ring_edges(model) r LEFT JOIN sumo_edge s ON s.edge_id = r.edge_id
        AND s.along_axis = r.along_axis AND s.lane_count > 0
    WHERE r.edge_id NOT IN (SELECT streetgen._edges_inside(options))
    GROUP BY roundabout_id, face
    -- A part of a ring goes round nothing.
    HAVING count(DISTINCT comes_from) = count(*);
END $$;
COMMENT ON FUNCTION streetgen._sumo_streets(name, jsonb) IS
    'The elements of a plain file of SUMO: the edges with their lanes, and the accepted roundabouts all of whose edges '
    'are written, each face of a double one by itself. A bus or carpool lane between lanes for all is one of '
    'these. '
    'Parameter waits says stop where a stop line is: netconvert knows such lines of a whole node only.';

CREATE OR REPLACE FUNCTION streetgen._sumo_going_on(model name, options jsonb)
    RETURNS TABLE(id bigint, name_in text, name_out text, index_in bigint, index_out bigint, goes_to text,
        traffic text, geom geometry, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH placed AS MATERIALIZED (
        SELECT lane_id, e.edge_id, e.along_axis, e.name, e.comes_from, e.goes_to, e.since, e.until,
            e.since = 0 AS begins, e.until = 1 AS ends, i - 1 + e.walk AS index, l.kind
        FROM streetgen._sumo_edges(model, options, false, false) e CROSS JOIN LATERAL
            streetgen._few(e.lanes) WITH ORDINALITY m(lane_id, i) JOIN lane l USING (lane_id)),
    going_on AS MATERIALIZED (
        SELECT k.way_id, a.name AS name_in, b.name AS name_out, a.index AS index_in, b.index AS index_out, a.goes_to,
            k.traffic, CASE WHEN k.lane_in <> k.lane_out THEN k.geom END, k.lane_in, k.lane_out, k.along_in,
            k.along_out
        -- netconvert draws the way from a lane back to it anew, since it ends where it began.
        FROM streetgen._connecting_ways(model, options) k
            JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in) AND a.ends
            JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out) AND b.begins)
    TABLE going_on
    UNION ALL SELECT 0, a.name, b.name, a.index, b.index, a.goes_to, NULL, NULL, NULL, NULL, NULL, NULL
    FROM placed a JOIN placed b USING (lane_id, along_axis) WHERE NOT a.ends AND a.until = b.since
    -- Cars that find no way on turn back, from lane to lane in the middle of the street.
    UNION ALL SELECT * FROM (
        SELECT DISTINCT ON (a.name) 0::bigint, a.name, b.name, a.index, b.index, a.goes_to, NULL::text, NULL::geometry,
            NULL::bigint, NULL::bigint, NULL::boolean, NULL::boolean
        FROM placed a JOIN placed b ON a.edge_id = b.edge_id AND a.along_axis <> b.along_axis
        WHERE a.ends AND b.begins AND a.goes_to = b.comes_from AND (a.kind, b.kind) = ('general', 'general')
            -- Few names are expected, and looked up.
            AND a.name NOT IN (SELECT DISTINCT g.name_in FROM going_on g)
        ORDER BY a.name, a.index DESC, b.index DESC) t;
END $$;
COMMENT ON FUNCTION streetgen._sumo_going_on(name, jsonb) IS
    'Which lane of an edge of SUMO goes on to which lane of another: by a way with its path, but back to its lane, and '
    'the lanes of the model, or, with id 0, from part to part of one street, and back where a street ends or leads on '
    'for nobody.';

CREATE OR REPLACE FUNCTION streetgen._sumo_connections(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    sumo_edge AS MATERIALIZED (
        SELECT name, lane_group_id, comes_from, goes_to FROM streetgen._sumo_edges(model, options, false, false)
        WHERE lane_count > 0),
    going_on AS MATERIALIZED (SELECT * FROM streetgen._sumo_going_on(model, options))
    SELECT 1, id, '<connection from="' || name_in || '" to="' || name_out || '" fromLane="' || index_in
        || '" toLane="' || index_out
        -- Who waits within a junction does not see who comes beside him into his lane: these wait before it.
        || CASE WHEN (name_in, name_out, index_out) IN (SELECT name_in, name_out, index_out FROM going_on
            GROUP BY 1, 2, 3 HAVING count(*) > 1) THEN '" contPos="0' ELSE '' END
        || coalesce('" allow="' || (SELECT string_agg(allow, ' ') FROM streetgen._sumo_lane_class() c
            WHERE c.kind = ANY (string_to_array(k.traffic, '|'))), '')
        || coalesce('" shape="' || CASE WHEN ST_Length(k.geom) > 0.05
            THEN streetgen._coordinates(k.geom, x, y, digits, tolerance) END, '') || '"/>'
    FROM origin, going_on k
    UNION ALL
    -- What is not said is invented: an edge without a way on goes into none.
    SELECT 2, a.lane_group_id, '<delete from="' || a.name || '" to="' || b.name || '"/>'
    FROM sumo_edge a JOIN sumo_edge b ON b.comes_from = a.goes_to
    WHERE NOT EXISTS (SELECT FROM going_on WHERE name_in = a.name)
    UNION ALL
    SELECT 3, c.edge_id, xmlelement(name crossing, xmlattributes(c.place_id AS node,
        array_to_string(names, ' ') AS edges, (marked OR controller_id IS NOT NULL)::integer AS priority,
        round(along::numeric, digits) AS width,
        number + links AS "linkIndex", streetgen._coordinates(c.line, x, y, digits, 0) AS shape))::text
    FROM origin, streetgen._sumo_crossings(model, options) c LEFT JOIN (
        SELECT junction_id AS controller_id, count(*) AS links
        FROM going_on JOIN (SELECT DISTINCT place_id::text AS goes_to, junction_id
            FROM streetgen._places(model, options) WHERE kind = 'signals') p USING (goes_to)
        WHERE lane_in IS NOT NULL GROUP BY junction_id) k USING (controller_id);
END $$;
COMMENT ON FUNCTION streetgen._sumo_connections(name, jsonb) IS
    'The elements of a plain file of SUMO: the connections, and the crossings.';

CREATE OR REPLACE FUNCTION streetgen._sumo_types(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 1, row_number() OVER (ORDER BY type COLLATE "C"), xmlelement(name type, xmlattributes(
        type AS id, 100 - min(importance) AS priority, round(max(speed)::numeric / 3.6, 2) AS speed))::text
    FROM (SELECT streetgen._sumo_type(a.kind, e.importance) AS type, e.importance, e.speed
        FROM edge e JOIN axis a USING (axis_id)
        WHERE e.edge_id IN (SELECT streetgen._written_edges(model, options))) t
    GROUP BY type;
END $$;
COMMENT ON FUNCTION streetgen._sumo_types(name, jsonb) IS
    'The elements of a plain file of SUMO: the types of edges, with the most important and the fastest of each.';

CREATE OR REPLACE FUNCTION streetgen.export_sumo(model name, part text, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'sumo', 'interconnection', options);
    parts constant text[] := '{nodes,edges,connections,types,tlLogics,additional}';
BEGIN
    PERFORM streetgen._check_given('part', part);
    IF part <> ALL (parts) THEN
        RAISE EXCEPTION 'format sumo has no part "%"', part USING ERRCODE = '22023',
            HINT = 'Its parts are ' || array_to_string(parts, ', ') || '.';
    END IF;
    RETURN QUERY SELECT row_number() OVER (ORDER BY rank, ref, text), text
        FROM (SELECT rank, ref, ('    ' || markup) COLLATE "C" AS text FROM (
                SELECT * FROM streetgen._sumo_nodes(model, known) WHERE part = 'nodes'
                UNION ALL SELECT * FROM streetgen._sumo_streets(model, known) WHERE part = 'edges'
                UNION ALL SELECT * FROM streetgen._sumo_connections(model, known) WHERE part = 'connections'
                UNION ALL SELECT * FROM streetgen._sumo_types(model, known) WHERE part = 'types'
                UNION ALL SELECT * FROM streetgen._sumo_signals(model, known) WHERE part = 'tlLogics'
                UNION ALL SELECT * FROM streetgen._sumo_stands(model, known) WHERE part = 'additional') e
            UNION ALL SELECT rank, ref, markup COLLATE "C" FROM streetgen._xml_frame(format('<%s xmlns:xsi='
                '"http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation='
                '"http://sumo.dlr.de/xsd/%s_file.xsd">', part, CASE part WHEN 'tlLogics' THEN 'tllogic' ELSE part END),
                format('</%s>', part))) l
        ORDER BY rank, ref, text;
END $$;
COMMENT ON FUNCTION streetgen.export_sumo(name, text, jsonb) IS
    'A plain file of SUMO, line by line, of which netconvert makes a network: part nodes, edges, connections, types or '
    'tlLogics; or part additional, bus stops and parking areas beside the lanes of that network. '
    'An edge is a lane group: edge_id along the axis, -edge_id against it; a loop is two, the second one '
    'ends in .end. '
    'Its lanes have the lines, widths and vehicle classes of the model, and lane 0 is at the kerb. A connection is an '
    'interconnection that connects, with its path. Nodes between which limits cross are one node, and several '
    'interconnections over it one connection. An edge without a way on leads back to the other direction of its '
    'street, or is parted from all that leave its node, since netconvert invents what is not said. '
    'With subject sidewalk, a sidewalk is lane 0 of its edge, or an edge '
    'edge_id.walk beside no lane of its direction, and so is a strip on the roadway where a street has none. Crossings '
    'from corner to corner are written (connections), unmarked ones with priority 0. A '
    'node has the intersection as parameter surface; its shape is so wide '
    'that no lane reaches its border, since netconvert cuts lanes there. '
    'With subject junction, junctions of kind signals are '
    'traffic lights, with subject signal by the programs of the model (tlLogics), and the nodes of a junction can be '
    'one. With it, who comes from the left goes first at a mini-roundabout (left_before_right), or from the right '
    'where one drives on the left. With subject roundabout, accepted rings are roundabouts (edges). '
    'Coordinates are counted from whole metres, which location says. options as streetgen.export_option() lists '
    'them: an unknown one, another '
    'part, or no edge that they take: 22023. A caller who may not read the model: 42501; a model without '
    'interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a warning.';
