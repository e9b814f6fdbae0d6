-- Proposals of a fit are accepted, rejected and undone.

CREATE OR REPLACE FUNCTION streetgen._require_fit_run(model name, run bigint, axes bigint[]) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wanted constant bigint := run;
    unknown bigint[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_reader(model),
        streetgen._check_given('fit_run', run::text), streetgen._require_subject(model, 'fit');
    IF NOT EXISTS (SELECT FROM fit_run r WHERE r.fit_run = wanted) THEN
        RAISE EXCEPTION 'there is no run % of fit', coalesce(run::text, 'NULL') USING ERRCODE = '22023',
            HINT = format('SELECT * FROM %I.fit_run lists them.', model);
    END IF;
    unknown := ARRAY(SELECT u FROM unnest(axes) u WHERE NOT EXISTS (SELECT FROM fit_proposal p
        WHERE p.fit_run = wanted AND p.axis_id = u) ORDER BY u);
    IF unknown <> '{}' THEN
        RAISE EXCEPTION 'run % has no proposal for axis %', run, coalesce(unknown[1]::text, 'NULL')
            USING ERRCODE = '22023', HINT = format('Leave out axes %s.', array_to_string(unknown, ', ', 'NULL'));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_fit_run(name, bigint, bigint[]) IS
    'Raises what streetgen._require_reader raises, 55000 for a model without the subject, and 22023 for a run that is '
    'none, and for axes of which it has no proposal.';

CREATE OR REPLACE FUNCTION streetgen._require_unedited(model name, proposals bigint[], done text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    edited bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    edited := ARRAY(SELECT p.axis_id FROM fit_proposal p LEFT JOIN axis a USING (axis_id)
        WHERE p.fit_proposal_id = ANY (proposals) AND p.axis_hash IS DISTINCT FROM streetgen._fit_hash(a.geom, a.width,
            a.width_end, a.roadway_offset, a.sidewalk_left, a.sidewalk_right) ORDER BY 1);
    IF edited <> '{}' THEN
        RAISE EXCEPTION '% axes were edited since the fit, and nothing was %', cardinality(edited), done
            USING ERRCODE = '55000', HINT = format('Leave these out: %s. Or fit again.',
                array_to_string(edited[:100], ', ') || CASE WHEN cardinality(edited) > 100 THEN ' …' ELSE '' END);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_unedited(name, bigint[], text) IS
    'Raises 55000 where an axis of some proposals is not as these know it, with the ids of these axes.';

CREATE OR REPLACE FUNCTION streetgen._require_whole(model name, run bigint, proposals bigint[], of_state text,
    done text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wanted constant bigint := run;
    belong bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    WITH RECURSIVE part(axis_id, nodes) AS (
        SELECT p.axis_id, p.nodes FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals)
        UNION SELECT o.axis_id, o.nodes FROM part JOIN fit_proposal o
            ON o.fit_run = wanted AND o.state = of_state AND o.nodes && part.nodes)
    SELECT array_agg(DISTINCT axis_id ORDER BY axis_id) FROM part INTO belong;
    IF EXISTS (SELECT FROM unnest(belong) b WHERE NOT EXISTS (SELECT FROM fit_proposal p
        WHERE p.fit_proposal_id = ANY (proposals) AND p.axis_id = b)) THEN
        RAISE EXCEPTION 'these axes share nodes that move with others, and nothing was %', done
            USING ERRCODE = '55000', HINT = format('These belong together: %s.', array_to_string(belong[:100], ', ')
                || CASE WHEN cardinality(belong) > 100 THEN ' …' ELSE '' END);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_whole(name, bigint, bigint[], text, text) IS
    'Raises 55000 where some proposals move a node that others of the run in the same state move too, with all axes '
    'that belong together.';

CREATE OR REPLACE FUNCTION streetgen.accept_fit(model name, fit_run bigint, axes bigint[] DEFAULT NULL) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    run constant bigint := fit_run;
    of_axes constant bigint[] := axes;
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_fit_run(model, run, of_axes);
    proposals := ARRAY(SELECT fit_proposal_id FROM fit_proposal p WHERE p.fit_run = run AND p.state = 'proposed'
        AND (of_axes IS NULL OR p.axis_id = ANY (of_axes)) ORDER BY 1 FOR UPDATE);
    PERFORM FROM axis a JOIN fit_proposal p USING (axis_id) WHERE p.fit_proposal_id = ANY (proposals)
        ORDER BY a.axis_id FOR UPDATE OF a;
    PERFORM streetgen._require_unedited(model, proposals, 'accepted'),
        streetgen._require_whole(model, run, proposals, 'proposed', 'accepted');
    UPDATE fit_proposal p SET former = to_jsonb(f) || jsonb_build_object('geom', a.geom::text) FROM axis a,
        LATERAL (SELECT a.width, a.width_end, a.roadway_offset, a.sidewalk_left, a.sidewalk_right, a.width_by_hand,
            a.source_width, a.source_width_end) f
        WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    UPDATE axis a SET geom = p.geom, width = p.width, width_end = p.width_end, roadway_offset = p.roadway_offset,
            sidewalk_left = coalesce(p.sidewalk_left, a.sidewalk_left),
            sidewalk_right = coalesce(p.sidewalk_right, a.sidewalk_right)
        FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    UPDATE fit_proposal p SET state = 'accepted', axis_hash = streetgen._fit_hash(a.geom, a.width, a.width_end,
            a.roadway_offset, a.sidewalk_left, a.sidewalk_right)
        FROM axis a WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    RETURN cardinality(proposals);
END $$;
COMMENT ON FUNCTION streetgen.accept_fit(name, bigint, bigint[]) IS
    'Writes proposals of a run to their axes, in one statement, as an edit by hand, and gives how many; streets follow '
    'at once. axes: of these alone, NULL: all that are still proposed. An axis that was edited since the fit: 55000, '
    'its id in the hint; so where axes share nodes that move with others that are left out. A run or axis that is '
    'none: 22023; without rights to edit: 42501.';

CREATE OR REPLACE FUNCTION streetgen.reject_fit(model name, fit_run bigint, axes bigint[] DEFAULT NULL) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    run constant bigint := fit_run;
    of_axes constant bigint[] := axes;
    rejected bigint;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_fit_run(model, run, of_axes);
    UPDATE fit_proposal p SET state = 'rejected' WHERE p.fit_run = run AND p.state = 'proposed'
        AND (of_axes IS NULL OR p.axis_id = ANY (of_axes));
    GET DIAGNOSTICS rejected = ROW_COUNT;
    RETURN rejected;
END $$;
COMMENT ON FUNCTION streetgen.reject_fit(name, bigint, bigint[]) IS
    'Marks proposals of a run as rejected, and gives how many: accept_fit leaves them. axes: of these alone, NULL: all '
    'that are still proposed. A run or axis that is none: 22023; without rights to edit: 42501.';

CREATE OR REPLACE FUNCTION streetgen.undo_fit(model name, fit_run bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.puts_back = 'on'
    AS $$
#variable_conflict use_column
DECLARE
    run constant bigint := fit_run;
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_fit_run(model, run, NULL);
    proposals := ARRAY(SELECT fit_proposal_id FROM fit_proposal p WHERE p.fit_run = run AND p.state = 'accepted'
        ORDER BY 1 FOR UPDATE);
    PERFORM FROM axis a JOIN fit_proposal p USING (axis_id) WHERE p.fit_proposal_id = ANY (proposals)
        ORDER BY a.axis_id FOR UPDATE OF a;
    PERFORM streetgen._require_unedited(model, proposals, 'undone');
    UPDATE axis a SET (geom, width, width_end, roadway_offset, sidewalk_left, sidewalk_right, width_by_hand,
            source_width, source_width_end) = (SELECT f.geom, f.width, f.width_end, f.roadway_offset, f.sidewalk_left,
            f.sidewalk_right, f.width_by_hand, f.source_width, f.source_width_end
            FROM jsonb_populate_record(a, p.former) f)
        FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    UPDATE fit_proposal p SET state = 'undone', former = NULL, axis_hash = streetgen._fit_hash(a.geom, a.width,
            a.width_end, a.roadway_offset, a.sidewalk_left, a.sidewalk_right)
        FROM axis a WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    RETURN cardinality(proposals);
END $$;
COMMENT ON FUNCTION streetgen.undo_fit(name, bigint) IS
    'Puts back exactly what the axes were before proposals of a run were accepted, in one statement, and gives how '
    'many. Where an axis was edited since, nothing is undone: 55000, with the ids in the hint. A run that is none: '
    '22023; without rights to edit: 42501.';

CREATE OR REPLACE FUNCTION streetgen._fit_edited() RETURNS TABLE(relation name)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES ('observation'::name), ('fit_run'), ('fit_proposal') $$;
COMMENT ON FUNCTION streetgen._fit_edited() IS 'The tables of the fit that an editor may write.';
