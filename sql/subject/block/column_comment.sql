-- This says what each column of blocks means.
CREATE OR REPLACE FUNCTION streetgen._block_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ VALUES
    ('block'::name, 'block_id'::name, 'key; kept while the smallest place of its ring is there'),
    ('block', 'kind', 'block; island: small, see setting block_island_area; strip: narrow and long, see '
        'block_strip_width; roadway: no ground is left. Else as block_override has it'),
    ('block', 'surface', 'the ground: empty where the face is roadway all over'),
    ('sidewalk_block', 'sidewalk_id', 'the sidewalk'),
    ('sidewalk_block', 'block_id', 'the block that it lies on; NULL: it lies in no face'),
    ('block_interior', 'block_id', 'the block'),
    ('block_interior', 'geom', 'its ground behind the sidewalks; empty: they take all of it'),
    ('block', 'method', 'hypothesis; covered: no ground is left; axis_bound: where a street beside it has no roadway '
        'on its level, the axis bounds it; robust_fallback: kerbs cross, or are missing'),
    ('block_edge', 'edge_id', 'the edge, of level ground_level'),
    ('block_edge', 'side', 'left or right in the direction of the edge'),
    ('block_edge', 'start_abscissa', 'where the part of the side begins, metres along the edge: 0 unless another edge '
        'crosses it without a node'),
    ('block_edge', 'end_abscissa', 'where the part ends, metres along the edge'),
    ('block_edge', 'block_id', 'the block that lies there; NULL: the outside of all blocks'),
    ('block_edge', 'ring', '1: the edge is about the block; others: about an island of streets within'),
    ('block_edge', 'ordinality', 'number along the rings of the block, with the block on the left, from its smallest '
        'place; 1 where no block lies'),
    ('block_override', 'block_override_id', 'key'),
    ('block_override', 'geom', 'a place on the ground of the block'),
    ('block_override', 'kind', 'block, island or strip') $$;
COMMENT ON FUNCTION streetgen._block_column() IS 'The columns of blocks, and what each is.';
