-- Pictures of a model.

CREATE OR REPLACE FUNCTION streetgen._legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('legend');
END $$;
COMMENT ON FUNCTION streetgen._legend() IS
    'The styles of drawings, from functions _ROOM_legend: place in a legend, form of the swatch (ground, line or '
    'paint), and what the style means near, and far, where a pixel is 3 m and more; NULL: it is not seen.';

CREATE OR REPLACE FUNCTION streetgen._svg_legend(styles text[], pixel float8)
    RETURNS TABLE(turn bigint, swatch text, words text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$
    SELECT row_number() OVER (ORDER BY place), format(CASE form
            WHEN 'line' THEN '<path class="%s line" style="stroke-width:2.5" d="M0 8h32"/>'
            WHEN 'paint' THEN '<rect class="section" width="32" height="16"/><rect class="%s" y="6.5" width="32" '
                'height="3"/>'
            ELSE '<rect class="%s" style="stroke:none" width="32" height="16"/>' END, style), said
    FROM streetgen._legend() l, LATERAL (SELECT CASE WHEN pixel < 3 THEN near ELSE far END AS said) s
    WHERE style = ANY (styles) AND said IS NOT NULL
    $$;
COMMENT ON FUNCTION streetgen._svg_legend(text[], float8) IS
    'What the styles of a drawing mean, in the order of a legend, each with a swatch (SVG) of 32 by 16; pixel: its '
    'size, metres.';

CREATE OR REPLACE FUNCTION streetgen._svg_beside_legend(map text, width integer, height numeric, pixel float8,
    styles text[]) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
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

CREATE OR REPLACE FUNCTION streetgen._drawn_part()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('drawn');
END $$;
COMMENT ON FUNCTION streetgen._drawn_part() IS
    'What streetgen.svg draws, query by query, over a model %1$I and the query size of the drawing, from functions '
    '_ROOM_drawn: layer (drawn in ascending order), style, is it a line, geometry and key. subject: the query stands '
    'only in models that compute it, or all of several.';

CREATE OR REPLACE FUNCTION streetgen._drawn_instead() RETURNS TABLE(place integer, subject text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('drawn_instead');
END $$;
COMMENT ON FUNCTION streetgen._drawn_instead() IS
    'The queries of streetgen._drawn_part, from functions _ROOM_drawn_instead, that do not stand in models which '
    'compute a subject: its own show more.';

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
