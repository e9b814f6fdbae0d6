-- Numbers of routes stand in boxes on their roads.

CREATE OR REPLACE FUNCTION streetgen._numbers(model name, box geometry)
    RETURNS TABLE(ref text, importance integer, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms_of(model), '_%s_numbered', 'name, geometry')
    LOOP
        RETURN QUERY EXECUTE part USING model, box;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._numbers(name, geometry) IS
    'The numbers of routes in a box of a model, from functions _ROOM_numbered (model, box): the line along which one '
    'stands, and how important it is, 1 the most.';

CREATE OR REPLACE FUNCTION streetgen._number_as_svg(number text, shield geometry, size float8, fill text, line text,
    x float8, y float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT format(E'<g class="ref"><rect style="fill:%1$s;stroke:%2$s;stroke-width:%3$s" x="%4$s" '
            'y="%5$s" width="%6$s" height="%7$s" rx="%8$s"/><text style="fill:%2$s;text-anchor:middle;font:bold '
            '%9$spx DejaVu Sans,sans-serif" x="%10$s" y="%11$s">%12$s</text></g>\n',
        coalesce(fill, 'none'), coalesce(line, 'none'),
        round((size / 10)::numeric, 4), round((ST_XMin(shield) - x)::numeric, 3),
        round((y - ST_YMax(shield))::numeric, 3), round((ST_XMax(shield) - ST_XMin(shield))::numeric, 3),
        round((ST_YMax(shield) - ST_YMin(shield))::numeric, 3), round((size / 4)::numeric, 4), round(size::numeric, 4),
        round(((ST_XMin(shield) + ST_XMax(shield)) / 2 - x)::numeric, 3),
        round((y - (ST_YMin(shield) + ST_YMax(shield)) / 2 + 0.36 * size)::numeric, 3), streetgen._as_xml(number)) $$;
COMMENT ON FUNCTION streetgen._number_as_svg(text, geometry, float8, text, text, float8, float8) IS
    'The number of a route in its box as SVG; size: of the font, metres; x and y are those of the upper left corner of '
    'the picture.';

CREATE OR REPLACE FUNCTION streetgen._svg_refs(model name, box geometry, pixel float8, theme text, scale float8,
    taken geometry[]) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- The number of a long road stands again after so many pixels, and not within half of that.
    again constant float8 := 700 * pixel;
    route record;
    number text;
    parts integer;
    shield geometry;
    numbers text[] := '{}';
    shields geometry[] := '{}';
    svg text := '';
BEGIN
    FOR route IN WITH rule AS (SELECT * FROM streetgen._symbols(model, theme, scale) r WHERE r.layer = 'ref'),
        kind AS (SELECT * FROM streetgen._drawn_kinds(model, theme, scale) d WHERE d.layer = 'ref')
        SELECT n.ref, l.geom, ST_Length(l.geom) AS length, size, s.fill, s.line
        FROM streetgen._numbers(model, box) n LEFT JOIN kind k ON k.kind = n.importance::text
            JOIN rule s ON s.kind = coalesce(k.drawn_as, ''), ST_Dump(ST_Intersection(n.geom, box)) l,
            streetgen._drawn_metres(s.width, s.unit, pixel) size
        WHERE ST_Length(l.geom) > 6 * size ORDER BY n.importance, length DESC, n.ref
    LOOP
        number := left(regexp_replace(route.ref, '\s+', ' ', 'g'), 16);
        parts := greatest(1, floor(route.length / again));
        FOR part IN 1 .. parts LOOP
            SELECT ground INTO shield
            FROM unnest('{0,-0.12,0.12,-0.24,0.24,-0.36,0.36}'::float8[]) WITH ORDINALITY o(aside, turn),
                ST_LineInterpolatePoint(route.geom, (part - 0.5 + aside) / parts) middle,
                LATERAL (SELECT ST_Expand(middle, route.size * (max(ends) * 0.55 + 0.4), 0.7 * route.size) AS ground
                    FROM streetgen._letters(number)) g
            WHERE ST_Within(ground, box) AND NOT EXISTS (SELECT FROM unnest(taken || shields) t
                    WHERE ST_DWithin(t, ground, 0.4 * route.size))
                AND NOT EXISTS (SELECT FROM unnest(numbers, shields) w(number, ground) WHERE w.number = route.ref
                    AND ST_DWithin(w.ground, g.ground, again / 2))
            ORDER BY turn LIMIT 1;
            CONTINUE WHEN shield IS NULL;
            numbers := numbers || route.ref;
            shields := shields || shield;
            svg := svg || streetgen._number_as_svg(number, shield, route.size, route.fill, route.line, ST_XMin(box),
                ST_YMax(box));
        END LOOP;
    END LOOP;
    RETURN svg;
END $$;
COMMENT ON FUNCTION streetgen._svg_refs(name, geometry, float8, text, float8, geometry[]) IS
    'The numbers of routes of a drawing as SVG, in metres from its upper left corner: boxes on their roads, none over '
    'another, nor over the ground that is taken, and again along a long road.';
