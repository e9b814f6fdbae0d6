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
