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
    'from 1 (0: the line itself). Lanelets and what regulates them have ids below 2^31.';

CREATE OR REPLACE FUNCTION streetgen._lanelet2_elements(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    joined_node AS MATERIALIZED (SELECT * FROM streetgen._joined_nodes(model, options)),
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
    road_point AS MATERIALIZED (
        SELECT road_id, number, nth, last, streetgen._lanelet2_id(road_id, number, nth) AS id, x1 AS x, y1 AS y,
            CASE WHEN heights IS NOT NULL THEN z1 END AS z
        FROM origin o, drawn d LEFT JOIN raised USING (road_id), streetgen._chain_borders(d.s, d.x, d.y, d.heading,
            d.length, d.curvature, d.curvature_end, d.station, d.border, '{}', coalesce(stations, '{}'),
            coalesce(heights, '{}'), o.tolerance) b),
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
        SELECT road_id, number, nth, streetgen._lanelet2_id(road_id, number, nth) AS id, x1 AS x, y1 AS y,
            CASE WHEN raised THEN z1 END AS z
        FROM origin o, connecting c JOIN (
                SELECT a.road_id, a.places || b.places AS ends, a.heights, a.heights[1] + a.heights[2] IS NOT NULL
                    AS raised
                FROM way_end a JOIN way_end b USING (road_id) WHERE (a.number, b.number) = (1, 2)) e USING (road_id),
            streetgen._chain_borders(c.s, c.x, c.y, c.heading, c.length, c.curvature, c.curvature_end,
                ARRAY[0, c.total], ARRAY[width_in / 2, width_out / 2, -width_in / 2, -width_out / 2], ends,
                CASE WHEN raised THEN ARRAY[0, c.total] ELSE '{}' END, CASE WHEN raised THEN heights ELSE '{}' END,
                o.tolerance) b
        WHERE nth > 1 AND NOT last),
    -- Stop and yield lines, and signals as lines one metre wide.
    painted AS MATERIALIZED (
        SELECT streetgen._lanelet2_id(streetgen._file_id('lane', lane_id, along_axis::integer), number) AS id, p.*
        FROM (SELECT l.lane_id, l.edge_id, m.along_axis, 1 AS number, m.kind,
                ST_MakeLine(ST_StartPoint(m.geom), ST_EndPoint(m.geom)) AS line
            FROM marking m JOIN lane l USING (edge_id, lane_position)
            WHERE m.kind IN ('stop', 'yield') AND NOT ST_IsEmpty(m.surface)
            UNION ALL SELECT l.lane_id, l.edge_id, h.along_axis, 2, 'light',
                ST_MakeLine(ST_Translate(h.geom, -cos(radians(angle)) / 2, sin(radians(angle)) / 2),
                    ST_Translate(h.geom, cos(radians(angle)) / 2, -sin(radians(angle)) / 2))
            FROM streetgen._signal_heads(model) h JOIN lane l USING (lane_id)) p
        WHERE edge_id IN (SELECT edge_id FROM drawn)),
    painted_point AS MATERIALIZED (
        SELECT p.id AS line_id, d.path[1] AS nth,
            streetgen._lanelet2_id(streetgen._file_id('lane', lane_id, along_axis::integer), number, d.path[1]) AS id,
            ST_X(d.geom) AS x, ST_Y(d.geom) AS y, NULL::float8 AS z
        FROM painted p, ST_DumpPoints(line) d),
    point AS MATERIALIZED (
        SELECT id, x, y, z FROM road_point UNION ALL SELECT id, x, y, z FROM way_point
        UNION ALL SELECT id, x, y, z FROM painted_point),
    bound AS MATERIALIZED (
        SELECT streetgen._lanelet2_id(road_id, number) AS id, 'border' AS kind, road_id, number,
            string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth) AS nodes
        FROM road_point GROUP BY road_id, number
        UNION ALL SELECT streetgen._lanelet2_id(road_id, number), 'way', road_id, number, '<nd ref="' || id_from
            || '"/>' || coalesce(p.nodes, '') || '<nd ref="' || id_to || '"/>'
        FROM way_end LEFT JOIN (SELECT road_id, number, string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth) AS nodes
            FROM way_point GROUP BY road_id, number) p USING (road_id, number)
        UNION ALL SELECT p.id, kind, NULL, NULL, string_agg('<nd ref="' || d.id || '"/>', '' ORDER BY nth)
        FROM painted p JOIN painted_point d ON d.line_id = p.id GROUP BY p.id, kind),
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
        FROM lanelet w JOIN joined_node n USING (node_id) JOIN lane l ON l.lane_id = w.lane_in
            LEFT JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis) = (l.edge_id, l.lane_position, w.along_in)
                AND m.kind IN ('stop', 'yield')
            LEFT JOIN painted p ON (p.lane_id, p.along_axis, p.number) = (w.lane_in, w.along_in, 1)
        WHERE n.place_id NOT IN (SELECT place_id FROM streetgen._places(model, options) WHERE kind = 'signals')),
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
        WHERE p.number = 2),
    with_room AS MATERIALIZED (SELECT edge_id FROM streetgen._room_beside_lanes(model)),
    regulated AS (
        SELECT lanelet AS id, string_agg('<member type="relation" ref="' || r.id || '" role="regulatory_element"/>', ''
            ORDER BY r.id) AS text
        FROM regulating r, unnest(lanelets) lanelet GROUP BY lanelet)
    SELECT 1, id, '<node id="' || id || '" version="1" visible="true" lat="'
        || streetgen._decimal(ST_Y(place), 11) || '" lon="' || streetgen._decimal(ST_X(place), 11)
        || coalesce('">' || streetgen._lanelet2_tags('{ele}', ARRAY[streetgen._decimal(p.z, 3)]) || '</node>', '"/>')
    FROM origin o, point p, ST_Transform(ST_SetSRID(ST_MakePoint(p.x, p.y), o.srid), 4326) place
    UNION ALL SELECT 2, b.id, '<way id="' || b.id || '" version="1" visible="true">' || nodes || CASE b.kind
        WHEN 'way' THEN streetgen._lanelet2_tags('{type}', '{virtual}')
        WHEN 'light' THEN streetgen._lanelet2_tags('{type,subtype}', '{traffic_light,red_yellow_green}')
        WHEN 'border' THEN CASE WHEN b.number IN (1, cardinality(d.lanes) + 1)
                    AND d.edge_id NOT IN (SELECT edge_id FROM with_room)
                THEN streetgen._lanelet2_tags('{type,subtype}', '{curbstone,high}')
            WHEN m.paint IS NULL THEN streetgen._lanelet2_tags('{type}', '{virtual}')
            ELSE streetgen._lanelet2_tags('{type,subtype}', ARRAY['line_thin', CASE WHEN m.paint <> 'mixed'
                THEN m.paint WHEN m.leftwards THEN 'solid_dashed' ELSE 'dashed_solid' END]) END
        ELSE streetgen._lanelet2_tags('{type}', '{stop_line}') END || '</way>'
    FROM bound b LEFT JOIN drawn d ON b.kind = 'border' AND d.road_id = b.road_id
        LEFT JOIN streetgen._lines_between(model) m ON (m.edge_id, m.lane_position) = (d.edge_id,
            d.before + b.number - 1)
    UNION ALL SELECT 3, l.id, '<relation id="' || l.id || '" version="1" visible="true"><member type="way" ref="'
        || streetgen._lanelet2_id(road_id, CASE WHEN along THEN i ELSE i + 1 END)
        || '" role="left"/><member type="way" ref="'
        || streetgen._lanelet2_id(road_id, CASE WHEN along THEN i + 1 ELSE i END)
        || '" role="right"/>' || coalesce(r.text, '')
        || streetgen._lanelet2_tags(ARRAY['type', 'subtype', 'location', 'one_way', 'speed_limit',
            'participant:' || participant, 'access', 'edge'], ARRAY['lanelet', subtype, 'urban',
            CASE type WHEN 'bidirectional' THEN 'no' ELSE 'yes' END, round(speed::numeric, 1) || ' km/h', 'yes', t.word,
            edge_id::text]) || '</relation>'
    FROM lanelet l LEFT JOIN regulated r USING (id) LEFT JOIN streetgen._lanes_without_through(model) t USING (lane_id)
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
    'the speed limit of their edge, say who drives there and whether one way only, and '
    'name their edge; access is the word of axis.access where nobody may drive through. A junction with stop or yield '
    'lines has a regulatory element right_of_way, and with subject '
    'signal each lane that waits for lights has one of traffic_light. Parking lanes are left out. Ids are those of '
    'streetgen._file_id, and of points and lines of a lane and a way beyond 2^31. Coordinates are '
    'WGS 84; ele is the height of profiles where the model computes them, else of axes that have any. Junctions, '
    'references and options are those of export_opendrive. An unknown '
    'option, or no edge that they take: 22023. A caller who may not read the model: 42501; a model without '
    'interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a warning.';
