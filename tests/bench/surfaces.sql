-- Surfaces alone, of model `timed` as generate computes them: the first steps of its statement, written into a bare table.
CREATE PROCEDURE bench.surfaces(INOUT rows bigint) LANGUAGE plpgsql SET search_path = pg_catalog, public SET enable_nestloop = off SET work_mem = '64MB' AS $$
DECLARE
    whole constant text := regexp_replace(streetgen._upsert_statement('timed', many => true), '[a-z_.]+ (= ANY \(\$[123]\)|IN \(SELECT axis_id FROM asked_axis\))', 'true', 'g');
BEGIN
    DROP SCHEMA IF EXISTS surfaces CASCADE;
    CREATE SCHEMA surfaces;
    EXECUTE 'CREATE TABLE surfaces.surface AS ' || regexp_replace(replace(replace(replace(split_part(whole, '-- The axes whose rows come out', 1), '$1', 'NULL::bigint[]'), '$2', 'NULL::bigint[]'), '$3', '''{}''::bigint[]'), ',\s*$', '')
        || ' SELECT relation, row_index, geom_1::geometry AS surface FROM result WHERE relation IN (''section'', ''intersection'')';
    GET DIAGNOSTICS rows = ROW_COUNT;
END $$;
