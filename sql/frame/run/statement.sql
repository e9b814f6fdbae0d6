-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{rows_there
setting AS MATERIALIZED (SELECT jsonb_object_agg(name, value) AS v FROM {model}.setting),
new_node AS MATERIALIZED (SELECT *, false AS fresh FROM {model}.node),
new_edge AS MATERIALIZED (SELECT *, false AS fresh FROM {model}.edge),
left_node AS (SELECT node_id FROM new_node WHERE false),
old_edge AS (SELECT *, true AS written FROM new_edge WHERE false),
written_axis AS (SELECT axis_id FROM new_edge WHERE false)
