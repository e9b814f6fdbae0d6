-- Rules of check_model for junctions.

CREATE OR REPLACE FUNCTION streetgen._junction_check_part()
    RETURNS TABLE(place integer, subject text, kind text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (68, 'junction', 'rule', $part$
SELECT 'error', 'node of degree three and more without a junction', 'node', d.node_id, d.degree, n.geom FROM degree d
    JOIN %1$I.node n USING (node_id) WHERE d.degree >= 3
        AND NOT EXISTS (SELECT FROM %1$I.junction_node j WHERE j.node_id = d.node_id)$part$),
    (69, 'junction', 'rule', $part$
SELECT 'warning', 'stale: the junction of a node changed since', 'node', m.node_id, m.junction_id, n.geom
    FROM unnest((%1$I._junction_members(NULL)).members) m JOIN %1$I.junction_node j USING (node_id)
        JOIN %1$I.node n USING (node_id) WHERE j.junction_id <> m.junction_id$part$),
    (70, 'junction', 'rule', $part$
SELECT 'notice', 'edge that junction_extent keeps out of a junction', 'edge', m.edge_id, e.end_abscissa
    - e.start_abscissa, e.geom FROM unnest((%1$I._junction_members(NULL)).members) m JOIN %1$I.edge e USING (edge_id)
    WHERE m.parted$part$),
    (71, 'junction', 'rule', $part$
SELECT 'notice', 'junction wider than junction_extent, m', 'junction', j.junction_id, c.width, j.geom
    FROM %1$I.junction j JOIN (SELECT n.junction_id, ST_MaxDistance(ST_Collect(p.geom), ST_Collect(p.geom)) AS width
        FROM %1$I.junction_node n JOIN %1$I.node p USING (node_id) GROUP BY n.junction_id HAVING count(*) > 1) c
        USING (junction_id)
    WHERE c.width > (SELECT value::float8 FROM %1$I.setting WHERE name = 'junction_extent')$part$),
    (72, 'junction', 'rule', $part$
SELECT 'notice', 'turn restriction via axes outside a junction, not obeyed', 'turn_restriction', r.turn_restriction_id,
    cardinality(r.via_axes), r.geom FROM %1$I.turn_restriction r
    WHERE r.via_axes IS NOT NULL AND 1 <> (SELECT count(DISTINCT coalesce(j.junction_id, -1))
            + count(*) FILTER (WHERE j.junction_id IS NULL)
        FROM streetgen._via_edges(%1$L, r.via_axes, r.via_geom) e
            LEFT JOIN %1$I.junction_edge j USING (edge_id))$part$),
    (73, 'junction', 'rule', $part$
SELECT 'warning', 'junction override without its axis', 'junction_override', o.junction_override_id, 0, o.geom
    FROM %1$I.junction_override o WHERE NOT EXISTS (SELECT FROM %1$I.edge e WHERE e.axis_id = o.axis_id)$part$) $$;
COMMENT ON FUNCTION streetgen._junction_check_part() IS 'The parts of streetgen._check_part() for junctions.';
