-- The plan of a controller as a picture: its phases, bars over time, and the times between greens.

CREATE OR REPLACE FUNCTION streetgen._wind(angle float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN ('{N,NE,E,SE,S,SW,W,NW}'::text[])[1 + (round(angle / 45)::integer % 8 + 8) % 8];
COMMENT ON FUNCTION streetgen._wind(float8) IS 'The wind of degrees clockwise from the north.';

CREATE OR REPLACE FUNCTION streetgen._signal_group_names(model name, controller bigint)
    RETURNS TABLE(signal_group integer, symbol text, says text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT g.signal_group, CASE g.kind WHEN 'walk' THEN 'F' ELSE 'K' END
            || row_number() OVER (PARTITION BY g.kind ORDER BY g.signal_group),
        CASE g.kind WHEN 'walk' THEN concat_ws(', ', concat_ws(' ', a.name, streetgen._wind(degrees(ST_Azimuth(c.geom,
                p.geom)))), 'on foot')
            ELSE concat_ws(', ', concat_ws(' ', a.name, 'from', streetgen._wind(h.angle + 180)), t.turns) END
    FROM signal_group g JOIN controller c USING (controller_id) JOIN edge e USING (edge_id)
        LEFT JOIN axis a USING (axis_id) LEFT JOIN control_point p USING (control_point_id)
        CROSS JOIN LATERAL (SELECT replace(array_to_string(ARRAY(SELECT turn FROM unnest('{left,through,right,u_turn}'
                ::text[]) WITH ORDINALITY u(turn, k) WHERE turn = ANY (array_agg(w.turn)) ORDER BY k), '/'), '_', ' ')
                AS turns, min(m.lane_in) AS lane
            FROM signal_movement m JOIN movement w USING (lane_in, lane_out, along_in, along_out)
            WHERE (m.controller_id, m.signal_group) = (g.controller_id, g.signal_group)) t
        LEFT JOIN LATERAL (SELECT angle FROM signal_head s WHERE s.controller_id = g.controller_id
            AND s.lane_id = t.lane LIMIT 1) h ON true
    WHERE g.controller_id = controller;
END $$;
COMMENT ON FUNCTION streetgen._signal_group_names(name, bigint) IS
    'What a plan calls the signal groups of a controller: K and a number for traffic, F for people on foot; the '
    'street, the wind that they come from or lie towards, and the turns.';

CREATE OR REPLACE FUNCTION streetgen._plan_bars(model name, controller bigint, styles jsonb, top integer, OUT svg text,
    OUT height integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH line AS MATERIALIZED (SELECT n.*, top + 8 + 20 * row_number() OVER (ORDER BY signal_group) AS y
        FROM streetgen._signal_group_names(model, controller) n),
    whole AS (SELECT greatest(cycle, 1) AS cycle FROM controller c WHERE c.controller_id = controller),
    state AS (SELECT s.ordinality, s.kind, s.duration, sum(s.duration) OVER (ORDER BY s.ordinality) AS ends,
            max(s.ordinality) FILTER (WHERE s.kind = 'green') OVER (ORDER BY s.ordinality) AS green
        FROM signal_state s WHERE s.controller_id = controller),
    shown AS (SELECT g.signal_group, g.ordinality, g.green_from, g.green_until, w.clear_until, CASE
                WHEN w.controller_id IS NOT NULL THEN 'walk' WHEN EXISTS (SELECT FROM signal_movement m
                WHERE (m.controller_id, m.signal_group, m.ordinality, m.right_of_way) = (g.controller_id,
                    g.signal_group, g.ordinality, 'protected')) THEN 'protected' ELSE 'permitted' END AS aspect
        FROM signal_green g JOIN signal_group k USING (controller_id, signal_group)
            LEFT JOIN signal_crossing w ON (w.controller_id, w.ordinality, w.control_point_id, w.edge_id)
                = (g.controller_id, g.ordinality, k.control_point_id, k.edge_id)
        WHERE g.controller_id = controller),
    bar AS (
        SELECT signal_group, aspect, green_from AS starts, green_until AS ends FROM shown
        UNION ALL SELECT signal_group, 'clear', green_until, clear_until FROM shown WHERE aspect = 'walk'
        UNION ALL SELECT signal_group, 'amber', s.ends - s.duration, s.ends FROM shown h
            JOIN state s ON s.green = h.ordinality AND s.kind = 'amber' WHERE aspect <> 'walk'),
    -- A green that goes on in the next cycle is drawn at its start.
    drawn AS (
        SELECT signal_group, aspect, greatest(starts - turn * cycle, 0) AS starts, least(ends - turn * cycle, cycle)
            AS ends, cycle FROM bar, whole, generate_series(-1, 1) turn
        WHERE ends - turn * cycle > 0 AND starts - turn * cycle < cycle)
    SELECT (SELECT string_agg(format('<path d="M%1$s %2$sv%3$s" style="%4$s"/><text x="%1$s" '
                'y="%5$s" text-anchor="middle" font-size="10">%6$s</text>', round((300 + 580 * t / cycle)::numeric, 1),
                top + 14, 20 * (SELECT count(*) FROM line) + 8, styles ->> 'signal_plan grid', top + 10, t), ''
                ORDER BY t)
            FROM whole, generate_series(0, floor(cycle)::integer, CASE WHEN cycle > 60 THEN 10 ELSE 5 END) t)
        || string_agg(format('<text x="10" y="%1$s" font-weight="bold">%2$s</text><text x="42" y="%1$s">%3$s'
            '</text><rect x="300" y="%4$s" width="580" height="2" style="%5$s"/>', y + 11, symbol,
            streetgen._as_xml(left(says, 42)), y + 6, styles ->> 'signal_plan red'), '' ORDER BY y)
        || coalesce((SELECT string_agg(format('<rect x="%s" y="%s" width="%s" height="12" style="%s"/>',
                round((300 + 580 * starts / cycle)::numeric, 1), y + 1,
                round((580 * (ends - starts) / cycle)::numeric, 1), styles ->> concat('signal_plan ', aspect))
                || CASE WHEN aspect NOT IN ('amber', 'clear') AND (ends - starts) / cycle > 0.06 THEN format(
                    '<text x="%1$s" y="%2$s" font-size="10">%3$s</text><text x="%4$s" y="%2$s" font-size="10" '
                    'text-anchor="end">%5$s</text>', round((303 + 580 * starts / cycle)::numeric, 1), y + 11,
                    starts, round((297 + 580 * ends / cycle)::numeric, 1), ends)
                    ELSE '' END, '' ORDER BY y, aspect <> 'clear',
                    starts) FROM drawn JOIN line USING (signal_group)), ''),
        34 + 20 * count(*) INTO svg, height
    FROM line;
END $$;
COMMENT ON FUNCTION streetgen._plan_bars(name, bigint, jsonb, integer) IS
    'The bars over time of the signal groups of a controller, in SVG below a height of the picture.';

CREATE OR REPLACE FUNCTION streetgen._plan_intergreens(model name, controller bigint, styles jsonb, top integer,
    OUT svg text, OUT height integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH line AS MATERIALIZED (SELECT n.*, row_number() OVER (ORDER BY signal_group) AS place
        FROM streetgen._signal_group_names(model, controller) n)
    SELECT format('<text x="10" y="%s" font-weight="bold">Time between greens, s: rows end, columns begin</text>',
            top + 14)
        || string_agg(format('<text x="10" y="%1$s">%2$s</text><text x="%3$s" y="%4$s" text-anchor="middle">%2$s'
            '</text>',
            top + 34 + 18 * place, symbol, 32 + 28 * place, top + 34), '' ORDER BY place)
        || (SELECT string_agg(format('<rect x="%s" y="%s" width="28" height="18" style="%s"/>', 18 + 28 * b.place,
                top + 21 + 18 * e.place, styles ->> CASE WHEN e.place = b.place THEN 'signal_plan same'
                ELSE 'signal_plan grid' END) || coalesce(format(
                '<text x="%s" y="%s" text-anchor="middle">%s</text>', 32 + 28 * b.place, top + 34 + 18 * e.place,
                i.seconds), ''), '' ORDER BY e.place, b.place)
            FROM line e CROSS JOIN line b LEFT JOIN intergreen i ON i.controller_id = controller
                AND (i.ends, i.begins) = (e.signal_group, b.signal_group)),
        50 + 18 * count(*) INTO svg, height
    FROM line;
END $$;
COMMENT ON FUNCTION streetgen._plan_intergreens(name, bigint, jsonb, integer) IS
    'The matrix of times between greens of a controller, in SVG below a height of the picture.';

CREATE OR REPLACE FUNCTION streetgen._plan_phases(model name, controller bigint, styles jsonb, top integer,
    OUT svg text, OUT height integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH place AS MATERIALIZED (
        SELECT s.ordinality, s.kind, s.duration, row_number() OVER (ORDER BY s.ordinality) - 1 AS turn
        FROM signal_state s WHERE s.controller_id = controller AND s.kind IN ('green', 'walk')),
    way AS MATERIALIZED (SELECT w.lane_in, w.lane_out, w.along_in, w.along_out, ST_Force2D(w.geom) AS geom
        FROM movement w WHERE w.junction_id = controller AND w.connecting),
    -- A crossing leads square over its street.
    walk AS MATERIALIZED (
        SELECT g.control_point_id, g.edge_id, ST_MakeLine(ST_Translate(p.geom, -half * cos(a), half * sin(a)),
            ST_Translate(p.geom, half * cos(a), -half * sin(a))) AS geom
        FROM signal_group g JOIN control_point p USING (control_point_id) JOIN edge e USING (edge_id),
            LATERAL (SELECT e.width / 2 AS half, ST_LineLocatePoint(e.geom, p.geom) AS t) f,
            LATERAL (SELECT ST_Azimuth(ST_LineInterpolatePoint(e.geom, greatest(0, t - 0.01)),
                ST_LineInterpolatePoint(e.geom, least(1, t + 0.01))) AS a) z
        WHERE g.controller_id = controller AND g.kind = 'walk'),
    box AS (SELECT ST_XMin(b) AS x, ST_YMax(b) AS y, 120 / greatest(ST_XMax(b) - ST_XMin(b), ST_YMax(b) - ST_YMin(b),
            1) AS scale
        FROM (SELECT ST_Extent(geom) AS b FROM (SELECT geom FROM way UNION ALL SELECT geom FROM walk) g) e),
    drawn AS (
        SELECT p.turn, 1 AS layer, 'grid' AS aspect, w.geom FROM place p, way w
        UNION ALL SELECT p.turn, 2, m.right_of_way, w.geom FROM place p JOIN signal_movement m
                ON (m.controller_id, m.ordinality) = (controller, p.ordinality)
            JOIN way w USING (lane_in, lane_out, along_in, along_out)
        UNION ALL SELECT p.turn, 3, CASE WHEN c.controller_id IS NULL THEN 'grid' ELSE 'walk' END, w.geom
        FROM place p CROSS JOIN walk w LEFT JOIN signal_crossing c ON (c.controller_id, c.ordinality,
            c.control_point_id, c.edge_id) = (controller, p.ordinality, w.control_point_id, w.edge_id))
    SELECT (SELECT string_agg(format('<text x="%s" y="%s" font-weight="bold">%s</text>', 10 + 146 * (turn % 6),
                top + 14 + 160 * (turn / 6), CASE kind WHEN 'walk' THEN 'on foot' ELSE 'phase '
                || turn + 1 END || ', ' || duration || ' s'), '' ORDER BY turn) FROM place)
        || string_agg(format('<path d="%s" transform="translate(%s %s)" fill="none" stroke="%s" stroke-width="%s"%s/>',
            ST_AsSVG(ST_Scale(ST_Translate(geom, -x, -y), scale, scale), 0, 1), 14 + 146 * (turn % 6),
            top + 24 + 160 * (turn / 6), substring(styles ->> concat('signal_plan ', aspect), '#[0-9a-f]+'),
            CASE layer WHEN 1 THEN 1 WHEN 2 THEN 2.5 ELSE 4 END, CASE WHEN layer = 2 THEN format(
                ' marker-end="url(#%s)"', aspect) WHEN layer = 3 THEN ' stroke-dasharray="3 2"' ELSE '' END), ''
            ORDER BY turn, layer, aspect, geom),
        160 * (1 + (SELECT max(turn) FROM place) / 6)::integer INTO svg, height
    FROM drawn, box;
END $$;
COMMENT ON FUNCTION streetgen._plan_phases(name, bigint, jsonb, integer) IS
    'The phases of a controller, who has green in each as arrows and who walks as dashes, in SVG below a height of the '
    'picture.';

CREATE OR REPLACE FUNCTION streetgen.signal_svg(model name, controller bigint) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    styles jsonb;
    top integer := 28;
    svg text;
    part record;
BEGIN
    PERFORM streetgen._use_model(model);
    -- Arguments are checked there.
    PERFORM FROM streetgen.signal_plan(model, controller);
    styles := streetgen._plan_styles(model, 1);
    SELECT format('<text x="10" y="18" font-size="14" font-weight="bold">%s</text>', streetgen._as_xml(format(
            'Controller %s: %s, cycle %s s, offset %s s', c.controller_id, c.program, c.cycle,
            round(c.start_offset::numeric, 1)))) INTO svg FROM controller c WHERE c.controller_id = controller;
    SELECT * INTO part FROM streetgen._plan_phases(model, controller, styles, top);
    svg := concat(svg, part.svg);
    top := top + coalesce(part.height, 0);
    SELECT * INTO part FROM streetgen._plan_bars(model, controller, styles, top);
    svg := concat(svg, part.svg);
    top := top + coalesce(part.height, 0);
    SELECT * INTO part FROM streetgen._plan_intergreens(model, controller, styles, top);
    svg := concat(svg, part.svg);
    top := top + coalesce(part.height, 0);
    RETURN format('<svg xmlns="http://www.w3.org/2000/svg" width="890" height="%s" font-family="sans-serif" '
            'font-size="12" style="%s"><defs>', top, styles ->> 'ink')
        || (SELECT string_agg(format('<marker id="%s" markerWidth="4" markerHeight="4" refX="2" refY="2" '
                'orient="auto"><path d="M0 0L4 2L0 4z" fill="%s"/></marker>', aspect, substring(styles
                ->> concat('signal_plan ', aspect), '#[0-9a-f]+')), '') FROM unnest('{protected,permitted}'::text[])
                aspect)
        || format('</defs><rect width="100%%" height="100%%" style="%s"/>', styles ->> 'paper') || svg || '</svg>';
END $$;
COMMENT ON FUNCTION streetgen.signal_svg(name, bigint) IS
    'The plan of a controller (SVG): its phases with who has green in each (light: permitted) and who walks; a bar '
    'over time for each signal group, with amber, walk and the time to clear; and the matrix of times between greens, '
    'in seconds. Errors are those of signal_plan.';
