-- Checks and counts of the fit.

CREATE OR REPLACE FUNCTION streetgen._check_fit(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'notice', 'proposal of a fit whose axis was edited since', 'fit_proposal', p.fit_proposal_id,
            NULL::float8, coalesce(a.geom, p.geom)::geometry
        FROM fit_proposal p LEFT JOIN axis a USING (axis_id) LEFT JOIN streetgen._fit_hashes(model, ARRAY(
            SELECT axis_id FROM fit_proposal WHERE state = 'proposed')) h USING (axis_id)
        WHERE p.state = 'proposed' AND p.axis_hash IS DISTINCT FROM h.axis_hash
    UNION ALL
    SELECT 'notice', 'proposal of a fit whose axis was edited since', 'corner_proposal', p.corner_proposal_id,
            NULL::float8, p.geom
        FROM corner_proposal p LEFT JOIN streetgen._corners_to_fit(model, ARRAY(SELECT o.corner_id
            FROM corner_proposal o WHERE o.state = 'proposed')) c USING (corner_id)
        WHERE p.state = 'proposed' AND (p.axes_hash IS DISTINCT FROM c.axes_hash OR c.by_hand)
    UNION ALL
    SELECT 'notice', 'kerb far from its observations, m', 'kerb_distance', k.kerb_distance_id, k.median, k.geom
        FROM kerb_distance k WHERE k.median > 0.5 AND k.observations >= 10;
END $$;
COMMENT ON FUNCTION streetgen._check_fit(name) IS 'The rows of streetgen.check_model for the fit.';

CREATE OR REPLACE FUNCTION streetgen._fit_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (80, 'fit', $part$
    SELECT 'open proposals of fits', count(*)::numeric, NULL FROM %1$I.fit_proposal WHERE state = 'proposed'
    UNION ALL SELECT 'mean distance to observations', avg(mean)::numeric(9,3), 'm' FROM %1$I.kerb_distance$part$) $$;
COMMENT ON FUNCTION streetgen._fit_summary() IS 'What streetgen.summary counts of the fit.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('proposal of a fit whose axis was edited since',
        'the axis is not as the fit knew it, and streetgen.accept_fit leaves it',
        '`streetgen.fit` anew, or `streetgen.reject_fit`'),
    ('kerb far from its observations, m',
        'half of the points observed of a kerb lie over 0.5 m beside that of the street',
        '`streetgen.fit`, then `streetgen.accept_fit`; `fit_change` shows what it would change');
