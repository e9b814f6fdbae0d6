-- Functions name PostGIS through search_path; where it lives elsewhere than in public, they follow.
-- Temporary tables, views and types come last: first, as where they are not named, a role could put its
-- own in place of the system's, and triggers would read them with the rights of the model's owner.
DO $$
DECLARE
    postgis name := (SELECT n.nspname FROM pg_extension e JOIN pg_namespace n ON n.oid = e.extnamespace
        WHERE e.extname = 'postgis');
    f record;
BEGIN
    FOR f IN SELECT p.oid::regprocedure AS signature, said FROM pg_proc p, unnest(proconfig) said
        WHERE pronamespace = 'streetgen'::regnamespace
            AND said IN ('search_path=pg_catalog', 'search_path=pg_catalog, public')
    LOOP
        EXECUTE format(CASE f.said WHEN 'search_path=pg_catalog'
            THEN 'ALTER FUNCTION %s SET search_path = pg_catalog, pg_temp'
            ELSE 'ALTER FUNCTION %s SET search_path = pg_catalog, %I, pg_temp' END, f.signature, postgis);
    END LOOP;
END $$;

-- A query over a model costs enough by the planner to be compiled, which takes seconds and hears no cancel; rows
-- that are few gain nothing by it. A function that computes with its arguments alone stays as it is: one that SET
-- says something for is never inlined. A procedure that commits cannot have a SET.
DO $$
DECLARE
    f regprocedure;
BEGIN
    FOR f IN SELECT p.oid FROM pg_proc p JOIN pg_language l ON l.oid = prolang
        WHERE pronamespace = 'streetgen'::regnamespace AND proname !~ '^_' AND prokind = 'f' AND lanname <> 'c'
            AND proargtypes[0] = 'name'::regtype
    LOOP
        EXECUTE format('ALTER FUNCTION %s SET jit = off', f);
    END LOOP;
END $$;
