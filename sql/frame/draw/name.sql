-- Names are written along their streets.

CREATE OR REPLACE FUNCTION streetgen._letter_width(letter text) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN letter ~ '[iljIJ''’.,:;|!]' THEN 0.3 WHEN letter ~ '[frt() -]' THEN 0.38
        WHEN letter ~ '[mwMW]' THEN 0.92 WHEN letter ~ '[[:upper:]]' THEN 0.71 ELSE 0.61 END $$;
COMMENT ON FUNCTION streetgen._letter_width(text) IS
    'How far a letter of a usual sans-serif font goes, in heights of the font.';

CREATE OR REPLACE FUNCTION streetgen._letters(words text)
    RETURNS TABLE(ordinality bigint, letter text, starts float8, ends float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ SELECT n, letter, sum(wide) OVER (ORDER BY n) - wide, sum(wide) OVER (ORDER BY n)
        FROM string_to_table(words, NULL) WITH ORDINALITY l(letter, n), streetgen._letter_width(letter) wide $$;
COMMENT ON FUNCTION streetgen._letters(text) IS
    'The letters of a text, and where each starts and ends, in heights of the font.';

CREATE OR REPLACE FUNCTION streetgen._short_name(name text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT coalesce((SELECT regexp_replace(name, long, short) FROM (VALUES ('^Rue\M', 'R.'), ('^Avenue\M', 'Av.'),
            ('^Boulevard\M', 'Bd'), ('^Place\M', 'Pl.'), ('^Impasse\M', 'Imp.'), ('^Passage\M', 'Pass.'),
            ('^Allée\M', 'All.'), ('^Chemin\M', 'Ch.'), ('^Rua\M', 'R.'), ('^Avenida\M', 'Av.'), ('^Calle\M', 'C.'),
            ('^Via\M', 'V.'), ('(?<=.)straße$', 'str.'), ('\mStraße$', 'Str.'), ('(?<=.)platz$', 'pl.'),
            ('\mStreet$', 'St'), ('\mAvenue$', 'Ave'), ('\mRoad$', 'Rd'), ('\mLane$', 'Ln'), ('\mDrive$', 'Dr'),
            ('\mCourt$', 'Ct'), ('\mHighway$', 'Hwy'), ('\mSquare$', 'Sq')) w(long, short)
        WHERE name ~ long LIMIT 1), name) $$;
COMMENT ON FUNCTION streetgen._short_name(text) IS
    'The name of a street as maps shorten it: by the word for street that it begins or ends with.';

CREATE OR REPLACE FUNCTION streetgen._names(model name, box geometry)
    RETURNS TABLE(name text, importance integer, geom geometry, apart float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms_of(model), '_%s_named', 'name, geometry')
    LOOP
        RETURN QUERY EXECUTE part USING model, box;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._names(name, geometry) IS
    'The names that can be written in a box of a model, from functions _ROOM_named (model, box): the line along which '
    'one stands, how important it is, 1 the most, and within how many metres it is not written again.';

CREATE OR REPLACE FUNCTION streetgen._kept_clear(model name, box geometry) RETURNS SETOF geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part text;
BEGIN
    FOR part IN SELECT * FROM streetgen._queries_of_rooms(streetgen._rooms_of(model), '_%s_kept_clear',
        'name, geometry')
    LOOP
        RETURN QUERY EXECUTE part USING model, box;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._kept_clear(name, geometry) IS
    'What names leave clear in a box of a model where another place is free, from functions _ROOM_kept_clear (model, '
    'box).';

CREATE OR REPLACE FUNCTION streetgen._name_along(line geometry, middle float8, long float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_X(ST_EndPoint(piece)) < ST_X(ST_StartPoint(piece)) THEN ST_Reverse(piece) ELSE piece END
    FROM (SELECT ST_LineSubstring(line, greatest(0, (middle - long / 2) / length), least(1, (middle + long / 2)
            / length)) AS piece FROM (SELECT ST_Length(line) AS length) l) p
    -- Text round a sharp bend is not read, nor a letter that turns by more than 60 degrees.
    WHERE GeometryType(piece) = 'LINESTRING'
        AND ST_Length(piece) < 1.08 * ST_Distance(ST_StartPoint(piece), ST_EndPoint(piece))
        AND NOT EXISTS (SELECT FROM ST_DumpSegments(ST_AddPoint(ST_LineFromMultiPoint(ST_LineInterpolatePoints(piece,
                0.04)), ST_StartPoint(piece), 0)) part
            WHERE cos(ST_Azimuth(ST_StartPoint(piece), ST_EndPoint(piece))
                - ST_Azimuth(ST_StartPoint(part.geom), ST_EndPoint(part.geom))) < 0.5) $$;
COMMENT ON FUNCTION streetgen._name_along(geometry, float8, float8) IS
    'The piece of a line on which a text stands upright, about an abscissa and so long, in metres; NULL where the line '
    'bends too much.';

CREATE OR REPLACE FUNCTION streetgen._letters_as_svg(words text, piece geometry, size float8, x float8, y float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- Letters that join each other, or stand from right to left, are left to the font.
    WITH part AS (SELECT * FROM streetgen._letters(words) WHERE words ~ '^[\u0020-\u024f\u0370-\u0527\u2010-\u201d]*$'
            UNION ALL SELECT 1, words, 0, max(ends) FROM streetgen._letters(words)
                WHERE words !~ '^[\u0020-\u024f\u0370-\u0527\u2010-\u201d]*$' HAVING count(*) > 0),
    placed AS (SELECT ordinality, letter, ST_LineInterpolatePoint(piece, least(1, starts / whole)) AS a,
            ST_LineInterpolatePoint(piece, least(1, ends / whole)) AS b
        FROM part, (SELECT max(ends) AS whole FROM part) w WHERE letter <> ' ')
    SELECT string_agg(format('<text transform="translate(%s %s)rotate(%s)">%s</text>',
            round((ST_X(a) + 0.36 * size * sin(turn) - x)::numeric, 2),
            round((y - ST_Y(a) + 0.36 * size * cos(turn))::numeric, 2), round(-degrees(turn)::numeric, 1),
            streetgen._as_xml(letter)), '' ORDER BY ordinality)
    FROM placed, LATERAL (SELECT atan2(ST_Y(b) - ST_Y(a), ST_X(b) - ST_X(a)) AS turn) t $$;
COMMENT ON FUNCTION streetgen._letters_as_svg(text, geometry, float8, float8, float8) IS
    'A text along a line, letter by letter, as SVG, its middle on the line; size: of the font, metres; x and y are '
    'those of the upper left corner of the picture.';

CREATE OR REPLACE FUNCTION streetgen._svg_names(model name, box geometry, pixel float8, theme text, scale float8,
    OUT svg text, OUT taken geometry[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- The name of a long street stands again after so many pixels, and nowhere within a part of that.
    again constant float8 := 450 * pixel;
    named record;
    words text;
    long float8;
    parts integer;
    piece geometry;
    clear constant geometry[] := ARRAY(SELECT streetgen._kept_clear(model, box));
    reach geometry;
    beside geometry[];
    around geometry[];
    same geometry[];
    written text[] := '{}';
    middles geometry[] := '{}';
BEGIN
    svg := '';
    taken := '{}';
    FOR named IN WITH rule AS (SELECT * FROM streetgen._symbols(model, theme, scale) r WHERE r.layer = 'name'),
        kind AS (SELECT * FROM streetgen._drawn_kinds(model, theme, scale) d WHERE d.layer = 'name')
        SELECT n.name, l.geom, ST_Length(l.geom) AS length, greatest(n.apart, 0.6 * again) AS apart, size,
            format('%s;paint-order:stroke;stroke-linejoin:round;font:%spx DejaVu Sans,sans-serif',
                streetgen._as_css(s.fill, s.line, size / 4, 'metre', NULL, pixel), round(size::numeric, 4)) AS style
        FROM streetgen._names(model, box) n LEFT JOIN kind k ON k.kind = n.importance::text
            JOIN rule s ON s.kind = coalesce(k.drawn_as, ''), ST_Dump(ST_Intersection(n.geom, box)) l,
            streetgen._drawn_metres(s.width, s.unit, pixel) size
        WHERE ST_Length(l.geom) > 3 * size ORDER BY n.importance, length DESC, n.name
    LOOP
        words := left(btrim(regexp_replace(named.name, '\s+', ' ', 'g')), 200);
        long := (SELECT max(ends) FROM streetgen._letters(words)) * named.size;
        IF long + named.size > named.length THEN
            words := streetgen._short_name(words);
            long := (SELECT max(ends) FROM streetgen._letters(words)) * named.size;
        END IF;
        CONTINUE WHEN long > named.length;
        parts := greatest(1, floor(named.length / greatest(again, named.apart)));
        reach := ST_Expand(named.geom, 0.6 * named.size);
        beside := ARRAY(SELECT c FROM unnest(clear) c WHERE c && reach
            AND ST_DWithin(c, named.geom, 0.6 * named.size));
        FOR part IN 1 .. parts LOOP
            around := ARRAY(SELECT t FROM unnest(taken) t WHERE t && reach);
            same := ARRAY(SELECT w.middle FROM unnest(written, middles) w(name, middle) WHERE w.name = named.name);
            SELECT along INTO piece
            FROM unnest('{0,-0.12,0.12,-0.24,0.24,-0.36,0.36,-0.48,0.48}'::float8[]) WITH ORDINALITY o(aside, turn),
                streetgen._name_along(named.geom, greatest(long / 2, least(named.length - long / 2, named.length
                    / parts * (part - 0.5 + aside))), long) along
            WHERE along IS NOT NULL AND NOT EXISTS (SELECT FROM unnest(around) t
                    WHERE ST_DWithin(t, along, 0.6 * named.size))
                AND NOT EXISTS (SELECT FROM unnest(same) s
                    WHERE ST_DWithin(s, ST_LineInterpolatePoint(along, 0.5), named.apart))
            ORDER BY EXISTS (SELECT FROM unnest(beside) c WHERE ST_DWithin(c, along, 0.6 * named.size)), turn LIMIT 1;
            CONTINUE WHEN piece IS NULL;
            taken := taken || ST_Buffer(piece, 0.55 * named.size, 'endcap=square');
            written := written || named.name;
            middles := middles || ST_LineInterpolatePoint(piece, 0.5);
            svg := svg || format(E'<g class="name" style="%s">%s</g>\n', named.style, streetgen._letters_as_svg(words,
                piece, named.size, ST_XMin(box), ST_YMax(box)));
        END LOOP;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._svg_names(name, geometry, float8, text, float8) IS
    'The names of a drawing as SVG, in metres from its upper left corner: important and long streets first, each name '
    'along its street, upright, shortened where it would not fit, none over another, and once for both carriageways; '
    'taken: the ground that they stand on.';
