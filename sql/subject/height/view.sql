-- Views of how high vehicles may be that pass under roads.

CREATE OR REPLACE FUNCTION streetgen._make_height_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW underpass WITH (security_invoker = true) AS
    SELECT o.overpass_id, o.edge_below AS edge_id, o.abscissa_below AS abscissa,
        streetgen._height_along(a.geom, o.abscissa_above) - streetgen._height_along(b.geom, o.abscissa_below)
            - (SELECT value::float8 FROM setting WHERE name = 'deck_depth') AS clearance, x.height_limit, o.geom
    FROM overpass o JOIN profile a ON a.edge_id = o.edge_above JOIN profile b ON b.edge_id = o.edge_below
        JOIN edge e ON e.edge_id = o.edge_below JOIN axis x USING (axis_id);
    COMMENT ON VIEW underpass IS
        'What passes under another road: how much room there is, and how high vehicles may be that pass';
    COMMENT ON COLUMN underpass.overpass_id IS 'the row of overpass';
    COMMENT ON COLUMN underpass.edge_id IS 'the edge below';
    COMMENT ON COLUMN underpass.abscissa IS 'where it passes below, metres along the edge';
    COMMENT ON COLUMN underpass.clearance IS
        'from the roadway to the underside of the deck, which is setting deck_depth below its roadway, metres';
    COMMENT ON COLUMN underpass.height_limit IS 'of the axis below: what a sign says, metres; NULL: no sign is known';
    COMMENT ON COLUMN underpass.geom IS 'the crossing';
END $$;
COMMENT ON FUNCTION streetgen._make_height_views(name) IS
    'Makes the view of a model that computes heights, again and again.';

CREATE OR REPLACE FUNCTION streetgen._height_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('underpass'::name, 'height') $$;
COMMENT ON FUNCTION streetgen._height_view() IS
    'Views of heights, each before those that it reads, and the subjects whose tables they read.';
