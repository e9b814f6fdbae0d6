-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_roundabout_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'roundabout_edge', 'face') THEN
        RETURN;
    END IF;
    -- Rings computed before have one face each.
    ALTER TABLE roundabout_edge ADD face integer NOT NULL DEFAULT 1;
    ALTER TABLE roundabout_edge ALTER face DROP DEFAULT;
END $$;
COMMENT ON FUNCTION streetgen._mend_roundabout_tables(name) IS
    'Adds the column that says which face of its ring an edge bounds, where a model was made before double '
    'roundabouts.';
