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
        (6, 'paint', 'paint', 'paint'), (7, 'axis', 'line', 'axis'), (8, 'limit', 'line', 'limit of a section'),
            (9, 'arc', 'line', 'corner of the wanted radius'),
        (10, 'arc fallback', 'line', 'corner of another radius'), (11, 'path', 'line', 'path from lane to lane'),
            (12, 'path implausible', 'line', 'path that is not plausible'),
            (13, 'report', 'ground', 'report')) l(place, style, form, said)
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
    (10, 'network', $part$
    SELECT 903, 'report', false, ST_Buffer(geom, 2), axis_a FROM %1$I.report$part$) $$;
COMMENT ON FUNCTION streetgen._drawn_part() IS
    'What streetgen.svg draws, query by query, over a model %1$I and the query size of the drawing: layer (drawn in '
    'ascending order), style, is it a line, geometry and key. subject: the query stands only in models that compute '
    'it.';

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
    $sql$ || (SELECT string_agg(query, ' UNION ALL ' ORDER BY place) FROM streetgen._drawn_part()
        WHERE subject = ANY (streetgen._subjects(model))) || $sql$),
drawn AS (
    SELECT layer, id, style, format('<path class="%%s" d="%%s"/>', style || CASE WHEN line THEN ' line' ELSE '' END,
        ST_AsSVG(ST_Translate(geom, -x, -y), 0, 2)) AS path
    FROM shape, size WHERE geom && box AND NOT ST_IsEmpty(geom))
SELECT pixel, round(w::numeric, 3) AS w, round(h::numeric, 3) AS h,
    greatest(1, round(($2 * h / w)::numeric)) AS height, ARRAY(SELECT DISTINCT style FROM drawn) AS styles,
    '<style>.section{fill:#c9ccd1}.intersection{fill:#b3b8c0}.transition{fill:#c3b8d6}.contested{fill:#d9c7a7}'
    'path{fill-rule:evenodd}.line{fill:none;stroke-width:' || round((pixel * 1)::numeric, 4)
    || '}.paint{fill:#fff}.axis{stroke:#8fa3b8}.limit{stroke:#6b7280}.arc{stroke:#1d4ed8;stroke-width:' ||
        round((pixel * 1.5)::numeric, 4) || '}.fallback{stroke:#c2410c}.path{stroke:#15803d;stroke-width:' ||
        round((pixel * 0.7)::numeric, 4) || '}.implausible{stroke:#6b7280;stroke-opacity:.5;stroke-width:' ||
        round((pixel * 0.4)::numeric, 4) || '}.report{fill:#dc2626;fill-opacity:.4}'
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
    'the network reports (red). Where a pixel is 3 m and more, a map: the roadway alone, dark, and reports. width in '
    'pixels. legend: on white beside the map, in addition to its width, with what is drawn and a scale.';
