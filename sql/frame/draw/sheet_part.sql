-- The parts of a sheet of paper, in millimetres from its upper left corner, downwards.

CREATE OR REPLACE FUNCTION streetgen._paper() RETURNS TABLE(paper text, long float8, short float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES ('A0', 1189, 841), ('A1', 841, 594), ('A2', 594, 420), ('A3', 420, 297), ('A4', 297, 210),
        ('A5', 210, 148) $$;
COMMENT ON FUNCTION streetgen._paper() IS 'Papers of ISO 216, in millimetres.';

CREATE OR REPLACE FUNCTION streetgen._sheet_parts(wide float8, high float8, OUT map geometry, OUT panel geometry,
    OUT title geometry, OUT legend geometry, OUT foot geometry)
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Printers leave some millimetres free, and coordinates stand round the map.
    near constant float8 := least(15, greatest(6, greatest(wide, high) / 42)) + 5;
    aside constant float8 := least(120, greatest(50, 0.2 * greatest(wide, high)));
    x float8 := wide - near - aside;
    y float8 := high - near - aside;
BEGIN
    IF wide > high THEN
        map := ST_MakeEnvelope(near, near, x - 8, high - near);
        panel := ST_MakeEnvelope(x, near, wide - near + 5, high - near);
        title := ST_MakeEnvelope(x + 4, near + 3, wide - near + 1, near + 44);
        legend := ST_MakeEnvelope(x + 4, near + 48, wide - near + 1, high - near - 38);
        foot := ST_MakeEnvelope(x + 4, high - near - 34, wide - near + 1, high - near - 3);
    ELSE
        map := ST_MakeEnvelope(near, near, wide - near, y - 8);
        panel := ST_MakeEnvelope(near, y, wide - near, high - near + 5);
        x := (wide - 2 * near) / 10;
        title := ST_MakeEnvelope(near + 4, y + 3, near + 3.3 * x, high - near + 1);
        legend := ST_MakeEnvelope(near + 3.5 * x, y + 5, near + 7.4 * x, high - near + 1);
        foot := ST_MakeEnvelope(near + 7.6 * x, y + 3, wide - near - 4, high - near + 2);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._sheet_parts(float8, float8) IS
    'Where map, panel, and in it title, legend and foot stand on a paper: beside the map, or below it where the paper '
    'is upright.';

CREATE OR REPLACE FUNCTION streetgen._round_length(longest float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT power * CASE WHEN longest >= 5 * power THEN 5 WHEN longest >= 2 * power THEN 2 ELSE 1 END
        FROM (SELECT (10::numeric ^ floor(log(longest)))::float8 AS power) p $$;
COMMENT ON FUNCTION streetgen._round_length(float8) IS
    'The greatest length that is not longer, and 1, 2 or 5 of a power of ten.';

CREATE OR REPLACE FUNCTION streetgen._fitted_text(words text, x float8, y float8, size float8, wide float8,
    attributes text DEFAULT '') RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format(E'<text x="%s" y="%s" font-size="%s"%s>%s</text>\n', round(x::numeric, 3), round(y::numeric, 3),
            round(least(size, wide / nullif(max(ends), 0))::numeric, 3), attributes, streetgen._as_xml(words))
        FROM streetgen._letters(words) $$;
COMMENT ON FUNCTION streetgen._fitted_text(text, float8, float8, float8, float8, text) IS
    'A text as SVG, its letters so high, or smaller, as it is no wider than that.';

CREATE OR REPLACE FUNCTION streetgen._sheet_grid(map geometry, panel geometry, box geometry,
    scale float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- Lines of the grid are 40 to 100 mm apart.
    WITH step AS (SELECT streetgen._round_length(0.1 * scale) AS metres),
    east AS (SELECT metres * n AS said, ST_XMin(map) + (metres * n - ST_XMin(box)) * 1000 / scale AS x
        FROM step, generate_series(ceil(ST_XMin(box) / metres)::bigint, floor(ST_XMax(box) / metres)::bigint) n),
    north AS (SELECT metres * n AS said, ST_YMax(map) - (metres * n - ST_YMin(box)) * 1000 / scale AS y
        FROM step, generate_series(ceil(ST_YMin(box) / metres)::bigint, floor(ST_YMax(box) / metres)::bigint) n),
    line AS (
        SELECT format('M%s %sh6m-3 -3v6', round((x - 3)::numeric, 3), round(y::numeric, 3)) AS path FROM east, north
            WHERE ST_Expand(map, -3) ~ ST_MakePoint(x, y)
        UNION ALL SELECT format('M%s %sv%s', round(x::numeric, 3), t, side) FROM east,
            (VALUES (ST_YMin(map), -1.5), (ST_YMax(map), 1.5)) v(t, side)
        UNION ALL SELECT format('M%s %sh%s', t, round(y::numeric, 3), side) FROM north,
            (VALUES (ST_XMin(map), -1.5), (ST_XMax(map), 1.5)) v(t, side)),
    label AS (
        SELECT format('<text x="%s" y="%s">%s E</text>', round(x::numeric, 3), t, said::numeric) AS words FROM east,
            unnest(ARRAY[ST_YMin(map) - 2, ST_YMax(map) + 3.8]) t
            WHERE x BETWEEN ST_XMin(map) + 8 AND ST_XMax(map) - 8
        UNION ALL SELECT format('<text transform="translate(%s %s)rotate(-90)">%s N</text>', t, round(y::numeric, 3),
            said::numeric) FROM north, unnest(ARRAY[ST_XMin(map) - 2, ST_XMax(map) + 3.8]) t
            WHERE y BETWEEN ST_YMin(map) + 8 AND ST_YMax(map) - 8)
    SELECT format(E'<path class="grid" fill="none" stroke="currentColor" stroke-width="0.18" d="%s"/>\n',
            (SELECT string_agg(path, '') FROM line))
        || (SELECT string_agg(format(E'<rect class="%s" x="%s" y="%s" width="%s" height="%s" fill="none" '
            'stroke="currentColor" stroke-width="0.35"/>\n', name, round(ST_XMin(part)::numeric, 3),
            round(ST_YMin(part)::numeric, 3), round((ST_XMax(part) - ST_XMin(part))::numeric, 3),
            round((ST_YMax(part) - ST_YMin(part))::numeric, 3)), '')
            FROM (VALUES ('frame', map), ('panel', panel)) f(name, part))
        || format(E'<g class="coordinates" font-size="2.2" text-anchor="middle">\n%s\n</g>\n',
            (SELECT string_agg(words, E'\n') FROM label)) $$;
COMMENT ON FUNCTION streetgen._sheet_grid(geometry, geometry, geometry, float8) IS
    'The frames of a panel and of a map that shows a box of ground, with ticks, crosses and coordinates of round '
    'numbers of metres.';

CREATE OR REPLACE FUNCTION streetgen._wrapped(words text, wide float8) RETURNS text[]
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    lines text[] := '{}';
    line text;
    longer text;
    word text;
BEGIN
    FOREACH word IN ARRAY string_to_array(words, ' ') LOOP
        longer := concat_ws(' ', line, word);
        IF (SELECT max(ends) FROM streetgen._letters(longer)) > wide AND line IS NOT NULL THEN
            lines := lines || line;
            longer := word;
        END IF;
        line := longer;
    END LOOP;
    RETURN lines || line;
END $$;
COMMENT ON FUNCTION streetgen._wrapped(text, float8) IS
    'A text as lines, each no longer than that, in heights of the font, but for a word that is longer.';

CREATE OR REPLACE FUNCTION streetgen._sheet_title(part geometry, name text, lines text[]) RETURNS text
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    x constant float8 := ST_XMin(part);
    y constant float8 := ST_YMin(part) + 5.5;
    wide constant float8 := ST_XMax(part) - x;
    size float8 := 2.8;
    written text[];
BEGIN
    LOOP
        written := ARRAY(SELECT w FROM unnest(lines) WITH ORDINALITY l(line, n), unnest(streetgen._wrapped(line, wide
            / size)) WITH ORDINALITY u(w, m) ORDER BY n, m);
        EXIT WHEN y + 2 + 1.6 * size * cardinality(written) <= ST_YMax(part) OR size < 0.5;
        -- Many lines get smaller letters.
        size := 0.9 * size;
    END LOOP;
    RETURN format(E'<g class="title">\n%s%s</g>\n', streetgen._fitted_text(name, x, y, 6, wide, ' font-weight="bold"'),
        (SELECT string_agg(streetgen._fitted_text(w, x, y + 2 + 1.6 * size * n, size, wide), '' ORDER BY n)
            FROM unnest(written) WITH ORDINALITY u(w, n)));
END $$;
COMMENT ON FUNCTION streetgen._sheet_title(geometry, text, text[]) IS
    'The title of a sheet: a name, and lines, wrapped to the width of the part and no higher than it is.';

CREATE OR REPLACE FUNCTION streetgen._sheet_legend(part geometry, model name, theme text, scale float8,
    symbols bigint[]) RETURNS text
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
    -- A swatch is 9 by 4.5 mm, as its pixels are of 0.28 mm, and smaller where many have no room.
    WITH entry AS MATERIALIZED (SELECT * FROM streetgen._svg_legend(model, theme, scale, symbols)),
    room AS (SELECT columns, wide / columns AS wide, rows, least(1, high / (6.5 * greatest(rows, 1))) AS shrunk
        FROM (SELECT ST_XMax(part) - ST_XMin(part) AS wide, ST_YMax(part) - ST_YMin(part) AS high) p,
            LATERAL (SELECT greatest(1, floor(wide / 44))::integer AS columns) c,
            LATERAL (SELECT ceil(count(*) / columns::numeric)::integer AS rows FROM entry) r)
    SELECT format(E'<g class="legend">\n%s</g>\n', string_agg(format('<g transform="translate(%s %s)scale(%s)">%s</g>',
            round((ST_XMin(part) + (turn - 1) / rows * wide)::numeric, 3),
            round((ST_YMin(part) + (turn - 1) % rows * 6.5 * shrunk)::numeric, 3),
            round((0.28 * shrunk)::numeric, 4), swatch) || streetgen._fitted_text(words,
                ST_XMin(part) + (turn - 1) / rows * wide + 11.5 * shrunk,
                ST_YMin(part) + ((turn - 1) % rows * 6.5 + 3.3) * shrunk, 2.8 * shrunk, wide - 12.5 * shrunk), ''
            ORDER BY turn))
    FROM room LEFT JOIN entry ON true $$;
COMMENT ON FUNCTION streetgen._sheet_legend(geometry, name, text, float8, bigint[]) IS
    'The legend of the symbols that a sheet shows, in as many columns as the part is wide.';

CREATE OR REPLACE FUNCTION streetgen._sheet_foot(part geometry, scale float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT format(E'<g class="north" transform="translate(%s %s)"><path d="M0 -8L3 4L0 1.8z" fill="currentColor"/>'
            '<path d="M0 -8L-3 4L0 1.8z" fill="none" stroke="currentColor" stroke-width="0.25"/>'
            '<text y="8" font-size="3.4" text-anchor="middle">N</text></g>\n', ST_XMin(part) + 5, ST_YMax(part) - 22)
        || format('<text x="%s" y="%s" font-size="5">1:%s</text>', ST_XMin(part) + 13, ST_YMax(part) - 16,
            trim_scale(scale::numeric))
        || format(E'<g class="bar" transform="translate(%s %s)" stroke="currentColor" stroke-width="0.25">%s</g>\n',
            ST_XMin(part), ST_YMax(part) - 8, (SELECT string_agg(format('<path d="M%s 0h%sv2h-%2$sz" fill="%s"/>',
            round((n * each)::numeric, 3), round(each::numeric, 3), CASE n % 2 WHEN 0 THEN 'currentColor' ELSE 'none'
            END), '' ORDER BY n) FROM generate_series(0, fields - 1) n))
        || format(E'<text x="%1$s" y="%2$s" font-size="2.5">0</text><text x="%3$s" y="%2$s" font-size="2.5" '
            'text-anchor="end">%4$s m</text>\n', ST_XMin(part), ST_YMax(part) - 2.5,
            round((ST_XMin(part) + fields * each)::numeric, 3), metres::numeric)
    FROM streetgen._round_length(0.001 * scale * (ST_XMax(part) - ST_XMin(part))) metres,
        LATERAL (SELECT CASE WHEN metres::numeric::text ~ '^[0.]*2' THEN 4 ELSE 5 END AS fields) f,
        LATERAL (SELECT metres * 1000 / scale / fields AS each) e $$;
COMMENT ON FUNCTION streetgen._sheet_foot(geometry, float8) IS 'An arrow to the north, a scale and its bar.';
