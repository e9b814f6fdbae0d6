-- The chains of junctions that a run locks.

CREATE OR REPLACE FUNCTION streetgen._junction_chain() RETURNS TABLE(relation name, touched text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    -- Junctions are read and written by several statements: also what is only computed again is locked.
    ('junction'::name, streetgen._part('junction_chain')) $f$;
COMMENT ON FUNCTION streetgen._junction_chain() IS 'The chains of junctions, as streetgen._chain has them.';
