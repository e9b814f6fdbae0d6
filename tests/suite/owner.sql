-- What an administrator does in a database with the extension for the set-up owner: a plain role may make models there, and theirs compute all
-- subjects, whichever create_model is asked for. It makes roles, as some tests do, and has no other right of a superuser.
DO $$
DECLARE
  made constant text := pg_get_functiondef('streetgen.create_model'::regproc);
  all_subjects constant text := replace(made, 'streetgen._with_needs(subjects);',
    'ARRAY(SELECT subject FROM streetgen._subject() WHERE streetgen._with_needs(subjects) IS NOT NULL ORDER BY place);');
BEGIN
  IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'streetgen_owner') THEN
    CREATE ROLE streetgen_owner LOGIN CREATEROLE;
  END IF;
  EXECUTE format('GRANT CREATE, TEMPORARY ON DATABASE %I TO streetgen_owner', current_database());
  GRANT CREATE ON SCHEMA public TO streetgen_owner;
  ASSERT all_subjects <> made OR made LIKE '%FROM streetgen._subject()%', 'create_model no longer says where its subjects come from';
  EXECUTE all_subjects;
END $$;
-- Until the module itself defines the setting.
GRANT SET ON PARAMETER streetgen.computes TO streetgen_owner;
