-- The chains of heights that a run locks.

CREATE OR REPLACE FUNCTION streetgen._height_chain() RETURNS TABLE(relation name, touched text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    -- All that is off the ground is one chain: few edits touch it, and what is lifted has no end that is known before.
    ('profile'::name, streetgen._part('height_chain')) $f$;
COMMENT ON FUNCTION streetgen._height_chain() IS 'The chains of heights, as streetgen._chain has them.';
