-- All rooms are there.
SELECT streetgen._compose_computed_table();

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

-- Functions of models say by this setting that they compute. Where the server does not know it, only who was granted it
-- may write it into the header of a function: owners make models and restore them.
DO $$
BEGIN
    IF NOT EXISTS (SELECT FROM pg_catalog.pg_parameter_acl, pg_catalog.aclexplode(paracl)
        WHERE parname = 'streetgen.computes' AND grantee = 0 AND privilege_type = 'SET') THEN
        -- One installation at a time, of all databases.
        LOCK TABLE pg_catalog.pg_parameter_acl IN SHARE ROW EXCLUSIVE MODE;
        GRANT SET ON PARAMETER streetgen.computes TO PUBLIC;
    END IF;
END $$;
