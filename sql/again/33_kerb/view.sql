-- How much of each corner's arc is really kerb.
CREATE OR REPLACE FUNCTION streetgen._make_corner_on_kerb_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.corner_on_kerb WITH (security_invoker = true) AS
SELECT c.corner_id, c.node_id, least(1, coalesce(sum(ST_Length(k.curve)), 0) / ST_Length(c.arc)) AS on_kerb, c.arc
FROM %1$I.corner c LEFT JOIN %1$I.kerb k ON k.node_id = c.node_id AND k.edge_id = c.edge_a
    AND k.side = 'corner_at_' || c.end_a AND k.curve IS NOT NULL
WHERE c.arc IS NOT NULL
GROUP BY c.corner_id
$sql$, model);
    EXECUTE format($sql$COMMENT ON VIEW %I.corner_on_kerb
        IS 'Arcs of corners, with the share of each that is kerb: on the rest other streets own the ground beyond'$sql$,
        model);
END $$;
COMMENT ON FUNCTION streetgen._make_corner_on_kerb_view(name) IS
    'Makes the view corner_on_kerb of a model, again and again.';
