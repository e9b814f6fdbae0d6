-- Rules of check_model for blocks.

CREATE OR REPLACE FUNCTION streetgen._check_block(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH face AS MATERIALIZED (
        SELECT block_id, b.surface, ST_GeometryN(ring, 1) AS face, half, edges
        FROM block b, LATERAL (SELECT ST_Polygonize(e.geom) AS ring, array_agg(e.edge_id) AS edges,
                max(greatest(e.width, e.width_end) / 2 + abs(e.roadway_offset)) AS half
            FROM block_edge s JOIN edge e USING (edge_id) WHERE s.block_id = b.block_id AND s.ring = 1) r
        WHERE ST_NumGeometries(ring) = 1),
    -- The middle of crossing dual carriageways is roadway by right: no corner about it has an arc.
    paved AS MATERIALIZED (
        SELECT block_id, face, center FROM face f, LATERAL ST_MaximumInscribedCircle(face) disc
        WHERE ST_Area(surface) < ST_Area(face) / 2 AND radius > half + 2 AND NOT ST_Intersects(surface, center)
            AND NOT EXISTS (SELECT FROM edge e WHERE e.edge_id = ANY (edges)
                AND ST_Distance(e.geom, center) < greatest(e.width, e.width_end) / 2 + abs(e.roadway_offset))
            AND EXISTS (SELECT FROM corner c WHERE c.edge_a = ANY (edges) AND c.edge_b = ANY (edges)
                AND c.method <> 'no_arc'))
    SELECT 'error', 'invalid surface', 'block', block_id, ST_Area(surface), surface FROM block
        WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
    UNION ALL
    SELECT 'error', 'block without an edge about it', 'block', block_id, ST_Area(surface), surface FROM block b
        WHERE NOT EXISTS (SELECT FROM block_edge e WHERE e.block_id = b.block_id)
    UNION ALL
    SELECT 'error', 'side of an edge that faces no block nor the outside', 'edge', e.edge_id, 0, e.geom
        FROM edge e, (SELECT value::integer AS level FROM setting WHERE name = 'ground_level') g
        WHERE e.level = g.level AND (SELECT count(DISTINCT side) FROM block_edge b
            WHERE b.edge_id = e.edge_id) < 2
    UNION ALL
    SELECT 'notice', 'kerbs of a block cross or are missing', 'block', block_id, ST_Area(surface), surface
        FROM block WHERE method = 'robust_fallback'
    UNION ALL
    SELECT 'notice', 'block that is roadway, m2', 'block', block_id, ST_Area(face), face FROM paved
    UNION ALL
    SELECT 'warning', 'block override on no block', 'block_override', o.block_override_id, 0, o.geom
        FROM block_override o WHERE NOT EXISTS (SELECT FROM block b WHERE b.surface && o.geom
            AND ST_Intersects(b.surface, o.geom))
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_block(name) IS
    'The rows of streetgen.check_model for blocks.';

CREATE OR REPLACE FUNCTION streetgen._block_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (20, 'block', $part$
    (SELECT 'blocks, ' || kind, count(*), NULL FROM %1$I.block GROUP BY kind ORDER BY kind)$part$),
    (21, 'block', $part$
    SELECT 'blocks, ground', round((coalesce(sum(ST_Area(surface)), 0) / 1e6)::numeric, 6), 'km2'
        FROM %1$I.block$part$),
    (22, 'block', $part$
    (SELECT 'blocks, ' || method, count(*), NULL FROM %1$I.block WHERE method <> 'hypothesis' GROUP BY method
        ORDER BY method)$part$) $$;
COMMENT ON FUNCTION streetgen._block_summary() IS 'What streetgen.summary counts of blocks.';

CREATE OR REPLACE FUNCTION streetgen._block_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('block'::name, 'e.edge_id IN (SELECT edge_id FROM block_edge WHERE block_id = ($1).block_id)') $$;
COMMENT ON FUNCTION streetgen._block_marked_by_hand() IS
    'The edges that a change of blocks by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('block without an edge about it', 'rows of block_edge were deleted by hand, or axes while nobody followed',
        'generate the model again'),
    ('side of an edge that faces no block nor the outside',
        'rows of block_edge were deleted by hand, or axes while nobody followed',
        'generate the axis again'),
    ('kerbs of a block cross or are missing',
        'its ground was put together from pieces of the arrangement of its kerbs',
        'nothing, where the ground is right; else move the axes apart'),
    ('block that is roadway, m2',
        'a disc 2 m wider than the streets fits between the axes, and its middle is roadway',
        'look at the corners about it, and at the widths of the streets'),
    ('block override on no block', 'its place lies on the roadway, or outside of all streets',
        'move or delete the override');
