-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._mend_height_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'profile', 'tied_from') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %I.profile ADD tied_from boolean NOT NULL DEFAULT false,
        ADD tied_to boolean NOT NULL DEFAULT false', model);
    -- Heights in the end tell this for the most part; the next run knows more.
    EXECUTE format('UPDATE %I.profile SET tied_from = true, tied_to = true WHERE method <> ''ground''', model);
    EXECUTE format('ALTER TABLE %I.profile ALTER tied_from DROP DEFAULT, ALTER tied_to DROP DEFAULT', model);
    EXECUTE format('DROP INDEX IF EXISTS %I.profile_off_ground', model);
    EXECUTE format('CREATE INDEX profile_off_ground ON %I.profile (edge_id)
        WHERE method <> ''ground'' OR tied_from OR tied_to', model);
    EXECUTE format('CREATE INDEX IF NOT EXISTS node_without_height ON %I.node USING gist (geom)
        WHERE ST_Z(geom) NOT BETWEEN -500 AND 10000', model);
END $$;
COMMENT ON FUNCTION streetgen._mend_height_tables(name) IS
    'Adds the columns that say at which nodes heights are found together, where a model was made before them.';
