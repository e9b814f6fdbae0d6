-- ASAM OpenDRIVE 1.7: roads of lines and arcs with lanes across them, and a road for each movement.

CREATE OR REPLACE FUNCTION streetgen._opendrive_lane_type(kind text, both_ways boolean, turn text DEFAULT NULL)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN both_ways THEN 'bidirectional' WHEN kind = 'general' THEN 'driving'
        WHEN kind = 'merging' THEN CASE WHEN turn LIKE 'merge%' THEN 'entry' ELSE 'exit' END
        WHEN kind = 'cycle' THEN 'biking' ELSE kind END;
COMMENT ON FUNCTION streetgen._opendrive_lane_type(text, boolean, text) IS
    'The type that a lane has in OpenDRIVE, by its kind, whether both directions use it, and where it leads.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_open(element xml) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN left(element::text, -2) || '>';
COMMENT ON FUNCTION streetgen._opendrive_open(xml) IS 'The opening tag of an empty element.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_plan(s float8[], x float8[], y float8[], heading float8[],
    length float8[], curvature float8[], curvature_end float8[], x0 float8, y0 float8, digits integer) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_opendrive_plan';
COMMENT ON FUNCTION streetgen._opendrive_plan(float8[], float8[], float8[], float8[], float8[], float8[], float8[],
    float8, float8, integer) IS 'The element planView of a chain, from an origin x0, y0.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_change(element text, place text, station float8[], value float8[])
    RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME', 'streetgen_opendrive_change';
COMMENT ON FUNCTION streetgen._opendrive_change(text, text, float8[], float8[]) IS
    'Elements of polynomials that are straight from station to station; place is the attribute that says where.';

-- Most roads are of one stretch: no arrays are made for these.
CREATE OR REPLACE FUNCTION streetgen._opendrive_step(element text, place text, length float8, "from" float8,
    "to" float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '<' || element || ' ' || place || '="0.0000000" a="' || streetgen._decimal("from", 5)
        || '" b="' || streetgen._decimal(("to" - "from") / length, 9) || '" c="0" d="0"/>';
COMMENT ON FUNCTION streetgen._opendrive_step(text, text, float8, float8, float8) IS
    'The element of a polynomial that is straight over a whole road of that length.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_mark(paint text, leftwards boolean, rightwards boolean,
    inside_left boolean DEFAULT true) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '<roadMark sOffset="0" type="' || CASE WHEN paint IS NULL THEN 'none' WHEN paint = 'dashed' THEN 'broken'
        WHEN paint = 'solid' THEN 'solid' WHEN leftwards = inside_left THEN 'solid broken' ELSE 'broken solid' END
        || '" color="standard" laneChange="' || CASE WHEN leftwards AND rightwards THEN 'both'
        WHEN leftwards THEN 'increase' WHEN rightwards THEN 'decrease' ELSE 'none' END || '"/>';
COMMENT ON FUNCTION streetgen._opendrive_mark(text, boolean, boolean, boolean) IS
    'The line between two lanes: solid, dashed, mixed (a solid one beside a dashed one) or none (NULL); whether one '
    'may cross it to the left and to the right; inside_left: towards the centre lane is left.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_roads() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
side AS MATERIALIZED (SELECT value IS DISTINCT FROM 'left' AS right_hand FROM %1$I.setting WHERE name = 'driving_side'),
-- Lanes on the right have negative numbers and lead along the road where one drives on the right. A lane that comes
-- between others against this order begins a road of its own.
sided AS (
    SELECT l.*, along_axis = right_hand AS on_right,
        lag(along_axis = right_hand) OVER (PARTITION BY edge_id ORDER BY lane_position) AS was_right
    FROM %1$I.lane l, side WHERE edge_id IN (SELECT edge_id FROM written_edge)
        AND lane_id NOT IN (SELECT lane_id FROM inner_lane)),
road AS (
    SELECT edge_id, run, row_number() OVER (ORDER BY edge_id, run) AS road_id, min(lane_position) - 1 AS before,
        count(*) FILTER (WHERE NOT on_right)::integer AS lefts, array_agg(lane_id ORDER BY lane_position) AS lanes,
        array_agg(streetgen._opendrive_lane_type(kind, both_ways, turn) ORDER BY lane_position) AS types,
        array_agg(geom::bytea ORDER BY lane_position) AS lines,
        array_agg(surface::bytea ORDER BY lane_position) AS surfaces,
        -- A merging lane lies on its ground alone.
        array_agg(CASE WHEN start_abscissa IS NULL AND end_abscissa IS NULL THEN width ELSE 0 END
            ORDER BY lane_position) AS widths
    FROM (SELECT *, count(*) FILTER (WHERE was_right AND NOT on_right)
            OVER (PARTITION BY edge_id ORDER BY lane_position) AS run FROM sided) s
    GROUP BY edge_id, run),
-- Where lanes meet, or go on beside their end, roads are cut back: a way of no length cannot be driven.
met AS MATERIALIZED (
    SELECT l.edge_id, at_end, greatest(0.05, 2 * max(ST_Length(w.geom))) AS cut
    FROM junction_way w, LATERAL (VALUES (lane_in, along_in), (lane_out, NOT along_out)) v(lane_id, at_end)
        JOIN %1$I.lane l USING (lane_id) WHERE ST_Length(w.geom) < 2 GROUP BY l.edge_id, at_end),
stretch AS (
    SELECT e.edge_id, e.geom, least(a, b) AS since, greatest(a, b) AS until, ST_Length(e.geom) AS total,
        coalesce(f.cut, 0) AS cut_start, coalesce(t.cut, 0) AS cut_end
    FROM written_edge e LEFT JOIN met f ON f.edge_id = e.edge_id AND NOT f.at_end
        LEFT JOIN met t ON t.edge_id = e.edge_id AND t.at_end JOIN (
        SELECT edge_id, CASE WHEN start.abscissa < until.abscissa THEN start.abscissa ELSE start.wanted_abscissa END
            AS a, CASE WHEN start.abscissa < until.abscissa THEN until.abscissa ELSE until.wanted_abscissa END AS b
        FROM %1$I.section_limit start JOIN %1$I.section_limit until USING (edge_id)
        WHERE start.which = 'start' AND until.which = 'end') l ON l.edge_id = e.edge_id),
-- The lines between lanes, and who may cross them, seen along the axis.
line_between AS MATERIALIZED (
    SELECT edge_id, lane_position, leftwards, rightwards, CASE WHEN NOT dashed THEN 'solid'
        WHEN leftwards = rightwards THEN 'dashed' ELSE 'mixed' END AS paint
    FROM %1$I.lane_separator WHERE edge_id IN (SELECT edge_id FROM written_edge)),
drawn AS MATERIALIZED (
    SELECT r.road_id, edge_id, r.before, r.lefts, r.lanes, r.types, v.share_from, v.share_to, d.*,
        d.s[cardinality(d.s)] + d.length[cardinality(d.s)] AS total
    FROM origin o, road r JOIN stretch t USING (edge_id) LEFT JOIN course c USING (edge_id),
        -- Crossed limits may lie at one place.
        LATERAL (SELECT greatest(least(since, total - 0.01), 0) AS a,
            least(greatest(until, greatest(least(since, total - 0.01), 0) + 0.01), total) AS b) w,
        LATERAL (SELECT (a + least(cut_start, (b - a) / 4)) / total AS share_from,
            (b - least(cut_end, (b - a) / 4)) / total AS share_to) v,
        LATERAL streetgen._road_lanes(ST_LineSubstring(ST_Force2D(t.geom), share_from, share_to)::bytea,
            coalesce(c.alignment, '{}'), coalesce(c.reach, 0), r.lines, r.surfaces, r.widths, o.tolerance) d),
placed AS MATERIALIZED (
    SELECT lane_id, road_id, edge_id, i::integer AS i, v.at_end,
        CASE WHEN i <= lefts THEN lefts - i + 1 ELSE lefts - i END AS number,
        types[i] AS type, places[4 * i - 3] AS x, places[4 * i - 2] AS y,
        places[4 * i - 1] AS heading, places[4 * i] AS width
    FROM drawn, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i), LATERAL (VALUES (false, starts), (true, ends))
        v(at_end, places)),
way_road AS MATERIALIZED (
    SELECT (SELECT max(road_id) FROM drawn) + row_number() OVER (ORDER BY way_id, a.road_id, ways) AS road_id, ways,
        a.road_id AS road_in, b.road_id AS road_out, a.number AS number_in, b.number AS number_out,
        a.at_end AS in_end, b.at_end AS out_end, a.width AS width_in, b.width AS width_out,
        CASE WHEN k.along_in THEN e.to_node ELSE e.from_node END AS node_id, a.type, k.lane_in, e.speed,
        (CASE WHEN short THEN ST_MakeLine(ST_MakePoint(a.x, a.y), ST_MakePoint(b.x, b.y)) ELSE k.geom END)::bytea
            AS path,
        ARRAY[a.x, a.y, a.heading + CASE WHEN a.at_end THEN 0 ELSE pi() END] AS path_from,
        ARRAY[b.x, b.y, b.heading + CASE WHEN b.at_end THEN pi() ELSE 0 END] AS path_to,
        CASE WHEN short THEN 1 ELSE o.tolerance END AS path_tolerance
    FROM origin o, junction_way k JOIN placed a ON (a.lane_id, a.at_end) = (k.lane_in, k.along_in)
        JOIN placed b ON (b.lane_id, b.at_end) = (k.lane_out, NOT k.along_out)
        JOIN written_edge e ON e.edge_id = a.edge_id,
        LATERAL (SELECT ST_Length(k.geom) < 2 AS short) w),
-- The chain of a road is longer than its path, and is read once: it is not kept.
connecting AS NOT MATERIALIZED (
    SELECT w.*, d.* FROM way_road w, streetgen._path_view(path, path_from, path_to, path_tolerance) d)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_roads() IS
    'Queries of a file of OpenDRIVE over a model: line_between, what parts lanes; drawn, a road '
    'for each edge with what streetgen._road_lanes gives; '
    'placed, its lanes with their numbers and how they begin and end; way_road, a road for each way from lane to lane; '
    'connecting, the same with its chain.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_heights(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
raised AS MATERIALIZED (
    SELECT road_id, array_agg(m ORDER BY m) AS station, array_agg(z ORDER BY m) AS heights
    FROM (SELECT DISTINCT ON (road_id, round(ST_M(p.geom)::numeric, 3)) road_id, ST_M(p.geom) AS m, ST_Z(p.geom) AS z
        FROM drawn JOIN ($part$ || CASE WHEN 'height' = ANY (subjects) THEN 'SELECT edge_id, geom FROM %1$I.profile'
                WHEN dimension = 3 THEN 'SELECT edge_id, geom FROM written_edge'
                ELSE 'SELECT NULL::bigint AS edge_id, NULL::geometry AS geom WHERE false' END || $part$) h
            USING (edge_id), ST_DumpPoints(ST_AddMeasure(ST_LineSubstring(h.geom, share_from, share_to), 0, total)) p
        ORDER BY road_id, round(ST_M(p.geom)::numeric, 3)) p
    GROUP BY road_id HAVING count(*) > 1)$part$
    FROM streetgen._subjects(model) subjects, streetgen.model m WHERE m.name = model $$;
COMMENT ON FUNCTION streetgen._opendrive_heights(name) IS
    'Query raised of a file of OpenDRIVE, after streetgen._opendrive_roads(): the heights of roads, metres, at '
    'stations along them: of profiles where the model computes them, else of axes that have any.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_lines() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
lane_text AS (
    SELECT road_id, lefts, i, '<lane id="' || CASE WHEN i <= lefts THEN lefts - i + 1 ELSE lefts - i END
        || '" type="' || types[i] || '" level="false">'
        || CASE WHEN stations = 2 THEN streetgen._opendrive_step('width', 'sOffset', total,
                border[2 * i - 1] - border[2 * i + 1], border[2 * i] - border[2 * i + 2])
            ELSE streetgen._opendrive_change('width', 'sOffset', station, ARRAY(
                SELECT border[(i - 1) * stations + k] - border[i * stations + k]
                FROM generate_series(1, stations) k)) END
        || streetgen._opendrive_mark(m.paint, m.leftwards, m.rightwards, i > lefts) || '</lane>' AS text
    FROM (SELECT d.*, cardinality(station) AS stations FROM drawn d) d
        CROSS JOIN streetgen._few(lanes) WITH ORDINALITY u(lane_id, i)
        LEFT JOIN line_between m ON (m.edge_id, m.lane_position)
            = (d.edge_id, before + CASE WHEN i <= lefts THEN i - 1 ELSE i END)),
lanes_text AS (
    SELECT road_id, string_agg(text, '' ORDER BY i) FILTER (WHERE i <= lefts) AS on_left,
        string_agg(text, '' ORDER BY i) FILTER (WHERE i > lefts) AS on_right
    FROM lane_text GROUP BY road_id),
-- The lane farthest to the left comes first.
across AS MATERIALIZED (
    SELECT l.road_id, '<left>' || nullif(concat(a.text, l.on_left), '') || '</left>' AS on_left,
        '<right>' || nullif(concat(l.on_right, b.text), '') || '</right>' AS on_right
    FROM lanes_text l LEFT JOIN sidewalk_lane a ON (a.road_id, a.side) = (l.road_id, 'left')
        LEFT JOIN sidewalk_lane b ON (b.road_id, b.side) = (l.road_id, 'right')),
line AS (
    SELECT 1 AS turn, 0::bigint AS id, streetgen._opendrive_open(xmlelement(name header, xmlattributes(
            1 AS "revMajor", right($1 ->> 'version', 1) AS "revMinor", %1$L AS name, 'StreetGen' AS vendor)))
        || '<geoReference><![CDATA['
        || trim(proj4text) || ']]></geoReference><offset x="' || x || '" y="' || y || '" z="0" hdg="0"/></header>'
        AS element
    FROM origin LEFT JOIN spatial_ref_sys ON srid = %2$s
    UNION ALL
    -- Not by ||, which copies what is there with each word.
    SELECT 2, d.road_id, concat(streetgen._opendrive_open(xmlelement(name road, xmlattributes(
            streetgen._xml_text(a.name) AS name, streetgen._decimal(d.total, 7) AS length,
            d.road_id AS id, -1 AS junction, CASE WHEN right_hand THEN 'RHT' ELSE 'LHT' END AS rule))),
        '<link>' || nullif(concat('<predecessor elementType="junction" elementId="' || f.place_id || '"/>',
            '<successor elementType="junction" elementId="' || t.place_id || '"/>'), '') || '</link>',
        '<type s="0" type="unknown"><speed max="', streetgen._decimal(e.speed, 1), '" unit="km/h"/></type>',
        streetgen._opendrive_plan(d.s, d.x, d.y, heading, length, curvature, curvature_end, o.x, o.y, digits),
        '<elevationProfile>' || streetgen._opendrive_change('elevation', 's', h.station, h.heights)
            || '</elevationProfile>',
        '<lanes>', streetgen._opendrive_change('laneOffset', 's', d.station,
            border[lefts * cardinality(d.station) + 1:(lefts + 1) * cardinality(d.station)]),
        '<laneSection s="0">', on_left, '<center><lane id="0" type="none" level="false">',
        streetgen._opendrive_mark(m.paint, m.leftwards, m.rightwards), '</lane></center>', on_right,
        '</laneSection></lanes>', j.text, g.text, '<userData code="edge" value="', d.edge_id, '"/></road>')
    FROM origin o, side, drawn d JOIN across USING (road_id) JOIN written_edge e USING (edge_id)
        LEFT JOIN crossroads f ON f.node_id = e.from_node LEFT JOIN crossroads t ON t.node_id = e.to_node
        LEFT JOIN (SELECT axis_id, name FROM %1$I.axis) a USING (axis_id)
        LEFT JOIN line_between m ON (m.edge_id, m.lane_position) = (d.edge_id, before + lefts)
        LEFT JOIN raised h ON h.road_id = d.road_id LEFT JOIN object_text j ON j.road_id = d.road_id
        LEFT JOIN signal_text g ON g.road_id = d.road_id
    UNION ALL
    SELECT 3, c.road_id, concat('<road length="', streetgen._decimal(total, 7), '" id="', c.road_id, '" junction="',
        place_id, '" rule="', rule, '"><link><predecessor elementType="road" elementId="', road_in, '" contactPoint="',
        CASE WHEN in_end THEN 'end' ELSE 'start' END, '"/><successor elementType="road" elementId="', road_out,
        '" contactPoint="', CASE WHEN out_end THEN 'end' ELSE 'start' END, '"/></link>',
        streetgen._opendrive_plan(s, c.x, c.y, heading, length, curvature, curvature_end, o.x, o.y, digits),
        '<elevationProfile>' || streetgen._opendrive_step('elevation', 's', total,
            a.heights[CASE WHEN in_end THEN cardinality(a.heights) ELSE 1 END],
            b.heights[CASE WHEN out_end THEN cardinality(b.heights) ELSE 1 END]) || '</elevationProfile>',
        '<lanes>', streetgen._opendrive_step('laneOffset', 's', total, half * width_in, half * width_out),
        '<laneSection s="0">', CASE WHEN NOT right_hand THEN '<left>' || lane || '</left>' END,
        '<center><lane id="0" type="none" level="false"/></center>',
        CASE WHEN right_hand THEN '<right>' || lane || '</right>' END, '</laneSection></lanes>', j.text,
        '<userData code="interconnection" value="', ways, '"/></road>')
    FROM origin o, side, connecting c JOIN joined_node USING (node_id) LEFT JOIN object_text j USING (road_id)
        LEFT JOIN raised a ON a.road_id = road_in LEFT JOIN raised b ON b.road_id = road_out,
        LATERAL (SELECT s[cardinality(s)] + length[cardinality(s)] AS total,
            CASE WHEN right_hand THEN 'RHT' ELSE 'LHT' END AS rule,
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
    FROM side, way_road JOIN joined_node USING (node_id) LEFT JOIN junction_controller c USING (place_id)
    GROUP BY place_id
    UNION ALL SELECT * FROM ring_line)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_lines() IS
    'Queries of a file of OpenDRIVE as streetgen._export_lines takes them, after streetgen._opendrive_beside().';

CREATE OR REPLACE FUNCTION streetgen._opendrive_rings(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN computed THEN $part$,
ring_line AS (
    SELECT 6 AS turn, roundabout_id AS id, '<junctionGroup id="' || roundabout_id || '" type="roundabout">'
        || string_agg(DISTINCT '<junctionReference junction="' || place_id || '"/>', '') || '</junctionGroup>'
        AS element
    FROM %1$I.roundabout JOIN %1$I.roundabout_edge r USING (roundabout_id) JOIN %1$I.edge e ON e.edge_id = r.edge_id
        JOIN crossroads ON node_id IN (from_node, to_node)
    WHERE accepted GROUP BY roundabout_id)$part$
    ELSE $part$, ring_line AS (SELECT 6 AS turn, 0::bigint AS id, NULL::text AS element WHERE false)$part$ END $$;
COMMENT ON FUNCTION streetgen._opendrive_rings(boolean) IS
    'Query ring_line of a file of OpenDRIVE, after crossroads: the junctions of accepted roundabouts; nothing of a '
    'model that computes none.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_beside(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._opendrive_heights(model) || streetgen._opendrive_sidewalks('sidewalk' = ANY (subjects))
        || streetgen._opendrive_objects('object' = ANY (subjects))
        || streetgen._opendrive_signals('signal' = ANY (subjects)) || $part$,
crossroads AS MATERIALIZED (
    SELECT node_id, place_id FROM joined_node
    WHERE place_id IN (SELECT place_id FROM way_road JOIN joined_node n USING (node_id)))$part$
        || streetgen._opendrive_rings('roundabout' = ANY (subjects))
    FROM streetgen._subjects(model) subjects $$;
COMMENT ON FUNCTION streetgen._opendrive_beside(name) IS
    'Queries of a file of OpenDRIVE, after streetgen._opendrive_roads(): what the roads of a model have beside lanes.';

CREATE OR REPLACE FUNCTION streetgen.export_opendrive(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'opendrive', 'interconnection', options);
BEGIN
    RETURN QUERY EXECUTE streetgen._export_lines(model, known,
        streetgen._opendrive_junctions() || streetgen._opendrive_courses(model) || streetgen._opendrive_roads()
            || streetgen._opendrive_beside(model) || streetgen._opendrive_lines(),
        '<OpenDRIVE>', '</OpenDRIVE>') USING known;
END $$;
COMMENT ON FUNCTION streetgen.export_opendrive(name, jsonb) IS
    'A file of ASAM OpenDRIVE 1.7 (or 1.6), line by line. An edge is a road, its reference line a chain of lines and '
    'arcs (streetgen.plan_view) along the axis between its section limits. That of a designed road has the elements '
    'of its alignment, clothoids as spirals, and that of a smoothed edge the arcs of the edge. Its lanes have the '
    'borders of the model as polynomials, parking lanes too; those against the axis lie left of the centre lane '
    'where one drives on the right. A lane that lies among those of the other direction is a road of its own. An '
    'interconnection that connects is a connecting road with one lane, which begins and ends where the lanes do, in '
    'their direction. A node with such is a junction, and nodes whose limits cross are one, without the edges '
    'between them. Sidewalks are the outermost lanes, 0.15 m above the others. A signal stands at the end of each '
    'lane that has one, lanes with the same green have one controller, and the program of the model is userData of '
    'the junction. Stop and yield lines without signals have signs (206 and 205 of country DE). Objects have their '
    'type, place and direction, crossings, bays and lines their outline. The junctions of an accepted roundabout are '
    'a junctionGroup. All ids are integers, and userData names the edge and the interconnection. Lines between lanes '
    'are road marks, laneChange as view lane_adjacency says. Heights are those of profiles where the model computes '
    'them, else of axes that have any. '
    'Coordinates are counted from the whole metres of offset, and geoReference is the text of PROJ. Lanes that meet '
    'at one place are cut back by 0.05 m for the road that connects them. options as streetgen.export_option() lists '
    'them: an unknown one, or no edge that they take: 22023. A caller who may not read the model: 42501; a model '
    'without interconnections, or junctions that are asked for: 55000. What is stale is written as it was, with a '
    'warning.';
