-- OpenDRIVE: junctions.

CREATE OR REPLACE FUNCTION streetgen._joined_nodes(model name, options jsonb)
    RETURNS TABLE(node_id bigint, place_id bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 200 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH RECURSIVE place AS MATERIALIZED (SELECT node_id, place_id FROM streetgen._places(model, options)),
    touching AS MATERIALIZED (
        SELECT DISTINCT v.* FROM (SELECT place_id, min(place_id) OVER (PARTITION BY group_id) AS first
            FROM intersection_group JOIN place USING (node_id)) g,
            LATERAL (VALUES (g.place_id, first), (first, g.place_id)) v(place_id, other) WHERE g.place_id <> first),
    reached AS (
        SELECT place_id, other FROM touching
        UNION SELECT r.place_id, t.other FROM reached r JOIN touching t ON t.place_id = r.other)
    SELECT p.node_id, coalesce(r.first, p.place_id)
    FROM place p LEFT JOIN (SELECT place_id, min(other) AS first FROM reached GROUP BY place_id) r USING (place_id);
END $$;
COMMENT ON FUNCTION streetgen._joined_nodes(name, jsonb) IS
    'The junction that each node is part of in OpenDRIVE. A road that comes into a junction lies in none, so what '
    'crossed limits join is one junction, and nothing between.';

CREATE OR REPLACE FUNCTION streetgen._held_places(model name, options jsonb) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT j.place_id FROM streetgen._joined_nodes(model, options) j
        WHERE j.node_id IN (SELECT m.node_id FROM marking m WHERE m.kind IN ('stop', 'yield')
            UNION ALL SELECT CASE WHEN h.along_axis THEN e.to_node ELSE e.from_node END
            FROM streetgen._signal_heads(model) h JOIN lane l USING (lane_id) JOIN edge e USING (edge_id)
            UNION ALL SELECT n.node_id FROM streetgen._opendrive_objects(model) o JOIN node n
                ON o.kind = 'crosswalk' AND ST_DWithin(n.geom, o.geom, 5));
END $$;
COMMENT ON FUNCTION streetgen._held_places(name, jsonb) IS
    'The junctions of OpenDRIVE at which somebody waits, for signals or at a stop or yield line, or crosses on foot.';
