-- Lanelet2: lanes between two borders, which neighbours and the ways across junctions share.

CREATE OR REPLACE FUNCTION streetgen._lanelet2_lane_class()
    RETURNS TABLE(type text, subtype text, participant text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES ('driving', 'road', 'vehicle'), ('bidirectional', 'road', 'vehicle'), ('entry', 'road', 'vehicle'),
        ('exit', 'road', 'vehicle'), ('bus', 'bus_lane', 'vehicle:bus'),
        ('HOV', 'road', 'vehicle:car:hov'), ('biking', 'bicycle_lane', 'bicycle') $$;
COMMENT ON FUNCTION streetgen._lanelet2_lane_class() IS
    'The subtype of lanelets, and who takes part in their traffic, by the type that lanes have in OpenDRIVE. A parking '
    'lane is no lanelet.';

CREATE OR REPLACE FUNCTION streetgen._lanelet2_tags(keys text[], words text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT string_agg(xmlelement(name tag, xmlattributes(k AS k, streetgen._xml_text(v) AS v))::text, ''
        ORDER BY n) FROM unnest(keys, words) WITH ORDINALITY u(k, v, n) WHERE v IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._lanelet2_tags(text[], text[]) IS
    'Elements tag, of the words that are not NULL.';

CREATE OR REPLACE FUNCTION streetgen._lanelet2_id(file_id bigint, number integer, nth integer DEFAULT 0)
    RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN (nth * 1000::bigint + number) * 2147483648 + file_id;
COMMENT ON FUNCTION streetgen._lanelet2_id(bigint, integer, integer) IS
    'The id of a line of what has file_id, by the number of the line from 1, and of a point of that line by its number '
    'from 1 (0: the line itself). Lanelets have ids below 2^31.';

CREATE OR REPLACE FUNCTION streetgen._lanelet2_elements(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    place AS MATERIALIZED (SELECT node_id, place_id, kind FROM streetgen._places(model, options)),
    side AS MATERIALIZED (SELECT value IS DISTINCT FROM 'left' AS right_hand FROM setting WHERE name = 'driving_side'),
    road AS MATERIALIZED (SELECT * FROM streetgen._opendrive_roads(model, options)),
    drawn AS NOT MATERIALIZED (SELECT * FROM road WHERE NOT connecting),
    connecting AS NOT MATERIALIZED (SELECT * FROM road WHERE connecting),
    -- Metres along roads, and the height there, where edges have heights.
    raised AS MATERIALIZED (
        SELECT road_id, array_agg(m ORDER BY m) AS stations, array_agg(z ORDER BY m) AS heights
        FROM (SELECT DISTINCT ON (road_id, round(ST_M(p.geom)::numeric, 3)) road_id, ST_M(p.geom) AS m,
                ST_Z(p.geom) AS z
            FROM drawn JOIN streetgen._heights_along(model) h USING (edge_id),
                ST_DumpPoints(ST_AddMeasure(ST_LineSubstring(h.geom, share_from, share_to), 0, total)) p
            ORDER BY road_id, round(ST_M(p.geom)::numeric, 3)) p
        GROUP BY road_id),
    -- Borders of a road have numbers from the left.
    border_point AS MATERIALIZED (
        SELECT road_id, number, nth, last, x1, y1, CASE WHEN heights IS NOT NULL THEN z1 END AS z1,
            nth = 1 OR last AS is_end, row_number() OVER (ORDER BY NOT (nth = 1 OR last), road_id, number, nth) AS n
        FROM origin o, drawn d LEFT JOIN raised USING (road_id), streetgen._chain_borders(d.s, d.x, d.y, d.heading,
            d.length, d.curvature, d.curvature_end, d.station, d.border, '{}', coalesce(stations, '{}'),
            coalesce(heights, '{}'), o.tolerance) b),
    -- Ends of two roads in one place, as at the corner of a kerb, are drawn apart along their borders.
    met AS MATERIALIZED (
        SELECT a.n FROM unnest(streetgen._first_within(
                (SELECT array_agg(v ORDER BY n, i) FROM border_point, unnest(ARRAY[x1, y1, coalesce(z1, 0)])
                    WITH ORDINALITY u(v, i) WHERE is_end),
                (SELECT array_agg(0::bigint) FROM border_point WHERE is_end), 0.05)) WITH ORDINALITY u(first, n)
            JOIN border_point a USING (n) JOIN border_point b ON b.n = u.first
        WHERE (a.road_id, a.last) <> (b.road_id, b.last)),
    road_point AS MATERIALIZED (
        SELECT road_id, number, nth, last, streetgen._lanelet2_id(road_id, number, nth) AS id,
            x1 + coalesce((x2 - x1) * share, 0) AS x, y1 + coalesce((y2 - y1) * share, 0) AS y, z1 AS z
        FROM (SELECT *, coalesce(lead(x1) OVER border, lag(x1) OVER border) AS x2,
                coalesce(lead(y1) OVER border, lag(y1) OVER border) AS y2
            FROM border_point WINDOW border AS (PARTITION BY road_id, number ORDER BY nth)) p,
            LATERAL (SELECT nullif(sqrt((x2 - x1) ^ 2 + (y2 - y1) ^ 2), 0) AS side) l,
            -- A border shorter than 0.1 m, of a lane between crossed limits, is that long.
            LATERAL (SELECT CASE WHEN side < 0.1 THEN (1 - 0.11 / side) / 2
                WHEN p.n IN (SELECT n FROM met) THEN least(0.11 / side, 0.25) END AS share) m),
    -- The bounds of a way across a junction, the left one first, begin and end in points of the lanes that it joins.
    way_end AS MATERIALIZED (
        SELECT w.road_id, v.number, a.id AS id_from, b.id AS id_to, ARRAY[a.x, a.y, b.x, b.y] AS places,
            ARRAY[a.z, b.z] AS heights
        FROM (SELECT c.*, f.lefts - c.number_in + (c.number_in > 0)::integer AS lane_from,
                t.lefts - c.number_out + (c.number_out > 0)::integer AS lane_to
            FROM connecting c JOIN drawn f ON f.road_id = c.road_in JOIN drawn t ON t.road_id = c.road_out) w
            CROSS JOIN (VALUES (1), (2)) v(number)
            JOIN road_point a ON (a.road_id, a.number) = (w.road_in, lane_from + ((v.number = 1) <> in_end)::integer)
                AND CASE WHEN in_end THEN a.last ELSE a.nth = 1 END
            JOIN road_point b ON (b.road_id, b.number) = (w.road_out, lane_to + ((v.number = 1) = out_end)::integer)
                AND CASE WHEN out_end THEN b.last ELSE b.nth = 1 END),
    way_point AS MATERIALIZED (
        SELECT road_id, number, nth, last, x1 AS x, y1 AS y, CASE WHEN raised THEN z1 END AS z
        FROM origin o, connecting c JOIN (
                SELECT a.road_id, a.places || b.places AS ends, a.heights, a.heights[1] + a.heights[2] IS NOT NULL
                    AS raised
                FROM way_end a JOIN way_end b USING (road_id) WHERE (a.number, b.number) = (1, 2)) e USING (road_id),
            streetgen._chain_borders(c.s, c.x, c.y, c.heading, c.length, c.curvature, c.curvature_end,
                ARRAY[0, c.total], ARRAY[width_in / 2, width_out / 2, -width_in / 2, -width_out / 2], ends,
                CASE WHEN raised THEN ARRAY[0, c.total] ELSE '{}' END, CASE WHEN raised THEN heights ELSE '{}' END,
                o.tolerance) b),
    -- Stop and yield lines, and signals as lines one metre wide, five metres above the ground.
    painted AS MATERIALIZED (
        SELECT streetgen._lanelet2_id(streetgen._file_id('lane', p.lane_id, along_axis::integer), number) AS id, p.*,
            r.heights[CASE WHEN along_axis THEN cardinality(heights) ELSE 1 END] AS height
        FROM (SELECT l.lane_id, m.along_axis, 1 AS number, m.kind,
                ST_MakeLine(ST_StartPoint(m.geom), ST_EndPoint(m.geom)) AS line
            FROM marking m JOIN lane l USING (edge_id, lane_position)
            WHERE m.kind IN ('stop', 'yield') AND NOT ST_IsEmpty(m.surface)
            UNION ALL SELECT h.lane_id, h.along_axis, 2, 'light',
                ST_MakeLine(ST_Translate(h.geom, -cos(radians(angle)) / 2, sin(radians(angle)) / 2),
                    ST_Translate(h.geom, cos(radians(angle)) / 2, -sin(radians(angle)) / 2))
            FROM streetgen._signal_heads(model) h) p
            JOIN (SELECT road_id, unnest(lanes) AS lane_id FROM drawn) d USING (lane_id)
            LEFT JOIN raised r USING (road_id)),
    walk AS MATERIALIZED (SELECT * FROM streetgen._lanelet2_walks(model, options)),
    -- Each line and its points. The ends of roads are apart from those of others.
    line_point AS MATERIALIZED (
        SELECT streetgen._lanelet2_id(road_id, number) AS line_id, nth, id, x, y, z,
            CASE WHEN last THEN 2 * road_id + 1 WHEN nth = 1 THEN 2 * road_id ELSE 0 END AS kept
        FROM road_point
        UNION ALL SELECT streetgen._lanelet2_id(road_id, number), nth, CASE WHEN nth = 1 THEN id_from
            WHEN last THEN id_to ELSE streetgen._lanelet2_id(road_id, number, nth) END, x, y, z, 0
        FROM way_point JOIN way_end USING (road_id, number)
        UNION ALL SELECT p.id, path[1], streetgen._lanelet2_id(streetgen._file_id('lane', lane_id, along_axis::integer),
            number, path[1]), ST_X(geom), ST_Y(geom),
            CASE kind WHEN 'light' THEN 5 + coalesce(height, 0) ELSE height END, 0
        FROM painted p, ST_DumpPoints(line)
        UNION ALL SELECT streetgen._lanelet2_id(file_id, number), nth, streetgen._lanelet2_id(file_id, number, nth),
            x, y, z, 0
        FROM walk),
    -- Points that a reader finds too near to each other are one.
    numbered AS MATERIALIZED (
        SELECT *, row_number() OVER (ORDER BY kept = 0, id) AS n
        FROM (SELECT id, max(kept) AS kept, min(x) AS x, min(y) AS y, min(z) AS z FROM line_point GROUP BY id) p),
    point AS MATERIALIZED (
        SELECT p.id AS of_id, f.* FROM unnest(streetgen._first_within(
                (SELECT array_agg(v ORDER BY n, i) FROM numbered, unnest(ARRAY[x, y, coalesce(z, 0)])
                    WITH ORDINALITY u(v, i)),
                (SELECT array_agg(kept ORDER BY n) FROM numbered), 0.05)) WITH ORDINALITY u(first, n)
            JOIN numbered p USING (n) JOIN numbered f ON f.n = u.first),
    bound AS MATERIALIZED (
        SELECT line_id AS id, string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth) AS nodes
        FROM (SELECT line_id, nth, p.id, lag(p.id) OVER (PARTITION BY line_id ORDER BY nth) AS before
            FROM line_point l JOIN point p ON p.of_id = l.id) l
        WHERE before IS DISTINCT FROM id GROUP BY line_id),
    -- Lanelets are told where to turn at nodes of three streets and more.
    crossroads AS MATERIALIZED (
        SELECT place_id FROM edge, LATERAL (VALUES (from_node), (to_node)) e(node_id) JOIN place USING (node_id)
        WHERE edge_id NOT IN (SELECT streetgen._edges_inside(options)) GROUP BY place_id HAVING count(*) > 2),
    turning AS MATERIALIZED (
        SELECT c.road_id, CASE coalesce(w.turn, CASE WHEN abs(angle) < pi() / 4 THEN 'through'
                WHEN angle > 0 THEN 'left' ELSE 'right' END) WHEN 'through' THEN 'straight'
            WHEN 'right' THEN 'right' WHEN 'left' THEN 'left'
            ELSE CASE WHEN right_hand THEN 'left' ELSE 'right' END END AS turn_direction
        FROM side, connecting c JOIN place n USING (node_id) JOIN crossroads USING (place_id)
            LEFT JOIN streetgen._connecting_ways(model, options) w ON array_to_string(w.interconnections, ' ') = c.ways,
            LATERAL (SELECT sum(l * (a + b) / 2) AS angle FROM unnest(c.length, c.curvature, c.curvature_end)
                u(l, a, b)) t),
    -- The border at the right of a lane, along its road, has the number after that at its left.
    lanelet AS MATERIALIZED (
        SELECT l.*, k.subtype, k.participant
        FROM (SELECT streetgen._file_id('lane', d.lanes[i]) AS id, d.road_id, i, d.lanes[i] AS lane_id,
                d.types[i] AS type, e.speed, (i > lefts) = right_hand AS along, d.edge_id, NULL::bigint AS node_id,
                NULL::bigint AS lane_in, NULL::boolean AS along_in
            FROM side, drawn d CROSS JOIN LATERAL generate_series(1, cardinality(d.lanes)) i
                JOIN edge e USING (edge_id)
            UNION ALL SELECT c.road_id, c.road_id, 1, NULL, c.type, c.speed, true, NULL, c.node_id, c.lane_in, c.in_end
            FROM connecting c) l
            JOIN streetgen._lanelet2_lane_class() k USING (type)),
    -- Traffic that comes over a line, painted or not, gives way to that which comes over none.
    obeying AS MATERIALIZED (
        SELECT w.id, n.place_id, p.id AS line_id, m.marking_id IS NOT NULL AS yields
        FROM lanelet w JOIN place n USING (node_id) JOIN lane l ON l.lane_id = w.lane_in
            LEFT JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis) = (l.edge_id, l.lane_position, w.along_in)
                AND m.kind IN ('stop', 'yield')
            LEFT JOIN painted p ON (p.lane_id, p.along_axis, p.number) = (w.lane_in, w.along_in, 1)
        WHERE n.kind IS DISTINCT FROM 'signals'),
    regulating AS MATERIALIZED (
        SELECT streetgen._file_id('node', place_id) AS id, array_agg(id ORDER BY id) AS lanelets,
            string_agg('<member type="relation" ref="' || id || '" role="'
                || CASE WHEN yields THEN 'yield' ELSE 'right_of_way' END || '"/>', '' ORDER BY id)
            || coalesce(string_agg(DISTINCT '<member type="way" ref="' || line_id || '" role="ref_line"/>', ''), '')
            || streetgen._lanelet2_tags('{type,subtype}', '{regulatory_element,right_of_way}') AS text
        FROM obeying GROUP BY place_id HAVING count(*) FILTER (WHERE yields) BETWEEN 1 AND count(*) - 1
        UNION ALL SELECT streetgen._file_id('lane', p.lane_id, 1 + p.along_axis::integer), ARRAY[w.id],
            '<member type="way" ref="' || p.id || '" role="refers"/>'
            || coalesce('<member type="way" ref="' || s.id || '" role="ref_line"/>', '')
            || streetgen._lanelet2_tags('{type,subtype}', '{regulatory_element,traffic_light}')
        FROM painted p JOIN lanelet w USING (lane_id)
            LEFT JOIN painted s ON (s.lane_id, s.along_axis, s.number) = (p.lane_id, p.along_axis, 1)
        WHERE p.number = 2
        UNION ALL SELECT streetgen._lanelet2_id(file_id, 3), array_agg(w.id ORDER BY w.id),
            '<member type="relation" ref="' || file_id || '" role="refers"/>'
            || coalesce(string_agg('<member type="way" ref="' || p.id || '" role="ref_line"/>', '' ORDER BY p.id), '')
            || streetgen._lanelet2_tags('{type,subtype}', '{regulatory_element,crosswalk}')
        FROM (SELECT DISTINCT file_id, edge_id, line FROM walk WHERE subtype = 'crosswalk') k
            JOIN lanelet w USING (edge_id) LEFT JOIN painted p ON p.number = 1 AND p.lane_id = w.lane_id
                AND ST_DWithin(p.line, k.line, 10)
        WHERE options ->> 'autoware' = 'yes' GROUP BY file_id),
    with_room AS MATERIALIZED (SELECT edge_id FROM streetgen._room_beside_lanes(model)),
    -- The tags of the lines of roads, and of those that are painted.
    line_kind AS (
        SELECT streetgen._lanelet2_id(b.road_id, b.number) AS id, CASE
            WHEN b.number IN (1, cardinality(d.lanes) + 1) AND d.edge_id NOT IN (SELECT edge_id FROM with_room)
                THEN streetgen._lanelet2_tags('{type,subtype}', '{curbstone,high}')
            WHEN m.paint IS NULL THEN streetgen._lanelet2_tags('{type,lane_change,lane_change:left,lane_change:right}',
                ARRAY['virtual', CASE WHEN leftwards AND rightwards THEN 'yes' END,
                    CASE WHEN leftwards AND NOT rightwards THEN 'yes' END,
                    CASE WHEN rightwards AND NOT leftwards THEN 'yes' END])
            ELSE streetgen._lanelet2_tags('{type,subtype}', ARRAY['line_thin', CASE WHEN m.paint <> 'mixed'
                THEN m.paint WHEN m.leftwards THEN 'solid_dashed' ELSE 'dashed_solid' END]) END AS tags
        FROM (SELECT DISTINCT road_id, number FROM road_point) b JOIN drawn d USING (road_id)
            LEFT JOIN streetgen._lines_between(model) m ON (m.edge_id, m.lane_position) = (d.edge_id,
                d.before + b.number - 1)
        UNION ALL SELECT id, CASE kind WHEN 'light'
            THEN streetgen._lanelet2_tags('{type,subtype,height}', '{traffic_light,red_yellow_green,1}')
            ELSE streetgen._lanelet2_tags('{type}', '{stop_line}') END
        FROM painted),
    regulated AS (
        SELECT lanelet AS id, string_agg('<member type="relation" ref="' || r.id || '" role="regulatory_element"/>', ''
            ORDER BY r.id) AS text
        FROM regulating r, unnest(lanelets) lanelet GROUP BY lanelet)
    SELECT 1, id, '<node id="' || id || '" version="1" visible="true" lat="'
        || streetgen._decimal(ST_Y(place), 11) || '" lon="' || streetgen._decimal(ST_X(place), 11)
        || coalesce('">' || nullif(concat('<tag k="ele" v="' || streetgen._decimal(p.z, 3) || '"/>', CASE WHEN local
            THEN '<tag k="local_x" v="' || streetgen._decimal(p.x - o.x, 3) || '"/><tag k="local_y" v="'
                || streetgen._decimal(p.y - o.y, 3) || '"/>' END), '') || '</node>', '"/>')
    FROM origin o, (SELECT DISTINCT id, x, y, z FROM point) p,
        ST_Transform(ST_SetSRID(ST_MakePoint(p.x, p.y), o.srid), 4326) place,
        (SELECT options ->> 'autoware' = 'yes' AS local) c
    UNION ALL SELECT 2, id, '<way id="' || id || '" version="1" visible="true">' || nodes
        || coalesce(tags, streetgen._lanelet2_tags('{type}', '{virtual}')) || '</way>'
    FROM bound LEFT JOIN line_kind USING (id)
    UNION ALL SELECT 3, l.id, '<relation id="' || l.id || '" version="1" visible="true"><member type="way" ref="'
        || streetgen._lanelet2_id(road_id, CASE WHEN along THEN i ELSE i + 1 END)
        || '" role="left"/><member type="way" ref="'
        || streetgen._lanelet2_id(road_id, CASE WHEN along THEN i + 1 ELSE i END)
        || '" role="right"/>' || coalesce(r.text, '')
        || streetgen._lanelet2_tags(ARRAY['type', 'subtype', 'location', 'one_way', 'speed_limit',
            'participant:' || participant, 'turn_direction', 'name'], ARRAY['lanelet', subtype,
            CASE WHEN t.word IS NULL THEN 'urban' ELSE 'private' END,
            CASE type WHEN 'bidirectional' THEN 'no' ELSE 'yes' END, round(l.speed::numeric, 1) || ' km/h', 'yes',
            turn_direction, a.name]) || '</relation>'
    FROM lanelet l LEFT JOIN regulated r USING (id) LEFT JOIN streetgen._lanes_without_through(model) t USING (lane_id)
        LEFT JOIN turning USING (road_id) LEFT JOIN edge e USING (edge_id)
        LEFT JOIN (SELECT axis_id, name FROM axis) a USING (axis_id)
    UNION ALL SELECT 3, file_id, '<relation id="' || file_id || '" version="1" visible="true"><member type="way" ref="'
        || streetgen._lanelet2_id(file_id, 1) || '" role="left"/><member type="way" ref="'
        || streetgen._lanelet2_id(file_id, 2) || '" role="right"/>'
        || streetgen._lanelet2_tags('{type,subtype,location,one_way,participant:pedestrian}',
            ARRAY['lanelet', subtype, 'urban', 'no', 'yes']) || '</relation>'
    FROM (SELECT DISTINCT file_id, subtype FROM walk) w
    UNION ALL SELECT 4, id, '<relation id="' || id || '" version="1" visible="true">' || text || '</relation>'
    FROM regulating;
END $$;
COMMENT ON FUNCTION streetgen._lanelet2_elements(name, jsonb) IS
    'The elements of a file of Lanelet2, by rank: nodes, ways, lanelets, and what regulates them.';

CREATE OR REPLACE FUNCTION streetgen.export_lanelet2(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'lanelet2', 'interconnection', options);
BEGIN
    RETURN QUERY SELECT row_number() OVER (ORDER BY rank, ref, text), text
        FROM (SELECT rank, ref, ('    ' || markup) COLLATE "C" AS text
            FROM streetgen._lanelet2_elements(model, known)
            UNION ALL SELECT rank, ref, markup COLLATE "C"
            FROM streetgen._xml_frame('<osm version="0.6" generator="StreetGen">', '</osm>')) l
        ORDER BY rank, ref, text;
END $$;
COMMENT ON FUNCTION streetgen.export_lanelet2(name, jsonb) IS
    'A file of Lanelet2, OSM XML, line by line. A lane is a lanelet between two borders, which neighbours share, and '
    'an interconnection that connects is a lanelet whose bounds begin and end in the points of those of its lanes. '
    'No bound folds: inside a tight turn it is cut where it crosses itself, so that the lane is as wide as ever. '
    'Borders between lanes are lines, dashed where the model has dashes, which one may cross then, '
    'solid_dashed or dashed_solid where only one side may; the outer ones are curbstones, but where roadway lies '
    'beside the lanes. Lanelets have '
    'the speed limit and the name of their street, say who drives there and whether one way only, and have location '
    'private where nobody may drive through. Those across nodes of three streets and more have turn_direction. A '
    'junction with stop or yield lines has a regulatory element right_of_way, and with subject '
    'signal each lane that waits for lights has one of traffic_light. Sidewalks along edges are lanelets of subtype '
    'walkway, crossings of subtype crosswalk. Parking and closed lanes are left out. Ids are those of '
    'streetgen._file_id, and beyond 2^31 for points and lines. Points nearer than 5 cm to each other are one. '
    'Coordinates are WGS 84; ele is the height of profiles where the model computes them, else of axes that have any. '
    'Option autoware adds local_x and local_y, and a regulatory element crosswalk for each crossing, which the library '
    'alone does not know. Junctions, references and other options are those of export_opendrive. An unknown '
    'option, or no edge that they take: 22023. A caller who may not read the model: 42501; a model without '
    'interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a warning.';
