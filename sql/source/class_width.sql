-- Lanes and widths that no source states, or that leave no room for what else it states.

CREATE OR REPLACE FUNCTION streetgen._settle_class_lanes(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- Models of older builds do not say who put a number that differs from that of a new model.
    RETURN QUERY WITH said AS (
        SELECT i.class, mode() WITHIN GROUP (ORDER BY lanes) AS lanes, count(*) AS lines FROM pg_temp._import i,
            -- Kinds of lanes may be an estimate beside those of the kerbs: these lines do not count.
            LATERAL (SELECT nullif(coalesce(i.lane_count, CASE WHEN num_nonnulls(i.kind_forward, i.kind_backward) = 0
                THEN CASE i.direction WHEN 'direct' THEN i.lanes_forward ELSE i.lanes_backward END END), 0) AS lanes) l
        WHERE i.direction IN ('direct', 'reverse') AND i.roundabout_tag IS NULL AND lanes BETWEEN 1 AND 15
        GROUP BY i.class HAVING count(*) >= streetgen._setting_number(model, 'class_lines_minimal')),
    settled AS (
        UPDATE axis_class c SET lanes_one_way = s.lanes, width_one_way = NULL, lanes_one_way_by = 'import'
        FROM said s LEFT JOIN streetgen._default_axis_class() d USING (class)
        WHERE c.class = s.class AND c.lanes_by_width AND c.lanes_one_way IS DISTINCT FROM s.lanes
            AND c.lanes_one_way_by IS NULL
            AND (c.lanes_one_way, c.width_one_way) IS NOT DISTINCT FROM (d.lanes_one_way, d.width_one_way)
        RETURNING c.class, s.lanes, s.lines)
    SELECT format('%s lanes on one-way lines that state none, as on most of so many that do', lanes), class, lines,
            NULL::text[]
        FROM settled ORDER BY class;
END $$;
COMMENT ON FUNCTION streetgen._settle_class_lanes(name) IS
    'Gives the classes of which an import has enough one-way lines that state their lanes, roundabouts apart, the '
    'number that most of them have; tells of each.';

CREATE OR REPLACE FUNCTION streetgen._tell_usual_widths(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT format('neither width nor lanes stated, %s m wide', round((coalesce(u.by_class, s.usual)
            + coalesce(c.parking_left + c.parking_right, 0))::numeric, 2)::float8), i.class, count(*), NULL::text[]
        FROM pg_temp._import i LEFT JOIN axis_class c USING (class),
            (SELECT (max(value) FILTER (WHERE name = 'width_default'))::float8 AS usual,
                (max(value) FILTER (WHERE name = 'lane_width'))::float8 AS lane,
                bool_or(value = 'true') FILTER (WHERE name = 'roundabout_tags') AS tags_count FROM setting) s,
            LATERAL (SELECT CASE WHEN i.direction IN ('direct', 'reverse')
                    AND NOT (s.tags_count AND streetgen._names_ring(i.roundabout_tag))
                THEN coalesce(c.width_one_way, c.lanes_one_way * s.lane, c.width) ELSE c.width END AS by_class) u
        WHERE num_nonnulls(i.width, i.lane_count, i.lanes_forward, i.lanes_backward, i.lanes_both, i.kind_forward,
            i.kind_backward) = 0
        GROUP BY 1, 2 ORDER BY 3 DESC, 2, 1;
END $$;
COMMENT ON FUNCTION streetgen._tell_usual_widths(name) IS
    'Tells of each class of an import how many of its lines state neither width nor lanes, and how wide they become.';

CREATE OR REPLACE FUNCTION streetgen._tell_narrow_between_kerbs(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT format('parking, cycle or closed lanes leave less than %s m for each other lane', s.narrowest),
            NULL::text, count(*), array_agg(i.label ORDER BY i.label)
        FROM (SELECT (max(value) FILTER (WHERE name = 'lane_width_minimal'))::float8 AS narrowest,
                (max(value) FILTER (WHERE name = 'lane_width'))::float8 AS lane,
                (max(value) FILTER (WHERE name = 'cycle_lane_width'))::float8 AS cycle,
                (max(value) FILTER (WHERE name = 'parking_lane_width'))::float8 AS parking FROM setting) s,
            pg_temp._import i LEFT JOIN axis_class c USING (class),
            LATERAL (SELECT streetgen._kerbside_width(i.kind_forward, i.lane_width_forward, s.lane, s.cycle, s.parking)
                + streetgen._kerbside_width(i.kind_backward, i.lane_width_backward, s.lane, s.cycle, s.parking)
                AS kerbside) k
        WHERE i.width > 0 AND k.kerbside > 0
            AND c.lanes_by_width IS NOT FALSE AND i.access IS DISTINCT FROM 'no' AND i.access IS DISTINCT FROM 'cycle'
            AND least(i.width, i.width_end) - k.kerbside < s.narrowest * greatest(1, i.lane_count,
                coalesce(streetgen.driving_lanes(i.kind_forward), 0) + coalesce(i.lanes_both, 0)
                + coalesce(streetgen.driving_lanes(i.kind_backward), 0))
        GROUP BY s.narrowest;
END $$;
COMMENT ON FUNCTION streetgen._tell_narrow_between_kerbs(name) IS
    'Tells the lines of an import whose stated width, less their parking, cycle and closed lanes, has no room for '
    'their other lanes, or for one.';
