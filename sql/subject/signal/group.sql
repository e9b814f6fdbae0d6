-- Signal groups, and the times between their greens.

CREATE OR REPLACE FUNCTION streetgen._intergreens(movements streetgen.signal_request[], cycle float8, all_red float8,
    step float8, walk float8, importance integer, turn_phases boolean)
    RETURNS TABLE(ends integer, begins integer, ends_on_foot boolean, begins_on_foot boolean, seconds float8)
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100 ROWS 50 AS 'MODULE_PATHNAME', 'streetgen_intergreens';
COMMENT ON FUNCTION streetgen._intergreens(streetgen.signal_request[], float8, float8, float8, float8, integer,
    boolean) IS
    'The seconds from the end of one green to the start of another one, of movements (their numbers from 1) that meet, '
    'and of movements and crossings on foot that they drive over. Arguments and errors are those of signal_phases.';

CREATE OR REPLACE FUNCTION streetgen._make_update_signal_groups(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _update_signal_groups(known bigint[], asked streetgen.signal_asked[],
        answered streetgen.signal_found[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
            -- Nothing is known of rows just computed: joins are on equal keys.
            SET enable_nestloop = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        RETURN QUERY WITH traffic AS MATERIALIZED (
            SELECT DISTINCT f.controller_id, f.signal_group, m.approach AS edge_id
            FROM unnest(asked) a, unnest(a.movements) m
                JOIN unnest(answered) f USING (lane_in, lane_out, along_in, along_out)),
        counted AS (SELECT controller_id, max(signal_group) AS traffic FROM traffic GROUP BY controller_id),
        new AS MATERIALIZED (
            SELECT controller_id, signal_group, 'traffic' AS kind, edge_id, NULL::bigint AS control_point_id,
                NULL::float8 AS clear FROM traffic
            UNION ALL
            -- People on foot are counted after all traffic.
            SELECT a.junction_id, t.traffic + c.walk::integer, 'walk', c.edge_id, c.control_point_id, c.clear
            FROM unnest(asked) a JOIN counted t ON t.controller_id = a.junction_id,
                unnest(a.control_points, a.crossed, a.clear) WITH ORDINALITY c(control_point_id, edge_id, clear,
                    walk)),
        there AS (SELECT * FROM signal_group WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM signal_group o USING there t WHERE (o.controller_id, o.signal_group) = (t.controller_id,
            t.signal_group) AND NOT EXISTS (SELECT FROM new n WHERE (n.controller_id, n.signal_group)
                = (t.controller_id, t.signal_group)) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, (t.kind, t.edge_id, t.control_point_id, t.clear)
                IS DISTINCT FROM (n.kind, n.edge_id, n.control_point_id, n.clear) AS changed
            FROM new n LEFT JOIN there t USING (controller_id, signal_group)),
        put AS (INSERT INTO signal_group (controller_id, signal_group, kind, edge_id, control_point_id, clear)
            SELECT controller_id, signal_group, kind, edge_id, control_point_id, clear FROM compared WHERE changed
            ORDER BY 1, 2
            ON CONFLICT (controller_id, signal_group) DO UPDATE SET (kind, edge_id, control_point_id, clear)
                = ROW (excluded.kind, excluded.edge_id, excluded.control_point_id, excluded.clear))
        SELECT 'signal_group', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
        RETURN QUERY WITH member AS MATERIALIZED (
            SELECT DISTINCT f.controller_id, f.signal_group, m.number::integer AS number
            FROM unnest(asked) a, unnest(a.movements) WITH ORDINALITY m(lane_in, lane_out, along_in, along_out,
                    approach, exit, turn, length, speed, lanes, importance, flow, precedence, conflicts, reaches,
                    walks, walk_seconds, walk_reaches, number)
                JOIN unnest(answered) f USING (lane_in, lane_out, along_in, along_out)),
        counted AS (SELECT controller_id, max(signal_group) AS traffic FROM member GROUP BY controller_id),
        rule AS (SELECT max(value) FILTER (WHERE name = 'signal_step')::float8 AS step,
            max(value) FILTER (WHERE name = 'walk_shortest')::float8 AS walk FROM setting),
        new AS MATERIALIZED (
            SELECT c.controller_id, CASE WHEN i.ends_on_foot THEN c.traffic + i.ends ELSE e.signal_group END AS ends,
                CASE WHEN i.begins_on_foot THEN c.traffic + i.begins ELSE b.signal_group END AS begins,
                max(i.seconds) AS seconds
            FROM unnest(asked) a JOIN counted c ON c.controller_id = a.junction_id CROSS JOIN rule
                CROSS JOIN LATERAL streetgen._intergreens(a.movements, 120, 6, rule.step, rule.walk, 1, NULL) i
                LEFT JOIN member e ON NOT i.ends_on_foot AND (e.controller_id, e.number) = (c.controller_id, i.ends)
                LEFT JOIN member b ON NOT i.begins_on_foot
                    AND (b.controller_id, b.number) = (c.controller_id, i.begins)
            WHERE e.signal_group IS DISTINCT FROM b.signal_group GROUP BY 1, 2, 3),
        there AS (SELECT * FROM intergreen WHERE controller_id = ANY (known)),
        gone AS (DELETE FROM intergreen o USING (
                SELECT controller_id, ends, begins FROM there EXCEPT SELECT controller_id, ends, begins FROM new) t
            WHERE (o.controller_id, o.ends, o.begins) = (t.controller_id, t.ends, t.begins) RETURNING 1),
        compared AS (SELECT n.*, t.controller_id IS NULL AS fresh, t.seconds IS DISTINCT FROM n.seconds AS changed
            FROM new n LEFT JOIN there t USING (controller_id, ends, begins)),
        put AS (INSERT INTO intergreen (controller_id, ends, begins, seconds)
            SELECT controller_id, ends, begins, seconds FROM compared WHERE changed ORDER BY 1, 2, 3
            ON CONFLICT (controller_id, ends, begins) DO UPDATE SET seconds = excluded.seconds)
        SELECT 'intergreen', count(*) FILTER (WHERE fresh), count(*) FILTER (WHERE changed AND NOT fresh),
            (SELECT count(*) FROM gone), count(*) FILTER (WHERE NOT changed), 0::bigint FROM compared;
    END $body$;
    PERFORM streetgen._own_function(model,
        '_update_signal_groups(bigint[], streetgen.signal_asked[], streetgen.signal_found[])',
        'Brings the signal groups of controllers, as they are and were, up to date, and the times between them');
END $$;
COMMENT ON FUNCTION streetgen._make_update_signal_groups(name) IS
    'Makes the function of a model that writes signal groups and the times between their greens.';
