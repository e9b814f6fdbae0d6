-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_surface_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._lacks_column(model, 'section', 'borders') THEN
        ALTER TABLE section ADD borders float8[];
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mend_surface_tables(name) IS
    'Adds the column that says where the borders of the roadway run, where a model was made before it; the next run '
    'fills it.';
