-- Surfaces alone, of model `timed` as generate computes them: the first part of its statement, written into a bare table.
CREATE PROCEDURE bench.surfaces(INOUT rows bigint) LANGUAGE plpgsql SET search_path = pg_catalog, public SET enable_nestloop = off SET work_mem = '64MB' AS $$
BEGIN
    DROP SCHEMA IF EXISTS surfaces CASCADE;
    CREATE SCHEMA surfaces;
    CREATE TABLE surfaces.surface (relation text, surface geometry);
    EXECUTE 'INSERT INTO surfaces.surface WITH ' || streetgen._upsert_input(streetgen._upsert_places('timed', 'empty')) || $sql$
        , every AS (SELECT array_agg(number) AS ids FROM (SELECT generate_series(1, 10 * count(*)) AS number FROM used) n)
        SELECT 'section', surface FROM streetgen._computed_section((SELECT streets FROM computed), (SELECT ids FROM every))
        UNION ALL SELECT 'intersection', surface FROM streetgen._computed_intersection((SELECT streets FROM computed), (SELECT ids FROM every)) $sql$
        USING NULL::bigint[], NULL::bigint[], NULL::bigint[], true;
    GET DIAGNOSTICS rows = ROW_COUNT;
END $$;
