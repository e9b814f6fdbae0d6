-- DXF of AutoCAD release 12: a drawing of the plan, which every CAD program opens.

CREATE OR REPLACE FUNCTION streetgen._dxf_text(words text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN words ~ '^[ -~]*$' THEN words ELSE (
            SELECT string_agg(CASE WHEN ascii(c) BETWEEN 32 AND 126 THEN c
                WHEN ascii(c) < 32 OR ascii(c) > 65535 THEN ' '
                ELSE '\U+' || lpad(upper(to_hex(ascii(c))), 4, '0') END, '' ORDER BY n)
            FROM regexp_split_to_table(words, '') WITH ORDINALITY t(c, n)) END $$;
COMMENT ON FUNCTION streetgen._dxf_text(text) IS
    'Words as a DXF file of ASCII has them: other letters as \U+ and their number, what is no letter as a space.';

CREATE OR REPLACE FUNCTION streetgen._dxf_colour(colour text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Colours of CAD programs by number, 7 being black or white.
    SELECT coalesce((SELECT number FROM (VALUES (1, 255, 0, 0), (2, 255, 255, 0), (3, 0, 255, 0), (4, 0, 255, 255),
                (5, 0, 0, 255), (6, 255, 0, 255), (8, 128, 128, 128), (9, 192, 192, 192), (30, 255, 127, 0),
                (32, 165, 82, 0), (33, 165, 124, 82), (42, 165, 124, 0), (54, 127, 127, 0), (82, 41, 165, 0),
                (94, 0, 127, 0), (152, 0, 124, 165), (250, 51, 51, 51), (251, 91, 91, 91),
                (253, 173, 173, 173), (254, 214, 214, 214))
                p(number, red, green, blue), decode(substr(colour, 2), 'hex') c WHERE c IS NOT NULL
            ORDER BY (red - get_byte(c, 0)) ^ 2 + (green - get_byte(c, 1)) ^ 2 + (blue - get_byte(c, 2)) ^ 2, number
            LIMIT 1), 7) $$;
COMMENT ON FUNCTION streetgen._dxf_colour(text) IS
    'The number of the colour of AutoCAD that is nearest to one of a rule (#rrggbb); 7 where there is none.';

CREATE OR REPLACE FUNCTION streetgen._dxf_polyline(line geometry, closed boolean, layer text, x float8, y float8,
    digits integer) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT format(E'0\nPOLYLINE\n8\n%1$s\n66\n1\n70\n%2$s\n10\n0\n20\n0\n30\n0\n%3$s0\nSEQEND\n8\n%1$s', layer,
            CASE WHEN closed THEN 1 ELSE 0 END, regexp_replace(places, '(\S+),(\S+) ?',
                E'0\nVERTEX\n8\n' || layer || E'\n10\n\\1\n20\n\\2\n30\n0\n', 'g'))
        FROM (SELECT streetgen._rounded_coordinates(CASE WHEN closed THEN ST_RemovePoint(line, ST_NPoints(line) - 1)
            ELSE line END, x, y, digits) AS places) p WHERE places IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._dxf_polyline(geometry, boolean, text, float8, float8, integer) IS
    'The entity of a LINESTRING, or of a ring that closes, from an origin.';

CREATE OR REPLACE FUNCTION streetgen._dxf_arc(arc geometry, layer text, x float8, y float8, digits integer)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH place AS (SELECT ST_X(a) AS ax, ST_Y(a) AS ay, ST_X(b) - ST_X(a) AS bx, ST_Y(b) - ST_Y(a) AS by,
            ST_X(c) - ST_X(a) AS cx, ST_Y(c) - ST_Y(a) AS cy
        FROM ST_PointN(arc, 1) a, ST_PointN(arc, 2) b, ST_PointN(arc, 3) c),
    circle AS (
        SELECT *, (cy * (bx ^ 2 + by ^ 2) - by * (cx ^ 2 + cy ^ 2)) / (2 * turn) AS mx,
            (bx * (cx ^ 2 + cy ^ 2) - cx * (bx ^ 2 + by ^ 2)) / (2 * turn) AS my
        FROM place, LATERAL (SELECT bx * cy - by * cx AS turn) t WHERE turn <> 0)
    -- An arc of DXF runs counter-clockwise.
    SELECT format(E'0\nARC\n8\n%s\n10\n%s\n20\n%s\n30\n0\n40\n%s\n50\n%s\n51\n%s', layer,
        streetgen._decimal(ax + mx - x, digits), streetgen._decimal(ay + my - y, digits),
        streetgen._decimal(sqrt(mx ^ 2 + my ^ 2), digits), streetgen._decimal(CASE WHEN turn > 0 THEN first ELSE last
            END, 6), streetgen._decimal(CASE WHEN turn > 0 THEN last ELSE first END, 6))
    FROM circle, LATERAL (SELECT degrees(atan2(-my, -mx)) AS first, degrees(atan2(cy - my, cx - mx)) AS last) d $$;
COMMENT ON FUNCTION streetgen._dxf_arc(geometry, text, float8, float8, integer) IS
    'The entity of a CIRCULARSTRING of three points, from an origin; NULL where these lie on a line.';

CREATE OR REPLACE FUNCTION streetgen._dxf_layers(model name)
    RETURNS TABLE(layer text, colour integer)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 40 SET search_path = pg_catalog
    AS $$ SELECT DISTINCT ON (s.layer) s.layer, streetgen._dxf_colour(coalesce(s.fill, s.line))
        FROM streetgen._symbols(model, 'street', 1) s
        WHERE s.layer NOT IN ('paper', 'ground', 'ink', 'ref', 'building') AND s.marker IS DISTINCT FROM 'shadow'
        ORDER BY s.layer, s.kind, s.symbol DESC $$;
COMMENT ON FUNCTION streetgen._dxf_layers(name) IS
    'The layers of theme street that a drawing of DXF has, with their colours, without shadows and what is drawn on '
    'paper alone.';

CREATE OR REPLACE FUNCTION streetgen._dxf_entities(model name, box geometry, options jsonb)
    RETURNS TABLE(turn integer, layer text, id bigint, part bigint, entity text, bounds geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    only_level constant integer := options ->> 'level';
    x constant float8 := options -> 'origin' ->> 0;
    y constant float8 := options -> 'origin' ->> 1;
    digits constant integer := options ->> 'precision';
    layers constant text[] := ARRAY(SELECT l.layer FROM streetgen._dxf_layers(model) l) || '{axis}'::text[];
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH shape AS (
        SELECT h.layer, h.kind, h.id, d.geom, d.path
        FROM streetgen._shapes(model, box, layers) h, ST_Dump(h.geom) d
        WHERE (only_level IS NULL OR h.level = only_level OR h.level IS NULL) AND ST_Intersects(h.geom, box)),
    ring AS (
        SELECT layer, kind, id, s.path || r.path AS path, ST_ExteriorRing(r.geom) AS line, true AS closed
        FROM shape s, ST_DumpRings(s.geom) r WHERE GeometryType(s.geom) = 'POLYGON'
        UNION ALL SELECT layer, kind, id, path, geom, false FROM shape WHERE GeometryType(geom) = 'LINESTRING'
        UNION ALL SELECT layer, kind, id, path, ST_CurveToLine(geom), false FROM shape
        WHERE GeometryType(geom) IN ('CIRCULARSTRING', 'COMPOUNDCURVE'))
    SELECT 1, layer, id, row_number() OVER (ORDER BY layer, id, kind, path, ST_AsBinary(line)),
        streetgen._dxf_polyline(ST_Force2D(line), closed, layer, x, y, digits), ST_Envelope(line) FROM ring
    UNION ALL SELECT 2, 'corner', corner_id, 1, streetgen._dxf_arc(arc, 'corner', x, y, digits), ST_Envelope(arc)
    FROM corner
    WHERE arc && box AND ST_Intersects(arc, box)
        AND (only_level IS NULL OR edge_a IN (SELECT edge_id FROM edge WHERE level = only_level))
    -- A street has its name once, at the middle of its longest edge, to be read from below or from the right.
    UNION ALL SELECT 3, 'name', edge_id, 1, format(E'0\nTEXT\n8\nname\n10\n%1$s\n20\n%2$s\n30\n0\n40\n2'
            '\n1\n%3$s\n50\n%4$s\n72\n1\n73\n2\n11\n%1$s\n21\n%2$s\n31\n0', streetgen._decimal(ST_X(place) - x, digits),
        streetgen._decimal(ST_Y(place) - y, digits), streetgen._dxf_text(name),
        streetgen._decimal(CASE WHEN along > 90 AND along <= 270 THEN along - 180 ELSE along END, 3)), NULL
    FROM (SELECT DISTINCT ON (a.name) e.edge_id, a.name, e.geom
            FROM edge e JOIN axis a USING (axis_id) WHERE a.name <> '' AND e.geom && box AND ST_Intersects(e.geom, box)
                AND (only_level IS NULL OR e.level = only_level)
            ORDER BY a.name, ST_Length(e.geom) DESC, e.edge_id) n,
        ST_LineInterpolatePoint(geom, 0.5) place, LATERAL (SELECT degrees(pi() / 2 - ST_Azimuth(
            ST_LineInterpolatePoint(geom, 0.49), ST_LineInterpolatePoint(geom, 0.51)))::numeric AS turned) z,
        LATERAL (SELECT ((turned % 360 + 360) % 360)::float8 AS along) w;
END $$;
COMMENT ON FUNCTION streetgen._dxf_entities(name, geometry, jsonb) IS
    'The entities of a drawing of what meets a box: lines and rings, arcs of corners, names, with the bounds of each.';

CREATE OR REPLACE FUNCTION streetgen.export_dxf(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'dxf', 'surface', options);
    model_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    -- A drawing without an extent takes all that has a coordinate, also what lies far from the axes.
    box constant geometry := coalesce(ST_MakeEnvelope((known -> 'extent' ->> 0)::float8,
        (known -> 'extent' ->> 1)::float8, (known -> 'extent' ->> 2)::float8, (known -> 'extent' ->> 3)::float8,
        model_srid), ST_MakeEnvelope(-1e12, -1e12, 1e12, 1e12, model_srid));
BEGIN
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, known)),
    entity AS MATERIALIZED (
        SELECT e.* FROM origin o, streetgen._dxf_entities(model, box,
            known || jsonb_build_object('origin', jsonb_build_array(o.x, o.y))) e
        WHERE e.entity IS NOT NULL),
    layer AS (
        SELECT u.layer, coalesce(l.colour, 7) AS colour FROM (SELECT DISTINCT e.layer FROM entity e) u
            LEFT JOIN streetgen._dxf_layers(model) l USING (layer)),
    line AS (
        SELECT 0 AS turn, '' AS layer, 0::bigint AS id, 0::bigint AS part, format(
            E'999\nStreetGen %s, model %s, SRID %s\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$EXTMIN\n10\n%s'
            '\n20\n%s\n9\n$EXTMAX\n10\n%s\n20\n%s\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n%s',
            streetgen.version(), streetgen._dxf_text(model), model_srid,
            streetgen._decimal(ST_XMin(drawn) - o.x, o.digits), streetgen._decimal(ST_YMin(drawn) - o.y, o.digits),
            streetgen._decimal(ST_XMax(drawn) - o.x, o.digits), streetgen._decimal(ST_YMax(drawn) - o.y, o.digits),
            (SELECT count(*) FROM layer)) AS text
        FROM origin o, (SELECT ST_Extent(e.bounds) AS drawn FROM entity e) b
        UNION ALL SELECT 0, l.layer, 1, 0, format(E'0\nLAYER\n2\n%s\n70\n0\n62\n%s\n6\nCONTINUOUS', l.layer, l.colour)
        FROM layer l
        UNION ALL SELECT 0, '~', 2, 0, E'0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES'
        UNION ALL SELECT e.turn, e.layer, e.id, e.part, e.entity FROM entity e
        UNION ALL SELECT 9, '', 0, 0, E'0\nENDSEC\n0\nEOF')
    SELECT row_number() OVER (ORDER BY l.turn, l.layer COLLATE "C", l.id, l.part), l.text FROM line l
    ORDER BY l.turn, l.layer COLLATE "C", l.id, l.part;
END $$;
COMMENT ON FUNCTION streetgen.export_dxf(name, jsonb) IS
    'A drawing in DXF of AutoCAD release 12, line by line, for CAD programs: the plan in metres, in the SRID of the '
    'model, which the first comment names. A layer is one of theme street, in a colour near to its own, or axis, '
    'corner or name. Surfaces are closed polylines, each ring by itself; corners are arcs of their radius (ARC); a '
    'street has its name once, 2 m high. options as streetgen.export_option() lists them; an extent takes what meets '
    'it. An unknown one, or no edge that they take: 22023. A caller who may not read the model: 42501. What is stale '
    'is written as it was, with a warning.';
