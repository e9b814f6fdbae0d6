-- Plain XML of SUMO: what netconvert makes a network of.

CREATE OR REPLACE FUNCTION streetgen._sumo_lane_class()
    RETURNS TABLE(kind text, allow text, disallow text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('general', NULL, 'pedestrian tram rail_urban rail rail_electric rail_fast ship'),
    ('merging', NULL, 'pedestrian tram rail_urban rail rail_electric rail_fast ship'),
    ('bus', 'bus coach taxi emergency', NULL),
    ('cycle', 'bicycle', NULL),
    ('parking', NULL, 'all'),
    ('sidewalk', 'pedestrian', NULL) $$;
COMMENT ON FUNCTION streetgen._sumo_lane_class() IS
    'The vehicle classes of SUMO that kinds of lanes and sidewalks allow, or else those that they do not. Cars park on '
    'a parking lane, but none drives there.';

CREATE OR REPLACE FUNCTION streetgen._sumo_parts() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    -- Lanes of a group are ordered from the kerb on.
    AS $$ SELECT $part$
        WITH merging AS (
            SELECT m.lane_id, m.lane_position, CASE WHEN g.along_axis THEN s ELSE 1 - t END AS since,
                CASE WHEN g.along_axis THEN t ELSE 1 - s END AS until, (m.side = 'right') = (g.along_axis = (
                    SELECT value IS DISTINCT FROM 'left' FROM %1$I.setting WHERE name = 'driving_side')) AS at_kerb
            FROM %1$I.lane m JOIN %1$I.lane_extent x ON x.lane_id = g.lanes[1],
                LATERAL (SELECT
                    coalesce((m.start_abscissa - x.start_abscissa) / (x.end_abscissa - x.start_abscissa), 0) AS s,
                    coalesce((m.end_abscissa - x.start_abscissa) / (x.end_abscissa - x.start_abscissa), 1) AS t) e
            WHERE m.edge_id = g.edge_id AND m.along_axis = g.along_axis AND m.kind = 'merging' AND x.end_abscissa
                > x.start_abscissa AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)),
        cut AS (
            SELECT share, row_number() OVER (ORDER BY share) AS k, count(*) OVER () - 1 AS parts,
                lead(share) OVER (ORDER BY share) AS until
            FROM (SELECT 0.0::float8 AS share UNION SELECT 1 UNION SELECT 0.5 WHERE from_place = to_place
                UNION SELECT since FROM merging UNION SELECT until FROM merging) s),
        named AS (
            SELECT *, text || CASE k WHEN 1 THEN '' WHEN parts THEN '.end' ELSE '.' || k END AS name,
                'middle.' || text || CASE WHEN parts > 2 THEN '.' || k ELSE '' END AS next
            FROM cut WHERE until IS NOT NULL)
        SELECT name, coalesce(lag(next) OVER w, from_place::text) AS comes_from,
            CASE k WHEN parts THEN to_place::text ELSE next END AS goes_to, share AS since, until,
            ARRAY(SELECT lane_id FROM merging m WHERE at_kerb AND m.since <= n.share AND m.until >= n.until
                ORDER BY lane_position * CASE WHEN along_axis THEN -1 ELSE 1 END)
            || lanes || ARRAY(SELECT lane_id FROM merging m WHERE NOT at_kerb AND m.since <= n.share
                AND m.until >= n.until ORDER BY lane_position * CASE WHEN along_axis THEN -1 ELSE 1 END) AS lanes,
            lane_count + (SELECT count(*) FROM merging m WHERE m.since <= n.share AND m.until >= n.until)::integer
                AS lane_count
        FROM named n WINDOW w AS (ORDER BY k)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_parts() IS
    'Query of the parts of a lane group g for SUMO, where a model computes ramps: a merging lane begins or ends '
    'between two parts, and nobody goes on from its end.';

CREATE OR REPLACE FUNCTION streetgen._sumo_edge(subjects text[], line text, loops boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._export_sidewalks('sidewalk' = ANY (subjects)) || $part$,
-- A sidewalk is a lane of the edge at whose kerb it lies; beside no lane of its direction it is an edge by itself.
grouped AS MATERIALIZED (
    SELECT g.lane_group_id, g.edge_id, g.along_axis, g.from_node, g.to_node, g.lanes, g.lane_count,
        $part$ || CASE line WHEN 'NULL' THEN 'NULL::geometry' ELSE 'g.geom' END || $part$ AS geom,
        streetgen._lane_group_text(g.edge_id, g.along_axis, number) AS text, (w.lane_id IS NOT NULL)::integer AS walk
    FROM %1$I.lane_group g LEFT JOIN sidewalk_beside w
        ON (w.edge_id, w.along_axis, w.lane_id) = (g.edge_id, g.along_axis, g.lanes[1])
    WHERE $part$ || CASE WHEN loops AND 'ramp' <> ALL (subjects) THEN $part$g.edge_id = ANY (ARRAY(
            SELECT edge_id FROM written_edge e JOIN place f ON f.node_id = from_node JOIN place t ON t.node_id = to_node
            WHERE f.place_id = t.place_id))$part$
        ELSE 'g.edge_id IN (SELECT edge_id FROM written_edge)' END || $part$),
carried AS (
    SELECT * FROM grouped
    UNION ALL SELECT 2 * lane_id, w.edge_id, w.along_axis, CASE WHEN w.along_axis THEN from_node ELSE to_node END,
        CASE WHEN w.along_axis THEN to_node ELSE from_node END, '{}', 0,
        CASE WHEN w.along_axis THEN w.line ELSE ST_Reverse(w.line) END,
        streetgen._lane_group_text(w.edge_id, w.along_axis, 1) || '.walk', 1
    FROM sidewalk_beside w JOIN written_edge e USING (edge_id)
    WHERE NOT EXISTS (SELECT FROM grouped g
        WHERE (g.edge_id, g.along_axis, g.lanes[1]) = (w.edge_id, w.along_axis, w.lane_id))),
-- netconvert knows no edge that comes back to its node: a loop is two, with a node in the middle.
sumo_edge AS MATERIALIZED (
    SELECT lane_group_id, edge_id, along_axis, walk, v.*, $part$ || line || $part$ AS line
    FROM (SELECT c.*, f.place_id AS from_place, t.place_id AS to_place
        FROM carried c JOIN place f ON f.node_id = from_node JOIN place t ON t.node_id = to_node) g,
    LATERAL ($part$ || CASE WHEN 'ramp' = ANY (subjects) THEN streetgen._sumo_parts() ELSE $part$
        SELECT CASE k WHEN 1 THEN text ELSE text || '.end' END AS name,
            CASE k WHEN 1 THEN from_place::text ELSE 'middle.' || text END AS comes_from,
            CASE WHEN k = 1 AND loop THEN 'middle.' || text ELSE to_place::text END AS goes_to,
            CASE k WHEN 1 THEN 0.0 ELSE 0.5 END::float8 AS since,
            CASE WHEN k = 1 AND loop THEN 0.5 ELSE 1 END::float8 AS until, lanes, lane_count
        -- Written so that the planner counts one part a lane group.
        FROM (VALUES (1), (2)) part(k), LATERAL (SELECT from_place = to_place AS loop) l
        WHERE CASE k WHEN 1 THEN true ELSE loop END$part$ END || $part$) v
    WHERE $part$ || CASE WHEN loops AND 'ramp' <> ALL (subjects) THEN 'from_place = to_place' ELSE 'true' END
        || $part$)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_edge(text[], text, boolean) IS
    'Query sumo_edge of the files of SUMO over a model that computes these subjects: the edges that lane groups and '
    'sidewalks are. Each has the nodes that traffic comes from and goes to. It begins and ends at shares of the length '
    'of its group, and walk counts its sidewalks (0 or 1). line is SQL, NULL where none is needed. loops: of edges in '
    'parts alone.';

CREATE OR REPLACE FUNCTION streetgen._sumo_nodes(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._sumo_edge(subjects, 'geom', true) || $part$,
-- Who is on a mini-roundabout comes from the left, and goes first; netconvert mirrors networks of left-hand traffic.
mini AS (
    SELECT DISTINCT n.node_id FROM %1$I.control_point p JOIN %1$I.edge e USING (axis_id)
        JOIN %1$I.node n ON n.node_id IN (e.from_node, e.to_node) AND ST_DWithin(p.geom, n.geom,
            (SELECT value::float8 FROM %1$I.setting WHERE name = 'control_distance'))
    WHERE p.kind = 'mini_roundabout'),
sumo_node AS (
    SELECT DISTINCT ON (place_id) 2 AS turn, place_id AS id, place_id::text AS name, n.geom, surface,
        CASE WHEN kind = 'signals' THEN 'traffic_light' WHEN kind = 'right_before_left' THEN kind
            WHEN kind = 'roundabout' AND bool_or(m.node_id IS NOT NULL) OVER (PARTITION BY place_id)
                THEN 'left_before_right'
            WHEN bool_or(stops) OVER (PARTITION BY place_id) THEN 'priority_stop' ELSE 'priority' END AS type,
        CASE WHEN kind = 'signals' THEN junction_id END AS controller
    FROM %1$I.node n JOIN place USING (node_id)
    LEFT JOIN (SELECT node_id, bool_or(kind = 'stop') AS stops FROM %1$I.marking
        WHERE edge_id IN (SELECT edge_id FROM written_edge) GROUP BY node_id) s USING (node_id)
    LEFT JOIN mini m USING (node_id)
    WHERE node_id IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge)
    ORDER BY place_id, node_id),
every_node AS (
    SELECT * FROM sumo_node
    UNION ALL SELECT 3, lane_group_id, comes_from, ST_LineInterpolatePoint(line, since), NULL, 'priority', NULL
    FROM sumo_edge WHERE since > 0),
line AS (
    SELECT 1 AS turn, 0::bigint AS id, xmlelement(name location, xmlattributes(
        round(-x::numeric, 2) || ',' || round(-y::numeric, 2) AS "netOffset", '0,0,0,0' AS "convBoundary",
        '0,0,0,0' AS "origBoundary", coalesce(nullif(trim(proj4text), ''), '!') AS "projParameter"))::text AS element
    FROM origin, spatial_ref_sys WHERE srid = %2$s
    UNION ALL
    -- Our names and numbers need no escape. As text they cost half as much as XML elements.
    SELECT turn, id, concat('<node id="', name, '" x="', round((ST_X(n.geom) - x)::numeric, digits), '" y="',
        round((ST_Y(n.geom) - y)::numeric, digits), '" type="', type, '" tl="' || controller,
        CASE WHEN type NOT IN ('right_before_left', 'left_before_right') THEN '" rightOfWay="edgePriority' END,
        '" shape="-1000,-1000 -1000,-1000 -1000,-1000"',
        coalesce('><param key="surface" value="' || CASE WHEN surface IS NOT NULL AND NOT ST_IsEmpty(surface) THEN
            streetgen._coordinates(ST_ExteriorRing(CASE ST_NumGeometries(surface)
                WHEN 1 THEN ST_GeometryN(surface, 1)
                ELSE (SELECT geom FROM ST_Dump(surface) ORDER BY ST_Area(geom) DESC LIMIT 1) END), x, y, digits, 0)
            END || '"/></node>', '/>'))
    FROM origin, every_node n)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_nodes(text[]) IS
    'Queries of a plain file of SUMO as streetgen._export_lines takes them: the nodes.';

CREATE OR REPLACE FUNCTION streetgen._sumo_rings(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN computed THEN $part$,
ring_line AS (
    SELECT 2 AS turn, roundabout_id AS id, xmlelement(name roundabout, xmlattributes(
        string_agg(comes_from, ' ' ORDER BY ordinality) AS nodes,
        string_agg(s.name, ' ' ORDER BY ordinality) AS edges))::text AS element
    FROM %1$I.roundabout r JOIN %1$I.roundabout_edge e USING (roundabout_id)
        LEFT JOIN sumo_edge s ON s.edge_id = e.edge_id AND s.along_axis = e.along_axis
            AND s.lane_count > 0
    WHERE accepted GROUP BY roundabout_id, face
    -- A part of a ring goes round nothing.
    HAVING count(DISTINCT comes_from) = count(*))$part$
    ELSE $part$, ring_line AS (SELECT 2 AS turn, 0::bigint AS id, NULL::text AS element WHERE false)$part$ END $$;
COMMENT ON FUNCTION streetgen._sumo_rings(boolean) IS
    'Query ring_line of the files of SUMO over a model, after sumo_edge: the accepted roundabouts all of whose edges '
    'are written, each face of a double one by itself; nothing of a model that computes none.';

CREATE OR REPLACE FUNCTION streetgen._sumo_edges(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._sumo_edge(subjects,
        'CASE WHEN until - since < 1 THEN ST_LineSubstring(geom, since, until) ELSE geom END', false)
    || streetgen._sumo_rings('roundabout' = ANY (subjects)) || streetgen._sumo_crossings(subjects) || $part$,
-- Who waits leaves the crossing free.
held_back AS (
    SELECT s.name, max(least(ST_Length(s.line) * (1 - ST_LineLocatePoint(s.line, ST_Centroid(c.line))) + along / 2
        + 0.5, ST_Length(s.line) / 2)) AS back
    FROM crossed c CROSS JOIN LATERAL unnest(c.names) n(name) JOIN sumo_edge s ON s.name = n.name
    WHERE s.until = 1 AND s.along_axis <> c.at_start AND ST_Intersects(s.line, c.line) GROUP BY s.name),
lane_line AS MATERIALIZED (
    SELECT name, index, c.allow, c.disallow, l.width,
        CASE WHEN until - since < 1 AND NOT within THEN ST_LineSubstring(driven, since, until) ELSE driven END AS line
    FROM (SELECT name, i - 1 + walk AS index, since, until, width,
            start_abscissa IS NOT NULL OR end_abscissa IS NOT NULL AS within,
            CASE WHEN e.along_axis THEN l.geom ELSE ST_Reverse(l.geom) END AS driven,
            -- Nobody changes to a lane that is closed to him: one between lanes of cars is open, to be crossed.
            CASE WHEN l.kind = 'bus' AND (SELECT bool_or(j < i) AND bool_or(j > i)
                FROM unnest(e.lanes) WITH ORDINALITY o(lane_id, j) JOIN %1$I.lane USING (lane_id)
                WHERE lane.kind = 'general') THEN 'general' ELSE l.kind END AS kind
        FROM sumo_edge e, streetgen._few(e.lanes) WITH ORDINALITY m(lane_id, i) JOIN %1$I.lane l USING (lane_id)
        UNION ALL SELECT name, 0, since, until, w.width, false,
            CASE WHEN e.along_axis THEN w.line ELSE ST_Reverse(w.line) END, 'sidewalk'
        FROM sumo_edge e JOIN sidewalk_beside w USING (edge_id, along_axis) WHERE walk = 1) l
    JOIN streetgen._sumo_lane_class() c USING (kind)),
lane_element AS (
    SELECT name, string_agg('<lane index="' || index || coalesce('" allow="' || allow, '')
        || coalesce('" disallow="' || disallow, '') || '" width="' || round(width::numeric, digits)
        || coalesce('" shape="' || streetgen._coordinates(streetgen._at_least_long(line, 0.16), x, y, digits,
            tolerance), '') || '"/>', '' ORDER BY index) AS elements
    FROM origin, lane_line GROUP BY name),
line AS (
    SELECT 1 AS turn, lane_group_id AS id, concat('<edge id="', s.name, '" from="', comes_from, '" to="', goes_to,
        '" priority="', 100 - e.importance, '" numLanes="', s.lane_count + walk, '" speed="',
        round(e.speed::numeric / 3.6, 2), '"', named, ' spreadType="center',
        '" shape="' || streetgen._coordinates(streetgen._at_least_long(line, 0.16), x, y, digits, 0.01), '">', elements,
        '<stopOffset value="' || round(back::numeric, digits) || '"/>',
        CASE WHEN s.until = 1 AND (s.edge_id, s.along_axis) IN (SELECT edge_id, along_axis FROM %1$I.marking
            WHERE kind = 'stop') THEN '<param key="waits" value="stop"/>' END, '</edge>') AS element
    FROM origin, sumo_edge s JOIN lane_element USING (name) LEFT JOIN held_back USING (name)
    JOIN (SELECT edge_id, axis_id, importance, speed FROM written_edge) e USING (edge_id)
    -- Words of users are escaped: of <a type="…" name="…"/> what stands between the name and the end.
    LEFT JOIN (SELECT axis_id, left(substr(xmlelement(name a, xmlattributes(streetgen._xml_text(kind) AS type,
        streetgen._xml_text(name) AS name))::text, 3), -2) AS named FROM %1$I.axis) a USING (axis_id)
    UNION ALL SELECT * FROM ring_line)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_edges(text[]) IS
    'Queries of a plain file of SUMO as streetgen._export_lines takes them: the edges with their lanes, and the '
    'roundabouts of a model that computes them. A bus lane between lanes for all is written as one of these. Parameter '
    'waits says stop where a stop line is: netconvert knows such lines of a whole node only.';

CREATE OR REPLACE FUNCTION streetgen._sumo_going_on(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._sumo_edge(subjects, 'NULL', false) || $part$,
placed AS MATERIALIZED (
    SELECT lane_id, along_axis, name, goes_to, since, until, since = 0 AS begins, until = 1 AS ends,
        i - 1 + walk AS index
    FROM sumo_edge, streetgen._few(lanes) WITH ORDINALITY m(lane_id, i)),
going_on AS MATERIALIZED (
    SELECT way_id AS id, a.name AS name_in, b.name AS name_out, a.index AS index_in, b.index AS index_out,
        k.geom, a.goes_to, k.turn, k.lane_in, k.lane_out, k.along_in, k.along_out
    FROM way k JOIN placed a ON (a.lane_id, a.along_axis) = (k.lane_in, k.along_in) AND a.ends
    JOIN placed b ON (b.lane_id, b.along_axis) = (k.lane_out, k.along_out) AND b.begins
    UNION ALL SELECT 0, a.name, b.name, a.index, b.index, NULL, a.goes_to, NULL, NULL, NULL, NULL, NULL
    FROM placed a JOIN placed b USING (lane_id, along_axis) WHERE NOT a.ends AND a.until = b.since)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_going_on(text[]) IS
    'Query going_on of the files of SUMO over a model: which lane of an edge goes on to which lane of another.';

CREATE OR REPLACE FUNCTION streetgen._sumo_connections(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._sumo_going_on(subjects) || streetgen._sumo_crossings(subjects) || $part$,
line AS (
    SELECT 1 AS turn, id, '<connection from="' || name_in || '" to="' || name_out || '" fromLane="' || index_in
        || '" toLane="' || index_out
        -- Who waits within a junction does not see who comes beside him into his lane: these wait before it.
        || CASE WHEN (name_in, name_out, index_out) IN (SELECT name_in, name_out, index_out FROM going_on
            GROUP BY 1, 2, 3 HAVING count(*) > 1) THEN '" contPos="0' ELSE '' END
        || coalesce('" shape="' || CASE WHEN ST_Length(k.geom) > 0.05
            THEN streetgen._coordinates(k.geom, x, y, digits, tolerance) END, '') || '"/>' AS element
    FROM origin, going_on k
    UNION ALL
    -- What is not said is invented: an edge without a way on goes into none.
    SELECT 2, a.lane_group_id, '<delete from="' || a.name || '" to="' || b.name || '"/>'
    FROM sumo_edge a JOIN sumo_edge b ON b.comes_from = a.goes_to
    WHERE NOT EXISTS (SELECT FROM going_on WHERE name_in = a.name)
    UNION ALL
    SELECT 3, c.edge_id, xmlelement(name crossing, xmlattributes(c.place_id AS node,
        array_to_string(names, ' ') AS edges, 1 AS priority, round(along::numeric, digits) AS width,
        number AS "linkIndex", streetgen._coordinates(c.line, x, y, digits, 0) AS shape))::text
    FROM origin, crossed c)$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_connections(text[]) IS
    'Queries of a plain file of SUMO as streetgen._export_lines takes them: the connections, '
    'and the crossings.';

CREATE OR REPLACE FUNCTION streetgen._sumo_types() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$, line AS (
    SELECT 1 AS turn, row_number() OVER (ORDER BY class COLLATE "C") AS id, xmlelement(name type, xmlattributes(
        streetgen._xml_text(class) AS id, 100 - importance AS priority, round(speed::numeric / 3.6, 2) AS speed))
        AS element
    FROM %1$I.axis_class WHERE class IN (SELECT kind FROM written_edge JOIN %1$I.axis USING (axis_id)))$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_types() IS
    'Queries of a plain file of SUMO as streetgen._export_lines takes them: the kinds of streets.';

CREATE OR REPLACE FUNCTION streetgen._sumo_part(subjects text[]) RETURNS TABLE(part text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES ('nodes', streetgen._sumo_nodes(subjects)), ('edges', streetgen._sumo_edges(subjects)),
        ('connections', streetgen._sumo_connections(subjects)), ('types', streetgen._sumo_types()),
        ('tlLogics', streetgen._sumo_signals(subjects)) $$;
COMMENT ON FUNCTION streetgen._sumo_part(text[]) IS
    'The plain files of SUMO of a model that computes these subjects: the part, which is the name of its root element, '
    'and the queries of its lines.';

CREATE OR REPLACE FUNCTION streetgen.export_sumo(model name, part text, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'sumo', 'interconnection', options);
    file record;
BEGIN
    PERFORM streetgen._check_given('part', part);
    SELECT * INTO file FROM streetgen._sumo_part(streetgen._subjects(model)) p WHERE p.part = export_sumo.part;
    IF file.part IS NULL THEN
        RAISE EXCEPTION 'format sumo has no part "%"', part USING ERRCODE = '22023',
            HINT = 'Its parts are ' || (SELECT string_agg(p.part, ', ') FROM streetgen._sumo_part('{}') p) || '.';
    END IF;
    RETURN QUERY EXECUTE streetgen._export_lines(model, known, file.query,
        format('<%s xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation='
            '"http://sumo.dlr.de/xsd/%s_file.xsd">', file.part,
            CASE file.part WHEN 'tlLogics' THEN 'tllogic' ELSE file.part END), format('</%s>', file.part)) USING known;
END $$;
COMMENT ON FUNCTION streetgen.export_sumo(name, text, jsonb) IS
    'A plain file of SUMO, line by line, of which netconvert makes a network: part nodes, edges, connections, types or '
    'tlLogics. An edge is a lane group: edge_id along the axis, -edge_id against it; a loop is two, the second one '
    'ends in .end. '
    'Its lanes have the lines, widths and vehicle classes of the model, and lane 0 is at the kerb. A connection is an '
    'interconnection that connects, with its path. An edge without a way on is parted from all that leave its node, '
    'since netconvert invents what is not said. With subject sidewalk, a sidewalk is lane 0 of its edge, or an edge '
    'edge_id.walk beside no lane of its direction, and crossings between two of them are written (connections). A '
    'node has the intersection as parameter surface; its shape is a place '
    'where no lane comes, since netconvert cuts lanes at shapes. With subject junction, junctions of kind signals are '
    'traffic lights, with subject signal by the programs of the model (tlLogics), and the nodes of a junction can be '
    'one. With it, who comes from the left goes first at a mini-roundabout (left_before_right), or from the right '
    'where one drives on the left. With subject roundabout, accepted rings are roundabouts (edges). '
    'Coordinates are counted from whole metres, which location says. options as streetgen.export_option() lists '
    'them: an unknown one, another '
    'part, or no edge that they take: 22023. A caller who may not read the model: 42501; a model without '
    'interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a warning.';
