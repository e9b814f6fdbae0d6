-- Widths that no source states.

CREATE OR REPLACE FUNCTION streetgen._tell_usual_widths(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT format('neither width nor lanes stated, %s m wide', round(coalesce(c.width, s.usual)::numeric,
            2)::float8), i.class, count(*), NULL::text[]
        FROM pg_temp._import i LEFT JOIN axis_class c USING (class),
            (SELECT value::float8 AS usual FROM setting WHERE name = 'width_default') s
        WHERE num_nonnulls(i.width, i.lane_count, i.lanes_forward, i.lanes_backward, i.lanes_both, i.kind_forward,
            i.kind_backward) = 0
        GROUP BY i.class, c.width, s.usual ORDER BY 3 DESC, 2;
END $$;
COMMENT ON FUNCTION streetgen._tell_usual_widths(name) IS
    'Tells of each class of an import how many of its lines state neither width nor lanes, and how wide they become.';
