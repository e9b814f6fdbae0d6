-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{neighbour
(
-- An intersection may reach farther than its axes.
WITH box AS MATERIALIZED (
    SELECT ST_Expand(geom, greatest((v ->> 'reach')::float8, (v ->> 'max_arc_distance')::float8)
        + greatest(width, width_end) / 2 + abs(roadway_offset)) AS box
    FROM used, setting WHERE axis_id IN (SELECT unnest($1))
    UNION ALL SELECT surface FROM former_node),
beside_section AS MATERIALIZED (
    SELECT DISTINCT edge_id FROM box b, LATERAL (
        SELECT edge_id FROM {model}.section s WHERE s.surface && b.box OFFSET 0) s),
beside_intersection AS MATERIALIZED (
    SELECT DISTINCT node_id FROM box b, LATERAL (
        SELECT node_id FROM {model}.intersection i WHERE i.surface && b.box OFFSET 0) i)
SELECT coalesce(array_agg(n), ARRAY[]::streetgen.street_neighbour[]) FROM (
    SELECT ROW (ST_X(f.geom), ST_Y(f.geom), ST_X(t.geom), ST_Y(t.geom), s.surface::bytea,
        s.level)::streetgen.street_neighbour AS n
    FROM beside_section b,
        LATERAL (SELECT * FROM {model}.edge e WHERE e.edge_id = b.edge_id OFFSET 0) e,
        LATERAL (SELECT * FROM {model}.section s WHERE s.edge_id = e.edge_id OFFSET 0) s,
        LATERAL (SELECT geom FROM {model}.node n WHERE n.node_id = e.from_node OFFSET 0) f,
        LATERAL (SELECT geom FROM {model}.node n WHERE n.node_id = e.to_node OFFSET 0) t
    WHERE e.axis_id NOT IN (SELECT unnest($1))
    UNION ALL SELECT ROW (ST_X(n.geom), ST_Y(n.geom), NULL, NULL, i.surface::bytea,
        i.level)::streetgen.street_neighbour
    FROM beside_intersection b,
        LATERAL (SELECT * FROM {model}.intersection i WHERE i.node_id = b.node_id OFFSET 0) i,
        LATERAL (SELECT geom FROM {model}.node n WHERE n.node_id = b.node_id OFFSET 0) n
    WHERE b.node_id NOT IN (SELECT node_id FROM former_node)) beside)

--{kerb
-- A kerb of an intersection may name an edge of an axis that is not written: as it is there.
kerb_edge AS MATERIALIZED (
    SELECT number, edge_id FROM new_edge
    UNION ALL SELECT c.number, e.edge_id
    FROM computed_edge c, LATERAL (SELECT edge_id FROM {model}.edge e
        WHERE (e.axis_id, e.start_abscissa, e.end_abscissa) = (c.axis_id, c.start_abscissa, c.end_abscissa) {by_key}) e
    WHERE NOT {whole} AND c.number NOT IN (SELECT number FROM written_edge)
        AND (c.from_node IN (SELECT number FROM new_node WHERE kerbs_affected)
            OR c.to_node IN (SELECT number FROM new_node WHERE kerbs_affected))),
kerb_edge_ids AS MATERIALIZED (SELECT streetgen._ids(number, edge_id) AS ids FROM kerb_edge)

--{kerb_there
SELECT k.kerb_id FROM new_edge e, LATERAL (SELECT kerb_id FROM {model}.kerb k
    WHERE k.edge_id = e.edge_id AND k.node_id IS NULL {by_key}) k WHERE e.kerbs_affected AND NOT e.fresh
UNION ALL SELECT k.kerb_id FROM new_node n, LATERAL (SELECT kerb_id, edge_id FROM {model}.kerb k
    WHERE k.node_id = n.node_id {by_key}) k
WHERE n.kerbs_affected AND NOT n.fresh AND k.edge_id IN (SELECT edge_id FROM kerb_edge)
