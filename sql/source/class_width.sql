-- Lanes and widths that no source states.

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
