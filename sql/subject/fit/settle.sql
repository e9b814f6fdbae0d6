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
        WHERE p.fit_run = wanted AND p.axis_id = u) AND NOT EXISTS (SELECT FROM corner_proposal p
        WHERE p.fit_run = wanted AND u IN (p.axis_a, p.axis_b)) ORDER BY u);
    IF unknown <> '{}' THEN
        RAISE EXCEPTION 'run % has no proposal for axis %', run, coalesce(unknown[1]::text, 'NULL')
            USING ERRCODE = '22023', HINT = format('Leave out axes %s.', array_to_string(unknown, ', ', 'NULL'));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_fit_run(name, bigint, bigint[]) IS
    'Raises what streetgen._require_reader raises, 55000 for a model without the subject, and 22023 for a run that is '
    'none, and for axes of which it has no proposal.';

CREATE OR REPLACE FUNCTION streetgen._settle_proposals(model name, proposals bigint[], new_state text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE fit_proposal p SET state = new_state, axis_hash = h.axis_hash,
            former = CASE WHEN new_state = 'accepted' THEN p.former END
        FROM streetgen._fit_hashes(model, ARRAY(SELECT axis_id FROM fit_proposal
            WHERE fit_proposal_id = ANY (proposals))) h
        WHERE p.fit_proposal_id = ANY (proposals) AND h.axis_id = p.axis_id;
END $$;
COMMENT ON FUNCTION streetgen._settle_proposals(name, bigint[], text) IS
    'Tells of proposals whose axes were just written that they are accepted, or undone, and how these axes are now.';

CREATE OR REPLACE FUNCTION streetgen._require_unedited(model name, proposals bigint[], done text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    edited bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    edited := ARRAY(SELECT p.axis_id FROM fit_proposal p
            LEFT JOIN streetgen._fit_hashes(model, ARRAY(SELECT axis_id FROM fit_proposal
                WHERE fit_proposal_id = ANY (proposals))) h USING (axis_id)
        WHERE p.fit_proposal_id = ANY (proposals) AND p.axis_hash IS DISTINCT FROM h.axis_hash ORDER BY 1);
    IF edited <> '{}' THEN
        RAISE EXCEPTION 'axes edited since the fit: %, and nothing was %', cardinality(edited), done
            USING ERRCODE = '55000', HINT = format('Leave these out: %s. Or fit again.', streetgen._listed(edited));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_unedited(name, bigint[], text) IS
    'Raises 55000 where an axis of some proposals is not as these know it, with the ids of these axes.';

CREATE OR REPLACE FUNCTION streetgen._moved_ends(model name, run bigint, back boolean)
    RETURNS TABLE(axis_id bigint, node_id bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    wanted constant bigint := run;
    goes_back constant boolean := back;
    same_place constant float8 := 0.001;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT DISTINCT p.axis_id, n.node_id
        FROM fit_proposal p JOIN axis a USING (axis_id) JOIN edge e USING (axis_id)
            JOIN node n ON n.node_id IN (e.from_node, e.to_node),
            LATERAL (SELECT CASE WHEN goes_back THEN (p.former ->> 'geom')::geometry ELSE p.geom END AS line) w
        WHERE p.fit_run = wanted AND p.state = CASE WHEN goes_back THEN 'accepted' ELSE 'proposed' END
            AND w.line::bytea <> a.geom::bytea
            -- A node may lie beside the end of an axis, within the tolerance.
            AND ST_Distance(CASE WHEN goes_back THEN w.line ELSE ST_Points(w.line) END, n.geom)
                > ST_Distance(a.geom, n.geom) + same_place;
END $$;
COMMENT ON FUNCTION streetgen._moved_ends(name, bigint, boolean) IS
    'The nodes at which axes will be no more once the open proposals of a run are accepted, or (back) its accepted '
    'ones undone.';

CREATE OR REPLACE FUNCTION streetgen._listed(ids bigint[]) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_to_string(ids[:100], ', ') || CASE WHEN cardinality(ids) > 100 THEN ' …' ELSE '' END $$;
COMMENT ON FUNCTION streetgen._listed(bigint[]) IS 'The ids for a hint, the first hundred of them.';

CREATE OR REPLACE FUNCTION streetgen._met_axes(model name, run bigint, back boolean)
    RETURNS TABLE(axis_id bigint, met bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    model_name constant name := model;
    wanted constant bigint := run;
    goes_back constant boolean := back;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH moved AS MATERIALIZED (SELECT * FROM streetgen._moved_ends(model_name, wanted, goes_back))
    SELECT m.axis_id, e.axis_id FROM moved m JOIN edge e ON e.from_node = m.node_id
    UNION SELECT m.axis_id, e.axis_id FROM moved m JOIN edge e ON e.to_node = m.node_id;
END $$;
COMMENT ON FUNCTION streetgen._met_axes(name, bigint, boolean) IS
    'The axes that share nodes with those that streetgen._moved_ends takes away from there.';

CREATE OR REPLACE FUNCTION streetgen._note_met_axes(model name, run bigint, proposals bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH met AS MATERIALIZED (
        SELECT m.axis_id, jsonb_agg(m.met ORDER BY m.met) AS axes FROM streetgen._met_axes(model, run, true) m
        GROUP BY 1)
    UPDATE fit_proposal p SET former = p.former || jsonb_build_object('met',
            coalesce((SELECT m.axes FROM met m WHERE m.axis_id = p.axis_id), '[]'))
        WHERE p.fit_proposal_id = ANY (proposals);
END $$;
COMMENT ON FUNCTION streetgen._note_met_axes(name, bigint, bigint[]) IS
    'Keeps with proposals that were just accepted the axes that share the nodes which an undoing takes them away from: '
    'others came there since.';

CREATE OR REPLACE FUNCTION streetgen._require_whole(model name, run bigint, proposals bigint[], back boolean)
    RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    done constant text := CASE WHEN back THEN 'undone' ELSE 'accepted' END;
    belong bigint[];
    strange bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    WITH RECURSIVE meeting AS MATERIALIZED (
        -- An axis that met another when it was accepted met it before, or was joined to it by the fit itself.
        SELECT m.axis_id, m.met, o.axis_id IS NULL AS stays,
            back AND coalesce(p.former -> 'met' @> to_jsonb(m.met), true) AS known
        FROM streetgen._met_axes(model, run, back) m JOIN fit_proposal p ON p.fit_run = run AND p.axis_id = m.axis_id
            LEFT JOIN fit_proposal o ON o.fit_run = run AND o.axis_id = m.met AND o.state = p.state),
    part(axis_id) AS (
        SELECT p.axis_id FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals)
        UNION SELECT t.met FROM part JOIN meeting t USING (axis_id) WHERE NOT t.stays)
    SELECT CASE WHEN count(*) > cardinality(proposals) THEN array_agg(axis_id ORDER BY axis_id) END,
        ARRAY(SELECT DISTINCT t.met FROM part JOIN meeting t USING (axis_id) WHERE t.stays AND NOT t.known ORDER BY 1)
    FROM part INTO belong, strange;
    IF strange <> '{}' THEN
        RAISE EXCEPTION 'axes that no proposal moves share nodes that move, and nothing was %', done
            USING ERRCODE = '55000', HINT = format('These would lose their nodes: %s. %s', streetgen._listed(strange),
                CASE WHEN back THEN 'Part them from the street first.' ELSE 'Fit again.' END);
    ELSIF belong IS NOT NULL THEN
        RAISE EXCEPTION 'these axes share nodes that move with others, and nothing was %', done
            USING ERRCODE = '55000', HINT = format('These belong together: %s.', streetgen._listed(belong));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_whole(name, bigint, bigint[], boolean) IS
    'Raises 55000 where some proposals of a run, accepted or (back) undone, move a node away from axes that stay: from '
    'others of the run, with all that belong together, or from axes that came there since or whose proposal was '
    'settled.';

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
        streetgen._require_whole(model, run, proposals, false);
    UPDATE fit_proposal p SET former = to_jsonb(f) || jsonb_build_object('geom', a.geom::text) FROM axis a,
        LATERAL (SELECT a.width, a.width_end, a.roadway_offset, a.sidewalk_left, a.sidewalk_right, a.width_by_hand,
            a.source_width, a.source_width_end) f
        WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    UPDATE axis a SET geom = p.geom, width = coalesce(p.width, a.width),
            width_end = CASE WHEN p.width IS NULL THEN a.width_end ELSE p.width_end END,
            roadway_offset = coalesce(p.roadway_offset, a.roadway_offset),
            sidewalk_left = coalesce(p.sidewalk_left, a.sidewalk_left),
            sidewalk_right = coalesce(p.sidewalk_right, a.sidewalk_right)
        FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    PERFORM streetgen._settle_proposals(model, proposals, 'accepted'),
        streetgen._note_met_axes(model, run, proposals);
    RETURN cardinality(proposals) + streetgen._accept_corners(model, run, of_axes);
END $$;
COMMENT ON FUNCTION streetgen.accept_fit(name, bigint, bigint[]) IS
    'Writes proposals of a run to their axes, or to corner_override, in one statement, as an edit by hand, and gives '
    'how many; streets follow at once. axes: of these alone, NULL: all that are still proposed. An axis or corner that '
    'was edited since the fit: 55000, its axes in the hint; so where axes share nodes that move with others that are '
    'left out. A run or axis that is none: 22023; without rights to edit: 42501.';

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
    RETURN rejected + streetgen._reject_corners(model, run, of_axes);
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
    PERFORM streetgen._require_unedited(model, proposals, 'undone'),
        streetgen._require_whole(model, run, proposals, true);
    UPDATE axis a SET (geom, width, width_end, roadway_offset, sidewalk_left, sidewalk_right, width_by_hand,
            source_width, source_width_end) = (SELECT f.geom, f.width, f.width_end, f.roadway_offset, f.sidewalk_left,
            f.sidewalk_right, f.width_by_hand, f.source_width, f.source_width_end
            FROM jsonb_populate_record(a, p.former) f)
        FROM fit_proposal p WHERE p.fit_proposal_id = ANY (proposals) AND a.axis_id = p.axis_id;
    PERFORM streetgen._settle_proposals(model, proposals, 'undone');
    RETURN cardinality(proposals) + streetgen._undo_corners(model, run);
END $$;
COMMENT ON FUNCTION streetgen.undo_fit(name, bigint) IS
    'Puts back exactly what axes and corners were before proposals of a run were accepted, in one statement, and gives '
    'how many. Where an axis was edited since, nothing is undone: 55000, with the ids in the hint. A run that is none: '
    '22023; without rights to edit: 42501.';

CREATE OR REPLACE FUNCTION streetgen._fit_edited() RETURNS TABLE(relation name)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES ('observation'::name), ('fit_run'), ('fit_proposal'), ('corner_proposal') $$;
COMMENT ON FUNCTION streetgen._fit_edited() IS 'The tables of the fit that an editor may write.';
