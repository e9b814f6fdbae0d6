-- When people on foot may cross at signals.

CREATE OR REPLACE FUNCTION streetgen._make_signal_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW signal_crossing WITH (security_invoker = true) AS
    SELECT s.controller_id, s.ordinality, c.control_point_id, c.edge_id,
        CASE WHEN p.crossed THEN 'permitted' ELSE 'protected' END AS right_of_way, c.geom
    FROM junction_crossing c JOIN signal_state s ON s.controller_id = c.junction_id
        CROSS JOIN LATERAL (
            SELECT coalesce(bool_or(o.edge_id = c.edge_id), false) AS crossed,
                coalesce(bool_or(i.edge_id = c.edge_id OR o.edge_id = c.edge_id AND w.turn = 'through'
                    OR c.inside AND ST_DWithin(w.geom, c.geom, c.width / 2)), false) AS taken
            FROM signal_movement m JOIN lane i ON i.lane_id = m.lane_in JOIN lane o ON o.lane_id = m.lane_out
                -- Each movement is looked up by its lanes, however many the planner expects.
                CROSS JOIN LATERAL (SELECT w.turn, w.geom FROM movement w
                    WHERE (w.lane_in, w.lane_out, w.along_in, w.along_out)
                        = (m.lane_in, m.lane_out, m.along_in, m.along_out) OFFSET 0) w
            WHERE (m.controller_id, m.ordinality) = (s.controller_id, s.ordinality)) p
    WHERE CASE s.kind WHEN 'green' THEN NOT p.taken WHEN 'all_red' THEN s.duration >= c.seconds ELSE false END;
    COMMENT ON VIEW signal_crossing IS
        'The states of a controller in which people on foot may cross a street of its junction: nobody has green '
        'there to drive in, or straight out; who turns into the street gives way to them (permitted)';
    COMMENT ON COLUMN signal_crossing.controller_id IS 'the controller';
    COMMENT ON COLUMN signal_crossing.ordinality IS 'the state';
    COMMENT ON COLUMN signal_crossing.control_point_id IS 'the crossing: a control point';
    COMMENT ON COLUMN signal_crossing.edge_id IS 'the street that is crossed';
    COMMENT ON COLUMN signal_crossing.right_of_way IS 'protected, or permitted: who turns into the street gives way';
    COMMENT ON COLUMN signal_crossing.geom IS 'the place of the control point';
END $$;
COMMENT ON FUNCTION streetgen._make_signal_views(name) IS
    'Makes the views of a model that computes signals, again and again.';

CREATE OR REPLACE FUNCTION streetgen._signal_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('signal_crossing'::name, 'signal') $$;
COMMENT ON FUNCTION streetgen._signal_view() IS
    'Views of signals, and the subjects whose tables they read.';
