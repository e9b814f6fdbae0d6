-- Sidewalks of blocks, and what they leave.
CREATE OR REPLACE FUNCTION streetgen._make_block_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    CREATE OR REPLACE VIEW sidewalk_block WITH (security_invoker = true) AS
    -- By its place: a wide street may reach over a narrow one, so its kerb lies where its edge is not about the
    -- block.
    SELECT s.sidewalk_id, (SELECT b.block_id FROM block b, ST_PointOnSurface(coalesce(s.strip, s.surface)) place
        WHERE b.surface && place AND ST_Intersects(b.surface, place) LIMIT 1) AS block_id
    FROM sidewalk s JOIN kerb k USING (edge_id, side, part)
    WHERE k.level = (SELECT value::integer FROM setting WHERE name = 'ground_level');
    EXECUTE streetgen._part_in('block_interior', model);
    COMMENT ON VIEW sidewalk_block IS 'The block that each sidewalk of the ground lies on';
    COMMENT ON COLUMN sidewalk_block.sidewalk_id IS 'the sidewalk';
    COMMENT ON COLUMN sidewalk_block.block_id IS 'the block that it lies on; NULL: it lies in no face';
    COMMENT ON VIEW block_interior IS 'The ground of each block behind its sidewalks, computed when it is asked for';
    COMMENT ON COLUMN block_interior.block_id IS 'the block';
    COMMENT ON COLUMN block_interior.geom IS 'its ground behind the sidewalks; empty: they take all of it';
END $$;
COMMENT ON FUNCTION streetgen._make_block_views(name) IS
    'Makes the views sidewalk_block and block_interior of a model, where it computes sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._block_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES ('sidewalk_block'::name, 'block'), ('sidewalk_block', 'sidewalk'), ('block_interior', 'block'),
        ('block_interior', 'sidewalk') $$;
COMMENT ON FUNCTION streetgen._block_view() IS
    'Views of blocks, and the subjects whose tables they read.';
