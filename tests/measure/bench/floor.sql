-- The least that writing the rows of model `timed` costs: the same rows, read from unlogged copies, into identical empty tables.
CREATE TABLE bench.key (place bigint GENERATED ALWAYS AS IDENTITY, statement text);

CREATE PROCEDURE bench.copy_rows() LANGUAGE plpgsql AS $$
DECLARE
    relation text;
BEGIN
    DROP SCHEMA IF EXISTS copy CASCADE;
    CREATE SCHEMA copy;
    FOR relation IN SELECT bench.derived('timed') LOOP
        EXECUTE format('CREATE UNLOGGED TABLE copy.%1$I AS SELECT * FROM timed.%1$I ORDER BY 1', relation);
    END LOOP;
END $$;

-- Empty tables with the columns and checks of the model, and what makes its keys and indexes: in `bench.key`, or at once.
CREATE PROCEDURE bench.empty_tables(keys_in_place boolean) LANGUAGE plpgsql AS $$
DECLARE
    relation text;
    key record;
BEGIN
    DROP SCHEMA IF EXISTS floor CASCADE;
    CREATE SCHEMA floor;
    TRUNCATE bench.key;
    FOR relation IN SELECT bench.derived('timed') LOOP
        EXECUTE format('CREATE TABLE floor.%1$I (LIKE timed.%1$I INCLUDING CONSTRAINTS INCLUDING STORAGE INCLUDING COMPRESSION)', relation);
    END LOOP;
    INSERT INTO bench.key (statement)
        SELECT replace(statement, ' timed.', ' floor.') FROM (
            SELECT CASE contype WHEN 'f' THEN 3 ELSE 1 END AS turn, k.oid, format('ALTER TABLE floor.%I ADD CONSTRAINT %I %s', relname, conname, pg_get_constraintdef(k.oid)) AS statement
            FROM pg_constraint k JOIN pg_class c ON c.oid = conrelid WHERE contype IN ('p', 'u', 'f') AND relnamespace = 'timed'::regnamespace AND relname IN (SELECT bench.derived('timed'))
            UNION ALL SELECT 2, indexrelid, pg_get_indexdef(indexrelid) FROM pg_index i JOIN pg_class c ON c.oid = indrelid
            WHERE relnamespace = 'timed'::regnamespace AND relname IN (SELECT bench.derived('timed')) AND NOT EXISTS (SELECT FROM pg_constraint k WHERE k.conindid = indexrelid AND contype IN ('p', 'u'))) s
        ORDER BY turn, oid;
    IF keys_in_place THEN CALL bench.make_keys(); END IF;
END $$;

CREATE PROCEDURE bench.insert_rows(INOUT rows bigint) LANGUAGE plpgsql AS $$
DECLARE
    relation text;
    inserted bigint;
BEGIN
    rows := 0;
    -- Rows in files that the same transaction began are not logged where wal_level is minimal; generate does the same.
    EXECUTE (SELECT 'TRUNCATE ' || string_agg(format('floor.%I', d), ', ') FROM bench.derived('timed') d);
    FOR relation IN SELECT bench.derived('timed') LOOP
        EXECUTE format('INSERT INTO floor.%1$I SELECT * FROM copy.%1$I', relation);
        GET DIAGNOSTICS inserted = ROW_COUNT;
        rows := rows + inserted;
    END LOOP;
END $$;

CREATE PROCEDURE bench.make_keys() LANGUAGE plpgsql AS $$
DECLARE
    key text;
BEGIN
    FOR key IN SELECT statement FROM bench.key ORDER BY place LOOP
        EXECUTE key;
    END LOOP;
END $$;
