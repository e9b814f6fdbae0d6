-- A cut across a street, drawn as engineers do: pieces side by side with their widths below.

CREATE OR REPLACE FUNCTION streetgen._traffic_outline(kind text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE
        WHEN kind = 'bus' THEN 'M-1.27.35V2.8Q-1.27 3.1-1 3.1H1Q1.27 3.1 1.27 2.8V.35H1.1V.03H.75V.35H-.75V.03'
            'H-1.1V.35ZM-1.1 1.3V2.6H1.1V1.3Z'
        WHEN kind = 'rail' THEN 'M-1.2.3V3Q-1.15 3.4-.9 3.4H.9Q1.15 3.4 1.2 3V.3H.8V.03H.67V.3H-.67V.03H-.8V.3Z'
            'M-1 1.5V2.9H1V1.5Z'
        WHEN kind IN ('cycle', 'cycle_track') THEN 'M-.04 0H.04V.72H.2Q.32 1.4.17 1.5H-.17Q-.32 1.4-.2.72H-.04Z'
            'M-.13 1.66a.13.13 0 1 1 .26 0a.13.13 0 1 1-.26 0Z'
        WHEN kind = 'sidewalk' THEN 'M-.16 0H-.03L0 .8L.03 0H.16L.2.85L.28 1.35Q.26 1.5.15 1.5'
            'H-.15Q-.26 1.5-.28 1.35L-.2.85ZM-.12 1.65a.12.12 0 1 1 .24 0a.12.12 0 1 1-.24 0Z'
        WHEN kind IN ('general', 'carpool', 'merging', 'parking', 'bay') THEN 'M-.9.35V.75Q-.88.9-.75.95L-.6 1.38'
            'Q-.56 1.48-.45 1.48H.45Q.56 1.48.6 1.38L.75.95Q.88.9.9.75V.35H.85V.03H.6V.35H-.6V.03H-.85V.35Z'
            'M-.58.95L-.47 1.35H.47L.58.95Z' END $$;
COMMENT ON FUNCTION streetgen._traffic_outline(text) IS
    'Who uses a piece of a cross-section, seen along the street: a path of SVG in metres, upwards from the middle of '
    'the ground. NULL: nobody.';

CREATE OR REPLACE FUNCTION streetgen._traffic_room(kind text, OUT width float8, OUT height float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN kind = 'bus' THEN 2.55 WHEN kind = 'rail' THEN 2.4
            WHEN kind IN ('cycle', 'cycle_track', 'sidewalk') THEN 0.8 ELSE 1.8 END,
        CASE kind WHEN 'bus' THEN 3.1 WHEN 'rail' THEN 3.4 ELSE 1.8 END $$;
COMMENT ON FUNCTION streetgen._traffic_room(text) IS 'Width and height (m) that such an outline takes.';

CREATE OR REPLACE FUNCTION streetgen._cross_section_drawn(model name, axis_id bigint, place float8)
    RETURNS TABLE(number integer, kind text, lane_id bigint, label text, layer text, rule text, inner_piece boolean,
        on_roadway boolean, low float8, high float8, rise float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 15 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    lanes jsonb;
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regclass('lane') IS NOT NULL THEN
        SELECT jsonb_object_agg(lane_id, CASE WHEN both_ways THEN '↕' WHEN along_axis THEN '↑' ELSE '↓' END)
            FROM lane JOIN edge e USING (edge_id) WHERE e.axis_id = _cross_section_drawn.axis_id
                AND lane.kind NOT IN ('parking', 'closed') INTO lanes;
    END IF;
    RETURN QUERY
    WITH piece AS (
        -- Metres to the right of the axis; ground that goes on is drawn so far.
        SELECT kind, kerb, lane_id, CASE side WHEN 'left' THEN -ends ELSE offset_from END AS low,
            CASE side WHEN 'left' THEN -offset_from ELSE ends END AS high
        FROM streetgen._cross_section(model, axis_id, place), LATERAL coalesce(offset_to, offset_from + 1.5) ends),
    -- A lane on both sides of the axis is drawn once, and one on both sides of a bay twice.
    whole AS (
        SELECT kind, kerb, lane_id, min(low) AS low, max(high) AS high FROM piece WHERE lane_id IS NOT NULL
            GROUP BY kind, kerb, lane_id, CASE WHEN low <> 0 AND high <> 0 THEN low END
        UNION ALL SELECT kind, kerb, lane_id, low, high FROM piece WHERE lane_id IS NULL),
    border AS (
        SELECT coalesce(min(high) FILTER (WHERE kind = 'kerb' AND kerb = 'standing' AND first), '-Infinity') AS on_left,
            coalesce(min(low) FILTER (WHERE kind = 'kerb' AND kerb = 'standing' AND NOT first), 'Infinity') AS on_right
        FROM (SELECT *, low < (SELECT avg(low + high) / 2 FROM whole
            WHERE lane_id IS NOT NULL OR kind IN ('roadway', 'shoulder', 'gutter', 'bay')) AS first FROM whole) w)
    SELECT row_number() OVER (ORDER BY low, high)::integer, kind, lane_id, CASE kind WHEN 'general' THEN 'lane'
            WHEN 'bus' THEN 'bus lane' WHEN 'carpool' THEN 'carpool lane' WHEN 'cycle' THEN 'cycle lane'
            WHEN 'cycle_track' THEN 'cycle track' WHEN 'rail' THEN 'track' WHEN 'merging' THEN 'merging lane'
            WHEN 'closed' THEN 'closed lane'
            WHEN 'kerb' THEN concat_ws(' ', nullif(kerb, 'standing'), 'kerb') WHEN 'outer' THEN '' ELSE kind END
            || coalesce(' ' || (lanes ->> lane_id::text), ''),
        CASE WHEN kind IN ('bus', 'carpool', 'cycle', 'cycle_track') THEN 'lane'
            WHEN kind IN ('kerb', 'gutter') THEN 'kerb' WHEN kind = 'sidewalk' THEN 'sidewalk'
            WHEN kind IN ('outer', 'median', 'splitter', 'island', 'furnishing', 'verge', 'buffer') THEN 'block'
            ELSE 'section' END,
        CASE WHEN kind IN ('bus', 'carpool', 'cycle') THEN kind WHEN kind = 'cycle_track' THEN 'cycle'
            WHEN kind = 'median' THEN 'strip'
            WHEN kind IN ('splitter', 'island', 'furnishing', 'verge', 'buffer') THEN 'island' ELSE '' END,
        row_number() OVER (ORDER BY low, high) > 1 AND lead(1) OVER (ORDER BY low, high) IS NOT NULL,
        lane_id IS NOT NULL OR kind IN ('roadway', 'shoulder', 'gutter', 'bay'), low, high,
        CASE WHEN low < on_left OR high > on_right THEN 0.12 ELSE 0 END::float8
    FROM whole, border WHERE high - low > 0.001;
END $$;
COMMENT ON FUNCTION streetgen._cross_section_drawn(name, bigint, float8) IS
    'The pieces of a cut from left to right as they are drawn, in metres to the right of the axis: with words, the '
    'layer and kind of the rule that fills them, and how high they rise above the roadway. Kerbs stand 12 cm high. The '
    'outermost ones go on.';

CREATE OR REPLACE FUNCTION streetgen._dimension_line(low float8, high float8, y float8, metres float8, style text)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT format('<path d="M%1$s %3$sH%2$sM%4$s %5$sl6-6M%6$s %5$sl6-6" style="%7$s"/>', a, b, c, a - 3, c + 3, b - 3,
            style)
        || format(CASE WHEN b - a > 30 THEN '<text x="%1$s" y="%2$s" text-anchor="middle">%4$s</text>'
            ELSE '<text transform="translate(%3$s %2$s)rotate(-90)">%4$s</text>' END,
            (a + b) / 2, c - 5, (a + b) / 2 + 4, trim(to_char(metres, '990.00')))
    FROM (SELECT round(low::numeric, 1) AS a, round(high::numeric, 1) AS b, round(y::numeric, 1) AS c) r $$;
COMMENT ON FUNCTION streetgen._dimension_line(float8, float8, float8, float8, text) IS
    'A line (SVG) with a tick at both ends and a width in metres above it, upright where it has no room.';

CREATE OR REPLACE FUNCTION streetgen.cross_section_svg(model name, axis bigint, metres float8,
    theme text DEFAULT 'street', scale float8 DEFAULT 100) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
#variable_conflict use_variable
DECLARE
    pixels float8;
    page record;
    hair text;
    street text;
    svg text;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('theme', theme, 'scale', scale::text),
        streetgen._check_theme(theme);
    IF scale NOT BETWEEN 10 AND 500 THEN
        RAISE EXCEPTION 'the scale is 1:%, expected 1:10 to 1:500', scale USING ERRCODE = '22023',
            HINT = 'Leave it out for 1:100.';
    END IF;
    -- Of a metre.
    pixels := 1 / (scale * streetgen._pixel_on_paper());
    SELECT * FROM streetgen._page(model, theme, scale) INTO page;
    hair := format('fill:none;stroke:%s;stroke-width:1', page.ink);
    SELECT a.name FROM axis a WHERE a.axis_id = axis INTO street;
    WITH piece AS MATERIALIZED (SELECT * FROM streetgen._cross_section_drawn(model, axis, metres)),
    size AS (
        SELECT s.*, wide / 2 - (low + high) / 2 * pixels AS zero, ground + 0.6 * pixels AS base
        FROM (SELECT min(low) AS low, max(high) AS high, greatest(480, 40 + (max(high) - min(low)) * pixels) AS wide,
            70 + max((streetgen._traffic_room(kind)).height) * pixels AS ground FROM piece) s),
    symbol AS MATERIALIZED (
        SELECT s.symbol, s.layer, s.kind, p.pattern, streetgen._as_css(coalesce(streetgen._pattern_name(p.pattern),
            s.fill), NULL, NULL, NULL, NULL, 1) AS style
        FROM streetgen._symbols(model, theme, scale) s, LATERAL (SELECT streetgen._pattern_as_svg(s.marker, s.fill,
            streetgen._drawn_metres(s.width, s.unit, 1), 1) AS pattern) p
        WHERE s.fill IS NOT NULL AND s.marker IS DISTINCT FROM 'shadow'),
    -- A kind without a rule of its own is filled as its layer.
    placed AS MATERIALIZED (
        SELECT DISTINCT ON (p.number) p.*, s.pattern, s.style, round((zero + p.low * pixels)::numeric, 1) AS x,
            round((zero + p.high * pixels)::numeric, 1) AS x_end, round((ground - rise * pixels)::numeric, 1) AS y
        FROM piece p CROSS JOIN size LEFT JOIN symbol s ON s.layer = p.layer AND s.kind IN (p.rule, '')
        ORDER BY p.number, s.kind <> p.rule, s.symbol DESC),
    run AS (
        SELECT min(low) AS low, max(high) AS high, count(*) AS pieces, count(*) OVER () AS runs FROM (
            SELECT p.*, number - row_number() OVER (PARTITION BY on_roadway ORDER BY number) AS turn
            FROM placed p WHERE inner_piece) p GROUP BY on_roadway, turn)
    SELECT format(E'<svg xmlns="http://www.w3.org/2000/svg" width="%1$s" height="%2$s" viewBox="0 0 %1$s %2$s" '
            'font-family="DejaVu Sans,sans-serif" font-size="11" fill="%3$s">\n'
            '<rect width="100%%" height="100%%" fill="%4$s"/>\n<text x="20" y="26" font-size="15" '
            'font-weight="bold">%5$s</text>\n<text x="20" y="44">%6$s</text>\n', ceil(wide), ceil(base + 174),
            page.ink, page.paper, streetgen._as_xml(coalesce(street, 'axis ' || axis)), format('axis %s at %s m, seen '
                'along it; widths in metres, 1:%s', axis, round(metres::numeric, 2), scale::numeric))
        -- What is paved lies on the ground.
        || (SELECT string_agg(DISTINCT coalesce(pattern, ''), '') FROM symbol)
        || (SELECT string_agg(format(E'<rect x="%s" y="%s" width="%s" height="%s" style="%s"/>\n', p.x,
                CASE n WHEN 1 THEN round(size.ground::numeric, 1) ELSE p.y END, p.x_end - p.x,
                round((CASE n WHEN 1 THEN 0.6 * pixels ELSE CASE WHEN p.layer = 'block' THEN 0.6 WHEN p.kind = 'kerb'
                    THEN 0.3 WHEN p.kind = 'sidewalk' THEN 0.2 ELSE 0.4 END * pixels + size.ground - p.y END)::numeric,
                    1),
                CASE WHEN n = 1 THEN g.style WHEN p.inner_piece
                    THEN format('%s;stroke:%s;stroke-width:.5', p.style, page.ink) ELSE p.style END), ''
                ORDER BY n, number)
            FROM placed p, (VALUES (1), (2)) turn(n), (SELECT style FROM symbol
                WHERE symbol.layer = 'block' AND symbol.kind = '' ORDER BY symbol DESC LIMIT 1) g)
        || coalesce((SELECT string_agg(format(E'<rect x="%s" y="%s" width="4" height="3" style="%s"/>\n', x - 2, y,
                s.style), '' ORDER BY number)
            FROM (SELECT *, lag(lane_id) OVER (ORDER BY number) AS lane_before FROM placed) p, symbol s
            WHERE lane_id IS NOT NULL AND lane_before IS NOT NULL AND s.layer = 'lane_separator'), '')
        || coalesce((SELECT string_agg(format(E'<path transform="translate(%s %s)scale(%s -%4$s)" d="%s" '
                'fill-rule="evenodd" fill-opacity="%s"/>\n', (x + x_end) / 2, y, NULL, round(pixels::numeric, 3), o,
                CASE WHEN kind IN ('parking', 'bay') THEN 0.3 ELSE 0.6 END), '' ORDER BY number)
            FROM placed, streetgen._traffic_outline(kind) o, streetgen._traffic_room(kind) r
            WHERE o IS NOT NULL AND high - low BETWEEN r.width AND CASE kind WHEN 'bay' THEN 3.2 ELSE 100 END), '')
        || (SELECT format(E'<path d="M%s %s%s" style="%s;stroke-width:1.8"/>\n', min(x),
                max(y) FILTER (WHERE number = 1), string_agg(format('V%sH%s', y, x_end), '' ORDER BY number), hair)
            FROM placed)
        -- Words below each piece, upright where they have no room.
        || (SELECT string_agg(CASE WHEN length(label) * 6.8 < x_end - x THEN format(
                E'<text x="%s" y="%s" text-anchor="middle">%s</text>\n', (x + x_end) / 2, round(base::numeric, 1) + 18,
                label) ELSE format(E'<text transform="translate(%s %s)rotate(-90)" text-anchor="end">%s</text>\n',
                (x + x_end) / 2 + 4, round(base::numeric, 1) + 7, label) END, '' ORDER BY number)
            FROM placed WHERE label <> '')
        || coalesce((SELECT string_agg(format(E'<path d="M%s %sV%s" style="%s" stroke-opacity=".3"/>\n', at,
                round(base::numeric, 1) + 3, round(base::numeric, 1) + 103, hair), '' ORDER BY at)
            FROM (SELECT x AS at FROM placed WHERE inner_piece UNION SELECT x_end FROM placed WHERE inner_piece) e), '')
        || coalesce((SELECT string_agg(streetgen._dimension_line(zero + d.low * pixels, zero + d.high * pixels, base
                + d.below, d.high - d.low, hair), E'\n' ORDER BY d.below, d.low)
            FROM (SELECT p.low, p.high, 100 AS below FROM piece p WHERE p.inner_piece AND p.high - p.low > 0.005
                UNION ALL SELECT r.low, r.high, 130 FROM run r WHERE r.runs > 1 AND r.pieces > 1
                UNION ALL SELECT min(r.low), max(r.high), 158 FROM run r) d), '')
        || format(E'\n<path d="M%1$s %2$sV%3$s" style="%4$s" stroke-dasharray="12 3 2 3"/>\n<text x="%1$s" y="%5$s" '
            'text-anchor="middle">axis</text>\n</svg>\n', round(zero::numeric, 1), 68, round(base::numeric, 1) + 4,
            hair, 64)
    FROM size WHERE low IS NOT NULL INTO svg;
    RETURN coalesce(svg, format('<svg xmlns="http://www.w3.org/2000/svg" width="480" height="40"><text x="20" y="26" '
        'fill="%s" font-family="DejaVu Sans,sans-serif" font-size="12">no cross-section of axis %s at %s m</text>'
        '</svg>', page.ink, axis, round(metres::numeric, 2)));
END $$;
COMMENT ON FUNCTION streetgen.cross_section_svg(name, bigint, float8, text, float8) IS
    'One cut across a street as engineers draw it (SVG), seen along its axis: pieces with their names and widths in '
    'metres, those of the roadway and of all, and whom each is for. Heights are not known: kerbs are drawn 12 cm high. '
    'theme: as of streetgen.svg; scale: 100 draws as for 1:100, where a pixel is 0.28 mm. Errors are those of '
    'streetgen.cross_section; another theme or scale: 22023.';
