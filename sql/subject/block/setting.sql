-- The settings of blocks.

CREATE OR REPLACE FUNCTION streetgen._block_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    ('ground_level', '0', NULL::text, 'level of which the faces are blocks', -100, 100, NULL::text[]),
    ('block_island_area', '300', 'm2',
        'a block with less ground is an island, as is what a tagged roundabout goes round; 0: none is', 0, 100000,
        NULL),
    ('block_strip_width', '12', 'm',
        'a block is a strip where the rectangle of its area and perimeter is no wider, and long; 0: none is', 0, 1000,
        NULL),
    ('block_strip_elongation', '4', NULL, 'the rectangle of a strip is at least so many times as long as wide', 1,
        1000, NULL) $$;
COMMENT ON FUNCTION streetgen._block_setting() IS 'The settings of blocks, with their defaults and ranges.';
