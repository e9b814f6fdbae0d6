-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_sidewalk_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._lacks_column(model, 'sidewalk', 'strip') THEN
        PERFORM streetgen._execute_each(ARRAY['ALTER TABLE %1$I.sidewalk ADD strip geometry(MultiPolygon, ' || m.srid
            || ')'], model) FROM streetgen.model m WHERE m.name = model;
        CREATE INDEX sidewalk_strip ON sidewalk USING gist (strip) WHERE strip IS NOT NULL;
    END IF;
    IF NOT streetgen._lacks_column(model, 'axis', 'sidewalk_left') THEN
        RETURN;
    END IF;
    ALTER TABLE axis ADD sidewalk_left float8 CHECK (sidewalk_left BETWEEN 0 AND 50),
        ADD sidewalk_right float8 CHECK (sidewalk_right BETWEEN 0 AND 50);
    ALTER TABLE edge ADD sidewalk_left float8 NOT NULL DEFAULT 0, ADD sidewalk_right float8 NOT NULL DEFAULT 0;
    ALTER TABLE edge ALTER sidewalk_left DROP DEFAULT, ALTER sidewalk_right DROP DEFAULT;
END $$;
COMMENT ON FUNCTION streetgen._mend_sidewalk_tables(name) IS
    'Adds the columns that say how wide sidewalks are, and the ground of a sidewalk with that of its bays, where a '
    'model was made before them.';
