-- How rooms make their tables.

CREATE OR REPLACE FUNCTION streetgen._finite(attribute name) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('NOT ST_IsEmpty(%1$I) AND ST_XMin(%1$I) BETWEEN -1e12 AND 1e12 AND ST_XMax(%1$I) BETWEEN '
        '-1e12 AND 1e12 AND ST_YMin(%1$I) BETWEEN -1e12 AND 1e12 AND ST_YMax(%1$I) BETWEEN -1e12 AND 1e12',
        attribute) $$;
COMMENT ON FUNCTION streetgen._finite(name) IS
    'What holds for a column of geometries with coordinates, all of them numbers within 1e12, as SQL for a constraint.';

CREATE OR REPLACE FUNCTION streetgen._execute_each(statements text[], VARIADIC places text[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    statement text;
BEGIN
    FOREACH statement IN ARRAY statements LOOP
        EXECUTE format(statement, VARIADIC places);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._execute_each(text[], text[]) IS
    'Runs statements in which %1$I is a model, and %2$s and so on further places.';
