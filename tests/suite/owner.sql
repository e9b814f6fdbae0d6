-- What an administrator does in a database with the extension for the set-up owner: a plain role may make models there and let others make some. It
-- makes roles and says how soon a deadlock is looked for, as some tests do, and has no other right of a superuser. create_model gives its models all subjects, whichever are asked for,
-- but while streetgen_test.subjects is "asked".
DO $$
BEGIN
  IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'streetgen_owner') THEN
    CREATE ROLE streetgen_owner LOGIN CREATEROLE;
  END IF;
  EXECUTE format('GRANT CREATE, TEMPORARY ON DATABASE %I TO streetgen_owner WITH GRANT OPTION', current_database());
  GRANT CREATE ON SCHEMA public TO streetgen_owner WITH GRANT OPTION;
  GRANT SET ON PARAMETER deadlock_timeout TO streetgen_owner;
END $$;
CREATE SCHEMA IF NOT EXISTS administrator;
GRANT USAGE ON SCHEMA administrator TO streetgen_owner;

-- A test may make the extension anew, which brings create_model as it was.
CREATE OR REPLACE FUNCTION administrator.give_all_subjects() RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  made constant text := pg_get_functiondef(to_regproc('streetgen.create_model'));
  all_subjects constant text := replace(made, 'streetgen._with_needs(subjects);',
    $f$streetgen._with_needs(CASE current_setting('streetgen_test.subjects', true) WHEN 'asked' THEN subjects ELSE subjects || 'all'::text END);$f$);
BEGIN
  IF all_subjects <> made THEN
    EXECUTE all_subjects;
  END IF;
  ASSERT coalesce(all_subjects LIKE '%streetgen_test.subjects%', true), 'create_model no longer says where its subjects come from';
END $$;
REVOKE ALL ON FUNCTION administrator.give_all_subjects() FROM public;
SELECT administrator.give_all_subjects() \g /dev/null

-- What a test asks the administrator for, by test.as_administrator.
CREATE OR REPLACE FUNCTION administrator.run(statement text) RETURNS void LANGUAGE plpgsql SECURITY DEFINER AS $$
BEGIN
  EXECUTE statement;
  PERFORM administrator.give_all_subjects();
END $$;
REVOKE ALL ON FUNCTION administrator.run(text) FROM public;
GRANT EXECUTE ON FUNCTION administrator.run(text) TO streetgen_owner;
