-- How blocks are drawn.

CREATE OR REPLACE FUNCTION streetgen._block_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    -- Below the roadway of the ground.
    (11, 'block', $part$
    SELECT -1 + g.level * 10, CASE kind WHEN 'block' THEN 'block' ELSE 'block ' || kind END, false, surface, block_id
        FROM %1$I.block, (SELECT value::integer AS level FROM %1$I.setting WHERE name = 'ground_level') g$part$) $$;
COMMENT ON FUNCTION streetgen._block_drawn() IS 'What streetgen.svg draws of blocks.';
