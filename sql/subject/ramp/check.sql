-- Rules of check_model for ramps.

CREATE OR REPLACE FUNCTION streetgen._check_ramp(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'notice', 'merging lane cut by the next junction, m', 'ramp', r.ramp_id, r.length, r.geom FROM ramp r
        WHERE r.cut
    UNION ALL
    SELECT 'notice', 'link shorter than the tangent of its ramp, m', 'ramp', r.ramp_id, ST_Length(e.geom), r.geom
        FROM ramp r JOIN edge e USING (edge_id) WHERE r.short_link
    UNION ALL
    SELECT 'warning', 'ramp override without its ramp', 'ramp_override', o.ramp_override_id, o.abscissa, o.geom
        FROM ramp_override o WHERE NOT EXISTS (SELECT FROM edge e JOIN ramp r USING (edge_id),
            LATERAL streetgen._ramp_stretch(model, r.ramp_id) s
            WHERE e.axis_id = o.axis_id AND o.abscissa BETWEEN s.low AND s.high)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_ramp(name) IS
    'The rows of streetgen.check_model for ramps.';

CREATE OR REPLACE FUNCTION streetgen._ramp_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (45, 'ramp', $part$
    (SELECT 'ramps, ' || kind, count(*), NULL FROM %1$I.ramp GROUP BY kind ORDER BY kind)$part$) $$;
COMMENT ON FUNCTION streetgen._ramp_summary() IS 'What streetgen.summary counts of ramps.';

INSERT INTO streetgen.check_rule (rule, meaning, hint, least_is_worst) VALUES
    ('merging lane cut by the next junction, m',
        'less room than `merging_length` and its taper want; the measure is what keeps its width',
        'a shorter `merging_length`, or `ramp_editing`', true),
    ('link shorter than the tangent of its ramp, m',
        'its bend into the lane of the highway is tighter, or begins beside it',
        'draw the link longer, or lower the tangent in `ramp_editing`', true);

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('ramp override without its ramp', 'no link meets a highway at the nearer end of its edge',
        'delete the row, or move its place');
