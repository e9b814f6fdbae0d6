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

CREATE OR REPLACE FUNCTION streetgen._lanelet2_elements(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Borders of roads have source 1 and a number from the left, those of ways across junctions source 2 and, the left
    -- one, number 1. Lines where drivers wait have source 3, lights 4.
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    joined_node AS MATERIALIZED (SELECT * FROM streetgen._joined_nodes(model, options)),
    side AS MATERIALIZED (SELECT value IS DISTINCT FROM 'left' AS right_hand FROM setting WHERE name = 'driving_side'),
    road AS MATERIALIZED (SELECT * FROM streetgen._opendrive_roads(model, options)),
    drawn AS NOT MATERIALIZED (SELECT * FROM road WHERE NOT connecting),
    connecting AS NOT MATERIALIZED (SELECT * FROM road WHERE connecting),
    road_point AS MATERIALIZED (
        SELECT road_id, number, nth, last, x1 AS x, y1 AS y FROM origin o, drawn d, streetgen._chain_borders(d.s, d.x,
            d.y,
            d.heading, d.length, d.curvature, d.curvature_end, d.station, d.border, o.tolerance) b),
    -- A way across a junction has points of its own between those of the lanes that it joins.
    way_point AS MATERIALIZED (
        SELECT road_id, number, nth, b.x1 AS x, b.y1 AS y FROM origin o, connecting c,
            streetgen._chain_borders(c.s, c.x, c.y, c.heading, c.length, c.curvature, c.curvature_end, ARRAY[0,
                c.total],
                ARRAY[width_in / 2, width_out / 2, -width_in / 2, -width_out / 2], o.tolerance) b
        WHERE nth > 1 AND NOT last),
    -- Stop and yield lines, and signals as lines one metre wide.
    painted AS MATERIALIZED (
        SELECT m.marking_id AS key, 3 AS source, m.edge_id, m.lane_position, m.along_axis, m.kind, m.geom
        FROM marking m WHERE m.kind IN ('stop', 'yield') AND NOT ST_IsEmpty(m.surface)
            AND m.edge_id IN (SELECT edge_id FROM drawn)
        UNION ALL SELECT h.lane_id, 4, l.edge_id, l.lane_position, h.along_axis, 'light',
            ST_MakeLine(ST_Translate(h.geom, -cos(radians(angle)) / 2, sin(radians(angle)) / 2),
                ST_Translate(h.geom, cos(radians(angle)) / 2, -sin(radians(angle)) / 2))
        FROM streetgen._signal_heads(model) h JOIN lane l USING (lane_id) WHERE l.edge_id IN (SELECT edge_id
            FROM drawn)),
    point AS MATERIALIZED (
        SELECT *, row_number() OVER (ORDER BY source, key, number, nth, way) AS id
        FROM (SELECT 1 AS source, road_id AS key, number, nth, last, NULL::boolean AS way, x, y FROM road_point
            UNION ALL SELECT 2, road_id, number, nth, NULL, NULL, x, y FROM way_point
            UNION ALL SELECT source, key, 1, p.path[1], NULL, along_axis, ST_X(p.geom), ST_Y(p.geom)
            FROM painted, ST_DumpPoints(ST_MakeLine(ST_StartPoint(geom), ST_EndPoint(geom))) p) p),
    road_bound AS (
        SELECT key AS road_id, number, string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth) AS nodes,
            min(id) FILTER (WHERE nth = 1) AS first, min(id) FILTER (WHERE last) AS last
        FROM point WHERE source = 1 GROUP BY key, number),
    bound AS MATERIALIZED (
        SELECT *, (SELECT count(*) FROM point) + row_number() OVER (ORDER BY source, key, number, way) AS id
        FROM (SELECT 1 AS source, road_id AS key, number, NULL::boolean AS way, first, last, nodes FROM road_bound
            UNION ALL SELECT 2, c.road_id, v.number, NULL, NULL, NULL, '<nd ref="'
                || CASE WHEN c.in_end THEN a.last ELSE a.first END || '"/>' || coalesce(p.nodes, '') || '<nd ref="'
                || CASE WHEN c.out_end THEN b.last ELSE b.first END || '"/>'
            FROM connecting c JOIN drawn f ON f.road_id = c.road_in JOIN drawn t ON t.road_id = c.road_out
                CROSS JOIN (VALUES (1), (2)) v(number)
                JOIN road_bound a ON (a.road_id, a.number) = (c.road_in, f.lefts - c.number_in
                    + CASE WHEN c.number_in > 0 THEN 1 ELSE 0 END + CASE WHEN (v.number = 1) = c.in_end THEN 0 ELSE 1
                        END)
                JOIN road_bound b ON (b.road_id, b.number) = (c.road_out, t.lefts - c.number_out
                    + CASE WHEN c.number_out > 0 THEN 1 ELSE 0 END + CASE WHEN (v.number = 1) = c.out_end THEN 1
                        ELSE 0 END)
                LEFT JOIN (SELECT key, number, string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth) AS nodes
                    FROM point
                    WHERE source = 2 GROUP BY key, number) p ON (p.key, p.number) = (c.road_id, v.number)
            UNION ALL SELECT source, key, 1, way, NULL, NULL, string_agg('<nd ref="' || id || '"/>', '' ORDER BY nth)
            FROM point WHERE source > 2 GROUP BY source, key, way) b),
    painted_bound AS MATERIALIZED (
        SELECT p.*, b.id FROM painted p JOIN bound b ON (b.source, b.key) = (p.source, p.key)
            AND b.way IS NOT DISTINCT FROM p.along_axis),
    -- The border at the right of a lane, along its road, has the number after that at its left.
    lanelet AS MATERIALIZED (
        SELECT l.*, (SELECT max(id) FROM bound) + row_number() OVER (ORDER BY road_id, i)
            AS id, k.subtype, k.participant
        FROM (SELECT d.road_id, i, d.lanes[i] AS lane_id, d.types[i] AS type, e.speed,
                (i > lefts) = right_hand AS along, a.id AS border, d.edge_id, NULL::bigint AS node_id,
                NULL::bigint AS lane_in, NULL::boolean AS along_in
            FROM side, drawn d CROSS JOIN LATERAL generate_series(1, cardinality(d.lanes)) i
                JOIN edge e USING (edge_id) JOIN bound a ON (a.source, a.key, a.number) = (1, d.road_id, i)
            UNION ALL SELECT c.road_id, 1, NULL, c.type, c.speed, true, a.id, NULL, c.node_id, c.lane_in, c.in_end
            FROM connecting c JOIN bound a ON (a.source, a.key, a.number) = (2, c.road_id, 1)) l
            JOIN streetgen._lanelet2_lane_class() k USING (type)),
    -- Traffic that comes over a line, painted or not, gives way to that which comes over none.
    obeying AS MATERIALIZED (
        SELECT w.id, n.place_id, p.id AS line_id, m.marking_id IS NOT NULL AS yields
        FROM lanelet w JOIN joined_node n USING (node_id) JOIN lane l ON l.lane_id = w.lane_in
            LEFT JOIN marking m ON (m.edge_id, m.lane_position, m.along_axis) = (l.edge_id, l.lane_position, w.along_in)
                AND m.kind IN ('stop', 'yield')
            LEFT JOIN painted_bound p ON (p.source, p.key) = (3, m.marking_id)
        WHERE n.place_id NOT IN (SELECT place_id FROM streetgen._places(model, options) WHERE kind = 'signals')),
    regulating AS MATERIALIZED (
        SELECT *, (SELECT max(id) FROM lanelet) + row_number() OVER (ORDER BY source, key, way) AS id
        FROM (SELECT 1 AS source, place_id AS key, NULL::boolean AS way, array_agg(id ORDER BY id) AS lanelets,
                string_agg('<member type="relation" ref="' || id || '" role="'
                    || CASE WHEN yields THEN 'yield' ELSE 'right_of_way' END || '"/>', '' ORDER BY id)
                || coalesce(string_agg(DISTINCT '<member type="way" ref="' || line_id || '" role="ref_line"/>', ''), '')
                || streetgen._lanelet2_tags('{type,subtype}', '{regulatory_element,right_of_way}') AS text
            FROM obeying GROUP BY place_id HAVING count(*) FILTER (WHERE yields) BETWEEN 1 AND count(*) - 1
            UNION ALL SELECT 2, p.key, p.along_axis, array_agg(w.id), '<member type="way" ref="' || p.id
                || '" role="refers"/>' || coalesce('<member type="way" ref="' || min(s.id) || '" role="ref_line"/>', '')
                || streetgen._lanelet2_tags('{type,subtype}', '{regulatory_element,traffic_light}')
            FROM painted_bound p JOIN lanelet w ON w.lane_id = p.key LEFT JOIN painted_bound s ON s.source = 3
                AND (s.edge_id, s.lane_position, s.along_axis) = (p.edge_id, p.lane_position, p.along_axis)
            WHERE p.source = 4 GROUP BY p.key, p.along_axis, p.id) r),
    with_room AS MATERIALIZED (SELECT edge_id FROM streetgen._room_beside_lanes(model)),
    regulated AS (
        SELECT lanelet AS id, string_agg('<member type="relation" ref="' || r.id || '" role="regulatory_element"/>', ''
            ORDER BY r.id) AS text
        FROM regulating r, unnest(lanelets) lanelet GROUP BY lanelet)
    SELECT 1, id, '<node id="' || id || '" version="1" visible="true" lat="'
        || streetgen._decimal(ST_Y(place), 11) || '" lon="' || streetgen._decimal(ST_X(place), 11) || '"/>'
    FROM origin o, point p, ST_Transform(ST_SetSRID(ST_MakePoint(p.x, p.y), o.srid), 4326) place
    UNION ALL SELECT 2, b.id, '<way id="' || b.id || '" version="1" visible="true">' || nodes || CASE b.source
        WHEN 2 THEN streetgen._lanelet2_tags('{type}', '{virtual}')
        WHEN 3 THEN streetgen._lanelet2_tags('{type}', '{stop_line}')
        WHEN 4 THEN streetgen._lanelet2_tags('{type,subtype}', '{traffic_light,red_yellow_green}')
        ELSE CASE WHEN b.number IN (1, cardinality(d.lanes) + 1) AND d.edge_id NOT IN (SELECT edge_id FROM with_room)
                THEN streetgen._lanelet2_tags('{type,subtype}', '{curbstone,high}')
            WHEN m.paint IS NULL THEN streetgen._lanelet2_tags('{type}', '{virtual}')
            ELSE streetgen._lanelet2_tags('{type,subtype}', ARRAY['line_thin', CASE WHEN m.paint <> 'mixed'
                THEN m.paint WHEN m.leftwards THEN 'solid_dashed' ELSE 'dashed_solid' END]) END END || '</way>'
    FROM bound b LEFT JOIN drawn d ON b.source = 1 AND d.road_id = b.key
        LEFT JOIN streetgen._lines_between(model) m ON (m.edge_id, m.lane_position) = (d.edge_id,
            d.before + b.number - 1)
    UNION ALL SELECT 3, l.id, '<relation id="' || l.id || '" version="1" visible="true"><member type="way" ref="'
        || CASE WHEN along THEN border ELSE border + 1 END || '" role="left"/><member type="way" ref="'
        || CASE WHEN along THEN border + 1 ELSE border END || '" role="right"/>' || coalesce(r.text, '')
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
    'an interconnection that connects is a lanelet whose borders begin and end in the points of those of its lanes. '
    'Borders between lanes are lines, dashed where the model has dashes, which one may cross then, '
    'solid_dashed or dashed_solid where only one side may; the outer ones are curbstones, but where roadway lies '
    'beside the lanes. Lanelets have '
    'the speed limit of their edge, say who drives there and whether one way only, and '
    'name their edge; access is the word of axis.access where nobody may drive through. A junction with stop or yield '
    'lines has a regulatory element right_of_way, and with subject '
    'signal each lane that waits for lights has one of traffic_light. Parking lanes are left out. Coordinates are '
    'WGS 84, heights are left out. Junctions, references and options are those of export_opendrive. An unknown '
    'option, or no edge that they take: 22023. A caller who may not read the model: 42501; a model without '
    'interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a warning.';
