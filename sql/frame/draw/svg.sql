-- Pictures of a model.

CREATE OR REPLACE FUNCTION streetgen._shapes(model name, box geometry, layers text[]) RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    rooms constant text[] := '{frame}'::text[] || streetgen._rooms_of(model);
    part text;
    instead record;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(rooms, '_%s_drawn_instead', '')
    LOOP
        FOR instead IN EXECUTE part LOOP
            layers := array_remove(layers, instead.layer);
        END LOOP;
    END LOOP;
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(rooms, '_%s_drawn', 'name, geometry, text[]')
    LOOP
        RETURN QUERY EXECUTE part USING model, box, layers;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._shapes(name, geometry, text[]) IS
    'What some layers of a model have in a box, from functions _ROOM_drawn (model, box, layers) of the subjects that '
    'it computes; layers that _ROOM_drawn_instead names are left to that room.';

CREATE OR REPLACE FUNCTION streetgen._moving_shapes(model name, box geometry, layers text[], run text, at float8)
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms(), '_%s_moving',
        'name, geometry, text[], text, float8')
    LOOP
        RETURN QUERY EXECUTE part USING model, box, layers, run, at;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._moving_shapes(name, geometry, text[], text, float8) IS
    'What of a model moves and is in a box, from functions _ROOM_moving (model, box, layers, run, at): at seconds of a '
    'run that was kept; run NULL: as it stands now.';

CREATE OR REPLACE FUNCTION streetgen._animated_shapes(model name, box geometry, layers text[], run text, pace float8)
    RETURNS SETOF streetgen.animated_shape
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms(), '_%s_animated',
        'name, geometry, text[], text, float8')
    LOOP
        RETURN QUERY EXECUTE part USING model, box, layers, run, pace;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._animated_shapes(name, geometry, text[], text, float8) IS
    'What of a run moves through a box, so many times as fast, from functions _ROOM_animated (model, box, layers, run, '
    'pace).';

CREATE OR REPLACE FUNCTION streetgen._drawn_as(model name)
    RETURNS TABLE(layer text, kind text, drawn_as text, turn integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms_of(model), '_%s_drawn_as', 'name')
    LOOP
        RETURN QUERY EXECUTE part USING model;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._drawn_as(name) IS
    'The kinds as which a kind of a layer may be drawn, in turn, from functions _ROOM_drawn_as (model).';

CREATE OR REPLACE FUNCTION streetgen._drawn_kinds(model name, theme text, scale float8)
    RETURNS TABLE(layer text, kind text, drawn_as text)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog
    AS $$
    WITH rule AS MATERIALIZED (SELECT DISTINCT r.layer, r.kind FROM streetgen._rules(model, theme, scale) r)
    SELECT DISTINCT ON (k.layer, k.kind) k.layer, k.kind, k.drawn_as FROM (
        SELECT r.layer, r.kind, r.kind AS drawn_as, 0 AS turn FROM rule r
        UNION ALL SELECT a.layer, a.kind, a.drawn_as, a.turn FROM streetgen._drawn_as(model) a
            JOIN rule r ON (r.layer, r.kind) = (a.layer, a.drawn_as)) k
    ORDER BY k.layer, k.kind, k.turn $$;
COMMENT ON FUNCTION streetgen._drawn_kinds(name, text, float8) IS
    'By the rules of which kind a kind of a layer is drawn, in a theme at a scale; any other by those of kind ''''.';

CREATE OR REPLACE FUNCTION streetgen._svg_legend(model name, theme text, scale float8, symbols bigint[])
    RETURNS TABLE(turn bigint, swatch text, words text)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 12 SET search_path = pg_catalog
    AS $$
    SELECT row_number() OVER (ORDER BY symbol), format(CASE WHEN fill IS NULL THEN '<path style="%2$s" d="M0 8h32"/>'
            ELSE '%1$s<rect style="%2$s" width="32" height="16"/><path fill="none" stroke="currentColor" '
                'stroke-opacity=".3" d="M0 0h32v16h-32z"/>' END, pattern,
            streetgen._as_css(coalesce(streetgen._pattern_name(pattern), fill), CASE WHEN marker IS NULL THEN line END,
                CASE WHEN unit = 'pixel' THEN width WHEN fill IS NULL THEN 2.5 ELSE 1 END, 'metre', dash, 1)),
            streetgen._as_xml(CASE WHEN length(meaning) > 80 THEN left(meaning, 79) || '…' ELSE meaning END)
    FROM (SELECT DISTINCT ON (meaning) * FROM streetgen._symbols(model, theme, scale)
        WHERE symbol = ANY (symbols) AND meaning IS NOT NULL ORDER BY meaning, symbol) s,
        streetgen._pattern_as_svg(marker, fill, streetgen._drawn_metres(width, unit, 1), 1) pattern
    $$;
COMMENT ON FUNCTION streetgen._svg_legend(name, text, float8, bigint[]) IS
    'What the symbols of a drawing mean, in their order from below, each with a swatch (SVG) of 32 by 16 '
    'pixels.';

CREATE OR REPLACE FUNCTION streetgen._svg_beside_legend(model name, map text, width integer, height numeric,
    pixel float8, theme text, scale float8, symbols bigint[]) RETURNS text
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
    -- Its longest words, and the scale bar of up to 180 pixels, say how wide it is.
    WITH legend AS MATERIALIZED (SELECT * FROM streetgen._svg_legend(model, theme, scale, symbols))
    SELECT format('<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s">', width + wide,
        greatest(height, tall)) || E'\n<rect width="100%" height="100%" fill="' || paper || E'"/>\n' || map
        || format('<svg x="%s" width="%s" height="%s" font-family="DejaVu Sans,sans-serif" font-size="14" fill="%s">',
            width, wide, tall, ink) || E'\n'
        || coalesce((SELECT string_agg(format('<g transform="translate(16 %s)">%s<text x="44" y="13">%s</text></g>',
            26 * l.turn - 10, l.swatch, l.words), E'\n' ORDER BY l.turn) FROM legend l), '') || E'\n'
        || format('<path transform="translate(16 %s)" d="M0 0v8h%sv-8" fill="none" stroke="%s" '
            'stroke-width="1.5"/><text x="16" y="%s">%s m</text>', tall - 44, round((metres / pixel)::numeric, 2), ink,
            tall - 18, metres::numeric) || E'\n</svg>\n</svg>\n'
    FROM (SELECT 26 * count(*) + 72 AS tall, greatest(212, 76 + ceil(14 * max((SELECT max(ends)
            FROM streetgen._letters(words))))) AS wide, 180 * pixel AS longest FROM legend) size,
        streetgen._round_length(longest) metres, streetgen._page(model, theme, scale) page
    $$;
COMMENT ON FUNCTION streetgen._svg_beside_legend(name, text, integer, numeric, float8, text, float8, bigint[]) IS
    'A map (SVG of width by height, in pixels of so many metres) with the legend of its symbols and a scale beside it, '
    'whose letters are 14 pixels high whatever the width.';

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

CREATE OR REPLACE FUNCTION streetgen._shape_as_svg(geom geometry, x float8, y float8, pixel float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE GeometryType(geom) WHEN 'COMPOUNDCURVE' THEN streetgen._curve_as_svg(geom, x, y)
        -- A line of paint is a decimetre wide; a point that an intersection leaves beside its surface is no path.
        ELSE ST_AsSVG(ST_Translate(ST_RemoveRepeatedPoints(ST_CollectionExtract(geom),
            CASE WHEN pixel > 1 THEN pixel / 4 ELSE least(pixel / 4, 0.03) END), -x, -y), 1,
            greatest(0, least(3, ceil(log(8 / pixel))::integer))) END $$;
COMMENT ON FUNCTION streetgen._shape_as_svg(geometry, float8, float8, float8) IS
    'A geometry as a path of SVG, to an eighth of a pixel (metres); x and y are those of the upper left corner of the '
    'picture.';

CREATE OR REPLACE FUNCTION streetgen._tell_unused_rules(model name, box geometry, theme text, scale float8,
    symbols bigint[]) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    unused record;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR unused IN SELECT DISTINCT r.layer, r.kind FROM symbol_rule r WHERE r.theme = _tell_unused_rules.theme
        AND scale > r.from_scale AND scale <= r.to_scale AND r.kind <> '' AND r.layer NOT IN ('name', 'ref')
        AND (r.layer, r.kind) NOT IN (SELECT a.layer, a.kind FROM streetgen.symbol_rule a)
        -- One without a colour hides what may be drawn as it.
        AND NOT (num_nonnulls(r.fill, r.line) = 0
            AND (r.layer, r.kind) IN (SELECT a.layer, a.drawn_as FROM streetgen._drawn_as(model) a))
        AND (r.layer, r.kind) NOT IN (SELECT s.layer, s.kind FROM streetgen._symbols(model, theme, scale) s
            WHERE s.symbol = ANY (symbols)) ORDER BY 1, 2
    LOOP
        RAISE WARNING 'the rule of %.symbol_rule for kind "%" of layer % draws nothing here', quote_ident(model),
            unused.kind, unused.layer USING HINT = format('Kinds of this layer are %s.', coalesce((
                SELECT string_agg(DISTINCT quote_literal(k.kind), ', ') FROM (
                    SELECT a.kind FROM streetgen.symbol_rule a WHERE a.layer = unused.layer
                    UNION ALL SELECT h.kind FROM streetgen._shapes(model, box, ARRAY[unused.layer]) h) k
                WHERE k.kind <> ''), ''''' alone'));
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._tell_unused_rules(name, geometry, text, float8, bigint[]) IS
    'Tells by a warning of a model''s own rules for a kind that no rule of all models has and that is not among the '
    'symbols of a drawing: it may be misspelt.';

CREATE OR REPLACE FUNCTION streetgen._svg_map(model name, box geometry, pixel float8, theme text, scale float8,
    run text DEFAULT NULL, at float8 DEFAULT 0, pace float8 DEFAULT NULL, OUT drawing text, OUT symbols bigint[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    layers constant text[] := ARRAY(SELECT DISTINCT s.layer FROM streetgen._symbols(model, theme, scale) s);
BEGIN
    WITH symbol AS MATERIALIZED (SELECT r.*, streetgen._pattern_as_svg(r.marker, r.fill,
            streetgen._drawn_metres(r.width, r.unit, pixel), pixel) AS pattern
            FROM streetgen._symbols(model, theme, scale) r),
    element AS (
        SELECT h.layer, h.kind, h.level, h.id, format('<path d="%s"/>', nullif(
            streetgen._shape_as_svg(h.geom, ST_XMin(box), ST_YMax(box), pixel), '')) AS element
        FROM (SELECT * FROM streetgen._shapes(model, box, layers)
            UNION ALL SELECT m.* FROM streetgen._moving_shapes(model, box, layers, run, at) m
            WHERE pace IS NULL) h
        -- Half a pixel is not seen.
        WHERE greatest(ST_XMax(h.geom) - ST_XMin(h.geom), ST_YMax(h.geom) - ST_YMin(h.geom)) >= pixel / 2
            AND (h.geom @ box OR ST_Intersects(h.geom, box))
        UNION ALL SELECT a.* FROM streetgen._animated_shapes(model, box, layers, run, pace) a
        WHERE pace IS NOT NULL),
    shape AS MATERIALIZED (
        SELECT e.layer, coalesce(k.drawn_as, '') AS kind, e.level, e.id, e.element
        FROM element e LEFT JOIN streetgen._drawn_kinds(model, theme, scale) k USING (layer, kind)),
    drawn AS (
        SELECT s.symbol, coalesce(h.level * 10, 1e6) + s.place AS height,
            format(E'<g class="%s" style="%s"%s>%s\n%s\n</g>',
                streetgen._as_xml(concat_ws(' ', s.layer, nullif(s.kind, ''))),
                streetgen._as_css(coalesce(streetgen._pattern_name(s.pattern), s.fill),
                    CASE WHEN s.marker IS NULL THEN s.line END, s.width, s.unit, s.dash, pixel),
                CASE s.marker WHEN 'shadow' THEN format(' transform="translate(%1$s %1$s)"',
                    streetgen._drawn_metres(s.width, s.unit, pixel)) END, s.pattern,
                string_agg(h.element, E'\n' ORDER BY h.id, h.element)) AS part
        FROM shape h JOIN symbol s USING (layer, kind) WHERE h.element <> ''
        GROUP BY s.symbol, s.layer, s.kind, s.place, s.fill, s.line, s.marker, s.width, s.unit, s.dash, s.pattern,
            h.level)
    SELECT coalesce((SELECT string_agg(format(E'<rect width="100%%" height="100%%" fill="%s"/>\n', s.fill), ''
            ORDER BY s.symbol) FROM symbol s WHERE s.layer = 'ground' AND s.fill IS NOT NULL), '')
        || coalesce((SELECT string_agg(d.part, E'\n' ORDER BY d.height, d.symbol) FROM drawn d) || E'\n',
            -- A picture of nothing says so.
            (SELECT format(E'<text x="%s" y="%s" fill="%s" text-anchor="middle" style="font:%spx DejaVu Sans,'
                'sans-serif">nothing here at 1:%s</text>\n', (ST_XMax(box) - ST_XMin(box)) / 2,
                (ST_YMax(box) - ST_YMin(box)) / 2, s.fill, round((16 * pixel)::numeric, 4), round(scale))
            FROM symbol s WHERE s.layer = 'ink' AND s.fill IS NOT NULL ORDER BY s.symbol DESC LIMIT 1), '')
        || (SELECT n.svg || streetgen._svg_refs(model, box, pixel, theme, scale, n.taken)
            FROM streetgen._svg_names(model, box, pixel, theme, scale) n), ARRAY(SELECT DISTINCT d.symbol FROM drawn d)
        INTO drawing, symbols;
END $$;
COMMENT ON FUNCTION streetgen._svg_map(name, geometry, float8, text, float8, text, float8, float8) IS
    'What streetgen.svg draws in a box of a model, in metres from its upper left corner, for pixels of so many metres, '
    'with a run at a time, or moving at a pace; and the symbols that are seen.';

CREATE OR REPLACE FUNCTION streetgen._model_extent(model name) RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT ST_Expand(ST_Extent(geom)::box2d, 10)::geometry FROM axis);
END $$;
COMMENT ON FUNCTION streetgen._model_extent(name) IS
    'The box of the axes of a model and 10 m about it; NULL where there is none.';
