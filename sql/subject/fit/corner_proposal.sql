-- Radii of corners are proposed where arcs of observed kerbs answer them, accepted, rejected and undone.

CREATE OR REPLACE FUNCTION streetgen._corners_to_fit(model name, corners bigint[])
    RETURNS TABLE(corner_id bigint, axis_a bigint, axis_b bigint, place geometry, radius float8, by_hand boolean,
        axes_hash bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT c.corner_id, a.axis_id, b.axis_id, streetgen._place_of_corner(ST_Force2D(n.geom),
            streetgen._direction_from(a.geom, c.end_a), streetgen._direction_from(b.geom, c.end_b),
            CASE WHEN twin THEN tolerance END), c.radius, h.by_hand,
        hash_record_extended(ROW(x.geom::bytea, x.width, x.width_end, x.roadway_offset, y.geom::bytea, y.width,
            y.width_end, y.roadway_offset), 0)
    FROM corner c JOIN node n USING (node_id) JOIN edge a ON a.edge_id = c.edge_a JOIN edge b ON b.edge_id = c.edge_b
        JOIN axis x ON x.axis_id = a.axis_id JOIN axis y ON y.axis_id = b.axis_id
        JOIN corner_editing h ON h.corner_id = c.corner_id, LATERAL (
            SELECT EXISTS (SELECT FROM corner t JOIN edge u ON u.edge_id = t.edge_a JOIN edge v ON v.edge_id = t.edge_b
                WHERE t.node_id = c.node_id AND t.corner_id <> c.corner_id
                    AND (u.axis_id, v.axis_id) = (a.axis_id, b.axis_id)) AS twin) w
    WHERE c.corner_id = ANY (corners);
END $$;
COMMENT ON FUNCTION streetgen._corners_to_fit(name, bigint[]) IS
    'Corners with what corner_override has of each: its axes, its place and whether one is there by hand. axes_hash is '
    'another number where one of its axes was edited.';

CREATE OR REPLACE FUNCTION streetgen._propose_corners(model name, of_axes bigint[]) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    changed constant float8 := 0.01;
    model_name constant name := model;
    run bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    WITH seen AS MATERIALIZED (SELECT * FROM streetgen._answering_arcs(model_name, of_axes)),
    answered AS MATERIALIZED (SELECT corner_id, radius, arc FROM seen WHERE corner_id IS NOT NULL),
    there AS MATERIALIZED (
        SELECT c.*, o.arc, o.observed, abs(o.observed - c.radius) AS off
        FROM (SELECT *, round(radius::numeric, 3)::float8 AS observed FROM answered) o
            JOIN streetgen._corners_to_fit(model_name, ARRAY(SELECT corner_id FROM answered)) c USING (corner_id)),
    proposed AS MATERIALIZED (SELECT * FROM there WHERE NOT by_hand AND off > changed),
    run AS (
        INSERT INTO fit_run (moves, axes, observations, used, mean_before, median_before, mean_after, median_after,
                iterations)
        SELECT 'corner', (SELECT count(*) FROM proposed), (SELECT count(*) FROM seen), count(*), avg(off),
            percentile_cont(0.5) WITHIN GROUP (ORDER BY off), avg(rest),
            percentile_cont(0.5) WITHIN GROUP (ORDER BY rest), 0
        FROM there, LATERAL (SELECT CASE WHEN by_hand THEN off ELSE 0 END AS rest) r RETURNING fit_run),
    written AS (
        INSERT INTO corner_proposal (fit_run, corner_id, axis_a, axis_b, geom, radius, before, axes_hash)
        SELECT r.fit_run, p.corner_id, p.axis_a, p.axis_b, p.arc, p.observed, p.radius, p.axes_hash
        FROM run r, proposed p ORDER BY p.corner_id)
    SELECT r.fit_run INTO run FROM run r;
    RETURN run;
END $$;
COMMENT ON FUNCTION streetgen._propose_corners(name, bigint[]) IS
    'Writes a run, and a proposal for each corner of axes (NULL: of all) that an arc of an observed kerb answers with '
    'another radius by over 1 cm, and gives the run. A corner whose radius is by hand keeps it. Distances of the run '
    'are those of radii.';

CREATE OR REPLACE FUNCTION streetgen._corners_of_run(model name, run bigint, axes bigint[], of_state text)
    RETURNS bigint[]
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    proposals := ARRAY(SELECT p.corner_proposal_id FROM corner_proposal p WHERE p.fit_run = run AND p.state = of_state
        AND (axes IS NULL OR p.axis_a = ANY (axes) OR p.axis_b = ANY (axes)) ORDER BY 1 FOR UPDATE);
    PERFORM FROM axis a WHERE EXISTS (SELECT FROM corner_proposal p WHERE p.corner_proposal_id = ANY (proposals)
        AND a.axis_id IN (p.axis_a, p.axis_b)) ORDER BY a.axis_id FOR UPDATE;
    RETURN proposals;
END $$;
COMMENT ON FUNCTION streetgen._corners_of_run(name, bigint, bigint[], text) IS
    'The proposals of a run for corners of axes (NULL: for all) that are in a state; locks them and their axes.';

CREATE OR REPLACE FUNCTION streetgen._require_unedited_corners(model name, proposals bigint[], done text)
    RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    edited bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    edited := ARRAY(SELECT DISTINCT e.axis_id FROM corner_proposal p
        LEFT JOIN streetgen._corners_to_fit(model, ARRAY(SELECT o.corner_id FROM corner_proposal o
            WHERE o.corner_proposal_id = ANY (proposals))) c USING (corner_id)
        LEFT JOIN corner_override o ON o.corner_override_id = p.corner_override_id,
        LATERAL (VALUES (p.axis_a), (p.axis_b)) e(axis_id)
        WHERE p.corner_proposal_id = ANY (proposals) AND (p.axes_hash IS DISTINCT FROM c.axes_hash
            OR CASE p.state WHEN 'accepted' THEN o.radius IS DISTINCT FROM p.radius ELSE c.by_hand END) ORDER BY 1);
    IF edited <> '{}' THEN
        RAISE EXCEPTION 'corners or axes were edited since the fit, and nothing was %', done USING ERRCODE = '55000',
            HINT = format('Leave out corners of these axes: %s. Or fit again.', streetgen._listed(edited));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_unedited_corners(name, bigint[], text) IS
    'Raises 55000 where a corner of some proposals, its radius by hand or one of its axes is not as these know it, '
    'with the ids of these axes.';

CREATE OR REPLACE FUNCTION streetgen._accept_corners(model name, run bigint, axes bigint[]) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    proposals := streetgen._corners_of_run(model, run, axes, 'proposed');
    PERFORM streetgen._require_unedited_corners(model, proposals, 'accepted');
    WITH place AS MATERIALIZED (
        SELECT p.corner_proposal_id, c.place::geometry(Point) AS place, p.axis_a, p.axis_b, p.radius
        FROM corner_proposal p JOIN streetgen._corners_to_fit(model, ARRAY(SELECT o.corner_id FROM corner_proposal o
            WHERE o.corner_proposal_id = ANY (proposals))) c USING (corner_id)
        WHERE p.corner_proposal_id = ANY (proposals)),
    written AS (
        INSERT INTO corner_override AS o (geom, axis_a, axis_b, radius)
        SELECT place, axis_a, axis_b, radius FROM place ORDER BY corner_proposal_id
        RETURNING o.corner_override_id, o.geom, o.axis_a, o.axis_b)
    UPDATE corner_proposal p SET state = 'accepted', corner_override_id = w.corner_override_id
        FROM place t JOIN written w ON (w.axis_a, w.axis_b, w.geom::bytea) = (t.axis_a, t.axis_b, t.place::bytea)
        WHERE p.corner_proposal_id = t.corner_proposal_id;
    RETURN cardinality(proposals);
END $$;
COMMENT ON FUNCTION streetgen._accept_corners(name, bigint, bigint[]) IS
    'Writes the open proposals of a run for corners of axes (NULL: for all) to corner_override, in one statement, and '
    'gives how many.';

CREATE OR REPLACE FUNCTION streetgen._reject_corners(model name, run bigint, axes bigint[]) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    proposals := streetgen._corners_of_run(model, run, axes, 'proposed');
    UPDATE corner_proposal p SET state = 'rejected' WHERE p.corner_proposal_id = ANY (proposals);
    RETURN cardinality(proposals);
END $$;
COMMENT ON FUNCTION streetgen._reject_corners(name, bigint, bigint[]) IS
    'Marks the open proposals of a run for corners of axes (NULL: for all) as rejected, and gives how many.';

CREATE OR REPLACE FUNCTION streetgen._undo_corners(model name, run bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    proposals bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    proposals := streetgen._corners_of_run(model, run, NULL, 'accepted');
    PERFORM streetgen._require_unedited_corners(model, proposals, 'undone');
    DELETE FROM corner_override o USING corner_proposal p
        WHERE p.corner_proposal_id = ANY (proposals) AND o.corner_override_id = p.corner_override_id;
    UPDATE corner_proposal p SET state = 'undone', corner_override_id = NULL
        WHERE p.corner_proposal_id = ANY (proposals);
    RETURN cardinality(proposals);
END $$;
COMMENT ON FUNCTION streetgen._undo_corners(name, bigint) IS
    'Takes the accepted proposals of a run for corners back from corner_override, in one statement, and gives how '
    'many.';
