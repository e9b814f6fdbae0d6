-- The one statement, blocks: which of them a run for some axes changes. They are renewed after it.

CREATE OR REPLACE FUNCTION streetgen._moved_block(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places ->> 'run' = 'part' AND places -> 'subjects' ? 'block'
        THEN streetgen._fill_template($part$
block_ground AS MATERIALIZED (SELECT (v ->> 'ground_level')::integer AS level FROM setting),
-- Edges that came, went or moved, as they were and as they are; of a stale one it is not known what changed beside it.
former_place AS MATERIALIZED (
    SELECT e.edge_id, e.level, e.from_node, e.to_node, e.start_abscissa, e.end_abscissa, e.geom, e.input_hash
    FROM old_edge o, LATERAL (SELECT * FROM {model}.edge e WHERE e.edge_id = o.edge_id OFFSET 0) e WHERE o.written),
moved_edge AS MATERIALIZED (
    SELECT f.edge_id, m.* FROM former_place f FULL JOIN new_edge n USING (edge_id), block_ground g, LATERAL (
        VALUES (f.level, f.from_node, f.to_node, f.geom, false), (n.level, n.from_node, n.to_node, n.geom, true))
            m(level, from_node, to_node, geom, now)
    WHERE m.level = g.level AND (f.input_hash IS NOT DISTINCT FROM 0
        OR (f.level, f.from_node, f.to_node, f.start_abscissa, f.end_abscissa, f.geom) IS DISTINCT FROM
            (n.level, n.from_node, n.to_node, n.start_abscissa, n.end_abscissa, n.geom))),
moved_end AS MATERIALIZED (
    SELECT node_id, edge_id
    FROM block_ground g, (SELECT from_node AS node_id FROM moved_edge UNION SELECT to_node FROM moved_edge) n,
        LATERAL (SELECT edge_id, e.level FROM {model}.edge e WHERE e.from_node = n.node_id
            UNION ALL SELECT edge_id, e.level FROM {model}.edge e WHERE e.to_node = n.node_id OFFSET 0) e
    WHERE e.level = g.level),
-- The face about what hangs on nothing that stays is the one at the nearest edge.
loose_edge AS MATERIALIZED (
    SELECT geom FROM moved_edge m WHERE now AND NOT EXISTS (SELECT FROM moved_end e
        WHERE e.node_id IN (m.from_node, m.to_node) AND e.edge_id NOT IN (SELECT edge_id FROM moved_edge
            WHERE edge_id IS NOT NULL))),
-- Kerbs that came, went or moved, as they were and as they are.
moved_border AS MATERIALIZED (
    SELECT k.edge_id, k.node_id, k.method, k.geom FROM block_ground g, (
        SELECT edge_id, node_id, level, method, geom FROM new_kerb WHERE changed
        UNION ALL SELECT k.edge_id, k.node_id, k.level, k.method, k.geom
        FROM (SELECT kerb_id FROM new_kerb WHERE changed AND NOT fresh UNION ALL SELECT kerb_id FROM gone_kerb) c,
            LATERAL (SELECT * FROM {model}.kerb k WHERE k.kerb_id = c.kerb_id OFFSET 0) k) k
    WHERE k.level = g.level),
-- A kerb that others contest may lie in a face that its edge is not about.
near_place AS MATERIALIZED (
    SELECT geom, true AS moved, ARRAY(SELECT edge_id FROM moved_edge WHERE edge_id IS NOT NULL) AS beside
    FROM loose_edge
    UNION ALL SELECT ST_LineInterpolatePoint(geom, 0.5), false, ARRAY[]::bigint[] FROM moved_border
    WHERE method IN ('contested', 'level_change')),
near_edge AS MATERIALIZED (
    SELECT p.moved, e.edge_id FROM block_ground g, near_place p, LATERAL (
        -- The nearest box bounds the distance, as in _nearest_axis.
        SELECT ST_Distance(b.geom, p.geom) AS away FROM (SELECT e.geom FROM {model}.edge e
            WHERE e.level = g.level AND e.edge_id <> ALL (p.beside) ORDER BY e.geom <#> p.geom LIMIT 1) b) bound,
        LATERAL (SELECT e.edge_id, e.away, min(e.away) OVER () AS least FROM (
            SELECT e.edge_id, ST_Distance(e.geom, p.geom) AS away FROM {model}.edge e WHERE e.level = g.level
                AND e.edge_id <> ALL (p.beside) AND ST_DWithin(e.geom, p.geom, bound.away + 0.001) OFFSET 0) e) e
    WHERE e.away <= e.least + 0.001),
-- Sides of the outside (block 0) change with edges alone.
block_beside AS MATERIALIZED (
    SELECT edge_id, true AS moved FROM moved_end
    UNION SELECT e.edge_id, true FROM block_ground g, moved_edge m, LATERAL (
        SELECT edge_id, e.level, e.geom FROM {model}.edge e WHERE e.geom && m.geom OFFSET 0) e
        WHERE e.level = g.level AND ST_Intersects(e.geom, m.geom)
    UNION SELECT edge_id, moved FROM near_edge
    UNION SELECT edge_id, false FROM moved_border
    UNION SELECT e.edge_id, false FROM moved_border b, LATERAL (
        SELECT edge_id FROM {model}.edge e WHERE e.from_node = b.node_id
        UNION ALL SELECT edge_id FROM {model}.edge e WHERE e.to_node = b.node_id OFFSET 0) e
        WHERE b.method = 'level_change'
    -- A kind by hand is asked for by an axis beside its block.
    UNION SELECT edge_id, false FROM old_edge WHERE axis_id IN (SELECT unnest($3))),
moved AS MATERIALIZED (
    SELECT coalesce(b.block_id, 0) AS id FROM block_beside s, LATERAL (
        SELECT block_id FROM {model}.block_edge b WHERE b.edge_id = s.edge_id OFFSET 0) b
    WHERE s.moved OR b.block_id IS NOT NULL
    UNION SELECT 0 FROM loose_edge WHERE NOT EXISTS (SELECT FROM near_edge WHERE moved))$part$, places) END $$;
COMMENT ON FUNCTION streetgen._moved_block(jsonb) IS
    'Part of the one statement in a run for some axes: moved, the blocks before the run that lie beside kerbs '
    'or about edges that it moves, beside the requested axes, or where it puts an edge that hangs on nothing; 0: the '
    'outside. NULL in other runs, and in a model without blocks.';

CREATE OR REPLACE FUNCTION streetgen._block_chain() RETURNS TABLE(relation name, touched text, at_end boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    ('block'::name, $q$
        SELECT t.axis_id, coalesce(b.block_id, 0) AS chain FROM touched t, LATERAL (
            SELECT block_id FROM {model}.block_edge b WHERE b.edge_id = t.edge_id OFFSET 0) b
        UNION ALL SELECT axis_id, block_id FROM {model}._blocks_about(axes)$q$, false) $f$;
COMMENT ON FUNCTION streetgen._block_chain() IS 'The chains of blocks, as streetgen._chain has them.';
