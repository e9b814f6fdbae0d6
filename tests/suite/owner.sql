-- What an administrator does in a database with the extension for the set-up owner: a plain role may make models there and let others make some. It
-- makes roles and says how soon a deadlock is looked for, as some tests do, and has no other right of a superuser. create_model gives its models all subjects, whichever are asked for,
-- but while streetgen_test.subjects is "asked".
DO $$
DECLARE
  made constant text := pg_get_functiondef('streetgen.create_model'::regproc);
  all_subjects constant text := replace(made, 'streetgen._with_needs(subjects);',
    $f$streetgen._with_needs(CASE current_setting('streetgen_test.subjects', true) WHEN 'asked' THEN subjects ELSE subjects || 'all'::text END);$f$);
BEGIN
  IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'streetgen_owner') THEN
    CREATE ROLE streetgen_owner LOGIN CREATEROLE;
  END IF;
  EXECUTE format('GRANT CREATE, TEMPORARY ON DATABASE %I TO streetgen_owner WITH GRANT OPTION', current_database());
  GRANT CREATE ON SCHEMA public TO streetgen_owner WITH GRANT OPTION;
  GRANT SET ON PARAMETER deadlock_timeout TO streetgen_owner;
  ASSERT all_subjects LIKE '%streetgen_test.subjects%', 'create_model no longer says where its subjects come from';
  EXECUTE all_subjects;
END $$;

-- What a test asks the administrator for, by test.as_administrator.
CREATE SCHEMA IF NOT EXISTS administrator;
GRANT USAGE ON SCHEMA administrator TO streetgen_owner;
CREATE OR REPLACE FUNCTION administrator.run(statement text) RETURNS void LANGUAGE plpgsql SECURITY DEFINER AS $$ BEGIN EXECUTE statement; END $$;
REVOKE ALL ON FUNCTION administrator.run(text) FROM public;
GRANT EXECUTE ON FUNCTION administrator.run(text) TO streetgen_owner;
