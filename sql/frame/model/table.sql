-- Conditions on columns of tables of every subject.

CREATE OR REPLACE FUNCTION streetgen._finite(attribute name) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('NOT ST_IsEmpty(%1$I) AND ST_XMin(%1$I) BETWEEN -1e12 AND 1e12 AND ST_XMax(%1$I) BETWEEN '
        '-1e12 AND 1e12 AND ST_YMin(%1$I) BETWEEN -1e12 AND 1e12 AND ST_YMax(%1$I) BETWEEN -1e12 AND 1e12',
        attribute) $$;
COMMENT ON FUNCTION streetgen._finite(name) IS
    'What holds for a column of geometries with coordinates, all of them numbers within 1e12, as SQL for a constraint.';
