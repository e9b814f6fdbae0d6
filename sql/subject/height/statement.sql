-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{height
profile_edges AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (e.edge_id, e.from_node, e.to_node,
        streetgen._ground_of('{model_name}', e.geom, f.geom, t.geom)::bytea,
        streetgen._by_speed((v ->> 'grade_maximal')::jsonb, e.speed) / 100, e.speed)::streetgen.profile_edge),
        ARRAY[]::streetgen.profile_edge[]) AS list
    FROM setting, new_edge e JOIN new_node f ON f.node_id = e.from_node JOIN new_node t ON t.node_id = e.to_node),
profile_lifts AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (o.edge_above, o.abscissa_above, o.edge_below, o.abscissa_below, o.clearance,
        o.sinks)::streetgen.profile_lift), ARRAY[]::streetgen.profile_lift[]) AS list FROM found_overpass o),
profile_heights AS MATERIALIZED (
    SELECT coalesce(array_agg(ROW (e.edge_id, (o.abscissa - e.start_abscissa) / (e.end_abscissa - e.start_abscissa)
        * ST_Length2D(e.geom), o.height)::streetgen.profile_height), ARRAY[]::streetgen.profile_height[]) AS list
    FROM {model}.height_override o JOIN new_edge e ON e.axis_id = o.axis_id
        AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa),
profile_gone AS MATERIALIZED (
    SELECT ARRAY(SELECT edge_id FROM old_edge WHERE written EXCEPT SELECT edge_id FROM new_edge) AS list)
