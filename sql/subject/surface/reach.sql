-- The reach of a change by surfaces.

CREATE OR REPLACE FUNCTION streetgen._surface_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- An arc may bend as far from its node as max_arc_distance, and so where an edge that ends there is cut.
    RETURN (SELECT max(value::float8) FROM setting WHERE name IN ('reach', 'max_arc_distance'));
END $$;
COMMENT ON FUNCTION streetgen._surface_reach(name) IS
    'How far a change of an axis reaches by surfaces and the arcs of corners, metres.';
