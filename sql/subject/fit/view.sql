-- Views of the changes that are proposed, and of observations that no street took.

CREATE OR REPLACE FUNCTION streetgen._unused_observations(model name)
    RETURNS TABLE(observation_id bigint, kind text, why text, points bigint, source text, source_ref text,
        geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    model_name constant name := model;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT o.observation_id, o.kind, CASE WHEN p.fate = 'at junction' THEN 'at a junction'
            WHEN p.fate = 'not sure' THEN 'its confidence is 0'
            WHEN o.kind = 'marking' THEN 'no street of two lanes within fit_reach of its kerb'
            ELSE 'no street within fit_reach of its kerb' END, count(*), o.source, o.source_ref,
            ST_Multi(ST_Collect(p.place))
        FROM streetgen._taken_points(model_name, NULL, false) p JOIN observation o USING (observation_id)
        WHERE p.fate <> 'taken' GROUP BY o.observation_id, p.fate ORDER BY 1, 3;
END $$;
COMMENT ON FUNCTION streetgen._unused_observations(name) IS 'The rows of view observation_unused.';

CREATE OR REPLACE FUNCTION streetgen._fit_arrows(line geometry, proposed geometry, kerbs_before float8[],
    kerbs_after float8[]) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH place AS (
        SELECT share, ST_LineInterpolatePoint(line, share) AS point, ST_Azimuth(ST_LineInterpolatePoint(line,
            greatest(0, share - 0.01)), ST_LineInterpolatePoint(line, least(1, share + 0.01))) AS heading
        FROM unnest(ARRAY[0.25, 0.5, 0.75]) share),
    arrow AS (
        SELECT ST_MakeLine(ST_Translate(point, -before * cos(heading), before * sin(heading)),
            ST_Translate(point, -after * cos(heading), after * sin(heading))) AS geom
        FROM place, LATERAL (VALUES (1), (3)) side(s), LATERAL (
            SELECT kerbs_before[s] + (kerbs_before[s + 1] - kerbs_before[s]) * share AS before,
                kerbs_after[s] + (kerbs_after[s + 1] - kerbs_after[s]) * share AS after) k
        WHERE heading IS NOT NULL AND abs(after - before) > 0.01 AND ST_Equals(line, proposed)
        UNION ALL SELECT ST_MakeLine(ST_ClosestPoint(line, d.geom), d.geom) FROM ST_DumpPoints(proposed) d
            WHERE NOT ST_DWithin(line, d.geom, 0.01))
    SELECT ST_Collect(geom) FROM arrow $$;
COMMENT ON FUNCTION streetgen._fit_arrows(geometry, geometry, float8[], float8[]) IS
    'Lines from where kerbs or vertices are to where a proposal has them (MULTILINESTRING; NULL: none moves by 1 cm). '
    'kerbs: metres to the left of the axis, of the left one at the start and the end, then of the right one.';

CREATE OR REPLACE FUNCTION streetgen._make_fit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'fit' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._part_in('observation_unused', model, jsonb_build_object('model', quote_literal(model)));
    COMMENT ON VIEW observation_unused IS 'Points of observations that no street takes, and why';
    COMMENT ON COLUMN observation_unused.observation_id IS 'the observation';
    COMMENT ON COLUMN observation_unused.kind IS 'its kind';
    COMMENT ON COLUMN observation_unused.why IS
        'no street within fit_reach of its kerb, for a marking none of two lanes; at a junction, where no section is; '
        'or its confidence is 0';
    COMMENT ON COLUMN observation_unused.points IS 'how many of its points';
    COMMENT ON COLUMN observation_unused.source IS 'table that it was taken from';
    COMMENT ON COLUMN observation_unused.source_ref IS 'its identity in the source';
    COMMENT ON COLUMN observation_unused.geom IS 'these points';
    EXECUTE streetgen._part_in('fit_change', model);
    COMMENT ON VIEW fit_change IS 'Arrows from what is to what is proposed: kerbs, or vertices of axes that move';
    COMMENT ON COLUMN fit_change.fit_proposal_id IS 'key: the proposal';
    COMMENT ON COLUMN fit_change.fit_run IS 'its run';
    COMMENT ON COLUMN fit_change.axis_id IS 'the axis';
    COMMENT ON COLUMN fit_change.wider IS 'how much wider the roadway becomes, metres';
    COMMENT ON COLUMN fit_change.geom IS 'lines from where each is to where it would be';
END $$;
COMMENT ON FUNCTION streetgen._make_fit_views(name) IS
    'Makes views observation_unused and fit_change of a model that computes the fit.';

CREATE OR REPLACE FUNCTION streetgen._fit_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('fit_change'::name, 'fit'), ('observation_unused', 'fit') $$;
COMMENT ON FUNCTION streetgen._fit_view() IS 'The views of the fit, and the subject whose tables they read.';
