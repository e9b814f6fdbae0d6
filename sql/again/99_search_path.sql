-- Functions name PostGIS through search_path; where it lives elsewhere than in public, they follow.
DO $$
DECLARE
    postgis name := (SELECT n.nspname FROM pg_extension e JOIN pg_namespace n ON n.oid = e.extnamespace WHERE e.extname = 'postgis');
    f regprocedure;
BEGIN
    IF postgis <> 'public' THEN
        FOR f IN SELECT oid::regprocedure FROM pg_proc
            WHERE pronamespace = 'streetgen'::regnamespace AND proconfig @> ARRAY['search_path=pg_catalog, public']
        LOOP
            EXECUTE format('ALTER FUNCTION %s SET search_path = pg_catalog, %I', f, postgis);
        END LOOP;
    END IF;
END $$;
