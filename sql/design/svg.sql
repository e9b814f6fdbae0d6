-- Pictures of a design: hill shade, zones and what each stage made; and profiles of links.

CREATE OR REPLACE FUNCTION streetgen._svg_hill_shade(model name, extent geometry, pixel float8) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- A cell is four pixels: finer shade costs more than it shows. Cells of one grey are one path.
    SELECT string_agg(format('<path fill-opacity="%s" d="%s"/>', round(1 - grey / 255.0, 2), cells), E'\n')
    FROM (SELECT grey, string_agg(format('M%s %sh4v4h-4z', 4 * i, 4 * j), '' ORDER BY j, i) AS cells
        FROM streetgen._shaded_cells(model, extent, 4 * pixel) GROUP BY grey) g $$;
COMMENT ON FUNCTION streetgen._svg_hill_shade(name, geometry, float8) IS
    'The hill shade of the terrain in an extent, as SVG in pixels of so many metres: what lies in the dark is the less '
    'transparent.';

CREATE OR REPLACE FUNCTION streetgen._design_drawing()
    RETURNS TABLE(place integer, first_stage integer, symbol text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 2, 'zone bridge', $q$SELECT geom FROM %1$I.zone JOIN %1$I.zone_class USING (class)
        WHERE passage = 'bridge' AND NOT zone.rejected$q$),
    (2, 2, 'zone free', $q$SELECT geom FROM %1$I.zone JOIN %1$I.zone_class USING (class)
        WHERE passage = 'free' AND NOT zone.rejected$q$),
    (3, 2, 'zone forbidden', $q$SELECT geom FROM %1$I.zone JOIN %1$I.zone_class USING (class)
        WHERE passage = 'forbidden' AND NOT zone.rejected$q$),
    (4, 4, 'design_link', $q$
        SELECT ST_MakeLine(a.geom, b.geom) FROM %1$I.design_link l JOIN %1$I.design_node a ON a.design_node_id = node_a
        JOIN %1$I.design_node b ON b.design_node_id = node_b WHERE NOT l.rejected$q$),
    (5, 5, 'straight_alignment', $q$
        SELECT ST_MakeLine(p.geom ORDER BY p.ordinality) FROM %1$I.design_link l,
        LATERAL streetgen._link_places(%2$L, l.design_link_id, false) p WHERE NOT l.rejected
            AND coalesce(method, '') NOT LIKE 'no_path%%' GROUP BY l.design_link_id$q$),
    (6, 6, 'design_alignment', $q$
        SELECT ST_Force2D(geom) FROM %1$I.design_link WHERE NOT rejected$q$),
    (7, 8, 'structure', $q$
        SELECT ST_Force2D(geom) FROM %1$I.structure WHERE NOT rejected$q$),
    (8, 9, 'design_axis', $q$
        SELECT ST_Force2D(geom) FROM %1$I.axis WHERE source = 'design'$q$) $$;
COMMENT ON FUNCTION streetgen._design_drawing() IS
    'What a picture of a design shows from which stage on (place of _design_stage): layer and kind of its '
    'rule, and query over model %1$I (%2$L).';

CREATE OR REPLACE FUNCTION streetgen.design_svg(model name, stage text DEFAULT 'axes', extent geometry DEFAULT NULL,
    width integer DEFAULT 1000) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    at_stage constant integer := (SELECT s.place FROM streetgen._design_stage() s WHERE s.stage = design_svg.stage);
    shown geometry := extent;
    pixel float8;
    styles jsonb;
    layer record;
    drawn text;
    svg text;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._require_design(model),
        streetgen._check_given('stage', stage, 'width', width::text);
    IF at_stage IS NULL OR width NOT BETWEEN 100 AND 4000 THEN
        RAISE EXCEPTION 'there is no picture of stage "%" of % pixels', stage, width USING ERRCODE = '22023',
            HINT = 'streetgen.design names the stages; a picture is 100 to 4000 pixels wide.';
    END IF;
    IF shown IS NULL THEN
        SELECT ST_SetSRID(ST_Extent(geom)::geometry, 0) FROM terrain_tile INTO shown;
    END IF;
    IF shown IS NULL THEN
        RAISE EXCEPTION 'model "%" has no terrain to draw', model USING ERRCODE = '22023',
            HINT = 'data/streetgen terrain FILE MODEL loads heights.';
    END IF;
    shown := streetgen._in_model(model, ST_Envelope(shown), 'the extent');
    pixel := (ST_XMax(shown) - ST_XMin(shown)) / width;
    IF pixel = 0 THEN
        RAISE EXCEPTION 'the extent has no width' USING ERRCODE = '22023', HINT = 'A POLYGON says what to draw.';
    END IF;
    styles := streetgen._plan_styles(model, pixel / streetgen._pixel_on_paper());
    svg := format(E'<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s">\n<rect width="100%%" '
        'height="100%%" style="%s"/>\n<g style="%s">%s</g>', width, ceil((ST_YMax(shown) - ST_YMin(shown)) / pixel),
        styles ->> 'paper', styles ->> 'hill_shade', streetgen._svg_hill_shade(model, shown, pixel));
    FOR layer IN SELECT * FROM streetgen._design_drawing() d WHERE d.first_stage <= at_stage ORDER BY d.place LOOP
        EXECUTE format($q$SELECT string_agg(ST_AsSVG(ST_Scale(ST_Translate(g.geom, -ST_XMin($1), -ST_YMax($1)),
            1 / $2, 1 / $2), 0, 1), ' ') FROM (%s) g(geom) WHERE g.geom && $1 $q$, format(layer.query, model, model))
            INTO drawn USING shown, pixel;
        svg := svg || coalesce(format(E'\n<path style="%s" d="%s"/>', styles ->> layer.symbol, drawn), '');
    END LOOP;
    IF at_stage >= 3 THEN
        SELECT string_agg(format('<circle cx="%s" cy="%s" r="%s" style="%s"/>%s',
            round(((ST_X(geom) - ST_XMin(shown)) / pixel)::numeric, 1), round(((ST_YMax(shown) - ST_Y(geom)) /
                pixel)::numeric, 1),
            CASE kind WHEN 'city' THEN 7 WHEN 'town' THEN 5 ELSE 3.5 END,
            styles ->> CASE kind WHEN 'interchange' THEN 'design_node interchange' ELSE 'design_node' END,
            coalesce(format('<text x="%s" y="%s" font-family="sans-serif" font-size="15" '
                'style="%s;paint-order:stroke">%s</text>',
                round(((ST_X(geom) - ST_XMin(shown)) / pixel)::numeric + 9, 1),
                round(((ST_YMax(shown) - ST_Y(geom)) / pixel)::numeric - 7, 1),
                styles ->> 'design_name', streetgen._as_xml(name)), '')), '')
            FROM design_node WHERE NOT rejected AND geom && shown INTO drawn;
        svg := svg || E'\n' || coalesce(drawn, '');
    END IF;
    RETURN svg || E'\n</svg>\n';
END $$;
COMMENT ON FUNCTION streetgen.design_svg(name, text, geometry, integer) IS
    'A picture of a design (SVG) after a stage: hill shade, zones (blue: to be bridged, green: free, brown: '
    'forbidden), nodes, links (dashed), straight alignments (black), alignments (blue), structures (red), axes '
    '(orange). extent: what is shown, NULL: the terrain. width: pixels, 100 to 4000. An unknown stage, no terrain, '
    'an extent without width: 22023; NULL for stage or width: 22004; a model without a design: 55000.';

CREATE OR REPLACE FUNCTION streetgen.profile_svg(model name, link bigint, width integer DEFAULT 1000) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    road geometry;
    tall constant integer := 260;
    styles jsonb;
    svg text;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._require_design(model);
    SELECT geom FROM design_link WHERE design_link_id = link INTO road;
    IF road IS NULL THEN
        RAISE EXCEPTION 'link % of the design has no road', link USING ERRCODE = '22023',
            HINT = format('SELECT * FROM streetgen.design(%L) computes it.', model);
    END IF;
    styles := streetgen._plan_styles(model, ST_Length(road) / width / streetgen._pixel_on_paper());
    WITH ground AS (SELECT * FROM streetgen.terrain_profile(model, road, ST_Length(road) / 400)
        WHERE height IS NOT NULL),
    road AS (SELECT ST_Length(road) * k / 400.0 AS abscissa, ST_Z(ST_LineInterpolatePoint(road, k / 400.0)) AS height
        FROM generate_series(0, 400) k),
    bound AS (SELECT min(height) AS low, max(height) AS high FROM (SELECT height FROM ground UNION ALL SELECT height
        FROM road) h),
    line AS (SELECT what, string_agg(round((abscissa / ST_Length(road) * width)::numeric, 1) || ',' || round((tall - 20
        - (height - low) / greatest(high - low, 10) * (tall - 40))::numeric, 1), ' ' ORDER BY abscissa) AS points
        FROM (SELECT 'ground' AS what, * FROM (SELECT abscissa, height FROM ground) g
            UNION ALL SELECT 'road', * FROM road) l, bound GROUP BY what)
    SELECT format('<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s" font-family="sans-serif" '
        'font-size="13"><rect width="100%%" height="100%%" style="%s"/>', width, tall, styles ->> 'paper')
        || (SELECT format('<polygon style="%s" points="0,%s %s %s,%s"/>', styles ->> 'profile ground', tall, points,
            width, tall) FROM line
            WHERE what = 'ground')
        || coalesce((SELECT string_agg(format('<rect x="%s" y="0" width="%s" height="%s" style="%s"/>',
            round((start_abscissa / ST_Length(road) * width)::numeric, 1),
            round(((end_abscissa - start_abscissa) / ST_Length(road) * width)::numeric, 1), tall,
            styles ->> concat('profile ', kind)), '') FROM structure WHERE design_link_id = link
            AND NOT rejected), '')
        || (SELECT format('<polyline style="%s" points="%s"/>', styles ->> 'profile road', points) FROM line
            WHERE what = 'road')
        || (SELECT format('<text x="6" y="16" style="%s">%s to %s m high, %s km</text></svg>', styles ->> 'ink',
            round(low::numeric),
            round(high::numeric), round((ST_Length(road) / 1000)::numeric, 1)) FROM bound) INTO svg;
    RETURN svg;
END $$;
COMMENT ON FUNCTION streetgen.profile_svg(name, bigint, integer) IS
    'The profile of a link of a design (SVG): ground (brown), road (blue), bridges (red) and tunnels (dark). width: '
    'pixels. A link without a road: 22023; a model without a design: 55000. NULL for NULL.';
