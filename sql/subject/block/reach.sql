-- The one statement, blocks: which of them a run for some axes changes. They are renewed after it.

CREATE OR REPLACE FUNCTION streetgen._moved_block(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places ->> 'run' = 'part' AND places -> 'subjects' ? 'block'
        THEN streetgen._fill_template(streetgen._part('moved_block'), places) END $$;
COMMENT ON FUNCTION streetgen._moved_block(jsonb) IS
    'Part of the one statement in a run for some axes: moved, the blocks before the run that lie beside kerbs '
    'or about edges that it moves, beside the requested axes, or where it puts an edge that hangs on nothing; 0: the '
    'outside. NULL in other runs, and in a model without blocks.';

CREATE OR REPLACE FUNCTION streetgen._block_chain() RETURNS TABLE(relation name, touched text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    ('block'::name, $q$
        SELECT t.axis_id, coalesce(b.block_id, 0) AS chain FROM touched t, LATERAL (
            SELECT block_id FROM {model}.block_edge b WHERE b.edge_id = t.edge_id OFFSET 0) b
        UNION ALL SELECT axis_id, block_id FROM {model}._blocks_about(axes)$q$) $f$;
COMMENT ON FUNCTION streetgen._block_chain() IS 'The chains of blocks, as streetgen._chain has them.';
