-- Rules of check_model for blocks.

CREATE OR REPLACE FUNCTION streetgen._check_block(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
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
    ('block override on no block', 'its place lies on the roadway, or outside of all streets',
        'move or delete the override');
