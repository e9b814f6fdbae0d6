-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_surface_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._lacks_column(model, 'section', 'borders') THEN
        ALTER TABLE section ADD borders float8[];
    END IF;
    IF streetgen._lacks_column(model, 'transition_override', 'geom') THEN
        PERFORM streetgen._execute_each(ARRAY['ALTER TABLE %I.transition_override ADD geom geometry(Point, %s)
            CONSTRAINT geom_is_a_finite_point CHECK (%s)'], model, srid::text, streetgen._finite('geom'));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mend_surface_tables(name, integer) IS
    'Adds the columns that say where the borders of the roadway run, which the next run fills, and where a transition '
    'by hand lies, where a model was made before them.';
