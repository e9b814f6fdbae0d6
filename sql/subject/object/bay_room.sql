-- Parking bays take ground of a roadway and leave the rest to those who drive: rules and check_model ask how much.

CREATE OR REPLACE FUNCTION streetgen._least_bay_depth() RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN 1.6::float8;
COMMENT ON FUNCTION streetgen._least_bay_depth() IS 'On a parking lane narrower than this no car stands, metres.';

CREATE OR REPLACE FUNCTION streetgen._bay_so_deep(depth float8, orientation text, with_axis boolean,
    OUT length float8, OUT width float8, OUT angle float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN across THEN deep ELSE usual.length END, CASE WHEN along THEN deep ELSE usual.width END,
        CASE WHEN along THEN 0 WHEN across THEN 90 WHEN with_axis THEN lean ELSE 180 - lean END
    FROM streetgen._usual_bay() usual,
        -- Between the depths of cars along the kerb, askew and across.
        LATERAL (SELECT round(least(depth, 10)::numeric, 6)::float8 AS deep,
            coalesce(orientation = 'parallel', depth < 3.25) AS along,
            coalesce(orientation = 'perpendicular', depth >= 4.75) AS across) d,
        LATERAL (SELECT asind(least(1, deep / usual.length)) AS lean) l $$;
COMMENT ON FUNCTION streetgen._bay_so_deep(float8, text, boolean) IS
    'Length, width (m) and angle (degrees) of a bay of a depth (m), for cars that stand parallel, diagonal or '
    'perpendicular; NULL: along the kerb below 3.25 m, across from 4.75 m on, and between these askew. They pass the '
    'kerb of its side along the axis or against it.';

CREATE OR REPLACE FUNCTION streetgen._make_bay_room(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _edges_between_borders(edges bigint[])
        RETURNS TABLE(edge_id bigint, axis_id bigint, start_abscissa float8, end_abscissa float8, roadway_offset float8,
            borders float8[])
        LANGUAGE sql STABLE ROWS 100 SET search_path FROM CURRENT SET jit = off
        AS $body$
        SELECT e.edge_id, e.axis_id, e.start_abscissa, e.end_abscissa, e.roadway_offset, coalesce(s.borders,
            streetgen._even_borders(e.width, e.width_end, e.end_abscissa - e.start_abscissa, e.roadway_offset))
        FROM edge e JOIN section s USING (edge_id) WHERE edges IS NULL OR e.edge_id = ANY (edges) $body$;
    CREATE OR REPLACE FUNCTION _lanes_across(edges bigint[])
        RETURNS TABLE(edge_id bigint, kind text, along_axis boolean, width float8, axis_offset float8,
            borders float8[], start_abscissa float8, end_abscissa float8)
        LANGUAGE plpgsql STABLE ROWS 10 SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    BEGIN
        IF edges <> '{}' AND to_regclass('lane') IS NOT NULL THEN
            RETURN QUERY SELECT edge_id, kind, along_axis, width, axis_offset,
                streetgen._lane_borders(borders, width, axis_offset), start_abscissa, end_abscissa
            FROM lane WHERE edge_id = ANY (edges) AND method <> 'crossed_limits';
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION _parking_lanes(edges bigint[])
        RETURNS TABLE(edge_id bigint, side text, depth float8, along_axis boolean, borders float8[])
        LANGUAGE sql STABLE ROWS 10 SET search_path FROM CURRENT SET jit = off
        AS $body$
        SELECT DISTINCT ON (edge_id, s.side) edge_id, s.side, l.width, l.along_axis, l.borders
        FROM _lanes_across(edges) l JOIN edge e USING (edge_id), LATERAL (
            SELECT streetgen._side_of_street(NULL, l.axis_offset, e.roadway_offset) AS side) s
        WHERE l.kind = 'parking' ORDER BY edge_id, s.side, abs(l.axis_offset - e.roadway_offset) DESC $body$;
    CREATE OR REPLACE FUNCTION _bay_room(bays streetgen.bay_place[])
        RETURNS TABLE(number bigint, on_lane boolean, narrowest float8, taken float8, remains float8, needed float8)
        LANGUAGE sql STABLE ROWS 100 SET search_path FROM CURRENT SET jit = off
        AS $body$
        WITH bay AS MATERIALIZED (
            SELECT * FROM unnest(bays) WITH ORDINALITY b(edge_id, side, low, high, axis_offset, depth, number)),
        street AS MATERIALIZED (
            SELECT e.edge_id, b.start_abscissa, b.borders,
                (SELECT value::float8 FROM setting WHERE name = CASE WHEN a.direction = 'both' OR e.lanes_both > 0
                    OR least(e.lanes_forward, e.lanes_backward) > 0 THEN 'bay_roadway_both' ELSE 'bay_roadway_one_way'
                    END) AS needed
            FROM _edges_between_borders(ARRAY(SELECT DISTINCT edge_id FROM bay)) b JOIN edge e USING (edge_id)
                JOIN axis a ON a.axis_id = e.axis_id),
        lane AS MATERIALIZED (SELECT * FROM _lanes_across(ARRAY(SELECT edge_id FROM street))),
        -- Metres from the axis outwards on the side of the bay.
        cut AS MATERIALIZED (
            SELECT b.number, b.edge_id, b.side, s.needed, at, v.other, width,
                greatest(to_border + b.axis_offset - b.depth, to_border - width) AS inner_end,
                to_border + least(b.axis_offset, 0) AS outer_end
            FROM bay b JOIN street s USING (edge_id), LATERAL unnest(ARRAY[low, (low + high) / 2, high]) at,
                LATERAL (SELECT CASE b.side WHEN 'left' THEN 'right' ELSE 'left' END AS other) v,
                LATERAL (SELECT streetgen._border_at(s.borders, at, b.side) AS to_border OFFSET 0) t,
                LATERAL (SELECT to_border + streetgen._border_at(s.borders, at, v.other) AS width OFFSET 0) w),
        piece AS (
            SELECT c.number, at, l.kind, i.lane_width, greatest(0, least(i.lane_outer, c.outer_end)
                    - greatest(i.lane_inner, c.inner_end)) AS of_lane
            FROM cut c JOIN street s USING (edge_id) JOIN lane l USING (edge_id), LATERAL (
                SELECT lane_outer, lane_inner, lane_outer - lane_inner AS lane_width FROM (
                    SELECT streetgen._border_at(l.borders, at, c.side) AS lane_outer,
                        -streetgen._border_at(l.borders, at, c.other) AS lane_inner OFFSET 0) i) i
            WHERE at + s.start_abscissa BETWEEN coalesce(l.start_abscissa, '-Infinity')
                AND coalesce(l.end_abscissa, 'Infinity')),
        across AS (
            SELECT number, at, bool_or(of_lane > 0.01 AND kind <> ALL ('{general,parking}')) AS on_lane,
                min(lane_width - of_lane) FILTER (WHERE of_lane > 0.01 AND kind = 'general') AS narrowest,
                coalesce(sum(lane_width) FILTER (WHERE kind = ANY ('{parking,cycle,closed}')), 0) AS not_driven,
                coalesce(sum(of_lane) FILTER (WHERE kind = ANY ('{parking,cycle,closed}')), 0) AS not_of_driven
            FROM piece GROUP BY number, at)
        SELECT c.number, coalesce(bool_or(on_lane), false), min(narrowest), max(taken),
            min(width - coalesce(not_driven, 0) - taken), min(needed)
        FROM cut c LEFT JOIN across a USING (number, at), LATERAL (
            SELECT greatest(0, outer_end - inner_end) - coalesce(not_of_driven, 0) AS taken) t
        GROUP BY c.number $body$;
    CREATE OR REPLACE FUNCTION _laid_bays(edges bigint[], of_rules boolean)
        RETURNS TABLE(street_object_id bigint, place streetgen.bay_place)
        LANGUAGE sql STABLE ROWS 100 SET search_path FROM CURRENT SET jit = off
        AS $body$
        SELECT o.street_object_id, ROW (e.edge_id, s.side, at - reach, at + reach, CASE WHEN o.side IS NOT NULL
            THEN o.axis_offset ELSE (CASE s.side WHEN 'left' THEN 1 ELSE -1 END) * o.axis_offset
                - streetgen._border_at(borders, at, s.side) END,
            streetgen._bay_depth(b.length, b.width, b.angle))::streetgen.bay_place
        FROM _edges_between_borders(edges) e JOIN street_object o USING (axis_id)
            JOIN parking_bay b USING (street_object_id),
            LATERAL (SELECT streetgen._side_of_street(o.side, o.axis_offset, e.roadway_offset) AS side,
                o.abscissa - e.start_abscissa AS at, streetgen._bay_reach(b.length, b.width, b.angle) AS reach) s
        WHERE (of_rules OR o.placed_by <> 'rule') AND o.method = 'relative' AND b.surface IS NOT NULL
            AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa $body$;
    CREATE OR REPLACE FUNCTION _judged_bays()
        RETURNS TABLE(street_object_id bigint, on_lane boolean, narrowest float8, remains float8, needed float8)
        LANGUAGE sql STABLE ROWS 100 SET search_path FROM CURRENT SET jit = off
        AS $body$
        WITH laid AS MATERIALIZED (
            SELECT street_object_id, place, row_number() OVER () AS number FROM _laid_bays(NULL, of_rules => true)),
        room AS MATERIALIZED (
            SELECT l.street_object_id, l.place, r.*
            FROM _bay_room((SELECT array_agg(place ORDER BY number) FROM laid)) r
                JOIN laid l USING (number)),
        beside AS (
            SELECT b.street_object_id, max(c.taken) AS taken FROM room b JOIN room c
                ON (c.place).edge_id = (b.place).edge_id AND (c.place).side <> (b.place).side
                    AND (c.place).low < (b.place).high AND (b.place).low < (c.place).high GROUP BY 1)
        -- One that lies beside the roadway takes none of it.
        SELECT b.street_object_id, b.on_lane, b.narrowest, CASE WHEN (b.place).axis_offset < (b.place).depth - 0.01
            THEN b.remains END - coalesce(o.taken, 0), b.needed
        FROM room b LEFT JOIN beside o USING (street_object_id) $body$;
    PERFORM streetgen._own_function(model, '_edges_between_borders(bigint[])',
        'Edges (NULL: all) with the borders of their roadway, of even ones too'),
        streetgen._own_function(model, '_lanes_across(bigint[])',
        'Lanes of edges with their borders; none in a model that computes no lanes'),
        streetgen._own_function(model, '_parking_lanes(bigint[])',
        'The outermost parking lane on each side of edges: its depth, whether its cars drive along the axis, and its '
        'borders'),
        streetgen._own_function(model, '_bay_room(streetgen.bay_place[])',
        'What bays take, each alone: whether a lane that is neither general nor for parking, how narrow a general lane '
        'gets (m; NULL: it takes of none), how much of the roadway for driving (m), what remains of that, and how much '
        'has to'),
        streetgen._own_function(model, '_laid_bays(bigint[], boolean)',
        'Bays at edges (NULL: at all), with those of rules or without them'),
        streetgen._own_function(model, '_judged_bays()',
        'What all bays take and leave, beside those on the other side of the street');
END $$;
COMMENT ON FUNCTION streetgen._make_bay_room(name) IS
    'Makes the functions of a model that tell what parking bays take of a roadway.';
