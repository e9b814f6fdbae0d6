-- A log of drives, street by street.

CREATE OR REPLACE FUNCTION streetgen._summarized_drive(model name, samples regclass, mapping jsonb, stretch float8,
    names text[])
    RETURNS TABLE(actor text, name text, axis_id bigint, starts float8, ends float8, sample_count bigint,
        seconds float8, mean_speed float8, greatest_over_limit float8, mean_offset float8, offset_deviation float8,
        least_gap float8, least_time_to_collision float8, lane_changes bigint)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('samples', samples::text, 'mapping',
        mapping::text), streetgen._require_subject(model, 'interconnection');
    IF NOT stretch BETWEEN 1 AND 1e6 THEN
        RAISE EXCEPTION 'stretch is %, expected 1 to 1,000,000 metres', stretch USING ERRCODE = '22023',
            HINT = 'NULL gives a row for each street by its name.';
    END IF;
    RETURN QUERY WITH driven AS MATERIALIZED (
        SELECT r.*, coalesce(k.lane_id, k.lane_in) AS lane_id, lead(r.t) OVER w - r.t AS until_next,
            CASE WHEN k.kind = 'lane' THEN lag(k.lane_id) OVER w END AS lane_before
        FROM streetgen.drive_report(model, samples, mapping) r LEFT JOIN link k ON k.link_id = r.link
        WHERE coalesce(r.finding, '') NOT IN ('no_time', 'twice') WINDOW w AS (PARTITION BY r.actor ORDER BY r.t)),
    placed AS (
        SELECT d.*, a.axis_id, a.name, e.start_abscissa + ST_LineLocatePoint(e.geom, d.geom)
                * (e.end_abscissa - e.start_abscissa) AS abscissa,
            -- A drive on to the next edge changes no lane, nor does one to where a lane of the same number begins.
            b.edge_id = l.edge_id AND b.lane_position <> l.lane_position AS changed
        FROM driven d LEFT JOIN lane l USING (lane_id) LEFT JOIN edge e USING (edge_id) LEFT JOIN axis a USING (axis_id)
            LEFT JOIN lane b ON b.lane_id = d.lane_before
        WHERE names IS NULL OR a.name = ANY (names)),
    grouped AS (
        SELECT p.*, CASE WHEN stretch IS NOT NULL OR p.name IS NULL THEN p.axis_id END AS axis,
            CASE WHEN p.axis_id IS NOT NULL THEN stretch * floor(p.abscissa / stretch) END AS start
        FROM placed p)
    SELECT g.actor, g.name, g.axis, g.start, g.start + stretch, count(*), sum(g.until_next),
        -- By time; a sample alone has none.
        coalesce(sum(g.speed * g.until_next) / nullif(sum(g.until_next) FILTER (WHERE g.speed IS NOT NULL), 0),
            avg(g.speed)), max(g.over_limit), avg(g.lane_offset), stddev_pop(g.lane_offset), min(g.gap),
        min(g.time_to_collision), count(*) FILTER (WHERE g.changed)
    FROM grouped g GROUP BY g.actor, g.name, g.axis, g.start ORDER BY g.actor, min(g.t), g.name, g.axis, g.start;
END $$;
COMMENT ON FUNCTION streetgen._summarized_drive(name, regclass, jsonb, float8, text[]) IS
    'What streetgen.drive_summary gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.drive_summary(model name, samples regclass, mapping jsonb DEFAULT '{}',
    stretch float8 DEFAULT NULL, names text[] DEFAULT NULL)
    RETURNS TABLE(actor text, name text, axis_id bigint, starts float8, ends float8, sample_count bigint,
        seconds float8, mean_speed float8, greatest_over_limit float8, mean_offset float8, offset_deviation float8,
        least_gap float8, least_time_to_collision float8, lane_changes bigint)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._summarized_drive($1, $2, $3, $4, $5) $$;
COMMENT ON FUNCTION streetgen.drive_summary(name, regclass, jsonb, float8, text[]) IS
    'A log of drives, samples with a mapping as streetgen.drive_report takes them, street by street: a row for each '
    'actor and name of a street, in the order of the drive, or where stretch is given for each stretch of so many '
    'metres along an axis. A street without name has axis_id; who is off the road has neither. names: these streets '
    'alone. seconds: from each sample to the next one of the actor. mean_speed and greatest_over_limit: km/h. '
    'mean_offset and offset_deviation: of metres to the left of the middle of lanes, and their standard deviation. '
    'least_gap: metres, least_time_to_collision: seconds. lane_changes: to another lane of an edge, between two '
    'samples on lanes. A sample without time, or of a time of which another one counts, is left out. A stretch that is '
    'not 1 to 1,000,000 m: 22023; else as drive_report. Campos, section 3.4.';
