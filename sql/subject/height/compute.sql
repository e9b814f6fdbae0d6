-- The one statement, heights along edges.

CREATE OR REPLACE FUNCTION streetgen._upsert_height(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template($part$
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
    SELECT ARRAY(SELECT edge_id FROM old_edge WHERE written EXCEPT SELECT edge_id FROM new_edge) AS list)$part$,
        places),
    streetgen._upsert_rows(places, 'profile', columns => 'geom, grade_max, method, tied_from, tied_to', rows => $part$
        SELECT row_number() OVER (ORDER BY edge_id)::integer AS number, edge_id, line::geometry AS geom, grade_max,
            method, tied_from, tied_to
        FROM $part$ || CASE WHEN places ->> 'run' IN ('whole', 'empty') THEN $part$
            streetgen._solved_profile((SELECT list FROM profile_edges), (SELECT list FROM profile_lifts),
                (SELECT list FROM profile_heights), {srid})$part$
        ELSE $part$
            streetgen._renewed_profile('{model_name}', (SELECT list FROM profile_edges),
                (SELECT list FROM profile_lifts), (SELECT list FROM profile_heights),
                (SELECT list FROM profile_gone), ARRAY(SELECT axis_id FROM written_axis))$part$ END)) $$;
COMMENT ON FUNCTION streetgen._upsert_height(jsonb) IS
    'Part of the one statement: the heights along new_edge, and along all edges that these lift or no longer lift.';
