-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_height_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'profile', 'tied_from') THEN
        RETURN;
    END IF;
    ALTER TABLE profile ADD tied_from boolean NOT NULL DEFAULT false, ADD tied_to boolean NOT NULL DEFAULT false;
    -- Heights in the end tell this for the most part; the next run knows more.
    UPDATE profile SET tied_from = true, tied_to = true WHERE method <> 'ground';
    ALTER TABLE profile ALTER tied_from DROP DEFAULT, ALTER tied_to DROP DEFAULT;
    -- It looks at these columns now, and comes back with the tables.
    EXECUTE format('DROP INDEX IF EXISTS %I.profile_off_ground', model);
END $$;
COMMENT ON FUNCTION streetgen._mend_height_tables(name) IS
    'Adds the columns that say at which nodes heights are found together, where a model was made before them.';
