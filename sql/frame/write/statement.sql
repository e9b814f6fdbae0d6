-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{former
-- Rows as they are before the change. OFFSET 0: each is looked up by its key, and not joined.
former_edge AS MATERIALIZED (
    SELECT e.axis_id, e.from_node, e.to_node, e.start_abscissa, e.end_abscissa, ST_Force2D(e.geom)::bytea AS geom,
           s.wanted_abscissa AS wanted_start, s.abscissa AS start, s.border_line::bytea AS border_start,
           t.wanted_abscissa AS wanted_end, t.abscissa AS "end", t.border_line::bytea AS border_end, c.surface::bytea,
               c.contested_area > 0 AS contested, c.level,
           coalesce(streetgen._numbers_sent(c.borders), '') AS borders, e.beside_left, e.beside_right,
           CASE cardinality(e.median_left) WHEN 0 THEN '' ELSE streetgen._numbers_sent(e.median_left) END
               AS median_left,
           CASE cardinality(e.median_right) WHEN 0 THEN '' ELSE streetgen._numbers_sent(e.median_right) END
               AS median_right
    FROM {model}.edge e,
        LATERAL (SELECT * FROM {model}.section_limit s WHERE (s.edge_id, s.which) = (e.edge_id, 'start') OFFSET 0) s,
        LATERAL (SELECT * FROM {model}.section_limit t WHERE (t.edge_id, t.which) = (e.edge_id, 'end') OFFSET 0) t,
        LATERAL (SELECT * FROM {model}.section c WHERE c.edge_id = e.edge_id OFFSET 0) c
    WHERE NOT {whole} AND e.axis_id = ANY ($1)),
former_node AS MATERIALIZED (
    SELECT n.node_id, n.geom, i.surface, i.contested_area, i.level
    FROM (SELECT from_node AS node_id FROM former_edge UNION SELECT to_node FROM former_edge) e,
        LATERAL (SELECT * FROM {model}.node n WHERE n.node_id = e.node_id OFFSET 0) n,
        LATERAL (SELECT * FROM {model}.intersection i WHERE i.node_id = e.node_id OFFSET 0) i)

--{input
setting AS MATERIALIZED (SELECT jsonb_object_agg(name, value) AS v FROM {model}.setting),
-- The hash only of those that are written. IN (SELECT …): looked up by hash, where ANY of an array goes through it
-- axis by axis.
used AS MATERIALIZED (
    SELECT axis_id, geom, level, width, width_end, roadway_offset, lane_count, lanes_forward, lanes_backward,
        lanes_both, kind_forward,
        kind_backward,
           lane_width_forward, lane_width_backward, lane_width_maximal, turn_forward, turn_backward, access,
           on_ring, street, sidewalk_left, sidewalk_right, speed,
           importance, radius, direction, estimated, area,
               CASE WHEN {whole} OR axis_id IN (SELECT unnest($1)) THEN input_hash END AS input_hash, setting_hash
    FROM {model}.axis_used WHERE {whole} OR axis_id = ANY ($2)),
{rings}
computed AS MATERIALIZED (
    SELECT streetgen._streets({srid},
        settings => (
            -- A path by a function of the user is drawn below.
            SELECT v || jsonb_build_object('trajectory', CASE v ->> 'trajectory' WHEN 'arcs' THEN 'arcs'
                ELSE 'bezier' END) FROM setting),
        axes => (
            SELECT array_agg(ROW (
                axis_id, ST_Force2D(geom)::bytea, level, width, width_end, roadway_offset, radius, importance, speed,
                lanes_forward, lanes_backward, lanes_both, kind_forward, kind_backward, lane_width_forward,
                    lane_width_backward, lane_width_maximal, turn_forward, turn_backward, access, on_ring, street,
                {whole} OR axis_id IN (SELECT unnest($3)) {or_turned}, input_hash IS NULL, area::bytea
                )::streetgen.street_axis ORDER BY axis_id)
            FROM used),
        controls => (
            SELECT array_agg(ROW (axis_id, abscissa, kind, direction)::streetgen.street_control
                ORDER BY control_point_id)
            FROM (SELECT control_point_id, axis_id, abscissa, kind, direction FROM {model}.control_point
                WHERE {whole} AND axis_id IS NOT NULL OR axis_id = ANY ($2) {yields}) c),
        former_edges => (
            SELECT array_agg(ROW (axis_id, start_abscissa, end_abscissa, geom, wanted_start, start, border_start,
                wanted_end, "end", border_end, surface, contested, level, borders, beside_left,
                beside_right, median_left, median_right)::streetgen.former_edge)
            FROM former_edge),
        former_nodes => (
            SELECT array_agg(ROW (ST_X(geom), ST_Y(geom), surface::bytea,
                contested_area > 0, level)::streetgen.former_node)
            FROM former_node),
        may_spread => NOT {edit}, subjects => string_to_array('{subjects}', ','),
        {arguments}) AS streets)

--{report
new_report AS MATERIALIZED (
    SELECT DISTINCT issue, axis_a, axis_b, measure, geom FROM streetgen._computed_report((SELECT streets FROM computed))
    WHERE {whole} OR axis_a IN (SELECT axis_id FROM written_axis) OR axis_b IN (SELECT axis_id FROM written_axis)),
old_report AS MATERIALIZED (
    SELECT issue, axis_a, axis_b, measure, geom, ctid AS place FROM {model}.report
    WHERE {whole} OR axis_a = ANY (ARRAY(SELECT axis_id FROM written_axis))
        OR axis_b = ANY (ARRAY(SELECT axis_id FROM written_axis))),
set_report AS (
    INSERT INTO {model}.report (issue, axis_a, axis_b, measure, geom)
    SELECT issue, axis_a, axis_b, measure, geom FROM new_report
        EXCEPT SELECT issue, axis_a, axis_b, measure, geom FROM old_report RETURNING 1),
gone_report AS (
    DELETE FROM {model}.report WHERE ctid = ANY (ARRAY(
        SELECT place FROM old_report o WHERE NOT EXISTS (
            SELECT FROM new_report n WHERE (n.issue, n.axis_a, n.axis_b, n.measure, n.geom) = (o.issue, o.axis_a,
                o.axis_b, o.measure, o.geom))))
    RETURNING 1)

--{compared
new_{relation} AS MATERIALIZED (
    SELECT {stored} FROM (
        SELECT old.{id} IS NULL AS fresh, ({old_columns}) IS DISTINCT FROM ({new_columns}) AS changed, {id_there}n.*
        FROM ({rows}
            ) n LEFT JOIN LATERAL (SELECT * FROM {model}.{relation} o WHERE NOT {empty}
                AND ({same_there}) = ({same_new})

--{there
,
gone_{relation} AS (
    -- A run over a whole model looks at every row only where one is too many.
    DELETE FROM {model}.{relation} WHERE NOT {empty}
        AND (NOT {whole} OR (SELECT count(*) FROM {model}.{relation}) > (SELECT updated + unchanged
        FROM count_{relation})) AND {id} = ANY (ARRAY(
        SELECT {id} FROM ({there}) t WHERE {id} NOT IN (SELECT {id} FROM new_{relation} WHERE NOT fresh)))
            RETURNING {id})
