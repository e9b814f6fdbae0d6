-- Pictures of a model.

CREATE OR REPLACE FUNCTION streetgen._svg_legend(styles text[], pixel float8)
    RETURNS TABLE(turn bigint, swatch text, words text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$
    SELECT row_number() OVER (ORDER BY place), format(CASE form
            WHEN 'line' THEN '<path class="%s line" style="stroke-width:2.5" d="M0 8h32"/>'
            WHEN 'paint' THEN '<rect class="section" width="32" height="16"/><rect class="%s" y="6.5" width="32" '
                'height="3"/>'
            ELSE '<rect class="%s" style="stroke:none" width="32" height="16"/>' END, style), said
    FROM (VALUES
        (1, 'section', 'ground', CASE WHEN pixel < 3 THEN 'section of a street' ELSE 'roadway' END),
            (2, 'intersection', 'ground', CASE WHEN pixel < 3 THEN 'intersection' END),
        (3, 'intersection transition', 'ground', CASE WHEN pixel < 3 THEN 'change of width' END),
        (4, 'section contested', 'ground', CASE WHEN pixel < 3 THEN 'contested section' END),
            (5, 'intersection contested', 'ground', CASE WHEN pixel < 3 THEN 'contested intersection' END),
        (35, 'sidewalk', 'ground', CASE WHEN pixel < 3 THEN 'sidewalk' END), (6, 'paint', 'paint', 'paint'),
        (7, 'axis', 'line', 'axis'), (8, 'limit', 'line', 'limit of a section'),
            (9, 'arc', 'line', 'corner of the wanted radius'),
        (10, 'arc fallback', 'line', 'corner of another radius'), (11, 'path', 'line', 'path from lane to lane'),
            (14, 'junction', 'ground', 'junction of several nodes'), (36, 'signal head', 'ground', 'signal'),
            (12, 'path implausible', 'line', 'path that is not plausible'),
            (13, 'report', 'ground', 'report'), (15, 'road', 'line', 'road'),
            (16, 'road radius', 'line', 'radius of a bend'),
            (17, 'block', 'ground', 'city block'), (18, 'block island', 'ground', 'island'),
            (19, 'block strip', 'ground', 'strip between carriageways'), (20, 'kerb', 'ground', 'kerb stones'),
            (40, 'object', 'ground', 'object'), (41, 'object green', 'ground', 'tree or hedge'),
            (42, 'bay', 'ground', 'parking bay'),
            (23, 'bridge', 'ground', 'bridge'), (24, 'tunnel', 'line', 'tunnel'),
            (21, 'ring', 'line', 'roundabout, bar: its score'), (22, 'ring refused', 'line', 'ring that is none'))
        l(place, style, form, said)
    WHERE style = ANY (styles) AND said IS NOT NULL
    $$;
COMMENT ON FUNCTION streetgen._svg_legend(text[], float8) IS
    'What the styles of a drawing mean, in the order of a legend, each with a swatch (SVG) of 32 by 16; a map whose '
    'pixel is 3 m and more has the roadway alone.';

CREATE OR REPLACE FUNCTION streetgen._svg_beside_legend(map text, width integer, height numeric, pixel float8,
    styles text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- The legend is drawn in units of a 1200th of the width, the scale bar up to 180 of them.
    SELECT format('<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s">', width + ceil(300 * unit),
        greatest(height, ceil(tall * unit))) || E'\n<rect width="100%" height="100%" fill="#fff"/>\n' || map
        || format('<svg x="%s" width="%s" height="%s" viewBox="0 0 300 %s" font-family="sans-serif" font-size="14" '
            'fill="#1f2937">', width, ceil(300 * unit), ceil(tall * unit), tall) || E'\n'
        || coalesce((SELECT string_agg(format('<g transform="translate(16 %s)">%s<text x="44" y="13">%s</text></g>',
            26 * l.turn - 10, l.swatch, l.words), E'\n' ORDER BY l.turn) FROM streetgen._svg_legend(styles, pixel) l),
            '') || E'\n'
        || format('<path transform="translate(16 %s)" d="M0 0v8h%sv-8" fill="none" stroke="#1f2937" '
            'stroke-width="1.5"/><text x="16" y="%s">%s m</text>', tall - 44, round((metres / (pixel * unit))::numeric,
            2), tall - 18, metres::numeric) || E'\n</svg>\n</svg>\n'
    FROM (SELECT width / 1200.0 AS unit, 26 * (SELECT count(*) FROM streetgen._svg_legend(styles, pixel)) + 72 AS tall,
        180 * pixel * width / 1200.0 AS longest) size,
        LATERAL (SELECT 10 ^ floor(log(longest)) AS power) p, LATERAL (SELECT power * CASE WHEN longest >= 5 * power
            THEN 5 WHEN longest >= 2 * power THEN 2 ELSE 1 END AS metres) s
    $$;
COMMENT ON FUNCTION streetgen._svg_beside_legend(text, integer, numeric, float8, text[]) IS
    'A map (SVG of width by height, in pixels of so many metres) with the legend of its styles and a scale on white '
    'beside it.';

CREATE OR REPLACE FUNCTION streetgen._drawn_part() RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 10 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'surface', $part$
    SELECT 1 + level * 10, CASE WHEN method IN ('contested', 'crowded') THEN 'section contested' ELSE 'section' END,
        false, surface, edge_id FROM %1$I.section$part$),
    (2, 'surface', $part$
    SELECT 2 + level * 10, CASE WHEN method IN ('contested', 'crowded') THEN 'intersection contested'
        WHEN method = 'transition' THEN 'intersection transition' ELSE 'intersection' END, false, surface, node_id
        FROM %1$I.intersection$part$),
    -- Paint and paths only where a pixel can show them; the roadway alone where it is wider than a lane.
    (3, 'lane', $part$
    SELECT 4 + e.level * 10, 'paint', false, p.surface, p.lane_separator_id FROM %1$I.lane_separator p
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    (4, 'lane', $part$
    SELECT 4 + e.level * 10, 'paint', false, m.surface, m.marking_id FROM %1$I.marking m
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    -- Below the line in the middle of the street, which runs along it.
    (5, 'network', $part$
    SELECT 3 + level * 10, 'axis', true, geom, edge_id FROM %1$I.edge, size WHERE pixel < 3$part$),
    (6, 'surface', $part$
    SELECT 901, 'limit', true, border_line, section_limit_id FROM %1$I.section_limit, size
        WHERE method = 'hypothesis' AND pixel < 3$part$),
    (7, 'surface', $part$
    SELECT 902, CASE method WHEN 'hypothesis' THEN 'arc' ELSE 'arc fallback' END, true, ST_CurveToLine(arc, 16),
        corner_id FROM %1$I.corner, size WHERE arc IS NOT NULL AND pixel < 3$part$),
    (8, 'interconnection', $part$
    SELECT CASE WHEN plausible THEN 895 ELSE 894 END, CASE WHEN plausible THEN 'path'
        ELSE 'path implausible' END, true, geom, interconnection_id FROM %1$I.interconnection, size
        WHERE pixel < 0.5$part$),
    -- Lanes between crossed limits join paths.
    (9, 'lane', $part$
    SELECT 895, 'path', true, geom, lane_id FROM %1$I.lane, size WHERE method = 'crossed_limits'
        AND pixel < 0.5$part$),
    -- Below the roadway of the ground.
    (11, 'block', $part$
    SELECT -1 + g.level * 10, CASE kind WHEN 'block' THEN 'block' ELSE 'block ' || kind END, false, surface, block_id
        FROM %1$I.block, (SELECT value::integer AS level FROM %1$I.setting WHERE name = 'ground_level') g$part$),
    (12, 'kerb', $part$
    SELECT 0.5 + level * 10, 'kerb', false, surface, kerb_id FROM %1$I.kerb, size WHERE pixel < 0.5$part$),
    (45, 'roundabout', $part$
    SELECT 904, CASE WHEN accepted THEN 'ring' ELSE 'ring refused' END, true, ST_Collect(geom, ST_SetSRID(ST_MakeLine(
        ST_MakePoint(ST_X(centre) - radius * score / 2, ST_Y(centre)),
        ST_MakePoint(ST_X(centre) + radius * score / 2, ST_Y(centre))), ST_SRID(geom))), roundabout_id
        FROM %1$I.roundabout, size WHERE pixel < 3$part$),
    (35, 'sidewalk', $part$
    SELECT k.level * 10, 'sidewalk', false, w.surface, w.sidewalk_id FROM %1$I.sidewalk w
        JOIN %1$I.kerb k USING (edge_id, side, part), size WHERE pixel < 3$part$),
    (40, 'junction', $part$
    SELECT 3 + i.level * 10, 'junction', false, j.surface, j.junction_id FROM %1$I.junction j
        JOIN %1$I.intersection i ON i.node_id = j.junction_id, size WHERE j.method <> 'hypothesis' AND pixel < 3$part$),
    (41, 'junction', $part$
    SELECT 4 + e.level * 10, 'paint', false, m.surface, m.marking_id FROM %1$I.rim_marking m
        JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 0.5$part$),
    (42, 'junction', $part$
    SELECT CASE WHEN plausible THEN 895 ELSE 894 END, CASE WHEN plausible THEN 'path' ELSE 'path implausible' END,
        true, geom, interconnections[1] FROM %1$I.movement, size WHERE pixel < 0.5$part$),
    (60, 'signal', $part$
    SELECT 905, 'signal head', false, ST_Buffer(geom, 0.6, 4), lane_id FROM %1$I.signal_head, size
        WHERE pixel < 0.5$part$),
    (44, 'junction', $part$
    SELECT 901, 'limit', true, l.border_line, l.section_limit_id FROM %1$I.section_limit l, size
        WHERE l.method = 'hypothesis' AND pixel < 3 AND NOT EXISTS (SELECT FROM %1$I.junction_edge j
            WHERE j.edge_id = l.edge_id)$part$),
    -- Arcs inside a junction are no kerb.
    (43, 'junction', $part$
    SELECT 902, CASE c.method WHEN 'hypothesis' THEN 'arc' ELSE 'arc fallback' END, true, d.geom, c.corner_id
        FROM size, %1$I.corner c LEFT JOIN %1$I.junction_node n USING (node_id)
            LEFT JOIN %1$I.junction j ON j.junction_id = n.junction_id AND j.method <> 'hypothesis'
            CROSS JOIN LATERAL ST_CurveToLine(c.arc, 16) whole CROSS JOIN LATERAL ST_Dump(CASE WHEN j.surface IS NULL
                THEN whole ELSE ST_Intersection(whole, ST_Buffer(ST_Boundary(j.surface), 0.05)) END) d
        WHERE c.arc IS NOT NULL AND pixel < 3 AND (j.surface IS NULL OR ST_Length(d.geom) > 0.5)$part$),
    -- A deck lies over what is painted on its level, and has its own paint.
    (50, 'bridge', $part$
    SELECT CASE method WHEN 'overpass' THEN 5.5 ELSE 0.5 END + e.level * 10, 'bridge', false, b.surface, b.bridge_id
        FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 3$part$),
    (51, 'bridge,lane', $part$
    SELECT 6.5 + e.level * 10, 'paint', false, ST_CollectionExtract(ST_Intersection(p.surface, b.surface), 3),
        b.bridge_id FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), LATERAL (
            SELECT surface FROM %1$I.lane_separator l WHERE l.edge_id = b.edge_id
            UNION ALL SELECT surface FROM %1$I.marking m WHERE m.edge_id = b.edge_id) p, size
        WHERE b.method = 'overpass' AND pixel < 0.5 AND b.surface && size.box$part$),
    -- The sun stands in the north-west.
    (52, 'bridge', $part$
    SELECT CASE method WHEN 'overpass' THEN 4.5 ELSE -0.5 END + e.level * 10, 'shadow', false,
        ST_Translate(b.surface, 2, -2), b.bridge_id
        FROM %1$I.bridge b JOIN %1$I.edge e USING (edge_id), size WHERE pixel < 3$part$),
    (53, 'bridge', $part$
    SELECT 8.5, 'tunnel', true, ST_Boundary(surface), tunnel_id FROM %1$I.tunnel, size WHERE pixel < 3$part$),
    (54, 'object', $part$
    SELECT 950, CASE t.category WHEN 'green' THEN 'object green' ELSE 'object' END, false,
        streetgen._object_symbol(o.geom, o.angle, t.symbol, greatest(t.size, 4 * pixel)), o.street_object_id
        FROM %1$I.street_object o JOIN %1$I.object_type t USING (type), size
        WHERE pixel < 0.5 AND t.symbol NOT IN ('crossing', 'bay')$part$),
    (55, 'object', $part$
    SELECT 7, 'paint', false, stripes, street_object_id FROM %1$I.pedestrian_crossing, size WHERE pixel < 0.5
    UNION ALL SELECT 7, 'bay', false, surface, street_object_id FROM %1$I.parking_bay, size
        WHERE pixel < 0.5$part$),
    (10, 'network', $part$
    SELECT 903, 'report', false, ST_Buffer(geom, 2), axis_a FROM %1$I.report$part$),
    (11, 'alignment', $part$
    SELECT 904, 'road', true, geom, road_id FROM %1$I.road, size WHERE pixel < 3$part$),
    -- As figure 6b of Wilkie, Sewall and Lin: from the ends of an arc to its centre.
    (12, 'alignment', $part$
    SELECT 905, 'road radius', true, ST_MakeLine(ARRAY[ST_StartPoint(arc), centre, ST_EndPoint(arc)]), road_arc_id
        FROM %1$I.road_arc, size WHERE pixel < 0.5 AND radius < 100$part$) $$;
CREATE OR REPLACE FUNCTION streetgen._drawn_instead() RETURNS TABLE(place integer, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES (4, 'junction'), (6, 'junction'), (7, 'junction'), (8, 'junction'), (9, 'junction') $$;
COMMENT ON FUNCTION streetgen._drawn_instead() IS
    'The queries of streetgen._drawn_part that do not stand in models which compute a subject: its own show more.';

COMMENT ON FUNCTION streetgen._drawn_part() IS
    'What streetgen.svg draws, query by query, over a model %1$I and the query size of the drawing: layer (drawn in '
    'ascending order), style, is it a line, geometry and key. subject: the query stands only in models that compute '
    'it, or all of several.';

CREATE OR REPLACE FUNCTION streetgen._curve_as_svg(curve geometry, x float8, y float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH part AS (SELECT path[1] AS n, geom, GeometryType(geom) = 'CIRCULARSTRING' AS curved FROM ST_Dump(curve)),
    placed AS (
        SELECT n, k, curved, ST_X(p) - x AS px, y - ST_Y(p) AS py FROM part,
            generate_series(1, ST_NPoints(geom)) k, ST_PointN(geom, k) p),
    arc AS (
        SELECT n, max(px) FILTER (WHERE k = 3) AS px, max(py) FILTER (WHERE k = 3) AS py,
            max(px) FILTER (WHERE k = 2) - max(px) FILTER (WHERE k = 1) AS ax,
            max(py) FILTER (WHERE k = 2) - max(py) FILTER (WHERE k = 1) AS ay,
            max(px) FILTER (WHERE k = 3) - max(px) FILTER (WHERE k = 1) AS bx,
            max(py) FILTER (WHERE k = 3) - max(py) FILTER (WHERE k = 1) AS by
        FROM placed WHERE curved GROUP BY n)
    SELECT string_agg(said, ' ' ORDER BY n, k) FROM (
        SELECT n, k, CASE WHEN n = 1 AND k = 1 THEN 'M ' ELSE 'L ' END || round(px::numeric, 2) || ' '
            || round(py::numeric, 2) AS said
        FROM placed WHERE NOT curved AND (k > 1 OR n = 1) OR curved AND n = 1 AND k = 1
        UNION ALL SELECT n, 2, CASE WHEN turn = 0 THEN format('L %s %s', round(px::numeric, 2), round(py::numeric, 2))
            ELSE format('A %1$s %1$s 0 0 %2$s %3$s %4$s', round((radius)::numeric, 3),
                CASE WHEN turn > 0 THEN 1 ELSE 0 END, round(px::numeric, 2), round(py::numeric, 2)) END
        FROM arc, LATERAL (SELECT ax * by - ay * bx AS turn) t, LATERAL (SELECT sqrt((ax ^ 2 + ay ^ 2)
            * (bx ^ 2 + by ^ 2) * ((bx - ax) ^ 2 + (by - ay) ^ 2)) / nullif(2 * abs(turn), 0) AS radius) r) s $$;
COMMENT ON FUNCTION streetgen._curve_as_svg(geometry, float8, float8) IS
    'A COMPOUNDCURVE as a path of SVG, with true arcs, none of more than half a circle; x and y are those of the '
    'upper left corner of the picture.';

CREATE OR REPLACE FUNCTION streetgen.svg(model name, extent geometry DEFAULT NULL, width integer DEFAULT 1200,
    legend boolean DEFAULT false) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    picture record;
    frame text;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('legend', legend::text),
        streetgen._check_extent(model, extent);
    IF width IS NULL OR width NOT BETWEEN 16 AND 20000 THEN
        RAISE EXCEPTION 'the width is %, expected 16 to 20000 pixels', coalesce(width::text, 'NULL')
            USING ERRCODE = '22023', HINT = 'The default is 1200.';
    END IF;
    EXECUTE format($sql$
WITH frame AS (
    SELECT CASE WHEN $1 IS NULL THEN (SELECT ST_Expand(ST_Extent(geom)::box2d, 10)::geometry FROM %1$I.axis)
        ELSE ST_Envelope($1) END AS box),
size AS (SELECT ST_XMin(box) AS x, ST_YMax(box) AS y, greatest(ST_XMax(box) - ST_XMin(box), 1) AS w,
    greatest(ST_YMax(box) - ST_YMin(box), 1) AS h,
                greatest(ST_XMax(box) - ST_XMin(box), 1) / $2 AS pixel, ST_SetSRID(box, %2$s) AS box FROM frame),
shape(layer, style, line, geom, id) AS (
    $sql$ || (SELECT string_agg(query, ' UNION ALL ' ORDER BY place) FROM streetgen._drawn_part() p
        WHERE string_to_array(subject, ',') <@ streetgen._subjects(model)
            AND NOT EXISTS (SELECT FROM streetgen._drawn_instead() i WHERE i.place = p.place
                AND i.subject = ANY (streetgen._subjects(model)))) || $sql$),
drawn AS (
    SELECT layer, id, style, format('<path class="%%s" d="%%s"/>', style || CASE WHEN line THEN ' line' ELSE '' END,
        CASE GeometryType(geom) WHEN 'COMPOUNDCURVE' THEN streetgen._curve_as_svg(geom, x, y)
            ELSE ST_AsSVG(ST_Translate(geom, -x, -y), 0, 2) END) AS path
    FROM shape, size WHERE geom && box AND NOT ST_IsEmpty(geom))
SELECT pixel, round(w::numeric, 3) AS w, round(h::numeric, 3) AS h,
    greatest(1, round(($2 * h / w)::numeric)) AS height, ARRAY(SELECT DISTINCT style FROM drawn) AS styles,
    '<style>.section{fill:#c9ccd1}.intersection{fill:#b3b8c0}.transition{fill:#c3b8d6}.contested{fill:#d9c7a7}'
    '.sidewalk{fill:#e7d9bd;stroke:#c9b791;stroke-width:' || round((pixel * 0.4)::numeric, 4)
    || '}path{fill-rule:evenodd}.line{fill:none;stroke-width:' || round((pixel * 1)::numeric, 4)
    || '}.paint{fill:#fff}.axis{stroke:#8fa3b8}.limit{stroke:#6b7280}.arc{stroke:#1d4ed8;stroke-width:' ||
        round((pixel * 1.5)::numeric, 4) || '}.fallback{stroke:#c2410c}.path{stroke:#15803d;stroke-width:' ||
        round((pixel * 0.7)::numeric, 4)
    || '}.junction{fill:#9fb0c3}.implausible{stroke:#6b7280;stroke-opacity:.5;stroke-width:' ||
        round((pixel * 0.4)::numeric, 4) || '}.report{fill:#dc2626;fill-opacity:.4}.road{stroke:#a21caf;stroke-width:'
    || round((pixel * 1.2)::numeric, 4) || '}.radius{stroke-width:' || round((pixel * 0.4)::numeric, 4) || '}'
    || '.signal.head{fill:#c92a2a}.block{fill:#dfe6d3}.island{fill:#bcd3a5}.strip{fill:#cfdcb4}.kerb{fill:#8b8f96}'
    || '.object{fill:#7c3aed;stroke:#4c1d95;stroke-width:' || round((pixel * 0.8)::numeric, 4)
    || '}.object.green{fill:#4d7c0f;fill-opacity:0.6;stroke:#3f6212}.bay{fill:#c9ccd1;stroke:#fff;stroke-width:'
    || round((pixel * 1.2)::numeric, 4) || '}'
    || '.bridge{fill:#c9ccd1;stroke:#374151;stroke-width:' || round((pixel * 1.2)::numeric, 4)
    || '}.shadow{fill:#111827;fill-opacity:.3}.tunnel{stroke:#374151;stroke-dasharray:'
    || round((pixel * 5)::numeric, 4) || ';stroke-width:' || round((pixel * 1)::numeric, 4) || '}'
    || '.ring{stroke:#7c3aed;stroke-width:' || round((pixel * 2)::numeric, 4)
    || '}.refused{stroke:#6b7280;stroke-width:' || round((pixel * 1)::numeric, 4) || '}'
    || CASE WHEN pixel < 3 THEN ''
        ELSE '.section,.intersection{fill:#4b5563;stroke:#4b5563;stroke-width:' || round((pixel * 0.6)::numeric,
        4) || '}' END || '</style>' || E'\n'
    || '<rect width="100%%" height="100%%" fill="#f3f1ea"/>' || E'\n' || coalesce((SELECT string_agg(path, E'\n'
        ORDER BY layer, id) FROM drawn), '') || E'\n' AS drawing FROM size
$sql$, model, (SELECT srid FROM streetgen.model m WHERE m.name = model)) INTO picture USING extent, width;
    frame := format('width="%s" height="%s" viewBox="0 0 %s %s"', width, picture.height, picture.w, picture.h);
    IF NOT legend THEN
        RETURN format(E'<svg xmlns="http://www.w3.org/2000/svg" %s>\n%s</svg>\n', frame, picture.drawing);
    END IF;
    RETURN streetgen._svg_beside_legend(format(E'<svg %s>\n%s</svg>\n', frame, picture.drawing), width, picture.height,
        picture.pixel, picture.styles);
END $$;
COMMENT ON FUNCTION streetgen.svg(name, geometry, integer, boolean) IS
    'One styled SVG of a model, or of an extent of it (geometry in the model''s SRID): surfaces by level, what is '
    'painted on them and paths between lanes (green, grey where not plausible; both where a pixel is under half a '
    'metre), axes, limits, arcs (blue; orange where the wanted radius did not hold), contested ground (ochre), what '
    'the network reports (red), rings (violet; grey where they are no roundabouts) with a bar at the centre as wide '
    'as the score says, the radius for 1; bridges over what they cross, with a shadow, and tunnels dashed. Where '
    'a pixel is 3 m and more, a map: the roadway alone, dark, and reports. '
    'width in pixels. legend: on white beside the map, in addition to its width, with what is drawn and a scale.';
