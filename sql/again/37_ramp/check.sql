-- Rules of check_model for ramps.

CREATE OR REPLACE FUNCTION streetgen._ramp_check_part()
    RETURNS TABLE(place integer, subject text, kind text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (94, 'ramp', 'rule', $part$
SELECT 'notice', 'merging lane cut by the next junction, m', 'ramp', r.ramp_id, r.length, r.geom FROM %1$I.ramp r
    WHERE r.cut$part$),
    (95, 'ramp', 'rule', $part$
SELECT 'notice', 'link shorter than the tangent of its ramp, m', 'ramp', r.ramp_id, ST_Length(e.geom), r.geom
    FROM %1$I.ramp r JOIN %1$I.edge e USING (edge_id) WHERE r.short_link$part$),
    (96, 'ramp', 'rule', $part$
SELECT 'warning', 'ramp override without its ramp', 'ramp_override', o.ramp_override_id, o.abscissa, o.geom
    FROM %1$I.ramp_override o WHERE NOT EXISTS (SELECT FROM %1$I.edge e JOIN %1$I.ramp r USING (edge_id),
        LATERAL streetgen._ramp_stretch(%1$L, r.ramp_id) s
        WHERE e.axis_id = o.axis_id AND o.abscissa BETWEEN s.low AND s.high)$part$) $$;
COMMENT ON FUNCTION streetgen._ramp_check_part() IS 'The parts of streetgen._check_part() for ramps.';
