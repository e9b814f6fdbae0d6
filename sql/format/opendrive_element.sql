-- OpenDRIVE: the elements of a file, roads with what they have beside lanes, and junctions.

CREATE OR REPLACE FUNCTION streetgen._opendrive_elements(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH written_edge AS MATERIALIZED (
        SELECT edge_id, axis_id, from_node, to_node, speed FROM edge
            WHERE edge_id IN (SELECT streetgen._written_edges(model, options))),
    origin AS MATERIALIZED (SELECT * FROM streetgen._opendrive_origin(model, options)),
    projected AS MATERIALIZED (SELECT * FROM streetgen._projected_geometries(model, options)),
    side AS MATERIALIZED (SELECT value IS DISTINCT FROM 'left' AS right_hand FROM setting WHERE name = 'driving_side'),
    place AS MATERIALIZED (
        SELECT node_id, streetgen._file_id('node', place_id) AS place_id FROM streetgen._places(model, options)),
    road AS MATERIALIZED (SELECT * FROM streetgen._opendrive_roads(model, options, true)),
    drawn AS NOT MATERIALIZED (SELECT * FROM road WHERE NOT connecting),
    connecting AS NOT MATERIALIZED (SELECT * FROM road WHERE connecting),
    street AS MATERIALIZED (SELECT * FROM streetgen._opendrive_streets(model, options)),
    -- Fast roads have lines at their edges also where the model paints none.
    line_between AS MATERIALIZED (
        SELECT * FROM streetgen._lines_between(model)
        UNION ALL SELECT edge_id, position, false, false, 'solid'
        FROM (SELECT edge_id, max(lane_position) AS lanes FROM lane JOIN street USING (edge_id)
            WHERE edge_lines GROUP BY edge_id) f, LATERAL (VALUES (0), (lanes)) v(position)
        WHERE NOT EXISTS (SELECT FROM lane_separator s
            WHERE (s.edge_id, s.lane_position) = (f.edge_id, v.position))),
    raised AS MATERIALIZED (
        SELECT h.road_id, c.*, heights[1] AS z_from, heights[cardinality(heights)] AS z_to, c.b[1] AS grade_from,
            c.b[n] + (h.total - c.s[n]) * (2 * c.c[n] + 3 * c.d[n] * (h.total - c.s[n])) AS grade_to
        FROM (SELECT road_id, p.total, array_agg(m ORDER BY m) AS station, array_agg(p.z - o.z ORDER BY m) AS heights
            FROM origin o, (SELECT DISTINCT ON (road_id, round(ST_M(p.geom)::numeric, 3)) road_id, drawn.total,
                    ST_M(p.geom) AS m, ST_Z(p.geom) AS z
                FROM drawn JOIN streetgen._heights_along(model) h USING (edge_id),
                    ST_DumpPoints(ST_AddMeasure(ST_LineSubstring(h.geom, share_from, share_to), 0, total)) p
                ORDER BY road_id, round(ST_M(p.geom)::numeric, 3)) p
            GROUP BY road_id, p.total HAVING count(*) > 1) h,
            streetgen._height_curve(station, heights, 0.01) c, LATERAL (SELECT cardinality(c.s) AS n) l),
    -- Roadway between the outer lanes and the kerbs.
    shoulder AS MATERIALIZED (
        SELECT d.road_id, v.side, '<lane id="' || CASE v.side WHEN 'left' THEN lefts + 1
                ELSE lefts - cardinality(lanes) - 1 END || '" type="shoulder" level="false">'
            || streetgen._opendrive_step('width', 'sOffset', total, room_at.start, room_at.end)
            || '<roadMark sOffset="0" type="none" color="standard" laneChange="none"/></lane>' AS text
        FROM streetgen._room_beside_lanes(model) b JOIN drawn d USING (edge_id) JOIN edge e USING (edge_id),
            (VALUES ('left'), ('right')) v(side),
            LATERAL (SELECT b.room * (1 + (e.width_end / e.width - 1) * share_from) AS start,
                b.room * (1 + (e.width_end / e.width - 1) * share_to) AS end) room_at
        WHERE CASE v.side WHEN 'left' THEN before = 0
            ELSE positions[cardinality(positions)]
                = (SELECT count(*) FROM lane l WHERE l.edge_id = d.edge_id) END),
    sidewalk_lane AS MATERIALIZED (
        SELECT d.road_id, s.side, '<lane id="' || CASE s.side WHEN 'left' THEN lefts + 1 + outer_lane.more
                ELSE lefts - cardinality(lanes) - 1 - outer_lane.more END
            || '" type="sidewalk" level="false"><width sOffset="0" a="' || streetgen._decimal(s.width, 5)
            || '" b="0" c="0" d="0"/>'
            || '<roadMark sOffset="0" type="none" color="standard" laneChange="none"/><height sOffset="0" inner="'
            || raised || '" outer="' || raised || '"/></lane>' AS text
        FROM streetgen._sidewalks_beside(model, options, false) s
            JOIN drawn d ON d.edge_id = s.edge_id AND s.lane_id = ANY (d.lanes)
            LEFT JOIN shoulder b ON (b.road_id, b.side) = (d.road_id, s.side),
            LATERAL (SELECT num_nonnulls(b.road_id) AS more) outer_lane,
            (SELECT k.raised FROM streetgen._mesh_layer() k WHERE k.layer = 'sidewalk') k),
    -- The lane of a road at one end of it.
    placed AS MATERIALIZED (
        SELECT lane_id, road_id, edge_id, at_end, halves[i] AS half,
            CASE WHEN i <= lefts THEN lefts - i + 1 ELSE lefts - i END AS number
        FROM drawn, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i), (VALUES (false, 1), (true, 2)) v(at_end, n)
        WHERE own_ends[n]),
    line_ahead AS MATERIALIZED (
        SELECT m.kind, m.along_axis, l.lane_id, p.road_id, p.number, coalesce(q.geom, m.geom) AS geom,
            coalesce(r.geom, m.surface) AS surface
        FROM marking m JOIN lane l USING (edge_id, lane_position)
            JOIN placed p ON (p.lane_id, p.at_end) = (l.lane_id, m.along_axis)
                AND coalesce(p.half = m.along_axis, true)
            LEFT JOIN projected q ON (q.kind, q.id) = ('marking', m.marking_id)
            LEFT JOIN projected r ON (r.kind, r.id) = ('marking surface', m.marking_id)
        WHERE m.kind <> 'arrow'),
    road_of_edge AS MATERIALIZED (SELECT DISTINCT edge_id FROM drawn),
    -- An object of an edge that is no road here, and one that no axis places, goes to the nearest street.
    standing AS MATERIALIZED (
        SELECT o.street_object_id, o.type, o.angle, o.kind, o.size, o.drawn, o.subtype, c.geom, c.surface, e.edge_id,
            e.from_node, e.to_node, ST_X(place) AS x, ST_Y(place) AS y
        FROM streetgen._opendrive_objects(model) o
            LEFT JOIN projected p ON (p.kind, p.id) = ('object', o.street_object_id)
            LEFT JOIN projected q ON (q.kind, q.id) = ('object surface', o.street_object_id)
            LEFT JOIN road_of_edge w ON w.edge_id = o.edge_id,
            LATERAL (SELECT CASE WHEN w.edge_id IS NOT NULL THEN w.edge_id
                WHEN o.edge_id IS NULL OR o.edge_id IN (SELECT streetgen._edges_taken(model, options)) THEN (
                    SELECT e.edge_id FROM edge e WHERE ST_DWithin(e.geom, o.geom, 50)
                        -- A value is looked up; a join would read all for each object.
                        AND (e.edge_id IN (SELECT edge_id FROM road_of_edge)) IS TRUE
                    ORDER BY ST_Distance(e.geom, o.geom), e.edge_id LIMIT 1) END AS edge_id) n
            JOIN written_edge e ON e.edge_id = n.edge_id,
            LATERAL (SELECT coalesce(p.geom, o.geom) AS geom, coalesce(q.geom, o.surface) AS surface) c,
            LATERAL (SELECT CASE WHEN ST_Dimension(c.geom) = 0 THEN c.geom
                ELSE ST_LineInterpolatePoint(c.geom, 0.5) END AS place) m),
    own_station AS MATERIALIZED (
        SELECT DISTINCT ON (street_object_id) s.*, d.road_id, d.total, p.*
        FROM standing s JOIN drawn d ON d.edge_id = s.edge_id AND d.before = 0,
            streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, s.x, s.y) p
        ORDER BY street_object_id, abs(p.beyond), d.road_id),
    -- Beyond the end of its road it stands at a road across the node, where that is nearer.
    stationed AS MATERIALIZED (
        SELECT o.street_object_id, o.type, o.angle, o.geom, o.kind, o.subtype, o.size, o.drawn, o.surface, o.x, o.y,
            coalesce(c.road_id, o.road_id) AS road_id, coalesce(c.total, o.total) AS total,
            coalesce(c.station, o.station) AS station, coalesce(c.aside, o.aside) AS aside,
            coalesce(c.direction, o.direction) AS direction, coalesce(c.beyond, o.beyond) AS beyond
        FROM own_station o LEFT JOIN LATERAL (
            SELECT c.road_id, c.total, p.*
            FROM connecting c, streetgen._chain_station(c.s, c.x, c.y, c.heading, c.length,
                c.curvature, c.curvature_end, o.x, o.y) p
            WHERE abs(o.beyond) > 0.01 AND c.node_id IN (o.from_node, o.to_node) AND abs(p.beyond) <= 0.01
                AND abs(p.aside) <= sqrt(o.aside ^ 2 + o.beyond ^ 2)
            ORDER BY abs(p.aside), c.road_id LIMIT 1) c ON true),
    grounded AS (
        SELECT streetgen._file_id('object', street_object_id) AS id, replace(type, '_', ' ') AS name, kind, subtype,
            angle, size, road_id, total, station, aside, direction, beyond, x, y, NULL::bigint AS lane, CASE
            WHEN ST_Dimension(geom) = 1 THEN ST_Buffer(geom, size / 2, 'endcap=flat join=mitre mitre_limit=2')
            WHEN drawn THEN surface
            -- What lies beside no road says by its corners where it is.
            WHEN abs(beyond) > 0.01 THEN ST_Buffer(geom, size / 2, 'quad_segs=2') END AS ground
        FROM stationed
        UNION ALL
        SELECT streetgen._file_id('lane', lane_id, 2 + along_axis::integer), l.kind || ' line', 'roadMark',
            'signalLines', NULL, NULL, road_id, d.total, p.station, p.aside, p.direction, p.beyond, ST_X(place),
            ST_Y(place), number, ST_OrientedEnvelope(surface)
        FROM line_ahead l JOIN drawn d USING (road_id), ST_LineInterpolatePoint(l.geom, 0.5) place,
            streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, ST_X(place),
                ST_Y(place)) p
        WHERE NOT ST_IsEmpty(surface)),
    object_text AS (
        SELECT road_id, 'object' AS kind, id,
            streetgen._opendrive_open(xmlelement(name object, xmlattributes(
                -- CARLA takes a name that begins with speed_ for a speed limit.
                id, streetgen._xml_text(name) AS name, kind AS type, subtype,
                streetgen._opendrive_station(station, total) AS s, streetgen._decimal(aside, 4) AS t,
                0 AS "zOffset", 'none' AS orientation, streetgen._decimal(CASE
                    WHEN outlined THEN -direction
                    ELSE pi() / 2 - radians(coalesce(angle, 0)) + convergence - direction END, 6) AS hdg,
                CASE WHEN kind = 'tree' AND NOT outlined THEN size / 2 END AS radius,
                CASE WHEN kind <> 'tree' AND NOT outlined THEN size END AS length,
                CASE WHEN kind <> 'tree' AND NOT outlined THEN size END AS width)))
            -- CARLA reads the outline of a crosswalk alone, and esmini those in a list.
            || CASE WHEN outlined THEN concat(CASE WHEN kind = 'crosswalk' THEN outline END, '<outlines>', outline,
                '</outlines>') ELSE '' END
            || CASE WHEN kind = 'parkingSpace' THEN '<parkingSpace access="all"/>' ELSE '' END
            || coalesce('<validity fromLane="' || lane || '" toLane="' || lane || '"/>', '') || '</object>' AS text
        FROM (SELECT convergence FROM origin) n, grounded,
            LATERAL (SELECT ST_GeometryType(ground) IS NOT DISTINCT FROM 'ST_Polygon' AS outlined) o,
            -- Corners count from the place at its station, at the end of the road where it lies beyond.
            LATERAL (SELECT CASE WHEN outlined THEN streetgen._opendrive_outline(ground, x - beyond * cos(direction),
                y - beyond * sin(direction)) END AS outline) c),
    -- A deck has one element, also where lanes of its edge are a road of their own.
    structure_text AS (
        SELECT road_id, kind, id, '<' || kind || ' s="' || streetgen._opendrive_station(since, total) || '" length="'
            || streetgen._opendrive_station(until - since, total - since) || '" id="'
            || streetgen._file_id(kind, id, part::integer) || '" type="' || type || '"/>' AS text
        FROM (SELECT d.road_id, d.total, t.kind, t.type, t.id, since, until,
                row_number() OVER (PARTITION BY t.kind, t.id ORDER BY d.road_id) - 1 AS part
            FROM drawn d JOIN streetgen._opendrive_structures(model) t ON t.edge_id = d.edge_id AND d.before = 0,
                LATERAL (SELECT total / (d.share_to - d.share_from) AS scale) l,
                LATERAL (SELECT greatest(t.share_from - d.share_from, 0) * scale AS since,
                    least(t.share_to - d.share_from, d.share_to - d.share_from) * scale AS until) s
            WHERE until > since) t),
    objects_text AS MATERIALIZED (
        SELECT road_id, '<objects>' || string_agg(text, ''
                ORDER BY array_position('{object,tunnel,bridge}', kind), id) || '</objects>' AS text
        FROM (TABLE object_text UNION ALL TABLE structure_text) o GROUP BY road_id),
    -- Lanes whose signals show the same in each state have one controller, which has the id of the first.
    signal_group AS MATERIALIZED (
        SELECT *, min(id) OVER (PARTITION BY controller_id, greens) AS number
        FROM (SELECT h.lane_id, h.along_axis, h.controller_id, h.greens, i.id, coalesce(p.geom, h.geom) AS geom
            FROM streetgen._signal_heads(model) h,
                LATERAL (SELECT streetgen._file_id('lane', lane_id, along_axis::integer) AS id) i
                LEFT JOIN projected p ON (p.kind, p.id) = ('head', i.id)) h),
    program AS MATERIALIZED (
        SELECT controller_id, 'cycle ' || round(min(c.cycle)::numeric, 2) || ' offset '
            || round(min(c.start_offset)::numeric, 2) || ': ' || string_agg(s.ordinality || ' ' || s.kind || ' '
            || round(s.duration::numeric, 2), ', ' ORDER BY s.ordinality) AS text
        FROM streetgen._signal_controllers(model) c JOIN streetgen._signal_states(model) s USING (controller_id)
        GROUP BY controller_id),
    driven AS MATERIALIZED (
        SELECT d.road_id, e.speed FROM drawn d JOIN written_edge e USING (edge_id) JOIN street t USING (edge_id)
        WHERE t.road_type NOT IN ('pedestrian', 'bicycle')),
    -- The speeds of the roads by which one comes to each end of a road.
    speed_before AS MATERIALIZED (
        SELECT road_id, at_end, min(speed) AS lowest, max(speed) AS highest
        FROM (SELECT c.road_out AS road_id, c.out_end AS at_end, c.road_in AS other FROM connecting c
            UNION ALL SELECT d.road_id, at_end, joined_road[n] FROM drawn d, (VALUES (false, 1), (true, 2)) v(at_end, n)
            ) b JOIN (SELECT road_id AS other, speed FROM driven) o USING (other)
        WHERE other <> road_id GROUP BY road_id, at_end),
    -- The lanes by which one enters a road, where another speed begins.
    new_speed AS (
        SELECT p.road_id, NOT at_end AS along_axis, n.speed, min(p.lane_id) AS lane_id, min(p.number) AS first,
            max(p.number) AS last
        FROM placed p JOIN driven n USING (road_id) JOIN lane l USING (lane_id) LEFT JOIN speed_before b
            USING (road_id, at_end)
        WHERE l.kind NOT IN ('parking', 'cycle', 'closed')
            AND (l.both_ways AND p.half IS NULL OR coalesce(p.half, l.along_axis) <> at_end)
            AND (b.lowest, b.highest) IS DISTINCT FROM (n.speed, n.speed)
        GROUP BY p.road_id, at_end, n.speed),
    -- A signal hangs above the end of its lane; a sign stands half a metre beside the lanes that it is for.
    sign AS MATERIALIZED (
        SELECT g.id, p.road_id, d.total, s.station, s.aside, g.along_axis, 5 AS raised, p.number AS first,
            p.number AS last,
            'yes' AS dynamic, 'OpenDRIVE' AS country, '1000001' AS type, 'signal' AS name, g.number AS controller,
            CASE WHEN g.along_axis THEN e.to_node ELSE e.from_node END AS node_id, g.controller_id,
            NULL::float8 AS speed
        FROM signal_group g JOIN placed p ON (p.lane_id, p.at_end) = (g.lane_id, g.along_axis)
                AND coalesce(p.half = g.along_axis, true)
            JOIN written_edge e USING (edge_id) JOIN drawn d ON d.road_id = p.road_id,
            streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, ST_X(g.geom),
                ST_Y(g.geom)) s
        UNION ALL
        SELECT streetgen._file_id('lane', m.lane_id, m.along_axis::integer), d.road_id, d.total, s.station,
            CASE WHEN m.along_axis = right_hand THEN
                    border[cardinality(border) - CASE WHEN m.along_axis THEN 0 ELSE stations - 1 END] - 0.5
                ELSE border[CASE WHEN m.along_axis THEN stations ELSE 1 END] + 0.5 END,
            m.along_axis, 2, m.first, m.last, 'no', 'DE', m.type, m.kind, NULL, NULL, NULL, NULL
        FROM (SELECT road_id, along_axis, kind, CASE kind WHEN 'stop' THEN '206' ELSE '205' END AS type,
                min(lane_id) AS lane_id, min(number) AS first, max(number) AS last,
                (array_agg(geom ORDER BY number))[1] AS geom
            FROM line_ahead l WHERE NOT EXISTS (SELECT FROM signal_group g
                WHERE (g.lane_id, g.along_axis) = (l.lane_id, l.along_axis))
            GROUP BY road_id, along_axis, kind) m JOIN drawn d USING (road_id) CROSS JOIN side,
            LATERAL (SELECT cardinality(station) AS stations, ST_LineInterpolatePoint(m.geom, 0.5) AS place) c,
            streetgen._chain_station(d.s, d.x, d.y, d.heading, d.length, d.curvature, d.curvature_end, ST_X(place),
                ST_Y(place)) s
        UNION ALL
        SELECT streetgen._file_id('entry', n.lane_id, n.along_axis::integer), d.road_id, d.total,
            CASE WHEN n.along_axis THEN 0 ELSE d.total END,
            CASE WHEN n.along_axis = right_hand THEN
                    border[cardinality(border) - CASE WHEN n.along_axis THEN stations - 1 ELSE 0 END] - 0.5
                ELSE border[CASE WHEN n.along_axis THEN 1 ELSE stations END] + 0.5 END,
            n.along_axis, 2, n.first, n.last, 'no', 'DE', '274', 'maximum speed', NULL, NULL, NULL, n.speed
        FROM new_speed n JOIN drawn d USING (road_id) CROSS JOIN side,
            LATERAL (SELECT cardinality(station) AS stations) c),
    signal_text AS MATERIALIZED (
        SELECT road_id, '<signals>' || string_agg('<signal s="' || streetgen._opendrive_station(station, total)
            || '" t="'
            || streetgen._decimal(aside, 4) || '" id="' || id || '" name="' || name || '" dynamic="' || dynamic
            || '" orientation="' || CASE WHEN along_axis THEN '+' ELSE '-' END || '" zOffset="' || raised
            || '" country="' || country || '" type="' || type || '" subtype="' || coalesce(round(speed)
                || '" value="' || streetgen._decimal(speed, 1) || '" unit="km/h', '-1')
            || '"><validity fromLane="' || first || '" toLane="' || last || '"/></signal>', '' ORDER BY id)
            || '</signals>' AS text
        FROM sign GROUP BY road_id),
    controller_line AS (
        SELECT 4 AS turn, controller AS id, '<controller id="' || controller || '" name="' || min(controller_id)
            || '">' || string_agg('<control signalId="' || id || '" type="0"/>', '' ORDER BY id)
            || '<userData code="green" value="' || array_to_string(min(greens), ' ') || '"/></controller>' AS element
        FROM sign JOIN (SELECT DISTINCT number AS controller, greens FROM signal_group) g USING (controller)
        GROUP BY controller),
    junction_controller AS MATERIALIZED (
        SELECT place_id, string_agg('<controller id="' || controller || '" type="0"/>', '' ORDER BY controller)
            || string_agg(DISTINCT '<userData code="program" value="' || p.text || '"/>', '') AS text
        FROM (SELECT DISTINCT place_id, controller, controller_id FROM sign JOIN place USING (node_id)) n
            JOIN program p USING (controller_id)
        GROUP BY place_id),
    crossroads AS MATERIALIZED (
        SELECT node_id, place_id FROM place
        WHERE place_id IN (SELECT place_id FROM connecting JOIN place n USING (node_id))),
    no_way_through AS MATERIALIZED (SELECT lane_id FROM streetgen._lanes_without_through(model)),
    lane_text AS (
        SELECT road_id, lefts, i, '<lane id="' || CASE WHEN i <= lefts THEN lefts - i + 1 ELSE lefts - i END
            || '" type="' || types[i] || '" level="false">'
            || coalesce('<link>' || nullif(concat('<predecessor id="' || joined_numbers[i] || '"/>', '<successor id="'
                || joined_numbers[cardinality(lanes) + i] || '"/>'), '') || '</link>', '')
            || CASE WHEN stations = 2 THEN streetgen._opendrive_step('width', 'sOffset', total,
                    border[2 * i - 1] - border[2 * i + 1], border[2 * i] - border[2 * i + 2])
                ELSE streetgen._opendrive_change('width', 'sOffset', station, ARRAY(
                    SELECT border[(i - 1) * stations + k] - border[i * stations + k]
                    FROM generate_series(1, stations) k)) END
            || streetgen._opendrive_mark(m.paint, m.leftwards, m.rightwards, i > lefts)
            || CASE WHEN lane_id IN (TABLE no_way_through) THEN '<access sOffset="0" rule="deny" '
                'restriction="throughTraffic"/>' ELSE '' END || '</lane>' AS text
        FROM (SELECT d.*, cardinality(station) AS stations FROM drawn d) d
            CROSS JOIN streetgen._few(lanes) WITH ORDINALITY u(lane_id, i)
            LEFT JOIN line_between m ON (m.edge_id, m.lane_position)
                = (d.edge_id, positions[i] - CASE WHEN i <= lefts THEN 1 ELSE 0 END)),
    -- The lane farthest to the left comes first.
    across AS MATERIALIZED (
        SELECT road_id, '<left>' || string_agg(text, '' ORDER BY turn, i) FILTER (WHERE side = 'left') || '</left>'
                AS on_left,
            '<right>' || string_agg(text, '' ORDER BY turn, i) FILTER (WHERE side = 'right') || '</right>' AS on_right
        FROM (SELECT road_id, CASE WHEN i <= lefts THEN 'left' ELSE 'right' END AS side, 0 AS turn, i, text
            FROM lane_text
            UNION ALL SELECT road_id, side, CASE side WHEN 'left' THEN -1 ELSE 1 END, 0, text FROM shoulder
            UNION ALL SELECT road_id, side, CASE side WHEN 'left' THEN -2 ELSE 2 END, 0, text FROM sidewalk_lane) t
        GROUP BY road_id)
    SELECT 1, 0::bigint, streetgen._opendrive_open(xmlelement(name header, xmlattributes(
            1 AS "revMajor", right(options ->> 'version', 1) AS "revMinor", model AS name,
            streetgen._decimal(north - y, 2) AS north, streetgen._decimal(south - y, 2) AS south,
            streetgen._decimal(east - x, 2) AS east, streetgen._decimal(west - x, 2) AS west, 'StreetGen' AS vendor)))
        || '<geoReference><![CDATA['
        || projection || ']]></geoReference><offset x="' || x || '" y="' || y
        || '" z="' || z || '" hdg="0"/></header>'
    FROM origin, (
        SELECT max(ST_YMax(g)) AS north, min(ST_YMin(g)) AS south, max(ST_XMax(g)) AS east, min(ST_XMin(g)) AS west
        FROM edge e JOIN written_edge USING (edge_id) LEFT JOIN projected p ON (p.kind, p.id) = ('edge', e.edge_id),
            coalesce(p.geom, e.geom) g) box
    UNION ALL
    -- Not by ||, which copies what is there with each word.
    SELECT 2, d.road_id, concat(streetgen._opendrive_open(xmlelement(name road, xmlattributes(
            streetgen._xml_text(a.name) AS name, streetgen._decimal(d.total, 7) AS length,
            d.road_id AS id, -1 AS junction, CASE WHEN right_hand THEN 'RHT' ELSE 'LHT' END AS rule))),
        '<link>', streetgen._opendrive_link('predecessor', joined_road[1], joined_end[1],
            CASE WHEN own_ends[1] THEN f.place_id END), streetgen._opendrive_link('successor', joined_road[2],
            joined_end[2], CASE WHEN own_ends[2] THEN t.place_id END), '</link>',
        '<type s="0" type="', a.road_type, '"><speed max="', streetgen._decimal(e.speed, 1), '" unit="km/h"/></type>',
        streetgen._opendrive_plan(d.s, d.x, d.y, heading, length, curvature, curvature_end, o.x, o.y, digits),
        '<elevationProfile>' || streetgen._opendrive_cubics('elevation', 's', h.s, h.a, h.b, h.c, h.d)
            || '</elevationProfile>',
        '<lanes>', streetgen._opendrive_change('laneOffset', 's', d.station,
            border[lefts * cardinality(d.station) + 1:(lefts + 1) * cardinality(d.station)]),
        '<laneSection s="0">', on_left, '<center><lane id="0" type="none" level="false">',
        streetgen._opendrive_mark(m.paint, m.leftwards, m.rightwards), '</lane></center>', on_right,
        '</laneSection></lanes>', j.text, g.text, '<userData code="edge" value="', d.edge_id, '"/></road>')
    FROM origin o, side, drawn d JOIN across USING (road_id) JOIN written_edge e USING (edge_id)
        LEFT JOIN crossroads f ON f.node_id = e.from_node LEFT JOIN crossroads t ON t.node_id = e.to_node
        JOIN street a USING (edge_id)
        -- No line lies between two halves of a lane.
        LEFT JOIN line_between m ON (m.edge_id, m.lane_position) = (d.edge_id, CASE WHEN lefts = 0 THEN before
            WHEN positions[lefts] IS DISTINCT FROM positions[lefts + 1] THEN positions[lefts] END)
        LEFT JOIN raised h ON h.road_id = d.road_id LEFT JOIN objects_text j ON j.road_id = d.road_id
        LEFT JOIN signal_text g ON g.road_id = d.road_id
    UNION ALL
    SELECT 3, c.road_id, concat('<road length="', streetgen._decimal(total, 7), '" id="', c.road_id, '" junction="',
        place_id, '" rule="', rule, '"><link><predecessor elementType="road" elementId="', road_in, '" contactPoint="',
        CASE WHEN in_end THEN 'end' ELSE 'start' END, '"/><successor elementType="road" elementId="', road_out,
        '" contactPoint="', CASE WHEN out_end THEN 'end' ELSE 'start' END, '"/></link>',
        streetgen._opendrive_plan(c.s, c.x, c.y, heading, length, curvature, curvature_end, o.x, o.y, digits),
        '<elevationProfile>' || streetgen._opendrive_climb(total, CASE WHEN in_end THEN a.z_to ELSE a.z_from END,
            CASE WHEN in_end THEN a.grade_to ELSE -a.grade_from END, CASE WHEN out_end THEN b.z_to ELSE b.z_from END,
            CASE WHEN out_end THEN -b.grade_to ELSE b.grade_from END) || '</elevationProfile>',
        '<lanes>', streetgen._opendrive_lean(total, half * width_in, half * width_out, lean_in, lean_out),
        '<laneSection s="0">', CASE WHEN NOT right_hand THEN '<left>' || lane || '</left>' END,
        '<center><lane id="0" type="none" level="false"/></center>',
        CASE WHEN right_hand THEN '<right>' || lane || '</right>' END, '</laneSection></lanes>', j.text,
        '<userData code="interconnection" value="', ways, '"/></road>')
    FROM origin o, side, connecting c JOIN place USING (node_id) LEFT JOIN objects_text j USING (road_id)
        LEFT JOIN raised a ON a.road_id = road_in LEFT JOIN raised b ON b.road_id = road_out,
        LATERAL (SELECT CASE WHEN right_hand THEN 'RHT' ELSE 'LHT' END AS rule,
            CASE WHEN right_hand THEN 0.5 ELSE -0.5 END AS half) w,
        LATERAL (SELECT '<lane id="' || CASE WHEN right_hand THEN -1 ELSE 1 END || '" type="' || type
            || '" level="false">'
            || '<link><predecessor id="' || number_in || '"/><successor id="' || number_out || '"/></link>'
            || streetgen._opendrive_step('width', 'sOffset', total, width_in, width_out) || '</lane>' AS lane) l
    UNION ALL SELECT * FROM controller_line
    UNION ALL
    SELECT 5, place_id, '<junction id="' || place_id || '">' || string_agg('<connection id="' || road_id
        || '" incomingRoad="' || road_in || '" connectingRoad="' || road_id || '" contactPoint="start"><laneLink from="'
        || number_in || '" to="' || CASE WHEN right_hand THEN -1 ELSE 1 END || '"/></connection>', ''
        ORDER BY road_id) || coalesce(min(c.text), '') || '</junction>'
    FROM side, connecting JOIN place USING (node_id) LEFT JOIN junction_controller c USING (place_id)
    GROUP BY place_id
    UNION ALL
    SELECT 6, roundabout_id, '<junctionGroup id="' || roundabout_id || '" type="roundabout">'
        || string_agg(DISTINCT '<junctionReference junction="' || place_id || '"/>', '') || '</junctionGroup>'
    FROM streetgen._ring_edges(model) JOIN edge USING (edge_id) JOIN crossroads ON node_id IN (from_node, to_node)
    GROUP BY roundabout_id;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_elements(name, jsonb) IS
    'The elements of a file of OpenDRIVE, by rank: the header, roads of edges, roads of ways from lane to lane, '
    'controllers, junctions, and the junctions of accepted roundabouts as groups.';
