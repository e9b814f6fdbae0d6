-- The columns of an axis may contradict each other: check_model and the report of an import tell.

CREATE OR REPLACE FUNCTION streetgen._contradictions(model name, said_by text DEFAULT NULL)
    RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
        SET plan_cache_mode = force_custom_plan
    AS $$
DECLARE
    origin constant text COLLATE "default" := said_by;
    of_lanes bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- To compute the values used of all axes costs more than of those that say something of lanes.
    of_lanes := ARRAY(SELECT a.axis_id FROM axis a WHERE (origin IS NULL OR a.source = origin)
        AND num_nonnulls(a.lane_count, a.lanes_forward, a.lanes_backward, a.kind_forward, a.kind_backward,
            a.lane_width_forward, a.lane_width_backward, a.turn_forward, a.turn_backward, a.change_forward,
            a.change_backward) > 0);
    RETURN QUERY WITH used AS MATERIALIZED (
        -- Without the radius, so that a predictor of the user's is not asked.
        SELECT axis_id, width, width_end, lane_count, lanes_forward, lanes_backward FROM axis_used
        WHERE axis_id = ANY (of_lanes)),
    said AS NOT MATERIALIZED (SELECT * FROM axis WHERE origin IS NULL OR source = origin),
    listed AS MATERIALIZED (
        SELECT axis_id, a.geom, w.*, streetgen.driving_lanes(w.kinds) AS of_kinds
        FROM used u JOIN said a USING (axis_id),
        LATERAL (VALUES (a.kind_forward, a.lane_width_forward, a.turn_forward, a.change_forward, a.lanes_forward,
                u.lanes_forward, a.direction = 'reverse'),
            (a.kind_backward, a.lane_width_backward, a.turn_backward, a.change_backward, a.lanes_backward,
                u.lanes_backward, a.direction = 'direct')) w(kinds, widths, turns, changes, stated, used, closed)
        WHERE coalesce(w.kinds, w.widths, w.turns, w.changes, w.stated::text) IS NOT NULL)
    SELECT 'notice', 'lanes for both directions of a one-way street, not taken', 'axis', axis_id, lanes_both::float8,
        geom::geometry FROM said WHERE direction <> 'both' AND lanes_both > 0
    UNION ALL
    SELECT 'notice', 'lane_count is not that of the directions, which count', 'axis', axis_id, a.lane_count, a.geom
        FROM said a JOIN used u USING (axis_id) WHERE a.lane_count <> u.lane_count
    UNION ALL
    SELECT 'notice', 'lanes against a one-way street, not taken', 'axis', axis_id, stated, geom FROM listed
        WHERE closed AND stated > 0 AND kinds IS NULL
    UNION ALL
    SELECT 'notice', 'number of lanes is not that of their kinds, which count', 'axis', axis_id, stated, geom
        FROM listed WHERE stated <> of_kinds
    UNION ALL
    SELECT 'notice', what || ' are not those of all lanes, not taken', 'axis', axis_id, entries, geom
        FROM listed, LATERAL (VALUES ('widths', widths), ('turns', turns), ('changes', changes)) v(what, list),
            LATERAL (SELECT cardinality(string_to_array(list, '|')) AS entries) n
        WHERE entries NOT IN (used, coalesce(cardinality(string_to_array(kinds, '|')), used))
    UNION ALL
    SELECT 'notice', 'lanes wider than their street, m', 'axis', axis_id, together, a.geom
        FROM used u JOIN said a USING (axis_id),
            LATERAL (SELECT sum(nullif(entry, '')::float8) AS together
                FROM unnest(string_to_array(a.lane_width_forward, '|')
                    || string_to_array(a.lane_width_backward, '|')) entry) w
        WHERE coalesce(a.lane_width_forward, a.lane_width_backward) IS NOT NULL
            AND together > greatest(u.width, u.width_end) + 0.1
    UNION ALL
    SELECT 'notice', 'width that no street has, m', 'axis', axis_id, greatest(width, width_end), geom FROM said
        WHERE greatest(width, width_end) > 50 AND lane_count IS NULL
    UNION ALL
    SELECT 'notice', 'speed that no street has, km/h', 'axis', axis_id, speed, geom FROM said
        WHERE speed > 200 OR speed < 1;
END $$;
COMMENT ON FUNCTION streetgen._contradictions(name, text) IS
    'The axes of a model, or of one source, whose columns contradict each other or cannot be, as rows of check_model.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('lanes for both directions of a one-way street, not taken',
        '`lanes_both` counts only where both directions are open',
        'correct `direction` or `lanes_both`'),
    ('lane_count is not that of the directions, which count', 'the sum of both directions differs',
        'correct `lane_count`'),
    ('lanes against a one-way street, not taken',
        'a closed direction has only lanes that `kind_backward` or `kind_forward` names',
        'name the kinds, or correct the direction'),
    ('number of lanes is not that of their kinds, which count', 'number and list differ', 'correct either'),
    ('widths are not those of all lanes, not taken', 'the list of widths has another length than the lanes',
        'correct the list'),
    ('turns are not those of all lanes, not taken', 'the list of turns has another length than the lanes',
        'correct the list'),
    ('changes are not those of all lanes, not taken',
        'the list of who may leave a lane has another length than the lanes', 'correct the list'),
    ('lanes wider than their street, m', 'the widths of single lanes are more than the roadway has',
        'correct `width`, or the lists of widths'),
    ('width that no street has, m',
        'the roadway is over 50 m wide, no number of lanes says so, and it is taken as it is',
        'correct `width`, or the unit of its column in the mapping; or state `lane_count`'),
    ('speed that no street has, km/h', 'the speed is below 1 or beyond 200 km/h, and is taken as it is',
        'correct `speed`, or the unit of its column in the mapping');
