-- The share of each corner's arc that is really kerb.
CREATE OR REPLACE FUNCTION streetgen._make_kerb_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW corner_on_kerb WITH (security_invoker = true) AS
    SELECT c.corner_id, c.node_id, least(1, coalesce(sum(ST_Length(k.curve)), 0) / ST_Length(c.arc)) AS on_kerb, c.arc
    FROM corner c LEFT JOIN kerb k ON k.node_id = c.node_id AND k.edge_id = c.edge_a
        AND k.side = 'corner_at_' || c.end_a AND k.curve IS NOT NULL
    WHERE c.arc IS NOT NULL
    GROUP BY c.corner_id;
    COMMENT ON VIEW corner_on_kerb
        IS 'Arcs of corners, with the share of each that is kerb: on the rest other streets own the ground beyond';
    COMMENT ON COLUMN corner_on_kerb.corner_id IS 'the corner';
    COMMENT ON COLUMN corner_on_kerb.node_id IS 'its node';
    COMMENT ON COLUMN corner_on_kerb.on_kerb IS
        'share of the arc that lies on the border of the roadway of its level, 0 to 1';
    COMMENT ON COLUMN corner_on_kerb.arc IS 'the arc';
END $$;
COMMENT ON FUNCTION streetgen._make_kerb_views(name) IS
    'Makes the view corner_on_kerb of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._kerb_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('corner_on_kerb'::name, 'kerb') $$;
COMMENT ON FUNCTION streetgen._kerb_view() IS
    'Views of kerbs, and the subjects whose tables they read.';
