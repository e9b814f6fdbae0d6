-- The block that each ring encloses.
CREATE OR REPLACE FUNCTION streetgen._make_roundabout_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'block' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    -- A ring runs counter-clockwise, and traffic on it too where traffic keeps to the right.
    CREATE OR REPLACE VIEW roundabout_block WITH (security_invoker = true) AS
    SELECT r.roundabout_id, (SELECT b.block_id FROM block_edge b WHERE b.edge_id = r.edge_id
        AND b.side = CASE WHEN r.along_axis = (s.value <> 'left') THEN 'left' ELSE 'right' END
        ORDER BY b.start_abscissa LIMIT 1) AS block_id
    FROM roundabout r, setting s WHERE s.name = 'driving_side';
    COMMENT ON VIEW roundabout_block
        IS 'The block that each ring encloses; NULL where the ring does not lie on the ground';
    COMMENT ON COLUMN roundabout_block.roundabout_id IS 'the ring';
    COMMENT ON COLUMN roundabout_block.block_id IS 'the block within; NULL: the ring lies on another level';
END $$;
COMMENT ON FUNCTION streetgen._make_roundabout_views(name) IS
    'Makes the view roundabout_block of a model that computes blocks, again and again.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('roundabout_block'::name, 'block'), ('roundabout_block', 'roundabout') $$;
COMMENT ON FUNCTION streetgen._roundabout_view() IS
    'Views of roundabouts, and the subjects whose tables they read.';
