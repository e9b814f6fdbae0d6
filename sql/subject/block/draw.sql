-- Drawings of blocks, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._block_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    -- Below the roadway of the ground.
    (11, 'block', $part$
    SELECT -1 + g.level * 10, CASE kind WHEN 'block' THEN 'block' ELSE 'block ' || kind END, false, surface, block_id
        FROM %1$I.block, (SELECT value::integer AS level FROM %1$I.setting WHERE name = 'ground_level') g$part$) $$;
COMMENT ON FUNCTION streetgen._block_drawn() IS 'What streetgen.svg draws of blocks.';

CREATE OR REPLACE FUNCTION streetgen._block_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (17, 'block', 'ground', 'city block', 'city block'),
    (18, 'block island', 'ground', 'island', 'island'),
    (19, 'block strip', 'ground', 'strip between carriageways', 'strip between carriageways') $$;
COMMENT ON FUNCTION streetgen._block_legend() IS 'What the styles of blocks mean.';
