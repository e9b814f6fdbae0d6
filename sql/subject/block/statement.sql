-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{block_statement
WITH ground AS MATERIALIZED (
    SELECT max(value) FILTER (WHERE name = 'ground_level')::integer AS level,
        max(value) FILTER (WHERE name = 'block_island_area')::float8 AS island_area,
        max(value) FILTER (WHERE name = 'block_strip_width')::float8 AS strip_width,
        max(value) FILTER (WHERE name = 'block_strip_elongation')::float8 AS strip_elongation,
        bool_or(value = 'true') FILTER (WHERE name = 'roundabout_tags') AS tags_count
    FROM {model}.setting WHERE name IN ('ground_level', 'roundabout_tags') OR name LIKE 'block%'),
-- The rows that may change.
old_side AS MATERIALIZED (
    SELECT * FROM {model}.block_edge WHERE {whole} OR block_id = ANY ($1)
    UNION ALL SELECT * FROM {model}.block_edge WHERE NOT {whole} AND 0 = ANY ($1) AND block_id IS NULL),
street AS MATERIALIZED (
    SELECT e.edge_id, e.geom, e.from_node, e.to_node,
        row_number() OVER (ORDER BY e.axis_id, e.start_abscissa) AS number,
        coalesce(ground.tags_count, false) AND streetgen._names_ring(a.roundabout_tag) AS on_ring
    FROM ground, {model}.edge e,
        LATERAL (SELECT roundabout_tag FROM {model}.axis a WHERE a.axis_id = e.axis_id {by_key}) a
    WHERE e.level = ground.level AND ({whole} OR e.edge_id = ANY (ARRAY(SELECT edge_id FROM old_side
        UNION SELECT n.edge_id FROM {model}.edge n WHERE n.axis_id = ANY ($2)
            AND (SELECT true FROM {model}.block_edge b WHERE b.edge_id = n.edge_id LIMIT 1) IS NULL)))),
kept AS MATERIALIZED (
    SELECT b.edge_id, b.side, b.start_abscissa, b.end_abscissa
    FROM street s, LATERAL (SELECT * FROM {model}.block_edge b WHERE b.edge_id = s.edge_id OFFSET 0) b
    WHERE NOT {whole} AND coalesce(b.block_id, 0) <> ALL ($1)),
-- Kerbs that others contest may lie beside an edge that they are not of. Those near streets that begin in one cell
-- are looked up together.
cell AS MATERIALIZED (
    SELECT ST_SetSRID(ST_Expand(ST_Extent(geom)::geometry, 50), {srid}) AS box FROM street WHERE NOT $3
    GROUP BY floor(ST_XMin(geom) / 400), floor(ST_YMin(geom) / 400)),
-- All of a place, where a ring has a gap else.
extent AS MATERIALIZED (
    SELECT ST_SetSRID(ST_Expand(ST_Extent(geom)::geometry, 200), {srid}) AS extent FROM street WHERE $3),
beside AS MATERIALIZED (
    SELECT k.edge_id, k.side, k.method, k.geom
    FROM ground, street s, LATERAL (SELECT * FROM {model}.kerb k WHERE k.edge_id = s.edge_id {by_key}) k
    WHERE k.level = ground.level AND NOT $3
    -- The edge of another level may have the corner where that level begins.
    UNION ALL SELECT k.edge_id, k.side, k.method, k.geom
    FROM ground, (SELECT from_node AS node_id FROM street UNION SELECT to_node FROM street) n,
        LATERAL (SELECT * FROM {model}.kerb k WHERE k.node_id = n.node_id {by_key}) k,
        LATERAL (SELECT level FROM {model}.edge e WHERE e.edge_id = k.edge_id {by_key}) e
    WHERE k.level = ground.level AND k.edge_id NOT IN (SELECT edge_id FROM street) AND e.level <> ground.level
        AND NOT $3
    UNION ALL (SELECT DISTINCT ON (k.kerb_id) k.edge_id, k.side, k.method, k.geom FROM ground, cell, LATERAL (
        SELECT * FROM {model}.kerb k WHERE k.geom && cell.box AND k.method = 'contested' {by_key}) k
    WHERE k.level = ground.level AND k.edge_id NOT IN (SELECT edge_id FROM street))
    UNION ALL SELECT k.edge_id, k.side, k.method, k.geom FROM ground, extent, LATERAL (
        SELECT * FROM {model}.kerb k WHERE {whole} OR k.geom && extent {by_key}) k
    WHERE k.level = ground.level AND $3),
found AS MATERIALIZED (
    SELECT b.* FROM ground g,
        (SELECT array_agg(edge_id ORDER BY number) AS ids,
            array_agg(ST_Force2D(geom)::bytea ORDER BY number) AS lines,
            array_agg(on_ring ORDER BY number) AS on_rings FROM street) s,
        (SELECT coalesce(array_agg(edge_id), ARRAY[]::bigint[]) AS edges,
            coalesce(array_agg(side), ARRAY[]::text[]) AS sides,
            coalesce(array_agg(method = 'contested'), ARRAY[]::boolean[]) AS contested,
            coalesce(array_agg(method = 'level_change'), ARRAY[]::boolean[]) AS change_level,
            coalesce(array_agg(geom::bytea), ARRAY[]::bytea[]) AS lines FROM beside) k,
        (SELECT coalesce(array_agg(edge_id), ARRAY[]::bigint[]) AS edges,
            coalesce(array_agg(side = 'left'), ARRAY[]::boolean[]) AS lefts,
            coalesce(array_agg(start_abscissa), ARRAY[]::float8[]) AS starts,
            coalesce(array_agg(end_abscissa), ARRAY[]::float8[]) AS ends FROM kept) t,
        (SELECT coalesce(array_agg(ST_X(geom) ORDER BY block_override_id), ARRAY[]::float8[]) AS x,
            coalesce(array_agg(ST_Y(geom) ORDER BY block_override_id), ARRAY[]::float8[]) AS y,
            coalesce(array_agg(kind ORDER BY block_override_id), ARRAY[]::text[]) AS kinds
            FROM {model}.block_override) o,
        LATERAL streetgen._blocks(s.ids, s.lines, s.on_rings, k.edges, k.sides, k.contested, k.change_level,
            k.lines, t.edges, t.lefts, t.starts, t.ends, o.x, o.y, o.kinds, g.island_area, g.strip_width,
            g.strip_elongation) b),
-- Without all kerbs nothing is written: they are then asked for by place. What an axis bounds depends on blocks across.
given AS MATERIALIZED (
    SELECT $3 OR coalesce(bool_and(has_all_kerbs), true) AND NOT EXISTS (SELECT FROM {model}.block
        WHERE block_id = ANY ($1) AND method = 'axis_bound') AS whole FROM found),
found_side AS MATERIALIZED (
    SELECT f.number, s.edge_id, CASE WHEN s."left" THEN 'left' ELSE 'right' END AS side, s.start_abscissa,
        s.end_abscissa, s.ring, s.ordinality::integer AS ordinality
    FROM found f, given, unnest(edge_ids, lefts, rings, starts, ends)
        WITH ORDINALITY s(edge_id, "left", ring, start_abscissa, end_abscissa, ordinality) WHERE given.whole),
-- Identity of blocks: by the smallest place of their ring.
heir AS MATERIALIZED (
    SELECT DISTINCT ON (f.number) f.number, o.block_id FROM found_side f JOIN old_side o
        ON (o.edge_id, o.side, o.start_abscissa) = (f.edge_id, f.side, f.start_abscissa)
    WHERE f.number > 0 AND o.block_id IS NOT NULL AND o.ordinality = 1 ORDER BY f.number, f.ordinality),
new_block AS MATERIALIZED (
    SELECT number, coalesce(h.block_id, nextval('{quoted_model}.block_block_id_seq')) AS block_id,
        h.block_id IS NULL AS fresh, kind, surface::geometry(MultiPolygon, {srid}) AS surface, method
    FROM (SELECT f.* FROM found f, given WHERE f.number > 0 AND given.whole ORDER BY f.number) f
        LEFT JOIN heir h USING (number) ORDER BY number),
changed_block AS MATERIALIZED (
    SELECT n.* FROM new_block n LEFT JOIN {model}.block o USING (block_id)
    WHERE n.fresh OR (o.kind, o.surface, o.method) IS DISTINCT FROM (n.kind, n.surface, n.method)),
set_block AS (
    INSERT INTO {model}.block (block_id, kind, surface, method)
    SELECT block_id, kind, surface, method FROM changed_block ORDER BY number
    ON CONFLICT (block_id) DO UPDATE SET (kind, surface, method) =
        (excluded.kind, excluded.surface, excluded.method)),
gone_block AS (
    DELETE FROM {model}.block b USING given
    WHERE given.whole AND ({whole} OR b.block_id = ANY ($1)) AND b.block_id NOT IN (SELECT block_id FROM new_block)
    RETURNING 1),
changed_side AS MATERIALIZED (
    SELECT f.edge_id, f.side, f.start_abscissa, f.end_abscissa, n.block_id, f.ring,
        -- About the outside there is no order.
        CASE WHEN n.number IS NULL THEN 1 ELSE f.ordinality END AS ordinality, o.edge_id IS NULL AS fresh
    FROM found_side f LEFT JOIN new_block n USING (number)
        LEFT JOIN old_side o ON (o.edge_id, o.side, o.start_abscissa) = (f.edge_id, f.side, f.start_abscissa)
    WHERE (o.block_id, o.end_abscissa, o.ring, o.ordinality) IS DISTINCT FROM (n.block_id, f.end_abscissa, f.ring,
        CASE WHEN n.number IS NULL THEN 1 ELSE f.ordinality END)),
set_side AS (
    INSERT INTO {model}.block_edge (edge_id, side, start_abscissa, end_abscissa, block_id, ring, ordinality)
    SELECT edge_id, side, start_abscissa, end_abscissa, block_id, ring, ordinality FROM changed_side
    ON CONFLICT (edge_id, side, start_abscissa) DO UPDATE SET (end_abscissa, block_id, ring, ordinality) =
        (excluded.end_abscissa, excluded.block_id, excluded.ring, excluded.ordinality)),
gone_side AS (
    DELETE FROM {model}.block_edge b USING given, old_side o
    WHERE given.whole AND (b.edge_id, b.side, b.start_abscissa) = (o.edge_id, o.side, o.start_abscissa)
        -- By hash, whatever the planner expects.
        AND (o.edge_id, o.side, o.start_abscissa) NOT IN (SELECT edge_id, side, start_abscissa FROM found_side)
    RETURNING 1)
SELECT 'block', (SELECT count(*) FROM changed_block WHERE fresh), (SELECT count(*) FROM changed_block WHERE NOT fresh),
    (SELECT count(*) FROM gone_block), (SELECT count(*) FROM new_block) - (SELECT count(*) FROM changed_block),
    (SELECT count(*) FROM new_block WHERE method <> 'hypothesis')
FROM given WHERE given.whole
UNION ALL SELECT 'block_edge', (SELECT count(*) FROM changed_side WHERE fresh),
    (SELECT count(*) FROM changed_side WHERE NOT fresh), (SELECT count(*) FROM gone_side),
    (SELECT count(*) FROM found_side) - (SELECT count(*) FROM changed_side), 0
FROM given WHERE given.whole

--{moved_block
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
moved_block AS MATERIALIZED (
    SELECT coalesce(b.block_id, 0) AS id, NULL::geometry AS ground FROM block_beside s, LATERAL (
        SELECT block_id FROM {model}.block_edge b WHERE b.edge_id = s.edge_id OFFSET 0) b
    WHERE s.moved OR b.block_id IS NOT NULL
    UNION SELECT 0, NULL FROM loose_edge WHERE NOT EXISTS (SELECT FROM near_edge WHERE moved))

--{block_interior
CREATE OR REPLACE VIEW block_interior WITH (security_invoker = true) AS
SELECT b.block_id, ST_Multi(ST_CollectionExtract(coalesce(ST_Difference(b.surface, (
    SELECT ST_Union(coalesce(s.strip, s.surface)) FROM sidewalk s JOIN kerb k USING (edge_id, side, part)
    WHERE coalesce(s.strip, s.surface) && b.surface AND ST_Intersects(coalesce(s.strip, s.surface), b.surface)
        AND k.level = (SELECT value::integer FROM setting WHERE name = 'ground_level'))), b.surface), 3))
    ::geometry(MultiPolygon, {srid}) AS geom
FROM block b
