-- What a statement says when it fails.
CREATE SCHEMA test;
GRANT USAGE ON SCHEMA test TO PUBLIC;

CREATE FUNCTION test.refusal(statement text, OUT state text, OUT said text, OUT detail text, OUT hint text) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  state := 'none';
EXCEPTION WHEN OTHERS THEN
  GET STACKED DIAGNOSTICS state = RETURNED_SQLSTATE, said = MESSAGE_TEXT, detail = PG_EXCEPTION_DETAIL, hint = PG_EXCEPTION_HINT;
END $$;

CREATE FUNCTION test.state(statement text) RETURNS text LANGUAGE sql AS $$ SELECT state FROM test.refusal(statement) $$;

CREATE FUNCTION test.said(statement text) RETURNS text LANGUAGE sql AS $$ SELECT coalesce(said, '') FROM test.refusal(statement) $$;

CREATE FUNCTION test.hint(statement text) RETURNS text LANGUAGE sql AS $$ SELECT coalesce(hint, '') FROM test.refusal(statement) $$;

-- A statement that only an administrator may run, such as one about extensions; in the set-up owner he is asked for it.
CREATE FUNCTION test.as_administrator(statement text) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  IF to_regprocedure('administrator.run(text)') IS NULL THEN
    EXECUTE statement;
  ELSE
    EXECUTE 'SELECT administrator.run($1)' USING statement;
  END IF;
END $$;
