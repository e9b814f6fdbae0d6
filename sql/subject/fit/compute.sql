-- Distances to the kerbs observed, after a run: they read the sections that the one statement wrote.

CREATE OR REPLACE FUNCTION streetgen._fit_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES (80, 'kerb_distance', 'fit', 'kerb_distance_id', 'edge_id, side', 'kerb_distance'::name, 1) $$;
COMMENT ON FUNCTION streetgen._fit_computed_table() IS 'The computed table of the fit.';

CREATE OR REPLACE FUNCTION streetgen._taken_points(model name, axes bigint[], kerbs_alone boolean)
    RETURNS TABLE(observation_id bigint, fate text, edge_id bigint, aside float8, off float8, place geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    model_name constant name := model;
    of_axes constant bigint[] := axes;
    only_kerbs constant boolean := kerbs_alone;
    grid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    -- Most models have none, and edits of streets ask.
    IF NOT EXISTS (SELECT FROM observation) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH given AS MATERIALIZED (SELECT * FROM streetgen._fit_axes(model_name, of_axes)),
    seen AS MATERIALIZED (SELECT * FROM streetgen._fit_observations(model_name, of_axes, only_kerbs)),
    first AS (
        SELECT axis, min(k) AS k FROM given, unnest(stretch_axes) WITH ORDINALITY s(axis, k) GROUP BY axis)
    SELECT s.observation_ids[t.number], t.fate, g.edges[f.k + t.stretch - 1], t.aside, t.off,
        ST_SetSRID(ST_MakePoint(s.x[t.number], s.y[t.number]), grid)
    FROM given g CROSS JOIN seen s CROSS JOIN LATERAL streetgen._taken_observations(g.lines, g.widths, g.lanes, g.moves,
            g.stretch_axes, g.stretches, g.nodes, s.kinds, s.relations, s.x, s.y, s.confidence, s.weight, s.width,
            streetgen._fit_rules(model_name, false), 'cauchy') t
        LEFT JOIN first f ON f.axis = t.axis;
END $$;
COMMENT ON FUNCTION streetgen._taken_points(name, bigint[], boolean) IS
    'Each point of an observation near axes (NULL: of all) with the edge that takes it: fate is taken, no street, at '
    'junction or not sure; aside from the axis, left positive, and off beyond the kerb of that side are metres.';

CREATE OR REPLACE FUNCTION streetgen._update_fit(model name, axes bigint[], moved streetgen.moved_row[],
    noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
        SET streetgen.computes = 'on'
    AS $$
#variable_conflict use_column
DECLARE
    of_axes constant bigint[] := axes;
    model_name constant name := model;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH region AS MATERIALIZED (
        SELECT edge_id FROM edge WHERE of_axes IS NULL OR axis_id = ANY (of_axes)),
    new AS MATERIALIZED (
        SELECT p.edge_id, CASE WHEN p.aside >= 0 THEN 'left' ELSE 'right' END AS side, count(*) AS observations,
            avg(abs(p.off) ORDER BY abs(p.off)) AS mean,
            percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(p.off)) AS median
        FROM streetgen._taken_points(model_name, of_axes, true) p JOIN region USING (edge_id)
        WHERE p.fate = 'taken' GROUP BY 1, 2),
    drawn AS MATERIALIZED (
        SELECT n.*, b.geom FROM new n JOIN edge e USING (edge_id), LATERAL (
            SELECT streetgen._side_of(ST_Force2D(e.geom), CASE n.side WHEN 'left' THEN (e.width + e.width_end) / 4
                + e.roadway_offset ELSE e.roadway_offset - (e.width + e.width_end) / 4 END) AS geom) b),
    compared AS MATERIALIZED (
        SELECT n.*, k.edge_id IS NULL AS fresh, (k.observations, k.mean, k.median, k.geom::bytea) IS DISTINCT FROM
            (n.observations, n.mean, n.median, n.geom::bytea) AS changed
        FROM drawn n LEFT JOIN kerb_distance k USING (edge_id, side)),
    gone AS (
        DELETE FROM kerb_distance k USING region r WHERE r.edge_id = k.edge_id AND NOT EXISTS (SELECT FROM new n
            WHERE (n.edge_id, n.side) = (k.edge_id, k.side)) RETURNING k.edge_id),
    put AS (
        INSERT INTO kerb_distance (edge_id, side, observations, mean, median, geom)
        SELECT edge_id, side, observations, mean, median, geom FROM compared WHERE changed ORDER BY edge_id, side
        ON CONFLICT (edge_id, side) DO UPDATE SET (observations, mean, median, geom)
            = ROW (excluded.observations, excluded.mean, excluded.median, excluded.geom))
    SELECT 'kerb_distance', count(*) FILTER (WHERE c.fresh), count(*) FILTER (WHERE c.changed AND NOT c.fresh),
        (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT c.changed), 0::bigint FROM compared c;
END $$;
COMMENT ON FUNCTION streetgen._update_fit(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the distances of their kerbs to those observed '
    'up to date.';

CREATE OR REPLACE FUNCTION streetgen._side_of(line geometry, aside float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN GeometryType(beside) = 'LINESTRING' AND NOT ST_IsEmpty(beside) THEN beside ELSE line END
        FROM ST_OffsetCurve(line, aside) beside $$;
COMMENT ON FUNCTION streetgen._side_of(geometry, float8) IS
    'The line so many metres to the left of another one (LINESTRING each); where there is no such line that line.';
