-- Arcs in lines, and the paper's method of roundabout candidates over a whole model.

CREATE OR REPLACE FUNCTION streetgen.roundabout_candidates(model name, eps float8 DEFAULT 40,
    "least" integer DEFAULT 4)
    RETURNS TABLE(number bigint, centre geometry, radius float8, support bigint, axis_ids bigint[], arcs geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('eps', eps::text, 'least', "least"::text);
    IF NOT (eps > 0 AND eps <= 1000) OR "least" NOT BETWEEN 1 AND 9999 THEN
        RAISE EXCEPTION 'eps is % and least is %, out of range', eps, "least" USING ERRCODE = '22023',
            HINT = 'eps goes up to 1000 m and is above 0, least goes from 1 to 9999.';
    END IF;
    RETURN QUERY
    WITH found AS MATERIALIZED (
        SELECT a.axis_id, a.level, d.* FROM axis a, streetgen.detect_arcs(ST_Force2D(a.geom), tolerance => 1) d),
    -- Each quadruplet of successive points on an arc is a circle of its own; an arc has support - 3.
    circle AS (SELECT f.*, n FROM found f, generate_series(4, support) n),
    clustered AS (
        SELECT c.*, ST_ClusterDBSCAN(c.centre, eps, "least")
            OVER (PARTITION BY c.level ORDER BY c.axis_id, ST_X(c.centre), ST_Y(c.centre), n
                ROWS BETWEEN UNBOUNDED PRECEDING AND UNBOUNDED FOLLOWING) AS cluster
        FROM circle c),
    -- Circles about nearly one centre are of one roundabout where their radii differ by less than a quarter.
    stepped AS (
        SELECT c.*, coalesce(c.radius > 1.25 * lag(c.radius) OVER by_radius, false)::integer AS step
        FROM clustered c WHERE cluster IS NOT NULL
        WINDOW by_radius AS (PARTITION BY level, cluster ORDER BY c.radius, axis_id, n)),
    split AS (
        SELECT s.*, sum(step) OVER (PARTITION BY level, cluster ORDER BY s.radius, axis_id, n) AS part FROM stepped s)
    SELECT row_number() OVER (ORDER BY count(*) DESC, min(s.axis_id), part),
        ST_SetSRID(ST_MakePoint(avg(ST_X(s.centre)), avg(ST_Y(s.centre))), min(ST_SRID(s.centre))), avg(s.radius),
            count(*),
        array_agg(DISTINCT s.axis_id), ST_Collect(s.arc ORDER BY s.axis_id) FILTER (WHERE n = 4)
    FROM split s GROUP BY level, cluster, part;
END $$;
COMMENT ON FUNCTION streetgen.roundabout_candidates(name, float8, integer) IS
    'Places of a model that may be roundabouts by the method of the paper: circles through quadruplets of successive '
    'points of the axes, their centres clustered (ST_ClusterDBSCAN: eps in metres, least centres) level by level, each '
    'cluster split where radii differ by a quarter. number: 1 for the one with the most circles; centre and radius '
    '(metres): means; support: how many circles; arcs: their CIRCULARSTRINGs, collected. A list to '
    'work through by eye: nothing of the model changes, and table roundabout does without. eps up to 1000, least from '
    '1 to 9999; else 22023. An unknown model: 3F000. StreetGen paper, 2.8, which has 40 m and 4.';
