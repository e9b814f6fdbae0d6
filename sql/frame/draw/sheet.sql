-- A sheet of paper with a map that is true to scale, its frame, legend and title.

CREATE OR REPLACE FUNCTION streetgen._checked_attribution(model name, value text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._believed_setting(model, 'attribution', value, length(value) <= 300,
        'Expected up to 300 letters; empty for none.') $$;
COMMENT ON FUNCTION streetgen._checked_attribution(name, text) IS 'A value of setting attribution; a long one: 22023.';

CREATE OR REPLACE FUNCTION streetgen._sheet_boxes(model name, middle geometry, wide float8, high float8,
    columns integer, rows integer) RETURNS SETOF geometry
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT place FROM generate_series(1, rows) r, generate_series(1, columns) c,
            ST_SetSRID(ST_Translate(ST_MakeEnvelope(0, 0, wide, high), ST_X(middle) + (c - 1 - columns / 2.0) * wide,
                ST_Y(middle) + (rows / 2.0 - r) * high), ST_SRID(middle)) place
        WHERE columns * rows = 1 OR EXISTS (SELECT FROM edge e WHERE e.geom && place AND ST_Intersects(e.geom, place))
        ORDER BY r, c;
END $$;
COMMENT ON FUNCTION streetgen._sheet_boxes(name, geometry, float8, float8, integer, integer) IS
    'The ground of each sheet of rows and columns of so many metres about a middle, row by row from the north-west; '
    'one of several that has no street is left out.';

CREATE OR REPLACE FUNCTION streetgen._sheet_index(map geometry, whole geometry, scale float8, boxes geometry[])
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT format(E'<g class="index" text-anchor="middle" font-weight="bold">\n%s</g>\n', string_agg(format(
            '<rect x="%s" y="%s" width="%s" height="%s" fill="none" stroke="currentColor" stroke-width="0.5"/>',
            round(x::numeric, 3), round(y::numeric, 3), round(wide::numeric, 3), round(high::numeric, 3))
        || streetgen._fitted_text(n::text, x + wide / 2, y + 0.6 * high, least(8, high / 3), wide), ''
        ORDER BY n))
    FROM unnest(boxes) WITH ORDINALITY b(box, n),
        LATERAL (SELECT ST_XMin(map) + (ST_XMin(box) - ST_XMin(whole)) * 1000 / scale AS x,
            ST_YMin(map) + (ST_YMax(whole) - ST_YMax(box)) * 1000 / scale AS y,
            (ST_XMax(box) - ST_XMin(box)) * 1000 / scale AS wide,
            (ST_YMax(box) - ST_YMin(box)) * 1000 / scale AS high) p $$;
COMMENT ON FUNCTION streetgen._sheet_index(geometry, geometry, float8, geometry[]) IS
    'The frames and numbers of sheets over a map that shows the whole.';

CREATE OR REPLACE FUNCTION streetgen._sheet_svg(model name, box geometry, wide float8, high float8, scale float8,
    theme text, lines text[], over text, OUT svg text, OUT symbols bigint[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    part record := streetgen._sheet_parts(wide, high);
    page record := streetgen._page(model, theme, scale);
    map record := streetgen._svg_map(model, box, streetgen._pixel_on_paper() * scale, theme, scale);
BEGIN
    symbols := map.symbols;
    svg := format(E'<svg xmlns="http://www.w3.org/2000/svg" width="%1$smm" height="%2$smm" viewBox="0 0 %1$s %2$s" '
            'font-family="DejaVu Sans,sans-serif" fill="%3$s" color="%3$s">\n', wide, high, page.ink)
        || format(E'<rect width="100%%" height="100%%" fill="%s"/>\n', page.paper)
        || format(E'<svg class="map" x="%s" y="%s" width="%s" height="%s" viewBox="0 0 %s %s">\n%s</svg>\n',
            ST_XMin(part.map), ST_YMin(part.map), ST_XMax(part.map) - ST_XMin(part.map), ST_YMax(part.map)
            - ST_YMin(part.map), round((ST_XMax(box) - ST_XMin(box))::numeric, 4),
            round((ST_YMax(box) - ST_YMin(box))::numeric, 4), map.drawing)
        || coalesce(over, '') || streetgen._sheet_grid(part.map, part.panel, box, scale)
        || streetgen._sheet_title(part.title, model, lines)
        || streetgen._sheet_legend(part.legend, model, theme, scale, map.symbols)
        || streetgen._sheet_foot(part.foot, scale) || E'</svg>\n';
END $$;
COMMENT ON FUNCTION streetgen._sheet_svg(name, geometry, float8, float8, float8, text, text[], text) IS
    'One sheet as SVG, so many millimetres wide and high, of a box of ground, and the symbols that are seen. over: SVG '
    'that lies over the map.';

CREATE OR REPLACE FUNCTION streetgen._sheet_lines(model name, theme text, paper text) RETURNS text[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY[format('Theme %s, paper %s', theme, paper), to_char(current_date, 'YYYY-MM-DD')]
        || (SELECT format('%s:%s, %s', r.auth_name, r.auth_srid, substring(r.srtext, '"([^"]*)"'))
            FROM streetgen.model m JOIN spatial_ref_sys r USING (srid) WHERE m.name = model)
        || (SELECT s.value FROM setting s WHERE s.name = 'attribution' AND s.value <> '');
END $$;
COMMENT ON FUNCTION streetgen._sheet_lines(name, text, text) IS
    'What the title of a sheet says below the name of the model: theme, paper, date, reference, and whose data it is.';

CREATE OR REPLACE FUNCTION streetgen.sheet(model name, scale float8 DEFAULT 500, paper text DEFAULT 'A3',
    centre geometry DEFAULT NULL, theme text DEFAULT 'street', upright boolean DEFAULT false)
    RETURNS TABLE(number integer, svg text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
DECLARE
    most constant integer := 100;
    size record;
    map geometry;
    extent geometry;
    whole geometry;
    middle geometry;
    -- Metres of ground of a sheet, and how many of them show the whole.
    wide float8;
    high float8;
    columns integer := 1;
    rows integer := 1;
    boxes geometry[];
    lines text[];
    small float8;
    page record;
    symbols bigint[] := '{}';
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('scale', scale::text, 'paper', paper, 'theme',
        theme, 'upright', upright::text), streetgen._check_theme(theme), streetgen._check_extent(model, centre),
        streetgen._check_type('the centre', centre, '{POINT}', 'ST_Point(x, y, srid) makes one.');
    IF ST_IsEmpty(centre) THEN
        RAISE EXCEPTION 'the centre is empty' USING ERRCODE = '22023',
            HINT = 'ST_Point(x, y, srid) makes one; NULL: sheets of the whole model.';
    END IF;
    IF NOT scale BETWEEN 10 AND 1e6 THEN
        RAISE EXCEPTION 'the scale is 1:%, expected 1:10 to 1:1000000', scale USING ERRCODE = '22023',
            HINT = '500 draws a sheet of 1:500.';
    END IF;
    SELECT * INTO size FROM streetgen._paper() p WHERE p.paper = upper(sheet.paper COLLATE "default");
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no paper "%"', paper USING ERRCODE = '22023', HINT = 'Papers are A0 to A5.';
    END IF;
    IF upright THEN
        SELECT size.paper, size.short AS long, size.long AS short INTO size;
    END IF;
    map := (streetgen._sheet_parts(size.long, size.short)).map;
    wide := (ST_XMax(map) - ST_XMin(map)) * scale / 1000;
    high := (ST_YMax(map) - ST_YMin(map)) * scale / 1000;
    extent := streetgen._model_extent(model);
    whole := ST_SetSRID(coalesce(extent, ST_MakeEnvelope(0, 0, 1, 1)),
        (SELECT m.srid FROM streetgen.model m WHERE m.name = model));
    middle := coalesce(ST_SetSRID(centre, ST_SRID(whole)), ST_Centroid(whole));
    IF NOT ST_Intersects(whole, ST_MakeEnvelope(ST_X(middle) - wide / 2, ST_Y(middle) - high / 2,
        ST_X(middle) + wide / 2, ST_Y(middle) + high / 2, ST_SRID(whole))) THEN
        RAISE EXCEPTION 'a sheet about %,% lies outside of model "%"', ST_X(middle), ST_Y(middle), model
            USING ERRCODE = '22023', HINT = CASE WHEN extent IS NULL THEN 'The model has no axes yet.'
                ELSE format('The model lies in %s,%s,%s,%s.', round(ST_XMin(whole)), round(ST_YMin(whole)),
                    round(ST_XMax(whole)), round(ST_YMax(whole))) END;
    END IF;
    IF centre IS NULL THEN
        columns := ceil((ST_XMax(whole) - ST_XMin(whole)) / wide);
        rows := ceil((ST_YMax(whole) - ST_YMin(whole)) / high);
        IF columns::bigint * rows <= 100 * most THEN
            boxes := ARRAY(SELECT streetgen._sheet_boxes(model, middle, wide, high, columns, rows));
        END IF;
        IF cardinality(boxes) > most OR boxes IS NULL THEN
            RAISE EXCEPTION 'model "%" would take % sheets, expected up to %', model, coalesce(cardinality(boxes),
                columns::bigint * rows), most USING ERRCODE = '22023',
                HINT = 'Take a larger paper, a smaller scale such as 1:5000, or a centre.';
        END IF;
    END IF;
    IF coalesce(cardinality(boxes), 0) = 0 THEN
        boxes := ARRAY(SELECT streetgen._sheet_boxes(model, middle, wide, high, 1, 1));
    END IF;
    lines := streetgen._sheet_lines(model, theme, size.paper);
    IF cardinality(boxes) > 1 THEN
        -- All of them have room on one.
        small := scale * greatest(columns, rows);
        number := 0;
        whole := (SELECT b FROM streetgen._sheet_boxes(model, middle, wide * small / scale, high * small / scale, 1,
            1) b);
        svg := (streetgen._sheet_svg(model, whole, size.long, size.short, small, theme,
            format('Index of %s sheets of 1:%s', cardinality(boxes), scale) || lines,
            streetgen._sheet_index(map, whole, small, boxes))).svg;
        RETURN NEXT;
    END IF;
    FOR i IN 1 .. cardinality(boxes) LOOP
        number := i;
        page := streetgen._sheet_svg(model, boxes[i], size.long, size.short, scale, theme, CASE
            WHEN cardinality(boxes) > 1 THEN ARRAY[format('Sheet %s of %s', i, cardinality(boxes))] ELSE '{}' END
            || lines, NULL);
        svg := page.svg;
        symbols := symbols || page.symbols;
        RETURN NEXT;
    END LOOP;
    PERFORM streetgen._tell_unused_rules(model, (SELECT ST_SetSRID(ST_Extent(b), ST_SRID(middle)) FROM unnest(boxes) b),
        theme, scale, symbols);
END $$;
COMMENT ON FUNCTION streetgen.sheet(name, float8, text, geometry, text, boolean) IS
    'Sheets of paper (SVG, in millimetres) with a map of 1:scale, its frame with coordinates, legend, scale and title: '
    'the one about a centre, or as many as show the whole model, after an index (number 0). paper: A0 to A5. upright: '
    'the map stands above title and legend. Each is true to scale when it is printed in its own size. Setting '
    'attribution says whose data it shows. A theme, scale or paper that is none, a centre whose sheet lies outside of '
    'the model, or more than 100 sheets: 22023.';
