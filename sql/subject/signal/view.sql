-- When people on foot may cross at signals, and when each signal group has green.

CREATE OR REPLACE FUNCTION streetgen._make_signal_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW signal_crossing WITH (security_invoker = true) AS
    SELECT g.controller_id, w.ordinality, g.control_point_id, g.edge_id,
        CASE WHEN w.crossed THEN 'permitted' ELSE 'protected' END AS right_of_way, p.geom, w.walk_from, w.walk_until,
        w.walk_until + g.clear AS clear_until
    FROM signal_group g JOIN control_point p USING (control_point_id) CROSS JOIN LATERAL (
        WITH turn AS (
            SELECT s.ordinality, s.kind, sum(s.duration) OVER (ORDER BY s.ordinality) AS ends, s.duration, (
                    -- Who has green here drives over the crossing, and so long after it.
                    SELECT max(i.seconds) FROM signal_movement m JOIN intergreen i ON (i.controller_id, i.ends,
                        i.begins) = (m.controller_id, m.signal_group, g.signal_group)
                    WHERE (m.controller_id, m.ordinality) = (s.controller_id, s.ordinality)) AS keeps, (
                    SELECT coalesce(bool_or(l.edge_id = g.edge_id), false)
                    FROM signal_movement m JOIN lane l ON l.lane_id = m.lane_out
                    WHERE (m.controller_id, m.ordinality) = (s.controller_id, s.ordinality)) AS crossed
            FROM signal_state s WHERE s.controller_id = g.controller_id),
        -- Where people walk in the next state too, they need not stop before it.
        stage AS (
            SELECT *, CASE WHEN coalesce(lead(keeps IS NULL) OVER w, first_value(keeps IS NULL) OVER w)
                    THEN coalesce(lead(ends - duration) OVER w, max(ends) OVER ()) ELSE ends END AS stops
            FROM turn WHERE kind IN ('green', 'walk') WINDOW w AS (ORDER BY ordinality))
        SELECT s.ordinality, s.crossed, greatest(s.ends - s.duration, max(t.ends + t.keeps
                - CASE WHEN t.ordinality > s.ordinality THEN whole ELSE 0 END)) AS walk_from,
            least(s.stops, min(t.ends - t.duration + CASE WHEN t.ordinality < s.ordinality THEN whole ELSE 0 END)
                - g.clear) AS walk_until
        FROM stage s LEFT JOIN turn t ON t.keeps IS NOT NULL CROSS JOIN (SELECT max(ends) AS whole FROM turn) c
        WHERE s.keeps IS NULL
        GROUP BY s.ordinality, s.crossed, s.ends, s.duration, s.stops) w
    WHERE g.kind = 'walk' AND w.walk_until - w.walk_from
        >= (SELECT value::float8 FROM setting WHERE name = 'walk_shortest') - 1e-6;
    COMMENT ON VIEW signal_crossing IS
        'The states of a controller in which people on foot may cross a street of its junction: nobody has green '
        'there to drive in, or straight out; who turns into the street gives way to them (permitted). Who steps on by '
        'walk_until is across before somebody drives over the crossing; seconds count from the start of the cycle';
    COMMENT ON COLUMN signal_crossing.controller_id IS 'the controller';
    COMMENT ON COLUMN signal_crossing.ordinality IS 'the state';
    COMMENT ON COLUMN signal_crossing.control_point_id IS 'the crossing: a control point';
    COMMENT ON COLUMN signal_crossing.edge_id IS 'the street that is crossed';
    COMMENT ON COLUMN signal_crossing.right_of_way IS 'protected, or permitted: who turns into the street gives way';
    COMMENT ON COLUMN signal_crossing.geom IS 'the place of the control point';
    COMMENT ON COLUMN signal_crossing.walk_from IS 'who drove over the crossing has left it: people may step on';
    COMMENT ON COLUMN signal_crossing.walk_until IS 'nobody steps on any more';
    COMMENT ON COLUMN signal_crossing.clear_until IS 'who stepped on last is across';
    CREATE OR REPLACE VIEW signal_green WITH (security_invoker = true) AS
    SELECT m.controller_id, m.signal_group, m.ordinality, s.ends - s.duration AS green_from, s.ends AS green_until
    FROM (SELECT DISTINCT controller_id, signal_group, ordinality FROM signal_movement) m
        JOIN (SELECT t.*, sum(duration) OVER (PARTITION BY controller_id ORDER BY ordinality) AS ends
            FROM signal_state t) s USING (controller_id, ordinality)
    UNION ALL
    SELECT g.controller_id, g.signal_group, c.ordinality, c.walk_from, c.walk_until
    FROM signal_group g JOIN signal_crossing c USING (controller_id, control_point_id, edge_id);
    COMMENT ON VIEW signal_green IS
        'When each signal group has green: seconds from the start of the cycle; people on foot: when they may step on';
    COMMENT ON COLUMN signal_green.controller_id IS 'the controller';
    COMMENT ON COLUMN signal_green.signal_group IS 'the signal group';
    COMMENT ON COLUMN signal_green.ordinality IS 'the state';
    COMMENT ON COLUMN signal_green.green_from IS 'it begins';
    COMMENT ON COLUMN signal_green.green_until IS 'it ends, and amber follows where the group is traffic';
END $$;
COMMENT ON FUNCTION streetgen._make_signal_views(name) IS
    'Makes the views of a model that computes signals, again and again.';

CREATE OR REPLACE FUNCTION streetgen._signal_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('signal_green'::name, 'signal'), ('signal_crossing', 'signal') $$;
COMMENT ON FUNCTION streetgen._signal_view() IS
    'Views of signals, each before those that it reads, and the subjects whose tables they read.';
