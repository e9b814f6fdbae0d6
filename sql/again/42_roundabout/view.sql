-- Which block each ring encloses.
CREATE OR REPLACE FUNCTION streetgen._make_roundabout_block_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A ring runs counter-clockwise, and traffic on it too where traffic keeps to the right.
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.roundabout_block WITH (security_invoker = true) AS
SELECT r.roundabout_id, (SELECT b.block_id FROM %1$I.block_edge b WHERE b.edge_id = r.edge_id
    AND b.side = CASE WHEN r.along_axis = (s.value <> 'left') THEN 'left' ELSE 'right' END
    ORDER BY b.start_abscissa LIMIT 1) AS block_id
FROM %1$I.roundabout r, %1$I.setting s WHERE s.name = 'driving_side'
$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.roundabout_block
        IS 'The block that each ring encloses; NULL where the ring does not lie on the ground'$sql$, model);
END $$;
COMMENT ON FUNCTION streetgen._make_roundabout_block_view(name) IS
    'Makes the view roundabout_block of a model that computes blocks, again and again.';
