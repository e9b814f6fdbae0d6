-- Columns that models of older builds lack.

CREATE OR REPLACE FUNCTION streetgen._mend_network_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._lacks_column(model, 'edge', 'curve') THEN
        EXECUTE format('ALTER TABLE %I.edge ADD curve geometry(CompoundCurve, %s)', model, srid);
    END IF;
    -- Another index takes its place.
    PERFORM streetgen._execute_each(ARRAY['DROP INDEX IF EXISTS %1$I.report_collapsed'], model);
END $$;
COMMENT ON FUNCTION streetgen._mend_network_tables(name, integer) IS
    'Adds to the edges of a model the curve that older ones lack, and drops an index of theirs.';
